// Colour of a field: ramp, Lambert and Blinn-Phong light from the upper left on the field as a height, grain.
// SPDX-License-Identifier: MIT
#include "../base/math.hpp"
#include "paint.hpp"

namespace dapple::paint {

constexpr int32_t kLargestSlope = 1023;  // gradient, Q8

// Unit vectors, Q8, x right, y down, z towards the eye: the light, and the half-vector between it and the eye.
constexpr int32_t kLightX = -128, kLightY = -148, kLightZ = 162;
constexpr int32_t kHalfX = -71, kHalfY = -82, kHalfZ = 232;

// The field's place in the range: 0..255 in Q4, 0..4080. Field differences are below 2^17, so the product stays below 2^31
// after the division has been split (span is at least 1 and values are clamped first).
static int32_t place(const Shader& s, int32_t value) {
  const int32_t over = base::clamp(value - s.low, 0, s.span);
  return over * 4080 / s.span;
}

// The place in the range as 0..65535, rounded: over 65535 / span by two divisions, because over is up to 131070 and
// 65535 = 255 * 257. The products are below 2^26.
static uint16_t deep_place(const Shader& s, int32_t value) {
  const int32_t over = base::clamp(value - s.low, 0, s.span) * 255;
  return static_cast<uint16_t>(over / s.span * 257 + (over % s.span * 257 + s.span / 2) / s.span);
}

static void ramp_colour(const Shader& s, int32_t at_q4, uint8_t* rgb) {
  uint8_t i = 0;
  while (i + 1 < s.stops && s.stretch[i + 1].at <= at_q4 >> 4) ++i;
  stretch_colour(s.stretch[i], static_cast<int16_t>(at_q4), rgb);
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

static void grey(uint8_t value, uint8_t* rgb) { rgb[0] = rgb[1] = rgb[2] = value; }

// from + (to - from) at / 4080, rounded; the sum is never negative and below 2^21.
static uint8_t between(const Shader& s, int32_t at_q4) {
  const int32_t moved = (static_cast<int32_t>(s.to) - s.from) * at_q4;
  return static_cast<uint8_t>((static_cast<int32_t>(s.from) * 4080 + moved + 2040) / 4080);
}

void shade(const Shader& s, const Source& f, uint16_t x, uint8_t count, uint8_t* rgb) {
  const base::RowKey key = base::row_key(s.seed, kGrainStream, f.world_y);
  for (uint8_t i = 0; i < count; ++i, ++x, rgb += 3) {
    const int16_t value = f.here[x];
    switch (s.view) {
      case View::colour:
        ramp_colour(s, place(s, value), rgb);
        if (s.slope != 0) light(s, f, x, rgb);
        if (s.grain != 0) grain(s.grain, key, f.world_x + x, rgb);
        break;
      case View::field:
      case View::height: grey(static_cast<uint8_t>((place(s, value) + 8) >> 4), rgb); break;
      case View::cells: grey(value > s.cell_level ? 255 : 0, rgb); break;
      case View::normal: normal(s, f, x, rgb); break;
      case View::opacity:
      case View::roughness: grey(between(s, place(s, value)), rgb); break;
    }
  }
}

// from and to in sixteen bits are 257 times themselves; |to - from| * 65535 < 2^24.
void shade_deep(const Shader& s, const Source& f, bool swapped, uint8_t* row) {
  for (uint16_t x = 0; x < f.width; ++x, row += 2) {
    const int32_t moved = (static_cast<int32_t>(s.to) - s.from) * deep_place(s, f.here[x]);
    put_16(row, static_cast<uint16_t>((static_cast<int32_t>(s.from) * 65535 + moved + 127) / 255), swapped);
  }
}

}  // namespace dapple::paint
