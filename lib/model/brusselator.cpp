// The Brusselator, reaction of one row. Source and ranges: brusselator.hpp.
//   u, v    Q20, 0..6 and 0..8          lap    Q20, |lap| <= 32
//   u v     Q12 * Q12, < 48 * 2^24, cut to Q12; u^2 v: u in Q11 times u v, < 288 * 2^23 < 2^32, cut to Q14, at most 60
//   force   Q10, <= 1536; product in Q24 < 2^31
//   react   Q14, |.| < 125, saturated to +-63 < 2^20; times a mantissa <= 2^10: < 2^30
//   sum     Q25, |.| <= 32 D dt + 63 dt < 64; rounded once to Q20
// SPDX-License-Identifier: MIT
#include "brusselator.hpp"

namespace dapple::brusselator {

constexpr int32_t kMost = 60 * (INT32_C(1) << 14), kMostSum = 63 * (INT32_C(1) << 14);

struct Reaction {
  int32_t feed, loss, decay, force;
  Rate speed, du, dv;

  DAPPLE_INLINE void step(int32_t& u, int32_t& v, int32_t lap_u, int32_t lap_v, int32_t more) const {
    const uint32_t u12 = static_cast<uint32_t>(u) >> 8, uv = (u12 * (static_cast<uint32_t>(v) >> 8)) >> 12;
    const int32_t product = base::min(static_cast<int32_t>(((u12 >> 1) * uv) >> 9), kMost), u14 = u >> 6;
    const int32_t gone = (u14 * loss) >> 12, made = (u14 * decay) >> 12, forced = (product * force) >> 10;
    const int32_t to_u = base::min(feed + 4 * more - gone + forced, kMostSum),
                  to_v = base::max(made - product, -kMostSum);
    u = stepped(u, times(to_u, speed) + diffused(lap_u, du), 0, kLargestU);
    v = stepped(v, times(to_v, speed) + diffused(lap_v, dv), 0, kLargestV);
  }
};

static Reaction reaction_of(const int32_t* p) {
  return {p[0], p[1], p[2], p[3], unpacked(p[4]), unpacked(p[5]), unpacked(p[6])};
}

// Deviations of the feed.
void react_row(const grid::Rows& rows) { react_rows(rows, reaction_of(rows.p)); }

}  // namespace dapple::brusselator
