// Grows every preset, and every family with each of its solvers, at the smallest size for a few steps, also coarse to fine
// as a window of the plane and as corner tiles; sliced, banded and out of unclean memory at odd addresses; and paints it in every way.
// Prints one line each: name WxH steps seed field pixels. tests/checks/hostile.sh compares what many compilers and
// options make of it. With DAPPLE_TABLES its argument is a table of ports/desktop, for tests/checks/kernels.sh; what is not
// sliced goes by the driver.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>

#include "../grow.hpp"
#include "corners.hpp"
#ifdef DAPPLE_TABLES
#include "driver.hpp"
#include "tables.hpp"
#endif

namespace {

constexpr uint32_t kSeed = 42;
constexpr uint16_t kLargestSide = 96;
constexpr uint32_t kWidestHalo = 64;

struct Way {
  uint32_t budget;
  uint8_t bands;
  uint8_t offset;    // of the memory from an aligned address
  uint8_t dirt;      // what the memory and the object hold before
  bool look;         // paints while it grows, and is painted in the end as the first one is
};
const dapple::grid::KernelSwap* kernels = nullptr;
constexpr Way kWays[] = {{UINT32_MAX, 1, 0, 0x00, false}, {1, 1, 1, 0xff, false}, {7, 2, 2, 0xa5, true}, {13, 5, 3, 0x80, false}};

// The recipe for a few steps only: `most` a stage, five times that for Gray-Scott.
dapple::Recipe shortened(dapple::Recipe recipe, uint32_t most) {
  for (uint8_t i = 0; i < recipe.stages; ++i) {
    dapple::Stage& stage = recipe.stage[i];
    const uint32_t steps = stage.model == &dapple::gray_scott_model ? 5 * most : most;
    if (stage.steps > steps) stage.steps = steps;
  }
  return recipe;
}

uint16_t fitting_side(uint16_t least, uint16_t multiple) {
  return static_cast<uint16_t>((least + multiple - 1) / multiple * multiple);
}

// The smallest torus the recipe takes; width 0 if that is larger than these goldens may be.
dapple::Domain smallest(const dapple::Recipe& recipe) {
  const dapple::Need need = dapple::need_for(recipe, dapple::torus(kLargestSide, kLargestSide));
  if (need.width > kLargestSide || need.height > kLargestSide) return dapple::torus(0, 0);
  return dapple::torus(fitting_side(need.width, need.multiple), fitting_side(need.height, need.multiple));
}

struct Tile {
  std::unique_ptr<uint8_t[]> memory;
  dapple::Texture texture;

  Tile(const dapple::Recipe& recipe, const dapple::Domain& domain, const Way& way) {
    const size_t bytes = dapple::bytes_for(recipe, domain, way.bands);
    memory.reset(new uint8_t[way.offset + bytes]);
    std::memset(memory.get(), way.dirt, way.offset + bytes);
    std::memset(static_cast<void*>(&texture), way.dirt, sizeof texture);
    dapple::Options options;
    options.bands = way.bands;
    options.kernels = kernels;
#ifdef DAPPLE_TABLES
    static dapple::desktop::Driver driver(1);
    if (way.budget == UINT32_MAX) options.driver = &driver;
#endif
    grown = texture.begin(recipe, domain, kSeed, memory.get() + way.offset, bytes, options) == dapple::ok;
    uint8_t line[4 * kLargestSide];
    for (uint16_t y = 0; grown && texture.step(way.budget) == dapple::more; y = static_cast<uint16_t>((y + 5) % domain.height))
      if (way.look) texture.paint(y, dapple::Pixels::rgba8888, line);
  }
  Tile(const Tile&) = delete;
  bool grown;

  uint64_t field_hash() {
    tests::Fnv fnv;
    int16_t line[kLargestSide];
    for (uint16_t y = 0; y < texture.domain().height; ++y) {
      texture.row(y, line);
      for (uint16_t x = 0; x < texture.domain().width; ++x) fnv.number(line[x]);
    }
    return fnv.value;
  }

  // Every view in colour, every format plain and dithered, rows from the bottom up.
  uint64_t pixels_hash() {
    using dapple::Pixels;
    using dapple::View;
    tests::Fnv fnv;
    for (const View view : {View::colour, View::field, View::cells, View::height, View::normal})
      for (const bool flag : {false, true}) add({view, Pixels::rgb888, false, flag}, fnv);
    for (const Pixels format : {Pixels::l8, Pixels::rgb888, Pixels::rgba8888, Pixels::rgb565, Pixels::rgb565_swapped,
                                Pixels::l1_msb, Pixels::l1_lsb, Pixels::l1_pages})
      for (const bool flag : {false, true}) add({View::colour, format, flag, false}, fnv);
    return fnv.value;
  }

 private:
  void add(const dapple::Brush& brush, tests::Fnv& fnv) {
    uint8_t line[4 * kLargestSide] = {};
    for (uint16_t rest = texture.domain().height; rest > 0; --rest) {
      texture.paint(static_cast<uint16_t>(rest - 1), brush, line);
      for (size_t i = 0; i < dapple::pixel_bytes(brush.format, texture.domain().width); ++i) fnv.byte(line[i]);
    }
  }
};

// Grows it every way; false if ways differ.
bool print(const std::string& name, const dapple::Recipe& recipe, const dapple::Domain& domain) {
  uint64_t field = 0, pixels = 0;
  for (const Way& way : kWays) {
    Tile tile(recipe, domain, way);
    if (!tile.grown) return false;
    const bool first = &way == kWays;
    const uint64_t field_now = tile.field_hash(), pixels_now = first || way.look ? tile.pixels_hash() : pixels;
    if (!first && (field != field_now || pixels != pixels_now)) return false;
    field = field_now;
    pixels = pixels_now;
  }
  std::printf("%s %ux%u %u %u %08lx%08lx %08lx%08lx\n", name.c_str(), unsigned(domain.width), unsigned(domain.height),
              unsigned(recipe.stage[recipe.stages - 1].steps), unsigned(kSeed), static_cast<unsigned long>(field >> 32),
              static_cast<unsigned long>(field & UINT32_MAX), static_cast<unsigned long>(pixels >> 32),
              static_cast<unsigned long>(pixels & UINT32_MAX));
  return true;
}

// Images for what takes them: 3 x 2 directions, styles and greys. Beside them every recipe gets a surface.
constexpr int8_t kPairs[] = {127, 0, 0, 127, -127, 0, 90, 90, -20, 10, 0, -127};
constexpr uint8_t kStyles[] = {255, 128, 255, 200, 140, 255, 90, 120, 128, 255, 0, 0, 64, 255, 255, 160, 128, 10};
constexpr uint8_t kGreys[] = {0, 255, 90, 33, 180, 128};
constexpr dapple::PlaceMaps kImages = {{kPairs, 3, 2}, {kStyles, 3, 2}, nullptr, {kGreys, 3, 2}, {kGreys, 3, 2}};

// The smallest torus, a window where the halo is not too wide, and both coarse to fine by the explicit solver where there
// is one. Returns how many were wrong.
int try_all(const std::string& name, const dapple::Recipe& whole) {
  const dapple::Domain window = dapple::window(-1003, 777, 41, 19);
  const dapple::Recipe recipe = shortened(whole, 8);
  int wrong = 0;
  for (const char* changes : {"", "solver=euler levels=2"}) {
    dapple::Recipe changed = recipe;
    dapple::Trouble trouble{};
    if (*changes != 0 && dapple::parse(changes, changed, trouble) != dapple::ok) continue;
    const dapple::Domain torus = smallest(changed);
    dapple::Surface surface{};
    if (torus.width > 0) surface = tests::measured(dapple::torus_surface(torus.width, torus.height, 400000));
    dapple::PlaceMaps images = kImages;
    images.surface = &surface;
    dapple::set_maps(changed, images);
    const std::string label = name + (*changes != 0 ? "+euler+levels" : "");
    bool good = torus.width == 0 || print(label, changed, torus);
    changed = shortened(changed, 2);
    const dapple::Need need = dapple::need_for(changed, window);
    if (need.status == dapple::ok && need.halo <= kWidestHalo) good = print(label + "@-1003,777", changed, window) && good;
    if (good) continue;
    std::printf("%s: budgets, bands or memory change the result\n", label.c_str());
    ++wrong;
  }
  return wrong;
}

int try_presets() {
  int wrong = 0;
  for (uint16_t i = 0; i < dapple::preset_count(); ++i) {
    char name[dapple::kMaxName];
    dapple::preset_at(i, name);
    wrong += try_all(name, dapple::load(*dapple::find_preset(name)));
  }
  return wrong;
}

// The maps of a material at sixteen and eight bits, and their levels, odd sides among them.
uint64_t maps_hash(dapple::Texture& texture) {
  using dapple::Pixels;
  using dapple::View;
  const dapple::Brush brushes[] = {{View::height, Pixels::l16}, {View::height, Pixels::l16_swapped}, {View::normal, Pixels::rgb888},
                                   {View::colour, Pixels::rgba8888, false, false, true}, {View::opacity, Pixels::l8},
                                   {View::roughness, Pixels::l8}};
  tests::Fnv fnv;
  for (const dapple::Brush& brush : brushes) {
    dapple::Mip mip = {brush.format, brush.view == View::normal, texture.domain().width, texture.domain().height};
    std::vector<uint8_t> level(dapple::pixel_bytes(mip.format, mip.width) * mip.height), next(level.size());
    for (uint16_t y = 0; y < mip.height; ++y) texture.paint(y, brush, &level[y * dapple::pixel_bytes(mip.format, mip.width)]);
    for (uint8_t rest = dapple::mip_levels(mip.width, mip.height);; --rest, level.swap(next), mip = mip_below(mip)) {
      const size_t line = dapple::pixel_bytes(mip.format, mip.width), half = dapple::pixel_bytes(mip.format, dapple::mip_side(mip.width));
      for (size_t i = 0; i < line * mip.height; ++i) fnv.byte(level[i]);
      if (rest == 0) break;
      for (uint16_t y = 0; y < dapple::mip_side(mip.height); ++y) {
        const uint8_t* rows[3] = {};
        for (uint8_t k = 0; k < dapple::mip_rows(mip.height); ++k) rows[k] = &level[(2u * y + k) * line];
        dapple::mip_row(mip, rows, y, &next[y * half]);
      }
    }
  }
  return fnv.value;
}

int try_maps() {
  for (const char* changes : {"", "opacity=0.9,0.1 roughness=0.2,0.7 light=2"}) {
    const dapple::Recipe recipe = shortened(tests::preset_with("coral", changes), 8);
    Tile tile(recipe, dapple::torus(61, 46), kWays[0]);
    if (!tile.grown) return 1;
    const uint64_t hash = maps_hash(tile.texture);
    std::printf("coral/maps%s 61x46 8 42 %08lx%08lx\n", *changes != 0 ? "/changed" : "", static_cast<unsigned long>(hash >> 32),
                static_cast<unsigned long>(hash & UINT32_MAX));
  }
  return 0;
}

int try_families() {
  int wrong = 0;
  for (const dapple::recipe::Family& family : dapple::recipe::families) {
    std::string solvers = family.solver_names;
    for (size_t bar = 0; bar != std::string::npos; solvers = solvers.substr(bar + 1)) {
      bar = solvers.find('|');
      const std::string text = std::string(family.name) + " solver=" + solvers.substr(0, bar);
      const dapple::Recipe recipe = tests::recipe_of(text.c_str());
      if (recipe.stages > 0) wrong += try_all(text.substr(0, text.find(' ')) + "/" + solvers.substr(0, bar), recipe);
      else ++wrong;
      if (bar == std::string::npos) break;
    }
  }
  return wrong;
}

// Corner tiles of all that they can share: a reaction, states, noise, seeds, two levels.
int try_corners() {
  constexpr const char* kShared[] = {"threshold scale=0.8", "threshold pairs=2 react=da scale=0.8 levels=2",
                                     "threshold scale=0.8 start=seeds pitch=9 radius=2", "threshold scale=0.8 solver=euler",
                                     "gray-scott scale=0.5 start=noise", "gray-scott scale=0.5 pitch=12 radius=3"};
  int wrong = 0;
  for (const char* const text : kShared) {
    const dapple::Recipe recipe = shortened(tests::recipe_of(text), 8);
    const dapple::Need need = dapple::need_for(recipe, dapple::corner_tiles(8));
    const uint16_t side = fitting_side(need.width, need.multiple);
    std::string name = std::string("corners/") + text;
    for (char& letter : name) letter = letter == ' ' ? '+' : letter;
    if (print(name, recipe, dapple::corner_tiles(side / dapple::grid::kTilesAcross))) continue;
    std::printf("%s: budgets, bands or memory change the result\n", name.c_str());
    ++wrong;
  }
  return wrong;
}

}  // namespace

int main(int count, char** words) {
#ifdef DAPPLE_TABLES
  const dapple::desktop::Table* const table = count == 2 ? dapple::desktop::table_named(words[1]) : nullptr;
  if (table == nullptr) return 2;
  kernels = table->kernels;
#else
  static_cast<void>(words);
  if (count != 1) return 2;
#endif
  return try_presets() + try_families() + try_maps() + try_corners() == 0 ? 0 : 1;
}
