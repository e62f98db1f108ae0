// Rows of colours, 128 pixels at a time: what lib/paint/shade.cpp and pack.cpp do pixel by pixel, as loops over arrays
// of words. Same numbers; bounds are told there. Other views than colours, and dithered formats, go the portable way.
// SPDX-License-Identifier: MIT
#pragma once

namespace dapple::paint {

constexpr uint16_t kPixels = 128;
using Words = int32_t[kPixels];
using Halves = int16_t[kPixels];

// Channels, 0..255.
struct Block {
  alignas(DAPPLE_WIDE) Halves rgb[3];
};

// mulhi of numbers without a sign.
static inline uint16_t mulhi_positive(uint16_t a, uint16_t b) {
  return static_cast<uint16_t>((static_cast<uint32_t>(a) * b) >> 16);
}

// The place in the range, 0..4080: over * 4080 / span. (a + 1/2) / b is at least 1 / 2 b away from a whole number, so
// the product with 1 / b, good to 52 bits, has the same whole part.
static void any_places(const Shader& s, const int16_t* DAPPLE_RESTRICT here, int16_t* DAPPLE_RESTRICT at) {
  const double inverse = 1.0 / s.span;
  Words over, whole;  // in loops of their own, or compilers take branches for values that are held
  for (uint16_t i = 0; i < kPixels; ++i) over[i] = base::clamp(here[i] - s.low, 0, s.span) * 4080;
  for (uint16_t i = 0; i < kPixels; ++i) whole[i] = static_cast<int32_t>((over[i] + 0.5) * inverse);
  for (uint16_t i = 0; i < kPixels; ++i) at[i] = static_cast<int16_t>(whole[i]);
}

// The same in sixteen bits, of ranges within int16 that are 4081..32768 wide. The factor is less than 1 too little, so
// that the product falls short by less than over / 65536 <= 1/2: the place, or one less. What is left then, below
// 2 span <= 65536, tells which.
static void short_places(const Shader& s, const int16_t* DAPPLE_RESTRICT here, int16_t* DAPPLE_RESTRICT at) {
  const uint16_t span = static_cast<uint16_t>(s.span), factor = static_cast<uint16_t>(UINT32_C(4080) * 65536 / span);
  const int16_t low = static_cast<int16_t>(s.low), high = static_cast<int16_t>(s.low + s.span);
  for (uint16_t i = 0; i < kPixels; ++i) {
    const int16_t raised = here[i] < low ? low : here[i], held = raised > high ? high : raised;
    const uint16_t over = static_cast<uint16_t>(held - low), place = mulhi_positive(over, factor);
    const uint16_t left =
        static_cast<uint16_t>(static_cast<uint16_t>(over * 4080u) - static_cast<uint16_t>(place * uint32_t{span}));
    at[i] = static_cast<int16_t>(place + (left >= span ? 1 : 0));
  }
}

static void places(const Shader& s, const int16_t* here, int16_t* at) {
  const bool fits = !base::kSmallCode && s.span > 4080 && s.span <= 32768 && s.low >= -32768 && s.low <= 32767 - s.span;
  (fits ? short_places : any_places)(s, here, at);
}

// Sixteen or eight numbers at a time, as the set has vectors.
typedef int16_t Short __attribute__((vector_size(DAPPLE_WIDE)));
constexpr uint16_t kShort = DAPPLE_WIDE / 2;
inline Short& short_at(int16_t* from) { return *reinterpret_cast<Short*>(from); }

// A stretch of the ramp for products of sixteen bits: the colour `past` 1/4080 of the ramp behind its stop is
//   from + ((mulhi(past * scale, step) + 4) >> 3),   scale = 2^k, step = 2^(8 - k) times the stretch's own
// which is stretch_colour without a rounding more. past stays below 16 times the width w of the stretch: k is the
// largest, up to 8, with 16 w 2^k <= 2^15. Then, as a step is 128 * 255 / w at most, those of k < 8 are below 2^13.
// Behind the last stop steps are 0.
constexpr uint8_t kFirst = 0, kScale = 1, kFrom = 2, kStep = 5, kParts = 8;
static void parts_of(const Shader& s, uint8_t k, int16_t* part) {
  const Stretch& stretch = s.stretch[k];
  const int32_t width = k + 1 < s.stops ? s.stretch[k + 1].at - stretch.at : 0;
  const int shift = width == 0 ? 0 : width <= 8 ? 8 : __builtin_clz(static_cast<unsigned>(width - 1)) - 21;
  part[kFirst] = static_cast<int16_t>(16 * stretch.at);
  part[kScale] = static_cast<int16_t>(1 << shift);
  for (uint8_t c = 0; c < 3; ++c) {
    part[kFrom + c] = stretch.base[c];
    part[kStep + c] = static_cast<int16_t>(stretch.step[c] * (256 >> shift));
  }
}

// What the stretch of every pixel has, and where the pixel is in it.
struct Picked {
  alignas(DAPPLE_WIDE) Halves past, from[3], step[3];
};

// Stretch k counts while all stretches up to it begin at or before the place: every one that does changes what the one
// before it has into its own.
static void pick(const Shader& s, int16_t* at, Picked& picked) {
  Short change[kMaxStops][kParts], begin[kMaxStops];
  int16_t part[kParts], before[kParts] = {};
  for (uint8_t k = 0; k < s.stops; ++k) {
    parts_of(s, k, part);
    begin[k] = Short{} + part[kFirst];
    for (uint8_t i = 0; i < kParts; ++i) {
      change[k][i] = Short{} + static_cast<int16_t>(part[i] ^ before[i]);
      before[i] = part[i];
    }
  }
  for (uint16_t i = 0; i < kPixels; i = static_cast<uint16_t>(i + kShort)) {
    const Short place = short_at(at + i);
    Short now[kParts], alive = Short{} - 1;
    for (uint8_t j = 0; j < kParts; ++j) now[j] = change[0][j];
    for (uint8_t k = 1; k < s.stops; ++k) {
      alive &= place >= begin[k];
      for (uint8_t j = 0; j < kParts; ++j) now[j] ^= alive & change[k][j];
    }
    const Short past = place - now[kFirst];
    short_at(picked.past + i) = (past & ~(past >> 15)) * now[kScale];
    for (uint8_t c = 0; c < 3; ++c)
      short_at(picked.from[c] + i) = now[kFrom + c], short_at(picked.step[c] + i) = now[kStep + c];
  }
}

static void ramp_colours(const Shader& s, int16_t* at, Block& block) {
  Picked picked;
  pick(s, at, picked);
  for (uint8_t c = 0; c < 3; ++c)
    for (uint16_t i = 0; i < kPixels; ++i) {
      const int16_t move = base::mulhi(picked.past[i], picked.step[c][i]);
      const int16_t sum = static_cast<int16_t>(picked.from[c][i] + ((move + 4) >> 3));
      block.rgb[c][i] = static_cast<int16_t>(base::clamp(sum, 0, 255));
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

// channel * bright >> 8, at most 255.
static inline int16_t brightened(int16_t channel, uint16_t bright) {
  const uint16_t value = mulhi_positive(static_cast<uint16_t>(channel << 8), bright);
  return static_cast<int16_t>(value > 255 ? 255 : value);
}

// Faces are 0..261, so bright is at most 412; shine beyond what makes a channel 0 or 255 is held.
static void lit(const Shader& s, const Words& gx, const Words& gy, Block& block) {
  Words square, inverse;
  Halves bright, shine;
  for (uint16_t i = 0; i < kPixels; ++i) square[i] = gx[i] * gx[i] + gy[i] * gy[i] + 65536;
  base::inverse_roots(square, inverse, kPixels / 8);
  for (uint16_t i = 0; i < kPixels; ++i) {
    const int32_t length = inverse[i] >> 4;
    const int32_t light = ((256 * kLightZ - gx[i] * kLightX - gy[i] * kLightY) * length) >> 20;
    bright[i] = static_cast<int16_t>(base::max(light, 40) * 256 / kLightZ);
    int32_t f = base::clamp(((256 * kHalfZ - gx[i] * kHalfX - gy[i] * kHalfY) * length) >> 20, 0, 256);
    f = (f * f) >> 8;
    f = (f * f) >> 8;
    f = (f * f) >> 8;
    f = (f * f) >> 8;
    shine[i] = static_cast<int16_t>(base::clamp(base::max(f - 53, 0) * s.gloss >> 8, -512, 512));
  }
  for (Halves& channel : block.rgb)
    for (uint16_t i = 0; i < kPixels; ++i) {
      const uint16_t value = mulhi_positive(static_cast<uint16_t>(channel[i] << 8), static_cast<uint16_t>(bright[i]));
      channel[i] = static_cast<int16_t>(base::clamp(static_cast<int16_t>(value + shine[i]), 0, 255));
    }
}

// A brightness beyond 16 bits makes of every channel but 0 more than 255.
static void grained(const Shader& s, const Source& f, int32_t x, Block& block) {
  const base::RowKey key = base::row_key(s.seed, kGrainStream, f.world_y);
  uint16_t bright[kPixels];
  for (int32_t i = 0; i < kPixels; ++i) {
    const int32_t noise = static_cast<int32_t>(base::hash(key, f.world_x + x + i) >> 24) - 128;
    bright[i] = static_cast<uint16_t>(base::clamp(256 + ((noise * s.grain) >> 7), 0, 65535));
  }
  for (Halves& channel : block.rgb)
    for (uint16_t i = 0; i < kPixels; ++i) channel[i] = brightened(channel[i], bright[i]);
}

// reduce(), undithered.
static inline uint16_t reduced(int16_t value, uint16_t levels) {
  const uint16_t x = static_cast<uint16_t>(static_cast<uint16_t>(value) * levels + 127u);
  return static_cast<uint16_t>(static_cast<uint16_t>(x + 1u + (x >> 8)) >> 8);
}

static void put_565s(const Block& b, bool swapped, uint8_t* DAPPLE_RESTRICT to, uint16_t n) {
  uint16_t pixel[kPixels];
  for (uint16_t i = 0; i < kPixels; ++i)
    pixel[i] = static_cast<uint16_t>((reduced(b.rgb[0][i], 31) << 11) | (reduced(b.rgb[1][i], 63) << 5) |
                                     reduced(b.rgb[2][i], 31));
  for (uint16_t i = 0; i < kPixels && swapped; ++i) pixel[i] = static_cast<uint16_t>((pixel[i] >> 8) | (pixel[i] << 8));
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

// Rows of the field of at most kPixels cells, with one more on either side, where loops of whole blocks may read; those
// above and below for light.
struct Field {
  int16_t above[kPixels], here[kPixels + 2], below[kPixels];
};
static void fetch(const Source& f, bool light, uint16_t x, uint16_t n, Field& field) {
  if (n < kPixels) field = Field{};
  base::copy_bytes(field.here, f.here + x - 1, size_t{2} * (n + 2u));
  if (!light) return;
  base::copy_bytes(field.above, f.above + x, size_t{2} * n);
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
    alignas(DAPPLE_WIDE) Halves at;
    fetch(f, s.slope != 0, static_cast<uint16_t>(x), n, field);
    places(s, field.here + 1, at);
    ramp_colours(s, at, block);
    if (s.slope != 0) {
      Words gx, gy;
      slopes(s, field.here + 2, field.here, gx);
      slopes(s, field.below, field.above, gy);
      lit(s, gx, gy, block);
    }
    if (s.grain != 0) grained(s, f, static_cast<int32_t>(x), block);
    put_pixels(*job.brush, f, block, static_cast<uint16_t>(x), n, job.row);
  }
}

}  // namespace dapple::paint
