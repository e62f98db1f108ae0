// Cell programs: every kernel is the look-up of the definition, programs whose future is known by heart, golden states;
// and the starts of one-bit cells.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>

#include "base/hash.hpp"
#include "onebit.hpp"

namespace cells = dapple::cells;
namespace evolve = dapple::evolve;
namespace grid = dapple::grid;
using dapple::Recipe;
using tests::made;
using tests::Torus;

namespace {

constexpr uint32_t kSeed = 5;

// The definition: bit 16 left + 8 right + 4 upper + 2 lower + self of the program.
Torus next(const Torus& t, uint32_t program) {
  return made(t.width, t.height, [&](int x, int y) {
    const int index = 16 * t.at(x - 1, y) + 8 * t.at(x + 1, y) + 4 * t.at(x, y - 1) + 2 * t.at(x, y + 1) + t.at(x, y);
    return static_cast<int>(program >> index & 1);
  });
}
Torus after(Torus t, uint32_t program, int steps) {
  while (steps-- > 0) t = next(t, program);
  return t;
}

// The program in which the new state hangs on the cell and the number of its neighbours that are on: bit n of `born`
// for a cell that is off, of `stays` for one that is on.
uint32_t totalistic(unsigned born, unsigned stays) {
  uint32_t program = 0;
  for (unsigned index = 0; index < 32; ++index) {
    const unsigned n = (index >> 1 & 1) + (index >> 2 & 1) + (index >> 3 & 1) + (index >> 4 & 1);
    program |= ((index & 1 ? stays : born) >> n & 1) << index;
  }
  return program;
}

Recipe recipe_of(uint32_t program, int steps) {
  Recipe recipe = tests::recipe_of("cells");
  recipe.stage[0].number[cells::program] = static_cast<int32_t>(program);
  recipe.stage[0].steps = static_cast<uint32_t>(steps);
  return recipe;
}

Torus grown(const Recipe& recipe, dapple::Domain d, const dapple::Options& options = dapple::Options{},
            uint32_t budget = UINT32_MAX) {
  Torus field = tests::grown(recipe, d, kSeed, options, budget);
  for (int& value : field.value) {
    if (value != 0 && value != cells::kUnit) FAIL("a cell is on or off");
    value /= cells::kUnit;
  }
  return field;
}

// The library's steps on cells that were set by hand.
Torus grown_from(const Torus& start, uint32_t program, int steps) {
  const Recipe recipe = recipe_of(program, steps);
  const dapple::Domain d = dapple::torus(static_cast<uint16_t>(start.width), static_cast<uint16_t>(start.height));
  const grid::Ground ground = {d.width, d.height, 0, 0};
  dapple::Need need{};
  const evolve::Parts parts = dapple::api::parts_of(recipe, ground, d, 1, need);
  std::vector<uint64_t> memory((parts.planes + parts.scratch + parts.table + parts.bands + 7) / 8);
  evolve::Run run;
  const evolve::Plan plan = {&recipe.start, recipe.stage, 1, false};
  evolve::begin(run, {plan, d, ground, parts, reinterpret_cast<uint8_t*>(memory.data()), nullptr, kSeed, 1});
  evolve::advance(run, d.height);  // the start, which is thrown away
  const auto row = [&](int y) { return evolve::row_of(run.field, 0, static_cast<uint16_t>(y)); };
  for (int y = 0; y < start.height; ++y)
    for (int x = 0; x < start.width; ++x) grid::put_bit(row(y), x, start.at(x, y) == 1);
  evolve::advance(run, UINT32_MAX);
  return made(start.width, start.height, [&](int x, int y) { return grid::get_bit(row(y), x) ? 1 : 0; });
}

Torus single(int side) {
  Torus t(side, side);
  t.at(side / 2, side / 2) = 1;
  return t;
}

const grid::KernelSwap kSwaps[][2] = {{{nullptr, nullptr}},
                                      {{cells::window_row, cells::window_row8}},
                                      {{cells::window_row, cells::window_row32}},
                                      {{cells::window_row, cells::window_row64}},
                                      {{cells::window_row, cells::window_by_cell}}};

}  // namespace

TEST_CASE("cells: every kernel, any number of bands, is the definition") {
  std::mt19937 random(1);
  for (int i = 0; i < 60; ++i) {
    const uint32_t program = static_cast<uint32_t>(random());
    const int steps = static_cast<int>(random() % 9), width = 8 + i % 12 + 64 * (i % 3),
              height = 8 + static_cast<int>(random() % 20);
    const dapple::Domain d = dapple::torus(static_cast<uint16_t>(width), static_cast<uint16_t>(height));
    const Torus want = after(grown(recipe_of(program, 0), d), program, steps);
    CAPTURE(program);
    CAPTURE(width);
    for (const auto& swap : kSwaps)
      for (uint8_t bands = 1; bands <= 3; ++bands) {
        dapple::Options options;
        options.bands = bands;
        options.kernels = swap;
        const uint32_t budgets[] = {1, 7, UINT32_MAX};
        CHECK(grown(recipe_of(program, steps), d, options, budgets[random() % 3]) == want);
      }
  }
}

// A window is the middle of a torus so large that nothing comes around it, given the same start.
TEST_CASE("cells: windows of the plane are the definition and parts of one another") {
  std::mt19937 random(2);
  for (int i = 0; i < 40; ++i) {
    const uint32_t program = static_cast<uint32_t>(random());
    const int steps = static_cast<int>(random() % 12), around = steps + 2;
    const int32_t x = static_cast<int32_t>(random() % 2000000000) - 1000000000,
                  y = static_cast<int32_t>(random() % 999) - 500;
    const uint16_t width = static_cast<uint16_t>(8 + random() % 90), height = static_cast<uint16_t>(8 + random() % 30);
    const Torus wide =
        grown(recipe_of(program, 0), dapple::window(x - around, y - around, static_cast<uint16_t>(width + 2 * around),
                                                    static_cast<uint16_t>(height + 2 * around)));
    const Torus all = after(wide, program, steps);
    const Torus want = made(width, height, [&](int cx, int cy) { return all.at(cx + around, cy + around); });
    CAPTURE(i);
    for (const auto& swap : kSwaps) {
      dapple::Options options;
      options.bands = static_cast<uint8_t>(1 + i % 3);
      options.kernels = swap;
      CHECK(grown(recipe_of(program, steps), dapple::window(x, y, width, height), options) == want);
    }
  }
}

TEST_CASE("cells: identity, complement and the four shifts") {
  const dapple::Domain d = dapple::torus(75, 43);
  const Torus start = grown(recipe_of(0, 0), d);
  const auto shifted = [&](int dx, int dy) {
    return made(75, 43, [&](int x, int y) { return start.at(x - dx, y - dy); });
  };
  CHECK(start.count() > 75 * 43 * 4 / 10);
  CHECK(grown(recipe_of(0, 1), d).count() == 0);
  CHECK(grown(recipe_of(0xffffffffu, 1), d).count() == 75 * 43);
  CHECK(grown(recipe_of(0xaaaaaaaau, 9), d) == start);
  CHECK(grown(recipe_of(0x55555555u, 8), d) == start);
  CHECK(grown(recipe_of(0x55555555u, 9), d) == made(75, 43, [&](int x, int y) { return 1 - start.at(x, y); }));
  CHECK(grown(recipe_of(0xffff0000u, 10), d) == shifted(10, 0));  // what is on the left comes here: all moves right
  CHECK(grown(recipe_of(0xff00ff00u, 11), d) == shifted(-11, 0));
  CHECK(grown(recipe_of(0xf0f0f0f0u, 12), d) == shifted(0, 12));
  CHECK(grown(recipe_of(0xccccccccu, 13), d) == shifted(0, -13));
}

// Sums modulo two are linear, and squaring them doubles every distance: after 2^k steps a pattern is the sum of its
// copies at that distance.
TEST_CASE("cells: parity copies any pattern") {
  const uint32_t parity = totalistic(0b01010, 0b01010), with_self = totalistic(0b01010, 0b10101);
  CHECK(with_self == 0x96696996u);
  const Torus start = grown(recipe_of(0, 0), dapple::torus(150, 90));
  for (const bool self : {false, true})
    for (const int steps : {1, 2, 4, 8, 16, 32, 64}) {
      const uint32_t program = self ? with_self : parity;
      CHECK(grown(recipe_of(program, steps), dapple::torus(150, 90)) == made(150, 90, [&](int x, int y) {
              const int sum =
                  start.at(x - steps, y) + start.at(x + steps, y) + start.at(x, y - steps) + start.at(x, y + steps);
              return (sum + (self ? start.at(x, y) : 0)) % 2;
            }));
      CHECK(grown_from(single(131), program, steps).count() == (self ? 5 : 4));
    }
  CHECK(grown_from(single(131), with_self, 63).count() > 1000);
}

// Born with one neighbour, for ever after: the cellular automaton of Ulam (OEIS A147562). Born with any: diamonds.
TEST_CASE("cells: a single cell grows as it is known to") {
  const int ulam[] = {1, 5, 9, 21, 25, 37, 49, 85, 89, 101, 113, 149, 161, 197, 233, 341, 345};
  for (int steps = 0; steps < 17; ++steps) {
    CHECK(grown_from(single(45), totalistic(0b00010, 0b11111), steps).count() == ulam[steps]);
    CHECK(grown_from(single(45), totalistic(0b11110, 0b11111), steps).count() == 2 * steps * (steps + 1) + 1);
    CHECK(grown_from(single(45), totalistic(0b00000, 0b11110), steps).count() == (steps == 0 ? 1 : 0));
  }
  // Two by two cells stay where two neighbours keep a cell alive; a frame of width one around them does not.
  Torus block(20, 20);
  for (const int i : {0, 1, 2, 3}) block.at(7 + i % 2, 15 + i / 2) = 1;
  CHECK(grown_from(block, totalistic(0b11000, 0b00100), 30) == block);
}

// FNV-1a of the cells, row by row, that the look-up of the definition leaves of noise (seed 5, 97 x 61) after 40 steps.
TEST_CASE("cells: golden states") {
  struct Golden {
    uint32_t program;
    uint64_t hash;
  };
  constexpr Golden kGoldens[] = {
      {0x1f83d9abu, UINT64_C(0xea8ca128ed5f50a1)}, {0x6a09e667u, UINT64_C(0x6a0e46504c26073d)},
      {0xbb67ae85u, UINT64_C(0x55ef90ed731b5a52)}, {0x3c6ef372u, UINT64_C(0x398bd97ecd08cc52)},
      {0xa54ff53au, UINT64_C(0x0488337690211e89)}, {0x510e527fu, UINT64_C(0x787eb0c374e76d07)},
  };
  for (const Golden& g : kGoldens) {
    tests::Fnv fnv;
    for (const int cell : grown(recipe_of(g.program, 40), dapple::torus(97, 61)).value)
      fnv.byte(static_cast<uint8_t>(cell));
    CAPTURE(g.program);
    CHECK(fnv.value == g.hash);
  }
}

// --- Starts ----------------------------------------------------------------------------------------------------------

TEST_CASE("cells: noise is the bits of the hash, thirty-two cells a number") {
  for (const dapple::Domain d :
       {dapple::torus(104, 84), dapple::torus(77, 43, 101, -36), dapple::window(-75, 52, 84, 76)}) {
    const auto world = [&](int at, int size) { return d.plane ? at : (at % size + size) % size; };
    CHECK(grown(recipe_of(0, 0), d) == made(d.width, d.height, [&](int x, int y) {
            const int32_t wx = world(x + d.x, d.width), wy = world(y + d.y, d.height);
            const int32_t number = (wx - ((wx % 32) + 32) % 32) / 32;
            return static_cast<int>(dapple::base::hash(kSeed, 0, number, wy) >> (wx - 32 * number) & 1);
          }));
  }
}

// Discs at ((i + 1/4 + 1/2 (j odd)) + jitter U) * spacing and so on, in double: cells near a disc's edge may be either.
TEST_CASE("cells: seeds are the discs of the jittered grid, on torus and plane") {
  const double pitch = 17.3, aspect = 0.875;
  const auto compare = [&](const char* jitter_text, const char* radius_text, const dapple::Domain& d) {
    const double jitter = std::stod(jitter_text), radius = std::stod(radius_text);
    CAPTURE(jitter);
    CAPTURE(radius);
    const std::string numbers = std::string(" jitter=") + jitter_text + " radius=" + radius_text;
    Recipe recipe = tests::recipe_of(("cells start=seeds pitch=17.3 aspect=.875 steps=0" + numbers).c_str());
    const Torus have = grown(recipe, d);
    const double columns = std::round(d.width / pitch), rows = 2 * std::round(d.height / (2 * pitch * aspect));
    const double wide = d.plane ? pitch : d.width / columns, high = d.plane ? pitch * aspect : d.height / rows;
    const auto shake = [&](uint32_t stream, int i, int j) {
      return jitter * (static_cast<double>(dapple::base::hash(kSeed, stream, i, j) >> 16) / 32768 - 1);
    };
    std::vector<double> nearest(have.value.size(), 1e9);
    const int first = d.plane ? -25 : 0;
    for (int j = first; j < (d.plane ? 25 : rows); ++j)
      for (int i = first; i < (d.plane ? 25 : columns); ++i) {
        const double cx = (i + 0.25 + 0.5 * (j & 1) + shake(64, i, j)) * wide - (d.plane ? d.x : 0);
        const double cy = (j + 0.5 + shake(65, i, j)) * high - (d.plane ? d.y : 0);
        for (size_t k = 0; k < nearest.size(); ++k) {
          double dx = static_cast<double>(k % d.width) + 0.5 - cx, dy = static_cast<double>(k / d.width) + 0.5 - cy;
          if (!d.plane) dx = std::remainder(dx, d.width), dy = std::remainder(dy, d.height);
          nearest[k] = std::min(nearest[k], dx * dx + dy * dy);
        }
      }
    int wrong = 0;
    for (size_t k = 0; k < nearest.size(); ++k) {
      const double edge = std::sqrt(nearest[k]) - radius;
      wrong += std::fabs(edge) > 0.03 && have.value[k] != (edge < 0);
    }
    CHECK(wrong == 0);
    CHECK(have.count() > (radius > 1 ? d.width * d.height / 8 : 0));
  };
  for (const dapple::Domain& d : {dapple::torus(150, 90), dapple::torus(64, 123), dapple::window(-300, 40, 160, 120)}) {
    compare("0.2", "4.2", d);
    compare("1", "4.2", d);
    compare("1", "0.6", d);
    compare("0.5", "13", d);
  }
}
