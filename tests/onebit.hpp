// What the tests of one-bit families share: plain grids on a torus, dice for recipes, presets by model.
// SPDX-License-Identifier: MIT
#pragma once
#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "grow.hpp"

namespace tests {

constexpr int64_t floor_divide(int64_t a, int64_t b) { return a / b - (a % b < 0); }

// A torus of numbers: cells, 0 or 1, or a field.
struct Torus {
  int width, height;
  std::vector<int> value;
  Torus(int w, int h) : width(w), height(h), value(static_cast<size_t>(w * h)) {}
  size_t index(int x, int y) const {
    return static_cast<size_t>((y % height + height) % height * width + (x % width + width) % width);
  }
  int& at(int x, int y) { return value[index(x, y)]; }
  int at(int x, int y) const { return value[index(x, y)]; }
  int count() const { return static_cast<int>(std::count(value.begin(), value.end(), 1)); }
  bool operator==(const Torus& other) const { return value == other.value; }
};

template <class Value>
Torus made(int width, int height, Value value) {
  Torus t(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) t.at(x, y) = value(x, y);
  return t;
}

// The library's field of a domain.
inline Torus grown(const dapple::Recipe& recipe, dapple::Domain d, uint32_t seed,
                   const dapple::Options& options = dapple::Options{}, uint32_t budget = UINT32_MAX) {
  Grown tile(recipe, d, seed, budget, options);
  REQUIRE(tile.status == dapple::ok);
  const std::vector<int16_t> field = tile.field();
  return made(d.width, d.height, [&](int x, int y) { return field[static_cast<size_t>(y * d.width + x)]; });
}

// Its cells, on their own grid. `kernels` make the field show 8000 for a cell that is on and 0 otherwise; enlarged,
// that keeps a cell's side of 4000 in the cell's middle. Domains begin at a whole cell.
inline Torus grown_cells(const dapple::Recipe& recipe, dapple::Domain d, uint32_t seed,
                         const dapple::grid::KernelSwap* kernels) {
  dapple::Options options;
  options.kernels = kernels;
  const Torus field = grown(recipe, d, seed, options);
  const int level = recipe.stage[0].level, middle = (1 << level) / 2;
  return made(d.width >> level, d.height >> level,
              [&](int x, int y) { return field.at((x << level) + middle, (y << level) + middle) > 4000; });
}

struct Dice {
  std::mt19937 random;
  int32_t roll(int32_t low, int32_t high) {
    return low + static_cast<int32_t>(random() % static_cast<uint32_t>(high - low + 1));
  }
  // A torus at least twice the nominal wavelength (`scale`) of a mask, and up to so many cells of the grid more.
  dapple::Domain torus(const dapple::Recipe& recipe, int32_t scale, int wider, int higher) {
    const int level = recipe.stage[0].level, least = std::max(8, scale / 500000 + 1);
    const int pitch = recipe.start.kind == dapple::Start::seeds ? recipe.start.pitch / 660000 >> level : 0;
    const auto side = [&](int more) {
      return static_cast<uint16_t>((std::max(least, pitch + 1) + roll(0, more)) << level);
    };
    const uint16_t width = side(wider);
    return dapple::torus(width, side(higher));
  }
};

inline std::vector<std::string> presets_of(const dapple::Model* model) {
  std::vector<std::string> names;
  for (uint16_t i = 0; i < dapple::preset_count(); ++i) {
    char name[dapple::kMaxName];
    const dapple::PresetEntry entry = dapple::preset_at(i, name);
    if (dapple::load(*entry.preset).stage[0].model == model) names.push_back(name);
  }
  return names;
}

// Numbers beyond their range are refused by parse, which says where the range ends.
struct Beyond {
  const char* text;
  int32_t low, high;
};
inline void check_refused(const Beyond& beyond) {
  dapple::Recipe recipe{};
  dapple::Trouble trouble{};
  INFO(std::string(beyond.text));
  CHECK(dapple::parse(beyond.text, recipe, trouble) == dapple::out_of_range);
  CHECK(trouble.low == beyond.low);
  CHECK(trouble.high == beyond.high);
}
// By begin, in recipes made by hand.
inline void check_refused(dapple::Recipe recipe, int slot, int32_t value) {
  CHECK(dapple::need_for(recipe, dapple::torus(96, 96)).status == dapple::ok);
  recipe.stage[0].number[slot] = value;
  INFO("slot " << slot << " value " << value);
  CHECK(dapple::need_for(recipe, dapple::torus(96, 96)).status == dapple::bad_recipe);
}

}  // namespace tests
