// Corner tiles: the table and the floor, equal cells where tiles may meet, no crease there, the same bytes however they are
// grown, and what is refused.
// SPDX-License-Identifier: MIT
#include "corners.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "grow.hpp"

namespace {

namespace grid = dapple::grid;

dapple::Recipe recipe_named(const std::string& text) {
  const size_t space = text.find(' ');
  const std::string name = text.substr(0, space);
  if (dapple::find_preset(name.c_str()) == nullptr) return tests::recipe_of(text.c_str());
  return space == std::string::npos ? tests::preset(name)
                                    : tests::preset_with(name.c_str(), text.c_str() + space + 1);
}

// A picture of 4 x 4 tiles, of cells of several parts each, looked at round its edges.
template <class Value> struct Sheet {
  std::vector<Value> cells;
  int side, parts;

  Value at(int x, int y, int part = 0) const {
    const int all = 4 * side;
    return cells[static_cast<size_t>(parts) * (static_cast<size_t>((y + all) % all) * all + (x + all) % all) + part];
  }
};

// Cells that differ between two edges with the same colours at their ends, two cells deep on either side.
template <class Value> size_t mismatches(const Sheet<Value>& sheet) {
  size_t wrong = 0;
  const auto colour = [](int i, int j) { return grid::corner_colour(static_cast<uint8_t>(i), static_cast<uint8_t>(j)); };
  for (int a = 0; a < 16; ++a)
    for (int b = 0; b < 16; ++b) {
      const int ai = a & 3, aj = a >> 2, bi = b & 3, bj = b >> 2, side = sheet.side;
      if (colour(ai, aj) != colour(bi, bj)) continue;
      const bool across = colour(ai + 1, aj) == colour(bi + 1, bj), down = colour(ai, aj + 1) == colour(bi, bj + 1);
      for (int along = 0; along < side; ++along)
        for (int off = -2; off < 2; ++off)
          for (int part = 0; part < sheet.parts; ++part) {
            wrong += across && sheet.at(ai * side + along, aj * side + off, part) != sheet.at(bi * side + along, bj * side + off, part);
            wrong += down && sheet.at(ai * side + off, aj * side + along, part) != sheet.at(bi * side + off, bj * side + along, part);
          }
    }
  return wrong;
}

Sheet<int16_t> field_of(tests::Grown& grown, int side) { return {grown.field(), side, 1}; }

// A floor of across x across tiles, as tile_at lays it.
Sheet<int16_t> floor_of(const Sheet<int16_t>& sheet, uint32_t seed, int across) {
  const int side = sheet.side, all = across * side;
  Sheet<int16_t> floor{std::vector<int16_t>(static_cast<size_t>(all) * all), all / 4, 1};
  for (int ty = 0; ty < across; ++ty)
    for (int tx = 0; tx < across; ++tx) {
      const dapple::CornerTile tile = dapple::tile_at(seed, tx - 3, ty - 5);
      for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
          floor.cells[static_cast<size_t>(ty * side + y) * all + tx * side + x] = sheet.at(tile.column * side + x, tile.row * side + y);
    }
  return floor;
}

// The mean absolute second difference at every column (or row) of a tile of the floor, over its median.
std::vector<double> second_differences(const Sheet<int16_t>& floor, int side, bool rows) {
  const int all = 4 * floor.side;
  std::vector<double> sum(static_cast<size_t>(side));
  for (int y = side; y < all - side; ++y)
    for (int x = side; x < all - side; ++x) {
      const int before = rows ? floor.at(x, y - 1) : floor.at(x - 1, y), after = rows ? floor.at(x, y + 1) : floor.at(x + 1, y);
      sum[static_cast<size_t>((rows ? y : x) % side)] += std::abs(before - 2 * floor.at(x, y) + after);
    }
  std::vector<double> sorted = sum;
  std::nth_element(sorted.begin(), sorted.begin() + side / 2, sorted.end());
  for (double& value : sum) value /= sorted[static_cast<size_t>(side) / 2];
  return sum;
}

dapple::Status try_corners(const char* text, uint16_t side, dapple::Need* need = nullptr) {
  const dapple::Recipe recipe = recipe_named(text);
  const dapple::Need wanted = dapple::need_for(recipe, dapple::corner_tiles(side));
  if (need != nullptr) *need = wanted;
  return wanted.status;
}

struct Golden {
  std::string recipe;
  unsigned side, seed;
  uint64_t field;
};
std::vector<Golden> goldens() {
  std::vector<Golden> all;
  std::ifstream in(DAPPLE_GOLDEN_DIR "/corners.txt");
  for (std::string line; std::getline(in, line);) {
    Golden g{};
    const int read = std::sscanf(line.c_str(), "%u %u %" SCNx64, &g.side, &g.seed, &g.field);
    size_t at = 0;
    for (int i = 0; i < 3; ++i) at = line.find(' ', at) + 1;
    g.recipe = line.substr(at);
    REQUIRE_MESSAGE(read == 3, "broken golden line: " << line);
    all.push_back(g);
  }
  REQUIRE(!all.empty());
  return all;
}

void check(const Golden& g, uint32_t budget, uint8_t bands) {
  dapple::Options options;
  options.bands = bands;
  tests::Grown grown(recipe_named(g.recipe), dapple::corner_tiles(static_cast<uint16_t>(g.side)), g.seed, budget, options);
  REQUIRE(grown.status == dapple::ok);
  char now[40];
  std::snprintf(now, sizeof now, "%u %u %016" PRIx64, g.side, g.seed, grown.field_hash());
  INFO("now: " << now << " " << g.recipe << "  (budget " << budget << ", bands " << int(bands) << ")");
  CHECK(grown.field_hash() == g.field);
  CHECK(grown.texture.rows_done() == grown.texture.rows_in_all());
}

}  // namespace

TEST_CASE("corners: every choice of colours once, every class as large as it should be") {
  unsigned seen = 0;
  for (uint8_t j = 0; j < 4; ++j)
    for (uint8_t i = 0; i < 4; ++i) seen |= 1u << grid::corners_of(i, j);
  CHECK(seen == 0xffff);
  const grid::Classes c = grid::kClasses;
  const auto members = [](const grid::Alike& alike, uint8_t share) {
    for (uint8_t t = 0; t < 16; ++t) {
      const auto like = std::count(std::begin(alike.first), std::end(alike.first), alike.first[t]);
      CHECK(like == 1 << share);
      CHECK(alike.first[alike.first[t]] == alike.first[t]);
      CHECK(alike.first[t] <= t);
    }
  };
  for (int far = 0; far < 2; ++far) {
    members(c.across[far], grid::kEdgeShare);
    members(c.down[far], grid::kEdgeShare);
    for (int right = 0; right < 2; ++right) members(c.corner[far][right], grid::kCornerShare);
  }
}

TEST_CASE("corners: tiles of the floor have the colours of its corners, wherever it is") {
  const auto colour = [](dapple::CornerTile t, int right, int below) {
    return grid::corner_colour(static_cast<uint8_t>(t.column + right), static_cast<uint8_t>(t.row + below));
  };
  const int32_t places[] = {INT32_MIN, -70, -1, 0, 12345678, INT32_MAX - 40};
  size_t wrong = 0;
  for (const int32_t left : places)
    for (const int32_t top : places)
      for (int32_t y = top; y < top + 40; ++y)
        for (int32_t x = left; x < left + 40; ++x) {
          const dapple::CornerTile tile = dapple::tile_at(9, x, y);
          const dapple::CornerTile right = dapple::tile_at(9, x + 1, y), below = dapple::tile_at(9, x, y + 1);
          wrong += colour(tile, 0, 0) != dapple::colour_at(9, x, y);
          wrong += colour(tile, 1, 0) != colour(right, 0, 0) || colour(tile, 1, 1) != colour(right, 0, 1);
          wrong += colour(tile, 0, 1) != colour(below, 0, 0) || colour(tile, 1, 1) != colour(below, 1, 0);
        }
  CHECK(wrong == 0);
}

TEST_CASE("corners: the floor uses all tiles, and four equal ones never meet") {
  constexpr int kAcross = 300;
  int count[16] = {}, equal = 0, like_other_seed = 0;
  const auto number = [](int x, int y) { return dapple::tile_at(1, x, y).number(); };
  for (int y = 0; y < kAcross; ++y)
    for (int x = 0; x < kAcross; ++x) {
      const uint8_t n = number(x, y);
      ++count[n];
      equal += n == number(x + 1, y) && n == number(x, y + 1) && n == number(x + 1, y + 1);
      like_other_seed += n == dapple::tile_at(2, x, y).number();
    }
  CHECK(equal == 0);
  for (const int times : count) {
    CHECK(times > kAcross * kAcross / 32);
    CHECK(times < kAcross * kAcross / 12);
  }
  CHECK(like_other_seed < kAcross * kAcross / 12);
}

TEST_CASE("corners: edges between equal colours are equal bit for bit, two cells deep") {
  for (const char* text : {"zebra", "weave levels=2", "coral", "maze", "reptile", "giraffe levels=2", "stucco", "zebra-bends", "zebra solver=euler steps=6",
                           "mitosis steps=700", "gs-maze steps=330 start=noise", "threshold scale=0.4 steps=9", "zebra steps=1"}) {
    CAPTURE(text);
    const dapple::Recipe recipe = recipe_named(text);
    const uint16_t side = 104;
    tests::Grown grown(recipe, dapple::corner_tiles(side), 5);
    REQUIRE(grown.status == dapple::ok);
    CHECK(mismatches(field_of(grown, side)) == 0);
    dapple::Brush brush;
    brush.format = dapple::Pixels::rgb888;
    if (recipe.paint.grain == 0 && recipe.paint.light == 0) CHECK(mismatches(Sheet<uint8_t>{grown.pixels(brush), side, 3}) == 0);
  }
}

TEST_CASE("corners: a plain torus has no equal edges, and tiles share no more than theirs") {
  const uint16_t side = 136;
  tests::Grown plain(recipe_named("zebra"), dapple::torus(4 * side, 4 * side), 5);
  CHECK(mismatches(field_of(plain, side)) > 10000);
  tests::Grown grown(recipe_named("zebra"), dapple::corner_tiles(side), 5);
  const Sheet<int16_t> sheet = field_of(grown, side);
  double least = 1, most = 0;
  for (int a = 0; a < 16; ++a)
    for (int b = 0; b < a; ++b) {
      int same = 0, all = 0;
      for (int y = 24; y < side - 24; ++y)
        for (int x = 24; x < side - 24; ++x, ++all)
          same += (sheet.at((a & 3) * side + x, (a >> 2) * side + y) > 0) == (sheet.at((b & 3) * side + x, (b >> 2) * side + y) > 0);
      least = std::min(least, double(same) / all);
      most = std::max(most, double(same) / all);
    }
  MESSAGE("cells on in both or in neither of two tiles' insides: " << least << " to " << most);
  CHECK(most < 0.85);
}

// Of columns and rows, the mean of four seeds; `plain`: tiles of a torus of as many cells, which share nothing and do not meet.
struct Creases {
  std::vector<double> columns, rows;
};
Creases creases_of(const dapple::Recipe& recipe, uint16_t side, bool plain) {
  constexpr int kSeeds = 4;
  Creases mean{std::vector<double>(side), std::vector<double>(side)};
  for (uint32_t seed = 1; seed <= kSeeds; ++seed) {
    const uint16_t all = static_cast<uint16_t>(4 * side);
    tests::Grown grown(recipe, plain ? dapple::torus(all, all) : dapple::corner_tiles(side), seed);
    const Sheet<int16_t> floor = floor_of(field_of(grown, side), seed, 14);
    const std::vector<double> x = second_differences(floor, side, false), y = second_differences(floor, side, true);
    for (size_t i = 0; i < side; ++i) {
      mean.columns[i] += x[i] / kSeeds;
      mean.rows[i] += y[i] / kSeeds;
    }
  }
  return mean;
}

// At an edge and at the borders of the bands where the reaction is shared and where planes are blended; beside what is natural
// there, which is only known inside a tile.
void check_creases(const dapple::Recipe& recipe, uint16_t side, const Creases& have, const Creases* natural) {
  const dapple::Stage& stage = recipe.stage[0];
  const dapple::evolve::BandWidth width = dapple::evolve::band_width(stage.solver->sharing, recipe.start.kind);
  for (const int32_t percent : {0, int32_t{width.narrow}, int32_t{width.blend}}) {
    const int band = percent == 0 ? 0 : dapple::evolve::band_of(*stage.model, stage.number, percent, side, 0);
    double worst = 0;
    for (const int at : {band - 1, band, band + 1, side - band - 2, side - band - 1, side - band}) {
      const size_t i = static_cast<size_t>((at + side) % side);
      const size_t inside = static_cast<size_t>(std::clamp((at + side) % side, 1, side - 2));
      const double column = natural ? natural->columns[inside] : 1, row = natural ? natural->rows[inside] : 1;
      worst = std::max({worst, have.columns[i] / column, have.rows[i] / row});
    }
    MESSAGE("second differences " << band << " cells from an edge: " << worst << " of the inside");
    CHECK(worst <= 1.10);
  }
}

TEST_CASE("corners: no crease at edges and at the borders of bands") {
  const dapple::Recipe recipe = recipe_named("zebra");
  check_creases(recipe, 144, creases_of(recipe, 144, false), nullptr);
}

TEST_CASE("corners: no crease where stripes bend, beyond what the bends themselves do") {
  const dapple::Recipe recipe = recipe_named("zebra-bends");
  const Creases natural = creases_of(recipe, 144, true);
  check_creases(recipe, 144, creases_of(recipe, 144, false), &natural);
}

TEST_CASE("corners: golden, in one call") {
  for (const Golden& g : goldens()) check(g, UINT32_MAX, 1);
}

TEST_CASE("corners: golden, in slices and bands") {
  for (const Golden& g : goldens()) {
    check(g, 1, 1);
    check(g, 7, 3);
    check(g, UINT32_MAX, 64);
  }
}

TEST_CASE("corners: what is refused") {
  dapple::Need need{};
  CHECK(try_corners("zebra", 104) == dapple::ok);
  CHECK(try_corners("zebra-bits", 104) == dapple::no_corners);
  CHECK(try_corners("fingerprint", 104) == dapple::no_corners);
  CHECK(try_corners("cells rule=7", 104) == dapple::no_corners);
  CHECK(try_corners("mapped map=swirl", 104) == dapple::no_corners);
  CHECK(try_corners("mapped map=corners", 104) == dapple::ok);
  CHECK(try_corners("mapped map=corners solver=lean", 104) == dapple::ok);
  CHECK(try_corners("zebra steps=0", 104) == dapple::no_corners);
  CHECK(try_corners("zebra", 50, &need) == dapple::tile_too_small);
  CHECK(need.width == 4 * 51);  // three wavelengths of 16.93 cells
  CHECK(need.bytes == 0);
  CHECK(try_corners("zebra", 51) == dapple::ok);
  CHECK(try_corners("zebra levels=2", 105, &need) == dapple::not_a_multiple);
  CHECK(need.multiple == 8);
  CHECK(try_corners("giraffe", 76) == dapple::tile_too_small);
  CHECK(try_corners("giraffe", 77) == dapple::ok);
  CHECK(try_corners("zebra", 16383) == dapple::ok);
  CHECK(try_corners("zebra", 16384) == dapple::bad_side);
  dapple::Domain domain = dapple::corner_tiles(104);
  domain.height = 208;
  CHECK(dapple::need_for(recipe_named("zebra"), domain).status == dapple::bad_side);
  domain = dapple::corner_tiles(104);
  domain.x = 4;
  CHECK(dapple::need_for(recipe_named("zebra"), domain).status == dapple::bad_side);
}
