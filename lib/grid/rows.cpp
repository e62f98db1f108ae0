// Copies of rows with wrapped halos: halos live here, in scratch rows, never in the planes.
// SPDX-License-Identifier: MIT
#include "rows.hpp"

namespace dapple::grid {

RowKernel choose(const KernelSwap* swaps, RowKernel portable) {
  for (; swaps != nullptr && swaps->portable != nullptr; ++swaps)
    if (swaps->portable == portable) return swaps->fast;
  return portable;
}

// A halo wider than the row goes on with cells of the halo, which are there by then.
template <class T> static void wrap_cells(T* row, uint16_t width, uint16_t halo) {
  for (uint16_t i = 0; i < halo; ++i) {
    row[static_cast<size_t>(width) + i] = row[i];
    row[-1 - static_cast<ptrdiff_t>(i)] = row[static_cast<ptrdiff_t>(width) - 1 - i];
  }
}

// At most 8 cells at `at` >= 0 as the low bits of a byte. Reads one byte past the one that holds the last cell.
static uint8_t bits_at(const uint8_t* row, int32_t at) {
  const uint16_t pair = static_cast<uint16_t>(row[at >> 3] | (static_cast<uint16_t>(row[(at >> 3) + 1]) << 8));
  return static_cast<uint8_t>(pair >> (at & 7));
}

// Up to eight cells either side of a row at least that wide: what masks and cell programs need.
static void wrap_eight(uint8_t* row, uint16_t width, uint8_t halo) {
  const uint8_t last = bits_at(row, static_cast<int32_t>(width) - 8);
  const uint8_t first = row[0];
  const uint8_t used = static_cast<uint8_t>(width & 7);
  uint8_t* const end = row + (width >> 3);
  end[0] = static_cast<uint8_t>((end[0] & ((1u << used) - 1u)) | (static_cast<uint32_t>(first) << used));
  if (used + halo > 8) end[1] = static_cast<uint8_t>(first >> (8 - used));
  row[-1] = last;
}

static void wrap_bits(uint8_t* row, uint16_t width, uint16_t halo) {
  if (halo == 0) return;
  if (halo <= 8 && width >= 8) return wrap_eight(row, width, static_cast<uint8_t>(halo));
  for (uint16_t i = 0; i < halo; ++i) {
    put_bit(row, static_cast<int32_t>(width) + i, get_bit(row, i));
    put_bit(row, -1 - static_cast<int32_t>(i), get_bit(row, static_cast<int32_t>(width) - 1 - i));
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
  copy_bytes(to, from, cell == Cell::bit ? (static_cast<size_t>(width) + 7) / 8 : row_bytes(cell, width));
  wrap_row(cell, to, width, halo);
}

}  // namespace dapple::grid
