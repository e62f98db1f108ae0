// Patches: sides that repeat, end, are held or joined; many small patches are one large one, bit for bit; six are a sphere.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "atlas.hpp"
#include "grow.hpp"

using dapple::closed_side;
using dapple::joined_side;
using dapple::Patch;
using dapple::Patches;
using dapple::repeating_side;
using dapple::Side;
using dapple::Surface;
using tests::Grown;

namespace {

constexpr Side kClosed = closed_side();

// across x down patches of width x height cells, side by side; those outside closed, or joined round the torus.
struct Sheet {
  std::vector<Patch> patch;
  Patches all;
  uint16_t across;

  Sheet(uint8_t wide, uint8_t high, uint16_t width, uint16_t height, bool closed_across, bool closed_down)
      : all{nullptr, static_cast<uint8_t>(wide * high), width, height}, across(wide) {
    for (int j = 0; j < high; ++j)
      for (int i = 0; i < wide; ++i) {
        const auto at = [&](int x, int y) {
          return static_cast<uint8_t>((y + high) % high * wide + (x + wide) % wide);
        };
        Patch p = {i * width, j * height,
                   {joined_side(at(i - 1, j), Side::right), joined_side(at(i + 1, j), Side::left),
                    joined_side(at(i, j - 1), Side::bottom), joined_side(at(i, j + 1), Side::top)}};
        if (closed_across && i == 0) p.side[Side::left] = kClosed;
        if (closed_across && i + 1 == wide) p.side[Side::right] = kClosed;
        if (closed_down && j == 0) p.side[Side::top] = kClosed;
        if (closed_down && j + 1 == high) p.side[Side::bottom] = kClosed;
        patch.push_back(p);
      }
    all.patch = patch.data();
  }
};

// An atlas with its memory, grown to the end.
struct GrownAtlas {
  std::vector<uint8_t> memory;
  std::vector<dapple::Texture> texture;
  dapple::Recipe recipe;
  dapple::Atlas atlas;
  dapple::AtlasNeed need{};
  dapple::Status status;

  GrownAtlas(const dapple::Recipe& r, const Patches& patches, uint32_t seed, uint32_t budget = UINT32_MAX,
             const dapple::Options& options = dapple::Options{})
      : memory(atlas_need(r, patches, options.bands).bytes), texture(patches.count), recipe(r) {
    status = atlas.begin(recipe, patches, seed, texture.data(), memory.data(), memory.size(), options, &need);
    if (status != dapple::ok) return;
    while (atlas.step(budget) == dapple::more) {
    }
    CHECK(atlas.rows_done() == atlas.rows_in_all());
  }
  std::vector<int16_t> field(size_t patch) {
    const dapple::Domain d = texture[patch].domain();
    std::vector<int16_t> all(static_cast<size_t>(d.width) * d.height);
    for (uint16_t y = 0; y < d.height; ++y) texture[patch].row(y, all.data() + static_cast<size_t>(y) * d.width);
    return all;
  }
  // All patches of a sheet as one.
  std::vector<int16_t> whole(const Sheet& sheet) {
    const size_t width = sheet.all.width, height = sheet.all.height, across = sheet.across;
    std::vector<int16_t> all(width * height * sheet.all.count);
    for (size_t i = 0; i < sheet.all.count; ++i) {
      const std::vector<int16_t> one = field(i);
      for (size_t y = 0; y < height; ++y)
        std::copy_n(one.data() + y * width, width,
                    all.data() + (i / across * height + y) * width * across + i % across * width);
    }
    return all;
  }
};

const char* const kRecipes[] = {"mapped map=none scale=2.2 stretch=2 angle=70 steps=4",
                                "mapped map=isotropic scale=2 pairs=2 rho=0.01 steps=3 solver=lean",
                                "mapped map=isotropic scale=1.5 steps=5 levels=2 fine=2",
                                "threshold scale=2.2 stretch=2 angle=30 steps=4",
                                "threshold scale=1.5 pairs=2 rho=0.02 steps=2 solver=euler",
                                "gray-scott start=noise steps=20"};

Surface measured(Surface surface) {
  while (measure(surface, 100) == dapple::more) {
  }
  REQUIRE(is_measured(surface));
  return surface;
}

}  // namespace

TEST_CASE("atlas: a patch that repeats, and four that close round a torus, are the torus bit for bit") {
  for (const char* text : kRecipes) {
    const dapple::Recipe recipe = tests::recipe_of(text);
    REQUIRE(recipe.stages > 0);
    const std::vector<int16_t> torus = Grown(recipe, dapple::torus(128, 96), 5).field();
    const Sheet one(1, 1, 128, 96, false, false), four(2, 2, 64, 48, false, false), twelve(4, 3, 32, 32, false, false);
    INFO(text);
    CHECK(Grown(recipe, on_patch(one.all, 0), 5).field() == torus);
    dapple::Options options;
    for (const uint8_t bands : {1, 3}) {
      options.bands = bands;
      CHECK(GrownAtlas(recipe, one.all, 5, 7, options).whole(one) == torus);
      CHECK(GrownAtlas(recipe, four.all, 5, 1, options).whole(four) == torus);
      CHECK(GrownAtlas(recipe, twelve.all, 5, 1000, options).whole(twelve) == torus);
    }
  }
}

TEST_CASE("atlas: patches side by side are one closed patch bit for bit, on a surface too") {
  std::vector<int16_t> heights;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 96; ++x) heights.push_back(static_cast<int16_t>(64 * ((x / 7 + y / 5) % 9)));
  const Surface bumps = measured(dapple::height_surface(96, 64, heights.data(), true));
  std::vector<dapple::Metric> whole, parts;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 96; ++x) whole.push_back(metric_at(bumps, 0, x, y));
  for (int i = 0; i < 3; ++i)
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 32; ++x) parts.push_back(whole[static_cast<size_t>(96 * y + 32 * i + x)]);
  const Surface large = measured(dapple::tensor_surface(96, 64, whole.data())),
                three = measured(dapple::tensor_surface(32, 64, parts.data(), 3));
  dapple::PlaceMaps on_large{}, on_three{};
  on_large.surface = &large;
  on_three.surface = &three;
  const Sheet one(1, 1, 96, 64, true, true), row(3, 1, 32, 64, true, true), around(1, 1, 96, 64, true, false);
  std::vector<std::string> texts(std::begin(kRecipes), std::end(kRecipes));
  texts.push_back("mapped map=none stretch=2 angle=20 scale=1.6 steps=4 solver=surface");
  texts.push_back("mapped map=isotropic scale=1.3 steps=4 levels=2 fine=2 solver=surface");
  for (const std::string& text : texts) {
    dapple::Recipe recipe = tests::recipe_of(text.c_str()), split = recipe;
    set_maps(recipe, on_large);
    set_maps(split, on_three);
    INFO(text);
    const std::vector<int16_t> closed = GrownAtlas(recipe, one.all, 8).whole(one);
    CHECK(Grown(recipe, on_patch(one.all, 0), 8, 3).field() == closed);
    CHECK(GrownAtlas(split, row.all, 8, 13).whole(row) == closed);
    CHECK(GrownAtlas(recipe, around.all, 8).whole(around) != closed);
  }
}

TEST_CASE("atlas: a constant field stays constant between closed sides, and does not between fixed ones") {
  const Surface vase = measured(dapple::vase_surface(64, 48, 400000, 900000));
  dapple::PlaceMaps maps{};
  maps.surface = &vase;
  for (const char* text :
       {"mapped map=none stretch=3 scale=2.2 angle=31 solver=flux", "mapped map=isotropic solver=surface",
        "mapped map=haunch stretch=2 solver=surface", "threshold stretch=3 angle=31", "threshold angle=31 solver=euler"}) {
    // Every cell begins in a disc; the reaction is on everywhere, then off.
    dapple::Recipe recipe = tests::recipe_of(
        (std::string(text) + " start=seeds pitch=8 radius=9 aspect=1 jitter=0 rho=-0.01:0.01@0.5 steps=8").c_str());
    REQUIRE(recipe.stages == 1);
    set_maps(recipe, maps);
    Patch patch = {0, 0, {kClosed, kClosed, kClosed, kClosed}};
    const Patches all = {&patch, 1, 64, 48};
    INFO(text);
    std::vector<int16_t> field = Grown(recipe, on_patch(all, 0), 3).field();
    CHECK(*std::min_element(field.begin(), field.end()) == *std::max_element(field.begin(), field.end()));
    patch.side[Side::right] = dapple::fixed_side(900000, 100000);
    field = Grown(recipe, on_patch(all, 0), 3).field();
    CHECK(field[63] > field[0] + 100);
    patch.side[Side::right] = kClosed;
    patch.side[Side::bottom] = dapple::fixed_side(0, 500000);
    field = Grown(recipe, on_patch(all, 0), 3).field();
    CHECK(field[47 * 64] < field[0] - 100);
  }
}

namespace {

// Mean difference of neighbours across sides, over that of cells near them.
double seam_ratio(GrownAtlas& grown, const Patches& all) {
  std::vector<std::vector<int16_t>> field;
  for (uint8_t i = 0; i < all.count; ++i) field.push_back(grown.field(i));
  const int side = all.width;
  const auto value = [&](uint8_t patch, int x, int y) {
    const dapple::grid::Source s = dapple::grid::source_of(all, 0, patch, x, y);
    return int{field[s.patch][static_cast<size_t>(s.y * side + s.x)]};
  };
  double across = 0, inside = 0;
  const int depth = side / 8;
  for (uint8_t i = 0; i < all.count; ++i)
    for (int t = 0; t < side; ++t)
      for (int k = 0; k < dapple::kSides; ++k)
        for (int d = 0; d < depth; ++d) {
          const auto at = [&](int in) {
            const int place = (k & 1) != 0 ? side - 1 - in : in;
            return k < Side::top ? value(i, place, t) : value(i, t, place);
          };
          (d == 0 ? across : inside) += std::abs(at(d) - at(d - 1)) / (d == 0 ? 1.0 : depth - 1.0);
        }
  return across / inside;
}

}  // namespace

TEST_CASE("atlas: nothing shows across the sides of a sphere") {
  std::vector<Patch> six(6);
  dapple::make_sphere(six.data(), 64);
  const Patches sphere = {six.data(), 6, 64, 64};
  CHECK_FALSE(first_unpaired(sphere).found);
  const Surface metric = measured(dapple::sphere_surface(64));
  dapple::PlaceMaps maps{};
  maps.surface = &metric;
  dapple::Recipe recipe = tests::recipe_of("mapped map=isotropic scale=1.6 steps=24 solver=surface");
  set_maps(recipe, maps);
  for (uint32_t seed = 1; seed <= 3; ++seed) {
    GrownAtlas grown(recipe, sphere, seed, 100);
    REQUIRE(grown.status == dapple::ok);
    const double joined = seam_ratio(grown, sphere);
    INFO("seed " << seed << ": " << joined);
    CHECK(joined >= 0.9);
    CHECK(joined <= 1.1);
    std::vector<Patch> apart = six;
    for (Patch& p : apart)
      for (Side& s : p.side) s = kClosed;
    const Patches faces = {apart.data(), 6, 64, 64};
    GrownAtlas single(recipe, faces, seed);
    CHECK(seam_ratio(single, sphere) > 3);
  }
}
