// Firmware that grows one texture, zebra-bits on 64 x 64 cells, and sends it to a panel twice: at one bit a pixel, then as
// rgb565. Its flash, static RAM and deepest stack are those of the library's table; what it sends is compared.
// SPDX-License-Identifier: MIT
#include "dapple.hpp"

extern "C" {
void host_put(char c);
int main();
}

namespace {

constexpr uint16_t kSide = 64;
constexpr uint32_t kSeed = 7;

// What is grown, and by what. To grow it by something else with the same calls is to change these lines.
constexpr auto masks DAPPLE_ROM = dapple::stored_masks<1>(dapple::presets::zebra_bits);
constexpr dapple::Fixed fixed DAPPLE_ROM =
    dapple::fixed(dapple::presets::zebra_bits, masks, dapple::torus(kSide, kSide), true);
alignas(4) uint8_t memory[fixed.need.bytes];
dapple::Texture tile;
bool begin() { return tile.begin(fixed, kSeed, memory, sizeof memory) == dapple::ok; }

void send(dapple::Pixels format) {
  uint8_t line[2 * kSide];
  const uint16_t bytes = static_cast<uint16_t>(dapple::pixel_bytes(format, kSide));
  for (uint16_t y = 0; y < kSide; ++y) {
    tile.paint(y, format, line);
    for (uint16_t i = 0; i < bytes; ++i) host_put(static_cast<char>(line[i]));
  }
}

}  // namespace

int main() {
  if (!begin()) return 1;
  while (tile.step(8) == dapple::more) {
  }
  send(dapple::Pixels::l1_msb);
  send(dapple::Pixels::rgb565_swapped);
  return 0;
}
