// Binary convolution by table. This is the definition; see convolve.hpp.
// SPDX-License-Identifier: MIT
#include "convolve.hpp"

namespace dapple::stencil {

// Cells x .. x + 31 of a row as bits, x at least -8 and any.
static uint64_t bits_from(const uint8_t* row, int32_t x, uint8_t count) {
  uint64_t bits = 0;
  for (uint8_t i = 0; i < count; ++i) bits |= static_cast<uint64_t>(grid::get_bit(row, x + i)) << i;
  return bits;
}

// sum[i] += the weights of one row of the mask over the cells around x + i.
static void add_row(const int8_t* weight, uint8_t side, const uint8_t* row, int32_t x, uint8_t count, int16_t* sum) {
  constexpr uint8_t kTables = (kLargestSide + 3) / 4;
  int8_t table[kTables][16] = {};
  for (uint8_t i = 0; i < side; ++i)
    for (uint8_t pattern = 0; pattern < 16; ++pattern)
      if ((pattern >> (i & 3)) & 1) table[i / 4][pattern] = static_cast<int8_t>(table[i / 4][pattern] + weight[i]);
  const uint64_t bits = bits_from(row, x - side / 2, static_cast<uint8_t>(count + side - 1));
  for (uint8_t i = 0; i < count; ++i)
    for (uint8_t k = 0; 4 * k < side; ++k) sum[i] = static_cast<int16_t>(sum[i] + table[k][(bits >> (i + 4 * k)) & 15]);
}

void sums_by_table(const MaskSet& set, uint8_t mask, const grid::Rows& rows, int32_t x, uint8_t count, int16_t* sum) {
  const uint8_t side = static_cast<uint8_t>(2 * set.radius + 1);
  int8_t weight[kLargestSide * kLargestSide];
  weights_of(set, mask, weight);
  for (uint8_t i = 0; i < count; ++i) sum[i] = 0;
  for (uint8_t k = 0; k < side; ++k) add_row(weight + k * side, side, static_cast<const uint8_t*>(rows.in[k]), x, count, sum);
}

// D of `count` <= kTableBlock cells from x on.
static void differences(const grid::Rows& rows, int32_t x, uint8_t count, int16_t* d) {
  const MaskSet& set = mask_set(rows);
  int16_t least[kTableBlock];
  for (uint8_t j = 0; j < set.count; ++j) {
    int16_t sum[kTableBlock];
    sums_by_table(set, j, rows, x, count, sum);
    for (uint8_t i = 0; i < count; ++i) {
      if (j == 0 || sum[i] > d[i]) d[i] = sum[i];
      if (j == 0 || sum[i] < least[i]) least[i] = sum[i];
    }
  }
  if (rows.p[0] == difference_abs && set.count > 1)
    for (uint8_t i = 0; i < count; ++i) d[i] = static_cast<int16_t>(d[i] + least[i]);
}

void convolve_by_table(const grid::Rows& rows) {
  const int16_t threshold = threshold_of(rows.p[1], mask_set(rows).sum);
  for (uint32_t x = 0; x < rows.n; x += kTableBlock) {
    const uint8_t count = static_cast<uint8_t>(base::min(kTableBlock, static_cast<int32_t>(rows.n - x)));
    int16_t d[kTableBlock];
    differences(rows, static_cast<int32_t>(x), count, d);
    for (uint8_t i = 0; i < count; ++i)
      grid::put_bit(static_cast<uint8_t*>(rows.out[0]), static_cast<int32_t>(x + i), d[i] > threshold);
  }
}

void field_by_table(const grid::Rows& rows) {
  const FieldScale scale = field_scale(mask_set(rows).sum);
  for (uint32_t x = 0; x < rows.n; x += kTableBlock) {
    const uint8_t count = static_cast<uint8_t>(base::min(kTableBlock, static_cast<int32_t>(rows.n - x)));
    int16_t d[kTableBlock];
    differences(rows, static_cast<int32_t>(x), count, d);
    for (uint8_t i = 0; i < count; ++i) grid::out16(rows, 0)[x + i] = field_value(scale, d[i]);
  }
}

}  // namespace dapple::stencil
