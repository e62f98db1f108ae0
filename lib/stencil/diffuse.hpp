// What diffusion sees of a cell's neighbours: five points, or eight neighbours with weights that are never negative,
// the same everywhere or along a map of directions, for kinetics.
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

// Sums of places where diffusion is a share of the recipe's, Q9, at most 1: the product, rounded. int32 shares with sums of
// int32 cells: rounded to Q14 first, 160 * 2^14 * 2^9 < 2^31; int16 with those of int16 cells: < 2^27.
void share_sums(int32_t* sums, const void* shares, bool wide, uint16_t n);

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

// --- Along a map: div (D grad C), D as above in every cell, its turn the map's. What a link carries it takes from one
// cell and gives to the other, so that diffusion makes nothing and takes nothing [Witkin & Kass 1991, 3.1]. A link's
// weight is the mean of those of its two cells. With q = 1 / stretch^2 a cell's own eight come to 2 (1 + q - |Dxy|) and
// its neighbours' to 4 + 2 (1 - q) at most, whatever the map: the eight links to 4, as of five points, which so stay
// the worst case of the bound on dt, and every step is a mean of cells.

// A cell of the map, packed as in maps.hpp, has the weights
//   x = mean - |v| + u,  y = mean - |v| - u,  fall = max(v, 0),  rise = max(-v, 0)
//   (u, v) = mulhi(256 (cos, sin), slope)
// Q13, floored, held at 0: mean = (1 + q) / 2, slope = (1 - q) 128 / 127, which q = .17 makes 6840.
struct LinkWeights {
  int16_t mean, slope;
};
constexpr LinkWeights link_weights(int32_t stretch) {  // 1/kMicro
  const int64_t across = INT64_C(8192) * base::kMicro / stretch * base::kMicro / stretch;
  return {static_cast<int16_t>((8192 + across) / 2),
          static_cast<int16_t>(base::divide_round((8192 - across) * 128, 127))};
}

// The links of a row to the next one and to its right: int16 rows with a halo of one, Q10. In scratch memory: `beside`,
// then two sets of `straight` (from cell 0 on), `falling` (-1) and `rising` (to n), which take turns being above and
// below; then three rows of the map, later of cells, int32, which take two each.
enum Link : uint8_t { beside, straight, falling, rising, kAcross = 3, kRowsOfCells = 7, kLinkRows = 13 };
constexpr size_t link_bytes(uint16_t n) { return kLinkRows * grid::scratch_bytes(grid::Cell::int16, n, 1); }
// map: rows y - 1, y, y + 1 of a plane of such cells, with a halo of one, int32 if wide, else int16; uses rows.run.
// scratch: link_bytes.
void link_row(const grid::Rows& rows, const void* const* map, bool wide, LinkWeights w);

// in: rows y - 1, y, y + 1 with a halo of one; out[0]: int32 sums over the eight links of weight (neighbour - cell), in
// the format of the cells; scratch: begins where the links end. int32: cells are rounded to Q14 first, |difference| <=
// 20 * 2^14, weights sum to 2^12 + 8, so < 2^30.4; int16: < 2^28.1. What rounding the cells first leaves is odd in the
// two cells of a link: only the last rounding, to the format of the cells, is not kept.
void linked_wide_row(const grid::Rows& rows);
void linked_narrow_row(const grid::Rows& rows);

}  // namespace dapple::stencil
