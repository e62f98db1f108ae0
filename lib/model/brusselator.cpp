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

struct Rates {
  int32_t feed, gone, decay, force;
  Rate dt, du, dv;
};

static void react(int32_t* DAPPLE_RESTRICT u, int32_t* DAPPLE_RESTRICT v, const int32_t* DAPPLE_RESTRICT lap_u,
                  const int32_t* DAPPLE_RESTRICT lap_v, const int32_t* DAPPLE_RESTRICT more, uint16_t n, Rates r) {
  for (uint16_t x = 0; x < n; ++x) {
    const uint32_t u12 = static_cast<uint32_t>(u[x]) >> 8, uv = (u12 * (static_cast<uint32_t>(v[x]) >> 8)) >> 12;
    const int32_t product = base::min(static_cast<int32_t>(((u12 >> 1) * uv) >> 9), kMost), u14 = u[x] >> 6;
    const int32_t gone = (u14 * r.gone) >> 12, made = (u14 * r.decay) >> 12, forced = (product * r.force) >> 10;
    const int32_t to_u = base::min(r.feed + 4 * more[x] - gone + forced, kMostSum),
                  to_v = base::max(made - product, -kMostSum);
    u[x] = stepped(u[x], times(to_u, r.dt) + diffused(lap_u[x], r.du), 0, kLargestU);
    v[x] = stepped(v[x], times(to_v, r.dt) + diffused(lap_v[x], r.dv), 0, kLargestV);
  }
}

// in: sums of u and v, deviations of the feed (Q12); out: u, v in place.
void react_row(const grid::Rows& rows) {
  const int32_t* p = rows.p;
  react(grid::out32(rows, 0), grid::out32(rows, 1), grid::in32(rows, 0), grid::in32(rows, 1), grid::in32(rows, 2),
        rows.n, {p[0], p[1], p[2], p[3], unpacked(p[4]), unpacked(p[5]), unpacked(p[6])});
}

}  // namespace dapple::brusselator
