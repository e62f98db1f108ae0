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

constexpr Reach convolution_reach(const int32_t* number, bool kept) {
  const uint8_t r = static_cast<uint8_t>(number[bits::radius]);
  const uint8_t masks = summed(number) ? static_cast<uint8_t>(1) : static_cast<uint8_t>(number[bits::masks]);
  const uint16_t table = static_cast<uint16_t>((stencil::mask_set_bytes(masks, kept) + 3) / 4);
  return {1, r, r, 0, 0, 0, 1, r, table, r, r, kept ? stencil::kept_bytes(r, masks) : static_cast<uint8_t>(0)};
}
constexpr Reach sliced_reach(const Model&, const int32_t* number, uint8_t) { return convolution_reach(number, true); }
constexpr Reach lean_reach(const Model&, const int32_t* number, uint8_t) { return convolution_reach(number, false); }

bool sliced_next(const Context& context, Cursor& cursor, Sweep& sweep);
bool lean_next(const Context& context, Cursor& cursor, Sweep& sweep);
void prepare_sliced(const Context& context);
void prepare_lean(const Context& context);

// The wavelength these numbers grow, in 1/kMicro cells of the grid, within 4 %: .985 of the first mask's peak, which is what
// spectra of grown textures show. 0: shorter than 4.4 cells (isotropic: 5), where rounding leaves no telling.
int32_t grown_wavelength(const int32_t* number);
int32_t grown_of(const stencil::MaskShape& shape);

inline constexpr Solver sliced DAPPLE_ROM = {sliced_reach, sliced_next, prepare_sliced, stencil::field_row};
inline constexpr Solver lean DAPPLE_ROM = {lean_reach, lean_next, prepare_lean, stencil::field_row};

}  // namespace dapple::evolve
