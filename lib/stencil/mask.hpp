// Masks of binary convolution: a difference of two Gaussians in small integers that sum to exactly zero.
// When dissipation dominates, the threshold family becomes R' = [K * R > rho] on one bit a cell (Witkin & Kass 5.3; Young
// 1984). K needs no more than radius 8, weights within +-7 and a positive sum P <= 127, so |K * R| <= P fits int8.
// SPDX-License-Identifier: MIT
#pragma once
#include "../base/math.hpp"
#include "../grid/rows.hpp"

namespace dapple::stencil {

constexpr uint8_t kSmallestMask = 4, kLargestMask = 8;  // radius, cells
constexpr uint8_t kLargestSide = 2 * kLargestMask + 1;
constexpr uint16_t kCells = kLargestSide * kLargestSide;
constexpr uint16_t kLargestSum = 127;                   // P
constexpr uint8_t kLargestWeight = 7, kLargestSummed = 15;  // of one mask, and of one that is the sum of two
constexpr uint8_t kMaxMasks = 5;

// What a mask is made from. u runs along the angle, v across it; s = .18129 wavelength is the sigma across that makes the
// difference of Gaussians with sigmas s and 1.5 s peak at `wavelength`.
//   P = exp(-u^2 / 2 (stretch s)^2 - v^2 / 2 s^2),  N = the same with 1.5 s across;  K ~ P / sum P - N / sum N
// over the square of the radius. isotropic: stretch 1, N with 1.5 s in both directions, over the disc x^2 + y^2 <= (r + 1/2)^2.
struct MaskShape {
  uint8_t radius;
  bool isotropic;
  int32_t wavelength, stretch;  // cells and 1, in 1/kMicro
  uint16_t angle;
};

// Row-major, (2 radius + 1)^2 weights used.
struct Mask {
  uint8_t radius;
  int16_t sum;  // P, of the positive weights
  int8_t weight[kLargestSide * kLargestSide];
};

// The mask of one shape, or of the sum of two (difference-abs of two orientations: max + min = D_1 + D_2). Weights are
// scaled by the largest factor, in tenths, that keeps every weight within kLargestWeight (of two: kLargestSummed) and P
// within kLargestSum after the sum has been made zero: by point-symmetric pairs where rounding was worst, the odd unit at
// the centre; isotropic masks by whole orbits of the square's symmetries. false: no factor does.
constexpr bool make_mask(const MaskShape* shapes, uint8_t count, Mask& mask);

// The wavelength, in 1/kMicro cells, at which the transfer function of a mask made from `shape` peaks.
int32_t peak_wavelength(const Mask& mask, const MaskShape& shape);

// The parts of it: adds factor (Q15) times K of a shape, Q30, to kernel[], row-major, with several factors to as many
// kernels so far apart; rounds exact weights in Q8 (false: P or a weight beyond its limit).
constexpr void add_kernel(const MaskShape& shape, int16_t factor, int32_t* kernel);
constexpr void add_kernels(const MaskShape& shape, const int16_t* factor, uint8_t count, int32_t* kernel, uint16_t apart);
constexpr bool round_mask(const int16_t* scaled, bool isotropic, uint8_t limit, Mask& mask);

// Weights as lists of unit taps, one for every sign and binary place: what bit-sliced evaluation eats. A tap is the index
// row * (2 radius + 1) + column; sum |weight| <= 2 * kLargestSum bounds their number.
constexpr uint8_t kPlaces = 4;
constexpr uint16_t kMaxTaps = 2 * kLargestSum;
struct Taps {
  uint8_t count[2][kPlaces];  // [negative][place]
  uint16_t index[kMaxTaps];   // in that order
};

// Lists of `rows` rows of weights; false when there are more than kMaxTaps or a weight takes more than four places.
constexpr bool make_taps(const int8_t* weight, uint8_t rows, uint8_t side, Taps& taps);
constexpr uint16_t count_of(const Taps& taps);

// What stands before stored taps.
struct StoredSet {
  uint8_t count, radius;
  int16_t sum;
};

// The masks of a stage, in the solver's table.
struct MaskSet {
  uint8_t count, radius;
  bool running;            // `change` is there and shorter: D(y + 1) = D(y) + change * R
  int16_t sum;             // P of the first mask: the unit of rho and of the field
  Taps whole[1];           // count of them, then as many of `change`
};
constexpr const Taps& whole_of(const MaskSet& set, uint8_t i) { return set.whole[i]; }
constexpr const Taps& change_of(const MaskSet& set, uint8_t i) { return set.whole[set.count + i]; }
constexpr size_t mask_set_bytes(uint8_t masks, bool running) {
  return sizeof(MaskSet) + sizeof(Taps) * (static_cast<size_t>(masks) * (running ? 2 : 1) - 1);
}

// Fills `set` (mask_set_bytes) with `count` masks; with `running`, also the vertical differences where all of them pay.
// false: a mask cannot be made.
constexpr bool make_masks(const MaskShape* shapes, uint8_t count, bool summed, bool running, MaskSet& set);

constexpr bool make_set(const Mask* masks, uint8_t count, bool running, MaskSet& set);

// Masks made by the compiler, to be put in read-only memory (DAPPLE_ROM).
template <uint8_t n> struct StoredMasks {
  StoredSet set;
  Taps taps[n];
};

// The weights of a mask back from its taps; those of mask i.
constexpr void weights_of(const Taps& whole, uint8_t radius, int8_t* weight);
constexpr void weights_of(const MaskSet& set, uint8_t i, int8_t* weight) { weights_of(whole_of(set, i), set.radius, weight); }

}  // namespace dapple::stencil

#include "mask_make.hpp"
