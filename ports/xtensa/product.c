/* Products of 64 bits and division of 32, which this machine's libgcc lacks or only builds upon.
   SPDX-License-Identifier: MIT */
#include <stdint.h>

/* Four products of 16 bits make one of 32. */
uint64_t __umulsidi3(uint32_t a, uint32_t b) {
  const uint32_t a0 = a & 0xffff, a1 = a >> 16, b0 = b & 0xffff, b1 = b >> 16;
  const uint32_t low = a0 * b0, cross = a1 * b0 + (low >> 16), other = a0 * b1 + (cross & 0xffff);
  const uint32_t high = a1 * b1 + (cross >> 16) + (other >> 16);
  return (uint64_t)high << 32 | (other << 16 | (low & 0xffff));
}

uint64_t __muldi3(uint64_t a, uint64_t b) {
  const uint32_t a0 = (uint32_t)a, a1 = (uint32_t)(a >> 32), b0 = (uint32_t)b, b1 = (uint32_t)(b >> 32);
  return __umulsidi3(a0, b0) + ((uint64_t)(a0 * b1 + a1 * b0) << 32);
}

static uint32_t divide(uint32_t number, uint32_t by, uint32_t *rest) {
  uint32_t quotient = 0, left = 0;
  for (int bit = 0; bit < 32; ++bit) {
    const uint32_t over = left >> 31;
    left = left << 1 | number >> 31;
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

uint32_t __udivsi3(uint32_t number, uint32_t by) {
  uint32_t rest;
  return divide(number, by, &rest);
}

uint32_t __umodsi3(uint32_t number, uint32_t by) {
  uint32_t rest;
  divide(number, by, &rest);
  return rest;
}

static uint32_t size_of(int32_t number) { return number < 0 ? 0u - (uint32_t)number : (uint32_t)number; }

int32_t __divsi3(int32_t number, int32_t by) {
  const uint32_t quotient = __udivsi3(size_of(number), size_of(by));
  return (int32_t)((number < 0) != (by < 0) ? 0u - quotient : quotient);
}

int32_t __modsi3(int32_t number, int32_t by) {
  const uint32_t rest = __umodsi3(size_of(number), size_of(by));
  return (int32_t)(number < 0 ? 0u - rest : rest);
}
