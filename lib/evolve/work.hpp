// The work of a stage, counted before it is done: what a benchmark measures and `dapple info` prints, exactly.
// SPDX-License-Identifier: MIT
#pragma once
#include "run.hpp"

namespace dapple::evolve {

// How often a step writes a cell, all planes together: reaction and passes of the Gaussian, sub-steps of Euler, one for a
// step of any other solver in every plane.
constexpr uint32_t updates_of_step(const Solver& solver, const Model& model, const int32_t* number, uint8_t level,
                                   const void* given) {
  const uint8_t planes = model.planes(number);
  if (solver.next != gaussian_next) return static_cast<uint32_t>(solver.reach(model, number, level, given).sweeps) * planes;
  uint32_t updates = planes;
  for (uint8_t plane = 0; plane < planes; ++plane) {
    const stencil::Lattice lattice = stencil::lattice_of(grid::at_level(model.tensor(number, plane), level));
    for (uint8_t i = 0; i < lattice.count; ++i) {
      stencil::PassSeries series = stencil::series_of(lattice.direction[i].share, 0);
      for (stencil::Pass pass{}; stencil::next_pass(series, pass);) ++updates;
    }
  }
  return updates;
}

// Cells written over a whole stage on a torus, its start or its refinement too.
constexpr uint64_t updates_of(const Stage& stage, uint16_t width, uint16_t height) {
  const uint64_t cells = static_cast<uint64_t>(at_level(width, stage.level)) * at_level(height, stage.level);
  const uint64_t first = same_grid(stage.entry) ? 0 : stage.model->planes(stage.number);
  const uint32_t updates = updates_of_step(*stage.solver, *stage.model, stage.number, stage.level, stage.stored);
  return cells * (first + static_cast<uint64_t>(stage.steps) * updates);
}

}  // namespace dapple::evolve
