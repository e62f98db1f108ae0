// Gray-Scott in one loop: stencil and reaction of lib/stencil/laplacian.cpp and lib/model/gray_scott.cpp, with no row
// of sums between them. Whatever else a kinetic step is made of goes the portable way.
// SPDX-License-Identifier: MIT
#pragma once

namespace dapple::evolve {

using base::mulhi;
using i16 = int16_t;

// fed: u = 1 and the rounding of what it is fed.
struct Rates {
  i16 u, u_rounding, v, v_rounding, feed, fed, drain, drain_rounding;
};
static Rates rates_of(const grid::Rows& rows) {
  const int32_t *t = rows.table, *p = rows.p;
  return {static_cast<i16>(t[0]), static_cast<i16>(t[1]), static_cast<i16>(t[3]),
          static_cast<i16>(t[4]), static_cast<i16>(p[0]), static_cast<i16>(gray_scott::kOne + p[1]),
          static_cast<i16>(p[2]), static_cast<i16>(p[3])};
}

// Formats and bounds are those of the two portable kernels.
static void gray_scott_cells(const i16* DAPPLE_RESTRICT uu, const i16* DAPPLE_RESTRICT ul, const i16* DAPPLE_RESTRICT u,
                             const i16* DAPPLE_RESTRICT ur, const i16* DAPPLE_RESTRICT ud,
                             const i16* DAPPLE_RESTRICT vu, const i16* DAPPLE_RESTRICT vl, const i16* DAPPLE_RESTRICT v,
                             const i16* DAPPLE_RESTRICT vr, const i16* DAPPLE_RESTRICT vd, i16* DAPPLE_RESTRICT out_u,
                             i16* DAPPLE_RESTRICT out_v, uint16_t n, Rates w) {
  for (uint16_t x = 0; x < n; ++x) {
    const i16 u2 = static_cast<i16>(2 * u[x]), v2 = static_cast<i16>(2 * v[x]);
    const i16 less_u = static_cast<i16>(w.u_rounding - u2), less_v = static_cast<i16>(w.v_rounding - v2);
    const i16 lap_u = static_cast<i16>(mulhi(static_cast<i16>(ul[x] + ur[x] + less_u), w.u) +
                                       mulhi(static_cast<i16>(uu[x] + ud[x] + less_u), w.u));
    const i16 lap_v = static_cast<i16>(mulhi(static_cast<i16>(vl[x] + vr[x] + less_v), w.v) +
                                       mulhi(static_cast<i16>(vu[x] + vd[x] + less_v), w.v));
    const i16 q = mulhi(v2, v2);
    const i16 z = mulhi(static_cast<i16>(2 * q + 2), u2);
    out_u[x] = static_cast<i16>(u[x] + lap_u - z + mulhi(static_cast<i16>(w.fed - u[x]), w.feed));
    out_v[x] = static_cast<i16>(v[x] + lap_v + z - mulhi(static_cast<i16>(v[x] + w.drain_rounding), w.drain));
  }
}

// The old rows come from the window; what the new ones are written to need not hold the old ones, as it must for
// narrow_row.
static void kinetic_row(const grid::Rows& rows) {
  const grid::RowKernel five = DAPPLE_OURS(DAPPLE_SET, stencil_five_row),
                        react = DAPPLE_OURS(DAPPLE_SET, gray_scott_react_row);
  if (rows.part[0] != five || rows.part[1] != react) {
    for (uint8_t i = 0; i < rows.planes; ++i) base::copy_bytes(rows.out[i], rows.in[3 * i + 1], size_t{2} * rows.n);
    return narrow_row(rows);
  }
  const i16 *u = grid::in16(rows, 1), *v = grid::in16(rows, 4);
  gray_scott_cells(grid::in16(rows, 0), u - 1, u, u + 1, grid::in16(rows, 2), grid::in16(rows, 3), v - 1, v, v + 1,
                   grid::in16(rows, 5), grid::out16(rows, 0), grid::out16(rows, 1), rows.n, rates_of(rows));
}

}  // namespace dapple::evolve
