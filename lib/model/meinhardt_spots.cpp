// Meinhardt's spots, reaction of one row. Source and ranges: meinhardt_spots.hpp.
//   a, b    Q20, below 8; b as a divisor at least 2^-10
//   a / b   Q15 by base::quotient, cut to Q12, at most 16
//   q       a (a / b), Q24 in uint32, <= 8 * 16 * 2^24 = 2^31, cut to Q13; c = .01 beta in Q16, <= 984; q c in Q29 < 2^30
//   react   Q20: |.| <= 1.92 + .15 * 8 + .05 < 3.2, a saturated to +-1.99; times a mantissa < 2^10: < 2^31
//   sum     Q25, |.| <= 32 D dt + 2 s dt < 64; rounded once to Q20
// SPDX-License-Identifier: MIT
#include "meinhardt_spots.hpp"

#include "../base/reciprocal.hpp"

namespace dapple::meinhardt_spots {

struct Rates {
  int32_t decay, drain, base;
  Rate speed, da, db;
};

constexpr int32_t kMost = 2 * (INT32_C(1) << 20) - 1;

static void react(int32_t* DAPPLE_RESTRICT a, int32_t* DAPPLE_RESTRICT b, const int32_t* DAPPLE_RESTRICT lap_a,
                  const int32_t* DAPPLE_RESTRICT lap_b, const int32_t* DAPPLE_RESTRICT more, uint16_t n, Rates r) {
  for (uint16_t x = 0; x < n; ++x) {
    const uint32_t a12 = static_cast<uint32_t>(a[x]) >> 8;
    const uint32_t divisor = static_cast<uint32_t>(base::max(b[x], 1 << 10));
    const int32_t ratio = base::min(static_cast<int32_t>(base::quotient<23>(a12, divisor) >> 3), INT32_C(1) << 16);
    const int32_t c = 655 + ((655 * more[x]) >> kVaryBits);
    const int32_t q = static_cast<int32_t>((a12 * static_cast<uint32_t>(ratio)) >> 11),
                  square = static_cast<int32_t>((a12 * a12) >> 11);
    const int32_t lost = (static_cast<int32_t>(a12) * r.decay) >> 8, drained = ((b[x] >> 8) * r.drain) >> 8;
    const int32_t to_a = base::clamp(((q * c) >> 9) - lost + r.base, -kMost, kMost);
    const int32_t to_b = base::clamp(((square * c) >> 9) - drained + r.base, -kMost, kMost);
    a[x] = stepped(a[x], times(to_a, r.speed) + diffused(lap_a[x], r.da), 0, kLargest);
    b[x] = stepped(b[x], times(to_b, r.speed) + diffused(lap_b[x], r.db), 0, kLargest);
  }
}

// in: sums of a and b, deviations of beta (Q12); out: a, b in place.
void react_row(const grid::Rows& rows) {
  const int32_t* p = rows.p;
  react(grid::out32(rows, 0), grid::out32(rows, 1), grid::in32(rows, 0), grid::in32(rows, 1), grid::in32(rows, 2),
        rows.n, {p[0], p[1], p[2], unpacked(p[3]), unpacked(p[4]), unpacked(p[5])});
}

}  // namespace dapple::meinhardt_spots
