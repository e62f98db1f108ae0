// Colour of a field: ramp, Lambert and Blinn-Phong light from the upper left on the field as a height, grain.
// SPDX-License-Identifier: MIT
#include "../base/hash.hpp"
#include "../base/math.hpp"
#include "paint.hpp"

namespace dapple::paint {

constexpr uint32_t kGrainStream = 128;
constexpr int32_t kLargestSlope = 1023;  // gradient, Q8

// Unit vectors, Q8, x right, y down, z towards the eye: the light, and the half-vector between it and the eye.
constexpr int32_t kLightX = -128, kLightY = -148, kLightZ = 162;
constexpr int32_t kHalfX = -71, kHalfY = -82, kHalfZ = 232;

Shader shader_of(const Paint& paint, const Brush& brush, int16_t unit, int16_t cell_level, uint32_t seed) {
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
  s.slope = static_cast<int32_t>(base::divide_round(static_cast<int64_t>(light) * 128 * 65536 / base::kMicro, high > low ? high - low : 1));
  s.gloss = static_cast<int32_t>(static_cast<int64_t>(paint.gloss) * 256 / base::kMicro);
  s.grain = static_cast<int32_t>(static_cast<int64_t>(paint.grain) * 256 / base::kMicro);
  s.cell_level = cell_level;
  s.seed = seed;
  s.view = brush.view;
  s.y_down = brush.y_down;
  s.stops = paint.ramp.count;
  for (uint8_t i = 0; i < s.stops; ++i) {
    const Stop &a = paint.ramp.stop[i], &b = paint.ramp.stop[i + 1 < s.stops ? i + 1 : i];
    const uint8_t from[3] = {a.red, a.green, a.blue}, to[3] = {b.red, b.green, b.blue};
    const int16_t width = static_cast<int16_t>(b.at > a.at ? b.at - a.at : 1);
    s.at[i] = a.at;
    for (uint8_t c = 0; c < 3; ++c) {
      s.base[i][c] = from[c];
      s.step[i][c] = static_cast<int16_t>((static_cast<int32_t>(to[c]) - from[c]) * 128 / width);
    }
  }
  return s;
}

static uint8_t to_byte(int32_t value) { return static_cast<uint8_t>(base::clamp(value, 0, 255)); }

// The field's place in the range: 0..255 in Q4, 0..4080. Field differences are below 2^17, so the product stays below 2^31
// after the division has been split (span is at least 1 and values are clamped first).
static int32_t place(const Shader& s, int32_t value) {
  const int32_t over = base::clamp(value - s.low, 0, s.span);
  return over * 4080 / s.span;
}

static void ramp_colour(const Shader& s, int32_t at_q4, uint8_t* rgb) {
  const int32_t at = at_q4 >> 4;
  uint8_t i = 0;
  while (i + 1 < s.stops && s.at[i + 1] <= at) ++i;
  const int32_t over = at_q4 - 16 * static_cast<int32_t>(s.at[i]);  // Q4, >= 0 but before the first stop
  for (uint8_t c = 0; c < 3; ++c) rgb[c] = to_byte(s.base[i][c] + ((s.step[i][c] * base::max(over, 0) + 1024) >> 11));
}

// The gradient of the field as a height, Q8, clamped.
struct Gradient {
  int32_t x, y;
};
static int32_t slope_of(const Shader& s, int32_t difference) {
  const int64_t slope = (static_cast<int64_t>(difference) * s.slope) >> 16;
  return slope > kLargestSlope ? kLargestSlope : slope < -kLargestSlope ? -kLargestSlope : static_cast<int32_t>(slope);
}
static Gradient gradient(const Shader& s, const Source& f, uint16_t x) {
  const int16_t* here = f.here + x;
  return {slope_of(s, static_cast<int32_t>(here[1]) - here[-1]), slope_of(s, static_cast<int32_t>(f.below[x]) - f.above[x])};
}

// (x, y, z) . n for the unit normal n = (-gx, -gy, 1) / |...|, Q8. The inverse length is 2^20 / |...| and the dot at most
// 1.02 * 256 |...|, so the product stays below 2^29.
static int32_t facing(const Gradient& g, int32_t x, int32_t y, int32_t z) {
  const uint32_t square = static_cast<uint32_t>(g.x * g.x) + static_cast<uint32_t>(g.y * g.y) + UINT32_C(65536);
  const int32_t inverse = base::inverse_root(square) >> 4;
  return ((256 * z - g.x * x - g.y * y) * inverse) >> 20;
}

static int32_t highlight(const Gradient& g) {
  int32_t f = base::clamp(facing(g, kHalfX, kHalfY, kHalfZ), 0, 256);
  for (uint8_t i = 0; i < 4; ++i) f = (f * f) >> 8;  // f^16
  return f;
}

static void light(const Shader& s, const Source& f, uint16_t x, uint8_t* rgb) {
  const Gradient g = gradient(s, f, x);
  const int32_t bright = base::max(facing(g, kLightX, kLightY, kLightZ), 40) * 256 / kLightZ;  // flat: 256
  const int32_t flat_gloss = 53;                                                              // (232/256)^16, Q8
  const int32_t shine = base::max(highlight(g) - flat_gloss, 0) * s.gloss >> 8;
  for (uint8_t c = 0; c < 3; ++c) rgb[c] = to_byte(((rgb[c] * bright) >> 8) + shine);
}

static void normal(const Shader& s, const Source& f, uint16_t x, uint8_t* rgb) {
  const Gradient g = gradient(s, f, x);
  const int32_t nx = facing(g, 256, 0, 0), ny = facing(g, 0, 256, 0), nz = facing(g, 0, 0, 256);
  rgb[0] = to_byte(128 + ((nx * 127) >> 8));
  rgb[1] = to_byte(128 + (((s.y_down ? ny : -ny) * 127) >> 8));
  rgb[2] = to_byte(128 + ((nz * 127) >> 8));
}

static void grain(const Shader& s, base::RowKey key, int32_t x, uint8_t* rgb) {
  const int32_t noise = static_cast<int32_t>(base::hash(key, x) >> 24) - 128;
  const int32_t bright = 256 + ((noise * s.grain) >> 7);
  for (uint8_t c = 0; c < 3; ++c) rgb[c] = to_byte((rgb[c] * bright) >> 8);
}

static void grey(uint8_t value, uint8_t* rgb) { rgb[0] = rgb[1] = rgb[2] = value; }

void shade(const Shader& s, const Source& f, uint16_t x, uint8_t count, uint8_t* rgb) {
  const base::RowKey key = base::row_key(s.seed, kGrainStream, f.world_y);
  for (uint8_t i = 0; i < count; ++i, ++x, rgb += 3) {
    const int16_t value = f.here[x];
    switch (s.view) {
      case View::colour:
        ramp_colour(s, place(s, value), rgb);
        if (s.slope != 0) light(s, f, x, rgb);
        if (s.grain != 0) grain(s, key, f.world_x + x, rgb);
        break;
      case View::field:
      case View::height: grey(static_cast<uint8_t>((place(s, value) + 8) >> 4), rgb); break;
      case View::cells: grey(value > s.cell_level ? 255 : 0, rgb); break;
      case View::normal: normal(s, f, x, rgb); break;
    }
  }
}

}  // namespace dapple::paint
