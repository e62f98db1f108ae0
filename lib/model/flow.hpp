// Binary convolution along a field of directions: one to five threads, each at its own angle to the direction of the place.
// R' = [max over threads D > rho P]; see stencil/steer.hpp.
// SPDX-License-Identifier: MIT
#pragma once
#include "bits.hpp"

namespace dapple::flow {

using bits::kUnit;

enum Slot : uint8_t { threads, field, nodes, bend, radius, scale, stretch, angles, rho = angles + 5, slots = rho + 4 };

constexpr int32_t kNodes[2] = {16, 1024}, kBend[2] = {0, 3000000};

inline constexpr Number numbers[] = {
    {Number::integer, "threads", 1, 5, 1, nullptr, "threads that cross"},
    {Number::word, "field", 0, 1, 0, "vector|scalar", "vector: loops and deltas; scalar: no defects"},
    {Number::integer, "nodes", kNodes[0], kNodes[1], 64, nullptr, "cells of the grid: distance of the direction's nodes"},
    {Number::decimal, "bend", kBend[0], kBend[1], 1300000, nullptr, "turns: how far a scalar field turns either way"},
    {Number::integer, "window", 4, 8, 6, nullptr, "cells of the grid: radius of the masks"},
    {Number::decimal, "scale", bits::kScale[0], bits::kScale[1], 8000000, nullptr, "cells of the grid: nominal wavelength, .8 to 2.2 windows"},
    {Number::decimal, "stretch", bits::kStretch[0], bits::kStretch[1], 3000000, nullptr, "e, length along the stripes"},
    {Number::angles, "angle", -bits::kTurn, bits::kTurn, 0, nullptr, "degrees of each thread against the direction"},
    {Number::schedule, "rho", -bits::kLargestRho, bits::kLargestRho, 0, nullptr, "P: the threshold on the difference"},
};

constexpr bits::Living living(const int32_t* number) {
  return number[threads] == 1 ? bits::Living{-450000, 450000} : bits::Living{-120000, number[threads] == 2 ? 430000 : 390000};
}

constexpr bits::Living lengths(const int32_t* number) { return bits::lengths_of(number[radius]); }

constexpr bool in_range(const int32_t* number) {
  for (uint8_t j = 0; j < 5; ++j)
    if (!within(number[angles + j], -2 * bits::kTurn, 2 * bits::kTurn)) return false;
  return within(number[threads], 1, 5) && within(number[field], 0, 1) && within(number[nodes], kNodes[0], kNodes[1]) &&
         within(number[bend], kBend[0], kBend[1]) && within(number[radius], 4, 8) &&
         within(number[scale], lengths(number).low, lengths(number).high) &&
         within(number[stretch], bits::kStretch[0], bits::kStretch[1]) &&
         schedule_within(number + rho, living(number).low, living(number).high);
}

constexpr int32_t wavelength(const int32_t* number) { return number[scale] / 16 * 15; }
constexpr int16_t cell_level(const int32_t* number) {
  return static_cast<int16_t>(base::divide_round(static_cast<int64_t>(number[rho + 1]) * kUnit, base::kMicro));
}

// p: {-, rho in 1/kMicro of P}
constexpr void values(const int32_t* number, Clock clock, int32_t* p) { p[1] = scheduled(number + rho, clock); }

}  // namespace dapple::flow

namespace dapple {
inline constexpr Model flow_model DAPPLE_ROM = {
    grid::Cell::bit,  0,       flow::kUnit, 0,       flow::in_range, bits::planes, bits::tensor, bits::levels, flow::wavelength,
    flow::cell_level, flow::values, nullptr, nullptr, nullptr,       nullptr,      true};
}  // namespace dapple
