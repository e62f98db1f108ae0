// A texture on its way: start, stages, sweeps, rows. Plain state that can stop after any row and go on later.
// SPDX-License-Identifier: MIT
#pragma once
#include "../start/start.hpp"
#include "sweep.hpp"

namespace dapple {

constexpr uint8_t kMaxStages = 4;
constexpr uint8_t kMaxLevel = 3;
constexpr uint8_t kMaxCoarse = 2;  // that a picture may stay at
constexpr uint8_t kMaxBands = 64;
constexpr uint32_t kMaxSteps = 4000000;
constexpr uint16_t kMostStamp = 4096;  // radius, pixels

// A model, its numbers, the grid (finest size / 2^level) and how long.
struct Stage {
  const Model* model;
  const evolve::Solver* solver;
  uint32_t steps;
  uint8_t level;
  Entry entry;
  int32_t number[kMaxNumbers];
  evolve::RowRefine refine;  // with Entry::refine: what does it
  const void* stored;        // what the solver finds ready made in read-only memory, if anything
};

}  // namespace dapple

namespace dapple::evolve {

using grid::Ground;

// The stages of a recipe, in read-only memory (rom) or not.
struct Plan {
  const Start* start;
  const Stage* stage;
  uint8_t stages;
  bool rom;
};

enum class Phase : uint8_t { starting, refining, sealing, sweeping, done };

struct Run;

// Of a patch. Before a sweep and at the end `seal` copies its ghost cells (ghosts.hpp).
struct Ghosts {
  void (*seal)(Run& run) = nullptr;  // one row; null: no patch
  uint8_t* planes;                   // of patch 0; those of the next patch come `block` bytes later
  size_t block;
  uint32_t* entry;  // of every ghost cell
  bool made;        // the entries, for this level
  bool sealed;      // nothing has moved since
};

// Somebody who does the sweeps of whole steps in another way than one row after the other: on threads, several sweeps at a
// time (ports/desktop). Same bytes.
struct Driver {
  // A whole step, if that is at most `rows` rows of work: takes its sweeps (take_sweep) and does them. Returns the rows of
  // work done; 0: the step is left as it was, to be done row by row.
  uint32_t (*step)(Driver& driver, Run& run, uint32_t rows);
};

struct Run {
  Plan plan;
  Stage stage;      // the current one, loaded
  Model model;
  Solver solver;
  const grid::KernelSwap* kernels;
  Driver* driver;
  Domain domain;
  Ground ground;
  uint16_t spent;   // cells of the halo, finest grid, that the sweeps so far have used up
  Field field;      // of the current level
  Band* band;
  int32_t* table;
  uint32_t seed;
  uint32_t step;    // done in this stage
  uint64_t rows;    // of work done in all, for progress
  Clock clock;      // clock.step counts over the stages that continue each other
  Cursor cursor;
  Sweep sweep;
  Phase phase;
  uint8_t index;    // of the stage
  uint8_t at_band, at_plane;
  uint8_t field_radius;  // of the solver's field kernel; 0: the model's own
  uint16_t field_space;  // bytes of its work space
  uint8_t kept;          // planes it reads behind the model's own
  uint16_t at_row;
  uint16_t parts;   // starts, refinements, sweeps and seals that have ended, modulo 2^16
  Ghosts ghosts;
};

// Memory by part, bytes. fits is false when a part does not fit size_t.
struct Parts {
  size_t planes, scratch, table, bands;
  bool fits;
  bool frugal = false;  // scratch comes last, so that it may be used for something else in the end
  size_t blocks = 0;    // of windows in blocks
  size_t ghosts = 0;    // of patches, behind the bands
};

constexpr uint16_t at_level(uint16_t size, uint8_t level) { return static_cast<uint16_t>(size >> level); }

// Adds what a stage needs to the parts: `rows16` more work rows than its solver asks for. Planes are as far apart as the
// finest grid, that of the last stage, asks for.
constexpr void add_stage(Parts& parts, const Stage& stage, const Model& model, const Solver& solver, const Ground& d, uint8_t finest,
                         uint8_t bands, uint8_t rows16 = 0) {
  const uint16_t width = at_level(d.width, stage.level);
  Reach reach = solver.reach(model, stage.number, stage.level, stage.stored);
  reach.rows16 = static_cast<uint8_t>(reach.rows16 + rows16);
  size_t band = 0, planes = 0, scratch = 0;
  parts.fits = parts.fits && band_bytes(reach, model.cell, width, bands, band);
  const uint16_t height = at_level(d.height, finest);
  if (stage.entry == Entry::refine) {
    const size_t ring = 4 * model.planes(stage.number) * grid::scratch_bytes(model.cell, static_cast<uint16_t>(width / 2), 1);
    band = ring > band ? ring : band;
  }
  parts.fits = parts.fits && base::add_bytes(scratch, bands, band) &&
               base::add_bytes(planes, height, grid::row_bytes(model.cell, at_level(d.width, finest)));
  size_t all = 0;
  parts.fits = parts.fits && base::add_bytes(all, static_cast<size_t>(model.planes(stage.number)) + reach.kept, planes);
  parts.planes = all > parts.planes ? all : parts.planes;
  parts.scratch = scratch > parts.scratch ? scratch : parts.scratch;
  const size_t table = sizeof(int32_t) * reach.table;
  parts.table = table > parts.table ? table : parts.table;
}

// Steps of one sweep over neighbouring rows can leave out the part of the halo that is used up.
constexpr bool leaves_margin(const Reach& reach) { return reach.sweeps == 1 && reach.radius > 0; }

// Rows of work of a stage; `spent` is the part of the halo that the stages before have used up, and is moved on.
constexpr uint64_t work_rows(const Stage& stage, const Model& model, const Reach& reach, const Ground& ground, bool plane, uint32_t& spent) {
  const uint16_t height = at_level(ground.height, stage.level);
  const bool patch = ground.patches != nullptr;
  uint64_t total = static_cast<uint64_t>(stage.steps) * reach.sweeps * height;
  if (stage.steps > 0) total += static_cast<uint64_t>(reach.once) * height;
  if (stage.entry == Entry::start) total += static_cast<uint64_t>(model.planes(stage.number)) * height;
  if (stage.entry == Entry::refine) total += height / 2u;
  if (patch) {  // a seal after the start, a refinement, and every sweep
    total += (static_cast<uint64_t>(stage.steps) * reach.sweeps + (stage.steps > 0 ? reach.once : 0u)) * height;
    if (!same_grid(stage.entry)) total += height;
  }
  for (uint32_t step = 0; plane && !patch && step < stage.steps; ++step) {
    spent += static_cast<uint32_t>(reach.spread) << stage.level;
    if (leaves_margin(reach)) total -= 2u * (spent >> stage.level);
  }
  return total;
}

// What a run begins with; all of it has been checked. memory: planes, scratch, table, bands and ghosts of parts, aligned
// to 4. Of patches `ghosts` has seal, and where there are several planes and block.
struct Setup {
  Plan plan;
  Domain domain;
  Ground ground;
  Parts parts;
  uint8_t* memory;
  const grid::KernelSwap* kernels;
  uint32_t seed;
  uint8_t bands;
  Ghosts ghosts = {};
  Driver* driver = nullptr;
};
void begin(Run& run, const Setup& setup);

// The next sweep of the step at hand, into run.sweep; false, with run.sweep.row null, when the step is complete.
bool take_sweep(Run& run);

// At most `rows` rows of work; false when nothing is left to do. one_part: ends where run.parts moves on, so that patches
// can take turns.
bool advance(Run& run, uint32_t rows, bool one_part = false);

// Whether nothing is under way: all steps so far are whole, in all planes, on the grid of the stage.
bool between_steps(const Run& run);

// What disturbs a run between two steps (disturb.cpp).
//   stamp    the cells of a disc, in pixels of the domain, of all planes: as discs of seeds, or back to the uniform state
//   change   a number of the current stage, for what is left of it; of explicit kinetics
//   go_on    more steps of the last stage, of a run that is done; rows: of work
Status stamp(Run& run, int32_t x, int32_t y, uint16_t radius, bool on);
Status change(Run& run, uint8_t slot, int32_t value);
Status go_on(Run& run, uint32_t steps, uint64_t& rows);

// Makes the sweep that comes next anew, where planes have changed; and what the stage keeps, where numbers have.
void reopen_sweep(Run& run);
void prepare_stage(Run& run);

}  // namespace dapple::evolve
