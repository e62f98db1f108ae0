// Masks along a field of directions by the kernels and the driver of ports/desktop: the numbers that they hold in 16
// bits, the sums and directions at which those are largest, and grown textures, against the definition.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstdlib>
#include <random>
#include <set>

#include "../grow.hpp"
#include "driver.hpp"
#include "each_table.hpp"
#include "strips.hpp"

namespace desktop = dapple::desktop;
namespace grid = dapple::grid;
namespace stencil = dapple::stencil;

namespace {

constexpr uint32_t kSeed = 21;
constexpr int kRadius = 4, kSide = 2 * kRadius + 1;

// All directions of angles, and those along vectors in Q12 as blended nodes have them.
std::set<std::pair<int, int>> all_directions() {
  std::set<std::pair<int, int>> all;
  for (int turn = 0; turn < 65536; ++turn) {
    const stencil::Doubled d = stencil::doubled_of(static_cast<uint16_t>(turn));
    all.insert({d.c2, d.s2});
  }
  for (int a = -4200; a < 4200; a += 5)
    for (int b = -4200; b < 4200; b += 5) {
      const stencil::Doubled d = stencil::unit_of(a, b);
      all.insert({d.c2, d.s2});
    }
  return all;
}

// Weights that sum to 127 and -127: such is the sum where the cells that have weights of one sign are on.
stencil::Mask random_mask(std::mt19937& random) {
  stencil::Mask mask = {kRadius, 127, {}};
  for (const int sign : {1, -1})
    for (int left = 127; left > 0;) {
      int8_t& weight = mask.weight[random() % (kSide * kSide)];
      if (weight != 0) continue;
      weight = static_cast<int8_t>(sign * std::min(left, 7));
      left -= std::abs(weight);
    }
  return mask;
}

// Five such masks; or one and its negative, so that all sums are largest at once.
struct Extreme {
  std::vector<int32_t> memory = std::vector<int32_t>(stencil::steer_set_bytes(true) / 4 + 1);
  stencil::Mask masks[stencil::kSteerable];

  stencil::SteerSet& set() { return *reinterpret_cast<stencil::SteerSet*>(memory.data()); }
  Extreme(std::mt19937& random, uint8_t kind, bool alike) {
    for (stencil::Mask& mask : masks) {
      mask = alike && &mask != masks ? masks[0] : random_mask(random);
      if (alike && random() % 2 == 0)
        for (int8_t& weight : mask.weight) weight = static_cast<int8_t>(-weight);
    }
    stencil::make_set(masks, stencil::kSteerable, true, set().masks);
    set().field = {static_cast<uint32_t>(random()), -300, 70, 0, 0, 16, 16, kind, 4096};
    set().threads = static_cast<uint8_t>(1 + random() % stencil::kMaxThreads);
    for (uint8_t t = 0; t < set().threads; ++t) {
      const stencil::Doubled thread = stencil::doubled_of(static_cast<uint16_t>(random()));
      set().c2[t] = thread.c2;
      set().s2[t] = thread.s2;
    }
  }
};

// Cells of which some have around them what makes a mask's sum largest, or least, and the signs of several masks alike.
struct Cells {
  static constexpr uint16_t kWidth = 300, kHeight = 60;
  static constexpr size_t kPitch = 32 + 64 + 32;
  alignas(32) std::array<uint8_t, kPitch * kHeight> memory;
  uint8_t* row(int y) { return memory.data() + 32 + kPitch * static_cast<size_t>(y); }

  Cells(std::mt19937& random, const Extreme& extreme) {
    for (uint8_t& byte : memory) byte = static_cast<uint8_t>(random());
    for (int y = kRadius; y + kRadius < kHeight; y += kSide)
      for (int x = kRadius; x + kRadius < kWidth; x += kSide) {
        const stencil::Mask& mask = extreme.masks[random() % stencil::kSteerable];
        const int sign = random() % 2 == 0 ? 1 : -1;
        for (int i = 0; i < kSide * kSide; ++i)
          if (mask.weight[i] != 0)
            grid::put_bit(row(y + i / kSide - kRadius), x + i % kSide - kRadius, mask.weight[i] * sign > 0);
      }
  }
};

// Cells of row y that differ from the definition; those near the edges are not looked at.
int different(Cells& cells, Extreme& extreme, int y, const uint8_t* have, const int32_t* p) {
  uint8_t want[64] = {};
  grid::Rows rows{};
  for (int k = 0; k < kSide; ++k) rows.in[k] = cells.row(y + k - kRadius);
  rows.out[0] = want;
  rows.p = p;
  rows.table = extreme.memory.data();
  rows.n = Cells::kWidth;
  rows.y = static_cast<uint16_t>(y);
  stencil::steer_by_table(rows);
  int count = 0;
  for (int x = kRadius; x < Cells::kWidth - kRadius; ++x) count += grid::get_bit(want, x) != grid::get_bit(have, x);
  return count;
}

// The world of these masks; some are summed by their change from row to row.
stencil::World upright(Extreme& extreme) {
  stencil::World world{};
  world.first = -kRadius;
  world.columns = kSide;
  world.radius = kRadius;
  world.masks = stencil::kSteerable;
  for (uint8_t m = 0; m < world.masks; ++m) {
    world.mask[m].whole = stencil::whole_of(extreme.set().masks, m);
    world.mask[m].running = m % 2 == 0 && stencil::make_change(extreme.masks[m], world.mask[m].change);
  }
  return world;
}

const char* const kRecipes[] = {
    "flow steps=5",
    "flow field=scalar bend=2.9 nodes=16 steps=4",
    "flow level=0 nodes=17 window=4 scale=5 rho=0.3:-0.4@0..0.9 steps=5",
    "flow level=0 threads=2 angle=0 rho=0.16 steps=4",
    "flow level=2 threads=5 angles=10,-20,77,145,300 window=8 scale=10 stretch=5 rho=-0.1 steps=3",
    "flow level=0 field=scalar bend=0 threads=3 angle=11 nodes=300 window=7 rho=0.24 steps=4",
};

}  // namespace

TEST_CASE("steered: products of directions and of sums fit 16 bits for all directions and threads") {
  std::set<std::pair<int, int>> threads;
  for (int turn = 0; turn < 65536; ++turn) {
    const stencil::Doubled d = stencil::doubled_of(static_cast<uint16_t>(turn));
    threads.insert({d.c2, d.s2});
  }
  const std::set<std::pair<int, int>> all = all_directions();
  CHECK(all.size() > 8000);
  int longest = 0, turned = 0, two = 0, four = 0;
  for (const auto& [c, s] : all) {
    longest = std::max(longest, c * c + s * s);
    if (c * c + s * s < 124 * 124) continue;
    for (const auto& [tc, ts] : threads) {
      turned = std::max({turned, std::abs(c * tc - s * ts), std::abs(s * tc + c * ts)});
      const int c2 = (c * tc - s * ts + 64) >> 7, s2 = (s * tc + c * ts + 64) >> 7;
      const int c4 = (c2 * c2 - s2 * s2 + 64) >> 7, s4 = (2 * c2 * s2 + 64) >> 7;
      two = std::max(two, std::abs(c2) + std::abs(s2));
      four = std::max(four, std::abs(c4) + std::abs(s4));
    }
  }
  CHECK(longest <= 16666);  // 129.1^2
  CHECK(turned + 64 <= INT16_MAX);
  CHECK(127 * two <= INT16_MAX);
  CHECK(127 * four <= INT16_MAX);
  CHECK(127 * (two + four) > INT16_MAX);  // so both together do not
}

TEST_CASE("steered: sums of +-127 along any direction, by the kernels of every table") {
  std::mt19937 random(5);
  for (int i = 0; i < 60; ++i) {
    Extreme extreme(random, i % 2 == 0 ? stencil::vectors : stencil::scalars, i % 4 < 2);
    Cells cells(random, extreme);
    const stencil::World world = upright(extreme);
    const int32_t p[] = {0, static_cast<int32_t>(random() % 900001) - 450000};
    CAPTURE(i);
    tests::each_table([&](const desktop::Table& table) {
      const grid::RowKernel row = grid::choose(table.kernels, stencil::steer_strip_row);
      for (const bool parts : {false, true}) {
        std::vector<uint8_t> out(Cells::kPitch * Cells::kHeight), kept(2 * 512 * Cells::kHeight + 32);
        const stencil::BitGrid from = {cells.row(0), Cells::kPitch, Cells::kHeight, 512, Cells::kWidth};
        uint8_t* const directions = kept.data() + (-reinterpret_cast<uintptr_t>(kept.data()) & 31);
        for (const bool fresh : {true, false})
          for (const uint16_t first : {uint16_t{kRadius}, uint16_t{33}}) {
            const uint16_t end = parts && first == kRadius ? uint16_t{33} : uint16_t{Cells::kHeight - kRadius};
            const int16_t threshold = stencil::threshold_of(p[1], extreme.set().masks.sum);
            const stencil::Steered steered = {
                {&world, from, out.data(), false, threshold, first, end, 0, Cells::kWidth, nullptr},
                &extreme.set(),
                directions,
                fresh};
            grid::Rows call{};
            call.in[0] = &steered;
            row(call);
          }
        int wrong = 0;
        for (int y = kRadius; y < Cells::kHeight - kRadius; ++y)
          wrong += different(cells, extreme, y, out.data() + Cells::kPitch * static_cast<size_t>(y), p);
        CHECK(wrong == 0);
      }
    });
  }
}

TEST_CASE("steered: by every table, with the driver and without, on tori and windows, threads and budgets") {
  desktop::Driver one(1), three(3);
  int grown = 0;
  for (const char* text : kRecipes) {
    const dapple::Recipe recipe = tests::recipe_of(text);
    REQUIRE(recipe.stages == 1);
    CAPTURE(std::string(text));
    for (const dapple::Domain& domain :
         {dapple::torus(96, 64), dapple::torus(300, 260), dapple::torus(1064, 68), dapple::torus(256, 516),
          dapple::window(-77, 5001, 90, 60), dapple::window(1000000, -9, 8, 300)}) {
      CAPTURE(domain.width);
      CAPTURE(domain.height);
      if (dapple::need_for(recipe, domain).status != dapple::ok) continue;  // less than two wavelengths
      ++grown;
      const uint64_t want = tests::field_hash_of(recipe, domain, kSeed);
      tests::each_table(
          [&](const desktop::Table& table) {
            dapple::Options options;
            options.kernels = table.kernels;
            CHECK(tests::field_hash_of(recipe, domain, kSeed, options) == want);
            options.driver = &one;
            for (const uint32_t budget : {UINT32_MAX, 700u, 150u})
              CHECK(tests::field_hash_of(recipe, domain, kSeed, options, budget) == want);
            options.driver = &three;
            CHECK(tests::field_hash_of(recipe, domain, kSeed, options) == want);
          },
          1);
    }
  }
  CHECK(grown == 34);
}
