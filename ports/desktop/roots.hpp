// base::inverse_root of many numbers, as loops.
// SPDX-License-Identifier: MIT
#pragma once

namespace dapple::base {

// Entries of the table and how much the next one is less, in the upper and the lower half.
struct RootSteps {
  uint32_t step[48];
};
static constexpr RootSteps make_root_steps() {
  const InverseRoots roots = make_inverse_roots();
  RootSteps steps{};
  for (uint8_t i = 0; i < 48; ++i)
    steps.step[i] = static_cast<uint32_t>(roots.entry[i]) << 16 | (roots.entry[i] - roots.entry[i + 1]);
  return steps;
}
static constexpr RootSteps kRootSteps = make_root_steps();

// n at most 512; numbers below 2^28. They are brought to 2^16 .. 2^18 by three shifts at most. Loops by themselves, or
// compilers see that what they choose hangs together, and take branches.
static void inverse_roots(const int32_t* DAPPLE_RESTRICT number, int32_t* DAPPLE_RESTRICT inverse, uint16_t n) {
  int32_t over[512], step[512];
  for (uint16_t i = 0; i < n; ++i) {
    int32_t x = number[i];
    x = x < (1 << 24) ? x : x >> 8;
    x = x < (1 << 20) ? x : x >> 4;
    x = x < (1 << 18) ? x : x >> 2;
    over[i] = max(x - 65536, 0);
  }
  for (uint16_t i = 0; i < n; ++i) step[i] = static_cast<int32_t>(kRootSteps.step[over[i] >> 12]);
  for (uint16_t i = 0; i < n; ++i) {
    const int32_t high = (step[i] >> 16) & 65535, low = step[i] & 65535;
    inverse[i] = high - ((low * (over[i] & 4095)) >> 12);
  }
  for (uint16_t i = 0; i < n; ++i) {
    const int32_t x = number[i], y = x < (1 << 24) ? x : x >> 8, z = y < (1 << 20) ? y : y >> 4;
    int32_t root = inverse[i];
    root = x < (1 << 24) ? root : root >> 4;
    root = y < (1 << 20) ? root : root >> 2;
    inverse[i] = z < (1 << 18) ? root : root >> 1;
  }
}

}  // namespace dapple::base
