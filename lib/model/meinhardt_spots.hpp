// Meinhardt's spots: an activator that makes more of itself and of its inhibitor, which divides it.
//   a' = s (.01 a^2 beta / b - p1 a + p3) + Da lap a,   b' = s (.01 a^2 beta - p2 b + p3) + Db lap b
// Meinhardt 1982, chapter 3; Turk 1991. With p3 = 0 spots stay alone at any distance: a = 0 is stable.
// SPDX-License-Identifier: MIT
#pragma once
#include "kinetics.hpp"

namespace dapple::meinhardt_spots {

using namespace kinetics;

// Planes: a, b. Settled, a <= 5.8 and .22 <= b <= 1.16; both are held below `largest`, and b is divided by as at least
// 2^-10.
constexpr int32_t kLargest = 8 * (INT32_C(1) << kWide) - 1;

enum Own : uint8_t { decay = own, drain, base_rate, spread, reach, slots };

constexpr int32_t kLeastScale = 1250000;  // cells of the grid: s = .64; below, spots die for want of cells

inline constexpr Number numbers[] = {
    scale_number(kLeastScale, 8000000, 2236068),
    dt_number(1000000),
    show_number("a|b"),
    above_number(0, 8000000, 1500000),
    reset_number,
    held_number,
    stretch_number,
    angle_number,
    vary_number(500000, "per cell: beta is uniform within this of 1"),
    coverage_number,
    decimal("decay", 10000, 150000, 30000, "p1, the rate at which a goes"),
    decimal("drain", 10000, 150000, 40000, "p2, the rate at which b goes"),
    decimal("base", 0, 50000, 0, "p3, the rate at which both are made; .004 lets empty places refill"),
    decimal("spread", 2000, 100000, 10000, "cells^2 per step: Da"),
    decimal("reach", 20000, 240000, 200000, "cells^2 per step: Db"),
};

inline constexpr auto ranges = kinetics::ranges_of(numbers);
constexpr bool in_range(const int32_t* number) { return kinetics::in_range(ranges.range, slots, number); }

// a0 = p2 / p1, b0 = .01 a0^2 / p2 (of p3 = 0). Noise of a tenth either way on a; discs hold three times the a.
constexpr grid::Levels levels(const int32_t* number, uint8_t plane) {
  const int64_t a0 = static_cast<int64_t>(number[drain]) * base::kMicro / number[decay];
  const int32_t a = static_cast<int32_t>(base::min(fixed(a0, kWide), kLargest / 4));
  const int64_t b0 = a0 * a0 / 100 / number[drain];
  const int32_t b = base::min(fixed(b0, kWide), kLargest);
  return plane == 0 ? grid::Levels{a, 3 * a, a - a / 10, a + a / 10} : grid::Levels{b, b, b, b};
}

// 6.2 / sqrt(s), measured within 6 % at Da = .01, Db = .2; lengths go with (Da Db)^(1/4).
constexpr int32_t wavelength(const int32_t* number) {
  const int64_t root = fourth_root(static_cast<int64_t>(number[spread]) * number[reach], INT64_C(2000000000));
  return stretched(number[scale] * root / base::kMicro * 31 / 5, number[stretch]);
}

constexpr int32_t most_dt(const int32_t* number, uint8_t) { return largest_dt(number[reach], 0); }
constexpr Bound bound(const int32_t* number, uint8_t level) {
  return bound_of(number, level, kLeastScale, most_dt(number, level));
}

// p: {p1, p2 in Q16, p3 in Q20; rates of the reaction, of Da and of Db, packed}
constexpr void values(const int32_t* number, Clock clock, int32_t* p) {
  const int32_t step = step_of(number, most_dt(number, clock.level));
  p[0] = fixed(number[decay], 16);
  p[1] = fixed(number[drain], 16);
  p[2] = fixed(number[base_rate], 20);
  p[3] = packed(rate_of(times_dt(speed_q30(number, clock.level), step), 20, kWide));
  p[4] = packed(rate_of(times_dt(q30_of(number[spread]), step), 14, kWide));
  p[5] = packed(rate_of(times_dt(q30_of(number[reach]), step), 14, kWide));
}

void react_row(const grid::Rows& rows);

}  // namespace dapple::meinhardt_spots

namespace dapple {
inline constexpr Model meinhardt_spots_model DAPPLE_ROM =
    kinetics::model_of(grid::Cell::int32, 0, meinhardt_spots::in_range, kinetics::two_planes, meinhardt_spots::levels,
                       meinhardt_spots::wavelength, meinhardt_spots::values, meinhardt_spots::react_row, meinhardt_spots::bound);
inline constexpr Model compact_meinhardt_spots_model DAPPLE_ROM =
    kinetics::compact_of<12, meinhardt_spots::levels>(meinhardt_spots_model);
}  // namespace dapple
