// Quotients without a division, by branches that compilers turn into masks: what a row of cells can be divided with.
// SPDX-License-Identifier: MIT
#pragma once
#include "port.hpp"

namespace dapple::base {

// inverse(m) == 2^31 / m within one part in 12000, 2^15 <= m < 2^16: result 2^15..2^16. A line (48 - 32 m) / 17 within
// 1/17, then two steps x (2 - m x), which square the error: 1/83521, and what 16 bits cut off.
DAPPLE_INLINE uint32_t inverse(uint32_t m) {
  uint32_t x = UINT32_C(92521) - ((m * UINT32_C(61682)) >> 16);  // Q15; m x <= 2^31 18/17 < 2^32
  x = (x * ((UINT32_C(0) - m * x) >> 16)) >> 15;                 // 2 - m x in Q31, its upper half in Q15
  return (x * ((UINT32_C(0) - m * x) >> 16)) >> 15;
}

// quotient<bits>(a, b) == a 2^bits / b within one part in 12000 and what is floored, a < 2^16, 2^(bits - 15) <= b <
// 2^bits, bits 16..23: b is shifted up to all its bits by eights, fours, twos, ones, the inverse of its upper 16 taken,
// and the product shifted as far.
template <uint8_t bits>
DAPPLE_INLINE uint32_t quotient(uint32_t a, uint32_t b) {
  constexpr uint32_t kTop = UINT32_C(1) << (bits - 1);
  const bool by8 = b < (kTop >> 7), by4 = (by8 ? b << 8 : b) < (kTop >> 3);
  uint32_t m = by8 ? b << 8 : b;
  m = by4 ? m << 4 : m;
  const bool by2 = m < (kTop >> 1);
  m = by2 ? m << 2 : m;
  const bool by1 = m < kTop;
  m = by1 ? m << 1 : m;
  uint32_t y = (a * inverse(m >> (bits - 16))) >> 15;
  y = by8 ? y << 8 : y;
  y = by4 ? y << 4 : y;
  y = by2 ? y << 2 : y;
  return by1 ? y << 1 : y;
}

}  // namespace dapple::base
