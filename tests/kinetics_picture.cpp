// Growth from a picture: recognisable, seamless, the same bits however grown.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "grow.hpp"

using tests::Grown;
using tests::recipe_of;

namespace {

constexpr int kSide = 96;

// A photograph's kind of grey: a slope that tiles, and discs, dark and light.
std::vector<uint8_t> photograph() {
  struct Disc {
    int x, y, r;
    double grey;
  };
  const Disc discs[] = {{24, 28, 16, 245}, {68, 64, 21, 20}, {70, 22, 11, 0}, {28, 72, 14, 225}};
  std::vector<uint8_t> cells;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      double grey = 110 + 70 * std::sin(2 * M_PI * x / kSide);
      for (const Disc& d : discs) {
        const int dx = std::abs(x - d.x), dy = std::abs(y - d.y);
        const int wx = std::min(dx, kSide - dx), wy = std::min(dy, kSide - dy);
        if (wx * wx + wy * wy < d.r * d.r) grey = d.grey;
      }
      cells.push_back(static_cast<uint8_t>(grey));
    }
  return cells;
}

std::vector<double> smoothed(const std::vector<int16_t>& f, int side, int radius) {
  std::vector<double> across(f.size()), all(f.size());
  const auto at = [side](int x, int y) { return static_cast<size_t>((y + side) % side * side + (x + side) % side); };
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      for (int k = -radius; k <= radius; ++k) across[at(x, y)] += f[at(x + k, y)];
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      for (int k = -radius; k <= radius; ++k) all[at(x, y)] += across[at(x, y + k)];
  return all;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  double sa = 0, sb = 0, aa = 0, bb = 0, ab = 0;
  const double n = static_cast<double>(a.size());
  for (size_t i = 0; i < a.size(); ++i) sa += a[i] / n, sb += b[i] / n;
  for (size_t i = 0; i < a.size(); ++i) {
    aa += (a[i] - sa) * (a[i] - sa);
    bb += (b[i] - sb) * (b[i] - sb);
    ab += (a[i] - sa) * (b[i] - sb);
  }
  return ab / std::sqrt(aa * bb);
}

std::vector<int16_t> grown(const char* text, const dapple::PlaceMaps& maps, dapple::Domain domain,
                           uint32_t budget = UINT32_MAX, uint8_t bands = 1) {
  dapple::Recipe recipe = recipe_of(text);
  dapple::set_maps(recipe, maps);
  dapple::Options options;
  options.bands = bands;
  Grown grown(recipe, domain, 5, budget, options);
  REQUIRE_MESSAGE(grown.status == dapple::ok, text);
  return grown.field();
}

dapple::PlaceMaps maps_of(const std::vector<uint8_t>& cells, uint16_t width, uint16_t height) {
  dapple::PlaceMaps maps{};
  maps.grey = {cells.data(), width, height};
  return maps;
}

}  // namespace

TEST_CASE("a picture is recognised in what has grown from it") {
  const std::vector<uint8_t> picture = photograph();
  const dapple::PlaceMaps maps = maps_of(picture, kSide, kSide);
  const uint16_t side = 288;
  for (const char* text :
       {"turing solver=pictured show=b decay=12 scale=4.47 steps=2000",
        "turing solver=pictured show=b decay=20 growth=25 dark=23.8 lit=28.5 scale=4.47 steps=2000"}) {
    const std::vector<int16_t> field = grown(text, maps, dapple::torus(side, side));
    std::vector<double> grey;
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) grey.push_back(picture[static_cast<size_t>(y / 3 * kSide + x / 3)]);
    const double same = correlation(smoothed(field, side, 9), grey);
    INFO(text << ": " << same);
    CHECK(same >= 0.8);
  }
}

TEST_CASE("growth from a picture: the same bits however the run is sliced, in bands, and over grids") {
  const std::vector<uint8_t> picture = photograph();
  const dapple::PlaceMaps maps = maps_of(picture, kSide, kSide);
  const char* text = "turing solver=pictured scale=9 vary=0.1 level=1 steps=9 then refine steps=5 then carry steps=4";
  const dapple::Domain domain = dapple::torus(74, 50);
  const std::vector<int16_t> whole = grown(text, maps, domain);
  for (const uint32_t budget : {1u, 7u, 1000u}) CHECK(grown(text, maps, domain, budget) == whole);
  for (const uint8_t bands : {uint8_t{2}, uint8_t{3}, uint8_t{9}}) CHECK(grown(text, maps, domain, 13, bands) == whole);
  const std::vector<uint8_t> other(kSide * kSide, 128);
  CHECK(grown(text, maps_of(other, kSide, kSide), domain) != whole);
}

TEST_CASE("growth from a picture: two windows of the plane agree") {
  const std::vector<uint8_t> picture = photograph();
  const dapple::PlaceMaps maps = maps_of(picture, kSide, kSide);
  const char* text = "turing solver=pictured scale=6 vary=0.1 steps=9";
  const std::vector<int16_t> a = grown(text, maps, dapple::window(-30, -25, 60, 50)),
                             b = grown(text, maps, dapple::window(-10, -9, 60, 50));
  int differ = 0;
  for (size_t y = 0; y < 34; ++y)
    for (size_t x = 0; x < 40; ++x) differ += a[(y + 16) * 60 + x + 20] != b[y * 60 + x];
  CHECK(differ == 0);
}

TEST_CASE("growth from a picture: black is `dark`, white is `lit`, whatever its size") {
  const dapple::Domain domain = dapple::torus(64, 48);
  for (const uint16_t side : {uint16_t{1}, uint16_t{7}, uint16_t{256}}) {
    const size_t cells = size_t{side} * side;
    const std::vector<uint8_t> black(cells, 0), white(cells, 255);
    const char* text = "turing solver=pictured growth=15.25 dark=15.25 lit=15.25 steps=40";
    const std::vector<int16_t> plain = grown("turing growth=15.25 steps=40", dapple::PlaceMaps{}, domain);
    CHECK(grown(text, maps_of(black, side, side), domain) == plain);
    text = "turing solver=pictured growth=15.25 dark=15.25 lit=20 steps=40";
    CHECK(grown(text, maps_of(black, side, side), domain) == plain);
    CHECK(grown(text, maps_of(white, side, side), domain) != plain);
    text = "turing solver=pictured growth=15.25 dark=20 lit=15.25 steps=40";
    CHECK(grown(text, maps_of(white, side, side), domain) == plain);
  }
}

TEST_CASE("growth from a picture: begin refuses what is no picture") {
  const std::vector<uint8_t> cells(257 * 4, 9);
  dapple::Recipe recipe = recipe_of("turing solver=pictured");
  CHECK(dapple::need_for(recipe, dapple::torus(64, 64)).status == dapple::bad_map);
  const auto status = [&](const dapple::PlaceMaps& maps) {
    dapple::set_maps(recipe, maps);
    return dapple::need_for(recipe, dapple::torus(64, 64)).status;
  };
  CHECK(status(dapple::PlaceMaps{}) == dapple::bad_map);
  CHECK(status(maps_of(cells, 257, 4)) == dapple::bad_map);
  CHECK(status(maps_of(cells, 0, 4)) == dapple::bad_map);
  CHECK(status(maps_of(cells, 256, 4)) == dapple::ok);
}
