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

// Whole groups of eight numbers below 2^28. They are brought to 2^16 .. 2^18 by three shifts at most; what they are
// before and between them says how far the root is to go back.
static void inverse_roots(const int32_t* DAPPLE_RESTRICT number, int32_t* DAPPLE_RESTRICT inverse, uint32_t groups) {
  for (uint32_t i = 0; i < 8 * groups; ++i) {
    const int32_t x = number[i], y = x < (1 << 24) ? x : x >> 8, z = y < (1 << 20) ? y : y >> 4;
    const int32_t over = max((z < (1 << 18) ? z : z >> 2) - 65536, 0);
    const int32_t step = static_cast<int32_t>(kRootSteps.step[over >> 12]), entry = (step >> 16) & 65535;
    int32_t root = entry - (((step & 65535) * (over & 4095)) >> 12);
    root = x < (1 << 24) ? root : root >> 4;
    root = y < (1 << 20) ? root : root >> 2;
    inverse[i] = z < (1 << 18) ? root : root >> 1;
  }
}

}  // namespace dapple::base
