// One explicit step of diffusion: the classical five- and nine-point stencils (Witkin & Kass eq. 4, 7).
// SPDX-License-Identifier: MIT
#pragma once
#include "../grid/rows.hpp"

namespace dapple::stencil {

// Five points, int16 in int16 out, for kinetics in Q14. in: rows y-1, y, y+1 with a halo of one; out[0]: increments.
//   out = mulhi(l + r - 2c + k, w) + mulhi(u + d - 2c + k, w),   w even, 64..16384, k = rounding_for(w)
// p: {w, k}. Cells 0..16383: |l + r - 2c| <= 32766, and with k it fits int16 but where both neighbours are within k / 2 of
// 16383 and c is as near to 0; there it wraps, in every kernel alike. |out| <= 2 * 8192.
void five_row(const grid::Rows& rows);

// Nine points, exact sums in int32. in: rows y-1, y, y+1 with a halo of one; out[0]: int32 sums.
//   out = xx (l + r - 2c) + yy (u + d - 2c) + xy (ul + dr - ur - dl)
// p: {xx, yy, xy} Q16 (xy is already half the off-diagonal term; y points down, so ul and dr are +). Euler keeps
// 4 (xx + yy) <= 1.7 * 65536 and |xy| <= (xx + yy) / 4, so |out| <= 32000 * (27853 + 2 * 6963) = 1.4e9 < 2^31.
void nine_row(const grid::Rows& rows);

}  // namespace dapple::stencil
