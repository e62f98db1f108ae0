// Binary convolution along a field of directions: the field against double and at its seams, the steered step against plain
// loops, kernels, windows; grown stripes follow the field.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "grow.hpp"

namespace flow = dapple::flow;
namespace grid = dapple::grid;
namespace stencil = dapple::stencil;
using dapple::Recipe;
using stencil::DirectionField;
using tests::Grown;

namespace {

constexpr uint32_t kSeed = 3;
const double kPi = std::acos(-1.0);

// The doubled direction of a cell, Q7.
struct Doubled {
  int c, s;
  bool operator==(const Doubled& o) const { return c == o.c && s == o.s; }
};
double change(Doubled a, Doubled b) { return std::hypot(a.c - b.c, a.s - b.s); }

Doubled direction(const DirectionField& f, int32_t x, int32_t y) {
  int8_t c = 0, s = 0;
  stencil::directions(f, x, y, 1, &c, &s);
  return {c, s};
}

DirectionField field_of(stencil::Directions kind, uint16_t width, uint16_t height, uint16_t across, uint16_t down) {
  return {9, 0, 0, width, height, across, down, kind, kind == stencil::scalars ? int16_t{5325} : int16_t{0}};  // bend 1.3
}

// Quadratic B-splines over 3 x 3 hashed nodes, in double but for the place within a node's cell, which has 8 bits, and the
// weights, which have 7. size 0: the plane, where `nodes` is their distance. `steady`: the length of a blended vector.
struct Exact {
  double c, s, steady;
};
struct Place {
  int64_t node;
  double weight[3];
};
Place place_of(int64_t at, int size, int nodes) {
  if (size != 0) at = (at % size + size) % size;
  const int64_t scaled = (256 * at + 128) * (size == 0 ? 1 : nodes), by = size == 0 ? nodes : size;
  const int64_t q8 = scaled / by - (scaled % by < 0), f = (q8 % 256 + 256) % 256;
  const double before = static_cast<double>((256 - f) * (256 - f) / 1024), after = static_cast<double>(f * f / 1024);
  return {(q8 - f) / 256, {before / 128, (128 - before - after) / 128, after / 128}};
}
Exact exact(const DirectionField& f, int64_t x, int64_t y) {
  const auto folded = [](int64_t i, int size, int nodes) {
    return static_cast<int32_t>(size == 0 ? i : (i % nodes + nodes) % nodes);
  };
  const Place px = place_of(x + f.x, f.width, f.across), py = place_of(y + f.y, f.height, f.down);
  double a = 0, b = 0;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) {
      const int32_t column = folded(px.node + i - 1, f.width, f.across), row = folded(py.node + j - 1, f.height, f.down);
      const uint32_t h = dapple::base::hash(f.seed, 96, column, row) >> 16;
      const double w = px.weight[i] * py.weight[j], turn = 2 * kPi * h / 65536;
      a += w * (f.kind == stencil::scalars ? h / 32768.0 - 1 : std::cos(turn));
      b += w * (f.kind == stencil::scalars ? 0 : std::sin(turn));
    }
  const double turn = 2 * kPi * a * f.bend / 4096;
  if (f.kind == stencil::scalars) return {std::cos(turn), std::sin(turn), 1};
  const double inverse = std::min(1 / std::hypot(a, b), 16.0);
  return {a * inverse, b * inverse, std::hypot(a, b)};
}

// How much a direction may change from cell to cell: neighbouring nodes differ by 2 at most, in turns of `bend` or in
// vectors of the blended length; a step of the weights adds less than 16.
double steepest(const DirectionField& f, double steady) {
  const double across = f.width == 0 ? 1.0 * f.across : 1.0 * f.width / f.across;
  const double apart = std::min(across, f.height == 0 ? 1.0 * f.down : 1.0 * f.height / f.down);
  return 127 * 2 / apart * (f.kind == stencil::scalars ? 2 * kPi * f.bend / 4096 : 1 / steady) + 16;
}

// Directions of neighbours that change more, but for defects of vectors.
int tears(const DirectionField& f, int x, int y) {
  const double steady = exact(f, x, y).steady;
  if (steady < 0.2) return 0;
  const Doubled here = direction(f, x, y);
  return (change(here, direction(f, x + 1, y)) > steepest(f, steady)) + (change(here, direction(f, x, y + 1)) > steepest(f, steady));
}

const DirectionField kFields[] = {
    field_of(stencil::vectors, 200, 150, 3, 2), field_of(stencil::scalars, 200, 150, 3, 2),
    field_of(stencil::vectors, 131, 97, 1, 4),  field_of(stencil::scalars, 131, 97, 1, 4),
    field_of(stencil::vectors, 0, 0, 48, 48),   field_of(stencil::scalars, 0, 0, 64, 64),
    field_of(stencil::scalars, 0, 0, 16, 16),
};

}  // namespace

TEST_CASE("flow: directions are quadratic B-splines of hashed nodes") {
  for (const DirectionField& f : kFields) {
    double worst = 0, rough = 0;  // near defects vectors are amplified by up to 16
    for (int y = -160; y < 250; y += 3)
      for (int x = -170; x < 300; ++x) {
        const Doubled have = direction(f, x, y);
        const Exact want = exact(f, x, y);
        double& to = want.steady > 0.2 ? worst : rough;
        to = std::max(to, std::hypot(have.c / 128.0 - want.c, have.s / 128.0 - want.s));
      }
    CHECK(worst < 0.011);
    CHECK(rough < 0.017);
  }
}

TEST_CASE("flow: directions close on the torus, roll with it, and change little from cell to cell") {
  for (const DirectionField& f : kFields) {
    int wrong = 0, torn = 0;
    const bool torus = f.width != 0;
    for (int y = torus ? -1 : -200; y < (torus ? f.height : 200); ++y)
      for (int x = torus ? -1 : -200; x < (torus ? f.width : 200); ++x) {
        const Doubled here = direction(f, x, y);
        wrong += torus && !(here == direction(f, x + f.width, y - 2 * f.height));
        DirectionField moved = f;
        moved.x = 1234;
        moved.y = -77;
        wrong += !(here == direction(moved, x - 1234, y + 77));
        torn += tears(f, x, y);
      }
    CHECK(wrong == 0);
    CHECK(torn == 0);
  }
}

TEST_CASE("flow: directions of a row are those of its cells") {
  for (const DirectionField& f : kFields)
    for (const int x : {-70, 0, 33}) {
      int8_t c[100], s[100];
      stencil::directions(f, x, 21, 100, c, s);
      for (int k = 0; k < 100; ++k) CHECK(direction(f, x + k, 21) == Doubled{c[k], s[k]});
    }
}

// Node 2^23 and on: coordinates in 1/256 of a node no longer fit 32 bits.
TEST_CASE("flow: directions go on to the plane's end") {
  for (const stencil::Directions kind : {stencil::vectors, stencil::scalars})
    for (const int distance : {16, 48, 64, 200}) {
      DirectionField f = field_of(kind, 0, 0, static_cast<uint16_t>(distance), static_cast<uint16_t>(distance));
      for (const int32_t at : {-(1 << 30) + 100, -(1 << 29), -(1 << 27), 1 << 27, 1 << 29, (1 << 30) - 100, (1 << 23) * 48}) {
        f.x = at - 50;
        f.y = -at;
        int torn = 0;
        for (int x = 0; x < 100; ++x) torn += tears(f, x, x);
        CAPTURE(int(kind));
        CAPTURE(distance);
        CAPTURE(at);
        CHECK(torn == 0);
      }
    }
}

// --- The steered step against plain loops ----------------------------------------------------------------------------

namespace {

// A grid of numbers on a torus.
struct Torus {
  int width, height;
  std::vector<int> value;
  int at(int x, int y) const {
    return value[static_cast<size_t>((y % height + height) % height * width + (x % width + width) % width)];
  }
};

// A recipe's stage on a torus, as docs/numbers.md has it.
struct Plain {
  const int32_t* n;
  stencil::Mask mask[stencil::kSteerable];
  int16_t sum;
  DirectionField field;

  Plain(const Recipe& recipe, int width, int height) : n(recipe.stage[0].number) {
    const auto nodes = [&](int size) {
      return static_cast<uint16_t>(std::max(1.0, std::floor(1.0 * size / n[flow::nodes] + 0.5)));
    };
    REQUIRE(stencil::make_steerable({static_cast<uint8_t>(n[flow::radius]), false, n[flow::scale], n[flow::stretch], 0}, mask, sum));
    field = {kSeed, 0, 0, static_cast<uint16_t>(width), static_cast<uint16_t>(height), nodes(width), nodes(height),
             static_cast<uint8_t>(n[flow::field]), static_cast<int16_t>(int64_t{n[flow::bend]} * 4096 / 1000000)};
  }
  // 128 D: the most of the threads.
  int steered(const Torus& cells, int x, int y) const {
    int d[stencil::kSteerable] = {}, most = INT32_MIN;
    const int r = n[flow::radius], side = 2 * r + 1;
    for (int m = 0; m < 5; ++m)
      for (int i = 0; i < side * side; ++i)
        if (mask[m].weight[i] != 0) d[m] += mask[m].weight[i] * cells.at(x + i % side - r, y + i / side - r);
    const Doubled here = direction(field, x, y);
    const auto unit = [](int q15) { return std::max(-127, std::min(127, static_cast<int>(std::floor(q15 / 256.0 + 0.5)))); };
    const auto q7 = [](int value) { return static_cast<int>(std::floor(value / 128.0 + 0.5)); };
    for (int t = 0; t < n[flow::threads]; ++t) {
      const uint16_t twice = static_cast<uint16_t>(2 * dapple::base::angle_of(n[flow::angles + t]));
      const int tc = unit(dapple::base::cosine(twice)), ts = unit(dapple::base::sine(twice));
      const int c2 = q7(here.c * tc - here.s * ts), s2 = q7(here.s * tc + here.c * ts);
      const int c4 = q7(c2 * c2 - s2 * s2), s4 = q7(2 * c2 * s2);
      most = std::max(most, 128 * d[0] + c2 * d[1] + s2 * d[2] + c4 * d[3] + s4 * d[4]);
    }
    return most;
  }
  template <class Value>
  Torus each(const Torus& cells, Value value) const {
    Torus to = cells;
    for (int i = 0; i < cells.width * cells.height; ++i) to.value[static_cast<size_t>(i)] = value(steered(cells, i % cells.width, i / cells.width));
    return to;
  }
};

// Instead of the field's kernel: the cells themselves.
void show_cells(const grid::Rows& rows) {
  const stencil::SteerSet& set = *reinterpret_cast<const stencil::SteerSet*>(rows.table);
  const uint8_t* row = static_cast<const uint8_t*>(rows.in[set.masks.radius]);
  for (int32_t x = 0; x < rows.n; ++x) grid::out16(rows, 0)[x] = grid::get_bit(row, x);
}
const grid::KernelSwap kShowCells[] = {{stencil::steer_field, show_cells}, {nullptr, nullptr}};
const grid::KernelSwap kByTable[] = {
    {stencil::steer_row, stencil::steer_by_table}, {stencil::steer_field, stencil::steer_field_by_table}, {nullptr, nullptr}};

Torus grown(const Recipe& recipe, dapple::Domain d, const dapple::Options& options, uint32_t budget = UINT32_MAX) {
  Grown tile(recipe, d, kSeed, budget, options);
  REQUIRE(tile.status == dapple::ok);
  const std::vector<int16_t> field = tile.field();
  return {d.width, d.height, {field.begin(), field.end()}};
}

void check_definition(Recipe recipe, uint16_t width, uint16_t height) {
  const uint32_t steps = recipe.stage[0].steps;
  const Plain plain(recipe, width, height);
  dapple::Options cells, field;
  cells.kernels = kShowCells;
  recipe.stage[0].steps = 0;
  Torus want = grown(recipe, dapple::torus(width, height), cells);
  recipe.stage[0].steps = steps;
  for (uint32_t step = 0; step < steps; ++step) {
    const int32_t rho = dapple::scheduled(recipe.stage[0].number + flow::rho, {step, steps});
    const int threshold = 128 * static_cast<int>(std::floor(rho * 1e-6 * plain.sum + 0.5 + 1e-9));
    want = plain.each(want, [&](int d) { return d > threshold; });
  }
  CHECK(grown(recipe, dapple::torus(width, height), cells).value == want.value);
  const int factor = static_cast<int>(std::floor(256.0 * 8000 / plain.sum + 0.5));
  want = plain.each(want, [&](int d) { return static_cast<int>(std::max(-8000.0, std::min(8000.0, std::floor(d * (factor / 32768.0) + 0.5)))); });
  CHECK(grown(recipe, dapple::torus(width, height), field).value == want.value);
}

struct Dice {
  std::mt19937 random;
  int32_t roll(int32_t low, int32_t high) {
    return low + static_cast<int32_t>(random() % static_cast<uint32_t>(high - low + 1));
  }
  Recipe recipe(uint8_t level) {
    Recipe recipe = tests::recipe_of("flow");
    recipe.stage[0].level = level;
    recipe.stage[0].steps = static_cast<uint32_t>(roll(1, 4));
    int32_t* n = recipe.stage[0].number;
    n[flow::threads] = roll(1, 5);
    n[flow::field] = roll(0, 1);
    n[flow::nodes] = roll(16, 90);
    n[flow::bend] = roll(0, 3000000);
    n[flow::radius] = roll(4, 8);
    n[flow::scale] = std::max(4000000, roll(n[flow::radius] * 800000, n[flow::radius] * 2200000));
    n[flow::stretch] = roll(1000000, 5000000);
    for (int j = 0; j < 5; ++j) n[flow::angles + j] = roll(-360000000, 360000000);
    for (int j = 0; j < 2; ++j) n[flow::rho + j] = roll(flow::living(n).low, flow::living(n).high);
    n[flow::rho + 3] = roll(0, 1000000);
    n[flow::rho + 2] = roll(0, n[flow::rho + 3]);
    return recipe;
  }
  // At least two wavelengths.
  dapple::Domain torus(const Recipe& recipe, int more) {
    const int level = recipe.stage[0].level, least = recipe.stage[0].number[flow::scale] / 500000 + 1;
    return dapple::torus(static_cast<uint16_t>((least + roll(0, more)) << level), static_cast<uint16_t>((least + roll(0, 20)) << level));
  }
};

std::vector<std::string> presets() {
  std::vector<std::string> names;
  for (uint16_t i = 0; i < dapple::preset_count(); ++i) {
    char name[dapple::kMaxName];
    const dapple::PresetEntry entry = dapple::preset_at(i, name);
    if (dapple::load(*entry.preset).stage[0].model == &dapple::flow_model) names.push_back(name);
  }
  return names;
}

}  // namespace

TEST_CASE("flow: every preset and random recipes are their definition") {
  CHECK(presets().size() == 5);
  for (const std::string& name : presets()) {
    CAPTURE(name);
    check_definition(tests::preset_with(name.c_str(), "level=0"), 41, 33);
    check_definition(tests::preset_with(name.c_str(), "level=0 steps=4"), 131, 24);
  }
  Dice dice{std::mt19937(5)};
  for (int i = 0; i < 40; ++i) {
    const Recipe recipe = dice.recipe(0);
    const dapple::Domain d = dice.torus(recipe, 40);
    CAPTURE(i);
    check_definition(recipe, d.width, d.height);
  }
}

TEST_CASE("flow: kernels, bands and budgets give the same bits on torus and plane; windows are parts of bigger windows") {
  Dice dice{std::mt19937(6)};
  for (int i = 0; i < 45; ++i) {
    const Recipe recipe = i < 5 ? dapple::load(*dapple::find_preset(presets()[static_cast<size_t>(i)].c_str())) : dice.recipe(static_cast<uint8_t>(i % 3));
    const int32_t far = i % 2 == 0 ? 1 : 900000;
    const int32_t x = dice.roll(-1000, 1000) * far, y = dice.roll(-1000, 1000) * far;
    const dapple::Domain torus = dice.torus(recipe, 90), window = dapple::window(x, y, 90, 40);
    CAPTURE(i);
    for (const dapple::Domain& d : {torus, window}) {
      const Torus want = grown(recipe, d, dapple::Options{});
      for (uint8_t bands = 1; bands <= 3; ++bands)
        for (const grid::KernelSwap* kernels : {static_cast<const grid::KernelSwap*>(nullptr), kByTable}) {
          const uint32_t budgets[] = {1, 7, UINT32_MAX};
          dapple::Options options;
          options.bands = bands;
          options.kernels = kernels;
          CHECK(grown(recipe, d, options, budgets[dice.roll(0, 2)]).value == want.value);
        }
    }
    const int dx = dice.roll(0, 50), dy = dice.roll(0, 25);
    const Torus big = grown(recipe, window, dapple::Options{}), part = grown(recipe, dapple::window(x + dx, y + dy, 40, 15), dapple::Options{});
    int wrong = 0;
    for (int k = 0; k < 40 * 15; ++k) wrong += part.at(k % 40, k / 40) != big.at(k % 40 + dx, k / 40 + dy);
    CHECK(wrong == 0);
  }
}
