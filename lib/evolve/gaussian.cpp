// Impulse splitting (Witkin & Kass eq. 12): react once, then apply the Gaussian of the macro step by lattice passes.
// SPDX-License-Identifier: MIT
#include "solver.hpp"

namespace dapple::evolve {

static void first_sweep(const Context& context, Cursor& cursor, Sweep& sweep, grid::RowKernel row) {
  sweep.row = grid::choose(context.kernels, row);
  sweep.first = 0;
  sweep.count = context.model->planes(context.number);
  sweep.radius = 0;
  context.model->values(context.number, context.clock, sweep.p);
  cursor.plane = 0;
  cursor.direction = 0;
  cursor.lattice.count = 0;
}

// Turns to a new plane: its reduction is made afresh, which is cheap beside a sweep and needs no memory.
static void open_plane(const Context& context, Cursor& cursor, int32_t length) {
  const grid::Tensor tensor = context.model->tensor(context.number, cursor.plane);
  cursor.lattice = stencil::lattice_of(grid::over(grid::at_level(tensor, context.level), length));
  cursor.direction = 0;
  if (cursor.lattice.count > 0)
    cursor.series = stencil::series_of(cursor.lattice.direction[0].share, 0, stencil::wide_share(length));
}

static void chain_sweep(const Context& context, Cursor& cursor, int32_t share, int32_t narrow, Sweep& sweep) {
  sweep.row = grid::choose(context.kernels, &stencil::chain_row);
  sweep.radius = 0;
  sweep.p[0] = share;
  sweep.p[1] = stencil::reach_of(share, narrow);
  sweep.p[2] = narrow;
  stencil::Pass pass{};
  while (stencil::next_pass(cursor.series, pass)) {
  }
}

bool passes_next(const Context& context, Cursor& cursor, Sweep& sweep, grid::RowKernel row, int32_t length) {
  if (cursor.sweep++ == 0) {
    first_sweep(context, cursor, sweep, row);
    open_plane(context, cursor, length);
    return true;
  }
  sweep.count = 1;
  const int32_t narrow = stencil::wide_share(length);
  for (;;) {
    if (cursor.direction == cursor.lattice.count) {
      if (++cursor.plane >= context.model->planes(context.number)) return false;
      open_plane(context, cursor, length);
      continue;
    }
    const stencil::Direction& d = cursor.lattice.direction[cursor.direction];
    sweep.first = cursor.plane;
    stencil::Pass pass{};
    const bool along_row = d.vy == 0;
    if (along_row) chain_sweep(context, cursor, d.share, narrow, sweep);
    if (along_row || !stencil::next_pass(cursor.series, pass)) {
      const uint8_t turn = cursor.series.turn;
      if (++cursor.direction < cursor.lattice.count)
        cursor.series = stencil::series_of(cursor.lattice.direction[cursor.direction].share, turn, narrow);
      if (along_row) return true;
      continue;
    }
    sweep.row = grid::choose(context.kernels, &stencil::pass_row);
    sweep.radius = 1;
    sweep.stride = static_cast<uint16_t>(pass.stride * d.vy);
    sweep.halo = static_cast<uint16_t>(pass.stride * (d.vx < 0 ? -d.vx : d.vx));
    sweep.p[0] = static_cast<int32_t>(pass.stride) * d.vx;
    sweep.p[1] = pass.weight;
    sweep.p[2] = pass.rounding;
    return true;
  }
}

bool gaussian_next(const Context& context, Cursor& cursor, Sweep& sweep) {
  return passes_next(context, cursor, sweep, context.model->impulse, grid::kOneVariance);
}

}  // namespace dapple::evolve
