// Rows of the field that paint reads, whatever grid the planes stand on.
// SPDX-License-Identifier: MIT
#pragma once
#include "run.hpp"

namespace dapple::evolve {

// Rows of coarse field that are kept while fine ones are made of them.
constexpr uint8_t kCoarseRows = 4;

constexpr size_t window_bytes(grid::Cell cell, uint16_t width, uint8_t radius) {
  return grid::align4((2u * radius + 1u) * grid::scratch_bytes(cell, width, radius));
}

// Bytes of work field_row needs: the model's work rows; or, where the field has neighbours, their rows with halo and, but
// for a torus that is not enlarged, the coarse rows at hand with a halo of two cells and their numbers, and two rows on the
// way to a fourfold enlargement.
constexpr size_t field_bytes(const Model& model, const Reach& reach, const Ground& ground, bool plane, uint16_t width, uint8_t level) {
  const size_t own = model.work_rows * grid::row_bytes(grid::Cell::int16, ground.width);
  if (reach.field_radius == 0) return own;
  const uint16_t coarse = at_level(ground.width, level);
  const size_t window = window_bytes(model.cell, coarse, reach.field_radius) + grid::align4(reach.space);
  if (level == 0 && !plane) return window;
  return window + kCoarseRows * (sizeof(uint32_t) + grid::scratch_bytes(grid::Cell::int16, coarse, 2)) +
         (level > 1 ? 2 : 0) * grid::row_bytes(grid::Cell::int16, static_cast<uint16_t>(width / 2 + 4));
}

// Forgets the rows kept in `work`: to be called before the first field_row and whenever the planes have moved. row: room
// for one row of the domain.
void forget_rows(const Run& run, int16_t* row, uint8_t* work);

// The field of row y of the domain, as it stands. out: domain.width values.
void field_row(const Run& run, uint16_t y, int16_t* out, uint8_t* work);

}  // namespace dapple::evolve
