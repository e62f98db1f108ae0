// Firmware that grows one texture, zebra-bits on 64 x 64 cells, and sends it to a panel twice: at one bit a pixel, then as
// rgb565. Its flash, static RAM and deepest stack are those of the library's table; what it sends is compared.
// SPDX-License-Identifier: MIT
#include "tile.hpp"

extern "C" {
void host_put(char c);
int main();
}

namespace {

constexpr uint16_t kSide = 64;
dapple::Tile<dapple::presets::zebra_bits, kSide, kSide> tile;

template <dapple::Pixels format> void send() {
  uint8_t line[dapple::pixel_bytes(format, kSide)];
  for (uint16_t y = 0; y < kSide; ++y) {
    tile.paint<format>(y, line);
    for (const uint8_t byte : line) host_put(static_cast<char>(byte));
  }
}

}  // namespace

int main() {
  tile.begin(7);
  while (tile.step(8) == dapple::more) {
  }
  send<dapple::Pixels::l1_msb>();
  send<dapple::Pixels::rgb565_swapped>();
  return 0;
}
