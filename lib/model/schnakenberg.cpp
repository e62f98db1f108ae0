// Schnakenberg's reaction, one row. Source and ranges: schnakenberg.hpp.
//   u, v    Q20, 0..6 and 0..4          lap    Q20, |lap| <= 24
//   u v     Q12 * Q12, < 24 * 2^24, cut to Q12
//   u^2 v   u (u v), Q24 in uint32, <= 144 * 2^24 < 2^32, cut to Q14, at most 60
//   react   Q14, |.| < 67 < 2^20.1; times a mantissa <= 2^10: < 2^31
//   sum     Q25, |.| <= 24 D dt + 67 s dt < 64; rounded once to Q20
// SPDX-License-Identifier: MIT
#include "schnakenberg.hpp"

namespace dapple::schnakenberg {

constexpr int32_t kMost = 60 * (INT32_C(1) << 14);

struct Reaction {
  int32_t feed, supply;
  Rate speed, du, dv;

  DAPPLE_INLINE void step(int32_t& u, int32_t& v, int32_t lap_u, int32_t lap_v, int32_t more) const {
    const uint32_t u12 = static_cast<uint32_t>(u) >> 8, uv = (u12 * (static_cast<uint32_t>(v) >> 8)) >> 12;
    const int32_t product = base::min(static_cast<int32_t>((u12 * uv) >> 10), kMost);
    const int32_t to_u = feed + 4 * more - (u >> 6) + product, to_v = supply - product;
    u = stepped(u, times(to_u, speed) + diffused(lap_u, du), 0, kLargestU);
    v = stepped(v, times(to_v, speed) + diffused(lap_v, dv), 0, kLargestV);
  }
};

static Reaction reaction_of(const int32_t* p) { return {p[0], p[1], unpacked(p[2]), unpacked(p[3]), unpacked(p[4])}; }

// Deviations of the feed.
void react_row(const grid::Rows& rows) { react_rows(rows, reaction_of(rows.p)); }

}  // namespace dapple::schnakenberg
