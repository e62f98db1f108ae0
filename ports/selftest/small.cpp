// The self-test of machines with 2 KB of RAM: tiles, one after another in the same memory, as lines of
// tests/golden/targets.txt. The deepest stack is not told here; whoever runs it watches.
// SPDX-License-Identifier: MIT
#include "say.hpp"
#include "tile.hpp"

extern "C" {
void host_put(char c);
int main();
}

namespace {

using namespace selftest_say;
using dapple::Pixels;
namespace presets = dapple::presets;

constexpr uint32_t kSeed = 7;

union Memory {
  dapple::Tile<presets::zebra_bits, 64, 64> zebra;
  dapple::Tile<presets::weave_bits, 64, 64> weave;
};
Memory memory;

template <class Tile> DAPPLE_APART void grow(Tile& tile, const char* name) {
  int16_t row[64];
  bool flat = false;
  tile.begin(kSeed);
  tile.finish();
  const uint64_t field = hash_of_field(tile, 64, 64, row, flat);
  tell(host_put, {name, flat ? " is flat" : "", 64, 64, kSeed, field});
  uint8_t* const line = reinterpret_cast<uint8_t*>(row);
  uint64_t pixels = kFirstHash;
  for (uint16_t y = 0; y < 64; ++y) {
    tile.template paint<Pixels::rgb565_swapped>(y, line);
    for (uint8_t x = 0; x < 128; ++x) add_byte(pixels, line[x]);
  }
  tell(host_put, {name, "/rgb565", 64, 64, kSeed, pixels});
}

}  // namespace

int main() {
  grow(memory.zebra, "zebra-bits/stored");
  grow(memory.weave, "weave-bits/stored");
  return 0;
}
