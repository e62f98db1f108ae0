// Tile, for the smallest machines, gives the bytes of a Texture: field and pixels, whatever the words and the slicing.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <cstring>
#include <vector>
#include "tile.hpp"

namespace {

using dapple::Pixels;
using dapple::Preset;
namespace presets = dapple::presets;

constexpr Preset full = dapple::recipe::preset("bits window=6 scale=9 stretch=3 angle=78.5 level=0 steps=8 ramp=zebra");
constexpr Preset ramped = dapple::recipe::preset(
    "bits masks=2 react=da window=5 scale=7 stretch=3 angle=0 rho=0.2:-0.1@0.2..0.9 steps=6 ramp=zebra grain=0.1 range=-1.1,0.4");

template <const Preset& preset, uint16_t width, uint16_t height> std::vector<int16_t> whole(uint32_t seed) {
  const dapple::Domain domain = dapple::torus(width, height);
  std::vector<uint8_t> memory(dapple::bytes_for(preset, domain));
  dapple::Texture texture;
  REQUIRE(texture.begin(preset, domain, seed, memory.data(), memory.size()) == dapple::ok);
  texture.finish();
  std::vector<int16_t> field(static_cast<size_t>(width) * height);
  for (uint16_t y = 0; y < height; ++y) texture.row(y, field.data() + static_cast<size_t>(y) * width);
  return field;
}

// The field of a tile grown `rows` at a time, looked at from the bottom up or from the top down.
template <class Tile> std::vector<int16_t> sliced(Tile& tile, uint16_t width, uint16_t height, uint32_t seed, uint16_t rows, bool up) {
  tile.begin(seed);
  while (tile.step(rows) == dapple::more) {
  }
  std::vector<int16_t> field(static_cast<size_t>(width) * height);
  for (uint16_t i = 0; i < height; ++i) {
    const uint16_t y = static_cast<uint16_t>(up ? height - 1 - i : i);
    tile.row(y, field.data() + static_cast<size_t>(y) * width);
  }
  return field;
}

template <const Preset& preset, uint16_t width, uint16_t height> void same_field() {
  static dapple::Tile<preset, width, height> tile;
  for (const uint32_t seed : {7u, 0xfffffff0u}) {
    const std::vector<int16_t> want = whole<preset, width, height>(seed);
    CHECK(sliced(tile, width, height, seed, 1, false) == want);
    CHECK(sliced(tile, width, height, seed, 7, true) == want);
    CHECK(sliced(tile, width, height, seed, 65535, false) == want);
  }
}

template <const Preset& preset> constexpr dapple::Fixed frugal = dapple::fixed(preset, dapple::torus(64, 64), true);

template <Pixels format, const Preset& preset> void same_pixels() {
  static dapple::Tile<preset, 64, 64> tile;
  std::vector<uint8_t> memory(frugal<preset>.need.bytes);
  dapple::Texture texture;
  REQUIRE(texture.begin(frugal<preset>, 7, memory.data(), memory.size()) == dapple::ok);
  texture.finish();
  tile.begin(7);
  tile.finish();
  uint8_t want[256] = {}, got[256] = {};
  for (uint16_t y = 0; y < 64; ++y) {
    texture.paint(y, format, want);
    tile.template paint<format>(y, got);
    REQUIRE(std::memcmp(want, got, sizeof want) == 0);
  }
}

template <const Preset& preset> void same_pixels_of_all_formats() {
  same_pixels<Pixels::l8, preset>();
  same_pixels<Pixels::rgb888, preset>();
  same_pixels<Pixels::rgba8888, preset>();
  same_pixels<Pixels::rgb565, preset>();
  same_pixels<Pixels::rgb565_swapped, preset>();
  same_pixels<Pixels::l1_msb, preset>();
  same_pixels<Pixels::l1_lsb, preset>();
  same_pixels<Pixels::l1_pages, preset>();
  same_pixels<Pixels::l16, preset>();
  same_pixels<Pixels::l16_swapped, preset>();
}

}  // namespace

TEST_CASE("Tile: the field of a Texture, running down the rows") {
  same_field<presets::zebra_bits, 64, 64>();
  same_field<presets::zebra_bits, 80, 54>();  // words of 8 bits, an odd number of rows
  same_field<full, 96, 40>();
  same_field<presets::weave_bits, 64, 48>();
}

TEST_CASE("Tile: the field of a Texture, with whole windows") {
  same_field<presets::maze_bits, 64, 64>();
  same_field<presets::spots_bits, 96, 64>();  // words of 16 bits
  same_field<presets::giraffe_bits, 64, 64>();
  same_field<ramped, 64, 46>();
}

TEST_CASE("Tile: words of 8, 16 and 32 bits give the same cells") {
  static dapple::Tile<presets::zebra_bits, 64, 64, uint8_t> eight;
  static dapple::Tile<presets::zebra_bits, 64, 64, uint16_t> sixteen;
  static dapple::Tile<presets::zebra_bits, 64, 64, uint32_t> thirty_two;
  const std::vector<int16_t> want = whole<presets::zebra_bits, 64, 64>(99);
  CHECK(sliced(eight, 64, 64, 99, 5, false) == want);
  CHECK(sliced(sixteen, 64, 64, 99, 5, false) == want);
  CHECK(sliced(thirty_two, 64, 64, 99, 5, false) == want);
}

TEST_CASE("Tile: the pixels of a frugal Texture") {
  same_pixels_of_all_formats<presets::zebra_bits>();
  same_pixels_of_all_formats<ramped>();
}

TEST_CASE("Tile: a ramp's places without a division") {
  for (int32_t value = -20000; value <= 20000; ++value) {
    const auto place = [&](int32_t low, int32_t span) {
      const int32_t over = value - low;
      return (over < 0 ? 0 : over > span ? span : over) * 4080 / span;
    };
    const int16_t v = static_cast<int16_t>(value);
    REQUIRE(dapple::tile::place<-7600, 15200>(v) == place(-7600, 15200));
    REQUIRE(dapple::tile::place<-16000, 32000>(v) == place(-16000, 32000));
    REQUIRE(dapple::tile::place<-3, 7>(v) == place(-3, 7));
    REQUIRE(dapple::tile::place<100, 4080>(v) == place(100, 4080));
  }
}

TEST_CASE("Tile: memory is what the 2 KB of an ATmega328P bear") {
  CHECK(sizeof(dapple::Tile<presets::zebra_bits, 64, 64, uint8_t>) <= 320);
  CHECK(sizeof(dapple::Tile<full, 128, 64, uint8_t>) <= 1448);
}
