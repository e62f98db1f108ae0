// What a Tile costs from its start to its last step, and its rows as pixels, between calls of `mark`: one of 64 x 64, and two
// for a display of 128 x 64, at half and at full resolution. Said and counted like work.cpp.
// SPDX-License-Identifier: MIT
#include "tile.hpp"
#include "marks.hpp"

namespace {

using dapple::Pixels;

constexpr dapple::Preset sharp DAPPLE_ROM =
    dapple::recipe::preset("bits window=6 scale=9 stretch=3 angle=78.540844 level=0 steps=8 ramp=zebra range=-0.95,0.95");

union Memory {
  dapple::Tile<dapple::presets::zebra_bits, 64, 64> tile;
  dapple::Tile<dapple::presets::zebra_bits, 128, 64> display;
  dapple::Tile<sharp, 128, 64> sharp_display;
};
Memory memory;

template <Pixels format, class Tile> void paint(Tile& tile, uint16_t width, uint8_t* line, uint32_t* hash) {
  for (uint16_t y = 0; y < 64; ++y) {
    tile.template paint<format>(y, line);
    for (uint16_t i = 0; hash != nullptr && i < dapple::pixel_bytes(format, width); ++i) add(*hash, line[i]);
  }
}

template <class Tile> DAPPLE_APART void measure(const char* name, Tile& tile, uint16_t width, uint32_t updates) {
  uint8_t line[2 * 128];
  mark();
  tile.begin(7);
  tile.finish();
  mark();
  mark();
  paint<Pixels::l1_msb>(tile, width, line, nullptr);
  mark();
  paint<Pixels::rgb565_swapped>(tile, width, line, nullptr);
  mark();
  uint32_t hash = kFirst;
  paint<Pixels::l1_msb>(tile, width, line, &hash);
  paint<Pixels::rgb565_swapped>(tile, width, line, &hash);
  say(name, updates, UINT32_C(64) * width, hash);
}

}  // namespace

int main() {
  measure("tile", memory.tile, 64, UINT32_C(32) * 32 * 8);
  measure("display", memory.display, 128, UINT32_C(64) * 32 * 8);
  measure("sharp-display", memory.sharp_display, 128, UINT32_C(128) * 64 * 8);
  return 0;
}
