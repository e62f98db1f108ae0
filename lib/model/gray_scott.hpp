// Gray-Scott: u feeds v, v kills itself. Pearson 1993, eq. 2.
// SPDX-License-Identifier: MIT
#pragma once
#include "../base/math.hpp"
#include "model.hpp"

namespace dapple::gray_scott {

constexpr int16_t kUnit = 16384;  // v = 1.0 in Q14
constexpr int16_t kOne = 16383;   // u = 1.0, so that every sum fits int16

// Slots. Plane 0 is u (the substrate), plane 1 is v (the activator, which paint shows).
enum Slot : uint8_t { feed, kill, scale, above, slots };

constexpr int32_t kFeed[2] = {5000, 100000}, kKill[2] = {30000, 75000};
constexpr int32_t kScale[2] = {500000, 1100000}, kAbove[2] = {10000, 500000};

inline constexpr Number numbers[] = {
    {Number::decimal, "feed", kFeed[0], kFeed[1], 36700, nullptr, "per step: F, the rate at which u is fed"},
    {Number::decimal, "kill", kKill[0], kKill[1], 64900, nullptr, "per step: k, the rate at which v dies beyond F"},
    {Number::decimal, "scale", kScale[0], kScale[1], 1000000, nullptr, "length: Du = .16 scale^2, Dv = .08 scale^2"},
    {Number::decimal, "above", kAbove[0], kAbove[1], 200000, nullptr, "v above which a cell is on"},
};

constexpr bool in_range(const int32_t* number) {
  return within(number[feed], kFeed[0], kFeed[1]) && within(number[kill], kKill[0], kKill[1]) &&
         within(number[scale], kScale[0], kScale[1]) && within(number[above], kAbove[0], kAbove[1]);
}

constexpr uint8_t planes(const int32_t*) { return 2; }

// Diffusion rates of one step as an even Q16 weight; the variance of a step is 2 D.
constexpr int32_t rate_q16(const int32_t* number, uint8_t plane) {
  const int64_t square = static_cast<int64_t>(number[scale]) * number[scale] / base::kMicro;  // scale^2, 1/kMicro
  return static_cast<int32_t>(2 * base::divide_round(square * 32768 * (plane == 0 ? 16 : 8), INT64_C(100) * base::kMicro));
}
constexpr grid::Tensor tensor(const int32_t* number, uint8_t plane) {
  const int32_t variance = 2 * rate_q16(number, plane);
  return {variance, 0, variance};
}

// u = 1, v = 0 with discs of u = 1/2, v = 1/4; noise lies between the two.
constexpr grid::Levels levels(const int32_t*, uint8_t plane) {
  return plane == 0 ? grid::Levels{kOne, 8192, 8192, kOne} : grid::Levels{0, 4096, 0, 4096};
}

// About 12 cells at scale 1 for the named parameter sets (measured 11 to 14).
constexpr int32_t wavelength(const int32_t* number) { return 12 * number[scale]; }

constexpr int16_t cell_level(const int32_t* number) {
  return static_cast<int16_t>(base::divide_round(static_cast<int64_t>(number[above]) * kUnit, base::kMicro));
}

// p: {F, rounding of F, F + k, rounding of F + k}, even Q16.
constexpr void values(const int32_t* number, Clock, int32_t* p) {
  p[0] = static_cast<int32_t>(2 * base::divide_round(static_cast<int64_t>(number[feed]) * 32768, base::kMicro));
  p[1] = base::rounding_for(static_cast<int16_t>(p[0]));
  p[2] = static_cast<int32_t>(2 * base::divide_round((static_cast<int64_t>(number[feed]) + number[kill]) * 32768, base::kMicro));
  p[3] = base::rounding_for(static_cast<int16_t>(p[2]));
}

void react_row(const grid::Rows& rows);
void field_row(const grid::Rows& rows);

}  // namespace dapple::gray_scott

namespace dapple {
inline constexpr Model gray_scott_model DAPPLE_ROM = {
    grid::Cell::int16,         0,                      gray_scott::kUnit,   0,
    gray_scott::in_range,      gray_scott::planes,        gray_scott::tensor,     gray_scott::levels,  gray_scott::wavelength,
    gray_scott::cell_level,    gray_scott::values,     nullptr,             gray_scott::react_row,
    nullptr,                   gray_scott::field_row};
}  // namespace dapple
