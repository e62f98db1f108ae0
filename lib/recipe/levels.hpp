// Coarse to fine as one word (Witkin & Kass 1991, 5.2): solver=multigrid, or levels=L fine=F. The run begins on the coarsest
// grid and is interpolated onto the next finer one for its last F steps, and so on; every grid takes the Gaussian passes
// of its own spacing, in which a step costs a pass or two less.
// SPDX-License-Identifier: MIT
#pragma once
#include "reader.hpp"

namespace dapple::recipe {

constexpr uint32_t kMostSteps = 1000000, kMostFine = 100000;
constexpr uint32_t kFineSteps = 6;                      // on each finer grid, if fine= is not given
constexpr int32_t kCoarsestWave = 7 * base::kMicro;     // cells: below, stripes turn towards the axes of the grid
constexpr const char* kMultigrid = "multigrid";

// The longest wavelength there is leaves no fifth grid to resolve it.
constexpr int32_t longest_wave() {
  int32_t number[kMaxNumbers] = {};
  number[threshold::scale] = threshold::kScale[1];
  number[threshold::ratio] = threshold::kRatio[1];
  return threshold::wavelength(number);
}
static_assert(kMaxStages == kMaxLevel + 1 && longest_wave() >> (kMaxLevel + 1) < kCoarsestWave, "");

// Total steps of the recipe: what `steps=` of an override means, whatever levels it runs on.
constexpr uint32_t total_steps(const Recipe& r) {
  uint32_t sum = 0;
  for (uint8_t i = 0; i < r.stages; ++i) sum += r.stage[i].steps;
  return sum;
}

// The grids that resolve a stage's pattern and leave steps for the coarsest.
constexpr uint8_t levels_for(const Stage& stage, uint32_t total, uint32_t fine) {
  const int32_t wave = stage.model->wavelength(stage.number);
  uint8_t levels = 1;
  while (levels <= kMaxLevel && wave >> levels >= kCoarsestWave && total > fine * levels) ++levels;
  return levels;
}

// A run over so many grids, of what the first stage holds.
constexpr void lay_levels(Recipe& recipe, uint8_t levels, uint32_t fine) {
  const uint32_t total = total_steps(recipe);
  recipe.stages = levels;
  for (uint8_t i = 0; i < levels; ++i) {
    recipe.stage[i] = recipe.stage[0];
    recipe.stage[i].level = static_cast<uint8_t>(levels - 1 - i);
    recipe.stage[i].entry = i == 0 ? Entry::start : Entry::refine;
    recipe.stage[i].refine = i == 0 ? nullptr : evolve::refine_row;
    recipe.stage[i].steps = fine;
  }
  recipe.stage[0].steps = total - fine * (levels - 1u);
}

// Whether the stages are what lay_levels makes of a family's first solver: what solver=multigrid stands for.
constexpr bool is_multigrid(const Recipe& recipe, const Family& f) {
  if (recipe.stages < 2 || index_of(word_of(kMultigrid), f.solver_names) < 0 || recipe.stage[0].steps == 0) return false;
  for (uint8_t i = 0; i < recipe.stages; ++i) {
    const Stage& s = recipe.stage[i];
    if (s.level + i + 1 != recipe.stages || s.solver != f.solvers[0] || (i > 0 && s.entry != Entry::refine)) return false;
    if (i > 1 && s.steps != recipe.stage[1].steps) return false;
    for (uint8_t k = 0; k < kMaxNumbers; ++k)
      if (s.number[k] != recipe.stage[0].number[k]) return false;
  }
  return recipe.stage[1].steps > 0 && recipe.stage[1].steps <= kMostFine && total_steps(recipe) <= kMostSteps;
}

// levels=L fine=F: the run's steps, all but F on each finer grid, on the coarsest. Another solver named for a recipe that
// was solver=multigrid takes it back to one grid.
constexpr bool spread_levels(Reader& r, Word all) {
  Recipe& recipe = *r.recipe;
  const uint32_t total = total_steps(recipe), fine = r.fine == 0 ? kFineSteps : r.fine;
  if (r.levels == 0 && r.multigrid) r.levels = levels_for(recipe.stage[0], total, fine);
  else if (r.levels == 0 && r.solver_given && r.was_multigrid) r.levels = 1;
  else if (r.levels == 0) return r.fine == 0 || fail(r, not_possible, all);
  if (total <= fine * (r.levels - 1)) return fail(r, not_possible, all);
  lay_levels(recipe, static_cast<uint8_t>(r.levels), fine);
  return true;
}

}  // namespace dapple::recipe
