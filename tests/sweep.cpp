// The machinery against a plain whole-plane implementation: sweeps in place with any stride, radius, cell and number of
// bands; toy models through the stepper; coarse to fine.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "base/hash.hpp"
#include "evolve/refine.hpp"
#include "grow.hpp"
#include "reference/planes.hpp"

namespace evolve = dapple::evolve;
namespace grid = dapple::grid;
using grid::Cell;
using reference::load;
using reference::mix_kernel;
using reference::mix_row;
using reference::naive_mix;
using reference::naive_refined;
using reference::narrowed;
using reference::Planes;
using reference::store;

namespace {

// --- One sweep by the library, over planes and scratch of exactly the bytes it asks for. ---
struct Swept {
  evolve::Field field{};
  std::vector<uint32_t> planes, scratch;
  std::vector<evolve::Band> band;

  Swept(Planes& from, const evolve::Sweep& sweep, uint8_t bands) : band(bands) {
    field.cell = from.cell;
    field.width = static_cast<uint16_t>(from.width);
    field.height = static_cast<uint16_t>(from.height);
    field.row_bytes = grid::row_bytes(field.cell, field.width);
    field.plane_bytes = field.row_bytes * field.height;
    field.bands = bands;
    const evolve::Reach reach{sweep.count, sweep.radius, sweep.halo, 0, 0, 0, 1, sweep.stride, 0, 0};
    REQUIRE(evolve::band_bytes(reach, field.cell, field.width, bands, field.band_bytes));
    planes.resize(field.plane_bytes * static_cast<size_t>(from.count) / 4);
    scratch.resize(std::max<size_t>(field.band_bytes * bands / 4, 1));
    field.planes = reinterpret_cast<uint8_t*>(planes.data());
    field.scratch = reinterpret_cast<uint8_t*>(scratch.data());
    each(from, [](int32_t& plain, Cell cell, uint8_t* row, int32_t x) { store(cell, row, x, plain); });
  }
  template <class Do>
  void each(Planes& plain, Do act) {
    for (int32_t i = 0; i < plain.count; ++i)
      for (int32_t y = 0; y < plain.height; ++y)
        for (int32_t x = 0; x < plain.width; ++x)
          act(plain.at(i, x, y), plain.cell, evolve::row_of(field, static_cast<uint8_t>(i), static_cast<uint16_t>(y)),
              x);
  }
  void read(Planes& to) {
    each(to, [](int32_t& plain, Cell cell, uint8_t* row, int32_t x) { plain = load(cell, row, x); });
  }
  // Bands from the last to the first, `budget` rows of each in turn.
  void run(const evolve::Sweep& sweep, uint32_t budget) {
    evolve::begin_sweep(field, sweep, band.data());
    for (bool more = true; more;) {
      more = false;
      for (uint8_t b = field.bands; b-- > 0;) {
        const uint32_t left = static_cast<uint32_t>(band[b].end - band[b].next);
        const uint32_t ran = evolve::run_band(field, sweep, nullptr, b, band[b], budget);
        CHECK_MESSAGE(ran == std::min(left, budget), "a band runs the rows it is asked for");
        more = more || band[b].next < band[b].end;
      }
    }
  }
};

Planes random_planes(Cell cell, int32_t width, int32_t height, int32_t count, uint32_t seed) {
  Planes planes(cell, width, height, count);
  std::mt19937 random(seed);
  for (int32_t& v : planes.value) v = narrowed(cell, static_cast<uint32_t>(random() >> 3));
  return planes;
}

bool sweep_agrees(const Planes& start, int32_t first, int32_t count, int32_t radius, int32_t stride, int32_t halo,
                  uint8_t bands, uint32_t budget) {
  Planes want = start, have = start;
  naive_mix(want, first, count, radius, stride, halo, 12345);
  evolve::Sweep sweep{};
  sweep.row = mix_kernel(start.cell);
  sweep.first = static_cast<uint8_t>(first);
  sweep.count = static_cast<uint8_t>(count);
  sweep.radius = static_cast<uint8_t>(radius);
  sweep.stride = static_cast<uint16_t>(stride);
  sweep.halo = static_cast<uint16_t>(halo);
  sweep.p[0] = radius;
  sweep.p[1] = halo;
  sweep.p[2] = 12345;
  Swept swept(have, sweep, bands);
  swept.run(sweep, budget);
  swept.read(have);
  return have.value == want.value;
}

constexpr uint8_t kBands[] = {1, 2, 3, 7, 64};
constexpr uint32_t kBudgets[] = {1, 7, UINT32_MAX};
constexpr Cell kCells[] = {Cell::bit, Cell::int16, Cell::int32};
constexpr tests::Size kSizes[] = {{8, 8}, {9, 11}, {15, 14}, {70, 9}, {33, 24}};

}  // namespace

TEST_CASE("sweep: every stride up to three heights, every number of bands and budget") {
  for (const int32_t height : {8, 9, 12})
    for (int32_t stride = 0; stride <= 3 * height; ++stride)
      for (const uint8_t bands : kBands) {
        const int32_t count = 1 + stride % 2;
        const Planes start = random_planes(kCells[stride % 3], 10, height, count, 5);
        CAPTURE(height);
        CAPTURE(stride);
        CAPTURE(int{bands});
        for (const uint32_t budget : kBudgets)
          for (int32_t radius = 1; radius <= 3; ++radius)
            CHECK(sweep_agrees(start, 0, count, radius, stride, radius, bands, budget));
      }
}

TEST_CASE("sweep: one plane, one row either side, as passes are") {
  for (const tests::Size size : {tests::Size{8, 30}, tests::Size{13, 31}, tests::Size{40, 36}})
    for (const int32_t stride : {1, 2, 3, 5, 9, 12, 15, 18, 24, 30, 31, 36, 47, 72, 120})
      for (const uint8_t bands : kBands)
        for (const uint32_t budget : {1u, 2u, 5u, 7u, 1000u}) {
          CAPTURE(size.height);
          CAPTURE(stride);
          CAPTURE(int{bands});
          CAPTURE(budget);
          const Planes start = random_planes(Cell::int16, size.width, size.height, 2, 6);
          CHECK(sweep_agrees(start, stride % 2, 1, 1, stride, 3, bands, budget));
        }
}

TEST_CASE("sweep: sizes, cells, planes, halos wider than the row, radius 0") {
  for (const tests::Size size : kSizes)
    for (const Cell cell : kCells)
      for (const uint8_t bands : kBands)
        for (int32_t radius = 0; radius <= 2; ++radius)
          for (const int32_t halo : {0, 1, 5, 20}) {
            CAPTURE(size.width);
            CAPTURE(size.height);
            CAPTURE(int(cell));
            CAPTURE(int{bands});
            CAPTURE(radius);
            CAPTURE(halo);
            const Planes start = random_planes(cell, size.width, size.height, 3, 7);
            CHECK(sweep_agrees(start, 0, 3, radius, 1, halo, bands, 3));
            CHECK(sweep_agrees(start, 1, 2, radius, size.height / 2, halo, bands, UINT32_MAX));
          }
}

// --- Toy models through the stepper. ---------------------------------------------------------------------------------
namespace {

// Slots: {radius, planes, salt}. A step's salt depends on the clock, so that steps and stages are told apart.
int32_t salt_of(const int32_t* number, uint32_t step, uint32_t steps) {
  return number[2] + static_cast<int32_t>(1000 * step + steps);
}
bool any_range(const int32_t*) { return true; }
uint8_t number_planes(const int32_t* number) { return static_cast<uint8_t>(number[1]); }
grid::Tensor no_tensor(const int32_t*, uint8_t) { return {0, 0, 0}; }
template <int32_t low, int32_t high>
grid::Levels noise_levels(const int32_t*, uint8_t plane) {
  return {0, 1, low - plane, high};
}
int32_t short_wave(const int32_t*) { return 1000000; }
int16_t zero_level(const int32_t*) { return 0; }
void toy_values(const int32_t* number, dapple::Clock clock, int32_t* p) {
  p[0] = p[1] = number[0];
  p[2] = salt_of(number, clock.step, clock.steps);
}
template <Cell cell>
void show_last(const grid::Rows& r) {
  for (int32_t x = 0; x < r.n; ++x) grid::out16(r, 0)[x] = static_cast<int16_t>(load<cell>(r.in[r.planes - 1], x));
}

// Game of Life, and the majority of 5 x 5 cells: what bit planes are for.
void life_row(const grid::Rows& r) {
  const auto on = [&](uint8_t row, int32_t x) {
    return int32_t{grid::get_bit(static_cast<const uint8_t*>(r.in[row]), x)};
  };
  for (int32_t x = 0; x < r.n; ++x) {
    int32_t sum = -on(1, x);
    for (uint8_t row = 0; row < 3; ++row) sum += on(row, x - 1) + on(row, x) + on(row, x + 1);
    grid::put_bit(static_cast<uint8_t*>(r.out[0]), x, sum == 3 || (sum == 2 && on(1, x) == 1));
  }
}
void majority_row(const grid::Rows& r) {
  for (int32_t x = 0; x < r.n; ++x) {
    int32_t sum = 0;
    for (uint8_t row = 0; row < 5; ++row)
      for (int32_t dx = -2; dx <= 2; ++dx) sum += grid::get_bit(static_cast<const uint8_t*>(r.in[row]), x + dx);
    grid::put_bit(static_cast<uint8_t*>(r.out[0]), x, sum > 12);
  }
}
int32_t block_sum(Planes& p, int32_t x, int32_t y, int32_t radius) {
  int32_t sum = 0;
  for (int32_t dy = -radius; dy <= radius; ++dy)
    for (int32_t dx = -radius; dx <= radius; ++dx) sum += p.at(0, x + dx, y + dy);
  return sum;
}

struct Toy {
  dapple::Model model;
  int32_t radius, planes, low, high;
  void (*naive)(Planes& planes, const int32_t* number, uint32_t step, uint32_t steps);
};

void naive_mixing(Planes& planes, const int32_t* number, uint32_t step, uint32_t steps) {
  naive_mix(planes, 0, planes.count, number[0], 1, number[0], salt_of(number, step, steps));
}
void naive_rule(Planes& planes, const int32_t* number, uint32_t, uint32_t) {
  Planes old = planes;
  for (int32_t y = 0; y < old.height; ++y)
    for (int32_t x = 0; x < old.width; ++x) {
      const int32_t sum = block_sum(old, x, y, number[0]), self = old.at(0, x, y);
      planes.at(0, x, y) = number[0] == 2 ? sum > 12 : sum == 3 || (sum == 4 && self == 1);
    }
}

template <Cell cell, int32_t low, int32_t high>
Toy toy(int32_t radius, int32_t planes, grid::RowKernel window = nullptr) {
  const bool mixing = window == nullptr;
  return {{cell, static_cast<uint8_t>(radius), 100, 0, any_range, number_planes, no_tensor, noise_levels<low, high>,
           short_wave, zero_level, toy_values, nullptr, nullptr, mixing ? mix_row<cell> : window, show_last<cell>},
          radius,
          planes,
          low,
          high,
          mixing ? naive_mixing : naive_rule};
}

// A recipe of direct stages: steps[i] on levels[i]; the first starts, equal levels carry, finer ones refine.
struct Path {
  std::vector<uint32_t> steps;
  std::vector<uint8_t> level;
};
dapple::Recipe recipe_of(const Toy& t, const Path& path) {
  dapple::Recipe recipe = dapple::load(dapple::presets::zebra);  // for its noise start and its paint
  recipe.stages = static_cast<uint8_t>(path.steps.size());
  for (size_t i = 0; i < path.steps.size(); ++i) {
    const dapple::Entry entry = i == 0                               ? dapple::Entry::start
                                : path.level[i] == path.level[i - 1] ? dapple::Entry::carry
                                                                     : dapple::Entry::refine;
    recipe.stage[i] = {&t.model,      &evolve::direct, path.steps[i],
                       path.level[i], entry,           {t.radius, t.planes, static_cast<int32_t>(7 * i)}, evolve::refine_row, nullptr};
  }
  return recipe;
}

Planes naive_run(const Toy& t, const Path& path, tests::Size size, uint32_t seed) {
  Planes planes(t.model.cell, size.width >> path.level[0], size.height >> path.level[0], t.planes);
  for (int32_t i = 0; i < t.planes; ++i)
    for (int32_t y = 0; y < planes.height; ++y)
      for (int32_t x = 0; x < planes.width; ++x) {
        if (t.model.cell == Cell::bit) {
          planes.at(i, x, y) = (dapple::base::hash(seed, static_cast<uint32_t>(i), x >> 5, y) >> (x & 31)) & 1;
          continue;
        }
        const int64_t count = t.high - (t.low - i) + 1;
        const int32_t v =
            t.low - i +
            static_cast<int32_t>((dapple::base::hash(seed, static_cast<uint32_t>(i), x, y) >> 16) * count >> 16);
        planes.at(i, x, y) = v;
      }
  uint32_t step = 0, steps = 0;
  for (const uint32_t s : path.steps) steps += s;
  for (size_t i = 0; i < path.steps.size(); ++i) {
    if (i > 0 && path.level[i] < path.level[i - 1]) planes = naive_refined(planes);
    const int32_t number[3] = {t.radius, t.planes, static_cast<int32_t>(7 * i)};
    for (uint32_t s = 0; s < path.steps[i]; ++s) t.naive(planes, number, step++, steps);
  }
  return planes;
}

// The same through evolve::Run, in memory of exactly its parts.
Planes library_run(const Toy& t, const Path& path, tests::Size size, uint32_t seed, uint8_t bands, uint32_t budget) {
  const dapple::Recipe recipe = recipe_of(t, path);
  const dapple::Domain domain = dapple::torus(size.width, size.height);
  const grid::Ground ground = {size.width, size.height, 0, 0};
  dapple::Need need{};
  const evolve::Parts parts = dapple::api::parts_of(recipe, ground, domain, bands, need);
  std::vector<uint64_t> memory((parts.planes + parts.scratch + parts.table + parts.bands + 7) / 8);
  const evolve::Plan plan = {&recipe.start, recipe.stage, recipe.stages, false};
  evolve::Run run;
  evolve::begin(run, {plan, domain, ground, parts, reinterpret_cast<uint8_t*>(memory.data()), nullptr, seed, bands});
  uint64_t rows = 0;
  for (bool more = true; more; rows = run.rows) {
    more = evolve::advance(run, budget);
    CHECK_MESSAGE(run.rows - rows <= budget, "no call does more than it was asked for");
  }
  CHECK(run.rows == need.rows);
  Planes result(t.model.cell, size.width, size.height, t.planes);
  for (int32_t i = 0; i < t.planes; ++i)
    for (uint16_t y = 0; y < size.height; ++y)
      for (uint16_t x = 0; x < size.width; ++x)
        result.at(i, x, y) = load(t.model.cell, evolve::row_of(run.field, static_cast<uint8_t>(i), y), x);
  return result;
}

const Toy kToys[] = {toy<Cell::int32, -50000, 15000>(1, 1),
                     toy<Cell::int32, -30, 30>(1, 2),
                     toy<Cell::int32, 0, 65535>(2, 1),
                     toy<Cell::int32, 5, 9>(2, 2),
                     toy<Cell::int16, -9000, 9000>(1, 3),
                     toy<Cell::bit, 0, 1>(1, 2),
                     toy<Cell::bit, 0, 2>(2, 1),
                     toy<Cell::bit, 0, 1>(1, 1, life_row),
                     toy<Cell::bit, 0, 1>(2, 1, majority_row)};

void check_run(const Toy& t, const Path& path, tests::Size size, const char* what) {
  const Planes want = naive_run(t, path, size, 42);
  for (const uint8_t bands : kBands)
    for (const uint32_t budget : kBudgets) {
      INFO(what << " radius " << t.radius << " planes " << t.planes << " cell " << int(t.model.cell) << " "
                << size.width << "x" << size.height << " bands " << int(bands) << " budget " << budget);
      CHECK(library_run(t, path, size, 42, bands, budget).value == want.value);
    }
}

}  // namespace

TEST_CASE("run: toy models of int32, int16 and bits are their whole-plane selves") {
  for (const Toy& t : kToys)
    for (const tests::Size size : kSizes) check_run(t, {{5}, {0}}, size, "one stage");
}

TEST_CASE("run: stages carry on with the same planes and the clock runs through them") {
  for (const Toy& t : kToys) check_run(t, {{2, 0, 3}, {0, 0, 0}}, {13, 21}, "carry");
}

TEST_CASE("run: coarse to fine") {
  for (const Toy& t : kToys) {
    if (t.model.cell == Cell::bit) continue;
    check_run(t, {{2, 3}, {1, 0}}, {22, 18}, "two levels");
    check_run(t, {{0, 0}, {1, 0}}, {16, 16}, "two levels, nothing else");
    check_run(t, {{1, 1, 0, 2}, {3, 2, 1, 0}}, {64, 72}, "four levels");
  }
}

TEST_CASE("refine: bilinear at cell centres, up to the largest cells") {
  for (const Cell cell : {Cell::int16, Cell::int32})
    for (const tests::Size size :
         {tests::Size{4, 4}, tests::Size{5, 1}, tests::Size{1, 5}, tests::Size{7, 2}, tests::Size{11, 13}}) {
      Planes coarse = random_planes(cell, size.width, size.height, 2, 3);
      for (size_t i = 0; i < coarse.value.size(); i += 3) coarse.value[i] = cell == Cell::int16 ? 32767 : INT32_MAX;
      for (size_t i = 1; i < coarse.value.size(); i += 5) coarse.value[i] = cell == Cell::int16 ? -32768 : INT32_MIN;
      Planes fine = naive_refined(coarse), have = fine;
      Swept whole(have, evolve::Sweep{}, 1);  // planes of the fine size, the coarse ones at their start
      evolve::Field field = whole.field;
      field.width = size.width;
      field.height = size.height;
      field.row_bytes = grid::row_bytes(cell, size.width);
      std::vector<uint32_t> scratch(2 * 4 * grid::scratch_bytes(cell, size.width, 1) / 4);
      field.scratch = reinterpret_cast<uint8_t*>(scratch.data());
      for (uint8_t i = 0; i < 2; ++i) {
        for (uint16_t y = 0; y < size.height; ++y)
          for (uint16_t x = 0; x < size.width; ++x) store(cell, evolve::row_of(field, i, y), x, coarse.at(i, x, y));
      }
      for (uint16_t y = size.height; y-- > 0;)
        for (uint8_t i = 0; i < 2; ++i) evolve::refine_row(field, i, y);
      whole.read(have);
      CAPTURE(size.width);
      CAPTURE(size.height);
      CHECK(have.value == fine.value);
    }
}

TEST_CASE("run: a bit model through the face of the library") {
  const Toy& life = kToys[7];
  const dapple::Recipe recipe = recipe_of(life, {{20}, {0}});
  dapple::Options options;
  options.bands = 3;
  tests::Grown tile(recipe, dapple::torus(37, 26), 9, 5, options);
  REQUIRE(tile.status == dapple::ok);
  const Planes want = naive_run(life, {{20}, {0}}, {37, 26}, 9);
  const std::vector<int16_t> field = tile.field();
  CHECK(std::equal(field.begin(), field.end(), want.value.begin(), want.value.end()));
  CHECK(std::count(field.begin(), field.end(), 1) > 20);  // not all dead
  CHECK(tile.texture.cell_level() == 0);
}
