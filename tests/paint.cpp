// Paint: pixel formats in memory order, dither, views, fixed ranges, ramps, normals.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>

#include "base/math.hpp"
#include "grow.hpp"

using dapple::Brush;
using dapple::Pixels;
using dapple::View;

namespace {

// Packs one row of given colours at row y.
std::vector<uint8_t> packed(const std::vector<uint8_t>& rgb, Pixels format, uint16_t y, bool dither, uint8_t fill = 0) {
  Brush brush;
  brush.format = format;
  brush.dither = dither;
  const uint16_t width = static_cast<uint16_t>(rgb.size() / 3);
  std::vector<uint8_t> row(dapple::pixel_bytes(format, width), fill);
  const dapple::paint::Source place = {nullptr, nullptr, nullptr, width, y, 0, y};
  dapple::paint::pack(brush, place, rgb.data(), 0, static_cast<uint8_t>(width), row.data());
  return row;
}

// A field as a plane with a slope, painted with a view; value(x, y) in field units.
template <class F> std::vector<uint8_t> painted(F value, uint16_t width, const dapple::Paint& paint, const Brush& brush) {
  std::vector<int16_t> rows[3];
  for (int k = 0; k < 3; ++k)
    for (int x = -1; x <= width; ++x) rows[k].push_back(static_cast<int16_t>(value(x, k - 1)));
  const dapple::paint::Source source = {rows[0].data() + 1, rows[1].data() + 1, rows[2].data() + 1, width, 0, 0, 0};
  const dapple::paint::Shader shader = dapple::paint::shader_of(paint, brush, 8000, 0, 1);
  std::vector<uint8_t> row(dapple::pixel_bytes(brush.format, width));
  dapple::paint::paint_row(shader, brush, source, row.data());
  return row;
}

dapple::Paint plain_paint() {
  dapple::Paint paint{};
  dapple::recipe::read_stops(dapple::recipe::word_of("000000,ffffff"), paint.ramp);
  paint.low = -100000;
  paint.high = 100000;
  return paint;
}

Brush brush_of(View view, Pixels format = Pixels::rgb888) {
  Brush brush;
  brush.view = view;
  brush.format = format;
  return brush;
}

}  // namespace

TEST_CASE("paint: formats are what their names say, byte by byte") {
  const std::vector<uint8_t> rgb = {255, 0, 0, 0, 255, 0, 0, 0, 255};
  using Bytes = std::vector<uint8_t>;
  CHECK(packed(rgb, Pixels::rgb888, 0, false) == rgb);
  CHECK(packed(rgb, Pixels::rgba8888, 0, false) == Bytes{255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255});
  CHECK(packed(rgb, Pixels::rgb565, 0, false) == Bytes{0x00, 0xf8, 0xe0, 0x07, 0x1f, 0x00});
  CHECK(packed(rgb, Pixels::rgb565_swapped, 0, false) == Bytes{0xf8, 0x00, 0x07, 0xe0, 0x00, 0x1f});
  CHECK(packed(rgb, Pixels::l8, 0, false) == Bytes{77, 149, 29});
}

TEST_CASE("paint: one bit a pixel in three layouts") {
  std::vector<uint8_t> rgb;
  for (const int on : {1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1}) rgb.insert(rgb.end(), 3, on ? 255 : 0);
  CHECK(packed(rgb, Pixels::l1_msb, 0, false) == std::vector<uint8_t>{0x80, 0x60});
  CHECK(packed(rgb, Pixels::l1_lsb, 0, false) == std::vector<uint8_t>{0x01, 0x06});
  const std::vector<uint8_t> page = packed(rgb, Pixels::l1_pages, 3, false, 0xf7);
  CHECK(page[0] == 0xff);
  CHECK(page[1] == 0xf7);
  CHECK(page[9] == 0xff);
  const std::vector<uint8_t> cleared = packed(rgb, Pixels::l1_pages, 3, false, 0xff);
  CHECK(cleared[0] == 0xff);
  CHECK(cleared[1] == 0xf7);
}

TEST_CASE("paint: row bytes") {
  CHECK(dapple::pixel_bytes(Pixels::l8, 11) == 11);
  CHECK(dapple::pixel_bytes(Pixels::rgb888, 11) == 33);
  CHECK(dapple::pixel_bytes(Pixels::rgba8888, 11) == 44);
  CHECK(dapple::pixel_bytes(Pixels::rgb565, 11) == 22);
  CHECK(dapple::pixel_bytes(Pixels::rgb565_swapped, 11) == 22);
  CHECK(dapple::pixel_bytes(Pixels::l1_msb, 11) == 2);
  CHECK(dapple::pixel_bytes(Pixels::l1_lsb, 16) == 2);
  CHECK(dapple::pixel_bytes(Pixels::l1_pages, 11) == 11);
}

TEST_CASE("paint: ordered dither keeps the mean and covers all thresholds") {
  for (const int grey : {0, 1, 37, 128, 200, 254, 255}) {
    int lit = 0, sum = 0;
    for (uint16_t y = 0; y < 8; ++y) {
      const std::vector<uint8_t> rgb(24, static_cast<uint8_t>(grey));
      const std::vector<uint8_t> row = packed(rgb, Pixels::l1_msb, y, true);
      for (int b = 0; b < 8; ++b) lit += (row[0] >> b) & 1;
      const std::vector<uint8_t> wide = packed(rgb, Pixels::rgb565_swapped, y, true);
      for (int x = 0; x < 8; ++x) sum += wide[2 * x] >> 3;  // five bits of red
    }
    CAPTURE(grey);
    CHECK(std::abs(lit - grey * 64 / 255) <= 1);
    CHECK(std::abs(sum / 64.0 - grey * 31 / 255.0) <= .05);
  }
}

TEST_CASE("paint: the ramp maps its fixed range, clipped at both ends") {
  const dapple::Paint paint = plain_paint();  // -800..800 of the field
  const auto ramp_at = [&](int value) { return painted([=](int, int) { return value; }, 4, paint, brush_of(View::colour))[0]; };
  CHECK(ramp_at(-30000) == 0);
  CHECK(ramp_at(-800) == 0);
  CHECK(ramp_at(0) == 128);
  CHECK(ramp_at(800) == 255);
  CHECK(ramp_at(30000) == 255);
  const auto height_at = [&](int value) { return painted([=](int, int) { return value; }, 4, paint, brush_of(View::height))[0]; };
  CHECK(height_at(-1600) == 0);
  CHECK(height_at(-800) == 64);
  CHECK(height_at(800) == 191);
  CHECK(height_at(1600) == 255);
}

TEST_CASE("paint: stops lie where they say") {
  dapple::Paint paint = plain_paint();
  REQUIRE(dapple::recipe::read_stops(dapple::recipe::word_of("0:102030,100:ffffff,200:000000,255:ff0000"), paint.ramp));
  const auto at = [&](int step) {
    return painted([=](int, int) { return -800 + (1600 * step + 127) / 255; }, 1, paint, brush_of(View::colour));
  };
  CHECK(at(0) == std::vector<uint8_t>{16, 32, 48});
  for (const int c : {0, 1, 2}) CHECK(std::abs(at(100)[c] - 255) <= 2);
  for (const int c : {0, 1, 2}) CHECK(std::abs(at(150)[c] - 127) <= 3);
  CHECK(at(255) == std::vector<uint8_t>{255, 0, 0});
}

TEST_CASE("paint: slopes towards the light are brighter, flat ground keeps its colour") {
  dapple::Paint paint = plain_paint();
  const auto grey = [&](int slope_x, int slope_y) {
    return int(painted([=](int x, int y) { return slope_x * x + slope_y * y; }, 1, paint, brush_of(View::colour))[0]);
  };
  const int unlit = grey(0, 0);
  paint.light = 2000000;
  CHECK(std::abs(grey(0, 0) - unlit) <= 1);
  CHECK(grey(100, 0) > unlit);   // rises to the right: faces left, towards the light
  CHECK(grey(-100, 0) < unlit);
  CHECK(grey(0, 100) > unlit);
  CHECK(grey(0, -100) < unlit);
}

TEST_CASE("paint: normals are unit vectors, y up unless asked otherwise") {
  dapple::Paint paint = plain_paint();
  paint.light = 4000000;
  for (const int slope : {0, 40, 200, 1500}) {
    Brush brush = brush_of(View::normal);
    const auto up = painted([=](int, int y) { return slope * y; }, 1, paint, brush);
    brush.y_down = true;
    const auto down = painted([=](int, int y) { return slope * y; }, 1, paint, brush);
    const double x = up[0] - 128.0, y = up[1] - 128.0, z = up[2] - 128.0;
    CAPTURE(slope);
    CHECK(std::abs(std::sqrt(x * x + y * y + z * z) - 127) <= 2.5);
    CHECK(z >= 0);
    CHECK((slope == 0 || up[1] > 128));  // higher below: the surface leans towards the top of the picture
    CHECK(std::abs(int(down[1]) - (256 - int(up[1]))) <= 1);
  }
}

TEST_CASE("paint: cells and field views of a grown tile") {
  tests::Grown tile(tests::preset_with("zebra", "steps=10"), dapple::torus(64, 48), 3);
  const std::vector<int16_t> field = tile.field();
  Brush brush = brush_of(View::cells, Pixels::l8);
  const std::vector<uint8_t> cells = tile.pixels(brush);
  for (size_t i = 0; i < field.size(); ++i) REQUIRE(cells[i] == (field[i] > tile.texture.cell_level() ? 255 : 0));
  brush.view = View::field;
  const std::vector<uint8_t> grey = tile.pixels(brush);
  for (size_t i = 0; i < field.size(); ++i) {
    const double want = std::min(255.0, std::max(0.0, (field[i] + 800) * 255.0 / 1600));
    REQUIRE(std::abs(grey[i] - want) <= 1.0);
  }
}

TEST_CASE("paint: rows in any order, and while the texture grows") {
  const dapple::Recipe recipe = tests::preset_with("weave", "steps=6 levels=2 fine=2");
  tests::Grown tile(recipe, dapple::torus(60, 58), 3);
  const std::vector<uint8_t> whole = tile.pixels(Brush{});
  std::vector<uint8_t> line(60 * 4);
  for (uint32_t k = 0; k < 200; ++k) {
    const uint16_t y = static_cast<uint16_t>((k * 23 + k / 3) % 58);
    tile.texture.paint(y, Brush{}, line.data());
    REQUIRE(std::equal(line.begin(), line.end(), whole.begin() + static_cast<long>(y) * 240));
  }
  std::vector<uint8_t> memory(dapple::bytes_for(recipe, dapple::torus(60, 58)));
  dapple::Texture growing;
  REQUIRE(growing.begin(recipe, dapple::torus(60, 58), 3, memory.data(), memory.size()) == dapple::ok);
  uint16_t y = 0;
  while (growing.step(5) == dapple::more) growing.paint(y = static_cast<uint16_t>((y + 17) % 58), Brush{}, line.data());
  std::vector<uint8_t> after;
  for (uint16_t row = 0; row < 58; ++row) {
    growing.paint(row, Brush{}, line.data());
    after.insert(after.end(), line.begin(), line.end());
  }
  CHECK(after == whole);
}

TEST_CASE("paint: another paint for a finished tile, and back") {
  tests::Grown tile(tests::preset_with("sand", "steps=6"), dapple::torus(48, 48), 3);
  const uint64_t before = tile.paint_hash();
  const dapple::Paint other = plain_paint();
  tile.texture.repaint(&other);
  CHECK(tile.paint_hash() != before);
  tile.texture.repaint(nullptr);
  CHECK(tile.paint_hash() == before);
}
