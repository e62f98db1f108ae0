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

struct Rates {
  int32_t feed, supply;
  Rate speed, du, dv;
};

static void react(int32_t* DAPPLE_RESTRICT u, int32_t* DAPPLE_RESTRICT v, const int32_t* DAPPLE_RESTRICT lap_u,
                  const int32_t* DAPPLE_RESTRICT lap_v, const int32_t* DAPPLE_RESTRICT more, uint16_t n, Rates r) {
  for (uint16_t x = 0; x < n; ++x) {
    const uint32_t u12 = static_cast<uint32_t>(u[x]) >> 8, uv = (u12 * (static_cast<uint32_t>(v[x]) >> 8)) >> 12;
    const int32_t product = base::min(static_cast<int32_t>((u12 * uv) >> 10), kMost);
    const int32_t to_u = r.feed + 4 * more[x] - (u[x] >> 6) + product, to_v = r.supply - product;
    u[x] = stepped(u[x], times(to_u, r.speed) + diffused(lap_u[x], r.du), 0, kLargestU);
    v[x] = stepped(v[x], times(to_v, r.speed) + diffused(lap_v[x], r.dv), 0, kLargestV);
  }
}

// in: sums of u and v, deviations of the feed (Q12); out: u, v in place.
void react_row(const grid::Rows& rows) {
  const int32_t* p = rows.p;
  react(grid::out32(rows, 0), grid::out32(rows, 1), grid::in32(rows, 0), grid::in32(rows, 1), grid::in32(rows, 2),
        rows.n, {p[0], p[1], unpacked(p[2]), unpacked(p[3]), unpacked(p[4])});
}

}  // namespace dapple::schnakenberg
