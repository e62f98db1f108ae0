// Every preset has the bytes tests/golden/presets.txt says, whatever the budget and the number of bands.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <set>

#include "goldens.hpp"

namespace {

using tests::Golden;
using tests::read_goldens;

void check(const Golden& g, uint32_t budget, uint8_t bands) {
  const dapple::Recipe recipe = tests::preset(g.name);
  dapple::Options options;
  options.bands = bands;
  tests::Grown tile(recipe, dapple::torus(static_cast<uint16_t>(g.width), static_cast<uint16_t>(g.height)), g.seed, budget, options);
  REQUIRE(tile.status == dapple::ok);
  char line[160];
  std::snprintf(line, sizeof line, "%s %ux%u %u %016" PRIx64 " %016" PRIx64, g.name, g.width, g.height, g.seed, tile.field_hash(), tile.paint_hash());
  INFO("now: " << line << "  (budget " << budget << ", bands " << int(bands) << ")");
  CHECK(tile.field_hash() == g.field);
  CHECK(tile.paint_hash() == g.pixels);
}

}  // namespace

TEST_CASE("golden: every preset has its lines, and no others") {
  std::set<std::string> wanted, found;
  for (uint16_t i = 0; i < dapple::preset_count(); ++i) {
    char name[dapple::kMaxName];
    const dapple::Recipe recipe = dapple::load(*dapple::preset_at(i, name).preset);
    for (const tests::Size any : tests::kGoldenSizes) {
      const tests::Size size = tests::fitting(any, recipe);
      wanted.insert(std::string(name) + " " + std::to_string(size.width) + "x" + std::to_string(size.height));
    }
  }
  for (const Golden& g : read_goldens()) found.insert(std::string(g.name) + " " + std::to_string(g.width) + "x" + std::to_string(g.height));
  CHECK(wanted == found);
}

TEST_CASE("golden: one call") {
  for (const Golden& g : read_goldens()) check(g, UINT32_MAX, 1);
}

TEST_CASE("golden: one row at a time") {
  for (const Golden& g : tests::fewer_goldens()) check(g, 1, 1);
}

TEST_CASE("golden: seven rows at a time, three bands") {
  for (const Golden& g : tests::fewer_goldens()) check(g, 7, 3);
}
