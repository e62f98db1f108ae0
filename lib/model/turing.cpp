// Turing's reaction, one row. Source and ranges: turing.hpp.
//   a, b    Q20, 0..20 and 0..14        lap    Q20, |lap| <= 8 * 20, exact sums of differences
//   a b     Q11 * Q12 in uint32, <= 280 * 2^23 < 2^32; cut to Q12
//   react   Q12, |.| <= 295 < 2^20.3; times a mantissa < 2^10: < 2^31
//   lap     rounded to Q14, < 2^21 (4 * 20 either way); times a mantissa < 2^10: < 2^31
//   sum     both floored to Q25, |.| < 80 Da dt + 295 s dt <= 64 for what the bound lets through; rounded once to Q20,
//   then held
// SPDX-License-Identifier: MIT
#include "turing.hpp"

namespace dapple::turing {

using kinetics::Rate;

// grown: all ones where the deviations are of the growth, and not of the decay; else 0.
struct Reaction {
  int32_t growth, decay;
  Rate speed, da, db;
  int32_t grown;

  DAPPLE_INLINE void step(int32_t& a, int32_t& b, int32_t lap_a, int32_t lap_b, int32_t more) const {
    constexpr int32_t kMostA = kLargestA * (INT32_C(1) << kWide), kMostB = kLargestB * (INT32_C(1) << kWide);
    const uint32_t product = (static_cast<uint32_t>(a) >> 9) * (static_cast<uint32_t>(b) >> 8);
    const int32_t ab = static_cast<int32_t>(product >> 11);
    const int32_t made = growth + (more & grown) - ab;
    const int32_t changed = ab - (b >> 8) - decay - (more & ~grown);
    a = stepped(a, times(made, speed) + diffused(lap_a, da), 0, kMostA);
    b = stepped(b, times(changed, speed) + diffused(lap_b, db), 0, kMostB);
  }
};

static Reaction reaction_of(const int32_t* p) {
  return {p[0], p[1], unpacked(p[2]), unpacked(p[3]), unpacked(p[4]), p[kGrown] != 0 ? -1 : 0};
}

// Deviations of the decay or the growth.
void react_row(const grid::Rows& rows) { react_rows(rows, reaction_of(rows.p)); }

}  // namespace dapple::turing
