/* 64-bit division and shifts for little-endian machines of 32 bits whose compiler comes without a library of them.
   SPDX-License-Identifier: MIT */
#include <stdint.h>

typedef union {
  uint64_t whole;
  struct {
    uint32_t low, high;
  } half;
} Wide;

uint64_t __ashldi3(uint64_t value, int count) {
  Wide in = {value}, out;
  if (count == 0) return value;
  out.half.low = count < 32 ? in.half.low << count : 0;
  out.half.high = count < 32 ? in.half.high << count | in.half.low >> (32 - count) : in.half.low << (count - 32);
  return out.whole;
}

uint64_t __lshrdi3(uint64_t value, int count) {
  Wide in = {value}, out;
  if (count == 0) return value;
  out.half.high = count < 32 ? in.half.high >> count : 0;
  out.half.low = count < 32 ? in.half.low >> count | in.half.high << (32 - count) : in.half.high >> (count - 32);
  return out.whole;
}

int64_t __ashrdi3(int64_t value, int count) {
  const uint64_t flipped = value < 0 ? ~(uint64_t)value : (uint64_t)value;
  const uint64_t shifted = __lshrdi3(flipped, count);
  return (int64_t)(value < 0 ? ~shifted : shifted);
}

static uint64_t divide(uint64_t number, uint64_t by, uint64_t *rest) {
  uint64_t quotient = 0, left = 0;
  for (int bit = 0; bit < 64; ++bit) {
    const uint32_t over = (uint32_t)(left >> 63);
    left = left << 1 | number >> 63;
    number <<= 1;
    quotient <<= 1;
    if (over != 0 || left >= by) {
      left -= by;
      quotient |= 1;
    }
  }
  *rest = left;
  return quotient;
}

static uint64_t size_of(int64_t number) { return number < 0 ? UINT64_C(0) - (uint64_t)number : (uint64_t)number; }

uint64_t __udivdi3(uint64_t number, uint64_t by) {
  uint64_t rest;
  return divide(number, by, &rest);
}

uint64_t __umoddi3(uint64_t number, uint64_t by) {
  uint64_t rest;
  divide(number, by, &rest);
  return rest;
}

int64_t __divdi3(int64_t number, int64_t by) {
  const uint64_t quotient = __udivdi3(size_of(number), size_of(by));
  return (int64_t)((number < 0) != (by < 0) ? UINT64_C(0) - quotient : quotient);
}

int64_t __moddi3(int64_t number, int64_t by) {
  const uint64_t rest = __umoddi3(size_of(number), size_of(by));
  return (int64_t)(number < 0 ? UINT64_C(0) - rest : rest);
}
