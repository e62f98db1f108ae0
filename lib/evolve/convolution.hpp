// Binary convolution as solvers: one sweep a step, with kept copies of rows (`sliced`) or in the least memory (`lean`).
// SPDX-License-Identifier: MIT
#pragma once
#include "../model/bits.hpp"
#include "../stencil/convolve.hpp"
#include "solver.hpp"

namespace dapple::evolve {

// Difference-abs of two orientations is one mask, the sum of both.
constexpr bool summed(const int32_t* number) {
  return number[bits::masks] == 2 && number[bits::react] == stencil::difference_abs;
}

constexpr uint8_t shapes_of(const int32_t* number, stencil::MaskShape* shapes) {
  const uint8_t count = static_cast<uint8_t>(number[bits::masks]);
  for (uint8_t i = 0; i < count; ++i)
    shapes[i] = {static_cast<uint8_t>(number[bits::radius]), number[bits::diffusion] == bits::isotropic, number[bits::scale],
                 number[bits::stretch], base::angle_of(number[bits::angles + i])};
  return count;
}

// The masks of these numbers, set.count of them (one for two orientations summed); false where one cannot be made.
constexpr bool make_stored(const int32_t* number, stencil::StoredSet& set, stencil::Taps* taps) {
  stencil::MaskShape shapes[stencil::kMaxMasks] = {};
  const uint8_t count = shapes_of(number, shapes);
  const bool sums = summed(number);
  set = {sums ? uint8_t{1} : count, shapes[0].radius, 0};
  for (uint8_t i = 0; i < set.count; ++i) {
    stencil::Mask mask{};
    if (!stencil::make_mask(shapes + i, sums ? count : uint8_t{1}, mask)) return false;
    if (i == 0) set.sum = mask.sum;
    const uint8_t side = static_cast<uint8_t>(2 * mask.radius + 1);
    if (!stencil::make_taps(mask.weight, side, side, taps[i])) return false;
  }
  return true;
}

// The same for n of them; a set of no masks when n is another number.
template <uint8_t n> constexpr stencil::StoredMasks<n> stored_masks(const int32_t* number) {
  stencil::StoredMasks<n> result{};
  const uint8_t count = summed(number) ? uint8_t{1} : static_cast<uint8_t>(number[bits::masks]);
  return count == n && make_stored(number, result.set, result.taps) ? result : stencil::StoredMasks<n>{};
}

constexpr Reach convolution_reach(const int32_t* number, bool kept) {
  const uint8_t r = static_cast<uint8_t>(number[bits::radius]);
  const uint8_t masks = summed(number) ? static_cast<uint8_t>(1) : static_cast<uint8_t>(number[bits::masks]);
  const uint16_t table = static_cast<uint16_t>((stencil::mask_set_bytes(masks, kept) + 3) / 4);
  return {1, r, r, 0, 0, 0, 1, r, table, r, r, kept ? stencil::kept_bytes(r, masks) : static_cast<uint8_t>(0),
          stencil::copies_space(r)};
}
constexpr Reach sliced_reach(const Model&, const int32_t* number, uint8_t, const void*) { return convolution_reach(number, true); }
constexpr Reach lean_reach(const Model&, const int32_t* number, uint8_t, const void*) { return convolution_reach(number, false); }

bool sliced_next(const Context& context, Cursor& cursor, Sweep& sweep);
bool lean_next(const Context& context, Cursor& cursor, Sweep& sweep);
void prepare_sliced(const Context& context);
void prepare_lean(const Context& context);

// The wavelength these numbers grow, in 1/kMicro cells of the grid, within 4 %: .985 of the first mask's peak (isotropic:
// .965 at 5.5 cells, rising to 1 at 10.3), which is what
// spectra of grown textures show. 0: shorter than 4.4 cells (isotropic: 5.8), where rounding leaves no telling.
int32_t grown_wavelength(const int32_t* number);
int32_t grown_of(const stencil::MaskShape& shape);

// Masks the compiler has made: Stage::stored is the place of them. Nothing but it is kept in memory.
constexpr Reach stored_reach(const Model&, const int32_t* number, uint8_t, const void*) {
  Reach reach = convolution_reach(number, false);
  reach.table = sizeof(const void*) > 4 ? 2 : 1;
  return reach;
}
bool stored_next(const Context& context, Cursor& cursor, Sweep& sweep);
void prepare_stored(const Context& context);
inline constexpr Solver stored DAPPLE_ROM = {stored_reach, stored_next, prepare_stored, stencil::field_stored};

inline constexpr Solver sliced DAPPLE_ROM = {sliced_reach, sliced_next, prepare_sliced, stencil::field_row};
inline constexpr Solver lean DAPPLE_ROM = {lean_reach, lean_next, prepare_lean, stencil::field_row};

}  // namespace dapple::evolve
