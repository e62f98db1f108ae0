// Explicit kinetics: one step of all morphogens in one sweep, diffusion by five points or, stretched, by eight
// neighbours. `kinetics` grows; `cascade` also holds cells: they are read by their neighbours, never written.
// SPDX-License-Identifier: MIT
#pragma once
#include "../model/kinetics.hpp"
#include "../stencil/diffuse.hpp"
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
  table_count
};

// Planes kept behind the model's own: the deviations of a rate from cell to cell, then what is held.
constexpr uint8_t kept_by(const int32_t* number, bool holds) {
  return static_cast<uint8_t>((number[kinetics::vary] > 0 ? 1 : 0) + (holds ? 1 : 0));
}

constexpr Reach reach_of_kinetics(const Model& model, const int32_t* number, bool holds) {
  const uint8_t planes = model.planes(number), kept = kept_by(number, holds);
  Reach reach{static_cast<uint8_t>(planes + kept),
              1,
              1,
              model.work_rows,
              static_cast<uint8_t>(planes + 1),
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

bool kinetics_next(const Context& context, Cursor& cursor, Sweep& sweep);
bool cascade_next(const Context& context, Cursor& cursor, Sweep& sweep);
void prepare_kinetics(const Context& context);
void kinetics_field(const grid::Rows& rows);
void cascade_field(const grid::Rows& rows);

inline constexpr Solver kinetics_solver DAPPLE_ROM = {kinetics_reach, kinetics_next, prepare_kinetics, kinetics_field};
inline constexpr Solver cascade_solver DAPPLE_ROM = {cascade_reach, cascade_next,  prepare_kinetics, cascade_field, nullptr,
                                                     Sharing::none, 1,             nullptr,          true};

}  // namespace dapple::evolve
