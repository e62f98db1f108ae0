// A search for programs that look nice, and not all alike.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "rule_score.hpp"
#include "rule_styles.hpp"

namespace cli {

// How often a 3 x 3 patch of each kind occurs, Q16; patches are one kind when turns, mirrors, or on for off lead from
// one to the other. 512 entries, of which those of the least patches of a kind are used.
using Patches = std::array<int32_t, 512>;

Patches patches_of(const Torus& torus);

// Half the sum of the differences, Q16: 0 alike, 65536 nothing in common.
int32_t distance_of(const Patches& a, const Patches& b);

struct Found {
  uint32_t program;
  Score score;
  Patches patches;
};

struct Search {
  Style style;
  uint32_t seed, count, steps;
  uint16_t width, height;
};

// The best first; fewer than count where the style has no more. Every program starts from noise of the same seed.
std::vector<Found> search_nice(const Search& search, const Report& report);

}  // namespace cli
