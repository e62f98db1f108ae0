// A search for programs that look nice, and not all alike.
// SPDX-License-Identifier: MIT
#include "rule_search.hpp"

#include <algorithm>
#include <set>

#include "grid/rows.hpp"

namespace cli {

// Bit 3 row + column of a patch.
static unsigned turned(unsigned patch) {
  unsigned result = 0;
  for (unsigned i = 0; i < 9; ++i) result |= (patch >> i & 1) << (3 * (i % 3) + 2 - i / 3);
  return result;
}
static unsigned mirrored(unsigned patch) { return (patch & 0111) << 2 | (patch & 0222) | (patch & 0444) >> 2; }

static std::array<uint16_t, 512> make_kinds() {
  std::array<uint16_t, 512> kinds{};
  for (unsigned patch = 0; patch < 512; ++patch) {
    unsigned least = patch, p = patch;
    for (int way = 0; way < 8; ++way) {
      p = way == 4 ? mirrored(p) : turned(p);
      least = std::min({least, p, p ^ 511u});
    }
    kinds[patch] = static_cast<uint16_t>(least);
  }
  return kinds;
}

Patches patches_of(const Torus& torus) {
  static const std::array<uint16_t, 512> kinds = make_kinds();
  std::array<uint64_t, 512> counts{};
  const uint16_t width = torus.width(), height = torus.height();
  for (uint16_t y = 0; y < height; ++y) {
    const uint8_t* const rows[3] = {torus.row(static_cast<uint16_t>((y + height - 1u) % height)), torus.row(y),
                                    torus.row(static_cast<uint16_t>((y + 1u) % height))};
    const auto column = [&](uint32_t x) {  // of the patch's three rows, the bits 0, 3 and 6
      unsigned bits = 0;
      for (unsigned i = 0; i < 3; ++i)
        bits |= static_cast<unsigned>(dapple::grid::get_bit(rows[i], static_cast<int32_t>(x))) << 3 * i;
      return bits;
    };
    unsigned patch = column(width - 1u) << 1 | column(0) << 2;
    for (uint32_t x = 0; x < width; ++x) {
      patch = (patch >> 1 & 0333) | column((x + 1) % width) << 2;
      ++counts[kinds[patch]];
    }
  }
  Patches patches{};
  for (unsigned i = 0; i < 512; ++i) patches[i] = static_cast<int32_t>(counts[i] * kOne / torus.cells());
  return patches;
}

int32_t distance_of(const Patches& a, const Patches& b) {
  int32_t sum = 0;
  for (unsigned i = 0; i < 512; ++i) sum += std::max(a[i] - b[i], b[i] - a[i]);
  return sum / 2;
}

// The nice ones among the first programs of the style, no two of them turned, mirrored or inverted.
static std::vector<Found> nice_ones(const Search& search, const Report& report) {
  constexpr uint64_t kTries = 256, kEnough = 12;  // for each one wanted
  std::vector<Found> nice;
  std::set<uint32_t> seen;
  Torus start(search.width, search.height);
  start.noise(search.seed);
  for (uint64_t i = 0; i < kTries * search.count && nice.size() < kEnough * search.count; ++i) {
    const uint32_t program = random_program(search.style, search.seed, static_cast<uint32_t>(i));
    if (!seen.insert(representative(program)).second) continue;
    if (report) report(nice.size(), kEnough * search.count);
    Torus torus = start;
    const Settled settled = run(torus, program, search.steps);
    const Score score = score_of(torus, program, settled);
    if (score.nice) nice.push_back({program, score, patches_of(torus)});
  }
  return nice;
}

std::vector<Found> search_nice(const Search& search, const Report& report) {
  std::vector<Found> nice = nice_ones(search, report), chosen;
  std::stable_sort(nice.begin(), nice.end(),
                   [](const Found& a, const Found& b) { return a.score.total > b.score.total; });
  // Different ones first, and less different ones as long as there are not enough.
  std::vector<bool> taken(nice.size());
  for (int32_t apart = kOne / 2; apart > 0 && chosen.size() < search.count; apart -= kOne / 16)
    for (size_t i = 0; i < nice.size() && chosen.size() < search.count; ++i) {
      const auto near = [&](const Found& other) { return distance_of(nice[i].patches, other.patches) < apart; };
      if (taken[i] || std::any_of(chosen.begin(), chosen.end(), near)) continue;
      taken[i] = true;
      chosen.push_back(nice[i]);
    }
  std::stable_sort(chosen.begin(), chosen.end(),
                   [](const Found& a, const Found& b) { return a.score.total > b.score.total; });
  return chosen;
}

}  // namespace cli
