// The three-point pass, the only thing the macro steps of the threshold family do to a plane besides reacting.
// Portable definition; see lattice.hpp for formats and docs/numbers.md for the proof.
// SPDX-License-Identifier: MIT
#include "lattice.hpp"

namespace dapple::stencil {

using base::mulhi;

// (l + r + 2c + rounding) >> 2 == c + (((l + r - 2c + rounding) * 16384) >> 16); the sum is at most 64002 < 2^16.
static void quarter(const int16_t* DAPPLE_RESTRICT l, const int16_t* DAPPLE_RESTRICT c, const int16_t* DAPPLE_RESTRICT r,
                    int16_t* DAPPLE_RESTRICT out, uint16_t n, int16_t rounding) {
  for (uint16_t x = 0; x < n; ++x)
    out[x] = static_cast<int16_t>(
        static_cast<uint16_t>(static_cast<uint16_t>(l[x]) + static_cast<uint16_t>(r[x]) +
                              2u * static_cast<uint16_t>(c[x]) + static_cast<uint16_t>(rounding)) >> 2);
}

static void weighted(const int16_t* DAPPLE_RESTRICT l, const int16_t* DAPPLE_RESTRICT c, const int16_t* DAPPLE_RESTRICT r,
                     int16_t* DAPPLE_RESTRICT out, uint16_t n, int16_t weight, int16_t rounding) {
  for (uint16_t x = 0; x < n; ++x) {
    const int16_t d = static_cast<int16_t>(l[x] + r[x] - 2 * c[x] + rounding);
    out[x] = static_cast<int16_t>(c[x] + mulhi(d, weight));
  }
}

static void three_point(const int16_t* l, const int16_t* c, const int16_t* r, int16_t* out, uint16_t n, int16_t weight,
                        int16_t rounding) {
  if (weight == kQuarter)
    quarter(l, c, r, out, n, rounding);
  else
    weighted(l, c, r, out, n, weight, rounding);
}

void pass_row_by(const grid::Rows& rows, ThreePoint three_point) {
  const int32_t* p = rows.p;
  three_point(grid::in16(rows, 0) - p[0], grid::in16(rows, 1), grid::in16(rows, 2) + p[0], grid::out16(rows, 0), rows.n,
              static_cast<int16_t>(p[1]), static_cast<int16_t>(p[2]));
}

void chain_row_by(const grid::Rows& rows, ThreePoint three_point) {
  using grid::Cell;
  const uint16_t halo = static_cast<uint16_t>(rows.p[1]);
  const size_t before = grid::halo_bytes(Cell::int16, halo);
  uint8_t* other = rows.scratch + grid::scratch_bytes(Cell::int16, rows.n, halo);
  int16_t* from = reinterpret_cast<int16_t*>(rows.scratch + before);
  int16_t* to = reinterpret_cast<int16_t*>(other + before);
  PassSeries series = series_of(rows.p[0], 0, rows.p[2]);
  Pass pass{}, next{};
  if (!next_pass(series, pass)) return;
  grid::copy_row(Cell::int16, from, rows.out[0], rows.n, halo);
  for (bool more = true; more; pass = next) {
    more = next_pass(series, next);
    int16_t* target = more ? to : grid::out16(rows, 0);
    three_point(from - pass.stride, from, from + pass.stride, target, rows.n, pass.weight, pass.rounding);
    if (!more) break;
    grid::wrap_row(Cell::int16, to, rows.n, halo);
    int16_t* swap = from;
    from = to;
    to = swap;
  }
}

void pass_row(const grid::Rows& rows) { pass_row_by(rows, three_point); }
void chain_row(const grid::Rows& rows) { chain_row_by(rows, three_point); }

}  // namespace dapple::stencil
