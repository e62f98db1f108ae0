// Steps of binary convolution. See convolution.hpp.
// SPDX-License-Identifier: MIT
#include "convolution.hpp"

namespace dapple::evolve {

int32_t grown_of(const stencil::MaskShape& shape) {
  stencil::Mask mask;
  if (!stencil::make_mask(&shape, 1, mask)) return 0;
  const int32_t peak = stencil::peak_wavelength(mask, shape);
  const int32_t share = shape.isotropic ? base::clamp(965 + (peak / 1000 - 5500) * 33 / 4500, 960, 1000) : 985;  // in 1/1000
  const int32_t grown = static_cast<int32_t>(static_cast<int64_t>(peak) * share / 1000);
  return grown < (shape.isotropic ? 5800000 : 4400000) ? 0 : grown;
}

int32_t grown_wavelength(const int32_t* number) {
  return grown_of({static_cast<uint8_t>(number[bits::radius]), number[bits::diffusion] == bits::isotropic, number[bits::scale],
                   number[bits::stretch], base::angle_of(number[bits::angles])});
}

static void prepare(const Context& context, bool running) {
  const int32_t* number = context.number;
  stencil::MaskShape shapes[stencil::kMaxMasks];
  const uint8_t count = shapes_of(number, shapes);
  stencil::make_masks(shapes, count, summed(number), running, *reinterpret_cast<stencil::MaskSet*>(context.table));
}

void prepare_sliced(const Context& context) { prepare(context, true); }
void prepare_lean(const Context& context) { prepare(context, false); }

void prepare_stored(const Context& context) { base::copy_bytes(context.table, &context.stored, sizeof context.stored); }

static bool next(const Context& context, Cursor& cursor, grid::RowKernel row, Sweep& sweep) {
  if (cursor.sweep++ != 0) return false;
  window_sweep(context, static_cast<uint8_t>(context.number[bits::radius]), row, sweep);
  return true;
}

bool sliced_next(const Context& context, Cursor& cursor, Sweep& sweep) { return next(context, cursor, stencil::convolve_row, sweep); }
bool lean_next(const Context& context, Cursor& cursor, Sweep& sweep) { return next(context, cursor, stencil::convolve_lean, sweep); }

bool stored_next(const Context& context, Cursor& cursor, Sweep& sweep) { return next(context, cursor, stencil::convolve_stored, sweep); }

}  // namespace dapple::evolve
