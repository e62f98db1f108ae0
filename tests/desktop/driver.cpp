// The driver of ports/desktop: any number of threads, passes fused in cache, any budget, the same bytes.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "../goldens.hpp"
#include "driver.hpp"
#include "each_table.hpp"

namespace desktop = dapple::desktop;

namespace {

// Counts the steps that the driver was asked for, and those it did.
struct Counted : dapple::evolve::Driver {
  explicit Counted(unsigned threads)
      : dapple::evolve::Driver{[](dapple::evolve::Driver& self, dapple::evolve::Run& run, uint32_t rows) {
          Counted& c = static_cast<Counted&>(self);
          const uint32_t done = c.driver.step(c.driver, run, rows);
          ++c.asked;
          c.done += done > 0;
          return done;
        }},
        driver(threads) {}

  desktop::Driver driver;
  uint32_t asked = 0, done = 0;
};

constexpr uint32_t kSeed = 5;
}  // namespace

TEST_CASE("driver: every preset has its goldens on 1 and 2 threads, those of up to 500 steps on 3 and 8 too") {
  for (const unsigned threads : {1u, 2u, 3u, 8u}) {
    Counted driver(threads);
    for (const tests::Golden& g : tests::fewer_goldens()) {
      const dapple::Recipe recipe = tests::preset(g.name);
      if (threads > 2 && tests::runs_long(recipe)) continue;  // thousands of steps of more threads than processors
      const dapple::Domain domain = dapple::torus(static_cast<uint16_t>(g.width), static_cast<uint16_t>(g.height));
      dapple::Options options;
      options.bands = static_cast<uint8_t>(threads);
      options.driver = &driver;
      options.kernels = desktop::best_table().kernels;
      driver.asked = driver.done = 0;
      tests::Grown tile(recipe, domain, g.seed, UINT32_MAX, options);
      REQUIRE(tile.status == dapple::ok);
      CAPTURE(threads);
      CAPTURE(std::string(g.name));
      CHECK(driver.asked > 0);
      CHECK(driver.done == driver.asked);
      CHECK(tile.field_hash() == g.field);
    }
  }
}

TEST_CASE("driver: passes that reach round the torus, wide rows, few rows, budgets within a step") {
  desktop::Driver driver(2);
  const char* const recipes[] = {"threshold scale=2.2 stretch=2 angle=78 steps=3",
                                 "threshold scale=6 stretch=4 angle=33 steps=3",
                                 "threshold pairs=3 scale=3 stretch=3 angles=0,60,120 steps=3",
                                 "threshold scale=4 diffusion=isotropic steps=4",
                                 "threshold scale=3 stretch=5 angle=90 steps=3",
                                 "threshold scale=3 stretch=5 angle=0 steps=3",
                                 "mapped map=swirl scale=1.8 stretch=2 steps=2",
                                 "mapped pairs=2 map=two-angle scale=3 ratio=1.7 stretch=4 steps=2"};
  for (const char* text : recipes) {
    const dapple::Recipe recipe = tests::recipe_of(text);
    for (const tests::Size size :
         {tests::Size{400, 200}, tests::Size{201, 403}, tests::Size{4000, 210}, tests::Size{20000, 230}}) {
      const dapple::Domain domain = dapple::torus(size.width, size.height);
      if (dapple::need_for(recipe, domain).status != dapple::ok) continue;
      CAPTURE(std::string(text));
      CAPTURE(size.width);
      const uint64_t want = tests::field_hash_of(recipe, domain, kSeed);
      REQUIRE(want != 0);
      dapple::Options options;
      options.bands = 2;
      options.driver = &driver;
      for (const uint32_t budget : {UINT32_MAX, 100000u, 7000u})
        CHECK(tests::field_hash_of(recipe, domain, kSeed, options, budget) == want);
      options.kernels = desktop::best_table().kernels;
      CHECK(tests::field_hash_of(recipe, domain, kSeed, options) == want);
    }
  }
}

TEST_CASE("driver: many steps at once by every table, budgets of some steps") {
  desktop::Driver driver(1);
  for (const char* text :
       {"gray-scott feed=0.0367 kill=0.0649 steps=70", "cells rule=0xB5A3C96E steps=70", "bits level=0 steps=7"}) {
    const dapple::Recipe recipe = tests::recipe_of(text);
    for (const tests::Size size : {tests::Size{200, 96}, tests::Size{131, 77}, tests::Size{2000, 80}}) {
      const dapple::Domain domain = dapple::torus(size.width, size.height);
      CAPTURE(std::string(text));
      CAPTURE(size.width);
      const uint64_t want = tests::field_hash_of(recipe, domain, kSeed);
      REQUIRE(want != 0);
      tests::each_table([&](const desktop::Table& table) {
        dapple::Options options;
        options.kernels = table.kernels;
        options.driver = &driver;
        for (const uint32_t budget : {UINT32_MAX, 1000u, 50u})
          CHECK(tests::field_hash_of(recipe, domain, kSeed, options, budget) == want);
      });
    }
  }
}

TEST_CASE("driver: steps after one that changes nothing are left out, with the same bytes") {
  struct Settling {
    const char* text;
    uint32_t least;  // steps that are left out of one call
  };
  const Settling all[] = {{"cells rule=0xfee8e880 steps=2000", 1000},  // the majority of five
                          {"cells rule=0xfee8e880 steps=2001", 1000},
                          {"bits level=0 steps=600", 200},
                          {"bits level=0 rho=0:-0.05@0.2..0.5 steps=600", 150},
                          {"gray-scott feed=0.09 kill=0.07 steps=3000", 500}};
  for (const Settling& one : all) {
    const dapple::Recipe recipe = tests::recipe_of(one.text);
    const dapple::Domain domain = dapple::torus(96, 64);
    CAPTURE(std::string(one.text));
    const uint64_t want = tests::field_hash_of(recipe, domain, kSeed);
    REQUIRE(want != 0);
    for (const uint32_t budget : {UINT32_MAX, 64u * 40 + 3}) {
      desktop::Driver driver(1);
      dapple::Options options;
      options.kernels = desktop::best_table().kernels;
      options.driver = &driver;
      CHECK(tests::field_hash_of(recipe, domain, kSeed, options, budget) == want);
      if (budget == UINT32_MAX) CHECK(driver.left_out() >= one.least);
    }
  }
}

// What moves last is a few cells, now and then of those behind the last whole byte of a row alone.
TEST_CASE("driver: a cell that changes is seen wherever it is") {
  const dapple::Recipe recipe = tests::recipe_of("bits level=0 steps=90");
  const dapple::Domain domain = dapple::torus(71, 67);  // whichever way the grid is kept
  for (uint32_t seed = 0; seed < 150; ++seed) {
    desktop::Driver driver(1);
    dapple::Options options;
    options.kernels = desktop::best_table().kernels;
    options.driver = &driver;
    CAPTURE(seed);
    CHECK(tests::field_hash_of(recipe, domain, seed, options) == tests::field_hash_of(recipe, domain, seed));
  }
}

TEST_CASE("driver: masks along every direction, on tori and windows of any size, by every table, threads and budgets") {
  const char* const recipes[] = {"bits level=0 angle=90 steps=6 rho=0:0.1@0..0.5",
                                 "bits level=0 angle=2 steps=5",
                                 "bits level=0 angle=45 window=8 steps=5",
                                 "bits level=0 angle=-45 window=4 scale=5 steps=5",
                                 "bits level=0 diffusion=isotropic steps=5",
                                 "bits level=0 masks=2 angles=0,90 rho=0.15 steps=5",
                                 "bits level=0 masks=4 angles=0,45,90,135 window=7 rho=0.2 steps=4",
                                 "bits level=1 masks=5 angles=9,45,81,117,153 rho=0.27 steps=4",
                                 "bits level=0 masks=2 react=da angles=0,90 steps=4",
                                 "bits level=0 masks=3 angles=9,81,117 window=8 rho=0.27 steps=15",
                                 "bits level=0 masks=2 angles=20,120 solver=lean rho=0.15 steps=4"};
  desktop::Driver one(1), several[] = {desktop::Driver(2), desktop::Driver(3), desktop::Driver(8)};
  for (const char* text : recipes) {
    const dapple::Recipe recipe = tests::recipe_of(text);
    CAPTURE(std::string(text));
    for (const dapple::Domain& domain :
         {dapple::torus(64, 64), dapple::torus(66, 130), dapple::torus(200, 142), dapple::torus(512, 128),
          dapple::torus(322, 258), dapple::window(-77, 5001, 90, 60), dapple::window(12, -9, 8, 300)}) {
      CAPTURE(domain.width);
      CAPTURE(domain.height);
      const uint64_t want = tests::field_hash_of(recipe, domain, kSeed);
      REQUIRE(want != 0);
      dapple::Options options;
      tests::each_table(
          [&](const desktop::Table& table) {
            options.kernels = table.kernels;
            options.driver = &one;
            for (const uint32_t budget : {UINT32_MAX, 700u, 150u})
              CHECK(tests::field_hash_of(recipe, domain, kSeed, options, budget) == want);
          },
          1);
      for (desktop::Driver& driver : several) {
        options.driver = &driver;
        CHECK(tests::field_hash_of(recipe, domain, kSeed, options) == want);
      }
    }
  }
}

TEST_CASE("driver: a step that does not fit the budget is done row by row, and progress counts alike") {
  desktop::Driver driver(2);
  dapple::Options options;
  options.bands = 2;
  options.driver = &driver;
  const dapple::Recipe recipe = tests::preset_with("weave", "steps=4");
  tests::Grown driven(recipe, dapple::torus(96, 80), 5, UINT32_MAX, options),
      small(recipe, dapple::torus(96, 80), 5, 90, options);
  CHECK(driven.texture.rows_done() == driven.texture.rows_in_all());
  CHECK(small.texture.rows_done() == small.texture.rows_in_all());
  CHECK(driven.field_hash() == small.field_hash());
}

TEST_CASE("driver: windows, in blocks too") {
  desktop::Driver driver(3);
  dapple::Options options;
  options.bands = 3;
  options.driver = &driver;
  options.kernels = desktop::best_table().kernels;
  for (const char* name : {"zebra", "zebra-bits", "fingerprint", "coral-bits"}) {
    const dapple::Recipe recipe = dapple::load(*dapple::find_preset(name));
    const dapple::Domain domain = dapple::window(-70, 1000, 90, 60);
    CAPTURE(std::string(name));
    const uint64_t want = tests::field_hash_of(recipe, domain, kSeed);
    REQUIRE(want != 0);
    CHECK(tests::field_hash_of(recipe, domain, kSeed, options) == want);
  }
}

TEST_CASE("driver: rows that end with a step leave the next one to it, and a stamp may come between") {
  const dapple::Recipe recipe = tests::recipe_of("gray-scott feed=0.0367 kill=0.0649 steps=6");
  const dapple::Domain domain = dapple::torus(96, 80);
  std::vector<uint8_t> memory(dapple::bytes_for(recipe, domain));
  Counted counted(1);
  std::vector<int16_t> fields[2];
  for (const bool driven : {false, true}) {
    dapple::Options options;
    options.kernels = desktop::best_table().kernels;
    if (driven) options.driver = &counted;
    dapple::Texture texture;
    REQUIRE(texture.begin(recipe, domain, kSeed, memory.data(), memory.size(), options) == dapple::ok);
    CHECK(texture.step(2 * 80) == dapple::more);  // the start of two planes
    CHECK(texture.between_steps());
    for (const uint16_t radius : {3, 5}) {
      CHECK(texture.step(2 * 80) == dapple::more);
      CHECK(texture.between_steps());
      CHECK(texture.stamp(20, 30, radius, true) == dapple::ok);
    }
    texture.finish();
    fields[driven].resize(96 * 80);
    for (uint16_t y = 0; y < 80; ++y) texture.row(y, fields[driven].data() + 96 * y);
  }
  CHECK(fields[0] == fields[1]);
  CHECK(counted.asked == 3);
  CHECK(counted.done == 3);
}

TEST_CASE("driver: a step is counted with its last row, however the rows were asked for") {
  const dapple::Domain domain = dapple::torus(96, 80);
  const dapple::Recipe recipe = tests::recipe_of("gray-scott feed=0.0367 kill=0.0649 steps=6"),
                       half = tests::recipe_of("gray-scott feed=0.0367 kill=0.0649 steps=3");
  std::vector<uint8_t> memory(dapple::bytes_for(recipe, domain));
  Counted counted(1);
  for (const uint32_t budget : {1u, 7u, 80u, 160u}) {
    dapple::Options options;
    options.driver = &counted;
    dapple::Texture texture;
    REQUIRE(texture.begin(recipe, domain, kSeed, memory.data(), memory.size(), options) == dapple::ok);
    for (uint64_t left; (left = 5 * 80 - texture.rows_done()) > 0 && texture.steps_done() < 3;)
      texture.step(static_cast<uint32_t>(std::min<uint64_t>(budget, left)));
    CHECK(texture.rows_done() == 5 * 80);  // the start of two planes, three steps
    CHECK(texture.steps_done() == 3);
    CHECK(texture.between_steps());
    std::vector<int16_t> field(96 * 80);
    for (uint16_t y = 0; y < 80; ++y) texture.row(y, field.data() + 96 * y);
    CHECK(field == tests::Grown(half, domain, kSeed).field());
  }
}
