// Small integer maths: sine, square roots. Angles are in 1/65536 of a full turn.
// SPDX-License-Identifier: MIT
#pragma once
#include "fixed.hpp"

namespace dapple::base {

// sine(a) == round(32767 sin(2 pi a / 65536)) within 3 units, Q0.15; exact at the quadrants, odd and symmetric bit for
// bit. A polynomial rather than a table, so that it is constexpr and costs no flash table where only recipes need it:
// z (c1 - z^2 (c3 - z^2 (c5 - z^2 c7))) on the quarter, z = 0..1 in Q15; int32 throughout, worst product 2^30 * 1.6 < 2^31.
constexpr int16_t sine(uint16_t angle) {
  const bool negative = (angle & 0x8000u) != 0;
  uint16_t quarter = static_cast<uint16_t>(angle & 0x7fffu);
  if (quarter > 0x4000u) quarter = static_cast<uint16_t>(0x8000u - quarter);
  const int32_t z = static_cast<int32_t>(quarter) * 2;  // Q15, 0..32768
  const int32_t z2 = (z * (z >> 1)) >> 14;              // Q15; z <= 2^15, so the product stays below 2^30
  int32_t sum = (z2 * 148 + 16384) >> 15;               // c7 = .00451
  sum = 2610 - sum;                                     // c5 = .07965
  sum = 21165 - ((z2 * sum + 16384) >> 15);             // c3 = .64591
  sum = 51471 - ((z2 * sum + 16384) >> 15);             // c1 = 1.57077
  const int32_t value = min((z * (sum >> 1) + 8192) >> 14, 32767);
  return static_cast<int16_t>(negative ? -value : value);
}
constexpr int16_t cosine(uint16_t angle) { return sine(static_cast<uint16_t>(angle + 0x4000u)); }

// angle_of(degrees in 1/kMicro) == round(degrees / 360 * 65536) mod 65536.
constexpr uint16_t angle_of(int32_t micro_degrees) {
  return static_cast<uint16_t>(divide_round(static_cast<int64_t>(micro_degrees) * 65536, INT64_C(360) * kMicro) & 0xffff);
}

// square_root(n) == floor(sqrt(n)).
constexpr uint16_t square_root(uint32_t n) {
  uint32_t root = 0;
  for (uint32_t bit = UINT32_C(1) << 15; bit != 0; bit >>= 1) {
    const uint32_t trial = root | bit;
    if (trial * trial <= n) root = trial;
  }
  return static_cast<uint16_t>(root);
}

constexpr uint32_t square_root64(uint64_t n) {
  uint64_t root = 0;
  for (uint64_t bit = UINT64_C(1) << 31; bit != 0; bit >>= 1) {
    const uint64_t trial = root | bit;
    if (trial * trial <= n) root = trial;
  }
  return static_cast<uint32_t>(root);
}

// inverse_root(n) == 2^24 / sqrt(n) within one part in 500 + 1 unit, n = 2^16..2^26, by table and linear steps:
// what a unit normal needs. 65535 below.
uint16_t inverse_root(uint32_t n);

}  // namespace dapple::base
