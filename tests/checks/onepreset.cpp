// Firmware that names one preset (ONE_PRESET): counts bytes at compile time, grows in slices, paints line by line.
// SPDX-License-Identifier: MIT
#include "dapple.hpp"

alignas(4) static uint8_t memory[dapple::bytes_for(dapple::presets::ONE_PRESET, dapple::torus(64, 64))];
static dapple::Texture tile;
volatile uint8_t panel;

extern "C" int main() {
  if (tile.begin(dapple::presets::ONE_PRESET, dapple::torus(64, 64), 7, memory, sizeof memory) != dapple::ok) return 1;
  while (tile.step(8) == dapple::more) {
  }
  for (uint16_t y = 0; y < 64; ++y) {
    uint8_t line[128];
    tile.paint(y, dapple::Pixels::rgb565_swapped, line);
    for (const uint8_t byte : line) panel = byte;
  }
  return 0;
}
