// What the tests share: growing a texture into a buffer of exactly the bytes it asks for, and the hashes of goldens.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "dapple.hpp"
#include "recipe/list.hpp"

namespace tests {

// FNV-1a, 64 bit.
struct Fnv {
  uint64_t value = UINT64_C(0xcbf29ce484222325);
  void byte(uint8_t b) { value = (value ^ b) * UINT64_C(0x100000001b3); }
  void number(int32_t n) {
    for (int shift = 0; shift < 32; shift += 8) byte(static_cast<uint8_t>(static_cast<uint32_t>(n) >> shift));
  }
};

// A texture with its own memory, grown to the end.
struct Grown {
  std::vector<uint8_t> memory;
  dapple::Recipe recipe;
  dapple::Texture texture;
  dapple::Status status;

  Grown(const dapple::Recipe& r, dapple::Domain domain, uint32_t seed, uint32_t budget = UINT32_MAX,
        const dapple::Options& options = dapple::Options{})
      : memory(dapple::bytes_for(r, domain, options.bands)), recipe(r) {
    status = texture.begin(recipe, domain, seed, memory.data(), memory.size(), options);
    if (status == dapple::ok)
      while (texture.step(budget) == dapple::more) {
      }
  }
  Grown(const Grown&) = delete;

  std::vector<int16_t> field() {
    const dapple::Domain d = texture.domain();
    std::vector<int16_t> all(static_cast<size_t>(d.width) * d.height);
    for (uint16_t y = 0; y < d.height; ++y) texture.row(y, all.data() + static_cast<size_t>(y) * d.width);
    return all;
  }
  uint64_t field_hash() {
    Fnv fnv;
    for (const int16_t value : field()) fnv.number(value);
    return fnv.value;
  }
  std::vector<uint8_t> pixels(const dapple::Brush& brush) {
    const dapple::Domain d = texture.domain();
    const size_t bytes = dapple::pixel_bytes(brush.format, d.width);
    std::vector<uint8_t> all(bytes * d.height);
    for (uint16_t y = 0; y < d.height; ++y) texture.paint(y, brush, all.data() + bytes * y);
    return all;
  }
  uint64_t paint_hash() {
    Fnv fnv;
    for (const uint8_t b : pixels(dapple::Brush{})) fnv.byte(b);
    return fnv.value;
  }
};

// Its hash; 0: refused.
inline uint64_t field_hash_of(const dapple::Recipe& recipe, const dapple::Domain& domain, uint32_t seed,
                              const dapple::Options& options = dapple::Options{}, uint32_t budget = UINT32_MAX) {
  Grown tile(recipe, domain, seed, budget, options);
  return tile.status == dapple::ok ? tile.field_hash() : 0;
}

inline dapple::Recipe recipe_of(const char* text) {
  dapple::Recipe recipe{};
  dapple::Trouble trouble{};
  if (dapple::parse(text, recipe, trouble) != dapple::ok) recipe.stages = 0;
  return recipe;
}

// Why a recipe is refused.
inline dapple::Trouble refusal(const char* text) {
  dapple::Recipe recipe{};
  dapple::Trouble trouble{};
  dapple::parse(text, recipe, trouble);
  return trouble;
}

inline dapple::Recipe preset(const std::string& name) { return dapple::load(*dapple::find_preset(name.c_str())); }

// A preset with some of its numbers changed.
inline dapple::Recipe preset_with(const char* name, const char* changes) {
  dapple::Recipe recipe = preset(name);
  dapple::Trouble trouble{};
  if (dapple::parse(changes, recipe, trouble) != dapple::ok) recipe.stages = 0;
  return recipe;
}

// A surface measured to the end, so many rows at a time.
inline dapple::Surface measured(dapple::Surface surface, uint32_t rows = 5) {
  while (measure(surface, rows) == dapple::more) {
  }
  return surface;
}

// The same part of a picture of `wide` elements a row.
template <class T>
std::vector<T> part(const std::vector<T>& all, size_t wide, size_t x, size_t y, size_t width, size_t height) {
  std::vector<T> result;
  for (size_t row = y; row < y + height; ++row)
    result.insert(result.end(), all.begin() + static_cast<ptrdiff_t>(row * wide + x),
                  all.begin() + static_cast<ptrdiff_t>(row * wide + x + width));
  return result;
}

struct Size {
  uint16_t width, height;
};
constexpr Size kGoldenSizes[] = {{128, 128}, {160, 96}, {97, 113}};
constexpr uint32_t kGoldenSeed = 1337;
// Of presets whose windows are in blocks.
constexpr dapple::Domain kGoldenWindows[] = {dapple::window(-37, 90, 96, 80), dapple::window(100000, -100000, 64, 64)};
inline bool in_blocks(const dapple::Recipe& recipe) { return dapple::need_for(recipe, kGoldenWindows[0]).block != 0; }

// A size the recipe can have: its sides rounded up to what its coarsest grid asks for.
inline Size fitting(Size size, const dapple::Recipe& recipe) {
  const unsigned step = dapple::need_for(recipe, dapple::torus(size.width, size.height)).multiple;
  return {static_cast<uint16_t>((size.width + step - 1) / step * step), static_cast<uint16_t>((size.height + step - 1) / step * step)};
}

}  // namespace tests
