// Windows of the endless plane: whatever is grown first, in whatever slices, they are parts of each other.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <string>

#include "world.hpp"

using dapple::window;
using tests::Cell;
using tests::Grown;
using tests::kEdge;
using tests::kSeed;
using tests::pixels_of;
using tests::World;
using tests::part;

namespace {

constexpr uint32_t kBudgets[] = {1, 7, UINT32_MAX};

// A window of 512 x 512 cells at chunk (left, top) of 128 x 128, and its chunks one by one in a random order.
void check_chunks(const std::string& text, int32_t left, int32_t top) {
  constexpr uint16_t kSide = 128, kWide = 512;
  const dapple::Recipe recipe = tests::recipe_of(text.c_str());
  Grown whole(recipe, window(left * kSide, top * kSide, kWide, kWide), kSeed);
  REQUIRE_MESSAGE(whole.status == dapple::ok, text);
  const std::vector<int16_t> field = whole.field();
  REQUIRE_MESSAGE(std::adjacent_find(field.begin(), field.end(), std::not_equal_to<>()) != field.end(),
                  text << " is flat");
  const std::vector<uint8_t> rgba = whole.pixels(dapple::Brush{});
  std::mt19937 random(static_cast<uint32_t>(left * 31 + top));
  std::vector<int> order(16);
  for (int i = 0; i < 16; ++i) order[static_cast<size_t>(i)] = i;
  for (uint8_t bands = 1; bands <= 3; ++bands)
    for (const uint32_t budget : kBudgets) {
      std::shuffle(order.begin(), order.end(), random);
      dapple::Options options;
      options.bands = bands;
      for (const int i : order) {
        const uint16_t x = static_cast<uint16_t>(i % 4 * kSide), y = static_cast<uint16_t>(i / 4 * kSide);
        Grown chunk(recipe, window(left * kSide + x, top * kSide + y, kSide, kSide), kSeed, budget, options);
        REQUIRE(chunk.status == dapple::ok);
        const bool same = chunk.field() == part(field, kWide, x, y, kSide, kSide) &&
                          chunk.pixels(dapple::Brush{}) == part(rgba, 4u * kWide, 4u * x, y, 4u * kSide, kSide);
        CHECK_MESSAGE(same, text << " chunk " << i << " at " << left << "," << top << " bands " << int(bands)
                                 << " budget " << budget);
      }
    }
  // The same from a cache that is looked at piece by piece.
  World world(recipe, kSide, 16, dapple::Brush{}, static_cast<uint8_t>(1 + random() % 3), random() % 4);
  REQUIRE(world.status == dapple::ok);
  std::shuffle(order.begin(), order.end(), random);
  for (const int i : order) {
    REQUIRE(world.chunks.look_at((left + i % 4) * kSide + 5, (top + i / 4) * kSide + 9, 90, 90) == dapple::ok);
    while (world.chunks.step(kBudgets[random() % 3]) == dapple::more) {
    }
  }
  for (int i = 0; i < 16; ++i) {
    const size_t x = static_cast<size_t>(i % 4 * kSide), y = static_cast<size_t>(i / 4 * kSide);
    CHECK_MESSAGE(
        pixels_of(world.chunks, left + i % 4, top + i / 4) == part(rgba, 4u * kWide, 4 * x, y, 4u * kSide, kSide),
        text << " cached chunk " << i << " at " << left << "," << top);
  }
}

}  // namespace

TEST_CASE("windows: a window is its chunks, in any order, budget and bands") {
  const std::string recipes[] = {
      "bits scale=9 stretch=3 angle=78.5 steps=8 ramp=zebra range=-0.95,0.95",
      "bits scale=9 stretch=3 angle=20 steps=6 level=0 ramp=zebra range=-0.95,0.95 light=2 gloss=0.3 grain=0.1",
      "bits masks=5 react=da scale=9 stretch=3 steps=6 level=1 ramp=jade light=1",
      "bits masks=2 react=md scale=9 stretch=3 steps=5 level=2 ramp=jade light=1",
      "bits diffusion=isotropic scale=9 steps=6 start=seeds pitch=26 radius=5 ramp=reptile light=1",
      "cells rule=0xfee8e880 steps=20",
      "cells rule=0x96696996 steps=33 range=-0.2,1.2 light=1",
  };
  for (const std::string& text : recipes)
    for (const Cell& place : {Cell(0, 0), Cell(-7, -2), Cell(-kEdge / 128, kEdge / 128 - 4)})
      check_chunks(text, place.first, place.second);
}

TEST_CASE("windows: every preset that settles soon, at a side no grid divides") {
  constexpr uint16_t kSide = 75;
  for (uint16_t i = 0; i < dapple::preset_count(); ++i) {
    char name[dapple::kMaxName];
    const dapple::PresetEntry entry = dapple::preset_at(i, name);
    const dapple::Recipe recipe = dapple::load(*entry.preset);
    if (const dapple::Need need = dapple::need_for(recipe, window(0, 0, kSide, kSide));
        need.status != dapple::ok || need.halo > 400 || need.block != 0)
      continue;
    World world(recipe, kSide, 4);
    REQUIRE(world.status == dapple::ok);
    world.look_and_finish(-kSide - 1, 3 * kSide - 1, 2, 2);
    Grown whole(recipe, window(-2 * kSide, 2 * kSide, 3 * kSide, 2 * kSide), kSeed);
    const std::vector<uint8_t> rgba = whole.pixels(dapple::Brush{});
    for (const Cell& c : {Cell(-2, 2), Cell(-1, 2), Cell(0, 2), Cell(-2, 3), Cell(-1, 3), Cell(0, 3)}) {
      const size_t x = static_cast<size_t>(c.first + 2) * kSide, y = static_cast<size_t>(c.second - 2) * kSide;
      if (!world.has(c.first, c.second)) continue;
      CHECK_MESSAGE(pixels_of(world.chunks, c.first, c.second) == part(rgba, 12u * kSide, 4 * x, y, 4u * kSide, kSide),
                    name);
    }
    CHECK(world.chunks.counters().held == 4);
  }
}
