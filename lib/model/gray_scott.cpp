// Gray-Scott, reaction of one row in Q14.
//   u' = u + Du lap u - u v^2 + F (1 - u),   v' = v + Dv lap v + u v^2 - (F + k) v
// q = mulhi(2v, 2v) is v^2 in Q12; z = mulhi(2q + 2, 2u) is u v^2 in Q14, the + 2 making up for the floors. v stays
// below .56 in every run (2q + 2 needs v < 1 to fit); u = 1, v = 0 is an exact fixed point.
// SPDX-License-Identifier: MIT
#include "gray_scott.hpp"

namespace dapple::gray_scott {

using base::mulhi;
using i16 = int16_t;

static void react(i16* DAPPLE_RESTRICT u, i16* DAPPLE_RESTRICT v, const i16* DAPPLE_RESTRICT du,
                  const i16* DAPPLE_RESTRICT dv, uint16_t n, i16 feed, i16 feed_rounding, i16 drain, i16 drain_rounding) {
  for (uint16_t x = 0; x < n; ++x) {
    const i16 v2 = static_cast<i16>(2 * v[x]), u2 = static_cast<i16>(2 * u[x]);
    const i16 q = mulhi(v2, v2);
    const i16 z = mulhi(static_cast<i16>(2 * q + 2), u2);
    u[x] = static_cast<i16>(u[x] + du[x] - z + mulhi(static_cast<i16>(kOne - u[x] + feed_rounding), feed));
    v[x] = static_cast<i16>(v[x] + dv[x] + z - mulhi(static_cast<i16>(v[x] + drain_rounding), drain));
  }
}

void react_row(const grid::Rows& rows) {
  const int32_t* p = rows.p;
  react(grid::out16(rows, 0), grid::out16(rows, 1), grid::in16(rows, 0), grid::in16(rows, 1), rows.n,
        static_cast<i16>(p[0]), static_cast<i16>(p[1]), static_cast<i16>(p[2]), static_cast<i16>(p[3]));
}

void field_row(const grid::Rows& rows) { grid::copy_bytes(rows.out[0], grid::in16(rows, 1) + rows.x, static_cast<size_t>(rows.n) * 2); }

}  // namespace dapple::gray_scott
