// What the tests of chunks share: a cache with its memory, guarded.
// SPDX-License-Identifier: MIT
#pragma once
#include <doctest/doctest.h>

#include <algorithm>
#include <utility>

#include "chunks.hpp"
#include "grow.hpp"

namespace tests {

constexpr uint32_t kSeed = 5;
constexpr int32_t kEdge = dapple::kFarthest - 2 * dapple::kWidestHalo;  // chunks end here at the latest

using Cell = std::pair<int32_t, int32_t>;

// A cache in a block of exactly its bytes, guarded on both sides, `shift` bytes off alignment.
struct World {
  static constexpr size_t kGuard = 16;
  dapple::Recipe recipe;
  std::vector<uint8_t> block;
  dapple::Chunks chunks;
  dapple::Status status;

  World(const dapple::Recipe& r, uint16_t side, uint16_t slots, const dapple::Brush& brush = dapple::Brush{},
        uint8_t bands = 1, size_t shift = 0)
      : recipe(r) {
    const size_t bytes = dapple::chunk_bytes(recipe, side, slots, brush.format, bands);
    block.assign(2 * kGuard + bytes + shift, 0xa5);
    dapple::Options options;
    options.bands = bands;
    status = chunks.begin(recipe, kSeed, side, slots, brush, block.data() + kGuard + shift, bytes, options);
  }
  World(const World&) = delete;
  ~World() {
    const auto untouched = [](uint8_t byte) { return byte == 0xa5; };
    CHECK(std::all_of(block.begin(), block.begin() + kGuard, untouched));
    CHECK(std::all_of(block.end() - kGuard, block.end(), untouched));
  }
  void look_and_finish(int32_t x, int32_t y, uint16_t width, uint16_t height) {
    REQUIRE(chunks.look_at(x, y, width, height) == dapple::ok);
    chunks.finish();
  }
  bool has(int32_t cx, int32_t cy) const { return chunks.pixels(cx, cy) != nullptr; }
};

inline std::vector<uint8_t> pixels_of(const dapple::Chunks& chunks, int32_t cx, int32_t cy) {
  const uint8_t* const from = chunks.pixels(cx, cy);
  return from == nullptr ? std::vector<uint8_t>()
                         : std::vector<uint8_t>(from, from + chunks.line_bytes() * chunks.side());
}

}  // namespace tests
