// The Brusselator under periodic force: spirals, and domains of four phases, that never come to rest.
//   u' = c - (d + 1) u + (1 + G cos w t) u^2 v + D lap u,   v' = d u - u^2 v + delta D lap v
// Prigogine & Lefever 1968; forced: Lin et al. 2004, whose c + beta is c with `vary`. It oscillates where d > 1 + c^2;
// w = 1.69 is four times its own frequency at c = .5, d = 1.5.
// SPDX-License-Identifier: MIT
#pragma once
#include "kinetics.hpp"

namespace dapple::brusselator {

using namespace kinetics;

// Planes: u, v, held within 0..6 and 0..8.
constexpr int32_t kLargestU = 6 * (INT32_C(1) << kWide), kLargestV = 8 * (INT32_C(1) << kWide) - 1;

enum Own : uint8_t { feed = own, decay, force, pace, delta, slots };

constexpr int32_t kLeastScale = 250000;
constexpr int32_t kReaction = 5000000;  // what the reaction takes of the bound, measured

inline constexpr Number numbers[] = {
    scale_number(250000, 3000000, 1000000, kLengthUnit),
    dt_number(80000),
    show_number("u|v"),
    above_number(0, 8000000, 500000),
    reset_number,
    held_number,
    stretch_number,
    angle_number,
    vary_number(200000, "per cell: feed is uniform within this of its value"),
    coverage_number,
    decimal("feed", 100000, 2000000, 500000, "c"),
    decimal("decay", 500000, 4000000, 1500000, "d"),
    decimal("force", 0, 500000, 150000, "G, the strength of the force; .1 to .2 locks at a quarter of its pace"),
    decimal("pace", 0, 8000000, 1690000, "w, the force's radians per unit of time"),
    decimal("delta", 0, 8000000, 1000000,
            "diffusion of v beside that of u; 0 spirals, 1 domains, 5 domains fringed by spots"),
};

inline constexpr auto ranges = kinetics::ranges_of(numbers);
constexpr bool in_range(const int32_t* number) { return kinetics::in_range(ranges.range, slots, number); }

// u0 = c, v0 = d / c, .8 either way: by phases that is a circle. Discs hold twice the u.
constexpr grid::Levels levels(const int32_t* number, uint8_t plane) {
  const int64_t level = plane == 0 ? number[feed] : static_cast<int64_t>(number[decay]) * base::kMicro / number[feed];
  const int32_t largest = plane == 0 ? kLargestU : kLargestV, least = fixed(50000, kWide), far = fixed(800000, kWide);
  const int32_t centre = level >= 7 * base::kMicro ? largest - far : base::min(fixed(level, kWide), largest - far);
  return {centre, plane == 0 ? 2 * centre : centre, base::max(centre - far, least), centre + far};
}

// The width of a front, about 16 cells at scale 1: there is no wavelength.
constexpr int32_t wavelength(const int32_t* number) { return 16 * number[scale]; }

// D of a plane on a grid, 1/kMicro cells^2 a unit of time.
constexpr int64_t diffusion(const int32_t* number, uint8_t plane, uint8_t level) {
  const int64_t length = number[scale] >> level, d = length * length / base::kMicro;
  return plane == 0 ? d : d * number[delta] / base::kMicro;
}
constexpr int32_t most_dt(const int32_t* number, uint8_t level) {
  const int64_t u = diffusion(number, 0, level), v = diffusion(number, 1, level);
  return largest_dt(u > v ? u : v, kReaction);
}
constexpr Bound bound(const int32_t* number, uint8_t level) {
  return bound_of(number, level, kLeastScale, most_dt(number, level));
}

// The phase of the force, 2^32 to the turn: step * round(w dt / (2 pi) * 2^32), which wraps as a turn does.
constexpr uint32_t phase_of(const int32_t* number, uint32_t step, int32_t dt_now) {
  const int64_t turn = static_cast<int64_t>(number[pace]) * dt_now / base::kMicro;  // radians, 1/kMicro
  return step * static_cast<uint32_t>(base::divide_round(turn * INT64_C(683565276), base::kMicro));  // 2^32 / (2 pi)
}

// p: {c in Q14, d + 1 in Q12, d in Q12, 1 + G cos w t in Q10; dt, dt D and dt delta D as packed rates}
constexpr void values(const int32_t* number, Clock clock, int32_t* p) {
  const int32_t step = step_of(number, most_dt(number, clock.level));
  const int32_t wave = base::cosine(static_cast<uint16_t>(phase_of(number, clock.step, step) >> 16));
  p[0] = fixed(number[feed], 14);
  p[1] = fixed(number[decay] + base::kMicro, 12);
  p[2] = fixed(number[decay], 12);
  p[3] = 1024 + static_cast<int32_t>(base::divide_round(static_cast<int64_t>(number[force]) * wave * 1024,
                                                        INT64_C(32767) * base::kMicro));
  p[4] = packed(rate_of(q30_of(step), 14, kWide));
  for (uint8_t plane = 0; plane < 2; ++plane)
    p[5 + plane] = packed(rate_of(times_dt(q30_of(diffusion(number, plane, clock.level)), step), 14, kWide));
}

void react_row(const grid::Rows& rows);

}  // namespace dapple::brusselator

namespace dapple {
inline constexpr Model brusselator_model DAPPLE_ROM =
    kinetics::model_of(grid::Cell::int32, 0, brusselator::in_range, kinetics::two_planes, brusselator::levels,
                       brusselator::wavelength, brusselator::values, brusselator::react_row, brusselator::bound);
}  // namespace dapple
