// The rounded high half of a product of 16 bits, in the form of which the compiler at hand makes the fewest instructions.
// SPDX-License-Identifier: MIT
#pragma once
#include "../../lib/base/fixed.hpp"

namespace dapple::stencil {

// floor(a b / 2^15 + 1/2), |a| < 2^14 and |b| < 2^14. gcc sees the one operation that AVX2 has for the first form; the
// second one is the product that lib/ has.
static inline int16_t rounded_product(int16_t a, int16_t b) {
#if DAPPLE_WIDE == 32 && !defined(__clang__)
  return static_cast<int16_t>((((static_cast<int32_t>(a) * b) >> 14) + 1) >> 1);
#else
  return static_cast<int16_t>((base::mulhi(static_cast<int16_t>(2 * a), static_cast<int16_t>(2 * b)) + 1) >> 1);
#endif
}

}  // namespace dapple::stencil
