// The cache of chunks: against a plain model of what it promises, and its edges one by one.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <random>
#include <utility>

#include "world.hpp"

using dapple::Chunks;
using dapple::Pixels;
using dapple::window;
using tests::Cell;
using tests::Grown;
using tests::kEdge;
using tests::kSeed;
using tests::pixels_of;
using tests::World;

namespace {

constexpr const char* kPlain = "bits scale=9 stretch=3 angle=78.5 steps=8 ramp=zebra range=-0.95,0.95";
constexpr const char* kQuick = "cells rule=0xfee8e880 steps=2";

// What a cache promises, without its cleverness.
struct Model {
  struct Held {
    uint32_t seen;
    size_t slot;
  };
  uint16_t side;
  size_t slots;
  uint32_t rows_a_chunk, grow_rows;
  std::map<Cell, Held> held;
  std::vector<Cell> sight, before;
  int64_t middle_x = 0, middle_y = 0;
  uint32_t now = 0, done = 0;  // rows of the chunk at work
  bool working = false;
  Cell at{};
  size_t slot = 0;  // taken when painting begins
  dapple::ChunkCounters counted{};

  static bool in(const std::vector<Cell>& cells, Cell c) {
    return std::find(cells.begin(), cells.end(), c) != cells.end();
  }

  void look_at(int32_t x, int32_t y, int32_t width, int32_t height) {
    ++now;
    before = sight;
    sight.clear();
    for (int64_t cy = floor_of(y); cy <= floor_of(y + height - 1); ++cy)
      for (int64_t cx = floor_of(x); cx <= floor_of(x + width - 1); ++cx)
        sight.emplace_back(static_cast<int32_t>(cx), static_cast<int32_t>(cy));
    for (const Cell& c : sight) {
      const auto found = held.find(c);
      if (found != held.end()) found->second.seen = now;
      if (!in(before, c)) ++(found != held.end() ? counted.hits : counted.misses);
    }
    middle_x = 2 * int64_t{x} + width;
    middle_y = 2 * int64_t{y} + height;
    if (working && !in(sight, at)) {
      working = false;
      ++counted.abandoned;
    }
  }
  int64_t floor_of(int64_t cell) const { return (cell - ((cell % side) + side) % side) / side; }

  bool choose() {
    int64_t nearest = INT64_MAX;
    for (const Cell& c : sight) {
      const int64_t dx = (2 * int64_t{c.first} + 1) * side - middle_x,
                    dy = (2 * int64_t{c.second} + 1) * side - middle_y;
      if (held.count(c) != 0 || dx * dx + dy * dy >= nearest) continue;
      nearest = dx * dx + dy * dy;
      at = c;
    }
    done = 0;
    return working = nearest != INT64_MAX;
  }
  void take_slot() {
    std::vector<bool> taken(slots);
    for (const auto& entry : held) taken[entry.second.slot] = true;
    slot = static_cast<size_t>(std::find(taken.begin(), taken.end(), false) - taken.begin());
    if (slot < slots) return;
    auto leaving = held.end();
    for (auto i = held.begin(); i != held.end(); ++i)
      if (!in(sight, i->first) && (leaving == held.end() || i->second.seen < leaving->second.seen ||
                                   (i->second.seen == leaving->second.seen && i->second.slot < leaving->second.slot)))
        leaving = i;
    REQUIRE(leaving != held.end());
    slot = leaving->second.slot;
    held.erase(leaving);
    ++counted.evicted;
  }
  void step(uint32_t rows) {
    while (rows > 0 && (working || choose())) {
      ++done;
      --rows;
      if (done == grow_rows) take_slot();
      if (done < rows_a_chunk) continue;
      held[at] = {now, slot};
      ++counted.grown;
      working = false;
    }
  }
};

}  // namespace

TEST_CASE("chunks: cells to chunks, both signs") {
  for (const uint16_t side : {8, 9, 64, 128, 1000, 65535})
    for (const int64_t middle :
         {INT64_C(0), INT64_C(1) << 30, -(INT64_C(1) << 30), int64_t{INT32_MAX}, int64_t{INT32_MIN}})
      for (int64_t cell = middle - 3 * side; cell <= middle + 3 * side; cell += side / 8) {
        if (cell < INT32_MIN || cell > INT32_MAX) continue;
        const int64_t chunk = dapple::chunk_at(static_cast<int32_t>(cell), side);
        CHECK((chunk * side <= cell && cell < (chunk + 1) * side));
      }
  CHECK(dapple::chunk_at(INT32_MIN, 8) == INT32_MIN / 8);
  static_assert(dapple::chunk_at(-1, 64) == -1 && dapple::chunk_at(-64, 64) == -1 && dapple::chunk_at(-65, 64) == -2,
                "floor");
}

TEST_CASE("chunks: slots a view can need") {
  for (const uint16_t side : {8, 13, 64})
    for (uint16_t width = 1; width < 150; ++width) {
      int32_t most = 0;
      for (int32_t x = -200; x < 200; ++x)
        most = std::max(most, dapple::chunk_at(x + width - 1, side) - dapple::chunk_at(x, side) + 1);
      CHECK(dapple::chunks_in_view(side, width, 1) == static_cast<uint32_t>(most));
      CHECK(dapple::chunks_in_view(side, 40, width) ==
            dapple::chunks_in_view(side, 40, 1) * static_cast<uint32_t>(most));
    }
}

TEST_CASE("chunks: every pixel format, any side, exactly its bytes") {
  const dapple::Recipe recipe = tests::recipe_of(kQuick);
  for (uint8_t format = 0; format <= static_cast<uint8_t>(Pixels::l16_swapped); ++format)
    for (const uint16_t side : {8, 17, 30}) {
      dapple::Brush brush;
      brush.format = static_cast<Pixels>(format);
      brush.dither = true;
      const size_t lines = brush.format == Pixels::l1_pages ? (side + 7u) / 8u : side;
      for (size_t shift = 0; shift < 4; ++shift) {
        World world(recipe, side, 6, brush, 2, shift);
        REQUIRE(world.status == dapple::ok);
        world.look_and_finish(-side, side, static_cast<uint16_t>(2 * side), side);
        for (const int32_t cx : {-1, 0}) {
          Grown chunk(recipe, window(cx * side, side, side, side), kSeed);
          std::vector<uint8_t> wanted(lines * world.chunks.line_bytes());
          for (uint16_t y = 0; y < side; ++y)
            chunk.texture.paint(
                y, brush, wanted.data() + (brush.format == Pixels::l1_pages ? y / 8u : y) * world.chunks.line_bytes());
          const uint8_t* const have = world.chunks.pixels(cx, 1);
          REQUIRE(have != nullptr);
          CHECK(std::equal(wanted.begin(), wanted.end(), have));
          CHECK(reinterpret_cast<uintptr_t>(have) % 4 == 0);
        }
        CHECK(world.chunks.counters().bytes == 2 * lines * world.chunks.line_bytes());
      }
    }
}

TEST_CASE("chunks: the cache does what its plain model does") {
  constexpr uint16_t kSide = 8;
  std::mt19937 random(99);
  const dapple::Recipe recipe = tests::recipe_of(kQuick);
  const dapple::Need need = dapple::need_for(recipe, window(0, 0, kSide, kSide));
  for (const Cell& home : {Cell(0, 0), Cell(kEdge - 300, -kEdge + 100), Cell(-kEdge + 90, 12345)})
    for (const uint16_t slots : {9, 16, 40}) {
      World world(recipe, kSide, slots, dapple::Brush{}, 1, random() % 4);
      Model model{kSide, slots, static_cast<uint32_t>(need.rows) + kSide, static_cast<uint32_t>(need.rows), {}, {}, {}};
      Cell at = home;
      for (int move = 0; move < 400; ++move) {
        at.first = std::clamp(at.first + static_cast<int32_t>(random() % 19) - 9, home.first - 60, home.first + 60);
        at.second = std::clamp(at.second + static_cast<int32_t>(random() % 19) - 9, home.second - 60, home.second + 60);
        const uint16_t width = static_cast<uint16_t>(1 + random() % 17),
                       height = static_cast<uint16_t>(1 + random() % 17);
        REQUIRE(world.chunks.look_at(at.first, at.second, width, height) == dapple::ok);
        model.look_at(at.first, at.second, width, height);
        for (uint32_t left = random() % 4; left > 0; --left) {
          const uint32_t rows = random() % (6 * model.rows_a_chunk);
          const bool all = world.chunks.step(rows) == dapple::done;
          model.step(rows);
          CHECK(all ==
                std::all_of(model.sight.begin(), model.sight.end(), [&](Cell c) { return model.held.count(c) != 0; }));
        }
        for (int32_t cy = dapple::chunk_at(home.second - 70, kSide); cy <= dapple::chunk_at(home.second + 90, kSide);
             ++cy)
          for (int32_t cx = dapple::chunk_at(home.first - 70, kSide); cx <= dapple::chunk_at(home.first + 90, kSide);
               ++cx)
            REQUIRE(world.has(cx, cy) == (model.held.count({cx, cy}) != 0));
        const dapple::ChunkCounters& c = world.chunks.counters();
        const dapple::ChunkCounters& m = model.counted;
        REQUIRE((c.grown == m.grown && c.hits == m.hits && c.misses == m.misses && c.evicted == m.evicted &&
                 c.abandoned == m.abandoned));
        REQUIRE(c.held == model.held.size());
      }
      CHECK((model.counted.evicted > 0 && model.counted.abandoned > 0 && model.counted.hits > 0));
      for (const auto& entry : model.held) {
        Grown chunk(recipe, window(entry.first.first * kSide, entry.first.second * kSide, kSide, kSide), kSeed);
        CHECK(chunk.pixels(dapple::Brush{}) == pixels_of(world.chunks, entry.first.first, entry.first.second));
      }
    }
}

TEST_CASE("chunks: the middle first, a row of work at a time") {
  const dapple::Recipe recipe = tests::recipe_of(kPlain);
  World world(recipe, 64, 9);
  const uint64_t rows = dapple::need_for(recipe, window(0, 0, 64, 64)).rows + 64;
  REQUIRE(world.chunks.look_at(-64, -64, 192, 192) == dapple::ok);
  const Cell order[] = {{0, 0}, {0, -1}, {-1, 0}, {1, 0}, {0, 1}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}};
  for (const Cell& next : order) {
    for (uint64_t row = 1; row < rows; ++row) REQUIRE(world.chunks.step(1) == dapple::more);
    CHECK(!world.has(next.first, next.second));
    CHECK(world.chunks.step(0) == dapple::more);
    CHECK((world.chunks.step(1) == dapple::done) == (next == order[8]));
    CHECK(world.has(next.first, next.second));
  }
  CHECK(world.chunks.step(0) == dapple::done);
  CHECK(world.chunks.missing() == 0);
}

TEST_CASE("chunks: the longest out of sight makes room; what goes out of sight while it grows is given up") {
  World world(tests::recipe_of(kQuick), 16, 3);
  const auto look = [&](int32_t cx) { world.look_and_finish(16 * cx, 0, 16, 16); };
  look(0), look(1), look(2), look(0), look(3);  // 1 was seen the longest ago
  CHECK((world.has(0, 0) && !world.has(1, 0) && world.has(2, 0) && world.has(3, 0)));
  world.look_and_finish(0, 0, 48, 16);  // 1 comes back for 3; all three in sight
  CHECK((world.has(0, 0) && world.has(1, 0) && world.has(2, 0) && !world.has(3, 0)));
  const dapple::ChunkCounters& c = world.chunks.counters();
  CHECK((c.grown == 5 && c.evicted == 2 && c.hits == 3 && c.misses == 5 && c.held == 3 && c.bytes == 3 * 16 * 16 * 4));
  REQUIRE(world.chunks.look_at(16 * 9, 0, 16, 16) == dapple::ok);
  CHECK(world.chunks.step(5) == dapple::more);
  look(1);
  CHECK((c.abandoned == 1 && c.evicted == 2 && world.has(0, 0) && world.has(2, 0) && !world.has(9, 0)));
  look(9);
  CHECK((world.has(9, 0) && c.grown == 6));
}

TEST_CASE("chunks: what is refused, and leaves all as it was") {
  const dapple::Recipe good = tests::recipe_of(kQuick);
  const dapple::Brush brush;
  std::vector<uint8_t> memory(100000);
  World world(good, 16, 4);
  world.look_and_finish(0, 0, 16, 16);
  const auto begin = [&](const dapple::Recipe& recipe, uint16_t side, uint16_t slots, size_t bytes, uint8_t bands = 1) {
    dapple::Options options;
    options.bands = bands;
    return world.chunks.begin(recipe, kSeed, side, slots, brush, memory.data(), bytes, options);
  };
  const size_t bytes = dapple::chunk_bytes(good, 16, 4, brush.format);
  CHECK(begin(good, 7, 4, 100000) == dapple::bad_side);
  CHECK(begin(good, 16, 0, 100000) == dapple::too_little_memory);
  CHECK(begin(good, 16, 4, bytes - 1) == dapple::too_little_memory);
  CHECK(world.chunks.begin(good, kSeed, 16, 4, brush, nullptr, bytes) == dapple::too_little_memory);
  CHECK(begin(good, 16, 4, 100000, 65) == dapple::bad_bands);
  CHECK(begin(good, 65000, 4, 100000) == dapple::too_large);
  const dapple::Recipe slow = tests::recipe_of("cells rule=1 steps=1024");
  CHECK(begin(slow, 16, 4, 100000) == dapple::halo_too_wide);
  CHECK(begin(dapple::Recipe{}, 16, 4, 100000) == dapple::bad_recipe);
  CHECK((dapple::chunk_bytes(good, 7, 4, brush.format) == 0 && dapple::chunk_bytes(good, 16, 0, brush.format) == 0));
  dapple::ChunkNeed need{};
  CHECK(world.chunks.begin(slow, kSeed, 16, 4, brush, memory.data(), 0, dapple::Options{}, &need) ==
        dapple::halo_too_wide);
  CHECK((need.halo == 1025 && need.bytes == 0));
  CHECK(world.chunks.look_at(0, 0, 0, 16) == dapple::bad_side);
  CHECK(world.chunks.look_at(0, 0, 65, 1) == dapple::too_little_memory);  // five chunks
  CHECK(world.chunks.look_at(0, 0, 1, 65) == dapple::too_little_memory);
  for (const int32_t far : {kEdge - 16, INT32_MAX, INT32_MIN, -kEdge - 1, dapple::kFarthest})
    CHECK((world.chunks.look_at(far, 0, 17, 16) == dapple::too_far &&
           world.chunks.look_at(0, far, 16, 17) == dapple::too_far));
  CHECK((world.has(0, 0) && world.chunks.counters().grown == 1 && world.chunks.sight().right == 0 &&
         world.chunks.step(1) == dapple::done));
  world.look_and_finish(kEdge - 32, -kEdge, 32, 32);
  CHECK(world.has(kEdge / 16 - 1, -kEdge / 16));
  REQUIRE(world.chunks.look_at(0, 0, 32, 32) == dapple::ok);
  CHECK(world.chunks.step(3) == dapple::more);
  CHECK(begin(good, 16, 4, bytes) == dapple::ok);  // nothing of before is left
  CHECK((!world.has(0, 0) && world.chunks.counters().held == 0 && world.chunks.missing() == 0));
  CHECK((world.chunks.step(9) == dapple::done && !world.chunks.sight().shows(0, 0)));
  world.look_and_finish(0, 0, 32, 32);
  CHECK((world.chunks.counters().grown == 4 && world.chunks.counters().misses == 4));
}

TEST_CASE("chunks: of a preset, in memory counted at compile time") {
  alignas(4) static uint8_t memory[dapple::chunk_bytes(dapple::presets::zebra_bits, 32, 6, Pixels::rgb565)];
  Chunks chunks;
  dapple::Brush brush;
  brush.format = Pixels::rgb565;
  REQUIRE(chunks.begin(dapple::presets::zebra_bits, kSeed, 32, 6, brush, memory, sizeof memory) == dapple::ok);
  REQUIRE(chunks.look_at(-40, 70, 20, 20) == dapple::ok);
  chunks.finish();
  Grown chunk(dapple::presets::zebra_bits.recipe, window(-64, 64, 32, 32), kSeed);
  CHECK(chunk.pixels(brush) == pixels_of(chunks, -2, 2));
}
