// Binary convolution along a field of directions: the steered step against plain loops, kernels, windows; grown stripes
// follow the field. The field itself: tests/directions.cpp.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>

#include "onebit.hpp"

namespace flow = dapple::flow;
namespace grid = dapple::grid;
namespace stencil = dapple::stencil;
using dapple::Recipe;
using tests::grown;
using tests::made;
using tests::Torus;

namespace {

constexpr uint32_t kSeed = 3;
const double kPi = std::acos(-1.0);

// A recipe's stage on a torus, as docs/numbers.md has it.
struct Plain {
  const int32_t* n;
  stencil::Mask mask[stencil::kSteerable];
  int16_t sum;
  stencil::DirectionField field;

  Plain(const Recipe& recipe, int width, int height) : n(recipe.stage[0].number) {
    const auto nodes = [&](int size) {
      return static_cast<uint16_t>(std::max(1.0, std::floor(1.0 * size / n[flow::nodes] + 0.5)));
    };
    REQUIRE(stencil::make_steerable({static_cast<uint8_t>(n[flow::radius]), false, n[flow::scale], n[flow::stretch], 0},
                                    mask, sum));
    field = {kSeed,
             0,
             0,
             static_cast<uint16_t>(width),
             static_cast<uint16_t>(height),
             nodes(width),
             nodes(height),
             static_cast<uint8_t>(n[flow::field]),
             static_cast<int16_t>(int64_t{n[flow::bend]} * 4096 / 1000000)};
  }
  // 128 D: the most of the threads.
  int steered(const Torus& cells, int x, int y) const {
    int d[stencil::kSteerable] = {}, most = INT32_MIN;
    const int r = n[flow::radius], side = 2 * r + 1;
    for (int m = 0; m < 5; ++m)
      for (int i = 0; i < side * side; ++i)
        if (mask[m].weight[i] != 0) d[m] += mask[m].weight[i] * cells.at(x + i % side - r, y + i / side - r);
    int8_t c = 0, s = 0;
    stencil::directions(field, x, y, 1, &c, &s);
    const auto unit = [](int q15) {
      return std::max(-127, std::min(127, static_cast<int>(std::floor(q15 / 256.0 + 0.5))));
    };
    const auto q7 = [](int value) { return static_cast<int>(std::floor(value / 128.0 + 0.5)); };
    for (int t = 0; t < n[flow::threads]; ++t) {
      const uint16_t twice = static_cast<uint16_t>(2 * dapple::base::angle_of(n[flow::angles + t]));
      const int tc = unit(dapple::base::cosine(twice)), ts = unit(dapple::base::sine(twice));
      const int c2 = q7(c * tc - s * ts), s2 = q7(s * tc + c * ts);
      const int c4 = q7(c2 * c2 - s2 * s2), s4 = q7(2 * c2 * s2);
      most = std::max(most, 128 * d[0] + c2 * d[1] + s2 * d[2] + c4 * d[3] + s4 * d[4]);
    }
    return most;
  }
  template <class Value>
  Torus each(const Torus& cells, Value value) const {
    return made(cells.width, cells.height, [&](int x, int y) { return value(steered(cells, x, y)); });
  }
};

// Instead of the field's kernel: the cells themselves.
void show_cells(const grid::Rows& rows) {
  const stencil::SteerSet& set = *reinterpret_cast<const stencil::SteerSet*>(rows.table);
  const uint8_t* row = static_cast<const uint8_t*>(rows.in[set.masks.radius]);
  for (int32_t x = 0; x < rows.n; ++x) grid::out16(rows, 0)[x] = grid::get_bit(row, x) ? 8000 : 0;
}
const grid::KernelSwap kShowCells[] = {{stencil::steer_field, show_cells}, {nullptr, nullptr}};
const grid::KernelSwap kByTable[] = {{stencil::steer_row, stencil::steer_by_table},
                                     {stencil::steer_field, stencil::steer_field_by_table},
                                     {nullptr, nullptr}};

Torus library_cells(const Recipe& recipe, dapple::Domain d) { return tests::grown_cells(recipe, d, kSeed, kShowCells); }

void check_definition(const Recipe& recipe, dapple::Domain d) {
  const uint32_t steps = recipe.stage[0].steps;
  const Plain plain(recipe, d.width, d.height);
  Recipe start = recipe;
  start.stage[0].steps = 0;
  Torus want = library_cells(start, d);
  for (uint32_t step = 0; step < steps; ++step) {
    const int32_t rho = dapple::scheduled(recipe.stage[0].number + flow::rho, {step, steps});
    const int threshold = 128 * static_cast<int>(tests::floor_divide(int64_t{2} * rho * plain.sum + 1000000, 2000000));
    want = plain.each(want, [&](int d128) { return d128 > threshold; });
  }
  CHECK(library_cells(recipe, d) == want);
  const int64_t factor = tests::floor_divide(2 * 256 * 8000 + plain.sum, 2 * plain.sum);
  CHECK(grown(recipe, d, kSeed) == plain.each(want, [&](int d128) {
    return static_cast<int>(
        std::max<int64_t>(-8000, std::min<int64_t>(8000, tests::floor_divide(d128 * factor + 16384, 32768))));
  }));
}

struct Dice : tests::Dice {
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
  dapple::Domain torus(const Recipe& recipe) {
    return tests::Dice::torus(recipe, recipe.stage[0].number[flow::scale], 70, 20);
  }
};
Dice dice_of(uint32_t seed) { return {{std::mt19937(seed)}}; }

}  // namespace

TEST_CASE("flow: every preset and random recipes are their definition") {
  const std::vector<std::string> presets = tests::presets_of(&dapple::flow_model);
  CHECK(presets.size() == 5);
  for (const std::string& name : presets) {
    CAPTURE(name);
    check_definition(tests::preset_with(name.c_str(), "level=0"), dapple::torus(41, 33));
    check_definition(tests::preset_with(name.c_str(), "level=0 steps=4"), dapple::torus(131, 24));
  }
  Dice dice = dice_of(5);
  for (int i = 0; i < 25; ++i) {
    const Recipe recipe = dice.recipe(0);
    CAPTURE(i);
    check_definition(recipe, dice.torus(recipe));
  }
}

static void check_variants(const Recipe& recipe, dapple::Domain d, Dice& dice) {
  const Torus want = grown(recipe, d, kSeed);
  for (uint8_t bands = 1; bands <= 3; ++bands)
    for (const bool table : {false, true}) {
      const uint32_t budgets[] = {1, 7, UINT32_MAX};
      dapple::Options options;
      options.bands = bands;
      options.kernels = table ? kByTable : nullptr;
      CHECK(grown(recipe, d, kSeed, options, budgets[dice.roll(0, 2)]) == want);
    }
}

TEST_CASE("flow: kernels, bands and budgets give the same bits on torus and plane") {
  Dice dice = dice_of(6);
  for (const std::string& name : tests::presets_of(&dapple::flow_model)) {
    const Recipe recipe = tests::preset(name);
    CAPTURE(name);
    check_variants(recipe, dice.torus(recipe), dice);
  }
  for (int i = 0; i < 24; ++i) {
    const Recipe recipe = dice.recipe(static_cast<uint8_t>(i % 3));
    const int32_t far = i % 2 == 0 ? 1 : 900000;
    CAPTURE(i);
    check_variants(recipe, dice.torus(recipe), dice);
    check_variants(recipe, dapple::window(dice.roll(-999, 999) * far, dice.roll(-999, 999) * far, 70, 31), dice);
  }
}

TEST_CASE("flow: windows are parts of bigger windows, random recipes") {
  Dice dice = dice_of(7);
  for (int i = 0; i < 40; ++i) {
    const Recipe recipe = dice.recipe(static_cast<uint8_t>(i % 3));
    const int32_t x = dice.roll(-100000000, 100000000) * 10, y = dice.roll(-500, 500);
    const int dx = dice.roll(0, 50), dy = dice.roll(0, 25);
    const Torus big = grown(recipe, dapple::window(x, y, 90, 45), kSeed);
    CAPTURE(i);
    CHECK(grown(recipe, dapple::window(x + dx, y + dy, 40, 20), kSeed) ==
          made(40, 20, [&](int px, int py) { return big.at(px + dx, py + dy); }));
  }
}

TEST_CASE("flow: a coarse grid grows like a fine one of its size, rolled too") {
  for (const char* name : {"fingerprint", "swirl-weave"})
    for (const int level : {1, 2}) {
      Recipe recipe = tests::preset_with(name, "level=0");
      const Torus fine = library_cells(recipe, dapple::torus(150, 110, 11, -20));
      recipe.stage[0].level = static_cast<uint8_t>(level);
      const int by = 1 << level;
      CHECK(library_cells(recipe, dapple::torus(static_cast<uint16_t>(150 * by), static_cast<uint16_t>(110 * by),
                                                11 * by, -20 * by)) == fine);
    }
}

// --- Grown stripes follow the field ----------------------------------------------------------------------------------

// Degrees between the stripes' local orientation (structure tensor, Gaussian of sigma cells) and the field's, every
// fourth cell.
static std::vector<double> deviations(const Recipe& recipe, int side, double sigma) {
  const Torus field = grown(recipe, dapple::torus(static_cast<uint16_t>(side), static_cast<uint16_t>(side)), kSeed);
  const Plain plain(recipe, side, side);
  const int reach = static_cast<int>(3 * sigma);
  std::vector<double> off;
  for (int y = 0; y < side; y += 4)
    for (int x = 0; x < side; x += 4) {
      double cosine = 0, sine = 0;  // of twice the gradient's angle, times its square
      for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx) {
          const double gx = field.at(x + dx + 1, y + dy) - field.at(x + dx - 1, y + dy);
          const double gy = field.at(x + dx, y + dy + 1) - field.at(x + dx, y + dy - 1);
          const double w = std::exp(-(dx * dx + dy * dy) / (2 * sigma * sigma));
          cosine += w * (gx * gx - gy * gy);
          sine += w * 2 * gx * gy;
        }
      int8_t c = 0, s = 0;
      stencil::directions(plain.field, x, y, 1, &c, &s);
      const double twice = std::atan2(-sine, -cosine) - std::atan2(s, c);  // stripes lie across the gradient
      off.push_back(std::fabs(std::remainder(twice, 2 * kPi)) * 90 / kPi);
    }
  return off;
}

// Measured: 90 % within 7.8 degrees, 99 % within 12.8 (seeds differ by half a degree).
TEST_CASE("flow: stripes follow the field") {
  for (const char* name : {"flowing-stripes", "fingerprint"}) {
    std::vector<double> off = deviations(tests::preset_with(name, "level=0"), 256, 4);
    std::sort(off.begin(), off.end());
    INFO(std::string(name) << " median " << off[off.size() / 2] << " 90 %: " << off[off.size() * 9 / 10]);
    CHECK(off[off.size() / 2] < 4);
    CHECK(off[off.size() * 9 / 10] < 9);
    CHECK(off[off.size() * 99 / 100] < 15);
  }
}

TEST_CASE("flow: numbers beyond their ranges are refused with bounds, by hand as a bad recipe") {
  constexpr int32_t kM = 1000000;
  for (const tests::Beyond& beyond : std::vector<tests::Beyond>{{"flow window=9", 4, 8},
                                                                {"flow threads=0", 1, 5},
                                                                {"flow nodes=15", 16, 1024},
                                                                {"flow bend=3.1", 0, 3 * kM},
                                                                {"flow scale=19", 4 * kM, 18 * kM},
                                                                {"flow window=4 scale=9", 4 * kM, 8800000},
                                                                {"flow level=3", 0, 2},
                                                                {"flow rho=.451", -450000, 450000},
                                                                {"flow threads=2 rho=-.121", -120000, 430000},
                                                                {"flow threads=3 rho=.391", -120000, 390000}})
    tests::check_refused(beyond);
  for (const auto& [slot, value] : std::vector<std::pair<int, int32_t>>{{flow::threads, 6},
                                                                        {flow::field, 2},
                                                                        {flow::nodes, 15},
                                                                        {flow::nodes, 1025},
                                                                        {flow::bend, 3000001},
                                                                        {flow::radius, 9},
                                                                        {flow::scale, 4700000},
                                                                        {flow::scale, 13200001},
                                                                        {flow::stretch, 900000},
                                                                        {flow::angles, -720000001},
                                                                        {flow::rho, 430001}})
    tests::check_refused(tests::preset("swirl-weave"), slot, value);
}
