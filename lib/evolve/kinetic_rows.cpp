// Rows of the steps of explicit kinetics. See kinetics.hpp.
// SPDX-License-Identifier: MIT
#include "kinetics.hpp"

#include "../base/hash.hpp"
#include "../start/start.hpp"

namespace dapple::evolve {

constexpr uint32_t kDitherStream = 161;  // of the hash

// Compact cells in the format of steps, and sums of them: |sum| < 2^18, cut <= 9.
static void widen(const int16_t* DAPPLE_RESTRICT from, int32_t* DAPPLE_RESTRICT to, uint16_t n, int32_t unit) {
  for (uint16_t x = 0; x < n; ++x) to[x] = from[x] * unit;
}
static void scale(int32_t* sums, uint16_t n, int32_t unit) {
  for (uint16_t x = 0; x < n; ++x) sums[x] *= unit;
}

// Two morphogens, 0..20 in Q20, back to int16: rounded up where what is cut off is more than a random number, half a
// hash each.
static void dither(const int32_t* DAPPLE_RESTRICT a, const int32_t* DAPPLE_RESTRICT b, int16_t* DAPPLE_RESTRICT to_a,
                   int16_t* DAPPLE_RESTRICT to_b, uint16_t n, base::RowKey key, int32_t at, uint8_t cut) {
  const int32_t mask = (INT32_C(1) << cut) - 1;
  for (int32_t x = 0; x < n; ++x) {
    const uint32_t h = base::hash(key, at + x);
    to_a[x] = static_cast<int16_t>(
        base::min((a[x] + static_cast<int32_t>(h & static_cast<uint32_t>(mask))) >> cut, INT32_C(32767)));
    to_b[x] = static_cast<int16_t>(base::min((b[x] + (static_cast<int32_t>(h >> 16) & mask)) >> cut, INT32_C(32767)));
  }
}

// The same for a row, where it is in the world: windows of the plane agree. A torus that is rolled has an edge in it.
static void narrow_row(const grid::Rows& rows, const int32_t* a, const int32_t* b) {
  const int32_t* t = rows.table;
  const uint16_t width = static_cast<uint16_t>(t[ring_x]), height = static_cast<uint16_t>(t[ring_y]);
  const bool plane = t[on_plane] != 0;
  const uint32_t seed = static_cast<uint32_t>(t[seed_of]) ^ base::mix(static_cast<uint32_t>(rows.p[kStepOf]) + 1);
  const base::RowKey key = base::row_key(seed, kDitherStream, start::world(t[origin_y] + rows.y, height, plane));
  int32_t at = start::world(t[origin_x] + rows.x, width, plane);
  for (uint16_t x = 0, count; x < rows.n; x = static_cast<uint16_t>(x + count), at = 0) {
    const int32_t left = width - at;
    count = static_cast<uint16_t>(rows.n - x);
    if (!plane && left < count) count = static_cast<uint16_t>(left);
    dither(a + x, b + x, grid::out16(rows, 0) + x, grid::out16(rows, 1) + x, count, key, at,
           static_cast<uint8_t>(t[cut_bits]));
  }
}

// The deviations of a row in the format of steps: as they are kept, widened, or zeros.
static const void* deviations(const grid::Rows& rows, int32_t* row) {
  const uint8_t planes = kept_at(rows);
  const bool compact = rows.table[cut_bits] != 0;
  if (rows.table[has_rates] != 0 && !compact) return rows.out[planes];
  if (rows.table[has_rates] != 0) widen(grid::out16(rows, planes), row, rows.n, kVaryCut);
  else
    for (uint16_t x = 0; x < rows.n; ++x) row[x] = 0;
  return row;
}

void kinetics_row(const grid::Rows& rows) {
  const size_t row_bytes = grid::row_bytes(grid::Cell::int32, rows.n);
  const uint8_t planes = kept_at(rows);
  const int32_t unit = INT32_C(1) << rows.table[cut_bits];
  const void* const shares = rows.in[3 * (rows.planes - 1) + 1];
  grid::Rows stencil = rows, react = rows;
  for (uint8_t plane = 0; plane < planes; ++plane) {
    for (uint8_t k = 0; k < 3; ++k) stencil.in[k] = rows.in[3 * plane + k];
    stencil.out[0] = rows.scratch + plane * row_bytes;
    rows.part[0](stencil);
    if (rows.table[graded] != 0) stencil::share_sums(grid::out32(stencil, 0), shares, rows.table[wide_cells] != 0, rows.n);
    react.in[plane] = stencil.out[0];
    if (unit > 1) scale(grid::out32(stencil, 0), rows.n, unit);
  }
  react.in[planes] = deviations(rows, reinterpret_cast<int32_t*>(rows.scratch + planes * row_bytes));
  react.scratch = rows.scratch + (planes + 1u) * row_bytes;
  for (uint8_t plane = 0; plane < planes && unit > 1; ++plane, react.scratch += row_bytes) {
    react.out[plane] = react.scratch;
    widen(grid::out16(rows, plane), grid::out32(react, plane), rows.n, unit);
  }
  rows.part[1](react);
  if (unit > 1) narrow_row(rows, grid::out32(react, 0), grid::out32(react, 1));
}

// mask: all ones where the cell is held. Byte by byte, whatever the cells.
static void hold(const uint8_t* DAPPLE_RESTRICT old, const uint8_t* DAPPLE_RESTRICT mask,
                 uint8_t* DAPPLE_RESTRICT cells, size_t bytes) {
  for (size_t i = 0; i < bytes; ++i) cells[i] = static_cast<uint8_t>(cells[i] ^ ((cells[i] ^ old[i]) & mask[i]));
}
void hold_row(const grid::Rows& rows) {
  const size_t bytes = static_cast<size_t>(rows.n) * (rows.table[wide_cells] != 0 ? 4 : 2);
  const uint8_t* const mask = static_cast<const uint8_t*>(rows.out[held_at(rows)]);
  for (uint8_t plane = 0; plane < kept_at(rows); ++plane)
    hold(static_cast<const uint8_t*>(rows.in[3 * plane + 1]), mask, static_cast<uint8_t*>(rows.out[plane]), bytes);
}

void cascade_row(const grid::Rows& rows) {
  kinetics_row(rows);
  hold_row(rows);
}

}  // namespace dapple::evolve
