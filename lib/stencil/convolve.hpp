// Binary convolution of a row: the definition by table, and the bit-sliced forms that give the same bits.
//
// Kernels of a step ("row") read in[k] = rows y - r + k with a halo of r cells and write the new row of bits to out[0];
// kernels of the field ("field") write n int16 values instead. table: a MaskSet. p: {rule, rho}, rho in 1/kMicro of P.
//   max_difference (M-D): D = max_j K_j * R;   difference_abs (D-A): D = max_j + min_j;   new cell = D > round(rho P)
// The field is 8000 D / P, rounded half up and held within +-8000.
// SPDX-License-Identifier: MIT
#pragma once
#include "slices.hpp"

namespace dapple::stencil {

constexpr int16_t kFieldUnit = 8000;  // D = P
enum MaskRule : uint8_t { max_difference, difference_abs };

inline const MaskSet& mask_set(const grid::Rows& rows) { return *reinterpret_cast<const MaskSet*>(rows.table); }

// round(rho P).
constexpr int16_t threshold_of(int32_t rho, int16_t sum) {
  return static_cast<int16_t>(base::divide_round(static_cast<int64_t>(rho) * sum, base::kMicro));
}

// D as the field has it.
struct FieldScale {
  int32_t factor;  // Q8
};
constexpr FieldScale field_scale(int16_t sum) {
  return {static_cast<int32_t>(base::divide_round(INT32_C(256) * kFieldUnit, sum))};
}
constexpr int16_t field_value(FieldScale scale, int16_t d) {
  const int32_t value = (static_cast<int32_t>(d) * scale.factor + 128) >> 8;
  return static_cast<int16_t>(base::clamp(value, -kFieldUnit, kFieldUnit));
}

// The definition: one look-up for four cells of a row of the mask (Witkin & Kass 5.3), sums by addition.
constexpr uint8_t kTableBlock = 32;  // cells at a time, at most
void sums_by_table(const MaskSet& set, uint8_t mask, const grid::Rows& rows, int32_t x, uint8_t count, int16_t* sum);
void convolve_by_table(const grid::Rows& rows);
void field_by_table(const grid::Rows& rows);

// Bit-sliced on the machine's words. Shifted copies of the rows at hand are kept in scratch (kept_bytes a cell), and so are
// the sums, where running down the rows takes fewer taps.
void convolve_row(const grid::Rows& rows);
void convolve_row8(const grid::Rows& rows);
void convolve_row32(const grid::Rows& rows);
void convolve_row64(const grid::Rows& rows);

// Bit-sliced without any scratch memory: shifted copies are made for every word.
void convolve_lean(const grid::Rows& rows);
void field_row(const grid::Rows& rows);
// The same with StoredMasks in read-only memory; rows.table holds the place of them.
void convolve_stored(const grid::Rows& rows);
void field_stored(const grid::Rows& rows);

}  // namespace dapple::stencil
