// Patches: sides that repeat, end, are held or joined; many small patches are one large one, bit for bit; six are a
// sphere.
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
using tests::measured;

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
        Patch p = {i * width,
                   j * height,
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
    REQUIRE(status == dapple::ok);
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
                                "gray-scott start=noise steps=20",
                                "turing decay=12.25 steps=20",
                                "turing map=none aspect=2 angle=30 steps=20",
                                "fitzhugh-nagumo map=isotropic stretch=2 steps=20",
                                "fitzhugh-nagumo steps=20"};

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

TEST_CASE("atlas: a patch that repeats has the places of its torus") {
  const Sheet one(1, 1, 64, 48, false, false);
  for (const char* text : {"turing map=two-angle aspect=2 scale=9 steps=20", "turing map=radial grade=centre scale=9 steps=20",
                           "schnakenberg grade=down finest=0.7 stretch=1.5 steps=20"}) {
    const dapple::Recipe recipe = tests::recipe_of(text);
    INFO(text);
    REQUIRE(recipe.stages > 0);
    CHECK(Grown(recipe, on_patch(one.all, 0), 5).field() == Grown(recipe, dapple::torus(64, 48), 5).field());
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
  const int8_t falling[] = {0, 127};  // one direction, which mirrors turn
  on_large.direction = on_three.direction = {falling, 1, 1};
  const uint8_t middling[] = {100};
  on_large.lengths = on_three.lengths = {middling, 1, 1};
  const Sheet one(1, 1, 96, 64, true, true), row(3, 1, 32, 64, true, true), around(1, 1, 96, 64, true, false);
  std::vector<std::string> texts(std::begin(kRecipes), std::end(kRecipes));
  texts.push_back("mapped map=none stretch=2 angle=20 scale=1.6 steps=4 solver=surface");
  texts.push_back("mapped map=isotropic scale=1.3 steps=4 levels=2 fine=2 solver=surface");
  texts.push_back("turing map=image aspect=2 vary=0.1 steps=20");
  texts.push_back("turing map=image grade=image scale=9 stretch=1.5 steps=20");
  texts.push_back("fitzhugh-nagumo map=image stretch=2 angle=10 level=1 steps=20 then refine steps=4");
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
  for (const char* text : {"mapped map=none stretch=3 scale=2.2 angle=31 solver=flux",
                           "mapped map=isotropic solver=surface", "mapped map=haunch stretch=2 solver=surface",
                           "threshold stretch=3 angle=31", "threshold angle=31 solver=euler"}) {
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

// A uniform state u = a + b = 1, v = b / u^2 = .9, with sides at that state: whatever the cells' format, nothing moves.
TEST_CASE("atlas: fixed sides hold wide and narrow kinetics at what they say, and work is counted as it is done") {
  const struct {
    const char *text, *fixed;
    int unit, level;
  } kinds[] = {{"schnakenberg feed=0.1 supply=0.9", "1,0.9", 1024, 1024},
               {"fitzhugh-nagumo bias=0", "0,0", 16384, 0},
               {"meinhardt-spots decay=0.04 drain=0.04", "1,0.25", 1024, 1024}};
  for (const auto& kind : kinds) {
    INFO(kind.text);
    const std::string recipe = std::string(kind.text) + " start=point radius=0.5 amplitude=0.01 steps=40";
    const dapple::Recipe held = tests::recipe_of((recipe + " sides=fixed fixed=" + kind.fixed).c_str());
    REQUIRE(held.stages == 1);
    const Patch patch = patch_of(held);
    const Patches all = {&patch, 1, 64, 64};
    Grown grown(held, on_patch(all, 0), 3);
    REQUIRE(grown.status == dapple::ok);
    const std::vector<int16_t> field = grown.field();
    for (int y = 0; y < 64; ++y) CHECK(std::abs(field[static_cast<size_t>(64 * y)] - kind.level) <= kind.unit / 100);
    CHECK(grown.texture.rows_done() == grown.texture.rows_in_all());
  }
  const dapple::Recipe cascade =
      tests::recipe_of("turing sides=closed scale=6 vary=0.1 steps=20 then freeze above=4.2 steps=10 then carry steps=5 then reset steps=3");
  REQUIRE(cascade.stages == 4);
  const Patch patch = patch_of(cascade);
  const Patches all = {&patch, 1, 64, 48};
  Grown grown(cascade, on_patch(all, 0), 3, 7);
  REQUIRE(grown.status == dapple::ok);
  CHECK(grown.texture.rows_done() == grown.texture.rows_in_all());
}

namespace {

// Differences of neighbours across sides, and of cells near them.
struct Seam {
  double across = 0, inside = 0;
  double ratio() const { return across / inside; }
};
void add_seams(GrownAtlas& grown, const Patches& all, Seam& seam) {
  std::vector<std::vector<int16_t>> field;
  for (uint8_t i = 0; i < all.count; ++i) field.push_back(grown.field(i));
  const int side = all.width;
  const auto value = [&](uint8_t patch, int x, int y) {
    const dapple::grid::Source s = dapple::grid::source_of(all, 0, patch, x, y);
    return int{field[s.patch][static_cast<size_t>(s.y * side + s.x)]};
  };
  const int depth = side / 8;
  for (uint8_t i = 0; i < all.count; ++i)
    for (int t = 0; t < side; ++t)
      for (int k = 0; k < dapple::kSides; ++k)
        for (int d = 0; d < depth; ++d) {
          const auto at = [&](int in) {
            const int place = (k & 1) != 0 ? side - 1 - in : in;
            return k < Side::top ? value(i, place, t) : value(i, t, place);
          };
          (d == 0 ? seam.across : seam.inside) += std::abs(at(d) - at(d - 1)) / (d == 0 ? 1.0 : depth - 1.0);
        }
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
  // Few waves cross a side: over several seeds.
  std::vector<Patch> apart = six;
  for (Patch& p : apart)
    for (Side& s : p.side) s = kClosed;
  const Patches faces = {apart.data(), 6, 64, 64};
  Seam joined, single;
  for (uint32_t seed = 1; seed <= 6; ++seed) {
    GrownAtlas grown(recipe, sphere, seed, 100);
    REQUIRE(grown.status == dapple::ok);
    add_seams(grown, sphere, joined);
    if (seed > 1) continue;
    GrownAtlas alone(recipe, faces, seed);
    add_seams(alone, sphere, single);
  }
  INFO("joined " << joined.ratio() << ", apart " << single.ratio());
  CHECK(joined.ratio() >= 0.9);
  CHECK(joined.ratio() <= 1.1);
  CHECK(single.ratio() > 3);
}

TEST_CASE("atlas: the first side that does not pair up is named") {
  std::vector<Patch> six(6);
  dapple::make_sphere(six.data(), 32);
  const auto first = [&](const std::vector<Patch>& list, uint16_t width, uint16_t height) {
    const Patches all = {list.data(), static_cast<uint8_t>(list.size()), width, height};
    const dapple::AtlasNeed need = atlas_need(tests::recipe_of("mapped scale=1"), all);
    CHECK((need.status == dapple::bad_sides) == need.unpaired.found);
    CHECK((need.bytes == 0) == need.unpaired.found);
    if (!need.unpaired.found) return std::string();
    return std::to_string(need.unpaired.patch) + " " + std::to_string(need.unpaired.side);
  };
  CHECK(first(six, 32, 32) == "");
  CHECK(first(six, 40, 32) == "1 2");  // the north's right side is not as long
  std::vector<Patch> broken = six;
  broken[3].side[Side::right] = kClosed;
  CHECK(first(broken, 32, 32) == "0 0");
  broken = six;
  broken[5].side[Side::left].reversed = !six[5].side[Side::left].reversed;
  CHECK(first(broken, 32, 32) != "");
  broken = six;
  broken[2].side[Side::top].patch = 6;
  CHECK(first(broken, 32, 32) == "2 2");
  broken[2].side[Side::top] = dapple::fixed_side(1000001, 0);
  CHECK(first(broken, 32, 32) == "2 2");
}

TEST_CASE("atlas: what begin refuses, and that it leaves alone what it was given") {
  const dapple::Recipe recipe = tests::recipe_of("mapped scale=1 steps=1");
  const Sheet sheet(2, 1, 32, 24, true, true);
  std::vector<dapple::Texture> texture(2);
  dapple::Atlas atlas;
  const size_t bytes = atlas_need(recipe, sheet.all).bytes;
  std::vector<uint8_t> memory(bytes, 7);
  dapple::AtlasNeed need{};
  CHECK(atlas.begin(recipe, sheet.all, 1, texture.data(), memory.data(), bytes - 1, {}, &need) ==
        dapple::too_little_memory);
  CHECK(need.bytes == bytes);
  CHECK(memory == std::vector<uint8_t>(bytes, 7));
  CHECK(dapple::need_for(recipe, on_patch(sheet.all, 2)).status == dapple::bad_sides);
  CHECK(texture[0].begin(recipe, on_patch(sheet.all, 0), 1, memory.data(), bytes) == dapple::bad_sides);  // not alone
  CHECK(dapple::need_for(tests::recipe_of("bits"), on_patch(sheet.all, 0)).status == dapple::bad_sides);
  const Sheet small(1, 1, 8, 8, true, true), odd(1, 1, 41, 40, true, true);
  CHECK(dapple::need_for(tests::recipe_of("mapped scale=4"), on_patch(small.all, 0)).status == dapple::tile_too_small);
  CHECK(dapple::need_for(tests::recipe_of("mapped levels=2"), on_patch(odd.all, 0)).status == dapple::not_a_multiple);
  CHECK(dapple::need_for(tests::recipe_of("mapped sides=closed"), dapple::torus(64, 64)).status == dapple::bad_sides);
}

TEST_CASE("atlas: sides are words of a recipe") {
  const auto sides = [](const char* text) {
    const Patch p = patch_of(tests::recipe_of((std::string("mapped ") + text).c_str()));
    std::string said;
    for (const Side& s : p.side) said += s.kind == Side::joined ? 'j' : s.kind == Side::closed ? 'c' : 'f';
    return said + (said.find('f') == std::string::npos ? "" : std::to_string(p.side[said.find('f')].value[1]));
  };
  CHECK(sides("") == "jjjj");
  CHECK(sides("sides=closed") == "cccc");
  CHECK(sides("sides=repeat,closed") == "jjcc");
  CHECK(sides("sides=closed,fixed,repeat,repeat fixed=0.25,0.5") == "cfjj500000");
  for (const char* wrong : {"sides=closed,repeat,closed,closed", "sides=closed,closed,closed", "sides=open",
                            "sides=", "sides=closed,closed,closed,closed,closed", "fixed=0.5", "fixed=1.5,0"})
    CHECK(tests::recipe_of((std::string("mapped ") + wrong).c_str()).stages == 0);
  const dapple::Recipe recipe = tests::recipe_of("mapped sides=fixed,closed,repeat,repeat fixed=0.25,0.5 scale=1.5");
  char text[600];
  CHECK(write(recipe, text, sizeof text) < sizeof text);
  const Patch once = patch_of(recipe), again = patch_of(tests::recipe_of(text));
  for (int i = 0; i < dapple::kSides; ++i) {
    CHECK(once.side[i].kind == again.side[i].kind);
    CHECK(once.side[i].value[0] == again.side[i].value[0]);
  }
}
