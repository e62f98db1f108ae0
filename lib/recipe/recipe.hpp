// A recipe: start, stages, paint. And the families it can be made of; adding a model adds one line to `families`.
// SPDX-License-Identifier: MIT
#pragma once
#include "../evolve/along.hpp"
#include "../evolve/blocks.hpp"
#include "../evolve/convolution.hpp"
#include "../evolve/flux.hpp"
#include "../evolve/kinetics.hpp"
#include "../evolve/refine.hpp"
#include "../evolve/run.hpp"
#include "../evolve/steering.hpp"
#include "../model/brusselator.hpp"
#include "../model/cells.hpp"
#include "../model/fitzhugh_nagumo.hpp"
#include "../model/gray_scott.hpp"
#include "../model/meinhardt_spots.hpp"
#include "../model/meinhardt_stripes.hpp"
#include "../model/schnakenberg.hpp"
#include "../model/threshold.hpp"
#include "../model/turing.hpp"
#include "../paint/paint.hpp"

namespace dapple {

// What a recipe says of the sides of its domain: a patch (patch_of) unless all repeat.
struct Sides {
  enum Kind : uint8_t { repeat, closed, fixed } kind[kSides];
  int32_t held[2];  // Side::value of the fixed ones
};

struct Recipe {
  Start start;
  Paint paint;
  uint8_t stages;
  Stage stage[kMaxStages];
  const evolve::BlockWork* blocks;  // how windows of the plane that a halo would be too wide for are grown; null: not at all
  Sides sides;
};

constexpr bool has_sides(const Recipe& recipe) {
  for (const Sides::Kind kind : recipe.sides.kind)
    if (kind != Sides::repeat) return true;
  return false;
}

// The patch that a recipe's sides ask for: the only one of its Patches.
constexpr Patch patch_of(const Recipe& recipe) {
  const Sides& s = recipe.sides;
  Patch patch{};
  for (uint8_t i = 0; i < kSides; ++i)
    patch.side[i] = s.kind[i] == Sides::repeat   ? repeating_side(i)
                    : s.kind[i] == Sides::closed ? closed_side()
                                                 : fixed_side(s.held[0], s.held[1]);
  return patch;
}

// A recipe that lives in read-only memory (flash on AVR).
struct Preset {
  Recipe recipe;
};

}  // namespace dapple

namespace dapple::recipe {

constexpr bits::Living any_number(const int32_t*) { return {INT32_MIN, INT32_MAX}; }

// What makes spots as they are asked for, measured (tests/reference/dials.cpp).
struct Dials {
  uint32_t settled;  // steps per scale^2 after which spots stay
};

// A model as text knows it: names, numbers, solvers (the first is the default), start and numbers of paint to begin with.
struct Family {
  const char* name;
  const Model* model;
  const Number* numbers;
  uint8_t number_count;
  const char* solver_names;  // separated by '|'; multigrid is the first one over several grids (levels.hpp)
  const evolve::Solver* solvers[4];
  uint32_t steps;
  Start start;
  int32_t low, high;
  uint8_t level = 0;
  bits::Living (*living)(const int32_t* number) = any_number;   // the thresholds rho between which a pattern lives
  bits::Living (*lengths)(const int32_t* number) = any_number;  // the range of scale, where it depends on other numbers
  int32_t (*grown)(const int32_t* number) = nullptr;        // coarse models: the wavelength these numbers grow
  const evolve::BlockWork* blocks = nullptr;
  uint8_t freezing = 0;  // which solver runs a stage that begins with `then freeze` or `then reset`; 0: none
  Dials dials = {0};             // of families that take aspect and spot_size
  const Model* compact = model;  // cells=compact: the same in half of the memory; the model itself where there is none
};

// Explicit kinetics also have the numbers of a map, in the slots from along::map on.
constexpr uint8_t map_numbers(const Family& f) { return f.freezing > 0 ? along::kNumbers : uint8_t{0}; }

// A family of explicit kinetics.
constexpr Family kinetics_family(const char* name, const Model* model, const Number* numbers, uint8_t count, uint32_t steps, Start start,
                                 int32_t low, int32_t high) {
  return {name, model, numbers, count, "plain|cascade", {&evolve::kinetics_solver, &evolve::cascade_solver}, steps, start, low, high, 0,
          any_number, any_number, nullptr, nullptr, 1};
}
constexpr Family of_spots(Family family, Dials dials, const Model* compact) {
  family.dials = dials;
  family.compact = compact;
  return family;
}
// And one whose rate a picture can set, with or without places.
constexpr uint8_t kPictured = 2;
constexpr Family with_picture(Family family) {
  family.solver_names = "plain|cascade|pictured";
  family.solvers[kPictured] = &evolve::pictured;
  family.solvers[kPictured + 1] = &evolve::pictured_along;
  return family;
}
constexpr Start kNoise = {Start::noise, 32000000, 600000, 250000, 4000000, 1000000, start::noise_row};

template <uint8_t n> constexpr uint8_t count_of(const Number (&)[n]) { return n; }

inline constexpr Family families[] = {
    {"threshold", &threshold_model, threshold::numbers, count_of(threshold::numbers), "gaussian|euler|multigrid",
     {&evolve::gaussian, &evolve::euler}, 32,
     kNoise, -50000, 50000, 0, any_number, any_number, nullptr, evolve::in_blocks},
    {"mapped", &mapped_model, mapped::numbers, count_of(mapped::numbers), "flux|lean|styled|surface",
     {&evolve::flux, &evolve::lean_flux, &evolve::styled, &evolve::surface}, 32,
     kNoise, -50000, 50000},
    {"gray-scott", &gray_scott_model, gray_scott::numbers, count_of(gray_scott::numbers), "kinetic",
     {&evolve::kinetic, nullptr}, 5000,
     {Start::seeds, 40000000, 600000, 350000, 5000000, 1000000, start::seeds_row}, 0, 350000},
    of_spots(with_picture(kinetics_family("turing", &turing_model, turing::numbers, count_of(turing::numbers), 4000, kNoise, 2500000, 9500000)), {60}, &compact_turing_model),
    of_spots(kinetics_family("meinhardt-spots", &meinhardt_spots_model, meinhardt_spots::numbers, count_of(meinhardt_spots::numbers), 3400, kNoise, 0, 5000000), {700}, &compact_meinhardt_spots_model),
    kinetics_family("meinhardt-stripes", &meinhardt_stripes_model, meinhardt_stripes::numbers, count_of(meinhardt_stripes::numbers), 2000, kNoise, 0, 1900000),
    kinetics_family("fitzhugh-nagumo", &fitzhugh_nagumo_model, fitzhugh_nagumo::numbers, count_of(fitzhugh_nagumo::numbers), 2000, kNoise, -1000000, 1000000),
    kinetics_family("schnakenberg", &schnakenberg_model, schnakenberg::numbers, count_of(schnakenberg::numbers), 8000, kNoise, 200000, 2500000),
    kinetics_family("brusselator", &brusselator_model, brusselator::numbers, count_of(brusselator::numbers), 4000, kNoise, 0, 2000000),
    {"bits", &bits_model, bits::numbers, count_of(bits::numbers), "sliced|lean",
     {&evolve::sliced, &evolve::lean}, 10,
     {Start::noise, 26000000, 875000, 300000, 5200000, 1000000, start::noise_row}, -950000, 950000, 1, bits::living, bits::lengths, evolve::grown_wavelength},
    {"flow", &flow_model, flow::numbers, count_of(flow::numbers), "steered",
     {&evolve::steered, nullptr}, 12,
     {Start::noise, 26000000, 875000, 300000, 5200000, 1000000, start::noise_row}, -920000, 920000, 1, flow::living, flow::lengths, evolve::steered_wavelength},
    {"cells", &cells_model, cells::numbers, count_of(cells::numbers), "direct",
     {&evolve::direct, nullptr}, 64,
     {Start::noise, 32000000, 875000, 300000, 6400000, 1000000, start::noise_row}, 0, 1000000},
};

// What text may begin with: all families, or those of a port's own list, which then links no others.
struct Families {
  const Family* first;
  uint8_t count;
};
inline constexpr Families kFamilies = {families, sizeof families / sizeof families[0]};

}  // namespace dapple::recipe
