// The work of solvers against resolution and wavelength, exactly: Witkin & Kass 1991, section 5.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "grow.hpp"

namespace {

uint64_t updates_of(const dapple::Recipe& recipe, uint16_t side) {
  uint64_t sum = uint64_t{side} * side;  // the field, once
  for (uint8_t i = 0; i < recipe.stages; ++i) sum += dapple::evolve::updates_of(recipe.stage[i], side, side);
  return sum;
}

// The picture of a preset with 17 waves across the side.
dapple::Recipe picture(const char* preset, int side, const std::string& changes) {
  const std::string text = "wavelength=" + std::to_string(side * 60 / 1024.0) + " " + changes;
  const dapple::Recipe recipe = tests::preset_with(preset, text.c_str());
  REQUIRE(recipe.stages > 0);
  return recipe;
}

// The exponent of work in the side, least squares of logarithms over doublings from `least` to `most`.
template <class F> double exponent(int least, int most, F recipe_at) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (int side = least; side <= most; side *= 2) {
    const double x = std::log2(side), y = std::log2(double(updates_of(recipe_at(side), static_cast<uint16_t>(side))));
    n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

uint32_t step_of(const dapple::Recipe& recipe) {
  const dapple::Stage& stage = recipe.stage[0];
  return dapple::evolve::updates_of_step(*stage.solver, *stage.model, stage.number, stage.level, stage.stored);
}

}  // namespace

TEST_CASE("solvers: exponents of the work, 64 to 1024, the picture held") {
  const auto with = [](const char* changes) { return [=](int side) { return picture("zebra", side, changes); }; };
  const double euler = exponent(64, 1024, with("solver=euler")), late = exponent(256, 1024, with("solver=euler"));
  CHECK((euler > 3.75 && euler < 4.05));
  CHECK((late > 3.9 && late < 4.05));
  const double gaussian = exponent(64, 1024, with("solver=gaussian"));
  CHECK((gaussian > 1.95 && gaussian < 2.6));  // r^2 log r
  const double multigrid = exponent(64, 1024, with("solver=multigrid"));
  CHECK((multigrid > 1.75 && multigrid < 2.25));
  const double binary = exponent(128, 512, [](int side) {
    return picture("zebra-bits", side, side == 128 ? "level=0" : side == 256 ? "level=1" : "level=2");
  });
  CHECK((binary > 0 && binary < 2.05));
}

// r^2 log r to the letter: work a pixel, per doubling of the resolution, grows by a constant and no more.
TEST_CASE("solvers: the Gaussian's work a pixel grows by the logarithm of the resolution") {
  double before = 0;
  for (int side = 64; side <= 1024; side *= 2) {
    const dapple::Recipe recipe = picture("zebra", side, "");
    const double work = double(updates_of(recipe, static_cast<uint16_t>(side))) / side / side / recipe.stage[0].steps;
    CHECK((side == 64 || (work > before && work - before <= 13)));  // two planes, three directions, two passes, rounding
    before = work;
  }
}

TEST_CASE("solvers: a Gaussian step costs no more than the logarithm of the wavelength, 8 to 64 cells") {
  const struct {
    const char* shape;
    int directions;
  } shapes[] = {{"diffusion=isotropic ratio=2", 2}, {"ratio=2 stretch=2 angle=20", 3}, {"ratio=2 stretch=3 angle=60", 3}, {"ratio=3 stretch=5", 2}};
  for (const auto& [shape, directions] : shapes) {
    CAPTURE(shape);
    const std::string all = std::string("threshold ") + shape;
    const auto cost = [&](double wave) {
      const dapple::Recipe recipe = tests::recipe_of((all + " wavelength=" + std::to_string(wave)).c_str());
      REQUIRE(recipe.stages == 1);
      return step_of(recipe);
    };
    const uint32_t least = cost(8);
    for (double wave = 8; wave <= 64; wave += 0.25) {
      CAPTURE(wave);
      // Two planes, their directions, two passes an octave, and half a pass because their number is whole: strides of 5, 6,
      // 7 ... throughout would need more than one pass.
      CHECK(cost(wave) <= least + 2 * directions * (2 * std::log2(wave / 8) + 0.5));
    }
    const dapple::Recipe euler = tests::recipe_of((all + " solver=euler wavelength=64").c_str());
    CHECK(step_of(euler) > 8 * cost(64));
  }
}

TEST_CASE("solvers: the count is what is done") {
  // Every sweep of a grid writes as many rows as rows_done counts; a chain is one sweep of several passes.
  const dapple::Recipe euler = tests::preset_with("weave", "solver=euler steps=3");
  const dapple::Need need = dapple::need_for(euler, dapple::torus(64, 48));
  CHECK(dapple::evolve::updates_of(euler.stage[0], 64, 48) == (need.rows - 4 * 48) * 64 * 4 + 4 * 64 * 48);
  // The reaction is one sweep over all planes, and all passes along the rows are one; other passes are a sweep each.
  const dapple::Recipe diagonal = tests::recipe_of("threshold angle=45 stretch=2 scale=2 steps=5");
  uint32_t chained = 0;
  for (uint8_t plane = 0; plane < 2; ++plane) {
    const auto lattice = dapple::stencil::lattice_of(dapple::threshold::tensor(diagonal.stage[0].number, plane));
    for (uint8_t i = 0; i < lattice.count; ++i) {
      if (lattice.direction[i].vy != 0) continue;
      dapple::stencil::PassSeries series = dapple::stencil::series_of(lattice.direction[i].share, 0);
      uint32_t passes = 0;
      for (dapple::stencil::Pass pass{}; dapple::stencil::next_pass(series, pass);) ++passes;
      chained += passes - 1;
    }
  }
  const dapple::Need rows = dapple::need_for(diagonal, dapple::torus(64, 64));
  CHECK(step_of(diagonal) == rows.sweeps / 5 - 1 + 2 + chained);
}
