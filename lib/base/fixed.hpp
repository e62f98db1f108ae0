// Fixed-point helpers: every shift, product and division that rounds is one of these. docs/numbers.md is the contract.
// SPDX-License-Identifier: MIT
#pragma once
#include "port.hpp"

namespace dapple::base {

static_assert((-1 >> 1) == -1, "right shift of a negative value must be arithmetic");
static_assert(sizeof(int16_t) == 2 && sizeof(int32_t) == 4, "two's complement integers of exact width");

// Recipe numbers are decimal: 1.0 == kMicro.
constexpr int32_t kMicro = 1000000;

// mulhi(a, b) == floor(a * b / 65536); a, b int16. One instruction on SSE2, NEON and most cores with a multiplier.
constexpr int16_t mulhi(int16_t a, int16_t b) { return static_cast<int16_t>((static_cast<int32_t>(a) * b) >> 16); }

// rounding_for(w): the constant r that, added before mulhi(d + r, w), makes the product round to nearest on average;
// r == floor((32768 + w/2) / w) for an even weight 64 <= w <= 32766. r * w < 65536, so mulhi(0 + r, w) == 0.
constexpr int16_t rounding_for(int16_t w) {
  return static_cast<int16_t>((INT32_C(32768) + w / 2) / w);
}

// divide_round(a, b) == floor(a / b + 1/2), b > 0: half up for both signs.
constexpr int64_t divide_round(int64_t a, int64_t b) {
  const int64_t doubled = 2 * a + b;
  const int64_t quotient = doubled / (2 * b);
  return doubled < 0 && quotient * 2 * b != doubled ? quotient - 1 : quotient;
}

constexpr int32_t min(int32_t a, int32_t b) { return a < b ? a : b; }
constexpr int32_t max(int32_t a, int32_t b) { return a > b ? a : b; }
constexpr int32_t clamp(int32_t x, int32_t low, int32_t high) { return x < low ? low : x > high ? high : x; }

// Greatest common divisor; gcd(0, n) == n.
constexpr uint16_t gcd(uint16_t a, uint16_t b) {
  while (a != 0) {
    const uint16_t rest = static_cast<uint16_t>(b % a);
    b = a;
    a = rest;
  }
  return b;
}

// Adds count * each to total; false (total untouched) when the sum would not fit size_t.
constexpr bool add_bytes(size_t& total, size_t count, size_t each) {
  if (each != 0 && count > (SIZE_MAX - total) / each) return false;
  total += count * each;
  return true;
}

}  // namespace dapple::base
