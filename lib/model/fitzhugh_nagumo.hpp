// FitzHugh-Nagumo with a slow inhibitor that spreads further than the activator: labyrinths, worms, spots by the bias.
//   a' = a - a^3 - b + Da lap a,   b' = s (a - s1 b - s0) + Db lap b
// FitzHugh 1961, Nagumo 1962. Steady patterns need Db > Da; with Da > Db there are only travelling waves.
// SPDX-License-Identifier: MIT
#pragma once
#include "kinetics.hpp"

namespace dapple::fitzhugh_nagumo {

using namespace kinetics;

// Planes: a, b in Q14, held within +-2. Settled, |a| < 1.1, |b| < .4.
constexpr int32_t kLargest = 32767;

enum Own : uint8_t { slow = own, couple, bias, spread, reach, slots };

constexpr int32_t kLeastScale = 350000;  // on its grid: a wavelength of six

inline constexpr Number numbers[] = {
    scale_number(400000, 4000000, 1000000, kLengthUnit),
    dt_number(100000),
    show_number("a|b"),
    above_number(-2000000, 2000000, 0),
    reset_number,
    held_number,
    stretch_number,
    angle_number,
    vary_number(200000, "per cell: bias is uniform within this of its value"),
    coverage_number,
    decimal("slow", 10000, 200000, 50000, "s, the rate of b beside that of a"),
    decimal("couple", 1200000, 4000000, 2000000, "s1, the decay of b"),
    decimal("bias", -300000, 300000, 0, "s0; 0 labyrinth, -.05 to -.1 worms, -.15 spots and beans, -.2 sparse spots"),
    decimal("spread", 100000, 2000000, 500000, "Da at scale 1; below .5 fronts catch on the lattice"),
    decimal("reach", 200000, 8000000, 2000000, "Db at scale 1"),
};

inline constexpr auto ranges = kinetics::ranges_of(numbers);
constexpr bool in_range(const int32_t* number) { return kinetics::in_range(ranges.range, slots, number); }

// The middle state a - a^3 - (a - s0) / s1 = 0, by a = (a^3 - s0 / s1) / (1 - 1 / s1) from 0 on, within +-1/2; b = (a -
// s0) / s1.
constexpr int64_t middle(const int32_t* number) {
  const int64_t one = base::kMicro, less = one - one * one / number[couple], push = one * number[bias] / number[couple];
  int64_t a = 0;
  for (uint8_t i = 0; i < 24; ++i) {
    a = (a * a / one * a / one - push) * one / less;
    a = a < -one / 2 ? -one / 2 : a > one / 2 ? one / 2 : a;
  }
  return a;
}

// Noise of .4 either way on a, which the bias asks for; discs hold a = 1.
constexpr grid::Levels levels(const int32_t* number, uint8_t plane) {
  const int64_t a = middle(number);
  if (plane == 0) return {fixed(a, kNarrow), 1 << kNarrow, fixed(a - 400000, kNarrow), fixed(a + 400000, kNarrow)};
  const int32_t b = fixed((a - number[bias]) * base::kMicro / number[couple], kNarrow);
  return {b, b, b, b};
}

// 17.8 cells at s = .05, Da = .5, Db = 2; lengths go with (Da Db)^(1/4), and measured with s^-.2.
constexpr int32_t wavelength(const int32_t* number) {
  const int64_t root = fourth_root(static_cast<int64_t>(number[spread]) * number[reach], INT64_C(1000000000000));
  return static_cast<int32_t>(number[scale] * root / base::kMicro * 178 / 10);
}

// D of a plane on a grid, 1/kMicro cells^2 a unit of time.
constexpr int64_t diffusion(const int32_t* number, uint8_t plane, uint8_t level) {
  const int64_t length = number[scale] >> level;
  return length * length / base::kMicro * number[plane == 0 ? spread : reach] / base::kMicro;
}
// dt (8 Da + 3) < 2, for |a - a^3| is at most 3 steep where |a| is below 1.15; dt (8 Db + s s1) < 2.
constexpr int32_t most_dt(const int32_t* number, uint8_t level) {
  const int64_t slowing = static_cast<int64_t>(number[slow]) * number[couple] / base::kMicro;
  return base::min(largest_dt(diffusion(number, 0, level), 3 * base::kMicro),
                   largest_dt(diffusion(number, 1, level), slowing));
}
constexpr Bound bound(const int32_t* number, uint8_t level) {
  return bound_of(number, level, kLeastScale, most_dt(number, level));
}

// p: {s1 in Q12, s0 in Q14; dt, s dt and dt Da, dt Db as packed rates}
constexpr void values(const int32_t* number, Clock clock, int32_t* p) {
  const int32_t step = step_of(number, most_dt(number, clock.level));
  p[0] = fixed(number[couple], 12);
  p[1] = fixed(number[bias], kNarrow);
  p[2] = packed(rate_of(q30_of(step), 14, kNarrow));
  p[3] = packed(rate_of(times_dt(q30_of(number[slow]), step), 14, kNarrow));
  for (uint8_t plane = 0; plane < 2; ++plane)
    p[4 + plane] = packed(rate_of(times_dt(q30_of(diffusion(number, plane, clock.level)), step), 14, kNarrow));
}

void react_row(const grid::Rows& rows);

}  // namespace dapple::fitzhugh_nagumo

namespace dapple {
inline constexpr Model fitzhugh_nagumo_model DAPPLE_ROM =
    kinetics::model_of(grid::Cell::int16, 0, fitzhugh_nagumo::in_range, kinetics::two_planes, fitzhugh_nagumo::levels,
                       fitzhugh_nagumo::wavelength, fitzhugh_nagumo::values, fitzhugh_nagumo::react_row, fitzhugh_nagumo::bound);
}  // namespace dapple
