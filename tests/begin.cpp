// What begin checks, what it reports, and that a refusal leaves everything as it was.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstring>

#include "grow.hpp"

using dapple::Need;
using dapple::Recipe;
using dapple::Status;
using dapple::Texture;
using dapple::torus;

namespace {

Status try_begin(const Recipe& recipe, dapple::Domain domain, Need* need = nullptr, uint8_t bands = 1, size_t bytes = 4000000) {
  static std::vector<uint8_t> memory(4000000);
  Texture texture;
  dapple::Options options;
  options.bands = bands;
  return texture.begin(recipe, domain, 1, memory.data(), bytes, options, need);
}

// Compile time, as firmware uses it.
constexpr size_t kZebraBytes = dapple::bytes_for(dapple::presets::zebra, torus(64, 64));
static_assert(kZebraBytes > 4 * 64 * 64 && kZebraBytes < 4 * 64 * 64 + 3000, "a one-pair tile: 4 bytes a cell and a few rows");
static_assert(dapple::bytes_for(dapple::presets::zebra, torus(16, 64)) == 0, "a refused tile needs nothing");

}  // namespace

TEST_CASE("begin: sizes") {
  const Recipe zebra = dapple::load(dapple::presets::zebra);
  Need need{};
  CHECK(try_begin(zebra, torus(7, 64), &need) == dapple::bad_side);
  CHECK(try_begin(zebra, torus(0, 0), &need) == dapple::bad_side);
  CHECK(try_begin(zebra, torus(32, 64), &need) == dapple::tile_too_small);
  CHECK(need.width == 34);
  CHECK(need.bytes == 0);
  CHECK(try_begin(zebra, torus(34, 34), &need) == dapple::ok);
  const Recipe giraffe = dapple::load(dapple::presets::giraffe);
  CHECK(try_begin(giraffe, torus(76, 64), &need) == dapple::tile_too_small);
  CHECK(need.width == 77);
  CHECK(try_begin(giraffe, torus(77, 47), &need) == dapple::ok);
  const Recipe levels = tests::preset_with("zebra", "levels=3");
  CHECK(try_begin(levels, torus(64, 66), &need) == dapple::not_a_multiple);
  CHECK(need.multiple == 4);
  CHECK(try_begin(levels, torus(64, 68), &need) == dapple::ok);
}

TEST_CASE("begin: a torus rolls by what its coarsest grid knows, and by any number of turns") {
  const Recipe bits = dapple::load(dapple::presets::zebra_bits);
  CHECK(try_begin(bits, torus(96, 80, 1, 0)) == dapple::not_a_multiple);
  CHECK(try_begin(bits, torus(96, 80, 0, -3)) == dapple::not_a_multiple);
  tests::Grown near(bits, torus(96, 80, 2, 78), 3), far(bits, torus(96, 80, 2 + 96 * 20000000, 78 - 80 * 20000000), 3);
  REQUIRE(near.status == dapple::ok);
  REQUIRE(far.status == dapple::ok);
  CHECK(near.field_hash() == far.field_hash());
}

TEST_CASE("begin: memory and bands") {
  const Recipe zebra = dapple::load(dapple::presets::zebra);
  Need need{};
  CHECK(try_begin(zebra, torus(64, 64), &need, 1, 100) == dapple::too_little_memory);
  const size_t wanted = need.bytes;
  CHECK(wanted == kZebraBytes);
  CHECK(try_begin(zebra, torus(64, 64), &need, 1, wanted - 1) == dapple::too_little_memory);
  CHECK(try_begin(zebra, torus(64, 64), &need, 1, wanted) == dapple::ok);
  CHECK(try_begin(zebra, torus(64, 64), &need, 0) == dapple::bad_bands);
  CHECK(try_begin(zebra, torus(64, 64), &need, 65) == dapple::bad_bands);
  CHECK(try_begin(zebra, torus(64, 64), &need, 64) == dapple::ok);
  Texture texture;
  CHECK(texture.begin(zebra, torus(64, 64), 1, nullptr, wanted) == dapple::too_little_memory);
}

TEST_CASE("begin: recipes made by hand") {
  const Recipe zebra = dapple::load(dapple::presets::zebra);
  const auto refused = [&](auto change) {
    Recipe r = zebra;
    change(r);
    return try_begin(r, torus(128, 128)) == dapple::bad_recipe;
  };
  CHECK(refused([](Recipe& r) { r.stages = 0; }));
  CHECK(refused([](Recipe& r) { r.stages = 9; }));
  CHECK(refused([](Recipe& r) { r.stage[0].model = nullptr; }));
  CHECK(refused([](Recipe& r) { r.stage[0].solver = nullptr; }));
  CHECK(refused([](Recipe& r) { r.stage[0].level = 1; }));
  CHECK(refused([](Recipe& r) { r.stage[0].entry = dapple::Entry::carry; }));
  CHECK(refused([](Recipe& r) { r.stage[0].number[dapple::threshold::pairs] = 6; }));
  CHECK(refused([](Recipe& r) { r.stage[0].number[dapple::threshold::scale] = 900000000; }));
  CHECK(refused([](Recipe& r) { r.stage[0].number[dapple::threshold::k] = -1; }));
  CHECK(refused([](Recipe& r) { r.stage[0].number[dapple::threshold::rho + 2] = 2; r.stage[0].number[dapple::threshold::rho + 3] = 1; }));
  CHECK(refused([](Recipe& r) { r.paint.ramp.count = 0; }));
  CHECK(refused([](Recipe& r) { r.paint.ramp.count = 9; }));
  CHECK(refused([](Recipe& r) { r.paint.high = r.paint.low; }));
  CHECK(refused([](Recipe& r) { r.start.kind = dapple::Start::seeds; r.start.radius = 0; }));
  CHECK(refused([](Recipe& r) { r.stages = 2; r.stage[1] = r.stage[0]; }));
  CHECK(refused([](Recipe& r) { r.stages = 2; r.stage[1] = r.stage[0]; r.stage[1].entry = dapple::Entry::refine; }));
  CHECK_FALSE(refused([](Recipe& r) { r.stages = 2; r.stage[1] = r.stage[0]; r.stage[1].entry = dapple::Entry::carry; }));
}

TEST_CASE("begin: a failure leaves the texture as it was") {
  const Recipe zebra = dapple::load(dapple::presets::zebra);
  tests::Grown tile(zebra, torus(64, 64), 9);
  const uint64_t before = tile.field_hash();
  unsigned char bytes[sizeof(Texture)];
  std::memcpy(bytes, &tile.texture, sizeof bytes);
  CHECK(tile.texture.begin(zebra, torus(64, 64), 9, tile.memory.data(), 10) == dapple::too_little_memory);
  CHECK(std::memcmp(bytes, &tile.texture, sizeof bytes) == 0);
  CHECK(tile.field_hash() == before);
}

TEST_CASE("begin: memory at any address") {
  const Recipe sand = tests::preset_with("sand", "steps=5");
  const size_t bytes = dapple::bytes_for(sand, torus(50, 41));
  uint64_t first = 0;
  for (size_t shift = 0; shift < 4; ++shift) {
    std::vector<uint8_t> memory(bytes + shift);
    Texture texture;
    REQUIRE(texture.begin(sand, torus(50, 41), 2, memory.data() + shift, bytes) == dapple::ok);
    texture.finish();
    tests::Fnv fnv;
    std::vector<int16_t> row(50);
    for (uint16_t y = 0; y < 41; ++y) {
      texture.row(y, row.data());
      for (const int16_t v : row) fnv.number(v);
    }
    if (shift == 0) first = fnv.value;
    CHECK(fnv.value == first);
  }
}

TEST_CASE("begin: bytes are the formula of README") {
  // planes w h 2; scratch 4 rows with halo for the passes, 2 for the chained ones, 2 work rows; paint 3 + 2 rows.
  const Need need = dapple::need_for(dapple::presets::zebra, torus(256, 256));
  CHECK(need.planes == 2 * 256 * 256 * 2);
  CHECK(need.bytes == need.planes + need.scratch + need.paint + need.rest);
  const size_t halo = dapple::grid::halo_bytes(dapple::grid::Cell::int16, need.reach);
  CHECK(need.scratch <= 6 * (256 * 2 + 2 * halo) + 2 * 256 * 2);
  CHECK(need.paint == 3 * (256 * 2 + 8) + 2 * 256 * 2);
}

TEST_CASE("texture: progress, steps and rows in all") {
  for (const char* name : {"zebra", "weave", "mitosis"}) {
    CAPTURE(name);
    Recipe recipe = tests::preset(name);
    if (recipe.stage[0].steps > 50) recipe.stage[0].steps = 50;
    tests::Grown tile(recipe, torus(96, 72), 4);
    CHECK(tile.texture.rows_done() == tile.texture.rows_in_all());
    CHECK(tile.texture.steps_done() == recipe.stage[0].steps);
  }
  tests::Grown levels(tests::preset_with("zebra", "levels=2"), torus(96, 72), 4);
  CHECK(levels.texture.rows_done() == levels.texture.rows_in_all());
}
