// Explicit kinetics whose pattern differs from place to place: the solvers of kinetics.hpp, but that diffusion is
// stretched along the direction of every cell, which a plane behind their own holds (stencil/diffuse.hpp), or is a share
// of the recipe's, which another holds: the wavelength goes with its root. Recipes with a map or a grade take them; others
// link none of it.
// SPDX-License-Identifier: MIT
#pragma once
#include "../model/along.hpp"
#include "../start/start.hpp"
#include "flux.hpp"
#include "kinetics.hpp"

namespace dapple::evolve {

// Behind the table of kinetics where the pictures are, then the map, whose places the grade has too.
constexpr uint16_t kMapWords = (sizeof(stencil::DirectionMap) + 3) / 4;

constexpr bool has_map(const int32_t* number) { return number[along::map] != mapped::none; }
constexpr bool has_grade(const int32_t* number) { return number[along::grade] != along::none; }
constexpr uint8_t planes_along(const int32_t* number) {
  return static_cast<uint8_t>((has_map(number) ? 1 : 0) + (has_grade(number) ? 1 : 0));
}

constexpr Reach with_planes(Reach reach, const int32_t* number) {
  reach.planes = static_cast<uint8_t>(reach.planes + planes_along(number));
  reach.kept = static_cast<uint8_t>(reach.kept + planes_along(number));
  reach.once = 1;
  reach.halo_rows = has_map(number) ? uint8_t{stencil::kLinkRows} : uint8_t{0};
  reach.table = static_cast<uint16_t>(table_count + kPictureWords + kMapWords);
  return reach;
}
constexpr Reach along_reach(const Model& model, const int32_t* number, uint8_t, const void*) {
  return with_planes(reach_of_kinetics(model, number, false), number);
}
constexpr Reach cascade_along_reach(const Model& model, const int32_t* number, uint8_t, const void*) {
  return with_planes(reach_of_kinetics(model, number, true), number);
}
constexpr Reach pictured_along_reach(const Model& model, const int32_t* number, uint8_t, const void*) {
  return with_planes(reach_of_pictured(model, number), number);
}

constexpr Status accepts_along(const int32_t* number, const void* given, const Domain& domain) {
  if (!along::in_range(number)) return bad_recipe;
  Status status = accepts_image(number[along::map], given);
  if (status == ok && number[along::grade] == along::image)
    status = given == nullptr ? bad_map : accepts_grey(static_cast<const PlaceMaps*>(given)->lengths);
  return status == ok ? accepts_share(number, given, domain) : status;
}
constexpr Status accepts_pictured_along(const int32_t* number, const void* given, const Domain& domain) {
  const Status status = accepts_picture(number, given, domain);
  return status == ok ? accepts_along(number, given, domain) : status;
}

bool along_next(const Context& context, Cursor& cursor, Sweep& sweep);
bool cascade_along_next(const Context& context, Cursor& cursor, Sweep& sweep);
bool pictured_along_next(const Context& context, Cursor& cursor, Sweep& sweep);
void prepare_along(const Context& context);
void prepare_pictured_along(const Context& context);

// start=segments of a recipe whose first stage follows a map: along it.
void segments_along_row(const start::Place& place, const Start& start, const grid::Levels& levels, uint8_t plane,
                        uint16_t y, void* row);

inline constexpr Solver along_solver DAPPLE_ROM =
    kinetics_of(along_reach, along_next, prepare_along, kinetics_field, accepts_along, false, Maps::on);
inline constexpr Solver cascade_along_solver DAPPLE_ROM =
    kinetics_of(cascade_along_reach, cascade_along_next, prepare_along, cascade_field, accepts_along, true, Maps::on);

inline constexpr Solver pictured_along DAPPLE_ROM =
    kinetics_of(pictured_along_reach, pictured_along_next, prepare_pictured_along, kinetics_field,
                accepts_pictured_along, false, Maps::on, true);

// The solver that does the same from place to place, or everywhere; one that knows no places itself. Told by what solvers
// say of themselves: for gcc's -fsanitize=undefined it is no constant whether two solvers are the same. grown: both that
// grow by a picture, if there are any: they come with the family.
constexpr const Solver* with_places(const Solver* solver, bool places, const Solver* const* grown) {
  if (solver->maps == Maps::unknown) return solver;
  if (solver->pictured) return grown[places ? 1 : 0];
  if (solver->freezes) return places ? &cascade_along_solver : &cascade_solver;
  return places ? &along_solver : &kinetics_solver;
}

// Numbers that the first sweep of a stage lays into planes: from its second step on they are what they were.
constexpr bool is_laid(const Solver& solver, const int32_t* number, uint8_t slot) {
  const bool turns = slot == kinetics::angle && solver.maps == Maps::on && has_map(number);
  const bool grows = solver.pictured && (slot == turing::growth || slot == turing::dark || slot == turing::lit);
  return slot == kinetics::vary || slot >= along::map || turns || grows;
}

}  // namespace dapple::evolve
