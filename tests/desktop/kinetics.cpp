// Explicit kinetics by every table of ports/desktop, with and without its driver: tori and windows of odd widths, kept
// planes, compact cells, cascades, stretched stencils, any budget, the bytes of the portable kernels.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include "../grow.hpp"
#include "driver.hpp"
#include "each_table.hpp"

namespace desktop = dapple::desktop;

namespace {

constexpr uint32_t kSeed = 23;

const char* const kRecipes[] = {
    "turing scale=6 decay=12.1 steps=40",
    "turing scale=6 decay=12.1 vary=0.1 steps=40",
    "turing solver=pictured scale=9 vary=0.1 level=1 steps=9 then refine steps=15 then carry steps=20",
    "turing scale=6 stretch=2 angle=30 steps=20",
    "turing scale=6 cells=compact steps=40",
    "turing scale=6 cells=compact vary=0.1 steps=20",
    "turing scale=6 steps=30 then freeze above=4.1 reset=off scale=4.5 steps=40 then carry steps=9",
    "turing scale=6 vary=0.1 level=1 steps=30 then refine steps=9 then freeze above=4.1 steps=40",
    "meinhardt-spots scale=3.2 vary=0.1 steps=40",
    "meinhardt-spots scale=3.2 steps=40 then freeze above=0.2 steps=20",
    "meinhardt-spots scale=3.2 cells=compact steps=40",
    "meinhardt-stripes vary=0.1 steps=20 then freeze steps=9",
    "fitzhugh-nagumo stretch=2 angle=30 steps=40",
    "fitzhugh-nagumo vary=0.1 steps=40",
    "gray-scott steps=70",
    "gray-scott scale=0.55 feed=0.046 kill=0.063 start=noise steps=40",
    "schnakenberg steps=40",
    "schnakenberg vary=0.05 steps=20",
    "brusselator steps=40",
};

constexpr uint8_t kGrey[] = {0, 80, 200, 255, 30, 120};

// A recipe that grows by a picture has this one.
dapple::Recipe recipe_with(const char* text, const dapple::PlaceMaps& maps) {
  dapple::Recipe recipe = tests::recipe_of(text);
  for (uint8_t s = 0; s < recipe.stages; ++s)
    if (recipe.stage[s].solver == &dapple::evolve::pictured) recipe.stage[s].stored = &maps;
  return recipe;
}

// By the table with a driver of so many threads, or none.
uint64_t hash_by(const desktop::Table& table, const dapple::Recipe& recipe, const dapple::Domain& domain,
                 desktop::Driver* driver, uint8_t bands, uint32_t budget) {
  dapple::Options options;
  options.kernels = table.kernels;
  options.driver = driver;
  options.bands = bands;
  return tests::field_hash_of(recipe, domain, kSeed, options, budget);
}

}  // namespace

TEST_CASE("desktop kinetics: tori of odd sizes and windows, bands, budgets, drivers of 1, 2, 3 and 8 threads") {
  desktop::Driver one(1), two(2), three(3), eight(8);
  dapple::PlaceMaps maps{};
  maps.grey = {kGrey, 3, 2};
  for (const char* text : kRecipes) {
    const dapple::Recipe recipe = recipe_with(text, maps);
    CAPTURE(std::string(text));
    REQUIRE(recipe.stages > 0);
    for (const dapple::Domain& domain :
         {dapple::torus(38, 26), dapple::torus(66, 34), dapple::torus(131, 75), dapple::window(-71, 1003, 53, 21)}) {
      if (dapple::need_for(recipe, domain).status != dapple::ok) continue;
      CAPTURE(domain.width);
      const uint64_t want = tests::field_hash_of(recipe, domain, kSeed);
      REQUIRE(want != 0);
      tests::each_table([&](const desktop::Table& table) {
        CHECK(hash_by(table, recipe, domain, nullptr, 1, UINT32_MAX) == want);
        CHECK(hash_by(table, recipe, domain, nullptr, 3, 17) == want);
        for (const uint32_t budget : {UINT32_MAX, 200u, 30u})
          CHECK(hash_by(table, recipe, domain, &one, 1, budget) == want);
        CHECK(hash_by(table, recipe, domain, &two, 2, UINT32_MAX) == want);
        CHECK(hash_by(table, recipe, domain, &three, 3, 1000) == want);
        CHECK(hash_by(table, recipe, domain, &eight, 8, UINT32_MAX) == want);
      });
    }
  }
}

TEST_CASE("desktop kinetics: planes larger than what one thread does at once") {
  desktop::Driver three(3);
  const dapple::Domain domain = dapple::torus(421, 180);
  for (const char* text : {"turing scale=6 steps=5", "turing scale=6 vary=0.1 steps=3 then freeze above=4 steps=4"}) {
    const dapple::Recipe recipe = tests::recipe_of(text);
    const uint64_t want = tests::field_hash_of(recipe, domain, kSeed);
    REQUIRE(want != 0);
    CHECK(hash_by(desktop::best_table(), recipe, domain, &three, 3, UINT32_MAX) == want);
  }
}
