// Turing's spots and stripes in the form of growth and decay: a' = s (g - a b) + Da lap a, b' = s (a b - b - d) + Db
// lap b. Turing 1952, eq. 10.1; Turk 1991. Patterns grow while sqrt(d) < g - d < b*, 4 d = b*^2 + 4 b*^1.5 (Da = 4 Db).
// SPDX-License-Identifier: MIT
#pragma once
#include "kinetics.hpp"

namespace dapple::turing {

using namespace kinetics;

// Planes: a, whose maxima are the spots, and b. Both are held within 0..largest, which settled patterns (a <= 11.1, b
// <= 11.3) never touch; b = 0 needs it.
constexpr int32_t kLargestA = 20, kLargestB = 14;

enum Own : uint8_t { growth = own, decay, spread, ratio, dark, lit, slots };

constexpr int32_t kGrowth[2] = {2000000, 30000000}, kDecay[2] = {1000000, 29000000}, kSpread[2] = {10000, 240000},
                  kRatio[2] = {2000000, 16000000};
constexpr uint8_t kGrown = 5;             // of p
constexpr int32_t kLeastB = 500000;       // g - d, the uniform b
constexpr int32_t kPeak = 6600000;        // b where steps first diverge, measured
constexpr int32_t kLeastScale = 3000000;  // cells of the grid: a wavelength of four

inline constexpr Number numbers[] = {
    scale_number(kLeastScale, 64000000, 11313708),
    dt_number(1000000),
    show_number("a|b"),
    above_number(0, 20000000, 5000000),
    reset_number,
    held_number,
    stretch_number,
    angle_number,
    vary_number(1000000, "per cell: decay (with a picture, growth) is uniform within this of its value"),
    coverage_number,
    decimal("growth", kGrowth[0], kGrowth[1], 16000000, "g, the rate at which a is made"),
    decimal("decay", kDecay[0], kDecay[1], 12050000,
            "d, the rate at which b goes; 12.05 round spots, 12.25 fast ones, 12.5 worms among them"),
    decimal("spread", kSpread[0], kSpread[1], 200000, "cells^2 per step: Da, the diffusion of a"),
    decimal("ratio", kRatio[0], kRatio[1], 4000000, "Da / Db"),
    decimal("dark", kGrowth[0], kGrowth[1], 14400000, "with solver=pictured: growth where the picture is black"),
    decimal("lit", kGrowth[0], kGrowth[1], 18000000, "with solver=pictured: growth where the picture is white"),
};

inline constexpr auto ranges = kinetics::ranges_of(numbers);
constexpr bool in_range(const int32_t* number) {
  return kinetics::in_range(ranges.range, slots, number) && number[growth] - number[decay] >= kLeastB;
}

constexpr int64_t spread_of(const int32_t* number, uint8_t plane) {
  return plane == 0 ? number[spread]
                    : base::divide_round(static_cast<int64_t>(number[spread]) * base::kMicro, number[ratio]);
}

// a0 = g / b0, b0 = g - d. Noise of one half either way; discs hold twice the a.
constexpr grid::Levels levels(const int32_t* number, uint8_t plane) {
  const int64_t b0 = number[growth] - number[decay];
  const int32_t level =
      fixed(plane == 0 ? base::divide_round(static_cast<int64_t>(number[growth]) * base::kMicro, b0) : b0, kWide);
  const int32_t half = INT32_C(1) << (kWide - 1),
                largest = (plane == 0 ? kLargestA : kLargestB) * (INT32_C(1) << kWide);
  const int32_t centre = level < largest - half ? level : largest - half;
  return {centre, plane == 0 ? base::min(2 * centre, largest) : centre, base::max(centre - half, 0), centre + half};
}

// 2 pi (Da Db / b0)^(1/4) / sqrt(s), less the 1 % by which grown patterns are shorter: a spot has 2 / sqrt(3) of its square.
constexpr int32_t wavelength(const int32_t* number) {
  const int64_t square = spread_of(number, 0) * spread_of(number, 1) / (number[growth] - number[decay]) * base::kMicro;
  const int64_t root =
      base::square_root64(static_cast<uint64_t>(base::square_root64(static_cast<uint64_t>(square))) * 1000000);
  return stretched(number[scale] * root / base::kMicro * 6170000 / base::kMicro, number[stretch]);
}

// dt (8 Da + s b) < 2 with b up to about 6.6; and s dt < 1/8, for the formats of the reaction.
constexpr int32_t most_dt(const int32_t* number, uint8_t level) {
  const int64_t speed = micro_of(speed_q30(number, level)) + 1, most = INT64_C(125000) * base::kMicro / speed - 1;
  const int32_t dt = largest_dt(number[spread], speed * kPeak / base::kMicro);
  return most < dt ? static_cast<int32_t>(most) : dt;
}
constexpr Bound bound(const int32_t* number, uint8_t level) {
  return bound_of(number, level, kLeastScale, most_dt(number, level));
}

// p: {g, d in Q12; rates of the reaction, of Da and of Db, packed; whether what varies is g}
constexpr void values(const int32_t* number, Clock clock, int32_t* p) {
  const int32_t step = step_of(number, most_dt(number, clock.level));
  p[0] = fixed(number[growth], 12);
  p[1] = fixed(number[decay], 12);
  p[2] = packed(rate_of(times_dt(speed_q30(number, clock.level), step), 12, kWide));
  for (uint8_t plane = 0; plane < 2; ++plane)
    p[3 + plane] = packed(rate_of(times_dt(q30_of(spread_of(number, plane)), step), 14, kWide));
  p[kGrown] = 0;
}

void react_row(const grid::Rows& rows);

}  // namespace dapple::turing

namespace dapple {
inline constexpr Model turing_model DAPPLE_ROM =
    kinetics::model_of(grid::Cell::int32, 0, turing::in_range, kinetics::two_planes, turing::levels,
                       turing::wavelength, turing::values, turing::react_row, turing::bound);
inline constexpr Model compact_turing_model DAPPLE_ROM = kinetics::compact_of<11, turing::levels>(turing_model);  // below 16
}  // namespace dapple
