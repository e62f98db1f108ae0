// What a pass in divergence form does in a cell: a direction's pull along a way, and what a link carries. See flux.hpp.
// SPDX-License-Identifier: MIT
#pragma once
#include "flux.hpp"

namespace dapple::stencil {

using base::mulhi;
using i16 = int16_t;

inline i16 positive(i16 a) { return a > 0 ? a : static_cast<i16>(0); }
inline i16 absolute(i16 a) { return a > 0 ? a : static_cast<i16>(-a); }
inline i16 third(i16 a) { return mulhi(a, 21845); }

// A stream's direction against a way, mirrored so that the three kinds of way are (1, 0), (1, 1) and (2, 1):
// x = 2 a c + 2 b s, y = 2 d c + 2 e s of the map's Q7 (c, s), with a, b, d, e in Q15; a vector of 127 becomes one of
// kOne.
struct Mirror {
  i16 a, b, d, e;
};
inline i16 flip_x_of(uint8_t way) { return way == 1 || way >= 6 ? static_cast<i16>(-1) : static_cast<i16>(1); }
inline i16 flip_y_of(uint8_t way) { return way >= 2 && (way & 1) != 0 ? static_cast<i16>(-1) : static_cast<i16>(1); }
inline Mirror mirror_of(const FluxSet::Stream& s, uint8_t way) {
  const i16 flip_x = flip_x_of(way), flip_y = flip_y_of(way);
  return {static_cast<i16>(flip_x * s.c), static_cast<i16>(-flip_x * s.s), static_cast<i16>(flip_y * s.s),
          static_cast<i16>(flip_y * s.c)};
}

// The parts of a packed cell in Q15.
inline i16 high_cos(i16 cell) { return static_cast<i16>(static_cast<uint16_t>(cell) << 8); }
inline i16 high_sin(i16 cell) { return static_cast<i16>(cell & ~255); }
inline i16 turned(i16 c, i16 s, i16 a, i16 b) { return static_cast<i16>(mulhi(c, a) + mulhi(s, b)); }

// Whatever the map holds |(x, y)| <= 180 / 127 kOne < 23000; what would double beyond int16 is held at 16383. The
// vector is a sum of g_i u_i, u_i the doubled ways, with the two g_i beside it positive.
inline i16 held(i16 x) { return x < 16383 ? x : static_cast<i16>(16383); }
// Axes: 2 g - sum of all g, -25800..32766; the sum is max(|x| + |y|/2, |y| + |x|/3).
inline i16 axis_of(i16 x, i16 y) {
  const i16 a = absolute(x), b = absolute(y);
  const i16 own = held(positive(static_cast<i16>(x - static_cast<i16>(b - (b >> 2)))));
  const i16 wide = static_cast<i16>(a + (b >> 1)), high = static_cast<i16>(b + third(a));
  return static_cast<i16>(static_cast<i16>(2 * own) - (wide > high ? wide : high));
}
// Diagonals: g = y - 4/3 |x|.
inline i16 diagonal_of(i16 x, i16 y) {
  const i16 a = absolute(x);
  return positive(static_cast<i16>(positive(y) - static_cast<i16>(a + third(a))));
}
// Knight's moves: g = min(5/4 y, 5/3 x).
inline i16 knight_of(i16 far, i16 near) {
  const i16 x = held(positive(far)), y = positive(near);
  const i16 one = static_cast<i16>(y + (y >> 2)), other = static_cast<i16>(static_cast<i16>(2 * x) - third(x));
  return one < other ? one : other;
}
// A link's pull is the mean of its two ends', floor(a/2) + floor(b/2); rows of pulls hold the halves.
inline i16 half(i16 a) { return static_cast<i16>(a >> 1); }

inline void pull_axis(const i16* DAPPLE_RESTRICT map, i16* DAPPLE_RESTRICT out, uint16_t n, Mirror m) {
  for (uint16_t k = 0; k < n; ++k) {
    const i16 c = high_cos(map[k]), s = high_sin(map[k]);
    out[k] = half(axis_of(turned(c, s, m.a, m.b), turned(c, s, m.d, m.e)));
  }
}
inline void pull_diagonal(const i16* DAPPLE_RESTRICT map, i16* DAPPLE_RESTRICT out, uint16_t n, Mirror m) {
  for (uint16_t k = 0; k < n; ++k) {
    const i16 c = high_cos(map[k]), s = high_sin(map[k]);
    out[k] = half(diagonal_of(turned(c, s, m.a, m.b), turned(c, s, m.d, m.e)));
  }
}
inline void pull_knight(const i16* DAPPLE_RESTRICT map, i16* DAPPLE_RESTRICT out, uint16_t n, Mirror m) {
  for (uint16_t k = 0; k < n; ++k) {
    const i16 c = high_cos(map[k]), s = high_sin(map[k]);
    out[k] = half(knight_of(turned(c, s, m.a, m.b), turned(c, s, m.d, m.e)));
  }
}

// What a way gets of a stream's direction, halves of units of kOne.
inline void pull_row(const FluxSet::Stream& s, uint8_t way, const i16* map, i16* out, uint16_t n) {
  const Mirror m = mirror_of(s, way);
  if (way < 2) pull_axis(map, out, n, m);
  else if (way < 4) pull_diagonal(map, out, n, m);
  else pull_knight(map, out, n, m);
}

inline FluxStage stage_of(const Spread& p, uint8_t way, uint8_t stage) {
  const int32_t stride = stride_of(stage), cap = stride * stride * (p.unit / 2);
  int32_t scale = 1;
  while (cap * scale < 16384) scale *= 2;
  const int32_t mean = way < 2 ? p.mean : INT32_C(0), before = share_before(p, stage);
  return {static_cast<i16>(slope_of(p, way) * 65536 / kOne),
          static_cast<i16>(mean - before),
          static_cast<i16>(cap),
          static_cast<i16>(base::min((INT32_C(1) << 29) / (cap * scale), 32767)),
          static_cast<i16>(mean),
          static_cast<i16>(before),
          static_cast<i16>(scale)};
}

// What a link carries: floor(weight * (to - from) / 2^16 + 1/2), in 16 bits throughout: |2 (to - from)| <= 32000, and
// floor((floor(2 a) + 1) / 2) = floor(a + 1/2). (The loops stay functions of their own: where a compiler sees that the
// factor is positive it multiplies in 32 bits.)
inline i16 carried_of(i16 q, i16 from, i16 to, FluxStage s) {
  const i16 t = positive(q < s.cap ? q : s.cap);
  const i16 weight = static_cast<i16>(
      2 * mulhi(static_cast<i16>(static_cast<uint16_t>(t) * static_cast<uint16_t>(s.scale)), s.factor));
  const i16 d = static_cast<i16>(to - from);
  return static_cast<i16>((mulhi(static_cast<i16>(2 * d), weight) + 1) >> 1);
}
inline i16 carried(i16 link, i16 from, i16 to, FluxStage s) {
  return carried_of(static_cast<i16>(mulhi(link, s.slope) + s.offset), from, to, s);
}

}  // namespace dapple::stencil
