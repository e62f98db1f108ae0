// The colour of one pixel: what shade.cpp and pack.cpp do for every field and format, and tile.hpp for one.
// SPDX-License-Identifier: MIT
#pragma once
#include "../base/hash.hpp"
#include "paint.hpp"

namespace dapple::paint {

constexpr uint32_t kGrainStream = 128;

constexpr Shader shader_of(const Paint& paint, const Brush& brush, int16_t unit, int16_t cell_level, uint32_t seed) {
  Shader s{};
  const int64_t low = base::divide_round(static_cast<int64_t>(paint.low) * unit, base::kMicro);
  const int64_t high = base::divide_round(static_cast<int64_t>(paint.high) * unit, base::kMicro);
  s.span = static_cast<int32_t>(high > low ? high - low : 1);
  s.low = static_cast<int32_t>(low);
  if (brush.view == View::height) {
    s.low -= s.span / 2;
    s.span *= 2;
  }
  const int32_t light = brush.view == View::normal && paint.light == 0 ? base::kMicro : paint.light;
  const bool flat = brush.unlit && brush.view == View::colour;
  s.slope = flat ? 0 : static_cast<int32_t>(base::divide_round(static_cast<int64_t>(light) * 128 * 65536 / base::kMicro, high > low ? high - low : 1));
  s.gloss = static_cast<int32_t>(static_cast<int64_t>(paint.gloss) * 256 / base::kMicro);
  s.grain = static_cast<int32_t>(static_cast<int64_t>(paint.grain) * 256 / base::kMicro);
  s.cell_level = cell_level;
  s.seed = seed;
  s.view = brush.view;
  s.y_down = brush.y_down;
  s.from = brush.view == View::opacity ? paint.opacity[0] : brush.view == View::roughness ? paint.roughness[0] : uint8_t{0};
  s.to = brush.view == View::opacity ? paint.opacity[1] : brush.view == View::roughness ? paint.roughness[1] : uint8_t{255};
  s.stops = paint.ramp.count;
  for (uint8_t i = 0; i < s.stops; ++i) {
    const Stop &a = paint.ramp.stop[i], &b = paint.ramp.stop[i + 1 < s.stops ? i + 1 : i];
    const uint8_t from[3] = {a.red, a.green, a.blue}, to[3] = {b.red, b.green, b.blue};
    const int16_t width = static_cast<int16_t>(b.at > a.at ? b.at - a.at : 1);
    s.stretch[i].at = a.at;
    for (uint8_t c = 0; c < 3; ++c) {
      s.stretch[i].base[c] = from[c];
      s.stretch[i].step[c] = static_cast<int16_t>((static_cast<int32_t>(to[c]) - from[c]) * 128 / width);
    }
  }
  return s;
}

inline uint8_t to_byte(int32_t value) { return static_cast<uint8_t>(base::clamp(value, 0, 255)); }

// The colour at a place of the range, 0..4080, within its stretch of the ramp. over is Q4 and |step * over| at most
// 255 * 16 * 128, so it fits 16 bits once its lowest 8 are gone.
inline void stretch_colour(const Stretch& s, int16_t at_q4, uint8_t* rgb) {
  const int16_t past = static_cast<int16_t>(at_q4 - 16 * static_cast<int16_t>(s.at));  // < 0 only before the first stop
  const int16_t over = past < 0 ? static_cast<int16_t>(0) : past;
  for (uint8_t c = 0; c < 3; ++c) {
    const int16_t move = static_cast<int16_t>((static_cast<int32_t>(s.step[c]) * over + 1024) >> 8);
    const int16_t sum = static_cast<int16_t>(s.base[c] + (move >> 3));
    rgb[c] = static_cast<uint8_t>(sum < 0 ? 0 : sum > 255 ? 255 : sum);
  }
}

inline void grain(int32_t strength, base::RowKey key, int32_t x, uint8_t* rgb) {
  const int32_t noise = static_cast<int32_t>(base::hash(key, x) >> 24) - 128;
  const int32_t bright = 256 + ((noise * strength) >> 7);
  for (uint8_t c = 0; c < 3; ++c) rgb[c] = to_byte((rgb[c] * bright) >> 8);
}

// luminance == (77 r + 150 g + 29 b) / 256, the weights of Rec. 601.
inline uint8_t luminance(const uint8_t* rgb) {
  return static_cast<uint8_t>((77u * rgb[0] + 150u * rgb[1] + 29u * rgb[2] + 128u) >> 8);
}

// To `bits` bits: rounded, or with a threshold 0..63 between neighbouring levels. x / 255 == (x + 1 + x / 256) / 256 for
// x < 65535, and x is at most 255 * 63 + 254.
inline uint16_t reduce(uint8_t value, uint8_t bits, bool dither, uint8_t threshold) {
  const uint16_t levels = static_cast<uint16_t>((1u << bits) - 1u);
  const uint16_t scaled = static_cast<uint16_t>(static_cast<uint16_t>(value) * levels);
  const uint16_t x = static_cast<uint16_t>(scaled + (dither ? (threshold * 4u + 2u) * 255u / 256u : 127u));
  return static_cast<uint16_t>((x + 1u + (x >> 8)) >> 8);
}

inline void put_565(uint8_t* to, const uint8_t* rgb, bool swapped, bool dither, uint8_t threshold) {
  const uint16_t r = reduce(rgb[0], 5, dither, threshold), g = reduce(rgb[1], 6, dither, threshold),
                 b = reduce(rgb[2], 5, dither, threshold);
  const uint8_t high = static_cast<uint8_t>((r << 3) | (g >> 3)), low = static_cast<uint8_t>((g << 5) | b);
  to[0] = swapped ? high : low;
  to[1] = swapped ? low : high;
}

inline void put_16(uint8_t* to, uint16_t value, bool swapped) {
  to[swapped ? 1 : 0] = static_cast<uint8_t>(value & 255);
  to[swapped ? 0 : 1] = static_cast<uint8_t>(value >> 8);
}

inline void put_one(uint8_t* byte, uint8_t bit, bool on) {
  const uint8_t mask = static_cast<uint8_t>(1u << bit);
  *byte = static_cast<uint8_t>(on ? *byte | mask : *byte & ~mask);
}

// One pixel of any format but dithered: pixel x of a row, y only for l1_pages.
inline void put_pixel(Pixels format, uint16_t x, uint16_t y, const uint8_t* rgb, bool dither, uint8_t threshold, uint8_t* row) {
  const size_t at = x;
  switch (format) {
    case Pixels::l8: row[at] = luminance(rgb); break;
    case Pixels::rgb888:
      for (uint8_t c = 0; c < 3; ++c) row[3 * at + c] = rgb[c];
      break;
    case Pixels::rgba8888:
      for (uint8_t c = 0; c < 3; ++c) row[4 * at + c] = rgb[c];
      row[4 * at + 3] = 255;
      break;
    case Pixels::rgb565: put_565(row + 2 * at, rgb, false, dither, threshold); break;
    case Pixels::rgb565_swapped: put_565(row + 2 * at, rgb, true, dither, threshold); break;
    case Pixels::l1_msb: put_one(row + x / 8, 7 - x % 8, reduce(luminance(rgb), 1, dither, threshold) != 0); break;
    case Pixels::l1_lsb: put_one(row + x / 8, x % 8, reduce(luminance(rgb), 1, dither, threshold) != 0); break;
    case Pixels::l1_pages: put_one(row + x, y % 8, reduce(luminance(rgb), 1, dither, threshold) != 0); break;
    case Pixels::l16:
    case Pixels::l16_swapped: put_16(row + 2 * at, static_cast<uint16_t>(257u * luminance(rgb)), format == Pixels::l16_swapped); break;
  }
}

}  // namespace dapple::paint
