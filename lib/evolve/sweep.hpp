// One sweep over the rows of a band, in place, resumable after any row.
//
// A kernel of radius r and stride S reads old rows y - r S .. y + r S. Rows are visited in coset order y, y + S, y + 2 S ...
// around the torus, so a ring of 2 r + 1 scratch rows a plane holds all old rows a kernel needs, whatever the stride;
// r more keep the first rows of a coset for its end. There are gcd(S, height) cosets. A band is a range of positions in
// that order. Bands never see each other's new rows: the up to 4 r old rows beyond a band's ends are copied before any
// band of the sweep starts, so bands may run in any order or at once.
// SPDX-License-Identifier: MIT
#pragma once
#include "solver.hpp"

namespace dapple::evolve {

// The planes of a grid and the scratch memory of its bands.
struct Field {
  uint8_t* planes;        // plane i starts at planes + i * plane_bytes, rows of row_bytes without halo
  size_t plane_bytes, row_bytes;
  uint8_t* scratch;       // of band 0; band i at scratch + i * band_bytes
  size_t band_bytes;
  uint16_t width, height;
  grid::Cell cell;
  uint8_t bands;
};

// Makes two fine rows of one coarse one, bottom row first; see refine.hpp.
using RowRefine = void (*)(const Field& coarse, uint8_t plane, uint16_t y);

inline uint8_t* row_of(const Field& field, uint8_t plane, uint16_t y) {
  return field.planes + plane * field.plane_bytes + static_cast<size_t>(y) * field.row_bytes;
}

// A band's place within a sweep: positions `next`..`end` are still to be done.
struct Band {
  uint16_t next, end;
  uint16_t coset, index;  // of position `next`; the row is (coset + index * stride) mod height
  uint16_t y;             // that row
  uint16_t stop;          // index at which this band's part of the coset ends
  uint16_t run;           // rows done since the ring was filled
  uint8_t slot;           // ring slot of the oldest row
  bool open;              // the ring is filled for this coset
};

// Rows of scratch a band needs in its windows: ring, saved first rows, and edges where there are several bands.
constexpr uint16_t window_rows(uint8_t radius, uint8_t bands) {
  return static_cast<uint16_t>(3 * radius + (radius > 0 ? 1 : 0) + (bands > 1 ? 4 * radius : 0));
}

// Cells there is room for where a kernel keeps more than rows: whole words of any width, and 64 cells to align them.
constexpr size_t kept_cells(uint16_t width) {
  const size_t rest = base::kWidestWord > 64 ? -static_cast<size_t>(width) & (base::kWidestWord - 1u) : 0;
  return static_cast<size_t>(width) + rest + 64;
}

// Bytes of scratch of one band.
constexpr bool band_bytes(const Reach& reach, grid::Cell cell, uint16_t width, uint8_t bands, size_t& total) {
  const size_t window = grid::scratch_bytes(cell, width, reach.halo);
  total = 0;
  const bool fits =
      base::add_bytes(total, reach.planes, grid::align4(window_rows(reach.radius, bands) * window)) &&
      base::add_bytes(total, reach.halo_rows, grid::scratch_bytes(grid::Cell::int16, width, reach.halo)) &&
      base::add_bytes(total, reach.rows16, grid::row_bytes(grid::Cell::int16, width)) &&
      base::add_bytes(total, reach.rows32, grid::row_bytes(grid::Cell::int32, width)) &&
      base::add_bytes(total, reach.bytes, kept_cells(width)) && base::add_bytes(total, reach.space, 1);
  total = grid::align4(total);
  return fits;
}

// Splits the sweep's positions among the bands and, with more than one, saves the rows beyond their ends.
void begin_sweep(const Field& field, const Sweep& sweep, Band* bands);

// Runs up to `rows` rows of one band; returns how many it ran. The band is complete when next == end.
uint32_t run_band(const Field& field, const Sweep& sweep, const int32_t* table, uint8_t index, Band& band, uint32_t rows);

}  // namespace dapple::evolve
