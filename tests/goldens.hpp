// The committed hashes of every preset.
// SPDX-License-Identifier: MIT
#pragma once
#include <doctest/doctest.h>

#include <cinttypes>
#include <cstdio>
#include <fstream>
#include <string>

#include "grow.hpp"

namespace tests {

struct Golden {
  char name[64];
  unsigned width, height, seed;
  uint64_t field, pixels;
};

inline std::vector<Golden> read_goldens() {
  std::vector<Golden> all;
  std::ifstream in(DAPPLE_GOLDEN_DIR "/presets.txt");
  for (std::string line; std::getline(in, line);) {
    Golden g{};
    const int read = std::sscanf(line.c_str(), "%63s %ux%u %u %" SCNx64 " %" SCNx64, g.name, &g.width, &g.height,
                                 &g.seed, &g.field, &g.pixels);
    REQUIRE_MESSAGE(read == 6, "broken golden line: " << line);
    all.push_back(g);
  }
  return all;
}

inline bool runs_long(const dapple::Recipe& recipe) { return recipe.stage[0].steps > 500; }

// All sizes of every preset, but of those that run long the last one alone.
inline std::vector<Golden> fewer_goldens() {
  const std::vector<Golden> all = read_goldens();
  std::vector<Golden> some;
  for (size_t i = 0; i < all.size(); ++i) {
    const bool last = i + 1 == all.size() || std::string(all[i].name) != all[i + 1].name;
    if (last || !runs_long(preset(all[i].name))) some.push_back(all[i]);
  }
  return some;
}

}  // namespace tests
