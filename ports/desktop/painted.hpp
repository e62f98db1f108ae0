// Rows of colours, 128 pixels at a time: what lib/paint/shade.cpp and pack.cpp do pixel by pixel, as loops over arrays
// of words. Same numbers; bounds are told there. Other views than colours, and dithered formats, go the portable way.
// SPDX-License-Identifier: MIT
#pragma once

namespace dapple::paint {

constexpr uint16_t kPixels = 128;
using Words = int32_t[kPixels];

struct Block {
  alignas(DAPPLE_WIDE) Words rgb[3];
  Words gx, gy;  // the gradient
};

// The place in the range, 0..4080: over * 4080 / span. (a + 1/2) / b is at least 1 / 2 b away from a whole number, so
// the product with 1 / b, good to 52 bits, has the same whole part.
static void places(const Shader& s, const int16_t* DAPPLE_RESTRICT here, int32_t* DAPPLE_RESTRICT at) {
  const double inverse = 1.0 / s.span;
  Words over;  // in a loop of its own, or compilers take branches for values that are held
  for (uint16_t i = 0; i < kPixels; ++i) over[i] = base::clamp(here[i] - s.low, 0, s.span) * 4080;
  for (uint16_t i = 0; i < kPixels; ++i) at[i] = static_cast<int32_t>((over[i] + 0.5) * inverse);
}

// Eight or four words at a time, as the set has vectors.
typedef int32_t Few __attribute__((vector_size(DAPPLE_WIDE)));
constexpr uint16_t kFew = DAPPLE_WIDE / 4;
inline Few few_at(const int32_t* from) { return *reinterpret_cast<const Few*>(from); }
inline Few chosen(Few mask, Few yes, Few no) { return no ^ ((no ^ yes) & mask); }

// A channel's colour `past` 1/4080 of the ramp behind the stop of colour `from`.
inline Few along(Few past, Few from, Few step) {
  const Few move = (step * past + 1024) >> 8, held = (move << 16) >> 19;  // as int16, and then by 8
  const Few sum = from + held, above = sum & ~(sum >> 31);
  return chosen(above > 255, Few{} + 255, above);
}

// A stretch in every word.
struct FewStretches {
  Few at, from[3], step[3];
};

// The ramp. Stretch k counts while all stretches up to it begin at or before the place.
static void ramp_colours(const Shader& s, const int32_t* at, Block& block) {
  FewStretches all[kMaxStops];
  for (uint8_t k = 0; k < s.stops; ++k) {
    all[k].at = Few{} + s.stretch[k].at;
    for (uint8_t c = 0; c < 3; ++c)
      all[k].from[c] = Few{} + s.stretch[k].base[c], all[k].step[c] = Few{} + s.stretch[k].step[c];
  }
  for (uint16_t i = 0; i < kPixels; i = static_cast<uint16_t>(i + kFew)) {
    const Few place = few_at(at + i), whole = place >> 4;
    FewStretches now = all[0];
    Few alive = Few{} - 1;
    for (uint8_t k = 1; k < s.stops; ++k) {
      alive &= whole >= all[k].at;
      now.at = chosen(alive, all[k].at, now.at);
      for (uint8_t c = 0; c < 3; ++c) {
        now.from[c] = chosen(alive, all[k].from[c], now.from[c]);
        now.step[c] = chosen(alive, all[k].step[c], now.step[c]);
      }
    }
    const Few past = place - 16 * now.at, over = past & ~(past >> 31);
    for (uint8_t c = 0; c < 3; ++c) *reinterpret_cast<Few*>(block.rgb[c] + i) = along(over, now.from[c], now.step[c]);
  }
}

// Differences beyond `limit` give a slope that is held anyway: 2^26 >> 16 is beyond it, and the product fits.
static void slopes(const Shader& s, const int16_t* DAPPLE_RESTRICT a, const int16_t* DAPPLE_RESTRICT b,
                   int32_t* DAPPLE_RESTRICT out) {
  const int32_t size = s.slope < 0 ? -s.slope : s.slope, limit = base::min(131072, (1 << 26) / size + 2);
  for (uint16_t i = 0; i < kPixels; ++i) {
    const int32_t difference = base::clamp(static_cast<int32_t>(a[i]) - b[i], -limit, limit);
    out[i] = base::clamp((difference * s.slope) >> 16, -kLargestSlope, kLargestSlope);
  }
}
constexpr int32_t kLargestFactor = 1 << 28;

static void lit(const Shader& s, Block& block) {
  Words square, inverse, bright, shine;
  for (uint16_t i = 0; i < kPixels; ++i) square[i] = block.gx[i] * block.gx[i] + block.gy[i] * block.gy[i] + 65536;
  base::inverse_roots(square, inverse, kPixels / 8);
  for (uint16_t i = 0; i < kPixels; ++i) {
    const int32_t length = inverse[i] >> 4;
    const int32_t light = ((256 * kLightZ - block.gx[i] * kLightX - block.gy[i] * kLightY) * length) >> 20;
    bright[i] = base::max(light, 40) * 256 / kLightZ;
    int32_t f = base::clamp(((256 * kHalfZ - block.gx[i] * kHalfX - block.gy[i] * kHalfY) * length) >> 20, 0, 256);
    f = (f * f) >> 8;
    f = (f * f) >> 8;
    f = (f * f) >> 8;
    f = (f * f) >> 8;
    shine[i] = base::max(f - 53, 0) * s.gloss >> 8;
  }
  for (Words& channel : block.rgb)
    for (uint16_t i = 0; i < kPixels; ++i) channel[i] = base::clamp(((channel[i] * bright[i]) >> 8) + shine[i], 0, 255);
}

static void grained(const Shader& s, const Source& f, int32_t x, Block& block) {
  const base::RowKey key = base::row_key(s.seed, kGrainStream, f.world_y);
  Words bright;
  for (int32_t i = 0; i < kPixels; ++i) {
    const int32_t noise = static_cast<int32_t>(base::hash(key, f.world_x + x + i) >> 24) - 128;
    bright[i] = 256 + ((noise * s.grain) >> 7);
  }
  for (Words& channel : block.rgb)
    for (uint16_t i = 0; i < kPixels; ++i) channel[i] = base::clamp((channel[i] * bright[i]) >> 8, 0, 255);
}

// reduce(), undithered.
static inline int32_t reduced(int32_t value, int32_t levels) {
  const int32_t x = value * levels + 127;
  return (x + 1 + (x >> 8)) >> 8;
}

static void put_565s(const Block& b, bool swapped, uint8_t* DAPPLE_RESTRICT to, uint16_t n) {
  uint16_t pixel[kPixels];
  for (uint16_t i = 0; i < kPixels; ++i) {
    const int32_t value = (reduced(b.rgb[0][i], 31) << 11) | (reduced(b.rgb[1][i], 63) << 5) | reduced(b.rgb[2][i], 31);
    pixel[i] = static_cast<uint16_t>(swapped ? (value >> 8) | (value << 8) : value);
  }
  base::copy_bytes(to, pixel, size_t{2} * n);
}

static void put_8888s(const Block& b, uint8_t* DAPPLE_RESTRICT to, uint16_t n) {
  uint32_t pixel[kPixels];
  for (uint16_t i = 0; i < kPixels; ++i)
    pixel[i] = static_cast<uint32_t>(b.rgb[0][i] | (b.rgb[1][i] << 8) | (b.rgb[2][i] << 16)) | UINT32_C(0xff000000);
  base::copy_bytes(to, pixel, size_t{4} * n);
}

static void put_pixels(const Brush& brush, const Source& source, const Block& b, uint16_t x, uint16_t n, uint8_t* row) {
  if (brush.format == Pixels::rgba8888) return put_8888s(b, row + size_t{4} * x, n);
  const bool at_once = !brush.dither && !base::kSmallCode;
  if (at_once && brush.format == Pixels::rgb565) return put_565s(b, false, row + size_t{2} * x, n);
  if (at_once && brush.format == Pixels::rgb565_swapped) return put_565s(b, true, row + size_t{2} * x, n);
  uint8_t rgb[3 * kPixels];
  for (uint16_t i = 0; i < n; ++i)
    for (uint8_t c = 0; c < 3; ++c) rgb[3 * i + c] = static_cast<uint8_t>(b.rgb[c][i]);
  if (brush.format == Pixels::rgb888) return base::copy_bytes(row + size_t{3} * x, rgb, size_t{3} * n);
  pack(brush, source, rgb, x, static_cast<uint8_t>(n), row);
}

// Rows of the field of at most kPixels cells, with one more on either side, where loops of whole blocks may read.
struct Field {
  int16_t above[kPixels], here[kPixels + 2], below[kPixels];
};
static void fetch(const Source& f, uint16_t x, uint16_t n, Field& field) {
  if (n < kPixels) field = Field{};
  base::copy_bytes(field.above, f.above + x, size_t{2} * n);
  base::copy_bytes(field.here, f.here + x - 1, size_t{2} * (n + 2u));
  base::copy_bytes(field.below, f.below + x, size_t{2} * n);
}

static void painted_row(const grid::Rows& rows) {
  const Job& job = *static_cast<const Job*>(rows.in[0]);
  const Shader& s = *job.shader;
  const Source& f = *job.source;
  if (s.view != View::colour || s.slope >= kLargestFactor || s.slope <= -kLargestFactor) return job_row(rows);
  for (uint32_t x = 0; x < f.width; x += kPixels) {
    const uint16_t n = static_cast<uint16_t>(base::min(kPixels, static_cast<int32_t>(f.width - x)));
    Field field;
    Block block;
    alignas(DAPPLE_WIDE) Words at;
    fetch(f, static_cast<uint16_t>(x), n, field);
    places(s, field.here + 1, at);
    ramp_colours(s, at, block);
    if (s.slope != 0) {
      slopes(s, field.here + 2, field.here, block.gx);
      slopes(s, field.below, field.above, block.gy);
      lit(s, block);
    }
    if (s.grain != 0) grained(s, f, static_cast<int32_t>(x), block);
    put_pixels(*job.brush, f, block, static_cast<uint16_t>(x), n, job.row);
  }
}

}  // namespace dapple::paint
