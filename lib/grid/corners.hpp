// Corner tiles: sixteen square tiles, one for every choice of two colours at four corners, lying as a 4 x 4 torus in which
// each of them occurs once. Any tiles whose common corners have the same colours may meet. Lagae & Dutre 2006.
// SPDX-License-Identifier: MIT
#pragma once
#include "../base/port.hpp"

namespace dapple::grid {

constexpr uint8_t kTilesAcross = 4, kTiles = 16;

// The colour, 0 or 1, of the upper left corner of the tile in column i and row j, both modulo 4:
//   0 0 0 1
//   0 0 1 0
//   1 0 1 1
//   0 1 1 1
constexpr uint8_t corner_colour(uint8_t i, uint8_t j) {
  return static_cast<uint8_t>((UINT32_C(0xed48) >> (4 * (j & 3) + (i & 3))) & 1);
}

// The colours of a tile's corners: left upper | right upper << 1 | left lower << 2 | right lower << 3.
constexpr uint8_t corners_of(uint8_t i, uint8_t j) {
  const uint8_t right = static_cast<uint8_t>(i + 1), below = static_cast<uint8_t>(j + 1);
  return static_cast<uint8_t>(corner_colour(i, j) | corner_colour(right, j) << 1 | corner_colour(i, below) << 2 |
                              corner_colour(right, below) << 3);
}

// The sixteen cells at one place of every tile, tile by tile (column + 4 row), and with which each has to agree: `first`
// is the first tile of its class.
struct Alike {
  uint8_t first[kTiles];
};

// The classes of a place near a corner (2^3 tiles each), near a horizontal edge (across) or a vertical one (down; 2^2
// each). below, right: the lower or right one of a tile's two edges is the nearer.
struct Classes {
  Alike corner[2][2];  // [below][right]
  Alike across[2];     // [below]
  Alike down[2];       // [right]
};
constexpr uint8_t kCornerShare = 3, kEdgeShare = 2;  // log2 of the tiles of a class

constexpr Classes make_classes() {
  Classes c{};
  uint8_t key[8][kTiles] = {};
  for (uint8_t t = 0; t < kTiles; ++t) {
    for (uint8_t k = 0; k < 2; ++k) {
      const uint8_t i = t & 3, j = t >> 2, right = static_cast<uint8_t>(i + 1), below = static_cast<uint8_t>(j + 1);
      const uint8_t along = static_cast<uint8_t>(j + k), beside = static_cast<uint8_t>(i + k);
      for (uint8_t r = 0; r < 2; ++r) key[2 * k + r][t] = corner_colour(static_cast<uint8_t>(i + r), along);
      key[4 + k][t] = static_cast<uint8_t>(corner_colour(i, along) | corner_colour(right, along) << 1);
      key[6 + k][t] = static_cast<uint8_t>(corner_colour(beside, j) | corner_colour(beside, below) << 1);
    }
  }
  Alike* const classes[8] = {&c.corner[0][0], &c.corner[0][1], &c.corner[1][0], &c.corner[1][1],
                             &c.across[0],    &c.across[1],    &c.down[0],      &c.down[1]};
  for (uint8_t n = 0; n < 8; ++n)
    for (uint8_t t = 0; t < kTiles; ++t) {
      uint8_t first = 0;
      while (key[n][first] != key[n][t]) ++first;
      classes[n]->first[t] = first;
    }
  return c;
}
inline constexpr Classes kClasses DAPPLE_ROM = make_classes();

// Where a place lies along one side of a tile: its distance to the nearer edge, 0 for the cells at it, and which that is.
struct Nearness {
  uint16_t distance;
  bool far;  // the right or lower edge
};
constexpr Nearness nearness(uint16_t at, uint16_t side) {
  const bool far = 2u * at >= side;
  return {far ? static_cast<uint16_t>(side - 1 - at) : at, far};
}

}  // namespace dapple::grid
