// The plane in blocks: windows of the threshold family are parts of each other, whatever came before, and show no blocks.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <random>
#include <string>

#include "world.hpp"

namespace evolve = dapple::evolve;
namespace stencil = dapple::stencil;
using dapple::window;
using tests::Grown;
using tests::kSeed;
using tests::World;
using tests::part;
using tests::preset;

namespace {

using Cells = std::vector<int16_t>;


bool meet(const evolve::Span& a, const evolve::Span& b) { return a.from < b.to && b.from < a.to; }
bool meet(const evolve::Box& a, const evolve::Box& b) { return meet(a.x, b.x) && meet(a.y, b.y); }

bool in(const evolve::Cover& c, uint8_t layer, int32_t x, int32_t y) {
  return x >= c.x[layer].first && x <= c.x[layer].last && y >= c.y[layer].first && y <= c.y[layer].last;
}

// Blocks of lower layers that a block reads are in the cover.
void check_below(const evolve::BlockGrid& g, const evolve::Cover& cover, uint8_t layer, const evolve::Box& reads) {
  const int32_t left = dapple::chunk_at(reads.x.from, g.side), top = dapple::chunk_at(reads.y.from, g.side);
  for (uint8_t below = 0; below < layer; ++below)
    for (int32_t y = top - 2; (y - 2) * g.side < reads.y.to; ++y)
      for (int32_t x = left - 2; (x - 2) * g.side < reads.x.to; ++x)
        if (meet(evolve::covered(g, below, x, y), reads)) REQUIRE(in(cover, below, x, y));
}

// Mean size of the second difference across column (row) `at` of every block.
double across(const Cells& field, size_t wide, size_t side, size_t at, bool down) {
  double sum = 0;
  size_t count = 0;
  for (size_t x = at == 0 ? side : at; x + 1 < wide; x += side)
    for (size_t y = 0; y < wide; ++y, ++count) {
      const auto cell = [&](size_t i) { return int{down ? field[i * wide + y] : field[y * wide + i]}; };
      sum += std::abs(cell(x - 1) - 2 * cell(x) + cell(x + 1));
    }
  return sum / static_cast<double>(count);
}

// What lies at the blocks' edges against the median of all columns that are as far from the next row of seeds.
double at_edges(const Cells& field, size_t wide, size_t side, size_t period, bool down) {
  std::vector<double> columns;
  for (size_t x = period; x < side; x += period) columns.push_back(across(field, wide, side, x, down));
  std::sort(columns.begin(), columns.end());
  return across(field, wide, side, 0, down) / columns[columns.size() / 2];
}

// Tiles that know nothing of each other, side by side.
Cells patchwork(const dapple::Recipe& recipe, uint16_t side, uint16_t count) {
  const size_t wide = static_cast<size_t>(side) * count;
  Cells all(wide * wide);
  for (uint16_t i = 0; i < count * count; ++i) {
    Grown tile(recipe, dapple::torus(side, side), 100u + i);
    for (uint16_t y = 0; y < side; ++y) tile.texture.row(y, &all[(size_t{i} / count * side + y) * wide + size_t{i} % count * side]);
  }
  return all;
}

double root_mean_square(const Cells& field) {
  double sum = 0;
  for (const int16_t value : field) sum += static_cast<double>(value) * value;
  return std::sqrt(sum / static_cast<double>(field.size()));
}

}  // namespace

TEST_CASE("blocks: of one layer keep clear of each other, and a cover holds all that is read") {
  std::mt19937 random(3);
  for (int32_t length = 2600000; length < 220000000; length += length / 9) {
    const evolve::BlockGrid g = evolve::block_grid(length);
    for (uint8_t layer = 1; layer < evolve::kLayers; ++layer)
      for (int32_t i = 0; i < 9; ++i)
        if (i != 4) REQUIRE(!meet(evolve::grown(g, layer, 0, 0), evolve::covered(g, layer, i % 3 - 1, i / 3 - 1)));
    REQUIRE(g.around % 8 == 0);
    for (int round = 0; round < 40; ++round) {
      const int32_t x = static_cast<int32_t>(random() % 3000) - 1500, y = static_cast<int32_t>(random() % 3000) - 1500;
      const uint16_t width = static_cast<uint16_t>(8 + random() % 700), height = static_cast<uint16_t>(8 + random() % 700);
      const evolve::Box wanted = {{x, x + width}, {y, y + height}};
      const evolve::Cover cover = evolve::cover_of(g, wanted);
      check_below(g, cover, evolve::kLayers, wanted);
      for (uint8_t layer = 1; layer < evolve::kLayers; ++layer)
        for (int32_t j = cover.y[layer].first; j <= cover.y[layer].last; ++j)
          for (int32_t i = cover.x[layer].first; i <= cover.x[layer].last; ++i)
            check_below(g, cover, layer, evolve::grown(g, layer, i, j));
      REQUIRE(evolve::count_of(cover.x[0]) <= evolve::most_chunks(g, width));
      REQUIRE(evolve::count_of(cover.y[0]) <= evolve::most_chunks(g, height));
      for (uint8_t layer = 1; layer < evolve::kLayers; ++layer) {
        if (evolve::count_of(cover, layer) == 0) continue;
        REQUIRE(in(cover, 0, cover.x[layer].first, cover.y[layer].first));
        REQUIRE(in(cover, 0, cover.x[layer].last, cover.y[layer].last));
      }
    }
  }
}

TEST_CASE("blocks: the passes of shading are wide where those of a step are, and have strides enough") {
  for (const int32_t length : evolve::kShadeLength) {
    CAPTURE(length);
    const int32_t narrow = stencil::wide_share(length), most = stencil::wide_share(dapple::grid::kOneVariance);
    CHECK(narrow == int64_t{most} * length / dapple::grid::kOneVariance);
    int32_t made = 0;
    stencil::PassSeries series = stencil::series_of(narrow, 0, narrow);
    for (stencil::Pass pass{}; stencil::next_pass(series, pass); ++made) CHECK(pass.stride == std::max(made, 1));
    CHECK(made == stencil::reach_of(narrow, narrow) + 1);
    CHECK(stencil::reach_of(narrow + 1, narrow) != stencil::reach_of(narrow + 1, narrow + 1));
    const dapple::grid::Tensor widest = dapple::grid::over({1600 * dapple::grid::kOneVariance, 0, 0}, length);  // of scale 8 and stretch 5
    CHECK(widest.xx <= stencil::kLargestShare);
  }
}

TEST_CASE("blocks: a window is its parts, alone or from a cache, in any order, budget and bands") {
  constexpr uint16_t kSide = 96;
  std::mt19937 random(17);
  for (const char* name : {"zebra", "giraffe", "reptile", "maze"})
    for (const int32_t at : {-3, 7000000}) {
      CAPTURE(name);
      if (at > 0 && std::strcmp(name, "zebra") != 0) continue;  // far away is the same to all
      const dapple::Recipe recipe = preset(name);
      Grown whole(recipe, window(at * kSide, -at * kSide, 3 * kSide, 2 * kSide), kSeed);
      REQUIRE(whole.status == dapple::ok);
      const std::vector<uint8_t> rgba = whole.pixels(dapple::Brush{});
      World world(recipe, kSide, 4, dapple::Brush{}, 2, random() % 4);
      std::vector<int> order = {0, 1, 2, 3, 4, 5, 0, 3};  // four slots: some make room, and come again
      std::shuffle(order.begin(), order.end(), random);
      for (const int i : order) {
        const int32_t cx = at + i % 3, cy = -at + i / 3;
        REQUIRE(world.chunks.look_at(cx * kSide, cy * kSide, kSide, kSide) == dapple::ok);
        if (i % 2 == 1) {  // given up on the way
          world.chunks.step(static_cast<uint32_t>(random() % 300000));
          world.chunks.look_at(-cx * kSide, cy * kSide, 9, 9);
          world.chunks.step(static_cast<uint32_t>(random() % 100000));
          world.chunks.look_at(cx * kSide, cy * kSide, kSide, kSide);
        }
        while (world.chunks.step(977) == dapple::more) {
        }
        const size_t x = static_cast<size_t>(i % 3 * kSide), y = static_cast<size_t>(i / 3 * kSide);
        CHECK(tests::pixels_of(world.chunks, cx, cy) == part(rgba, 12u * kSide, 4 * x, y, 4u * kSide, kSide));
      }
      const uint16_t x = static_cast<uint16_t>(random() % 200), y = static_cast<uint16_t>(random() % 150);
      dapple::Options options;
      options.bands = 3;
      Grown alone(recipe, window(at * kSide + x, -at * kSide + y, 41, 23), kSeed, 1, options);
      CHECK(alone.field() == part(whole.field(), 3u * kSide, x, y, 41, 23));
    }
}

TEST_CASE("blocks: every preset that has them, and every way a recipe can grow a chunk") {
  const auto check = [](const dapple::Recipe& recipe, const std::string& name) {
    Grown whole(recipe, window(-500, 333, 120, 100), kSeed), other(recipe, window(-455, 300, 40, 99), kSeed, 7);
    REQUIRE_MESSAGE(whole.status == dapple::ok, name);
    CHECK(dapple::need_for(recipe, window(0, 0, 8, 8)).block > 0);
    const Cells field = whole.field();
    CHECK_MESSAGE(part(other.field(), 40, 0, 33, 40, 66) == part(field, 120, 45, 0, 40, 66), name);
    CHECK(std::any_of(field.begin(), field.end(), [&](int16_t v) { return v > whole.texture.cell_level(); }));
    CHECK(std::any_of(field.begin(), field.end(), [&](int16_t v) { return v <= whole.texture.cell_level(); }));
  };
  int found = 0;
  for (uint16_t i = 0; i < dapple::preset_count(); ++i) {
    char name[dapple::kMaxName];
    const dapple::Recipe recipe = dapple::load(*dapple::preset_at(i, name).preset);
    if (!tests::in_blocks(recipe)) continue;
    ++found;
    check(recipe, name);
  }
  CHECK(found == 15);  // stucco's halo is narrow enough
  check(tests::preset_with("weave", "levels=2"), "weave levels=2");
  check(tests::preset_with("sand", "levels=4 steps=50"), "sand levels=4");
  check(tests::preset_with("sand", "solver=euler"), "sand solver=euler");
  check(tests::recipe_of("threshold scale=0.5 steps=100"), "fine");
}

TEST_CASE("blocks: no edge is to be seen") {
  const struct {
    std::string name;
    uint16_t blocks;
    size_t period;  // of the rows of seeds, where whole blocks hold whole numbers of them
  } all[] = {{"zebra", 6, 1}, {"giraffe", 3, 1}, {"reptile", 4, 16}, {"maze", 6, 1}};
  for (const auto& one : all) {
    CAPTURE(one.name);
    const dapple::Recipe recipe = preset(one.name);
    const uint16_t side = dapple::need_for(recipe, window(0, 0, 64, 64)).block;
    const uint16_t wide = static_cast<uint16_t>(side * one.blocks);
    Grown plane(recipe, window(0, 0, wide, wide), kSeed);
    REQUIRE(plane.status == dapple::ok);
    const Cells field = plane.field();
    for (const bool down : {false, true}) {
      const double ratio = at_edges(field, wide, side, one.period, down);
      MESSAGE(one.name << std::string(down ? " rows" : " columns") << ": second differences at the edges " << ratio);
      CHECK(ratio < 1.10);
      CHECK(ratio > 0.85);
    }
    Grown torus(recipe, dapple::torus(wide, wide), kSeed);
    const double size = root_mean_square(field) / root_mean_square(torus.field());
    MESSAGE(one.name << ": the field is " << size << " of the torus'");
    CHECK(std::abs(size - 1) < 0.05);
  }
  const dapple::Recipe zebra = preset("zebra");
  CHECK(at_edges(patchwork(zebra, 160, 3), 480, 160, 1, false) > 1.5);  // it would be seen
}

TEST_CASE("blocks: work, progress, and what is refused") {
  const dapple::Recipe zebra = preset("zebra");
  std::vector<uint8_t> memory(dapple::bytes_for(zebra, window(0, 0, 64, 64)));
  dapple::Texture tile;
  dapple::Options options;
  REQUIRE(tile.begin(zebra, window(0, 0, 64, 64), 1, memory.data(), memory.size(), options) == dapple::ok);
  CHECK(tile.rows_in_all() == dapple::need_for(zebra, window(0, 0, 64, 64)).rows);
  REQUIRE(tile.step(100000) == dapple::more);
  CHECK((tile.rows_done() == 100000 && !tile.decided() && tile.unit() == 8000));
  int16_t row[64] = {1, 2, 3};
  tile.row(5, row);
  CHECK(std::all_of(row, row + 64, [](int16_t v) { return v == 0; }));
  tile.finish();
  CHECK((tile.decided() && tile.rows_done() == tile.rows_in_all()));
  tile.row(5, row);
  CHECK(std::any_of(row, row + 64, [](int16_t v) { return v != 0; }));
  // The same place again: all is decided; a place beside it: much is.
  options.again = true;
  const uint64_t all = tile.rows_in_all();
  REQUIRE(tile.begin(zebra, window(0, 0, 64, 64), 1, memory.data(), memory.size(), options) == dapple::ok);
  CHECK(tile.rows_in_all() < all / 100);
  tile.finish();
  REQUIRE(tile.begin(zebra, window(160, 0, 64, 64), 1, memory.data(), memory.size(), options) == dapple::ok);
  CHECK((tile.rows_in_all() < all && tile.rows_in_all() > all / 100));
  tile.finish();
  CHECK(tile.rows_done() == tile.rows_in_all());

  CHECK(dapple::need_for(preset("mitosis"), window(0, 0, 64, 64)).status == dapple::halo_too_wide);
  CHECK(dapple::fixed(dapple::presets::giraffe, window(0, 0, 64, 64)).need.status == dapple::halo_too_wide);
  CHECK(dapple::need_for(zebra, window(tests::kEdge, 0, 8, 8)).status == dapple::too_far);
  CHECK(dapple::need_for(zebra, window(0, 0, 65000, 8)).status == dapple::too_large);
  CHECK(dapple::need_for(tests::preset_with("zebra", "steps=2"), window(0, 0, 8, 8)).block == 0);
}

TEST_CASE("blocks: golden windows") {
  std::ifstream in(DAPPLE_GOLDEN_DIR "/planes.txt");
  int lines = 0;
  for (std::string line; std::getline(in, line); ++lines) {
    char name[64], now[200];
    int x = 0, y = 0;
    unsigned width = 0, height = 0, seed = 0;
    REQUIRE(std::sscanf(line.c_str(), "%63s %d,%d %ux%u %u", name, &x, &y, &width, &height, &seed) == 6);
    Grown tile(preset(name), window(x, y, static_cast<uint16_t>(width), static_cast<uint16_t>(height)), seed, 5000);
    REQUIRE(tile.status == dapple::ok);
    std::snprintf(now, sizeof now, "%s %d,%d %ux%u %u %016" PRIx64 " %016" PRIx64, name, x, y, width, height, seed,
                  tile.field_hash(), tile.paint_hash());
    CHECK(line == now);
  }
  CHECK(lines == 2 * 11);
}
