// Meinhardt's stripes, reaction of one row. Source and ranges: meinhardt_stripes.hpp.
//   cells   Q14, 0..2                   lap    Q14, |lap| <= 8
//   a^2 e   Q15, <= 8; times k = .01 beta in Q16, <= 787: Q31 < 2^28, cut to Q19: < 2^16
//   / c     Q20 by base::quotient, at most 1
//   react   Q20, |.| < 2, times a mantissa <= 2^10: <= 2^31 is kept off by +-1.99
//   sum     Q19; rounded once to Q14
// Two passes, so that compilers see few rows at a time.
// SPDX-License-Identifier: MIT
#include "meinhardt_stripes.hpp"

#include "../base/reciprocal.hpp"

namespace dapple::meinhardt_stripes {

using i16 = int16_t;

struct Rates {
  int32_t decay, drain, relax;
  Rate speed, da, dd;
};

constexpr int32_t kMost = 2 * (INT32_C(1) << 20) - 1;

// .01 beta a^2 e in Q19.
DAPPLE_INLINE uint32_t made(int32_t a, int32_t e, int32_t k) {
  const int32_t square = (a * a) >> 15;                          // Q13, <= 2^15
  return static_cast<uint32_t>(((square * e) >> 12) * k) >> 12;  // Q15 times Q16
}

// rate (own in Q14), Q20.
DAPPLE_INLINE int32_t lost(int32_t own, int32_t rate) { return (own * rate) >> 10; }

DAPPLE_INLINE i16 after(int32_t cell, int32_t react, int32_t lap, Rate speed, Rate diffusion) {
  return static_cast<i16>(
      stepped(cell, times(base::clamp(react, -kMost, kMost), speed) + times(lap, diffusion), 0, kLargest));
}

// in, out: Q14. a, b and c from the old d and e.
static void react_abc(i16* DAPPLE_RESTRICT a, i16* DAPPLE_RESTRICT b, i16* DAPPLE_RESTRICT c,
                      const i16* DAPPLE_RESTRICT d, const i16* DAPPLE_RESTRICT e, const int32_t* DAPPLE_RESTRICT lap_a,
                      const int32_t* DAPPLE_RESTRICT lap_b, const i16* DAPPLE_RESTRICT more, uint16_t n, Rates r) {
  for (uint16_t x = 0; x < n; ++x) {
    const int32_t k = 655 + ((655 * static_cast<int32_t>(more[x])) >> kVaryBits);
    const uint32_t by_a = made(a[x], e[x], k), by_b = made(b[x], d[x], k);
    const uint32_t divisor = static_cast<uint32_t>(2 * base::max(c[x], 1 << 9));
    const int32_t share_a = static_cast<int32_t>(base::quotient<16>(by_a, divisor)),
                  share_b = static_cast<int32_t>(base::quotient<16>(by_b, divisor));
    a[x] = after(a[x], share_a - lost(a[x], r.decay), lap_a[x], r.speed, r.da);
    b[x] = after(b[x], share_b - lost(b[x], r.decay), lap_b[x], r.speed, r.da);
    c[x] = after(c[x], static_cast<int32_t>(2 * (by_a + by_b)) - lost(c[x], r.drain), 0, r.speed, r.da);
  }
}

// d follows a, or e b; own is the old a or b.
static void follow(i16* DAPPLE_RESTRICT d, const i16* DAPPLE_RESTRICT own, const int32_t* DAPPLE_RESTRICT lap,
                   uint16_t n, int32_t relax, Rate speed, Rate dd) {
  for (uint16_t x = 0; x < n; ++x)
    d[x] = after(d[x], lost(static_cast<int32_t>(own[x]) - d[x], relax), lap[x], speed, dd);
}

// in: sums of a, b, c, d, e, then deviations of beta (Q12); out: the five in place. scratch: the old a and b.
void react_row(const grid::Rows& rows) {
  const int32_t* p = rows.p;
  const Rates r = {p[0], p[1], p[2], unpacked(p[3]), unpacked(p[4]), unpacked(p[5])};
  const size_t bytes = grid::row_bytes(grid::Cell::int16, rows.n);
  i16* const old_a = reinterpret_cast<i16*>(rows.scratch);
  i16* const old_b = reinterpret_cast<i16*>(rows.scratch + bytes);
  grid::copy_bytes(old_a, rows.out[0], static_cast<size_t>(rows.n) * 2);
  grid::copy_bytes(old_b, rows.out[1], static_cast<size_t>(rows.n) * 2);
  react_abc(grid::out16(rows, 0), grid::out16(rows, 1), grid::out16(rows, 2), grid::out16(rows, 3),
            grid::out16(rows, 4), grid::in32(rows, 0), grid::in32(rows, 1), grid::in16(rows, 5), rows.n, r);
  follow(grid::out16(rows, 3), old_a, grid::in32(rows, 3), rows.n, r.relax, r.speed, r.dd);
  follow(grid::out16(rows, 4), old_b, grid::in32(rows, 4), rows.n, r.relax, r.speed, r.dd);
}

}  // namespace dapple::meinhardt_stripes
