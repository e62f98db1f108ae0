// Chunks of the plane on several threads: the same bytes, in the same slots, as by Chunks::step.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstring>
#include <vector>

#include "../grow.hpp"
#include "each_table.hpp"
#include "growers.hpp"
#include "ready.hpp"

namespace desktop = dapple::desktop;

namespace {

constexpr uint32_t kSeed = 77;
constexpr uint16_t kSlots = 14;

struct Cache {
  dapple::Chunks chunks;
  std::vector<uint8_t> memory;

  Cache(const dapple::Recipe& recipe, uint16_t side, const dapple::Brush& brush, bool fast) {
    dapple::Options options;
    if (fast) options.kernels = desktop::best_table().kernels;
    memory.resize(dapple::chunk_bytes(recipe, side, kSlots, brush.format));
    REQUIRE(chunks.begin(recipe, kSeed, side, kSlots, brush, memory.data(), memory.size(), options) == dapple::ok);
  }
};

// Everything in sight, and what is left of what was in sight before; and how it came there.
void check_same(const Cache& a, const Cache& b, const dapple::Brush& brush) {
  const uint16_t side = a.chunks.side();
  const size_t bytes =
      dapple::pixel_bytes(brush.format, side) * (brush.format == dapple::Pixels::l1_pages ? side / 8u : side);
  for (int32_t cy = -4; cy < 8; ++cy)
    for (int32_t cx = -4; cx < 8; ++cx) {
      const uint8_t *one = a.chunks.pixels(cx, cy), *other = b.chunks.pixels(cx, cy);
      CHECK((one == nullptr) == (other == nullptr));
      if (one == nullptr || other == nullptr) continue;
      CHECK(std::memcmp(one, other, bytes) == 0);
      CHECK(one - a.memory.data() == other - b.memory.data());
    }
  CHECK(a.chunks.counters().grown == b.chunks.counters().grown);
  CHECK(a.chunks.counters().evicted == b.chunks.counters().evicted);
  CHECK(a.chunks.counters().bytes == b.chunks.counters().bytes);
}

struct View {
  int32_t x, y;
};
constexpr View kViews[] = {{0, 0}, {40, 100}, {90, -60}, {0, 0}};

}  // namespace

TEST_CASE("growers: chunks on any number of threads have the bytes, and the slots, of chunks by steps") {
  const dapple::Brush brushes[] = {{dapple::View::colour, dapple::Pixels::rgb565},
                                   {dapple::View::colour, dapple::Pixels::l1_pages}};
  for (const char* text : {"bits steps=6", "bits masks=3 angles=0,45,90 steps=5 rho=0.2", "flow steps=3",
                           "cells rule=0xfee8e880 steps=4", "threshold scale=2 stretch=2 steps=14"}) {
    const dapple::Recipe recipe = tests::recipe_of(text);
    CAPTURE(std::string(text));
    for (const dapple::Brush& brush : brushes)
      for (const unsigned threads : {1u, 2u, 3u, 8u}) {
        CAPTURE(threads);
        Cache stepped(recipe, 64, brush, false), grown(recipe, 64, brush, true);
        desktop::Growers growers(threads);
        growers.begin(grown.chunks);
        for (const View& view : kViews) {
          REQUIRE(stepped.chunks.look_at(view.x, view.y, 120, 90) == dapple::ok);
          REQUIRE(grown.chunks.look_at(view.x, view.y, 120, 90) == dapple::ok);
          stepped.chunks.finish();
          const uint32_t missing = grown.chunks.missing();
          CHECK(growers.grow() == missing);
          CHECK(grown.chunks.missing() == 0);
          check_same(stepped, grown, brush);
        }
      }
  }
}

TEST_CASE("growers: some at a time, the nearest first; none while a step is in the midst of one") {
  const dapple::Recipe recipe = tests::recipe_of("bits steps=4");
  Cache cache(recipe, 64, {dapple::View::colour, dapple::Pixels::l8}, true);
  desktop::Growers growers(2);
  growers.begin(cache.chunks);
  CHECK(growers.grow() == 0);
  REQUIRE(cache.chunks.look_at(0, 0, 192, 192) == dapple::ok);
  REQUIRE(cache.chunks.missing() == 9);
  CHECK(growers.grow(1) == 1);
  CHECK(cache.chunks.pixels(1, 1) != nullptr);
  CHECK(growers.grow(0) == 0);
  CHECK(growers.grow(3) == 3);
  CHECK(cache.chunks.missing() == 5);
  CHECK(cache.chunks.step(1) == dapple::more);
  CHECK(growers.grow() == 0);
  while (cache.chunks.counters().grown == 4) cache.chunks.step(1);
  CHECK(growers.grow() == 4);
  CHECK(cache.chunks.missing() == 0);
  CHECK(cache.chunks.counters().grown == 9);
}

TEST_CASE("ready: masks made once, the same bytes by every table, with a driver and without, in any budget") {
  desktop::Driver driver(1);
  for (const char* text : {"bits steps=6", "bits masks=5 angles=9,45,81,117,153 rho=0.27 window=5 steps=4",
                           "bits masks=2 react=da angles=0,90 steps=5", "bits masks=3 react=da angles=0,60,120 steps=3",
                           "bits diffusion=isotropic level=2 steps=4", "cells rule=0xfee8e880 steps=4"}) {
    const dapple::Recipe recipe = tests::recipe_of(text);
    const desktop::Ready ready(recipe);
    CAPTURE(std::string(text));
    CHECK((ready.recipe().stage[0].stored != nullptr) == (recipe.stage[0].model == &dapple::bits_model));
    for (const dapple::Domain& domain : {dapple::window(-1000, 77, 100, 60), dapple::torus(164, 132)}) {
      const uint64_t want = tests::field_hash_of(recipe, domain, kSeed);
      REQUIRE(want != 0);
      tests::each_table([&](const desktop::Table& table) {
        dapple::Options options;
        options.kernels = table.kernels;
        for (const uint32_t budget : {UINT32_MAX, 45u}) {
          options.driver = nullptr;
          CHECK(tests::field_hash_of(ready.recipe(), domain, kSeed, options, budget) == want);
          options.driver = &driver;
          CHECK(tests::field_hash_of(ready.recipe(), domain, kSeed, options, budget) == want);
        }
      });
    }
  }
}

TEST_CASE("ready: what would be refused stays as it is") {
  dapple::Recipe recipe = tests::recipe_of("bits steps=6");
  recipe.stage[0].number[dapple::bits::masks] = 6;
  CHECK(desktop::Ready(recipe).recipe().stage[0].stored == nullptr);
  recipe.stages = 0;
  CHECK(desktop::Ready(recipe).recipe().stages == 0);
}
