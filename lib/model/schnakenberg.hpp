// Schnakenberg's kinetics: u' = s (a - u + u^2 v) + Du lap u, v' = s (b - u^2 v) + Dv lap v. Schnakenberg 1979.
// SPDX-License-Identifier: MIT
#pragma once
#include "kinetics.hpp"

namespace dapple::schnakenberg {

using namespace kinetics;

// Planes: u, v, held within 0..6 and 0..4.
constexpr int32_t kLargestU = 6 * (INT32_C(1) << kWide), kLargestV = 4 * (INT32_C(1) << kWide) - 1;

enum Own : uint8_t { feed = own, supply, spread, reach, slots };

constexpr int32_t kLeastScale = 3000000;

inline constexpr Number numbers[] = {
    scale_number(kLeastScale, 32000000, 7071068),
    dt_number(1000000),
    show_number("u|v"),
    above_number(0, 6000000, 1200000),
    reset_number,
    held_number,
    stretch_number,
    angle_number,
    vary_number(100000, "per cell: feed is uniform within this of its value"),
    coverage_number,
    decimal("feed", 10000, 500000, 100000, "a, the rate at which u is made"),
    decimal("supply", 100000, 2000000, 900000, "b, the rate at which v is made"),
    decimal("spread", 2000, 100000, 20000, "cells^2 per step: Du"),
    decimal("reach", 20000, 240000, 200000, "cells^2 per step: Dv"),
};

inline constexpr auto ranges = kinetics::ranges_of(numbers);
constexpr bool in_range(const int32_t* number) { return kinetics::in_range(ranges.range, slots, number); }

// u0 = a + b, v0 = b / u0^2. Noise of a tenth either way on u; discs hold twice the u.
constexpr grid::Levels levels(const int32_t* number, uint8_t plane) {
  const int64_t u0 = static_cast<int64_t>(number[feed]) + number[supply];
  const int32_t u = fixed(u0, kWide);
  const int32_t v =
      base::min(fixed(static_cast<int64_t>(number[supply]) * base::kMicro / u0 * base::kMicro / u0, kWide), kLargestV);
  return plane == 0 ? grid::Levels{u, base::min(2 * u, kLargestU), u - u / 10, u + u / 10} : grid::Levels{v, v, v, v};
}

// 10.6 cells at s = .02, Du = .02, Dv = .2; lengths go with (Du Dv)^(1/4) / sqrt(s).
constexpr int32_t wavelength(const int32_t* number) {
  const int64_t root = fourth_root(static_cast<int64_t>(number[spread]) * number[reach], INT64_C(4000000000));
  return static_cast<int32_t>(number[scale] * root / base::kMicro * 3 / 2);
}

// dt (8 Dv + s u^2) < 2, with u^2 up to about 3 where v's checkerboard grows.
constexpr int32_t most_dt(const int32_t* number, uint8_t level) {
  return largest_dt(number[reach], 3 * micro_of(speed_q30(number, level)));
}
constexpr Bound bound(const int32_t* number, uint8_t level) {
  return bound_of(number, level, kLeastScale, most_dt(number, level));
}

// p: {a, b in Q14; rates of the reaction, of Du and of Dv, packed}
constexpr void values(const int32_t* number, Clock clock, int32_t* p) {
  const int32_t step = step_of(number, most_dt(number, clock.level));
  p[0] = fixed(number[feed], 14);
  p[1] = fixed(number[supply], 14);
  p[2] = packed(rate_of(times_dt(speed_q30(number, clock.level), step), 14, kWide));
  p[3] = packed(rate_of(times_dt(q30_of(number[spread]), step), 14, kWide));
  p[4] = packed(rate_of(times_dt(q30_of(number[reach]), step), 14, kWide));
}

void react_row(const grid::Rows& rows);

}  // namespace dapple::schnakenberg

namespace dapple {
inline constexpr Model schnakenberg_model DAPPLE_ROM =
    kinetics::model_of(grid::Cell::int32, 0, schnakenberg::in_range, kinetics::two_planes, schnakenberg::levels,
                       schnakenberg::wavelength, schnakenberg::values, schnakenberg::react_row, schnakenberg::bound);
}  // namespace dapple
