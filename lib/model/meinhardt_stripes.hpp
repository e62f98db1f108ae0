// Meinhardt's stripes: two activators that exclude each other through c and help each other through d and e.
//   a' = s (.01 a^2 e beta / c - ka a) + Da lap a
//   b' = s (.01 b^2 d beta / c - ka b) + Da lap b
//   c' = s (.01 beta (a^2 e + b^2 d) - kc c)
//   d' = s kd (a - d) + Dd lap d
//   e' = s kd (b - e) + Dd lap e
// Meinhardt 1982, chapter 12; Turk 1991. Nothing moves but from a difference: initiator cells draw the stripes.
// SPDX-License-Identifier: MIT
#pragma once
#include "kinetics.hpp"

namespace dapple::meinhardt_stripes {

using namespace kinetics;

// Planes: a, b, c, d, e in Q14, held within 0..2. Settled, a, b <= 1.96, .08 <= c <= .45, .2 <= d, e <= 1.3; c is
// divided by as at least 2^-5.
constexpr int32_t kLargest = 32767;

enum Own : uint8_t { decay = own, drain, relax, spread, reach, slots };

constexpr int32_t kLeastScale = 600000;

inline constexpr Number numbers[] = {
    scale_number(kLeastScale, 2000000, 1000000),
    dt_number(1000000),
    show_number("a|b|c|d|e"),
    above_number(0, 2000000, 750000),
    reset_number,
    held_number,
    stretch_number,
    angle_number,
    vary_number(200000, "per cell: beta is uniform within this of 1"),
    coverage_number,
    decimal("decay", 10000, 150000, 40000, "ka, the rate at which a and b go"),
    decimal("drain", 10000, 150000, 60000, "kc, the rate at which c goes"),
    decimal("relax", 10000, 150000, 40000, "kd, the rate at which d follows a, and e follows b"),
    decimal("spread", 5000, 100000, 20000, "cells^2 per step: Da; below .015 the lattice shows"),
    decimal("reach", 50000, 245000, 240000, "cells^2 per step: Dd"),
};

inline constexpr auto ranges = kinetics::ranges_of(numbers);
constexpr bool in_range(const int32_t* number) {
  return kinetics::in_range(ranges.range, slots, number) && number[drain] < 4 * static_cast<int64_t>(number[decay]);
}

constexpr uint8_t planes(const int32_t*) { return 5; }

// a0 = b0 = d0 = e0 = kc / (2 ka), c0 = .02 a0^3 / kc. Noise of a twentieth on a and b; discs hold twice the a.
constexpr grid::Levels levels(const int32_t* number, uint8_t plane) {
  const int64_t level = static_cast<int64_t>(number[drain]) * base::kMicro / (2 * number[decay]);
  const int32_t a = fixed(level, kNarrow);
  const int32_t c = base::min(fixed(level * level / base::kMicro * level / 50 / number[drain], kNarrow), kLargest);
  if (plane == 2) return {c, c, c, c};
  if (plane > 2) return {a, a, a, a};
  return {a, plane == 0 ? base::min(2 * a, kLargest) : a, a - a / 20, base::min(a + a / 20, kLargest)};
}

// 12 cells at Da = .02, Dd = .24, s = 1; lengths go with (Da Dd)^(1/4) / sqrt(s).
constexpr int32_t wavelength(const int32_t* number) {
  const int64_t root = fourth_root(static_cast<int64_t>(number[spread]) * number[reach], INT64_C(4800000000));
  return static_cast<int32_t>(number[scale] * root / base::kMicro * 12);
}

// dt 8 Dd < 2.
constexpr int32_t most_dt(const int32_t* number, uint8_t) { return largest_dt(number[reach], 0); }
constexpr Bound bound(const int32_t* number, uint8_t level) {
  return bound_of(number, level, kLeastScale, most_dt(number, level));
}

// p: {ka, kc, kd in Q16; rates of the reaction, of Da and of Dd, packed}
constexpr void values(const int32_t* number, Clock clock, int32_t* p) {
  const int32_t step = step_of(number, most_dt(number, clock.level));
  p[0] = fixed(number[decay], 16);
  p[1] = fixed(number[drain], 16);
  p[2] = fixed(number[relax], 16);
  p[3] = packed(rate_of(times_dt(speed_q30(number, clock.level), step), 20, kNarrow));
  p[4] = packed(rate_of(times_dt(q30_of(number[spread]), step), 14, kNarrow));
  p[5] = packed(rate_of(times_dt(q30_of(number[reach]), step), 14, kNarrow));
}

void react_row(const grid::Rows& rows);

}  // namespace dapple::meinhardt_stripes

namespace dapple {
inline constexpr Model meinhardt_stripes_model DAPPLE_ROM =
    kinetics::model_of(grid::Cell::int16, 2, meinhardt_stripes::in_range, meinhardt_stripes::planes, meinhardt_stripes::levels,
                       meinhardt_stripes::wavelength, meinhardt_stripes::values, meinhardt_stripes::react_row, meinhardt_stripes::bound);
}  // namespace dapple
