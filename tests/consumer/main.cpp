// Grows two different textures at once on two threads and compares them with the same two grown one after the other.
// SPDX-License-Identifier: MIT
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <thread>
#include <vector>

#include "dapple.hpp"
#include "recipe/list.hpp"

namespace {

// FNV-1a, 64 bit, over the field's values as four little-endian bytes each: what `dapple grow --hash` prints.
uint64_t hash_of(dapple::Texture& tile) {
  uint64_t hash = UINT64_C(0xcbf29ce484222325);
  std::vector<int16_t> line(tile.domain().width);
  for (uint16_t y = 0; y < tile.domain().height; ++y) {
    tile.row(y, line.data());
    for (const int16_t value : line)
      for (int shift = 0; shift < 32; shift += 8)
        hash = (hash ^ ((static_cast<uint32_t>(int32_t{value}) >> shift) & 255u)) * UINT64_C(0x100000001b3);
  }
  return hash;
}

// 0 if it cannot be grown.
uint64_t grown(const char* recipe_text, uint32_t seed, uint32_t budget) {
  dapple::Recipe recipe{};
  dapple::Trouble trouble{};
  if (dapple::parse(recipe_text, recipe, trouble) != dapple::ok) return 0;
  const dapple::Domain domain = dapple::torus(96, 96);
  std::vector<uint8_t> memory(dapple::bytes_for(recipe, domain));
  dapple::Texture tile;
  if (tile.begin(recipe, domain, seed, memory.data(), memory.size()) != dapple::ok) return 0;
  while (tile.step(budget) == dapple::more) {
  }
  return hash_of(tile);
}

}  // namespace

int main() {
  const char* const weave = "threshold pairs=2 react=md scale=1.9 stretch=3 angle=0 rho=0.02 steps=32";
  const char* const spots = "gray-scott feed=0.03 kill=0.062 steps=2000";
  const uint64_t alone[2] = {grown(weave, 7, UINT32_MAX), grown(spots, 8, UINT32_MAX)};
  uint64_t together[2] = {};
  std::thread first([&] { together[0] = grown(weave, 7, 3); });
  std::thread second([&] { together[1] = grown(spots, 8, 5); });
  first.join();
  second.join();
  const bool equal = alone[0] != 0 && alone[1] != 0 && alone[0] == together[0] && alone[1] == together[1];
  std::printf("weave %016" PRIx64 "  spots %016" PRIx64 "\n", together[0], together[1]);
  if (!equal) std::printf("one after the other: weave %016" PRIx64 "  spots %016" PRIx64 "\n", alone[0], alone[1]);
  return equal ? 0 : 1;
}
