// The threshold family along a map of directions [Witkin & Kass 1991, 3.1]: the numbers of threshold.hpp in the same
// slots, but that the slot of `diffusion` names the map and one more slot says how large its features are. Same
// kernels.
// SPDX-License-Identifier: MIT
#pragma once
#include "threshold.hpp"

namespace dapple::mapped {

using namespace threshold;

constexpr uint8_t map = diffusion, detail = threshold::slots;
static_assert(detail + 1 <= kMaxNumbers, "one slot more than the family's own");

enum Kind : uint8_t { none, radial, scallop, haunch, two_angle, swirl, bends, corners, image, isotropic_pairs, kinds };

constexpr int32_t kMostPairs = 4;
constexpr int32_t kDetail[2] = {10000, 1000000};

constexpr const char* kMaps = "none|radial|scallop|haunch|two-angle|swirl|bends|corners|image|isotropic";
constexpr int32_t kDetailStandard = 250000;
constexpr const char* kDetailUnit =
    "of the tile's width: softness of a radial centre, width of a scallop, distance of a swirl's nodes; corners: of 90 "
    "degrees";

inline constexpr Number numbers[] = {
    {Number::integer, "pairs", 1, kMostPairs, 1, nullptr, "activator-inhibitor pairs"},
    {Number::word, "react", 0, 1, 0, "md|da", "md: max of differences (14); da: difference of abs (15)"},
    {Number::word, "map", 0, kinds - 1, radial, kMaps,
     "direction of every place of the tile; isotropic: none, whatever stretch says"},
    threshold::numbers[3],
    threshold::numbers[4],
    threshold::numbers[5],
    {Number::angles, "angle", -kTurn, kTurn, 0, nullptr, "degrees of each pair against the map's direction"},
    threshold::numbers[7],
    threshold::numbers[8],
    {Number::decimal, "detail", kDetail[0], kDetail[1], kDetailStandard, nullptr, kDetailUnit},
};

constexpr bool in_range(const int32_t* number) {
  return within(number[map], 0, kinds - 1) && within(number[detail], kDetail[0], kDetail[1]) &&
         shared_in_range(number, kMostPairs);
}

// With e1 along x: the map turns it.
constexpr grid::Tensor tensor(const int32_t* number, uint8_t plane) { return axes_of(number, plane, number[map] == isotropic_pairs); }

}  // namespace dapple::mapped

namespace dapple {
inline constexpr Model mapped_model DAPPLE_ROM = {grid::Cell::int16,     0,
                                                  threshold::kUnit,      2,
                                                  mapped::in_range,      threshold::planes,
                                                  mapped::tensor,        threshold::levels,
                                                  threshold::wavelength, threshold::cell_level,
                                                  threshold::values,     threshold::impulse_row,
                                                  threshold::react_row,  nullptr,
                                                  threshold::field_row,  false,
                                                  unbounded,             threshold::decided_row};
}  // namespace dapple
