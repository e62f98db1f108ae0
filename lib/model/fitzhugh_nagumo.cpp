// FitzHugh-Nagumo, reaction of one row. Source and ranges: fitzhugh_nagumo.hpp.
//   a, b    Q14, within +-2             lap    Q14, |lap| <= 16
//   a^3     a^2 in Q12, <= 2^14, times a in Q14: < 2^29, cut to Q14
//   react   Q14, |.| <= 12 and 11 < 2^18; times a mantissa <= 2^10: <= 2^28
//   sum     Q19, |.| <= 12 dt + 16 dt D < 2^31; rounded once to Q14
// SPDX-License-Identifier: MIT
#include "fitzhugh_nagumo.hpp"

namespace dapple::fitzhugh_nagumo {

using i16 = int16_t;

struct Rates {
  int32_t couple, bias;
  Rate fast, slow, da, db;
};

static void react(i16* DAPPLE_RESTRICT a, i16* DAPPLE_RESTRICT b, const int32_t* DAPPLE_RESTRICT lap_a,
                  const int32_t* DAPPLE_RESTRICT lap_b, const i16* DAPPLE_RESTRICT more, uint16_t n, Rates r) {
  for (uint16_t x = 0; x < n; ++x) {
    const int32_t u = a[x], v = b[x];
    const int32_t cube = (((u * u) >> 16) * u) >> 12;
    const int32_t bias = r.bias + 4 * static_cast<int32_t>(more[x]);
    const int32_t to_a = u - cube - v, to_b = u - ((v * r.couple) >> 12) - bias;
    a[x] = static_cast<i16>(stepped(u, times(to_a, r.fast) + times(lap_a[x], r.da), -kLargest, kLargest));
    b[x] = static_cast<i16>(stepped(v, times(to_b, r.slow) + times(lap_b[x], r.db), -kLargest, kLargest));
  }
}

// in: sums of a and b, deviations of the bias (Q12); out: a, b in place.
void react_row(const grid::Rows& rows) {
  const int32_t* p = rows.p;
  react(grid::out16(rows, 0), grid::out16(rows, 1), grid::in32(rows, 0), grid::in32(rows, 1), grid::in16(rows, 2),
        rows.n, {p[0], p[1], unpacked(p[2]), unpacked(p[3]), unpacked(p[4]), unpacked(p[5])});
}

}  // namespace dapple::fitzhugh_nagumo
