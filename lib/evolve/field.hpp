// Rows of the field that paint reads, whatever grid the planes stand on.
// SPDX-License-Identifier: MIT
#pragma once
#include "run.hpp"

namespace dapple::evolve {

// Rows of coarse field that are kept while fine ones are made of them.
constexpr uint8_t kCoarseRows = 4;

// Bytes of work field_row needs: the model's work rows; or, where the field has neighbours, their rows with halo, the
// coarse rows at hand with a halo of two cells and their numbers, and two rows on the way to a fourfold enlargement.
constexpr size_t field_bytes(const Model& model, const Reach& reach, const Ground& ground, uint16_t width, uint8_t level) {
  const size_t own = model.work_rows * grid::row_bytes(grid::Cell::int16, ground.width);
  if (reach.field_radius == 0) return own;
  const uint16_t coarse = at_level(ground.width, level);
  const size_t window = (2u * reach.field_radius + 1u) * grid::scratch_bytes(model.cell, coarse, reach.field_radius);
  return window + kCoarseRows * (sizeof(uint32_t) + grid::scratch_bytes(grid::Cell::int16, coarse, 2)) +
         (level > 1 ? 2 : 0) * grid::row_bytes(grid::Cell::int16, static_cast<uint16_t>(width / 2 + 4));
}

// Forgets the rows kept in `work`: to be called before the first field_row and whenever the planes have moved.
void forget_rows(const Run& run, uint8_t* work);

// The field of row y of the domain, as it stands. out: domain.width values.
void field_row(const Run& run, uint16_t y, int16_t* out, uint8_t* work);

}  // namespace dapple::evolve
