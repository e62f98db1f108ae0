// Cells, rows of cells with halos, and the one signature every row kernel has.
// SPDX-License-Identifier: MIT
#pragma once
#include "../base/fixed.hpp"

namespace dapple::grid {

// What one cell of a plane is. bit: cell x is bit x mod 8 (least significant first) of byte x / 8 of its row.
enum class Cell : uint8_t { bit, int16, int32 };

constexpr uint8_t kMaxPlanes = 10;  // five activator-inhibitor pairs
constexpr uint8_t kMaxIn = 32;      // rows a kernel may read

constexpr size_t align4(size_t bytes) { return (bytes + 3) & ~static_cast<size_t>(3); }

// Bytes of a row of `width` cells in a plane; rows start at multiples of four bytes.
constexpr size_t row_bytes(Cell cell, uint16_t width) {
  return cell == Cell::bit ? align4((static_cast<size_t>(width) + 7) / 8)
                           : align4(static_cast<size_t>(width) * (cell == Cell::int16 ? 2 : 4));
}

// Bytes of the first `count` cells of a row, a multiple of 32. By a shift: run_band is one of those functions in which clang
// for AVR loses products (ports/avr/README.md).
constexpr size_t cell_bytes(Cell cell, uint16_t count) {
  return cell == Cell::bit ? count / 8u : static_cast<size_t>(count) << (cell == Cell::int16 ? 1 : 2);
}

// Bytes before cell 0 of a scratch row whose halo has `halo` cells on either side.
constexpr size_t halo_bytes(Cell cell, uint16_t halo) {
  return cell == Cell::bit ? (static_cast<size_t>(halo) + 7) / 8 : align4(static_cast<size_t>(halo) * (cell == Cell::int16 ? 2 : 4));
}

// Bytes of a scratch row: halo, cells, halo. Rows of bits follow each other without a gap.
constexpr size_t scratch_bytes(Cell cell, uint16_t width, uint16_t halo) {
  return cell == Cell::bit ? 2 * halo_bytes(cell, halo) + (static_cast<size_t>(width) + 7) / 8 : 2 * halo_bytes(cell, halo) + row_bytes(cell, width);
}

struct Rows;
using RowKernel = void (*)(const Rows&);

// The arguments of a row kernel. The kernel says in its comment which rows it reads and writes and what p holds.
// Rows point at cell 0; a row that comes from a window has its halo on both sides. No row overlaps another, but for
// in[i] == out[i] where the kernel says "in place".
struct Rows {
  const void* in[kMaxIn];
  void* out[kMaxPlanes];
  const int32_t* p;          // numbers of this step, in the kernel's own formats
  const int32_t* table;      // numbers a solver keeps over its steps, if any
  const RowKernel* part;     // kernels this one is made of, if any
  uint8_t* scratch;          // the solver's scratch memory
  uint16_t n;                // cells
  uint8_t planes;
  uint16_t x, y;             // of the first cell in its grid
  uint16_t run;              // rows this band has done without a break: 0 for the first row, or after a jump
};

inline const int16_t* in16(const Rows& r, uint8_t i) { return static_cast<const int16_t*>(r.in[i]); }
inline int16_t* out16(const Rows& r, uint8_t i) { return static_cast<int16_t*>(r.out[i]); }
inline const int32_t* in32(const Rows& r, uint8_t i) { return static_cast<const int32_t*>(r.in[i]); }
inline int32_t* out32(const Rows& r, uint8_t i) { return static_cast<int32_t*>(r.out[i]); }

// A kernel and a faster one with the same bytes. A list of these ends with {nullptr, nullptr}.
struct KernelSwap {
  RowKernel portable, fast;
};
RowKernel choose(const KernelSwap* swaps, RowKernel portable);

using base::copy_bytes;

// Copies `width` cells and wraps `halo` cells around on both sides, halo <= any size (cells repeat with period width).
void copy_row(Cell cell, void* to, const void* from, uint16_t width, uint16_t halo);

// Wraps the halo of a scratch row whose cells are in place already.
void wrap_row(Cell cell, void* row, uint16_t width, uint16_t halo);

inline bool get_bit(const uint8_t* row, int32_t x) { return (row[x >> 3] >> (x & 7)) & 1; }
inline void put_bit(uint8_t* row, int32_t x, bool on) {
  const uint8_t mask = static_cast<uint8_t>(1u << (x & 7));
  row[x >> 3] = static_cast<uint8_t>(on ? row[x >> 3] | mask : row[x >> 3] & ~mask);
}

}  // namespace dapple::grid
