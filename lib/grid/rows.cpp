// Copies of rows with wrapped halos: halos live here, in scratch rows, never in the planes.
// SPDX-License-Identifier: MIT
#include "rows.hpp"

namespace dapple::grid {

RowKernel choose(const KernelSwap* swaps, RowKernel portable) {
  for (; swaps != nullptr && swaps->portable != nullptr; ++swaps)
    if (swaps->portable == portable) return swaps->fast;
  return portable;
}

template <class T> static void wrap_cells(T* row, uint16_t width, uint16_t halo) {
  if (halo <= width) {
    for (uint16_t i = 0; i < halo; ++i) {
      row[static_cast<size_t>(width) + i] = row[i];
      row[-1 - static_cast<ptrdiff_t>(i)] = row[static_cast<size_t>(width) - 1 - i];
    }
    return;
  }
  uint16_t source = 0;
  for (uint16_t i = 0; i < halo; ++i) {
    row[static_cast<size_t>(width) + i] = row[source];
    if (++source == width) source = 0;
  }
  source = static_cast<uint16_t>(width - 1);
  for (uint16_t i = 1; i <= halo; ++i) {
    row[-static_cast<ptrdiff_t>(i)] = row[source];
    source = static_cast<uint16_t>(source == 0 ? width - 1 : source - 1);
  }
}

static void wrap_bits(uint8_t* row, uint16_t width, uint16_t halo) {
  for (uint16_t i = 0; i < halo; ++i) {
    const int32_t right = static_cast<int32_t>(i) % width;
    put_bit(row, static_cast<int32_t>(width) + i, get_bit(row, right));
    put_bit(row, -1 - static_cast<int32_t>(i), get_bit(row, static_cast<int32_t>(width) - 1 - right));
  }
}

void wrap_row(Cell cell, void* row, uint16_t width, uint16_t halo) {
  switch (cell) {
    case Cell::bit: wrap_bits(static_cast<uint8_t*>(row), width, halo); break;
    case Cell::int16: wrap_cells(static_cast<int16_t*>(row), width, halo); break;
    case Cell::int32: wrap_cells(static_cast<int32_t*>(row), width, halo); break;
  }
}

void copy_row(Cell cell, void* to, const void* from, uint16_t width, uint16_t halo) {
  copy_bytes(to, from, row_bytes(cell, width));
  wrap_row(cell, to, width, halo);
}

}  // namespace dapple::grid
