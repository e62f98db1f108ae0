// Explicit diffusion stencils, one row. See laplacian.hpp for formats.
// SPDX-License-Identifier: MIT
#include "laplacian.hpp"

namespace dapple::stencil {

using base::mulhi;

// Left and right come as pointers of their own: compilers then vectorise without a recurrence.
static void five(const int16_t* DAPPLE_RESTRICT u, const int16_t* DAPPLE_RESTRICT l, const int16_t* DAPPLE_RESTRICT c,
                 const int16_t* DAPPLE_RESTRICT r, const int16_t* DAPPLE_RESTRICT d, int16_t* DAPPLE_RESTRICT out,
                 uint16_t n, int16_t w, int16_t k) {
  for (uint16_t x = 0; x < n; ++x) {
    const int16_t twice = static_cast<int16_t>(2 * c[x]);
    out[x] = static_cast<int16_t>(mulhi(static_cast<int16_t>(l[x] + r[x] - twice + k), w) +
                                  mulhi(static_cast<int16_t>(u[x] + d[x] - twice + k), w));
  }
}

void five_row(const grid::Rows& rows) {
  const int16_t* c = grid::in16(rows, 1);
  five(grid::in16(rows, 0), c - 1, c, c + 1, grid::in16(rows, 2), grid::out16(rows, 0), rows.n,
       static_cast<int16_t>(rows.p[0]), static_cast<int16_t>(rows.p[1]));
}

static void nine(const int16_t* DAPPLE_RESTRICT u, const int16_t* DAPPLE_RESTRICT c, const int16_t* DAPPLE_RESTRICT d,
                 int32_t* DAPPLE_RESTRICT out, uint16_t n, int32_t xx, int32_t yy, int32_t xy) {
  for (int32_t x = 0; x < n; ++x) {
    const int32_t twice = 2 * static_cast<int32_t>(c[x]);
    const int32_t across = static_cast<int32_t>(c[x - 1]) + c[x + 1] - twice;
    const int32_t along = static_cast<int32_t>(u[x]) + d[x] - twice;
    const int32_t corners = static_cast<int32_t>(u[x - 1]) + d[x + 1] - u[x + 1] - d[x - 1];
    out[x] = xx * across + yy * along + xy * corners;
  }
}

void nine_row(const grid::Rows& rows) {
  nine(grid::in16(rows, 0), grid::in16(rows, 1), grid::in16(rows, 2), static_cast<int32_t*>(rows.out[0]), rows.n,
       rows.p[0], rows.p[1], rows.p[2]);
}

}  // namespace dapple::stencil
