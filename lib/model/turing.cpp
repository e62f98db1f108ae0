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

// grown: the deviations are of the growth, and not of the decay.
template <bool grown>
static void react(int32_t* DAPPLE_RESTRICT a, int32_t* DAPPLE_RESTRICT b, const int32_t* DAPPLE_RESTRICT lap_a,
                  const int32_t* DAPPLE_RESTRICT lap_b, const int32_t* DAPPLE_RESTRICT more, uint16_t n, int32_t growth,
                  int32_t decay, Rate speed, Rate da, Rate db) {
  constexpr int32_t kMostA = kLargestA * (INT32_C(1) << kWide), kMostB = kLargestB * (INT32_C(1) << kWide);
  for (uint16_t x = 0; x < n; ++x) {
    const uint32_t product = (static_cast<uint32_t>(a[x]) >> 9) * (static_cast<uint32_t>(b[x]) >> 8);
    const int32_t ab = static_cast<int32_t>(product >> 11);
    const int32_t made = growth + (grown ? more[x] : 0) - ab;
    const int32_t changed = ab - (b[x] >> 8) - decay - (grown ? 0 : more[x]);
    a[x] = stepped(a[x], times(made, speed) + diffused(lap_a[x], da), 0, kMostA);
    b[x] = stepped(b[x], times(changed, speed) + diffused(lap_b[x], db), 0, kMostB);
  }
}

// in: sums of a and b, deviations of the decay or the growth (Q12); out: a, b in place.
void react_row(const grid::Rows& rows) {
  const int32_t* p = rows.p;
  const auto row = p[5] != 0 ? react<true> : react<false>;
  row(grid::out32(rows, 0), grid::out32(rows, 1), grid::in32(rows, 0), grid::in32(rows, 1), grid::in32(rows, 2), rows.n,
      p[0], p[1], unpacked(p[2]), unpacked(p[3]), unpacked(p[4]));
}

}  // namespace dapple::turing
