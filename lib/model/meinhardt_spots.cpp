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

constexpr int32_t kMost = 2 * (INT32_C(1) << 20) - 1;

struct Reaction {
  int32_t decay, drain, least;
  Rate speed, da, db;

  DAPPLE_INLINE void step(int32_t& a, int32_t& b, int32_t lap_a, int32_t lap_b, int32_t more) const {
    const uint32_t a12 = static_cast<uint32_t>(a) >> 8;
    const uint32_t divisor = static_cast<uint32_t>(base::max(b, 1 << 10));
    const int32_t ratio = base::min(static_cast<int32_t>(base::quotient<23>(a12, divisor) >> 3), INT32_C(1) << 16);
    const int32_t c = 655 + ((655 * more) >> kVaryBits);
    const int32_t q = static_cast<int32_t>((a12 * static_cast<uint32_t>(ratio)) >> 11),
                  square = static_cast<int32_t>((a12 * a12) >> 11);
    const int32_t lost = (static_cast<int32_t>(a12) * decay) >> 8, drained = ((b >> 8) * drain) >> 8;
    const int32_t to_a = base::clamp(((q * c) >> 9) - lost + least, -kMost, kMost);
    const int32_t to_b = base::clamp(((square * c) >> 9) - drained + least, -kMost, kMost);
    a = stepped(a, times(to_a, speed) + diffused(lap_a, da), 0, kLargest);
    b = stepped(b, times(to_b, speed) + diffused(lap_b, db), 0, kLargest);
  }
};

static Reaction reaction_of(const int32_t* p) {
  return {p[0], p[1], p[2], unpacked(p[3]), unpacked(p[4]), unpacked(p[5])};
}

// Deviations of beta.
void react_row(const grid::Rows& rows) { react_rows(rows, reaction_of(rows.p)); }

}  // namespace dapple::meinhardt_spots
