// Textures of every family, and chunks of the plane, on 1, 2, 3 and 8 threads, for a build under the thread sanitizer
// (tests/checks/threads.sh): it ends well if all have the same bytes, and the sanitizer saw no race.
// SPDX-License-Identifier: MIT
#include <cstdio>

#include "../grow.hpp"
#include "growers.hpp"
#include "tables.hpp"

static uint64_t hash_of_chunks(const dapple::Recipe& recipe, unsigned threads) {
  constexpr uint16_t kSide = 64, kSlots = 12;
  const dapple::Brush brush;
  std::vector<uint8_t> memory(dapple::chunk_bytes(recipe, kSide, kSlots, brush.format));
  dapple::Options options;
  options.kernels = dapple::desktop::best_table().kernels;
  dapple::Chunks chunks;
  if (chunks.begin(recipe, 3, kSide, kSlots, brush, memory.data(), memory.size(), options) != dapple::ok) return 0;
  dapple::desktop::Growers growers(threads);
  growers.begin(chunks);
  chunks.look_at(-70, -10, 200, 130);
  growers.grow();
  tests::Fnv fnv;
  for (int32_t cy = chunks.sight().top; cy <= chunks.sight().bottom; ++cy)
    for (int32_t cx = chunks.sight().left; cx <= chunks.sight().right; ++cx)
      for (size_t i = 0; i < kSide * chunks.line_bytes(); ++i) fnv.byte(chunks.pixels(cx, cy)[i]);
  return fnv.value;
}

int main() {
  const char* const recipes[] = {"threshold pairs=2 scale=1.9 stretch=3 steps=4",
                                 "gray-scott steps=20",
                                 "bits masks=2 steps=5",
                                 "bits masks=4 angles=0,45,90,135 level=0 rho=0.2 steps=4",
                                 "flow steps=3",
                                 "cells rule=0xB5A3C96E steps=12",
                                 "mapped map=swirl scale=1.8 stretch=2 steps=2",
                                 "mapped pairs=2 map=two-angle scale=1.8 stretch=3 steps=1",
                                 "turing steps=12",
                                 "turing scale=6 vary=0.1 steps=9 then freeze above=4.1 steps=9",
                                 "meinhardt-stripes steps=6",
                                 "fitzhugh-nagumo stretch=2 angle=30 steps=8"};
  int wrong = 0;
  for (const char* text : recipes) {
    uint64_t want = 0;
    for (const unsigned threads : {1u, 2u, 3u, 8u}) {
      dapple::desktop::Driver driver(threads);
      dapple::Options options;
      options.bands = static_cast<uint8_t>(threads);
      options.driver = &driver;
      options.kernels = dapple::desktop::best_table().kernels;
      const uint64_t hash = tests::field_hash_of(tests::recipe_of(text), dapple::torus(160, 128), 3, options);
      if (threads == 1) want = hash;
      if (hash == want && want != 0) continue;
      ++wrong;
      std::printf("%s on %u threads: other bytes than on one, or refused\n", text, threads);
    }
  }
  for (const char* text :
       {"bits masks=3 angles=0,45,90 rho=0.2 steps=4", "flow steps=2", "cells rule=0xB5A3C96E steps=5"})
    for (const unsigned threads : {2u, 3u, 8u}) {
      const dapple::Recipe recipe = tests::recipe_of(text);
      const uint64_t want = hash_of_chunks(recipe, 1);
      if (want != 0 && hash_of_chunks(recipe, threads) == want) continue;
      ++wrong;
      std::printf("chunks of %s on %u threads: other bytes than on one, or refused\n", text, threads);
    }
  return wrong == 0 ? 0 : 1;
}
