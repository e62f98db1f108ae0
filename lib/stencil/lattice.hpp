// Diffusion over one macro step as three-point passes along lattice directions with growing strides.
// A constant tensor's Gaussian (Witkin & Kass eq. 9, 12; variance V) factors into at most three one-dimensional ones by
// Selling's reduction, and each of those into passes of stride 1, 1, 2, 3, 4, ... , of wide ones 1, 1, 2, 3, 4, 6, 8, 11, ...
// so that their number grows as the logarithm of the width. docs/numbers.md has proof and fidelity.
// SPDX-License-Identifier: MIT
#pragma once
#include "../grid/plane.hpp"

namespace dapple::stencil {

using grid::Tensor;
using grid::kOneVariance;

constexpr int16_t kQuarter = 16384;        // the weight 1/4 in Q16: a full pass
constexpr int16_t kSmallestWeight = 64;    // a lighter last pass is dropped
constexpr int32_t kSmallestShare = 1966;   // a direction with less variance than .03 is dropped
constexpr int32_t kWideShare = 3014656;    // 46, Q16: what strides 1, 1, 2 ... 6 reach; a direction with more is wide
constexpr uint16_t kLargestStride = 91;    // passes 1, 1, 2, 3, 4, 6 ... 91 reach a variance of 8231.5 along a direction
constexpr int32_t kLargestShare = 539459584;  // that variance, Q16

// One direction of the reduction: V = sum of share * v v^T. vy > 0, or (vx, vy) == (1, 0).
struct Direction {
  int16_t vx, vy;
  int32_t share;  // Q16, >= kSmallestShare
};

// Directions in the order they are applied: (1, 0) first if it is there, then by vy, then by vx.
struct Lattice {
  Direction direction[3];
  uint8_t count;
};

constexpr int64_t product(const Tensor& t, const Direction& a, const Direction& b) {
  return static_cast<int64_t>(t.xx) * a.vx * b.vx + static_cast<int64_t>(t.xy) * (a.vx * b.vy + a.vy * b.vx) +
         static_cast<int64_t>(t.yy) * a.vy * b.vy;
}

constexpr bool before(const Direction& a, const Direction& b) { return a.vy != b.vy ? a.vy < b.vy : a.vx < b.vx; }

// Selling's reduction [Selling 1874; Fehrenbach & Mirebeau 2014]: a superbase e0 + e1 + e2 = 0 is flipped until all
// products e_i V e_j <= 0; then V = sum over pairs of -(e_i V e_j) v v^T, v perpendicular to the third vector.
constexpr Lattice lattice_of(const Tensor& t) {
  Direction e[3] = {{1, 0, 0}, {0, 1, 0}, {-1, -1, 0}};
  for (uint8_t round = 0; round < 60; ++round) {
    uint8_t i = 0, j = 1, k = 2;
    if (product(t, e[0], e[1]) > 0) {
    } else if (product(t, e[0], e[2]) > 0) {
      j = 2, k = 1;
    } else if (product(t, e[1], e[2]) > 0) {
      i = 1, j = 2, k = 0;
    } else {
      break;
    }
    e[k] = {static_cast<int16_t>(e[i].vx - e[j].vx), static_cast<int16_t>(e[i].vy - e[j].vy), 0};
    e[i] = {static_cast<int16_t>(-e[i].vx), static_cast<int16_t>(-e[i].vy), 0};
  }
  Lattice result{};
  for (uint8_t k = 0; k < 3; ++k) {
    const int64_t share = -product(t, e[(k + 1) % 3], e[(k + 2) % 3]);
    if (share < kSmallestShare) continue;
    Direction d = {static_cast<int16_t>(-e[k].vy), e[k].vx, static_cast<int32_t>(share)};
    if (d.vy < 0 || (d.vy == 0 && d.vx < 0)) {
      d.vx = static_cast<int16_t>(-d.vx);
      d.vy = static_cast<int16_t>(-d.vy);
    }
    uint8_t at = result.count++;
    for (; at > 0 && before(d, result.direction[at - 1]); --at) result.direction[at] = result.direction[at - 1];
    result.direction[at] = d;
  }
  return result;
}

// One pass: cells C[p], neighbours at +-stride along the direction.
//   C' = C + (((C[+] + C[-] - 2 C + rounding) * weight) >> 16),  all cells read the old plane.
struct Pass {
  uint16_t stride;
  int16_t weight;    // Q16, even, 64..16384
  int16_t rounding;  // rounding_for(weight); full passes of one plane take 2, 1, 2, 1 ... in turn
};

// The passes of one direction. Strides 1, 1, 2, 3 ... : stride s at the full weight 1/4 adds s^2 / 2 to the variance;
// the last pass takes what is left. A wide one's strides grow by the root of 2 from 4 on: two passes double the width. Wide is
// what has more than `narrow`: wide_share(length) for a step of that length, so that recipes are wide or not, not steps.
struct PassSeries {
  int32_t rest;   // variance still to be made, Q16
  uint16_t made;  // passes so far
  uint8_t turn;   // parity of the full passes of this plane
  bool wide;
};

constexpr int32_t wide_share(int32_t length) {
  if (length == kOneVariance) return kWideShare;
  return static_cast<int32_t>(static_cast<int64_t>(kWideShare) * length / kOneVariance);
}

constexpr PassSeries series_of(int32_t share, uint8_t turn, int32_t narrow = kWideShare) {
  return {share, 0, turn, share > narrow};
}

// 1, 1, 2, 3, 4, then 5, 6, 7 ..., or 6, 8, 11, 16, 23, 32, 45, 64, 91: 4 sqrt(2)^i, 181 / 32 = 5.656.
constexpr uint16_t stride_at(uint16_t made, bool wide) {
  if (made == 0) return 1;
  if (!wide || made < 4) return made;
  const uint16_t twice = static_cast<uint16_t>((made - 4) / 2);
  return static_cast<uint16_t>(made % 2 == 0 ? UINT32_C(4) << twice : ((UINT32_C(181) << twice) + 16) >> 5);
}

constexpr bool next_pass(PassSeries& series, Pass& pass) {
  if (series.rest <= 0) return false;
  const uint16_t stride = stride_at(series.made, series.wide);
  if (stride > kLargestStride) return false;
  const int32_t square = static_cast<int32_t>(stride) * stride;
  const int32_t capacity = square * (kOneVariance / 2);
  const bool full = series.rest >= capacity;
  const int32_t weight = full ? kQuarter : 2 * ((series.rest + 2 * square) / (4 * square));
  series.rest = full ? series.rest - capacity : 0;
  ++series.made;
  if (weight < kSmallestWeight) return false;
  pass.stride = stride;
  pass.weight = static_cast<int16_t>(weight);
  pass.rounding = base::rounding_for(pass.weight);
  if (weight == kQuarter) {
    pass.rounding = static_cast<int16_t>(2 - series.turn);
    series.turn ^= 1;
  }
  return true;
}

// The largest stride of the direction's passes.
constexpr uint16_t reach_of(int32_t share, int32_t narrow = kWideShare) {
  PassSeries series = series_of(share, 0, narrow);
  Pass pass{};
  uint16_t reach = 0;
  while (next_pass(series, pass)) reach = pass.stride;
  return reach;
}

// How far, in rows or cells, all passes of a direction together carry a value.
constexpr uint16_t spread_of(const Direction& d, int32_t narrow = kWideShare) {
  PassSeries series = series_of(d.share, 0, narrow);
  Pass pass{};
  uint16_t sum = 0;
  while (next_pass(series, pass)) sum = static_cast<uint16_t>(sum + pass.stride);
  const int16_t across = static_cast<int16_t>(d.vx < 0 ? -d.vx : d.vx);
  return static_cast<uint16_t>(sum * (across > d.vy ? across : d.vy));
}

// Kernel of one pass that leaves the row. in[0], in[1], in[2]: the plane's rows y - S, y, y + S with halo; out[0]: row y.
// p: {shift = stride * vx (may be negative), weight, rounding}. Concentrations 0..16000: |d + r| <= 32512 fits int16, and
// the result stays between the least and the greatest of the three cells (exhaustively tested).
void pass_row(const grid::Rows& rows);

// Kernel of all passes along (1, 0), row by row in cache. in place: out[0]. p: {share, halo, narrow}. scratch: two rows with halo.
void chain_row(const grid::Rows& rows);

// Both with a pass of somebody's own, for kernels of a port: out[x] from l[x], c[x], r[x]; no row overlaps another.
using ThreePoint = void (*)(const int16_t* l, const int16_t* c, const int16_t* r, int16_t* out, uint16_t n,
                            int16_t weight, int16_t rounding);
void pass_row_by(const grid::Rows& rows, ThreePoint three_point);
void chain_row_by(const grid::Rows& rows, ThreePoint three_point);

}  // namespace dapple::stencil
