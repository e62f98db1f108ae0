// The stepper: an explicit state machine over phases, stages, steps, sweeps, bands and rows.
// SPDX-License-Identifier: MIT
#include "corners.hpp"

namespace dapple::evolve {

using base::rom_load;

static Stage load_stage(const Plan& plan, uint8_t index) {
  return plan.rom ? rom_load(plan.stage + index) : plan.stage[index];
}
static Start load_start(const Plan& plan) { return plan.rom ? rom_load(plan.start) : *plan.start; }

static void set_level(Run& run, uint8_t level) {
  run.field.width = at_level(run.ground.width, level);
  run.field.height = at_level(run.ground.height, level);
  run.field.row_bytes = grid::row_bytes(run.field.cell, run.field.width);
}

// The steps of the stages that continue each other into and out of stage `index`: schedules run over all of them.
static void set_clock(Run& run) {
  if (run.stage.entry == Entry::start) run.clock.step = 0;
  run.clock.steps = run.clock.step + run.stage.steps;
  for (uint8_t i = static_cast<uint8_t>(run.index + 1); i < run.plan.stages; ++i) {
    const Stage next = load_stage(run.plan, i);
    if (next.entry == Entry::start) break;
    run.clock.steps += next.steps;
  }
}

static Context context_of(const Run& run) {
  return {&run.model, run.stage.number, run.kernels, run.table, run.clock, run.stage.level, &run.ground, run.domain.plane, run.seed, run.stage.stored, run.step == 0, run.stage.entry};
}

// Makes the stage's model, solver and grid current. A refined stage keeps the coarse grid until it is refined.
DAPPLE_APART static void open_stage(Run& run) {
  run.stage = load_stage(run.plan, run.index);
  run.model = rom_load(run.stage.model);
  run.solver = rom_load(run.stage.solver);
  run.step = 0;
  run.cursor.sweep = 0;
  run.cursor.part = 0;
  run.sweep.row = nullptr;
  run.at_plane = 0;
  run.field_radius = run.kept = 0;
  run.clock.level = run.stage.level;
  if (run.solver.field != nullptr) {
    const Reach reach = run.solver.reach(run.model, run.stage.number, run.stage.level, run.stage.stored);
    run.field_radius = reach.field_radius;
    run.field_space = reach.space;
    run.kept = reach.kept;
  }
  set_clock(run);
  if (run.solver.prepare != nullptr) run.solver.prepare(context_of(run));
  run.phase = Phase::sweeping;
  if (run.stage.entry == Entry::start) {
    set_level(run, run.stage.level);
    run.ghosts.made = false;
    run.phase = Phase::starting;
    run.at_row = 0;
  } else if (run.stage.entry == Entry::refine) {
    run.phase = Phase::refining;
    run.at_row = run.field.height;
  }
}

void begin(Run& run, const Setup& setup) {
  const Parts& parts = setup.parts;
  run.plan = setup.plan;
  run.domain = setup.domain;
  run.ground = setup.ground;
  run.spent = 0;
  run.seed = setup.seed;
  run.kernels = setup.kernels;
  run.driver = setup.driver;
  const Model model = rom_load(load_stage(run.plan, 0).model);
  run.field.cell = model.cell;
  const uint8_t finest = load_stage(run.plan, static_cast<uint8_t>(run.plan.stages - 1)).level;
  run.field.plane_bytes = grid::row_bytes(model.cell, at_level(run.ground.width, finest)) * at_level(run.ground.height, finest);
  run.field.planes = setup.memory;
  run.field.scratch = setup.memory + parts.planes + (parts.frugal ? parts.table + parts.bands : 0);
  run.field.band_bytes = parts.scratch / setup.bands;
  run.field.bands = setup.bands;
  uint8_t* const table = parts.frugal ? setup.memory + parts.planes : run.field.scratch + parts.scratch;
  run.table = reinterpret_cast<int32_t*>(table);
  run.band = reinterpret_cast<Band*>(table + parts.table);
  run.ghosts = setup.ghosts;
  if (run.ghosts.planes == nullptr) run.ghosts.planes = setup.memory;
  run.ghosts.entry = reinterpret_cast<uint32_t*>(table + parts.table + parts.bands);
  run.ghosts.sealed = false;
  run.parts = 0;
  run.rows = 0;
  run.index = 0;
  run.clock = {};
  open_stage(run);
}

// What is at work has come to its end: sweeps are next.
static void end_part(Run& run, bool sealed) {
  run.phase = Phase::sweeping;
  run.ghosts.sealed = sealed;
  ++run.parts;
}

DAPPLE_APART static void start_one_row(Run& run) {
  const Start start = load_start(run.plan);
  const uint8_t level = run.stage.level;
  const start::Place place = {run.field.cell,      run.field.width,     run.field.height, level,
                              run.ground.x >> level, run.ground.y >> level, run.domain.plane,   run.seed, run.table};
  uint8_t* row = row_of(run.field, run.at_plane, run.at_row);
  if (run.domain.corners != nullptr) {
    rom_load(run.domain.corners).start_row(place, start, run.solver, context_of(run), run.at_plane, run.at_row, row);
  } else {
    const grid::Levels levels = run.model.levels(run.stage.number, run.at_plane);
    start.row(place, start, levels, run.at_plane, run.at_row, row);
  }
  if (++run.at_row < run.field.height) return;
  run.at_row = 0;
  if (++run.at_plane == run.model.planes(run.stage.number)) end_part(run, false);
}

DAPPLE_APART static void refine_one_row(Run& run) {
  --run.at_row;
  const uint8_t planes = run.model.planes(run.stage.number);
  for (uint8_t plane = 0; plane < planes; ++plane) run.stage.refine(run.field, plane, run.at_row);
  if (run.at_row > 0) return;
  set_level(run, run.stage.level);
  run.ghosts.made = false;
  end_part(run, false);
}

// On the plane, what the sweeps of a step need not compute: the part of the halo that is used up once the step is done.
static void set_margin(Run& run, bool first) {
  if (!first && run.step > 0) return;  // only first steps have sweeps of their own before the others
  run.sweep.margin = 0;
  if (!run.domain.plane || run.ground.patches != nullptr) return;
  const Reach reach = run.solver.reach(run.model, run.stage.number, run.stage.level, run.stage.stored);
  if (first) run.spent = static_cast<uint16_t>(run.spent + (reach.spread << run.stage.level));
  const bool whole = run.sweep.radius == 0;  // what a sweep without neighbours leaves out, the next would read
  if (leaves_margin(reach) && !whole) run.sweep.margin = at_level(run.spent, run.stage.level);
}

static void seal_one_row(Run& run) {
  run.ghosts.seal(run);
  if (++run.at_row < run.field.height) return;
  run.ghosts.made = true;
  end_part(run, true);
}

static bool next_sweep(Run& run) {
  run.sweep.tile = 0;
  if (run.domain.corners == nullptr) return run.solver.next(context_of(run), run.cursor, run.sweep);
  return rom_load(run.domain.corners).next(context_of(run), run.solver, load_start(run.plan), run.cursor, run.sweep);
}

bool take_sweep(Run& run) {
  const bool first = run.cursor.sweep == 0;
  if (next_sweep(run)) {
    set_margin(run, first);
    return true;
  }
  run.sweep.row = nullptr;
  run.cursor.sweep = 0;
  ++run.step;
  ++run.clock.step;
  return false;
}

// The next sweep of the step, the next step, the next stage: whatever comes now that no sweep is under way.
DAPPLE_APART static void open_sweep(Run& run) {
  if (run.step == run.stage.steps) {
    if (++run.index == run.plan.stages)
      run.phase = Phase::done;
    else
      open_stage(run);
    return;
  }
  if (!take_sweep(run)) return;
  run.at_band = 0;
  begin_sweep(run.field, run.sweep, run.band);
}

// A step that the driver, if there is one, does as a whole: its rows of work.
static uint32_t driven(Run& run, uint32_t rows) {
  if (run.driver == nullptr || run.cursor.sweep != 0 || run.step == run.stage.steps) return 0;
  if (run.domain.corners != nullptr || run.ghosts.seal != nullptr) return 0;
  return run.driver->step(*run.driver, run, rows);
}

// A sweep that has been opened, the first of its step, of which no row is done; or none, where the step waits for a driver.
bool between_steps(const Run& run) {
  if (run.phase == Phase::done) return true;
  if (run.phase != Phase::sweeping) return false;
  if (run.sweep.row == nullptr) return run.driver != nullptr && run.cursor.sweep == 0;
  return run.cursor.sweep == 1 && run.at_band == 0 && !run.band[0].open && run.band[0].run == 0;
}

// Its margin stays.
void reopen_sweep(Run& run) {
  if (run.phase == Phase::done || run.sweep.row == nullptr) return;
  run.cursor.sweep = 0;
  next_sweep(run);
  begin_sweep(run.field, run.sweep, run.band);
}

void prepare_stage(Run& run) {
  if (run.solver.prepare != nullptr) run.solver.prepare(context_of(run));
  reopen_sweep(run);
}

static uint32_t sweep_rows(Run& run, uint32_t rows) {
  Band& band = run.band[run.at_band];
  const uint32_t done = run_band(run.field, run.sweep, run.table, run.at_band, band, rows);
  if (band.next == band.end && ++run.at_band == run.field.bands) {
    run.sweep.row = nullptr;
    end_part(run, false);
  }
  return done;
}

bool advance(Run& run, uint32_t rows, bool one_part) {
  const uint16_t part = run.parts;
  while (run.phase != Phase::done) {
    if (one_part && run.parts != part) return true;
    if (run.phase == Phase::sweeping && run.sweep.row == nullptr) {
      if (run.ghosts.seal != nullptr && !run.ghosts.sealed) {
        run.phase = Phase::sealing;
        run.at_row = 0;
        continue;
      }
      const bool begins = run.cursor.sweep == 0 && run.step < run.stage.steps;
      if (rows == 0 && run.driver != nullptr && begins) return true;  // a step, for which the driver wants rows
      const uint32_t done = driven(run, rows);
      rows -= done;
      run.rows += done;
      if (done == 0) open_sweep(run);
      continue;
    }
    if (rows == 0) return true;
    uint32_t done = 1;
    switch (run.phase) {
      case Phase::starting: start_one_row(run); break;
      case Phase::refining: refine_one_row(run); break;
      case Phase::sealing: seal_one_row(run); break;
      case Phase::sweeping: done = sweep_rows(run, rows); break;
      case Phase::done: break;
    }
    rows -= done;
    run.rows += done;
  }
  return false;
}

}  // namespace dapple::evolve
