// The stepper: an explicit state machine over phases, stages, steps, sweeps, bands and rows.
// SPDX-License-Identifier: MIT
#include "run.hpp"

#include "refine.hpp"

namespace dapple::evolve {

using base::rom_load;

static Stage load_stage(const Plan& plan, uint8_t index) {
  return plan.rom ? rom_load(plan.stage + index) : plan.stage[index];
}
static Start load_start(const Plan& plan) { return plan.rom ? rom_load(plan.start) : *plan.start; }

static void set_level(Run& run, uint8_t level) {
  run.field.width = at_level(run.domain.width, level);
  run.field.height = at_level(run.domain.height, level);
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

// Makes the stage's model, solver and grid current. A refined stage keeps the coarse grid until it is refined.
static void open_stage(Run& run) {
  run.stage = load_stage(run.plan, run.index);
  run.model = rom_load(run.stage.model);
  run.solver = rom_load(run.stage.solver);
  run.step = 0;
  run.cursor.sweep = 0;
  run.sweep.row = nullptr;
  run.at_plane = 0;
  set_clock(run);
  switch (run.stage.entry) {
    case Entry::start:
      set_level(run, run.stage.level);
      run.phase = Phase::starting;
      run.at_row = 0;
      break;
    case Entry::carry: run.phase = Phase::sweeping; break;
    case Entry::refine:
      run.phase = Phase::refining;
      run.at_row = run.field.height;
      break;
  }
}

void begin(Run& run, const Plan& plan, const Domain& domain, uint32_t seed, const grid::KernelSwap* kernels, uint8_t bands,
           const Parts& parts, uint8_t* memory) {
  run.plan = plan;
  run.domain = domain;
  run.seed = seed;
  run.kernels = kernels;
  const Stage first = load_stage(plan, 0);
  const Model model = rom_load(first.model);
  run.field.planes = memory;
  run.field.cell = model.cell;
  run.field.plane_bytes = grid::row_bytes(model.cell, domain.width) * domain.height;
  run.field.scratch = memory + parts.planes;
  run.field.band_bytes = parts.scratch / bands;
  run.field.bands = bands;
  run.table = reinterpret_cast<int32_t*>(run.field.scratch + parts.scratch);
  run.band = reinterpret_cast<Band*>(run.field.scratch + parts.scratch + parts.table);
  run.rows = 0;
  run.index = 0;
  run.clock = {0, 0};
  open_stage(run);
}

static void start_one_row(Run& run) {
  const Start start = load_start(run.plan);
  const uint8_t level = run.stage.level;
  const start::Place place = {run.field.cell,        run.field.width,       run.field.height, level,
                              at_level(run.domain.x, level), at_level(run.domain.y, level), run.seed};
  const uint8_t planes = run.model.planes(run.stage.number);
  uint8_t* row = row_of(run.field, run.at_plane, run.at_row);
  const grid::Levels levels = run.model.levels(run.stage.number, run.at_plane);
  if (start.kind == Start::noise)
    start::noise_row(place, run.at_plane, levels, run.at_row, row);
  else
    start::seeds_row(place, start, levels, run.at_row, row);
  if (++run.at_row < run.field.height) return;
  run.at_row = 0;
  if (++run.at_plane == planes) run.phase = Phase::sweeping;
}

static void refine_one_row(Run& run) {
  --run.at_row;
  const uint8_t planes = run.model.planes(run.stage.number);
  for (uint8_t plane = 0; plane < planes; ++plane) refine_row(run.field, plane, run.at_row);
  if (run.at_row > 0) return;
  set_level(run, run.stage.level);
  run.phase = Phase::sweeping;
}

// The next sweep of the step, the next step, the next stage: whatever comes now that no sweep is under way.
static void open_sweep(Run& run) {
  if (run.step == run.stage.steps) {
    if (++run.index == run.plan.stages)
      run.phase = Phase::done;
    else
      open_stage(run);
    return;
  }
  const Context context = {&run.model, run.stage.number, run.kernels, run.table, run.clock, run.stage.level};
  if (run.solver.next(context, run.cursor, run.sweep)) {
    run.at_band = 0;
    begin_sweep(run.field, run.sweep, run.band);
    return;
  }
  run.sweep.row = nullptr;
  run.cursor.sweep = 0;
  ++run.step;
  ++run.clock.step;
}

static uint32_t sweep_rows(Run& run, uint32_t rows) {
  Band& band = run.band[run.at_band];
  const uint32_t done = run_band(run.field, run.sweep, run.table, run.at_band, band, rows);
  if (band.next == band.end && ++run.at_band == run.field.bands) run.sweep.row = nullptr;
  return done;
}

bool advance(Run& run, uint32_t rows) {
  while (run.phase != Phase::done) {
    if (run.phase == Phase::sweeping && run.sweep.row == nullptr) {
      open_sweep(run);
      continue;
    }
    if (rows == 0) return true;
    uint32_t done = 1;
    switch (run.phase) {
      case Phase::starting: start_one_row(run); break;
      case Phase::refining: refine_one_row(run); break;
      case Phase::sweeping: done = sweep_rows(run, rows); break;
      case Phase::done: break;
    }
    rows -= done;
    run.rows += done;
  }
  return false;
}

uint64_t work_rows(const Plan& plan, const Domain& domain) {
  uint64_t total = 0;
  for (uint8_t i = 0; i < plan.stages; ++i) {
    const Stage stage = load_stage(plan, i);
    const Model model = rom_load(stage.model);
    const Reach reach = rom_load(stage.solver).reach(model, stage.number, stage.level);
    const uint16_t height = at_level(domain.height, stage.level);
    const uint8_t planes = model.planes(stage.number);
    if (stage.entry == Entry::start) total += static_cast<uint64_t>(planes) * height;
    if (stage.entry == Entry::refine) total += height / 2;
    total += static_cast<uint64_t>(stage.steps) * reach.sweeps * height;
  }
  return total;
}

void field_row(const Run& run, uint16_t y, int16_t* out, uint8_t* work) {
  // While a stage refines, from the bottom up, the rows above still stand on the coarser grid.
  uint8_t level = run.stage.level;
  if (run.phase == Phase::refining && at_level(y, level) < 2 * static_cast<int32_t>(run.at_row)) ++level;
  int32_t values[kMaxValues] = {};
  run.model.values(run.stage.number, run.clock, values);
  grid::Rows rows;
  rows.p = values;
  rows.table = run.table;
  rows.part = nullptr;
  rows.scratch = work;
  rows.n = at_level(run.domain.width, level);
  rows.planes = run.model.planes(run.stage.number);
  const uint16_t row = at_level(y, level);
  const size_t bytes = grid::row_bytes(run.field.cell, rows.n);
  for (uint8_t i = 0; i < rows.planes; ++i) rows.in[i] = run.field.planes + i * run.field.plane_bytes + row * bytes;
  rows.out[0] = out;
  grid::choose(run.kernels, run.model.field)(rows);
  if (level == 0) return;
  for (uint16_t x = run.domain.width; x-- > 0;) out[x] = out[at_level(x, level)];
}

}  // namespace dapple::evolve
