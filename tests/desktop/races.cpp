// Textures of every family on 1, 2, 3 and 8 threads, for a build under the thread sanitizer (tests/checks/threads.sh):
// it ends well if all have the same bytes, and the sanitizer saw no race.
// SPDX-License-Identifier: MIT
#include <cstdio>

#include "../grow.hpp"
#include "driver.hpp"
#include "tables.hpp"

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
  return wrong == 0 ? 0 : 1;
}
