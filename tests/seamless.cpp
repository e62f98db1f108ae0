// Seamlessness, exactly: a tile grown from a rolled start is the rolled tile, bit for bit, field and pixels.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include "grow.hpp"

namespace {

void check_rolled(const dapple::Recipe& recipe, uint16_t width, uint16_t height, uint16_t dx, uint16_t dy) {
  tests::Grown plain(recipe, dapple::torus(width, height), 5);
  tests::Grown rolled(recipe, dapple::torus(width, height, dx, dy), 5);
  REQUIRE(plain.status == dapple::ok);
  REQUIRE(rolled.status == dapple::ok);
  const std::vector<int16_t> a = plain.field(), b = rolled.field();
  dapple::Brush brush;
  brush.format = dapple::Pixels::rgb888;
  const std::vector<uint8_t> p = plain.pixels(brush), q = rolled.pixels(brush);
  const bool grainless = recipe.paint.grain == 0;  // grain is laid on the picture, not grown
  size_t field_wrong = 0, pixels_wrong = 0;
  for (uint16_t y = 0; y < height; ++y)
    for (uint16_t x = 0; x < width; ++x) {
      const size_t here = static_cast<size_t>(y) * width + x;
      const size_t there = static_cast<size_t>((y + dy) % height) * width + (x + dx) % width;
      field_wrong += b[here] != a[there];
      for (size_t c = 0; c < 3; ++c) pixels_wrong += grainless && q[3 * here + c] != p[3 * there + c];
    }
  CHECK(field_wrong == 0);
  CHECK(pixels_wrong == 0);
}

}  // namespace

TEST_CASE("seamless: rolled start, rolled tile, for every preset") {
  for (uint16_t i = 0; i < dapple::preset_count(); ++i) {
    char name[dapple::kMaxName];
    const dapple::PresetEntry entry = dapple::preset_at(i, name);
    CAPTURE(name);
    dapple::Recipe recipe = dapple::load(*entry.preset);
    if (recipe.stage[0].steps > 300) recipe.stage[0].steps = 300;
    const uint16_t step = dapple::need_for(recipe, dapple::torus(96, 80)).multiple;
    check_rolled(recipe, 96, 80, static_cast<uint16_t>(37 / step * step), static_cast<uint16_t>(51 / step * step));
  }
}

TEST_CASE("seamless: coarse to fine, by shifts the coarsest grid knows") {
  for (const char* changes : {"levels=2", "levels=3 fine=5"}) {
    CAPTURE(changes);
    check_rolled(tests::preset_with("zebra", changes), 96, 80, 12, 44);
    check_rolled(tests::preset_with("giraffe", changes), 104, 96, 52, 8);
  }
}

TEST_CASE("seamless: the explicit solver") { check_rolled(tests::preset_with("weave", "solver=euler steps=6"), 70, 63, 11, 62); }

TEST_CASE("seamless: a rolled tile differs from the plain one") {
  tests::Grown plain(tests::preset_with("zebra", "steps=4"), dapple::torus(64, 64), 5);
  tests::Grown rolled(tests::preset_with("zebra", "steps=4"), dapple::torus(64, 64, 1, 0), 5);
  CHECK(plain.field() != rolled.field());
}
