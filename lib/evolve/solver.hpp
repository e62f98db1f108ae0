// How a model's time step becomes sweeps over its planes. A solver joins a model with stencils; the sweep machinery
// (sweep.hpp) knows neither.
// SPDX-License-Identifier: MIT
#pragma once
#include "../base/status.hpp"
#include "../grid/domain.hpp"
#include "../model/model.hpp"
#include "../stencil/lattice.hpp"

namespace dapple {

// What happens when a stage begins.
enum class Entry : uint8_t {
  start,   // the recipe's start fills the planes (first stage only)
  carry,   // the planes go on as they are, on the same grid
  refine,  // from a grid coarser by 2: bilinear at cell centres
  freeze,  // the same as carry, but the cells that are on are held from now on: read, never written
  reset,   // the same as carry, no cell is held; as with freeze, some cells may go back to the uniform state
};
constexpr bool same_grid(Entry entry) { return entry != Entry::start && entry != Entry::refine; }

}  // namespace dapple

namespace dapple::evolve {

struct Run;  // run.hpp

// One sweep: a row kernel over every row of the grid. With radius r and stride S the kernel for row y reads, of each of
// its planes, the old rows y - r S ... y + r S (mod height) with halos; with r = 0 it works on the plane's row in place.
struct Sweep {
  grid::RowKernel row;
  grid::RowKernel part[2];  // handed to the kernel
  uint8_t first, count;     // planes
  uint8_t radius;
  uint16_t stride;
  uint16_t halo;            // cells
  int32_t p[kMaxValues];    // handed to the kernel
  uint16_t margin = 0;      // rows and cells at every edge of the grid that are left as they are (windows of the plane)
  uint16_t tile = 0;        // corner tiles: only rows y < tile are visited; the kernel does y + tile k, k = 0..3, of them
};

// Where a solver is within one time step. Plain state: it can be copied and resumed.
struct Cursor {
  uint16_t sweep;             // sweeps handed out so far
  uint8_t plane, direction;   // gaussian: what comes next
  stencil::PassSeries series;
  stencil::Lattice lattice;
  uint8_t part;               // corner tiles: of the step, see corners.cpp
};

// What a solver is asked about: a model with its numbers on a grid coarser by 2^level.
struct Context {
  const Model* model;
  const int32_t* number;
  const grid::KernelSwap* kernels;
  int32_t* table;  // Reach::table numbers, kept while the stage lasts
  Clock clock;
  uint8_t level;
  const grid::Ground* ground;
  bool plane;
  uint32_t seed;
  const void* stored;  // Stage::stored
  bool first;          // the stage's first step
  Entry entry = Entry::start;  // of the stage
};

// What a solver needs of the scratch memory.
struct Reach {
  uint8_t planes, radius;  // of the widest window
  uint16_t halo;
  uint8_t rows16, rows32;  // work rows without halo
  uint8_t halo_rows;       // int16 work rows with halo
  uint16_t sweeps;         // per step, for information
  uint16_t stride;         // the largest distance of two rows or cells that meet in one sweep
  uint16_t table;          // int32 numbers a solver keeps for its kernels (Rows::table)
  uint16_t spread;         // how far, in cells of this grid, one step carries what a cell holds
  uint8_t field_radius = 0;  // rows and cells around a cell that `field` reads
  uint8_t bytes = 0;         // of scratch for each of kept_cells (sweep.hpp), for kernels that keep more than rows
  uint16_t space = 0;        // bytes of work space, whatever the width, of the kernels of a step and of the field
  uint8_t kept = 0;          // planes the solver keeps behind the model's own
  uint8_t once = 0;          // sweeps more in the first step of a stage
  uint16_t span = 0;         // how far, in cells, one sweep carries what a cell holds; 0: `stride`
};

// What corner tiles agree on while they grow.
enum class Sharing : uint8_t {
  none,      // cannot be
  reaction,  // the solver has a sweep of the model's `impulse` alone: the tiles decide together where it is on
  state,     // the planes are blended now and then
};

enum class Maps : uint8_t {
  unknown,  // along.hpp has no solver that does the same along a map
  off,      // it has
  on        // this is one
};

struct Solver {
  Reach (*reach)(const Model& model, const int32_t* number, uint8_t level, const void* stored);
  // Fills `sweep` with the next sweep of this step; false when the step is complete. cursor.sweep == 0 begins a step.
  bool (*next)(const Context& context, Cursor& cursor, Sweep& sweep);
  // Fills the table when a stage begins, if the solver has one.
  void (*prepare)(const Context& context) = nullptr;
  // Where the field needs neighbours, instead of the model's own kernel: in[k] rows y - field_radius + k with halo;
  // out[0] the field of the stage's grid, which is then enlarged bilinearly. With a radius of 0: in[plane], kept planes too.
  grid::RowKernel field = nullptr;
  // ok where Stage::stored is what these numbers need on that domain; null: nothing is wanted.
  Status (*accepts)(const int32_t* number, const void* stored, const Domain& domain) = nullptr;
  Sharing sharing = Sharing::none;
  uint8_t sharing_steps = 1;  // Sharing::state: from one blend to the next
  bool (*alike)(const int32_t* number) = nullptr;  // whether the numbers treat all tiles alike; null: they always do
  bool freezes = false;  // can begin a stage by freeze and reset
  Maps maps = Maps::unknown;
  bool pictured = false;  // grows by a grey picture
  // Before rows of the field are made, whenever planes have moved: what they want to know of all cells, into the run's
  // table. row: room for one row of the domain.
  void (*look)(const Run& run, int16_t* row, uint8_t* work) = nullptr;
};

// A sweep of one kernel that does the whole step on windows of rows.
inline void window_sweep(const Context& context, uint8_t radius, grid::RowKernel row, Sweep& sweep) {
  sweep.first = 0;
  sweep.count = context.model->planes(context.number);
  sweep.radius = radius;
  sweep.stride = 1;
  sweep.halo = radius;
  sweep.row = grid::choose(context.kernels, row);
  context.model->values(context.number, context.clock, sweep.p);
}

constexpr uint16_t wider(uint16_t a, uint16_t b) { return a > b ? a : b; }

// --- gaussian: impulse splitting, eq. (12). One reaction, then the Gaussian of a whole macro step on every plane. ---
// length: of the step, Q16 macro steps.
constexpr Reach passes_reach(const Model& model, const int32_t* number, uint8_t level, int32_t length) {
  Reach reach{1, 0, 0, model.work_rows, 0, 0, 1, 0, 0, 0};
  const int32_t narrow = stencil::wide_share(length);
  for (uint8_t plane = 0; plane < model.planes(number); ++plane) {
    const stencil::Lattice lattice = stencil::lattice_of(grid::over(grid::at_level(model.tensor(number, plane), level), length));
    uint16_t spread = 0;
    for (uint8_t i = 0; i < lattice.count; ++i) {
      const stencil::Direction& d = lattice.direction[i];
      spread = static_cast<uint16_t>(spread + stencil::spread_of(d, narrow));
      const uint16_t stride = stencil::reach_of(d.share, narrow);
      const uint16_t across = static_cast<uint16_t>(stride * (d.vx < 0 ? -d.vx : d.vx));
      reach.halo = wider(reach.halo, across);
      reach.stride = wider(reach.stride, wider(across, static_cast<uint16_t>(stride * d.vy)));
      if (d.vy == 0) {
        reach.span = wider(reach.span, stencil::spread_of(d));
        reach.halo_rows = 2;
        ++reach.sweeps;
      } else {
        reach.radius = 1;
        stencil::PassSeries series = stencil::series_of(d.share, 0, narrow);
        stencil::Pass pass{};
        while (stencil::next_pass(series, pass)) ++reach.sweeps;
      }
    }
    reach.spread = wider(reach.spread, spread);
  }
  reach.span = wider(reach.span, reach.stride);
  return reach;
}
constexpr Reach gaussian_reach(const Model& model, const int32_t* number, uint8_t level, const void*) {
  return passes_reach(model, number, level, grid::kOneVariance);
}
// After a first sweep `row` over all planes, the passes of a step of that length; the model's values are in sweep.p.
bool passes_next(const Context& context, Cursor& cursor, Sweep& sweep, grid::RowKernel row, int32_t length);
bool gaussian_next(const Context& context, Cursor& cursor, Sweep& sweep);
inline constexpr Solver gaussian DAPPLE_ROM = {gaussian_reach, gaussian_next, nullptr, nullptr, nullptr, Sharing::reaction};

// --- euler: the explicit step of eq. (5), all planes in one sweep; sub-steps per macro step as stability asks. -------
// b dt = 1/2 is divided by m so that dt (4 tr A + b) <= 1.7, beyond which the threshold feeds the checkerboard.
constexpr uint16_t euler_steps(const Model& model, const int32_t* number, uint8_t level) {
  int64_t trace = 0;  // Q16 variance of a macro step = A
  for (uint8_t plane = 0; plane < model.planes(number); ++plane) {
    const grid::Tensor t = grid::at_level(model.tensor(number, plane), level);
    const int64_t sum = static_cast<int64_t>(t.xx) + t.yy;
    trace = sum > trace ? sum : trace;
  }
  const int64_t need = 5 * (4 * trace + 65536);  // m >= (4 tr A + 1) / 2 / 1.7
  return static_cast<uint16_t>((need + 17 * 65536 - 1) / (INT64_C(17) * 65536));
}
constexpr Reach euler_reach(const Model& model, const int32_t* number, uint8_t level, const void*) {
  const uint8_t planes = model.planes(number);
  const uint16_t steps = euler_steps(model, number, level);
  return {planes, 1, 1, model.work_rows, planes, 0, steps, 1, static_cast<uint16_t>(3 * planes), steps};
}
bool euler_next(const Context& context, Cursor& cursor, Sweep& sweep);
inline constexpr Solver euler DAPPLE_ROM = {euler_reach, euler_next, nullptr, nullptr, nullptr, Sharing::state, 1};

// --- kinetic: one explicit step of dt = 1 with the five-point stencil in int16. -------------------------------------
constexpr Reach kinetic_reach(const Model& model, const int32_t* number, uint8_t, const void*) {
  const uint8_t planes = model.planes(number);
  return {planes, 1, 1, static_cast<uint8_t>(model.work_rows + planes), 0, 0, 1, 1, static_cast<uint16_t>(3 * planes), 1};
}
bool kinetic_next(const Context& context, Cursor& cursor, Sweep& sweep);
// Its sweep: part[0] the stencil, part[1] the reaction; table: three numbers of the stencil for each plane.
void narrow_row(const grid::Rows& rows);
inline constexpr Solver kinetic DAPPLE_ROM = {kinetic_reach, kinetic_next, nullptr, nullptr, nullptr, Sharing::state, 16};

// --- direct: the model's own window kernel, any kind of cell. -------------------------------------------------------
constexpr Reach direct_reach(const Model& model, const int32_t* number, uint8_t, const void*) {
  return {model.planes(number), model.radius, model.radius, model.work_rows, 0, 0, 1, model.radius, 0, model.radius};
}
bool direct_next(const Context& context, Cursor& cursor, Sweep& sweep);
inline constexpr Solver direct DAPPLE_ROM = {direct_reach, direct_next};

}  // namespace dapple::evolve
