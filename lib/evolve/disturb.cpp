// What a caller may do to a run between two steps. The planes and numbers are those of the grid as it is, so the same
// calls after the same steps give the same bits, however the steps were sliced.
// SPDX-License-Identifier: MIT
#include "along.hpp"
#include "run.hpp"

namespace dapple::evolve {

// Corner tiles and patches share cells with others; cells of one bit have no levels between.
static bool open_to_all(const Run& run) {
  return run.domain.corners == nullptr && run.ground.patches == nullptr && run.field.cell != grid::Cell::bit;
}

static void fill(const Run& run, uint8_t plane, int32_t x, int32_t y, int32_t level) {
  const int32_t width = run.field.width, height = run.field.height;
  if (run.domain.plane && (x < 0 || y < 0 || x >= width || y >= height)) return;
  x = (x % width + width) % width;
  y = (y % height + height) % height;
  start::set_cell(
      {run.field.cell, run.field.width, run.field.height, run.stage.level, 0, 0, run.domain.plane, run.seed},
      row_of(run.field, plane, static_cast<uint16_t>(y)), static_cast<uint16_t>(x), level);
}

// Pixels are the cells of the finest grid; on coarser ones a cell is in where its first pixel is.
Status stamp(Run& run, int32_t x, int32_t y, uint16_t radius, bool on) {
  if (!between_steps(run) || !open_to_all(run)) return not_now;
  if (!within(x, -65535, 65535) || !within(y, -65535, 65535) || radius > kMostStamp) return out_of_range;
  const uint8_t level = run.stage.level;
  if (run.domain.plane) x += run.domain.x - run.ground.x, y += run.domain.y - run.ground.y;
  const int32_t r = radius >> level, cx = x >> level, cy = y >> level;
  for (uint8_t plane = 0; plane < run.model.planes(run.stage.number); ++plane) {
    const grid::Levels levels = run.model.levels(run.stage.number, plane);
    for (int32_t dy = -r; dy <= r; ++dy)
      for (int32_t dx = -r; dx <= r; ++dx)
        if (dx * dx + dy * dy <= r * r) fill(run, plane, cx + dx, cy + dy, on ? levels.disc : levels.background);
  }
  reopen_sweep(run);
  return ok;
}

static bool as_large(const Reach& a, const Reach& b) {
  return a.planes == b.planes && a.kept == b.kept && a.rows16 == b.rows16 && a.rows32 == b.rows32 && a.halo == b.halo &&
         a.radius == b.radius && a.sweeps == b.sweeps && a.once == b.once && a.spread == b.spread && a.table == b.table;
}

Status change(Run& run, uint8_t slot, int32_t value) {
  if (!between_steps(run) || !open_to_all(run) || run.model.bound == unbounded) return not_now;
  if (slot >= kMaxNumbers) return out_of_range;
  Stage& stage = run.stage;
  const auto reach = [&] { return run.solver.reach(run.model, stage.number, stage.level, stage.stored); };
  const Reach before = reach();
  const int32_t old = stage.number[slot];
  stage.number[slot] = value;
  const auto accepts = run.solver.accepts;
  const bool fits = run.model.in_range(stage.number) && as_large(before, reach());
  const bool good = fits && (accepts == nullptr || accepts(stage.number, stage.stored, run.domain) == ok);
  const bool placed = slot >= along::map && run.solver.maps != Maps::on;  // it would take another solver
  const bool laid = placed || (run.step > 0 && is_laid(run.solver, stage.number, slot));
  Status status = !good ? out_of_range : laid ? not_now : ok;
  if (status == ok) {
    const Bound bound = run.model.bound(stage.number, stage.level);
    if (!within(stage.number[bound.slot], bound.low, bound.high)) status = unstable;
  }
  if (status != ok) stage.number[slot] = old;
  if (status == ok) prepare_stage(run);
  return status;
}

// A window's halo is used up when it is done.
Status go_on(Run& run, uint32_t steps, uint64_t& rows) {
  if (run.phase != Phase::done || run.domain.plane || !open_to_all(run)) return not_now;
  if (steps > kMaxSteps || run.stage.steps > kMaxSteps - steps) return out_of_range;
  const Reach reach = run.solver.reach(run.model, run.stage.number, run.stage.level, run.stage.stored);
  rows = static_cast<uint64_t>(steps) * reach.sweeps * run.field.height;
  if (run.step == 0 && steps > 0) rows += static_cast<uint64_t>(reach.once) * run.field.height;
  run.index = static_cast<uint8_t>(run.plan.stages - 1);
  run.stage.steps += steps;
  run.clock.steps += steps;
  run.phase = Phase::sweeping;
  advance(run, 0);
  return ok;
}

}  // namespace dapple::evolve
