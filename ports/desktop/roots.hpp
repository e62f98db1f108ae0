// base::inverse_root of many numbers, as loops.
// SPDX-License-Identifier: MIT
#pragma once

namespace dapple::base {

// n at most 512; numbers below 2^28.
static void inverse_roots(const int32_t* DAPPLE_RESTRICT number, int32_t* DAPPLE_RESTRICT inverse, uint16_t n) {
  int32_t over[512], shift[512];
  for (uint16_t i = 0; i < n; ++i) {
    const int32_t x = number[i];
    const int32_t twos = (x >= (1 << 18)) + (x >= (1 << 20)) + (x >= (1 << 22)) + (x >= (1 << 24)) + (x >= (1 << 26));
    shift[i] = twos;
    over[i] = (x >> (2 * twos)) - 65536;
  }
  for (uint16_t i = 0; i < n; ++i) {
    const int32_t place = over[i] < 0 ? 0 : over[i] >> 12;
    const int32_t entry = kInverseRoots.entry[place], next = kInverseRoots.entry[place + 1];
    inverse[i] = over[i] < 0 ? 65535 : (entry - (((entry - next) * (over[i] & 4095)) >> 12)) >> shift[i];
  }
}

}  // namespace dapple::base
