// Tensors of a plane on a surface, cell by cell: m V V^T + s V R V^T [Witkin & Kass 1991, 4, with V = V~^-1]. With
// V = [[p, q], [0, r]], R = [[c, s], [s, -c]]:
//   V V^T    twice its mean p^2 + q^2 + r^2, twice its vector (p^2 + q^2 - r^2, 2 q r)
//   V R V^T  twice its mean c (p^2 - q^2 - r^2) + 2 s p q, its vector (c (p^2 - q^2 + r^2) / 2 + s p q, s p r - c q r)
// SPDX-License-Identifier: MIT
#include "flux.hpp"

namespace dapple::stencil {

using i16 = int16_t;

// A product of two Q14 numbers of at most 1.
static inline int32_t by(i16 a, i16 b) { return (static_cast<int32_t>(a) * b) >> 14; }

// Squares and products are Q14; the principal values of V V^T are at most 1, so |p q|, |q r| <= 1/2. A direction is at
// most 16257 long: every sum of products with it is below 1.1e9 < 2^31. |round * twice the vector| <= kOne 2^14 = 2.7e8
// but for the roundings of the squares, which `lean` >= 1/256 keeps below 1e7; leaning * 16257 <= 2.7e8. mean <= 16000.
// One step of floor at each shift. With V = 1 x, y are c, s and the mean is m, to the bit.
void warp_row(const WarpRow& w, const Warp& plane, i16 mean, i16* DAPPLE_RESTRICT x, i16* DAPPLE_RESTRICT y,
              i16* DAPPLE_RESTRICT means, uint16_t n) {
  const int32_t fx = w.flip_x, fy = w.flip_y, both = fx * fy;
  const i16 a = static_cast<i16>(fx * w.c), b = static_cast<i16>(-fx * w.s), d = static_cast<i16>(fy * w.s),
            e = static_cast<i16>(fy * w.c);
  for (uint16_t k = 0; k < n; ++k) {
    const i16 high_c = static_cast<i16>(static_cast<uint16_t>(w.map[k]) << 8),
              high_s = static_cast<i16>(w.map[k] & ~255);
    const int32_t c = base::mulhi(high_c, a) + base::mulhi(high_s, b),
                  s = base::mulhi(high_c, d) + base::mulhi(high_s, e);
    const i16 p = w.p[k], q = w.q[k], r = w.r[k];
    const int32_t pp = by(p, p), qq = by(q, q), rr = by(r, r), pq = by(p, q), qr = by(q, r), pr = by(p, r);
    const int32_t lean_x = (c * (pp - qq + rr) + 2 * both * s * pq) >> 15, lean_y = (s * pr - both * c * qr) >> 14;
    const int32_t lean_mean = (fx * c * (pp - qq - rr) + 2 * fy * s * pq) >> 15;
    x[k] = static_cast<i16>((plane.round * fx * (pp + qq - rr) + plane.leaning * lean_x) >> 14);
    y[k] = static_cast<i16>((plane.round * fy * 2 * qr + plane.leaning * lean_y) >> 14);
    means[k] = static_cast<i16>((static_cast<int32_t>(mean) * (pp + qq + rr) + 2 * plane.mean * lean_mean) >> 15);
  }
}

}  // namespace dapple::stencil
