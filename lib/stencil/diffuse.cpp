// Sums of neighbours for kinetics, one row. See diffuse.hpp for formats.
// SPDX-License-Identifier: MIT
#include "diffuse.hpp"

namespace dapple::stencil {

// Neighbours come as pointers of their own: compilers then vectorise without a recurrence.
template <class T>
static void five(const T* DAPPLE_RESTRICT u, const T* DAPPLE_RESTRICT l, const T* DAPPLE_RESTRICT c,
                 const T* DAPPLE_RESTRICT r, const T* DAPPLE_RESTRICT d, int32_t* DAPPLE_RESTRICT out, uint16_t n) {
  for (uint16_t x = 0; x < n; ++x)
    out[x] = static_cast<int32_t>(l[x]) + r[x] + u[x] + d[x] - 4 * static_cast<int32_t>(c[x]);
}

template <class T>
static void five_of(const grid::Rows& rows) {
  const T* c = static_cast<const T*>(rows.in[1]);
  five(static_cast<const T*>(rows.in[0]), c - 1, c, c + 1, static_cast<const T*>(rows.in[2]), grid::out32(rows, 0),
       rows.n);
}
void five_wide_row(const grid::Rows& rows) { five_of<int32_t>(rows); }
void five_narrow_row(const grid::Rows& rows) { five_of<int16_t>(rows); }

// One pair of opposite neighbours; cut: bits that go before the product.
template <class T, uint8_t cut>
DAPPLE_INLINE int32_t pair(const T* a, const T* b, const T* c, uint16_t x, int32_t weight) {
  const int32_t sum = static_cast<int32_t>(a[x]) + b[x] - 2 * static_cast<int32_t>(c[x]);
  return ((sum + ((1 << cut) >> 1)) >> cut) * weight;
}

template <class T, uint8_t cut>
static void eight(const T* DAPPLE_RESTRICT u, const T* DAPPLE_RESTRICT c, const T* DAPPLE_RESTRICT d,
                  int32_t* DAPPLE_RESTRICT out, uint16_t n, EightWeights w) {
  constexpr uint8_t shift = 10 - cut;
  for (uint16_t x = 0; x < n; ++x) {
    const int32_t sum = pair<T, cut>(c - 1, c + 1, c, x, w.x) + pair<T, cut>(u, d, c, x, w.y) +
                        pair<T, cut>(u - 1, d + 1, c, x, w.fall) + pair<T, cut>(d - 1, u + 1, c, x, w.rise);
    out[x] = (sum + (1 << (shift - 1))) >> shift;
  }
}

template <class T, uint8_t cut>
static void eight_of(const grid::Rows& rows) {
  const int32_t* w = rows.table;
  eight<T, cut>(static_cast<const T*>(rows.in[0]), static_cast<const T*>(rows.in[1]), static_cast<const T*>(rows.in[2]),
                grid::out32(rows, 0), rows.n, {w[0], w[1], w[2], w[3]});
}
void eight_wide_row(const grid::Rows& rows) { eight_of<int32_t, 6>(rows); }
void eight_narrow_row(const grid::Rows& rows) { eight_of<int16_t, 0>(rows); }

}  // namespace dapple::stencil
