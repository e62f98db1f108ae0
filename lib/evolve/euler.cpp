// Explicit steps: a stencil turns the rows of every plane into sums, then the reaction turns rows and sums into rows.
// SPDX-License-Identifier: MIT
#include "../stencil/laplacian.hpp"
#include "solver.hpp"

namespace dapple::evolve {

constexpr uint8_t kTablePerPlane = 3;

// in[3 plane + k]: rows y - 1 + k; out[plane]: row y. part: {stencil, reaction}. scratch: the sums of every plane, then
// the reaction's own rows. p: the model's values; table: the stencil's numbers, three to a plane.
static void step_row(const grid::Rows& rows, size_t sum_bytes) {
  grid::Rows stencil = rows, react = rows;
  for (uint8_t plane = 0; plane < rows.planes; ++plane) {
    for (uint8_t k = 0; k < 3; ++k) stencil.in[k] = rows.in[3 * plane + k];
    stencil.out[0] = rows.scratch + plane * sum_bytes;
    stencil.p = rows.table + kTablePerPlane * plane;
    rows.part[0](stencil);
    react.in[plane] = stencil.out[0];
  }
  react.scratch = rows.scratch + rows.planes * sum_bytes;
  rows.part[1](react);
}

static void wide_row(const grid::Rows& rows) { step_row(rows, grid::row_bytes(grid::Cell::int32, rows.n)); }
void narrow_row(const grid::Rows& rows) { step_row(rows, grid::row_bytes(grid::Cell::int16, rows.n)); }

static void whole_window(const Context& context, Sweep& sweep) {
  sweep.first = 0;
  sweep.count = context.model->planes(context.number);
  sweep.radius = 1;
  sweep.stride = sweep.halo = 1;
  sweep.part[1] = grid::choose(context.kernels, context.model->react);
}

// Nine-point weights of a sub-step, Q16: dt a11, dt a22, dt a12 / 2. The tensor is the variance of b dt = 1/2, so A itself.
static void fill_nine(const Context& context, uint16_t steps) {
  for (uint8_t plane = 0; plane < context.model->planes(context.number); ++plane) {
    const grid::Tensor t = grid::at_level(context.model->tensor(context.number, plane), context.level);
    int32_t* to = context.table + kTablePerPlane * plane;
    to[0] = t.xx / (2 * static_cast<int32_t>(steps));
    to[1] = t.yy / (2 * static_cast<int32_t>(steps));
    to[2] = t.xy / (4 * static_cast<int32_t>(steps));
  }
}

bool euler_next(const Context& context, Cursor& cursor, Sweep& sweep) {
  const uint16_t steps = euler_steps(*context.model, context.number, context.level);
  if (cursor.sweep == 0) {
    whole_window(context, sweep);
    sweep.part[0] = grid::choose(context.kernels, &stencil::nine_row);
    fill_nine(context, steps);
    context.model->values(context.number, context.clock, sweep.p);
    sweep.p[5] = 32768 / static_cast<int32_t>(steps);
  }
  sweep.row = wide_row;
  return cursor.sweep++ < steps;
}

bool kinetic_next(const Context& context, Cursor& cursor, Sweep& sweep) {
  if (cursor.sweep++ != 0) return false;
  whole_window(context, sweep);
  sweep.row = grid::choose(context.kernels, narrow_row);
  sweep.part[0] = grid::choose(context.kernels, &stencil::five_row);
  for (uint8_t plane = 0; plane < sweep.count; ++plane) {
    const int32_t weight = context.model->tensor(context.number, plane).xx / 2;  // D dt, even Q16
    context.table[kTablePerPlane * plane] = weight;
    context.table[kTablePerPlane * plane + 1] = base::rounding_for(static_cast<int16_t>(weight));
  }
  context.model->values(context.number, context.clock, sweep.p);
  return true;
}

bool direct_next(const Context& context, Cursor& cursor, Sweep& sweep) {
  if (cursor.sweep++ != 0) return false;
  window_sweep(context, context.model->radius, context.model->window, sweep);
  return true;
}

}  // namespace dapple::evolve
