// Rows of ghost cells. See ghosts.hpp.
// SPDX-License-Identifier: MIT
#include "ghosts.hpp"

#include "../model/kinetics.hpp"
#include "../stencil/maps.hpp"

namespace dapple::evolve {

// An entry: the byte of the source's cell, counted from plane 0 of patch 0; or one of the fixed sides.
constexpr uint32_t kFixed = kMostGhostBytes;
static uint32_t fixed_entry(uint8_t patch, uint8_t side) { return kFixed | static_cast<uint32_t>(4 * patch + side); }

// Rows above and below the patch are ghosts throughout, the others at both ends. Entries follow each other row by row.
struct Row {
  uint32_t* entry;
  uint16_t first, gap;  // cells at the beginning; cells of the patch behind them
};
static Row ghosts_of(const Run& run, uint16_t y) {
  const uint16_t pad = at_level(run.ground.pad, run.stage.level), wide = run.field.width;
  const uint16_t below = static_cast<uint16_t>(run.field.height - pad);
  const bool whole = y < pad || y >= below;
  const uint32_t full = static_cast<uint32_t>(y < pad ? y : y < below ? pad : y - below + pad) * wide;
  const uint32_t ends = static_cast<uint32_t>(y < pad ? 0 : y < below ? y - pad : below - pad) * (2u * pad);
  return {run.ghosts.entry + full + ends, whole ? wide : pad, static_cast<uint16_t>(whole ? 0 : wide - 2 * pad)};
}

static uint32_t entry_of(const Run& run, const grid::Source& s) {
  if (s.fixed != nullptr) {
    const Patch* const all = run.ground.patches->patch;
    for (uint8_t i = 0; i < run.ground.patches->count; ++i)
      for (uint8_t k = 0; k < kSides; ++k)
        if (s.fixed == &all[i].side[k]) return fixed_entry(i, k);
  }
  const int32_t pad = at_level(run.ground.pad, run.stage.level);
  const size_t cell = run.field.cell == grid::Cell::int16 ? 2 : 4;
  return static_cast<uint32_t>(s.patch * run.ghosts.block + static_cast<size_t>(s.y + pad) * run.field.row_bytes +
                               static_cast<size_t>(s.x + pad) * cell);
}

DAPPLE_APART static void make_entries(const Run& run, const Row& row, uint16_t y) {
  const int32_t pad = at_level(run.ground.pad, run.stage.level);
  uint32_t* entry = row.entry;
  for (int32_t x = 0; x < run.field.width; ++x) {
    if (x == row.first && row.gap > 0) x += row.gap;
    *entry++ = entry_of(run, grid::source_of(*run.ground.patches, run.stage.level, run.ground.patch, x - pad, y - pad));
  }
}

// In the format of the cells, which for wide ones is not that of the field.
static int32_t fixed_value(const Run& run, uint32_t entry, uint8_t plane) {
  const Side& side = run.ground.patches->patch[(entry & 255) / 4].side[entry & 3];
  const int64_t one = run.field.cell == grid::Cell::int32 ? INT64_C(1) << kinetics::kWide : run.model.unit;
  return static_cast<int32_t>(base::divide_round(side.value[plane & 1] * one, base::kMicro));
}

template <class T>
static void fill(const Run& run, const Row& row, uint8_t plane, T* cell) {
  const uint8_t* const source = run.ghosts.planes + plane * run.field.plane_bytes;
  const uint32_t* entry = row.entry;
  for (uint16_t x = 0; x < run.field.width; ++x) {
    if (x == row.first && row.gap > 0) x = static_cast<uint16_t>(x + row.gap);
    const uint32_t from = *entry++;
    cell[x] =
        from >= kFixed ? static_cast<T>(fixed_value(run, from, plane)) : *reinterpret_cast<const T*>(source + from);
  }
}

void seal_row(Run& run) {
  const Row row = ghosts_of(run, run.at_row);
  if (!run.ghosts.made) make_entries(run, row, run.at_row);
  const uint8_t planes = run.model.planes(run.stage.number);
  for (uint8_t i = 0; i < planes; ++i) {
    uint8_t* const cells = row_of(run.field, i, run.at_row);
    if (run.field.cell == grid::Cell::int16) fill(run, row, i, reinterpret_cast<int16_t*>(cells));
    else fill(run, row, i, reinterpret_cast<int32_t*>(cells));
  }
}

}  // namespace dapple::evolve

namespace dapple::grid {

extern const PatchWork patch_work = {evolve::seal_row, stencil::patch_row, source_of};

}  // namespace dapple::grid
