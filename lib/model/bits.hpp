// Binary convolution: activator and inhibitor in the limit of strong dissipation, at one bit a cell. R' = [D > rho P] with
// D = K * R, or over several orientations the maximum of K_j * R (M-D) or maximum + minimum (D-A). Witkin & Kass 1991, 5.3.
// SPDX-License-Identifier: MIT
#pragma once
#include "../base/math.hpp"
#include "model.hpp"

namespace dapple::bits {

constexpr int16_t kUnit = 8000;  // of the field: D = P, the positive sum of the mask

enum Slot : uint8_t { masks, react, diffusion, radius, scale, stretch, angles, rho = angles + 5, slots = rho + 4 };
enum Diffusion : uint8_t { oriented, isotropic };

constexpr int32_t kScale[2] = {4000000, 18000000}, kStretch[2] = {1000000, 5000000};
constexpr int32_t kLargestRho = 500000, kTurn = 360000000;

inline constexpr Number numbers[] = {
    {Number::integer, "masks", 1, 5, 1, nullptr, "orientations"},
    {Number::word, "react", 0, 1, 0, "md|da", "md: max of differences (14); da: difference of abs (15)"},
    {Number::word, "diffusion", 0, 1, 0, "oriented|isotropic", "shape of the masks"},
    {Number::integer, "window", 4, 8, 6, nullptr, "cells of the grid: radius of the masks"},
    {Number::decimal, "scale", kScale[0], kScale[1], 9000000, nullptr, "cells of the grid: nominal wavelength, .8 to 2.2 windows"},
    {Number::decimal, "stretch", kStretch[0], kStretch[1], 3000000, nullptr, "e, length along the stripes"},
    {Number::angles, "angle", -kTurn, kTurn, 0, nullptr, "degrees from x towards y (down), along the stripes"},
    {Number::schedule, "rho", -kLargestRho, kLargestRho, 0, nullptr, "P: the threshold on the difference"},
};

// A range of a number, 1/kMicro, where it depends on others.
struct Living {
  int32_t low, high;
};

// The thresholds between which a pattern lives, in 1/kMicro of P: beyond them every cell goes off, or on, within twelve steps
// (measured for each rule at the usual wavelengths, where less than 2 % of the cells, or of the ground, are left).
constexpr Living living_of(int32_t masks, bool sums, bool round) {
  if (masks == 1) return round ? Living{-440000, 440000} : Living{-kLargestRho, kLargestRho};
  if (!sums) return {-120000, masks > 3 ? 430000 : 450000};
  return masks == 2 ? Living{-370000, 350000} : Living{-430000, 430000};
}
constexpr Living living(const int32_t* number) {
  return living_of(number[masks], number[react] == 1, number[diffusion] == isotropic);
}

// The nominal wavelengths a mask of this radius shows well.
constexpr Living lengths_of(int32_t radius) {
  const int32_t low = radius * (base::kMicro / 10 * 8), high = radius * (base::kMicro / 10 * 22);
  return {low > kScale[0] ? low : kScale[0], high < kScale[1] ? high : kScale[1]};
}
constexpr Living lengths(const int32_t* number) { return lengths_of(number[radius]); }

constexpr bool in_range(const int32_t* number) {
  for (uint8_t j = 0; j < 5; ++j)
    if (!within(number[angles + j], -2 * kTurn, 2 * kTurn)) return false;
  return within(number[masks], 1, 5) && within(number[react], 0, 1) && within(number[diffusion], 0, 1) &&
         within(number[radius], 4, 8) && within(number[scale], lengths(number).low, lengths(number).high) && within(number[stretch], kStretch[0], kStretch[1]) &&
         schedule_within(number + rho, living(number).low, living(number).high);
}

constexpr uint8_t planes(const int32_t*) { return 1; }
constexpr grid::Tensor tensor(const int32_t*, uint8_t) { return {0, 0, 0}; }
constexpr grid::Levels levels(const int32_t*, uint8_t) { return {0, 1, 0, 1}; }

// Roughly; grown_wavelength (evolve/) knows better.
constexpr int32_t wavelength(const int32_t* number) { return number[scale] / 16 * 15; }

constexpr int16_t cell_level(const int32_t* number) {
  return static_cast<int16_t>(base::divide_round(static_cast<int64_t>(number[rho + 1]) * kUnit, base::kMicro));
}

// p: {react, rho in 1/kMicro of P}
constexpr void values(const int32_t* number, Clock clock, int32_t* p) {
  p[0] = number[react];
  p[1] = scheduled(number + rho, clock);
}

}  // namespace dapple::bits

namespace dapple {
inline constexpr Model bits_model DAPPLE_ROM = {
    grid::Cell::bit,  0,       bits::kUnit, 0,       bits::in_range, bits::planes, bits::tensor, bits::levels, bits::wavelength,
    bits::cell_level, bits::values, nullptr, nullptr, nullptr,        nullptr,      true};
}  // namespace dapple
