// The maps of a material: all from one call, what their values mean, sixteen bits of height, and levels that tile.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "grow.hpp"

using dapple::Brush;
using dapple::Mip;
using dapple::Pixels;
using dapple::View;
using Bytes = std::vector<uint8_t>;

namespace {

constexpr Brush kMaps[] = {{View::height, Pixels::l16},
                           {View::normal, Pixels::rgb888},
                           {View::colour, Pixels::rgb888, false, false, true},
                           {View::opacity, Pixels::l8},
                           {View::roughness, Pixels::l8}};

struct Level {
  Mip mip;
  Bytes pixels;

  size_t line() const { return dapple::pixel_bytes(mip.format, mip.width); }
  size_t channels() const { return mip.format == Pixels::l16 ? 1 : line() / mip.width; }
  int at(int x, int y, size_t channel = 0) const {
    const size_t row = static_cast<size_t>(y) * line();
    if (mip.format == Pixels::l16) return pixels[row + 2u * x] | pixels[row + 2u * x + 1] << 8;
    return pixels[row + static_cast<size_t>(x) * channels() + channel];
  }
};

Level below(const Level& from) {
  Level to = {mip_below(from.mip), {}};
  to.pixels.resize(to.line() * to.mip.height);
  for (uint16_t y = 0; y < to.mip.height; ++y) {
    const uint8_t* rows[3] = {};
    for (uint8_t k = 0; k < dapple::mip_rows(from.mip.height); ++k) rows[k] = &from.pixels[(2u * y + k) * from.line()];
    dapple::mip_row(from.mip, rows, y, &to.pixels[y * to.line()]);
  }
  return to;
}

std::vector<Level> maps_of(tests::Grown& tile) {
  const dapple::Domain d = tile.texture.domain();
  std::vector<Level> all;
  for (const Brush& brush : kMaps) {
    all.push_back({{brush.format, brush.view == View::normal, d.width, d.height}, {}});
    all.back().pixels.resize(all.back().line() * d.height);
  }
  for (uint16_t y = 0; y < d.height; ++y) {
    dapple::Layer layers[5];
    for (size_t i = 0; i < 5; ++i) layers[i] = {kMaps[i], &all[i].pixels[y * all[i].line()]};
    tile.texture.paint(y, layers, 5);
  }
  return all;
}

// How much pixels differ from those to the right of them (or below), on average, by place along the torus.
std::vector<double> steps_along(const Level& l, bool down) {
  const int along = down ? l.mip.height : l.mip.width, across = down ? l.mip.width : l.mip.height;
  std::vector<double> mean(static_cast<size_t>(along), 0.0);
  for (int i = 0; i < along; ++i)
    for (int k = 0; k < across; ++k)
      for (size_t c = 0; c < l.channels(); ++c) {
        const int next = (i + 1) % along;
        mean[static_cast<size_t>(i)] += std::abs(down ? l.at(k, i, c) - l.at(k, next, c) : l.at(i, k, c) - l.at(next, k, c));
      }
  return mean;
}

// The step from the last pixel to the first is like those inside: no larger than the largest of them and a third more.
bool has_seam(const Level& l) {
  for (const bool down : {false, true}) {
    const std::vector<double> steps = steps_along(l, down);
    if (steps.back() > *std::max_element(steps.begin(), steps.end() - 1) * 4 / 3) return true;
  }
  return false;
}

// The mean over the part of the torus that pixel (x, y) of the next level covers, from areas.
double covered(const Level& from, int x, int y, size_t channel) {
  const Mip to = mip_below(from.mip);
  const auto overlap = [](int pixel, int of, int side, int half) {
    const double wide = double(side) / half;
    return std::max(0.0, std::min(pixel + 1.0, (of + 1) * wide) - std::max(double(pixel), of * wide)) / wide;
  };
  double sum = 0;
  for (int v = 0; v < from.mip.height; ++v)
    for (int u = 0; u < from.mip.width; ++u)
      sum += from.at(u, v, channel) * overlap(u, x, from.mip.width, to.width) * overlap(v, y, from.mip.height, to.height);
  return sum;
}

Level noise(Mip mip, uint32_t seed) {
  Level level = {mip, {}};
  level.pixels.resize(level.line() * mip.height);
  for (uint8_t& byte : level.pixels) byte = static_cast<uint8_t>((seed = seed * 1664525 + 1013904223) >> 24);
  return level;
}

}  // namespace

TEST_CASE("maps: one call paints what single calls paint") {
  for (const char* name : {"weave", "zebra-bits", "gs-spots"}) {
    CAPTURE(name);
    tests::Grown tile(tests::preset_with(name, "steps=6"), dapple::torus(64, 64), 9);
    const std::vector<Level> maps = maps_of(tile);
    for (size_t i = 0; i < 5; ++i) CHECK(maps[i].pixels == tile.pixels(kMaps[i]));
  }
}

TEST_CASE("maps: opacity and roughness go from the value of low to the value of high") {
  const dapple::Recipe recipe = tests::preset_with("zebra", "steps=12 range=-0.05,0.07 opacity=1,0.2 roughness=0.1,0.9");
  tests::Grown tile(recipe, dapple::torus(64, 48), 3);
  const std::vector<int16_t> field = tile.field();
  const std::vector<Level> maps = maps_of(tile);
  const Bytes deep = tile.pixels({View::opacity, Pixels::l16});
  for (size_t i = 0; i < field.size(); ++i) {
    const double t = std::min(1.0, std::max(0.0, (field[i] + 400) / 960.0));  // -0.05 and 0.12 of 8000
    REQUIRE(std::abs(maps[3].pixels[i] - (255 - t * 204)) <= 1.0);
    REQUIRE(std::abs(maps[4].pixels[i] - (26 + t * (230 - 26))) <= 1.0);
    REQUIRE(std::abs((deep[2 * i] | deep[2 * i + 1] << 8) - 257 * (255 - t * 204)) <= 1.0);
  }
  CHECK(*std::min_element(maps[3].pixels.begin(), maps[3].pixels.end()) == 51);
  CHECK(*std::max_element(maps[4].pixels.begin(), maps[4].pixels.end()) == 230);
}

TEST_CASE("maps: height has sixteen bits, the eight of the view and more") {
  for (const char* name : {"reptile", "mitosis"}) {  // units 8000 and 16383
    CAPTURE(name);
    tests::Grown tile(tests::preset_with(name, "steps=20"), dapple::torus(96, 80), 3);
    const Bytes little = tile.pixels({View::height, Pixels::l16}), big = tile.pixels({View::height, Pixels::l16_swapped});
    const Bytes eight = tile.pixels({View::height, Pixels::l8});
    const std::vector<int16_t> field = tile.field();
    const double unit = tile.texture.unit() / 1e6, low = tile.recipe.paint.low * unit, high = tile.recipe.paint.high * unit;
    std::vector<bool> seen(65536, false);
    for (size_t i = 0; i < eight.size(); ++i) {
      const int value = little[2 * i] | little[2 * i + 1] << 8;
      REQUIRE((big[2 * i] << 8 | big[2 * i + 1]) == value);
      REQUIRE(std::abs(value / 257.0 - eight[i]) <= 1.0);
      const double t = (field[i] - (low + high) / 2) / (high - low) / 2 + 0.5;
      REQUIRE(std::abs(value - 65535 * std::min(1.0, std::max(0.0, t))) <= 40);  // low and high are whole units of the field
      seen[static_cast<size_t>(value)] = true;
    }
    CHECK(std::count(seen.begin(), seen.end(), true) > 256);
  }
}

TEST_CASE("maps: the ends of a range of any width, sixteen bits") {
  for (const int32_t unit : {8000, 16383})
    for (const int32_t micro : {1, 333, 1000000, 2000000})
      for (const View view : {View::field, View::height}) {
        dapple::Paint paint{};
        paint.ramp.count = 1;
        paint.low = -micro;
        paint.high = micro;
        const Brush brush = {view, Pixels::l16};
        const auto shader = dapple::paint::shader_of(paint, brush, static_cast<int16_t>(unit), 0, 1);
        const int16_t row[3] = {-32768, static_cast<int16_t>(shader.low + shader.span / 2), 32767};
        const dapple::paint::Source source = {row, row, row, 3, 0, 0, 0};
        uint8_t out[6];
        dapple::paint::paint_row(shader, brush, source, out);
        const auto expected = [&](int32_t value) {
          const double t = (double(value) - shader.low) / shader.span;
          return std::floor(65535 * std::min(1.0, std::max(0.0, t)) + 0.5);
        };
        for (int i = 0; i < 3; ++i) CHECK(std::abs((out[2 * i] | out[2 * i + 1] << 8) - expected(row[i])) <= 1);
      }
}

TEST_CASE("maps: colour without light is the ramp alone, and grain") {
  tests::Grown tile(tests::preset_with("coral", "steps=12"), dapple::torus(48, 48), 3);
  dapple::Paint flat = tile.recipe.paint;
  flat.light = 0;
  const Brush lit = {View::colour, Pixels::rgb888}, unlit = {View::colour, Pixels::rgb888, false, false, true};
  const Bytes bare = tile.pixels(unlit);
  CHECK(bare != tile.pixels(lit));
  tile.texture.repaint(&flat);
  CHECK(bare == tile.pixels(lit));
}

TEST_CASE("mips: a pixel is the mean of what it covers, whatever the sides, every pixel counting the same") {
  const tests::Size sizes[] = {{8, 6}, {7, 9}, {2, 2}, {1, 5}, {3, 1}, {5, 8}, {13, 3}};
  for (const Pixels format : {Pixels::l8, Pixels::rgb888, Pixels::rgba8888, Pixels::l16})
    for (const tests::Size size : sizes) {
      const Level from = noise({format, false, size.width, size.height}, size.width * 31u + size.height);
      const Level to = below(from);
      for (int y = 0; y < to.mip.height; ++y)
        for (int x = 0; x < to.mip.width; ++x)
          for (size_t c = 0; c < to.channels(); ++c) REQUIRE(std::abs(to.at(x, y, c) - covered(from, x, y, c)) <= 0.5000001);
    }
  const Level wide = noise({Pixels::l16, false, 65535, 1}, 7);
  const Level half = below(wide);
  for (const int x : {0, 1, 16383, 32766}) {
    const int m = 32767, a = wide.at(2 * x, 0), b = wide.at(2 * x + 1, 0), c = wide.at(2 * x + 2, 0);
    CHECK(std::abs(half.at(x, 0) - (double(m - x) * a + double(m) * b + (x + 1.0) * c) / 65535) <= 0.5000001);
  }
}

TEST_CASE("mips: big-endian heights are the little-endian ones with their bytes swapped") {
  Level little = noise({Pixels::l16, false, 9, 6}, 3), big = little;
  big.mip.format = Pixels::l16_swapped;
  for (size_t i = 0; i < big.pixels.size(); i += 2) std::swap(big.pixels[i], big.pixels[i + 1]);
  little = below(little);
  big = below(big);
  for (size_t i = 0; i < big.pixels.size(); i += 2) std::swap(big.pixels[i], big.pixels[i + 1]);
  CHECK(big.pixels == little.pixels);
}

TEST_CASE("mips: normals are unit vectors on every level, along the mean of those above") {
  tests::Grown tile(tests::preset_with("coral", "steps=20"), dapple::torus(97, 64), 3);
  Level level = maps_of(tile)[1];
  for (int k = 0; k < 6; ++k) {
    const Level next = below(level);
    for (int y = 0; y < next.mip.height; ++y)
      for (int x = 0; x < next.mip.width; ++x) {
        double n[3], mean[3], length = 0, square = 0;
        for (size_t c = 0; c < 3; ++c) {
          n[c] = next.at(x, y, c) - 128.0;
          mean[c] = covered(level, x, y, c) - 128;
          length += mean[c] * mean[c];
          square += n[c] * n[c];
        }
        REQUIRE(std::abs(std::sqrt(square) - 127) <= 1);
        for (size_t c = 0; c < 3; ++c) REQUIRE(std::abs(n[c] - 127 * mean[c] / std::sqrt(length)) <= 1);
      }
    level = next;
  }
  const Bytes against = {255, 128, 128, 1, 128, 128};
  const uint8_t* const rows[] = {against.data()};
  uint8_t out[3];
  dapple::mip_row({Pixels::rgb888, true, 2, 1}, rows, 0, out);
  CHECK((out[0] == 128 && out[1] == 128 && out[2] == 255));
}

TEST_CASE("mips: a rolled map has rolled levels, bit for bit") {
  constexpr uint16_t kSide = 64, kRoll = 24;
  tests::Grown plain(tests::preset_with("weave", "steps=8"), dapple::torus(kSide, kSide), 5);
  tests::Grown rolled(tests::preset_with("weave", "steps=8"), dapple::torus(kSide, kSide, kRoll, kRoll), 5);
  std::vector<Level> a = maps_of(plain), b = maps_of(rolled);
  for (size_t i = 0; i < a.size(); ++i)
    for (int k = 0; k <= 3; ++k) {
      const int side = kSide >> k, roll = kRoll >> k;
      size_t wrong = 0;
      for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
          for (size_t c = 0; c < a[i].channels(); ++c)
            wrong += b[i].at(x, y, c) != a[i].at((x + roll) % side, (y + roll) % side, c);
      CHECK(wrong == 0);
      a[i] = below(a[i]);
      b[i] = below(b[i]);
    }
}

TEST_CASE("mips: every map and every level of it tiles, odd sides too") {
  for (const char* name : {"zebra", "reptile", "coral", "weave-bits", "mitosis"})
    for (const tests::Size size : {tests::Size{97, 113}, tests::Size{128, 96}}) {
      const dapple::Recipe recipe = tests::preset_with(name, "");
      const tests::Size fit = tests::fitting(size, recipe);
      tests::Grown tile(recipe, dapple::torus(fit.width, fit.height), 3);
      CAPTURE(name);
      for (Level& level : maps_of(tile))
        for (int k = 0; std::min(level.mip.width, level.mip.height) >= 12; ++k, level = below(level)) {
          CAPTURE(k);
          CHECK(!has_seam(level));
        }
    }
  tests::Grown window(tests::preset_with("zebra-bits", ""), dapple::window(0, 0, 112, 96), 3);
  int seams = 0;
  for (Level& level : maps_of(window)) seams += has_seam(level);
  CHECK(seams == 5);  // part of the plane does not tile: the measure sees it
}

TEST_CASE("mips: levels down to one pixel") {
  CHECK(dapple::mip_levels(1, 1) == 0);
  CHECK(dapple::mip_levels(256, 256) == 8);
  CHECK(dapple::mip_levels(200, 150) == 7);
  CHECK(dapple::mip_levels(65535, 8) == 15);
  Mip mip = {Pixels::l8, false, 65535, 8};
  for (int k = 0; k < 15; ++k) mip = mip_below(mip);
  CHECK((mip.width == 1 && mip.height == 1));
}
