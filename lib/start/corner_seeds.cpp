// Seed discs of corner tiles: the lattice of seeds.cpp fitted to one tile, a column and a row of discs on its edges.
// SPDX-License-Identifier: MIT
#include "../base/hash.hpp"
#include "../grid/corners.hpp"
#include "discs.hpp"

namespace dapple::start {

// The lattice places of one tile along one direction.
struct Along {
  uint8_t tile;
  int32_t local;   // number of the place within the tile
  bool near, far;  // a disc there may touch the band of an edge; the right or lower one
};

// `at` on a tile, measured like `side` and `reach`.
static Along along_of(int32_t place, int32_t a_tile, int64_t at, int64_t side, int64_t reach) {
  const bool far = 2 * at >= side;
  return {static_cast<uint8_t>(place / a_tile), place % a_tile, (far ? side - at : at) < reach, far};
}

// How far from an edge the centre of a disc that touches the band may stand in the lattice, 1/256 cell.
static int64_t reach_of(const Place& place, const Start& start, uint16_t band, int64_t spacing) {
  const int64_t radius = cells(place, start.radius);
  return static_cast<int64_t>(band) * 256 + radius + spacing * start.jitter / base::kMicro;
}

// The tile whose disc at this place of the lattice the one of a tile is moved with.
static uint8_t leader_of(const grid::Classes& c, const Along& across, const Along& down) {
  const uint8_t tile = static_cast<uint8_t>(across.tile + 4 * down.tile);
  if (across.near && down.near) return c.corner[down.far][across.far].first[tile];
  if (down.near) return c.across[down.far].first[tile];
  return across.near ? c.down[across.far].first[tile] : tile;
}

void corner_seeds_row(const Place& place, const Start& start, const Levels& levels, uint16_t band, uint16_t y, void* row) {
  clear_row(place, levels, row);
  Place one = place;
  one.width = one.height = static_cast<uint16_t>(place.width / grid::kTilesAcross);
  const DiscGrid discs = disc_grid(start, one);
  const grid::Classes classes = base::rom_load(&grid::kClasses);
  const int32_t value = disc_level(start, levels);
  const int64_t at = static_cast<int64_t>(y) * 256 + 128;
  const int64_t wide = reach_of(place, start, band, discs.wide / discs.columns);
  const int64_t high = reach_of(place, start, band, discs.high / discs.rows);
  for (int32_t j = 0; j < grid::kTilesAcross * static_cast<int32_t>(discs.rows); ++j) {
    const Along down = along_of(j, discs.rows, j % discs.rows * discs.high / discs.rows, discs.high, high);
    for (int32_t i = 0; i < grid::kTilesAcross * static_cast<int32_t>(discs.columns); ++i) {
      const int64_t half_columns = 2 * (i % discs.columns) + (j & 1);  // odd rows stand half a place further
      const Along across = along_of(i, discs.columns, half_columns * discs.wide / (2 * discs.columns), discs.wide, wide);
      const uint8_t leader = leader_of(classes, across, down);
      const int32_t like_x = (leader & 3) * discs.columns + across.local, like_y = (leader >> 2) * discs.rows + down.local;
      const int64_t centre_y = floor_divide(j * discs.high, discs.rows) +
                               shake(base::hash(place.seed, kJitterY, like_x, like_y), start.jitter, discs.high / discs.rows);
      const int64_t half = half_chord(place, start, grid::kTilesAcross * discs.high, centre_y, at);
      if (half < 0) continue;
      const int64_t centre_x = floor_divide((2 * static_cast<int64_t>(i) + (j & 1)) * discs.wide, 2 * discs.columns) +
                               shake(base::hash(place.seed, kJitterX, like_x, like_y), start.jitter, discs.wide / discs.columns);
      fill_chord(place, centre_x, half, value, row);
    }
  }
}

}  // namespace dapple::start
