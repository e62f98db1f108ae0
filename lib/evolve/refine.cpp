// Coarse to fine, bottom row first: fine rows 2 y and 2 y + 1 never reach down to coarse row y - 2, so a ring of three
// coarse rows and the saved last one are all that is needed.
// SPDX-License-Identifier: MIT
#include "refine.hpp"

namespace dapple::evolve {

// Sums of int32 cells need 36 bits, those of int16 cells 20.
template <class T, class Sum> static void blend(const T* near, const T* other, T* out, uint16_t n) {
  for (int32_t x = 0; x < n; ++x) {
    const Sum middle = static_cast<Sum>(9) * near[x] + static_cast<Sum>(3) * other[x] + 8;
    out[2 * x] = static_cast<T>((middle + static_cast<Sum>(3) * near[x - 1] + other[x - 1]) >> 4);
    out[2 * x + 1] = static_cast<T>((middle + static_cast<Sum>(3) * near[x + 1] + other[x + 1]) >> 4);
  }
}

static void blend_row(grid::Cell cell, const uint8_t* near, const uint8_t* other, uint8_t* out, uint16_t n) {
  if (cell == grid::Cell::int16)
    blend<int16_t, int32_t>(reinterpret_cast<const int16_t*>(near), reinterpret_cast<const int16_t*>(other),
                            reinterpret_cast<int16_t*>(out), n);
  else
    blend<int32_t, int64_t>(reinterpret_cast<const int32_t*>(near), reinterpret_cast<const int32_t*>(other),
                            reinterpret_cast<int32_t*>(out), n);
}

void refine_row(const Field& coarse, uint8_t plane, uint16_t y) {
  const size_t stride = grid::scratch_bytes(coarse.cell, coarse.width, 1);
  uint8_t* const base = coarse.scratch + 4 * plane * stride + grid::halo_bytes(coarse.cell, 1);
  const auto ring = [&](int32_t row) { return base + static_cast<size_t>(row % 3) * stride; };
  uint8_t* const last = base + 3 * stride;
  const uint16_t height = coarse.height;
  const auto load = [&](uint8_t* to, uint16_t row) { grid::copy_row(coarse.cell, to, row_of(coarse, plane, row), coarse.width, 1); };
  // The ring holds rows y + 1, y, y - 1 in slots of their number mod 3; at the ends the wrapped row takes the free slot.
  if (y + 1 == height) {
    load(last, y);
    load(ring(y), y);
    load(ring(y + 1), 0);
  }
  uint8_t* const above = y == 0 ? last : ring(y - 1);
  if (y > 0) load(above, static_cast<uint16_t>(y - 1));
  const size_t fine_row = grid::row_bytes(coarse.cell, static_cast<uint16_t>(2 * coarse.width));
  uint8_t* const out = coarse.planes + plane * coarse.plane_bytes + 2 * static_cast<size_t>(y) * fine_row;
  blend_row(coarse.cell, ring(y), above, out, coarse.width);
  blend_row(coarse.cell, ring(y), ring(y + 1), out + fine_row, coarse.width);
}

}  // namespace dapple::evolve
