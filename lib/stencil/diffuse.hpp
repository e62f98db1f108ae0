// What diffusion sees of a cell's neighbours: five points, or eight neighbours with weights that are never negative,
// for kinetics.
// SPDX-License-Identifier: MIT
#pragma once
#include "../base/math.hpp"
#include "../grid/rows.hpp"

namespace dapple::stencil {

// in: rows y - 1, y, y + 1 with a halo of one; out[0]: int32 sums in the format of the cells.
//   five:   l + r + u + d - 4 c, exactly. |cells| <= 20 in Q20: |sum| <= 160 * 2^20 < 2^28; int16: < 2^18
void five_wide_row(const grid::Rows& rows);
void five_narrow_row(const grid::Rows& rows);
//   eight:  (x (l + r - 2c) + y (u + d - 2c) + fall (ul + dr - 2c) + rise (dl + ur - 2c)) / 2^10
// table: {x, y, fall, rise} Q10, at least 0, their sum at most 2^11. int32: pairs are rounded to Q14 first, 40 * 2^14 *
// 2^11 < 2^31; int16: pairs < 2^17, products and their sum < 2^28. Rounded to the format of the cells.
void eight_wide_row(const grid::Rows& rows);
void eight_narrow_row(const grid::Rows& rows);

// The weights of D = R diag(1, 1 / stretch^2) R^T, R a turn by the angle (x right, y down): Dxx - |Dxy|, Dyy - |Dxy|,
// and |Dxy| for the diagonal it runs along. None is negative while stretch^2 <= (1 + sqrt 2)^2; what rounding leaves
// below 0 is held there.
struct EightWeights {
  int32_t x, y, fall, rise;
};
constexpr EightWeights eight_weights(int32_t stretch, int32_t angle) {  // 1/kMicro, degrees
  const uint16_t theta = base::angle_of(angle);
  const int64_t c = base::cosine(theta), s = base::sine(theta);
  const int64_t across = (INT64_C(1) << 20) * base::kMicro / stretch * base::kMicro / stretch;  // Q20
  const int64_t one = INT64_C(32767) * 32767 * 1024, along = INT64_C(1) << 20;
  const int32_t xx = static_cast<int32_t>(base::divide_round(c * c * along + s * s * across, one));
  const int32_t yy = static_cast<int32_t>(base::divide_round(s * s * along + c * c * across, one));
  const int32_t xy = static_cast<int32_t>(base::divide_round(c * s * (along - across), one));
  const int32_t beside = xy < 0 ? -xy : xy;
  return {base::max(xx - beside, 0), base::max(yy - beside, 0), base::max(xy, 0), base::max(-xy, 0)};
}

}  // namespace dapple::stencil
