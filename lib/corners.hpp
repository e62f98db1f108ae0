// Corner tiles: an endless floor that never repeats, of one recipe, for one look into a table per tile. Sixteen square tiles are
// grown once, in one go, as a torus of 4 x 4; laid as tile_at says, any two of them meet as if they had been grown together.
//
//   const dapple::Domain domain = dapple::corner_tiles(128);   // the sheet: 4 x 4 tiles of 128 x 128 cells
//   std::vector<uint8_t> memory(dapple::bytes_for(recipe, domain));
//   dapple::Texture sheet;
//   if (sheet.begin(recipe, domain, seed, memory.data(), memory.size()) != dapple::ok) fault();
//   sheet.finish();
//   const dapple::CornerTile tile = dapple::tile_at(seed, x, y);   // of the floor, any x and y
//   blit(sheet, tile.column * 128, tile.row * 128, 128, 128, x * 128, y * 128);
//
// For recipes of the families threshold and gray-scott; a one-bit texture has the endless plane. While a texture of corner tiles
// is on its way they do not agree yet. Eight wavelengths a side look best: with less one sees the same tile come again.
// SPDX-License-Identifier: MIT
#pragma once
#include "base/hash.hpp"
#include "dapple.hpp"

namespace dapple {

constexpr uint16_t kLargestTile = 65535 / grid::kTilesAcross;

// Sixteen tiles of side x side cells as one torus. A side beyond kLargestTile: begin answers bad_side.
constexpr Domain corner_tiles(uint16_t side) {
  const uint16_t all = static_cast<uint16_t>(side > kLargestTile ? 0 : side * grid::kTilesAcross);
  return {all, all, 0, 0, false, &evolve::corners};
}

// A tile of the sheet: number column + 4 row.
struct CornerTile {
  uint8_t column, row;

  constexpr uint8_t number() const { return static_cast<uint8_t>(column + grid::kTilesAcross * row); }
};

constexpr uint32_t kCornerStream = 112;  // of the hash

// The colour, 0 or 1, of the corner at the upper left of the floor's tile (x, y). Corners 2 x 2 at a time have one of the fourteen
// patterns of two colours, 1 + below(hash(seed, 112, floor(x / 2), floor(y / 2)), 14), so that four equal tiles never meet.
constexpr uint8_t colour_at(uint32_t seed, int32_t x, int32_t y) {
  const uint32_t pattern = 1 + base::below(base::hash(seed, kCornerStream, x >> 1, y >> 1), 14);
  return static_cast<uint8_t>((pattern >> ((x & 1) + 2 * (y & 1))) & 1);
}

// The number of the tile with the corner colours `key` (left upper | right upper << 1 | left lower << 2 | right lower << 3) is
// in bits 4 key .. 4 key + 3: 0 3 12 13 4 15 2 11 1 8 5 14 7 6 9 10 for key = 0 .. 15.
constexpr uint64_t make_corner_table() {
  uint64_t table = 0;
  for (uint8_t t = 0; t < grid::kTiles; ++t)
    table |= static_cast<uint64_t>(t) << (4 * grid::corners_of(static_cast<uint8_t>(t & 3), static_cast<uint8_t>(t >> 2)));
  return table;
}
constexpr uint64_t kCornerTable = make_corner_table();
static_assert(kCornerTable == UINT64_C(0xa967e581b2f4dc30), "every choice of colours has its tile");

// The tile that lies at column x and row y of the floor. Coordinates wrap at 2^31.
constexpr CornerTile tile_at(uint32_t seed, int32_t x, int32_t y) {
  const int32_t right = static_cast<int32_t>(static_cast<uint32_t>(x) + 1), below = static_cast<int32_t>(static_cast<uint32_t>(y) + 1);
  const uint8_t key = static_cast<uint8_t>(colour_at(seed, x, y) | colour_at(seed, right, y) << 1 | colour_at(seed, x, below) << 2 |
                                           colour_at(seed, right, below) << 3);
  const uint8_t number = static_cast<uint8_t>((kCornerTable >> (4 * key)) & 15);
  return {static_cast<uint8_t>(number & 3), static_cast<uint8_t>(number >> 2)};
}

}  // namespace dapple
