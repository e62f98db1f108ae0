// What the AVR demo prints: seamless tiles in ten shades of ASCII, one after another in the same few hundred bytes. The same
// on a desktop, where tests compare the two.
// SPDX-License-Identifier: MIT
#pragma once
#include "tile.hpp"

namespace show {

constexpr uint16_t kSide = 64;  // pixels; a line of text stands for two rows, since letters are twice as high as wide

union Memory {
  dapple::Tile<dapple::presets::zebra_bits, kSide, kSide> zebra;
  dapple::Tile<dapple::presets::labyrinth_bits, kSide, kSide> labyrinth;
  dapple::Tile<dapple::presets::sand_bits, kSide, kSide> sand;
};

struct Inks {
  char letter[11];
};
constexpr Inks inks DAPPLE_ROM = {" .:-=+*#%@"};

// The field, -8000 .. 8000, as one of ten letters of growing ink.
inline char letter(int16_t value) {
  return dapple::base::rom_load(inks.letter + (static_cast<uint16_t>(value + 8000) >> 5) / 51);
}

template <class Tile> void print(Tile& tile, uint32_t seed, void (*put)(char)) {
  tile.begin(seed);
  tile.finish();
  for (uint16_t y = 0; y < kSide; y = static_cast<uint16_t>(y + 2)) {
    int16_t row[kSide];
    tile.row(y, row);
    for (const int16_t value : row) put(letter(value));
    put('\n');
  }
  put('\n');
}

// Every texture once.
inline void all(Memory& memory, uint32_t seed, void (*put)(char)) {
  print(memory.zebra, seed, put);
  print(memory.labyrinth, seed, put);
  print(memory.sand, seed, put);
}

}  // namespace show
