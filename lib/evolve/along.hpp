// Explicit kinetics along a map of directions: the solvers of kinetics.hpp, but that diffusion is stretched along the
// direction of every cell, which a plane behind their own holds (stencil/diffuse.hpp). Recipes with a map take them;
// others link none of it.
// SPDX-License-Identifier: MIT
#pragma once
#include "../model/along.hpp"
#include "../start/start.hpp"
#include "flux.hpp"
#include "kinetics.hpp"

namespace dapple::evolve {

// Behind the table of kinetics the map.
constexpr uint16_t kMapWords = (sizeof(stencil::DirectionMap) + 3) / 4;

constexpr Reach reach_along(const Model& model, const int32_t* number, bool holds) {
  Reach reach = reach_of_kinetics(model, number, holds);
  ++reach.planes;
  ++reach.kept;
  reach.once = 1;
  reach.halo_rows = stencil::kLinkRows;
  reach.table = static_cast<uint16_t>(table_count + kMapWords);
  return reach;
}
constexpr Reach along_reach(const Model& model, const int32_t* number, uint8_t, const void*) {
  return reach_along(model, number, false);
}
constexpr Reach cascade_along_reach(const Model& model, const int32_t* number, uint8_t, const void*) {
  return reach_along(model, number, true);
}

constexpr Status accepts_along(const int32_t* number, const void* given, const Domain& domain) {
  if (!along::in_range(number)) return bad_recipe;
  const Status status = accepts_image(number[along::map], given);
  return status == ok ? accepts_share(number, given, domain) : status;
}

bool along_next(const Context& context, Cursor& cursor, Sweep& sweep);
bool cascade_along_next(const Context& context, Cursor& cursor, Sweep& sweep);
void prepare_along(const Context& context);

// start=segments of a recipe whose first stage follows a map: along it.
void segments_along_row(const start::Place& place, const Start& start, const grid::Levels& levels, uint8_t plane,
                        uint16_t y, void* row);

inline constexpr Solver along_solver DAPPLE_ROM =
    kinetics_of(along_reach, along_next, prepare_along, kinetics_field, accepts_along, false, Maps::on);
inline constexpr Solver cascade_along_solver DAPPLE_ROM =
    kinetics_of(cascade_along_reach, cascade_along_next, prepare_along, cascade_field, accepts_along, true, Maps::on);

// The solver that does the same along a map, or without one; one that knows no maps itself. Told by what solvers say of
// themselves: for gcc's -fsanitize=undefined it is no constant whether two solvers are the same.
constexpr const Solver* with_map(const Solver* solver, bool map) {
  if (solver->maps == Maps::unknown) return solver;
  if (solver->freezes) return map ? &cascade_along_solver : &cascade_solver;
  return map ? &along_solver : &kinetics_solver;
}

}  // namespace dapple::evolve
