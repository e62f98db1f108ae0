// Table for inverse_root.
// SPDX-License-Identifier: MIT
#include "math.hpp"

namespace dapple::base {

// entry[i] == floor(2^24 / sqrt(2^16 + 2^12 i)), i = 0..48, the first one less to fit.
struct InverseRoots {
  uint16_t entry[49];
};
static constexpr InverseRoots make_inverse_roots() {
  InverseRoots table{};
  for (uint8_t i = 0; i < 49; ++i) {
    const uint32_t root = square_root64((UINT64_C(1) << 48) / ((UINT32_C(1) << 16) + (static_cast<uint32_t>(i) << 12)));
    table.entry[i] = static_cast<uint16_t>(root > 65535 ? 65535 : root);
  }
  return table;
}
static constexpr InverseRoots kInverseRoots DAPPLE_ROM = make_inverse_roots();
static_assert(make_inverse_roots().entry[48] == 32768 && make_inverse_roots().entry[20] == 43690, "16-bit int spoils a table quietly");

uint16_t inverse_root(uint32_t n) {
  if (n < UINT32_C(65536)) return 65535;
  uint8_t shift = 0;
  while (n >= (UINT32_C(1) << 18)) {
    n >>= 2;
    ++shift;
  }
  const uint32_t over = n - (UINT32_C(1) << 16);
  const uint8_t i = static_cast<uint8_t>(over >> 12);
  const uint32_t a = rom_load(&kInverseRoots.entry[i]), b = rom_load(&kInverseRoots.entry[i + 1]);
  return static_cast<uint16_t>((a - (((a - b) * (over & 4095)) >> 12)) >> shift);
}

}  // namespace dapple::base
