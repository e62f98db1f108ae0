// Corner tiles: the sixteen tiles of grid/corners.hpp, grown as one torus. Between the sweeps of a solver come sweeps that make
// cells agree which may come to lie on one place of the plane: those near a corner of one colour, near an edge between two.
//
// Where the reaction is a sweep of its own the tiles share it and nothing else: in a band around the edges it is on where the
// mean of the shading field over the class is above rho. Concentrations, a smooth filter of it, are left alone, and so no
// crease comes of it. Other solvers blend their planes now and then, towards the first tile of a class. At the end all planes
// are blended, with weights of which two cells either side of an edge have none of their own: those agree bit for bit.
// SPDX-License-Identifier: MIT
#pragma once
#include "../grid/corners.hpp"
#include "../start/start.hpp"
#include "run.hpp"

namespace dapple::evolve {

struct Corners {
  // In place of the solver's own `next`.
  bool (*next)(const Context& context, const Solver& solver, const Start& start, Cursor& cursor, Sweep& sweep);
  // One row of the start.
  void (*start_row)(const start::Place& place, const Start& start, const Solver& solver, const Context& context, uint8_t plane,
                    uint16_t y, void* row);
};

// Whether a stage grows all tiles by the same rule.
constexpr bool treats_alike(const Stage& s) {
  return s.solver->sharing != Sharing::none && (s.solver->alike == nullptr || s.solver->alike(s.number));
}

constexpr uint16_t tile_side(const Ground& ground, uint8_t level) {
  return at_level(static_cast<uint16_t>(ground.width / grid::kTilesAcross), level);
}

// Half the width of the bands around the edges, in percent of the wavelength: wide until .3 of the run, narrow from .7 on, so
// that no pattern forms along the edges first; seeds agree in a narrow band only. The last blend keeps well within the band in
// which the reaction was shared: what it has to make equal dies away inwards from the band's border.
struct BandWidth {
  uint8_t wide, narrow, blend;
};
constexpr BandWidth band_width(Sharing sharing, Start::Kind start) {
  if (sharing == Sharing::state) return {135, 90, 90};
  return start == Start::noise ? BandWidth{125, 90, 50} : BandWidth{75, 75, 50};
}

constexpr uint8_t kThinnestBand = 4;  // cells: two that agree, two of passage

// In percent of the wavelength, at a step.
constexpr int32_t percent_at(BandWidth width, Clock clock) {
  const int64_t all = clock.steps, at = 10 * static_cast<int64_t>(clock.step);
  const int64_t left = at <= 3 * all ? 4 * all : at >= 7 * all ? 0 : 7 * all - at;  // of 4 all
  return static_cast<int32_t>(width.narrow + (width.wide - width.narrow) * left / (all > 0 ? 4 * all : 1));
}

// In cells of the stage's grid, at most .45 of the tile's side.
constexpr uint16_t band_of(const Model& model, const int32_t* number, int32_t percent, uint16_t side, uint8_t level) {
  const int64_t cells = (static_cast<int64_t>(model.wavelength(number)) * percent / (100 * INT64_C(1000000))) >> level;
  const int64_t most = static_cast<int64_t>(side) * 45 / 100;
  const int64_t thick = cells < kThinnestBand ? kThinnestBand : cells;
  return static_cast<uint16_t>(thick > most ? most : thick);
}

// Rows of scratch a stage needs beside the solver's: the shading field of four rows.
constexpr uint8_t corner_rows(const Solver& solver) { return solver.sharing == Sharing::reaction ? 4 : 0; }

// Sweeps more of a stage, of which each is as many rows of work as a tile has: the start's, one a step or a blend now and then,
// and the last blend. `before` of `all` steps come before the stage.
constexpr uint32_t corner_sweeps(const Solver& solver, uint32_t steps, uint32_t before, uint32_t all, Start::Kind start) {
  if (steps == 0) return 0;
  const uint32_t after = before + steps, every = solver.sharing_steps;
  uint32_t sweeps = before == 0 && start == Start::noise ? 1 : 0;
  sweeps += solver.sharing == Sharing::reaction ? steps : after / every - before / every;
  if (after == all && (solver.sharing == Sharing::reaction || all % every != 0)) ++sweeps;
  return sweeps;
}

bool corners_next(const Context& context, const Solver& solver, const Start& start, Cursor& cursor, Sweep& sweep);
void corners_start_row(const start::Place& place, const Start& start, const Solver& solver, const Context& context, uint8_t plane,
                       uint16_t y, void* row);
inline constexpr Corners corners DAPPLE_ROM = {corners_next, corners_start_row};

}  // namespace dapple::evolve
