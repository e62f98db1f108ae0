// Binary convolution against its definition: plain sums over the weights of whole tori, double-buffered; kernels,
// bands, budgets and windows that must not change a bit; starts; what is refused.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>

#include "onebit.hpp"
#include "stencil/convolve.hpp"

namespace bits = dapple::bits;
namespace grid = dapple::grid;
namespace stencil = dapple::stencil;
using dapple::Recipe;
using tests::floor_divide;
using tests::grown;
using tests::made;
using tests::presets_of;
using tests::Torus;

namespace {

constexpr uint32_t kSeed = 11;

// The masks of a recipe's stage; difference-abs of two is one mask.
std::vector<stencil::Mask> masks_of(const int32_t* n) {
  std::vector<stencil::MaskShape> shapes;
  for (int j = 0; j < n[bits::masks]; ++j)
    shapes.push_back({static_cast<uint8_t>(n[bits::radius]), n[bits::diffusion] == bits::isotropic, n[bits::scale],
                      n[bits::stretch], dapple::base::angle_of(n[bits::angles + j])});
  const bool summed = n[bits::masks] == 2 && n[bits::react] == 1;
  std::vector<stencil::Mask> masks(summed ? 1 : shapes.size());
  for (size_t j = 0; j < masks.size(); ++j)
    REQUIRE(stencil::make_mask(&shapes[j], static_cast<uint8_t>(summed ? 2 : 1), masks[j]));
  return masks;
}

// D of every cell: the largest of the sums, plus the least where the rule says so.
Torus differences(const int32_t* n, const Torus& cells) {
  const int r = n[bits::radius], side = 2 * r + 1;
  const std::vector<stencil::Mask> masks = masks_of(n);
  const Torus wide =
      made(cells.width + 2 * r, cells.height + 2 * r, [&](int x, int y) { return cells.at(x - r, y - r); });
  return made(cells.width, cells.height, [&](int x, int y) {
    int most = INT32_MIN, least = INT32_MAX;
    for (const stencil::Mask& m : masks) {
      int sum = 0;
      for (int j = 0; j < side; ++j) {
        const int* row = &wide.value[static_cast<size_t>((y + j) * wide.width + x)];
        for (int i = 0; i < side; ++i) sum += m.weight[j * side + i] * row[i];
      }
      most = std::max(most, sum);
      least = std::min(least, sum);
    }
    return masks.size() > 1 && n[bits::react] == 1 ? most + least : most;
  });
}

// rho of a step in 1/1000000 and round(rho P), halves up.
int threshold_at(const int32_t* n, uint32_t step, uint32_t steps, int sum) {
  const int32_t* s = n + bits::rho;
  const int64_t one = 1000000, at = one * step, begin = int64_t{s[2]} * steps, end = int64_t{s[3]} * steps;
  int64_t rho = at < begin ? s[0] : s[1];
  if (at >= begin && at < end)
    rho = s[0] + floor_divide(int64_t{2} * (s[1] - s[0]) * (at - begin) + (end - begin), 2 * (end - begin));
  return static_cast<int>(floor_divide(2 * rho * sum + one, 2 * one));
}

Torus grown_plainly(const Recipe& recipe, Torus cells) {
  const dapple::Stage& stage = recipe.stage[0];
  const int sum = masks_of(stage.number)[0].sum;
  for (uint32_t step = 0; step < stage.steps; ++step) {
    const int threshold = threshold_at(stage.number, step, stage.steps, sum);
    cells = differences(stage.number, cells);
    for (int& value : cells.value) value = value > threshold;
  }
  return cells;
}

// 8000 D / P, held within +-8000.
Torus field_plainly(const Recipe& recipe, const Torus& cells) {
  const int32_t* n = recipe.stage[0].number;
  const int sum = masks_of(n)[0].sum;
  Torus d = differences(n, cells);
  const int64_t factor = floor_divide(2 * 256 * 8000 + sum, 2 * sum);
  for (int& value : d.value) {
    const double exact = std::max(-8000.0, std::min(8000.0, 8000.0 * value / sum));
    value =
        static_cast<int>(std::max<int64_t>(-8000, std::min<int64_t>(8000, floor_divide(value * factor + 128, 256))));
    if (std::fabs(value - exact) > 1) FAIL("the field is 8000 D / P");
  }
  return d;
}

// Twofold: 3/4 of the cell a finer one lies in and 1/4 of the one beside it, first down, then across.
Torus enlarged(const Torus& coarse) {
  const auto beside = [](int i) { return i % 2 == 0 ? i / 2 - 1 : i / 2 + 1; };
  const Torus tall = made(coarse.width, 2 * coarse.height, [&](int x, int y) {
    return static_cast<int>(floor_divide(3 * coarse.at(x, y / 2) + coarse.at(x, beside(y)) + 2, 4));
  });
  return made(2 * coarse.width, 2 * coarse.height, [&](int x, int y) {
    return static_cast<int>(floor_divide(3 * tall.at(x / 2, y) + tall.at(beside(x), y) + 2, 4));
  });
}
Torus enlarged(const Torus& coarse, int level) { return level == 0 ? coarse : enlarged(enlarged(coarse), level - 1); }

// Instead of the field's kernel: the cells themselves, 8000 where they are on.
void show_cells(const grid::Rows& rows) {
  const uint8_t* row = static_cast<const uint8_t*>(rows.in[stencil::mask_set(rows).radius]);
  for (int32_t x = 0; x < rows.n; ++x) grid::out16(rows, 0)[x] = grid::get_bit(row, x) ? 8000 : 0;
}
const grid::KernelSwap kShowCells[] = {{stencil::field_row, show_cells}, {nullptr, nullptr}};

Torus library_cells(const Recipe& recipe, dapple::Domain d) { return tests::grown_cells(recipe, d, kSeed, kShowCells); }

bool agrees(const Recipe& recipe, dapple::Domain d) {
  Recipe start = recipe;
  start.stage[0].steps = 0;
  const Torus cells = grown_plainly(recipe, library_cells(start, d));
  CHECK(library_cells(recipe, d) == cells);
  return grown(recipe, d, kSeed) == enlarged(field_plainly(recipe, cells), recipe.stage[0].level);
}

// Any masks, rule, angles and a threshold in the living range.
struct Dice : tests::Dice {
  Recipe recipe(uint8_t level) {
    Recipe recipe = tests::recipe_of("bits");
    recipe.stage[0].level = level;
    recipe.stage[0].steps = static_cast<uint32_t>(roll(0, 6));
    int32_t* n = recipe.stage[0].number;
    n[bits::masks] = roll(1, 5);
    n[bits::react] = roll(0, 1);
    n[bits::diffusion] = roll(0, 3) == 0;
    n[bits::radius] = roll(4, 8);
    n[bits::scale] = std::max(4000000, roll(n[bits::radius] * 800000, n[bits::radius] * 2200000));
    n[bits::stretch] = roll(1000000, 5000000);
    for (int j = 0; j < 5; ++j) n[bits::angles + j] = roll(-360000000, 360000000);
    const bits::Living living = bits::living(n);
    for (int j = 0; j < 2; ++j) n[bits::rho + j] = roll(living.low, living.high);
    n[bits::rho + 3] = roll(0, 1000000);
    n[bits::rho + 2] = roll(0, n[bits::rho + 3]);
    return recipe;
  }
  dapple::Domain torus(const Recipe& recipe) {
    return tests::Dice::torus(recipe, recipe.stage[0].number[bits::scale], 110, 20);
  }
};
Dice dice_of(uint32_t seed) { return {{std::mt19937(seed)}}; }

}  // namespace

TEST_CASE("bits: every preset is its definition, on grids of 1, 1/2 and 1/4") {
  const std::vector<std::string> names = presets_of(&dapple::bits_model);
  CHECK(names.size() == 13);
  Dice dice = dice_of(1);
  for (const std::string& name : names)
    for (const int level : {0, 1, 2})
      for (int i = 0; i < 3; ++i) {
        const Recipe recipe = tests::preset_with(name.c_str(), ("level=" + std::to_string(level)).c_str());
        const dapple::Domain d = dice.torus(recipe);
        INFO(name << " level " << level << " " << d.width << "x" << d.height);
        CHECK(agrees(recipe, d));
      }
}

TEST_CASE("bits: random recipes are their definition") {
  Dice dice = dice_of(2);
  for (int i = 0; i < 150; ++i) {
    const Recipe recipe = dice.recipe(static_cast<uint8_t>(i % 8 == 7 ? 2 : i % 2));
    CAPTURE(i);
    CHECK(agrees(recipe, dice.torus(recipe)));
  }
}

// The smallest sides there are, below the mask's own, and every height modulo eight.
TEST_CASE("bits: tiles smaller than their masks, and seams at every height") {
  for (const int level : {0, 1, 2})
    for (int side = 8; side <= 24; ++side) {
      const dapple::Domain d =
          dapple::torus(static_cast<uint16_t>((32 - side) << level), static_cast<uint16_t>(side << level));
      Recipe recipe = tests::preset_with(side % 2 == 0 ? "weave-bits" : "labyrinth-bits", "window=5 scale=4.2 steps=4");
      recipe.stage[0].level = static_cast<uint8_t>(level);
      CAPTURE(level);
      CAPTURE(side);
      CHECK(agrees(recipe, d));
    }
}

// --- What must not change a bit --------------------------------------------------------------------------------------

enum Solver { sliced, lean, stored };
struct Variant {
  const char* name;
  Solver solver;
  grid::KernelSwap swap[3];
};
static const Variant kVariants[] = {
    {"as it is", sliced, {{nullptr, nullptr}}},
    {"by table",
     sliced,
     {{stencil::convolve_row, stencil::convolve_by_table}, {stencil::field_row, stencil::field_by_table}}},
    {"8 bits", sliced, {{stencil::convolve_row, stencil::convolve_row8}}},
    {"32 bits", sliced, {{stencil::convolve_row, stencil::convolve_row32}}},
    {"64 bits", sliced, {{stencil::convolve_row, stencil::convolve_row64}}},
    {"lean", lean, {{nullptr, nullptr}}},
    {"lean by table", lean, {{stencil::convolve_lean, stencil::convolve_by_table}}},
    {"stored", stored, {{nullptr, nullptr}}},
};

// Masks made ahead of the run, as a compiler does; those of fewer masks are the beginning of those of more.
using Stored = stencil::StoredMasks<stencil::kMaxMasks>;
template <uint8_t n>
static void store(const int32_t* number, Stored& to) {
  const stencil::StoredMasks<n> made = dapple::evolve::stored_masks<n>(number);
  if (made.set.count == n) std::memcpy(static_cast<void*>(&to), &made, sizeof made);
}
static Stored stored_of(const int32_t* number) {
  Stored all{};
  store<1>(number, all);
  store<2>(number, all);
  store<3>(number, all);
  store<4>(number, all);
  store<5>(number, all);
  return all;
}

static void check_variants(const Recipe& recipe, const dapple::Domain& domain, Dice& dice) {
  const Torus want = grown(recipe, domain, kSeed);
  const Stored masks = stored_of(recipe.stage[0].number);
  for (const Variant& v : kVariants)
    for (uint8_t bands = 1; bands <= 3; ++bands) {
      Recipe changed = recipe;
      if (v.solver == lean) changed.stage[0].solver = &dapple::evolve::lean;
      if (v.solver == stored) changed.stage[0].solver = &dapple::evolve::stored;
      changed.stage[0].stored = &masks;
      dapple::Options options;
      options.bands = bands;
      options.kernels = v.swap;
      const uint32_t budgets[] = {1, 3, 50, UINT32_MAX};
      const uint32_t budget = budgets[dice.roll(0, 3)];
      INFO(std::string(v.name) << " bands " << int(bands) << " budget " << budget);
      CHECK(grown(changed, domain, kSeed, options, budget) == want);
    }
}

TEST_CASE("bits: kernels, solvers, bands and budgets give the same bits, every preset") {
  Dice dice = dice_of(3);
  for (const std::string& name : presets_of(&dapple::bits_model)) {
    const Recipe recipe = tests::preset(name);
    CAPTURE(name);
    check_variants(recipe, dice.torus(recipe), dice);
  }
}

TEST_CASE("bits: kernels, solvers, bands and budgets give the same bits, random recipes") {
  Dice dice = dice_of(4);
  for (int i = 0; i < 60; ++i) {
    const Recipe recipe = dice.recipe(static_cast<uint8_t>(i % 3));
    CAPTURE(i);
    check_variants(recipe, dice.torus(recipe), dice);
    const auto far = [&] { return dice.roll(-1000, 1000) * (i % 5 == 0 ? 1000003 : 1); };
    const auto side = [&] { return static_cast<uint16_t>(dice.roll(8, 90)); };
    check_variants(recipe, dapple::window(far(), far(), side(), side()), dice);
  }
}

TEST_CASE("bits: windows are parts of bigger windows, random recipes") {
  Dice dice = dice_of(5);
  for (int i = 0; i < 60; ++i) {
    const Recipe recipe = dice.recipe(static_cast<uint8_t>(i % 3));
    const int32_t x = dice.roll(-100000000, 100000000) * 10, y = dice.roll(-500, 500);
    const int dx = dice.roll(0, 50), dy = dice.roll(0, 50);
    const Torus big = grown(recipe, dapple::window(x, y, 90, 70), kSeed);
    CAPTURE(i);
    CHECK(grown(recipe, dapple::window(x + dx, y + dy, 40, 20), kSeed) ==
          made(40, 20, [&](int px, int py) { return big.at(px + dx, py + dy); }));
  }
}

// --- Starts ----------------------------------------------------------------------------------------------------------

static Torus start_of(const char* preset, const char* changes, dapple::Domain d) {
  Recipe recipe = tests::preset_with(preset, changes);
  recipe.stage[0].steps = 0;
  return library_cells(recipe, d);
}

// tests/cells.cpp holds the starts of one-bit cells to their definition, on the finest grid.
TEST_CASE("bits: a coarse grid starts like a fine one of its size") {
  const auto same = [](const char* preset, const char* coarse, dapple::Domain c, const char* fine, dapple::Domain f) {
    return start_of(preset, coarse, c) == start_of(preset, fine, f);
  };
  using dapple::torus;
  using dapple::window;
  CHECK(same("zebra-bits", "level=1", torus(104, 84, 10, -36), "level=0", torus(52, 42, 5, -18)));
  CHECK(same("zebra-bits", "level=2", torus(104, 84, 40, -36), "level=0", torus(26, 21, 10, -9)));
  CHECK(same("zebra-bits", "level=2", window(-104, 84, 40, 36), "level=0", window(-26, 21, 10, 9)));
  const char* half = "level=0 pitch=13 radius=2.6";
  CHECK(same("reptile-bits", "level=1", torus(150, 90, 10, -36), half, torus(75, 45, 5, -18)));
  CHECK(same("reptile-bits", "level=1", window(-150, 90, 80, 70), half, window(-75, 45, 40, 35)));
  CHECK(same("reptile-bits", "level=2", window(-152, 88, 80, 72), "level=0 pitch=6.5 radius=1.3",
             window(-38, 22, 20, 18)));
}

// --- What is refused -------------------------------------------------------------------------------------------------

TEST_CASE("bits: numbers beyond their ranges are refused with bounds") {
  constexpr int32_t kM = 1000000;
  for (const tests::Beyond& beyond :
       std::vector<tests::Beyond>{{"bits window=9", 4, 8},
                                  {"bits window=3", 4, 8},
                                  {"bits masks=0", 1, 5},
                                  {"bits masks=6", 1, 5},
                                  {"bits scale=18.000001", 4 * kM, 18 * kM},
                                  {"bits scale=3.999999", 4 * kM, 18 * kM},
                                  {"bits window=4", 4 * kM, 8800000},
                                  {"bits scale=6 window=8", 6400000, 17600000},
                                  {"bits level=3", 0, 2},
                                  {"bits stretch=5.1", kM, 5 * kM},
                                  {"bits stretch=.9", kM, 5 * kM},
                                  {"bits rho=.6", -500000, 500000},
                                  {"bits diffusion=isotropic rho=.441", -440000, 440000},
                                  {"bits diffusion=isotropic rho=0:-.441@.3", -440000, 440000},
                                  {"bits masks=2 rho=-.121", -120000, 450000},
                                  {"bits masks=3 rho=.451", -120000, 450000},
                                  {"bits masks=5 rho=.431", -120000, 430000},
                                  {"bits masks=2 react=da rho=.351", -370000, 350000},
                                  {"bits masks=3 react=da rho=-.431", -430000, 430000}})
    tests::check_refused(beyond);
}

TEST_CASE("bits: begin distrusts recipes made by hand") {
  const Recipe coral = tests::preset("coral-bits");
  for (const auto& [slot, value] : std::vector<std::pair<int, int32_t>>{{bits::masks, 0},
                                                                        {bits::masks, 6},
                                                                        {bits::react, 2},
                                                                        {bits::diffusion, 2},
                                                                        {bits::radius, 3},
                                                                        {bits::radius, 9},
                                                                        {bits::scale, 3000000},
                                                                        {bits::scale, 4700000},
                                                                        {bits::scale, 13200001},
                                                                        {bits::stretch, 900000},
                                                                        {bits::stretch, 5000001},
                                                                        {bits::angles + 4, 720000001},
                                                                        {bits::rho, 430001},
                                                                        {bits::rho + 1, -120001},
                                                                        {bits::rho + 2, 400001},
                                                                        {bits::rho + 3, 1000001}})
    tests::check_refused(coral, slot, value);
  Recipe eighth = coral;
  eighth.stage[0].level = 3;
  CHECK(dapple::need_for(eighth, dapple::torus(256, 256)).status == dapple::bad_recipe);
}
