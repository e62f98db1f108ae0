// Explicit kinetics: one step of all morphogens in one sweep, diffusion by five points or, stretched, by eight
// neighbours. `kinetics` grows; `cascade` also holds cells: they are read by their neighbours, never written;
// `pictured` grows by a picture [Lawlor].
// SPDX-License-Identifier: MIT
#pragma once
#include "../model/kinetics.hpp"
#include "../model/turing.hpp"
#include "../stencil/diffuse.hpp"
#include "../stencil/maps.hpp"
#include "solver.hpp"

namespace dapple::evolve {

// The table: four weights of the stencil, and what a stage's first sweep and the field want to know.
enum KineticTable : uint8_t {
  shown_plane = 4,
  held_apart,
  morphogens,
  varies,
  vary_count,
  origin_x,
  origin_y,
  ring_x,
  ring_y,
  on_plane,
  seed_of,
  wide_cells,
  has_rates,  // a plane of deviations is kept
  level_of,
  cut_bits,  // of compact cells; 0: the cells are computed as they are kept
  linked,    // a plane of directions is kept, behind what is held
  graded,    // and the last one, of the squares of the wavelengths' shares, Q9: finest (Q12) * 8 + kind, or 0
  moved,     // what the field has more than the shown morphogen, so that the share of cells asked for is on
  table_count
};

constexpr uint8_t kStepOf = kMaxValues - 1;  // of a sweep's p: which step this is, for compact cells
constexpr int32_t kVaryCut = 1 << (kinetics::kVaryBits - kinetics::kCompactVary);  // deviations of compact cells

// Planes kept behind the model's own: the deviations of a rate from cell to cell, then what is held.
constexpr uint8_t kept_by(const int32_t* number, bool holds) {
  return static_cast<uint8_t>((number[kinetics::vary] > 0 ? 1 : 0) + (holds ? 1 : 0));
}

constexpr Reach reach_of_kinetics(const Model& model, const int32_t* number, bool holds) {
  const uint8_t planes = model.planes(number), kept = kept_by(number, holds);
  const uint8_t computed = kinetics::cut_of(model) > 0 ? planes : uint8_t{0};  // rows in the format of steps
  Reach reach{static_cast<uint8_t>(planes + kept),
              1,
              1,
              model.work_rows,
              static_cast<uint8_t>(planes + 1 + computed),
              0,
              1,
              1,
              table_count,
              1};
  reach.kept = kept;
  reach.once = kept > 0 ? 1 : 0;
  return reach;
}
constexpr Reach kinetics_reach(const Model& model, const int32_t* number, uint8_t, const void*) {
  return reach_of_kinetics(model, number, false);
}
constexpr Reach cascade_reach(const Model& model, const int32_t* number, uint8_t, const void*) {
  return reach_of_kinetics(model, number, true);
}

// A share of all cells is for tiles: windows of the plane, and patches that are joined, would not agree.
constexpr Status accepts_share(const int32_t* number, const void*, const Domain& domain) {
  const bool whole = domain.patches != nullptr ? domain.patches->count == 1 : !domain.plane;
  return whole || number[kinetics::coverage] == 0 ? ok : no_coverage;
}

// A plane of growth behind the model's own; where the picture is follows the table.
constexpr uint8_t kPictureWords = (sizeof(const GreyImage*) + 3) / 4;
constexpr Reach reach_of_pictured(const Model& model, const int32_t* number) {
  Reach reach = reach_of_kinetics(model, number, false);
  reach.planes = static_cast<uint8_t>(model.planes(number) + 1);
  reach.kept = reach.once = 1;
  reach.table = static_cast<uint16_t>(table_count + kPictureWords);
  return reach;
}
constexpr Reach pictured_reach(const Model& model, const int32_t* number, uint8_t, const void*) {
  return reach_of_pictured(model, number);
}
constexpr Status accepts_grey(const GreyImage& image) {
  const bool good = image.cells != nullptr && within(image.width, 1, kMostImage) && within(image.height, 1, kMostImage);
  return good ? ok : bad_map;
}
constexpr Status accepts_picture(const int32_t* number, const void* given, const Domain& domain) {
  if (given == nullptr) return bad_map;
  const Status status = accepts_grey(static_cast<const PlaceMaps*>(given)->grey);
  return status == ok ? accepts_share(number, given, domain) : status;
}

inline uint8_t kept_at(const grid::Rows& rows) { return static_cast<uint8_t>(rows.table[morphogens]); }
inline uint8_t held_at(const grid::Rows& rows) { return static_cast<uint8_t>(kept_at(rows) + rows.table[has_rates]); }

// A step. in[3 plane + k]: rows y - 1 + k; out[plane]: row y, in place; kept planes last. part: {stencil, reaction}.
// table: KineticTable. scratch: the sums of every morphogen, a row of deviations, compact cells in the format of steps,
// then the reaction's own rows.
void kinetics_row(const grid::Rows& rows);
// The same, then what is held goes back to what it was; and that alone.
void cascade_row(const grid::Rows& rows);
void hold_row(const grid::Rows& rows);

bool kinetics_next(const Context& context, Cursor& cursor, Sweep& sweep);
bool cascade_next(const Context& context, Cursor& cursor, Sweep& sweep);
bool pictured_next(const Context& context, Cursor& cursor, Sweep& sweep);
void prepare_kinetics(const Context& context);
void prepare_pictured(const Context& context);
void kinetics_field(const grid::Rows& rows);
void cascade_field(const grid::Rows& rows);
void look_at_share(const Run& run, int16_t* row, uint8_t* work);

// The other parts of their sweeps, for solvers that do more (along.hpp): first sweeps' rows; a cell of either width; both
// sweeps, of cells that may be held, and by a picture.
void enter_row(const grid::Rows& rows);
void picture_row(const grid::Rows& rows);
void set_cell(const grid::Rows& rows, void* row, uint16_t x, int32_t value);
void enter_sweep(const Context& context, bool has_mask, Sweep& sweep);
void step_sweep(const Context& context, bool has_mask, grid::RowKernel row, Sweep& sweep);
void picture_sweep(const Context& context, Sweep& sweep);
void pictured_sweep(const Context& context, grid::RowKernel row, Sweep& sweep);

// They share nothing between tiles, and look for a share of all cells.
constexpr Solver kinetics_of(decltype(Solver::reach) reach, decltype(Solver::next) next,
                             decltype(Solver::prepare) prepare, grid::RowKernel field,
                             decltype(Solver::accepts) accepts, bool freezes, Maps maps, bool pictured = false) {
  return {reach, next, prepare, field, accepts, Sharing::none, 1, nullptr, freezes, maps, pictured, look_at_share};
}
inline constexpr Solver kinetics_solver DAPPLE_ROM =
    kinetics_of(kinetics_reach, kinetics_next, prepare_kinetics, kinetics_field, accepts_share, false, Maps::off);
inline constexpr Solver cascade_solver DAPPLE_ROM =
    kinetics_of(cascade_reach, cascade_next, prepare_kinetics, cascade_field, accepts_share, true, Maps::off);
inline constexpr Solver pictured DAPPLE_ROM = kinetics_of(pictured_reach, pictured_next, prepare_pictured,
                                                          kinetics_field, accepts_picture, false, Maps::off, true);

}  // namespace dapple::evolve
