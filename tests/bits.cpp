// Binary convolution against its definition: plain sums over the weights of whole tori, double-buffered; kernels, bands,
// budgets and windows that must not change a bit; starts; what is refused.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "base/hash.hpp"
#include "grow.hpp"
#include "stencil/convolve.hpp"

namespace bits = dapple::bits;
namespace grid = dapple::grid;
namespace stencil = dapple::stencil;
using dapple::Recipe;
using tests::Grown;
using tests::Size;

namespace {

constexpr uint32_t kSeed = 11;
constexpr int kMargin = 8;

int64_t floor_divide(int64_t a, int64_t b) { return a / b - (a % b < 0); }

// A torus of numbers: cells or a field.
struct Torus {
  int width, height;
  std::vector<int> value;
  Torus(int w, int h) : width(w), height(h), value(static_cast<size_t>(w * h)) {}
  int& at(int x, int y) {
    return value[static_cast<size_t>((y % height + height) % height * width + (x % width + width) % width)];
  }
};

template <class Value>
Torus made(int width, int height, Value value) {
  Torus t(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) t.at(x, y) = value(x, y);
  return t;
}

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
Torus differences(const int32_t* n, Torus& cells) {
  const int r = n[bits::radius], side = 2 * r + 1;
  const std::vector<stencil::Mask> masks = masks_of(n);
  Torus wide = made(cells.width + 2 * r, cells.height + 2 * r, [&](int x, int y) { return cells.at(x - r, y - r); });
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
  if (at >= begin && at < end) rho = s[0] + floor_divide(2 * (s[1] - s[0]) * (at - begin) + (end - begin), 2 * (end - begin));
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
Torus field_plainly(const Recipe& recipe, Torus& cells) {
  const int32_t* n = recipe.stage[0].number;
  const int sum = masks_of(n)[0].sum;
  Torus d = differences(n, cells);
  const int64_t factor = floor_divide(2 * 256 * 8000 + sum, 2 * sum);
  for (int& value : d.value) {
    const double exact = std::max(-8000.0, std::min(8000.0, 8000.0 * value / sum));
    value = static_cast<int>(std::max<int64_t>(-8000, std::min<int64_t>(8000, floor_divide(value * factor + 128, 256))));
    if (std::fabs(value - exact) > 1) FAIL("the field is 8000 D / P");
  }
  return d;
}

// Twofold: 3/4 of the cell a finer one lies in and 1/4 of the one beside it, first down, then across.
Torus enlarged(Torus coarse) {
  const auto beside = [](int i) { return i % 2 == 0 ? i / 2 - 1 : i / 2 + 1; };
  Torus tall = made(coarse.width, 2 * coarse.height, [&](int x, int y) {
    return static_cast<int>(floor_divide(3 * coarse.at(x, y / 2) + coarse.at(x, beside(y)) + 2, 4));
  });
  return made(2 * coarse.width, 2 * coarse.height, [&](int x, int y) {
    return static_cast<int>(floor_divide(3 * tall.at(x / 2, y) + tall.at(beside(x), y) + 2, 4));
  });
}
Torus enlarged(Torus coarse, int level) { return level == 0 ? coarse : enlarged(enlarged(coarse), level - 1); }

// Instead of the field's kernel: the cells themselves, 8000 where they are on.
void show_cells(const grid::Rows& rows) {
  const uint8_t* row = static_cast<const uint8_t*>(rows.in[stencil::mask_set(rows).radius]);
  for (int32_t x = 0; x < rows.n; ++x) grid::out16(rows, 0)[x] = grid::get_bit(row, x) ? 8000 : 0;
}
const grid::KernelSwap kShowCells[] = {{stencil::field_row, show_cells}, {nullptr, nullptr}};

// The library's cells, on their own grid: the enlargement of 0 and 8000 keeps a cell's side of 4000 in its middle. Windows
// begin at a whole cell.
Torus library_cells(const Recipe& recipe, dapple::Domain d) {
  dapple::Options options;
  options.kernels = kShowCells;
  Grown tile(recipe, d, kSeed, UINT32_MAX, options);
  REQUIRE(tile.status == dapple::ok);
  const std::vector<int16_t> field = tile.field();
  const int level = recipe.stage[0].level, middle = (1 << level) / 2;
  return made(d.width >> level, d.height >> level, [&](int x, int y) {
    return field[static_cast<size_t>(((y << level) + middle) * d.width + (x << level) + middle)] > 4000;
  });
}

bool agrees(const Recipe& recipe, Size size) {
  Recipe start = recipe;
  start.stage[0].steps = 0;
  const dapple::Domain tile_of = dapple::torus(size.width, size.height);
  Torus cells = grown_plainly(recipe, library_cells(start, tile_of));
  CHECK(library_cells(recipe, tile_of).value == cells.value);
  const Torus want = enlarged(field_plainly(recipe, cells), recipe.stage[0].level);
  Grown tile(recipe, tile_of, kSeed);
  const std::vector<int16_t> have = tile.field();
  return std::equal(have.begin(), have.end(), want.value.begin(), want.value.end());
}

std::vector<std::string> presets_of(const dapple::Model* model) {
  std::vector<std::string> names;
  for (uint16_t i = 0; i < dapple::preset_count(); ++i) {
    char name[dapple::kMaxName];
    const dapple::PresetEntry entry = dapple::preset_at(i, name);
    if (dapple::load(*entry.preset).stage[0].model == model) names.push_back(name);
  }
  return names;
}

// Sizes of a grid, in its own cells, that a recipe may have: the smallest, and some with odd sides.
std::vector<Size> sizes_for(const Recipe& recipe, int level) {
  const dapple::Need need = dapple::need_for(recipe, dapple::torus(64, 64));
  std::vector<Size> sizes;
  for (const Size more : {Size{0, 0}, Size{3, 1}, Size{26, 6}, Size{49, 11}}) {
    const unsigned step = 1u << level;
    const auto side = [&](unsigned least, unsigned extra) { return static_cast<uint16_t>(((least + step - 1) / step + extra) * step); };
    sizes.push_back({side(need.width, more.width), side(need.height, more.height)});
  }
  return sizes;
}

// Any masks, rule, angles and a threshold in the living range.
struct Dice {
  std::mt19937 random;
  int32_t roll(int32_t low, int32_t high) {
    return low + static_cast<int32_t>(random() % static_cast<uint32_t>(high - low + 1));
  }
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
    n[bits::rho] = roll(living.low, living.high);
    n[bits::rho + 1] = roll(living.low, living.high);
    n[bits::rho + 3] = roll(0, 1000000);
    n[bits::rho + 2] = roll(0, n[bits::rho + 3]);
    return recipe;
  }
  dapple::Domain torus(const Recipe& recipe) {
    const dapple::Need need = dapple::need_for(recipe, dapple::torus(64, 64));
    const int step = 1 << recipe.stage[0].level;
    const auto side = [&](int least, int most) { return static_cast<uint16_t>(((least + step - 1) / step + roll(0, most)) * step); };
    return dapple::torus(side(need.width, 120), side(need.height, 20));
  }
};

}  // namespace
TEST_CASE("bits: every preset is its definition, on grids of 1, 1/2 and 1/4") {
  const std::vector<std::string> names = presets_of(&dapple::bits_model);
  CHECK(names.size() == 13);
  for (const std::string& name : names)
    for (const int level : {0, 1, 2}) {
      const Recipe recipe = tests::preset_with(name.c_str(), ("level=" + std::to_string(level)).c_str());
      for (const Size size : sizes_for(recipe, level)) {
        INFO(name << " level " << level << " " << size.width << "x" << size.height);
        CHECK(agrees(recipe, size));
      }
    }
}

TEST_CASE("bits: random recipes are their definition") {
  Dice dice{std::mt19937(1)};
  for (int i = 0; i < 120; ++i) {
    const Recipe recipe = dice.recipe(static_cast<uint8_t>(i % 8 == 7 ? 2 : i % 2));
    const dapple::Domain d = dice.torus(recipe);
    CAPTURE(i);
    CHECK(agrees(recipe, {d.width, d.height}));
  }
}

// --- What must not change a bit --------------------------------------------------------------------------------------

struct Variant {
  const char* name;
  grid::KernelSwap swap[3];
  bool lean;
};
static const Variant kVariants[] = {
    {"as it is", {{nullptr, nullptr}}, false},
    {"lean", {{nullptr, nullptr}}, true},
    {"by table", {{stencil::convolve_row, stencil::convolve_by_table}, {stencil::field_row, stencil::field_by_table}}, false},
    {"lean by table", {{stencil::convolve_lean, stencil::convolve_by_table}}, true},
    {"8 bits", {{stencil::convolve_row, stencil::convolve_row8}}, false},
    {"32 bits", {{stencil::convolve_row, stencil::convolve_row32}}, false},
    {"64 bits", {{stencil::convolve_row, stencil::convolve_row64}}, false},
};

static void check_variants(const Recipe& recipe, const dapple::Domain& domain, Dice& dice) {
  Grown plain(recipe, domain, kSeed);
  REQUIRE(plain.status == dapple::ok);
  const uint64_t want = plain.field_hash();
  for (const Variant& v : kVariants)
    for (uint8_t bands = 1; bands <= 3; ++bands) {
      Recipe changed = recipe;
      if (v.lean) changed.stage[0].solver = &dapple::evolve::lean;
      dapple::Options options;
      options.bands = bands;
      options.kernels = v.swap;
      const uint32_t budgets[] = {1, 3, 50, UINT32_MAX};
      const uint32_t budget = budgets[dice.roll(0, 3)];
      Grown other(changed, domain, kSeed, budget, options);
      INFO(v.name << " bands " << int(bands) << " budget " << budget);
      REQUIRE(other.status == dapple::ok);
      CHECK(other.field_hash() == want);
    }
}

TEST_CASE("bits: kernels, solvers, bands and budgets give the same bits, every preset") {
  Dice dice{std::mt19937(2)};
  for (const std::string& name : presets_of(&dapple::bits_model)) {
    const Recipe recipe = dapple::load(*dapple::find_preset(name.c_str()));
    CAPTURE(name);
    check_variants(recipe, dice.torus(recipe), dice);
    check_variants(recipe, dapple::window(-77, 1003, 59, 40), dice);
  }
}

TEST_CASE("bits: kernels, solvers, bands and budgets give the same bits, random recipes") {
  Dice dice{std::mt19937(3)};
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
  Dice dice{std::mt19937(4)};
  for (int i = 0; i < 60; ++i) {
    const Recipe recipe = dice.recipe(static_cast<uint8_t>(i % 3));
    const int32_t x = dice.roll(-100000000, 100000000) * 10, y = dice.roll(-500, 500);
    Grown big(recipe, dapple::window(x, y, 90, 70), kSeed);
    const int dx = dice.roll(0, 50), dy = dice.roll(0, 50);
    Grown part(recipe, dapple::window(x + dx, y + dy, 40, 20), kSeed);
    CAPTURE(i);
    REQUIRE(big.status == dapple::ok);
    REQUIRE(part.status == dapple::ok);
    const std::vector<int16_t> a = big.field(), b = part.field();
    size_t wrong = 0;
    for (size_t k = 0; k < b.size(); ++k) wrong += b[k] != a[(k / 40 + static_cast<size_t>(dy)) * 90 + k % 40 + static_cast<size_t>(dx)];
    CHECK(wrong == 0);
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
    return start_of(preset, coarse, c).value == start_of(preset, fine, f).value;
  };
  using dapple::torus;
  using dapple::window;
  CHECK(same("zebra-bits", "level=1", torus(104, 84, 10, -36), "level=0", torus(52, 42, 5, -18)));
  CHECK(same("zebra-bits", "level=2", torus(104, 84, 40, -36), "level=0", torus(26, 21, 10, -9)));
  CHECK(same("zebra-bits", "level=2", window(-104, 84, 40, 36), "level=0", window(-26, 21, 10, 9)));
  const char* half = "level=0 pitch=13 radius=2.6";
  CHECK(same("reptile-bits", "level=1", torus(150, 90, 10, -36), half, torus(75, 45, 5, -18)));
  CHECK(same("reptile-bits", "level=1", window(-150, 90, 80, 70), half, window(-75, 45, 40, 35)));
  CHECK(same("reptile-bits", "level=2", window(-152, 88, 80, 72), "level=0 pitch=6.5 radius=1.3", window(-38, 22, 20, 18)));
}

// --- What is refused -------------------------------------------------------------------------------------------------

TEST_CASE("bits: numbers beyond their ranges are refused with bounds") {
  struct Case {
    const char* text;
    int32_t low, high;
  };
  constexpr int32_t kM = 1000000;
  for (const Case& c : {Case{"bits window=9", 4, 8}, Case{"bits window=3", 4, 8}, Case{"bits masks=0", 1, 5},
                        Case{"bits masks=6", 1, 5}, Case{"bits scale=18.000001", 4 * kM, 18 * kM},
                        Case{"bits scale=3.999999", 4 * kM, 18 * kM}, Case{"bits stretch=5.1", kM, 5 * kM},
                        Case{"bits stretch=.9", kM, 5 * kM}, Case{"bits rho=.6", -500000, 500000},
                        Case{"bits diffusion=isotropic rho=.441", -440000, 440000},
                        Case{"bits diffusion=isotropic rho=0:-.441@.3", -440000, 440000},
                        Case{"bits masks=2 rho=-.121", -120000, 450000}, Case{"bits masks=3 rho=.451", -120000, 450000},
                        Case{"bits masks=5 rho=.431", -120000, 430000}, Case{"bits masks=2 react=da rho=.351", -370000, 350000},
                        Case{"bits masks=3 react=da rho=-.431", -430000, 430000}}) {
    CAPTURE(c.text);
    Recipe recipe{};
    dapple::Trouble trouble{};
    CHECK(dapple::parse(c.text, recipe, trouble) == dapple::out_of_range);
    CHECK(trouble.low == c.low);
    CHECK(trouble.high == c.high);
  }
}

static dapple::Status begun(const Recipe& recipe, dapple::Domain d) {
  static std::vector<uint8_t> memory(4000000);
  dapple::Texture texture;
  return texture.begin(recipe, d, kSeed, memory.data(), memory.size());
}

TEST_CASE("bits: begin distrusts recipes made by hand") {
  const auto status = [](int slot, int32_t value) {
    Recipe recipe = dapple::load(*dapple::find_preset("coral-bits"));
    recipe.stage[0].number[slot] = value;
    return begun(recipe, dapple::torus(64, 64));
  };
  CHECK(status(bits::masks, 5) == dapple::ok);
  for (const auto& [slot, value] : std::vector<std::pair<int, int32_t>>{
           {bits::masks, 0}, {bits::masks, 6}, {bits::react, 2}, {bits::diffusion, 2}, {bits::radius, 3}, {bits::radius, 9},
           {bits::scale, 3000000}, {bits::scale, 4700000}, {bits::scale, 13200001}, {bits::stretch, 900000},
           {bits::stretch, 5000001}, {bits::angles + 4, 720000001}, {bits::rho, 430001}, {bits::rho + 1, -120001},
           {bits::rho + 2, 400001}, {bits::rho + 3, 1000001}}) {
    CAPTURE(slot);
    CAPTURE(value);
    CHECK(status(slot, value) == dapple::bad_recipe);
  }
}

TEST_CASE("bits: what parse takes, begin takes; a grid of 1/8 is refused or right") {
  for (const char* text : {"bits window=4", "bits window=5", "bits window=8", "bits window=8 scale=6", "bits window=4 scale=9"}) {
    CAPTURE(text);
    const Recipe recipe = tests::recipe_of(text);
    if (recipe.stages > 0) CHECK(begun(recipe, dapple::torus(64, 64)) == dapple::ok);
  }
  const Recipe eighth = tests::preset_with("zebra-bits", "level=3");
  if (eighth.stages > 0 && begun(eighth, dapple::torus(256, 152)) == dapple::ok) CHECK(agrees(eighth, {256, 152}));
}
