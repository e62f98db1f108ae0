// Steps of explicit kinetics along a map of directions. See along.hpp.
// SPDX-License-Identifier: MIT
#include "along.hpp"

namespace dapple::evolve {

// In the places of the constant weights: those of a cell of the map, and the turn of its doubled direction, Q15.
enum AlongTable : uint8_t { mean_weight, slope_weight, turn_c, turn_s };

void prepare_along(const Context& context) {
  const int32_t* const number = context.number;
  int32_t* const table = context.table;
  prepare_kinetics(context);
  const bool round = number[along::map] == mapped::isotropic_pairs;
  const stencil::LinkWeights w = stencil::link_weights(round ? base::kMicro : number[kinetics::stretch]);
  const uint16_t turn = static_cast<uint16_t>(2 * base::angle_of(number[kinetics::angle]));
  table[mean_weight] = w.mean;
  table[slope_weight] = w.slope;
  table[turn_c] = base::cosine(turn);
  table[turn_s] = base::sine(turn);
  make_map(context, number[along::map], number[along::detail],
           *reinterpret_cast<stencil::DirectionMap*>(table + table_count));
}

// A sum of products of Q7 and Q15, rounded.
static int8_t turned(int32_t a, int32_t c, int32_t b, int32_t s) {
  return stencil::to_q7((a * c + b * s + 16384) >> 15);
}

// The first sweep of a stage, of the kernel it is made of and then the plane of directions.
static void enter_along_row(const grid::Rows& rows) {
  const int32_t* const t = rows.table;
  enter_row(rows);
  int16_t* const map = reinterpret_cast<int16_t*>(rows.scratch);
  stencil::place_row(*reinterpret_cast<const stencil::DirectionMap*>(t + table_count), 0, rows.y, rows.n, map);
  for (uint16_t x = 0; x < rows.n; ++x) {
    const int32_t c = static_cast<int8_t>(map[x] & 255), s = map[x] >> 8;
    set_cell(rows, rows.out[rows.planes - 1], x,
             stencil::packed({turned(c, t[turn_c], -s, t[turn_s]), turned(s, t[turn_c], c, t[turn_s])}));
  }
}

// Along half of the angle of a cell's vector (c, s) of length l, either way: (l + c, s), or (s, l - c) where that is
// longer; so 1.4 l or more, scaled to 1.4 * 2^11 .. 2^12 for unit_of. Where there is no vector, along x.
static start::Way way_at(const start::Place& place, int32_t x, int32_t y) {
  stencil::DirectionMap m = *reinterpret_cast<const stencil::DirectionMap*>(place.table + table_count);
  int16_t cell = 0;
  m.x = m.field.x = x;
  m.y = m.field.y = y;
  stencil::map_row(m, 0, 0, 1, &cell);
  const int32_t c = static_cast<int8_t>(cell & 255), s = cell >> 8;
  const int32_t length = base::max(1, static_cast<int32_t>(base::square_root(static_cast<uint32_t>(c * c + s * s))));
  const int32_t scale = 2048 / length, across = c < 0 ? s : length + c, down = c < 0 ? length - c : s;
  const stencil::Doubled way = stencil::unit_of(across * scale, down * scale);
  return {way.c2 * 258, way.s2 * 258};
}

void segments_along_row(const start::Place& place, const Start& start, const grid::Levels& levels, uint8_t, uint16_t y,
                        void* row) {
  start::lay_segments(place, start, levels, y, row, way_at);
}

// A row of a step of kinetics, behind the links of its cells. part: {stencil, reaction}; scratch: links first.
static void along_row(const grid::Rows& rows) {
  grid::Rows on = rows;
  const int32_t* const t = rows.table;
  const bool holds = rows.planes > t[morphogens] + t[has_rates] + 1;
  stencil::link_row(rows, rows.in + 3 * (rows.planes - 1), t[wide_cells] != 0,
                    {static_cast<int16_t>(t[mean_weight]), static_cast<int16_t>(t[slope_weight])});
  on.scratch += stencil::link_bytes(rows.n);
  (holds ? cascade_row : kinetics_row)(on);
}

static bool next_along(const Context& context, bool holds, Cursor& cursor, Sweep& sweep) {
  const uint16_t at = cursor.sweep++;
  if (context.first && at == 0) {
    enter_sweep(context, holds, sweep);
    sweep.row = enter_along_row;
  } else {
    const bool wide = context.model->cell == grid::Cell::int32;
    step_sweep(context, holds, along_row, sweep);
    sweep.part[0] = grid::choose(context.kernels, wide ? stencil::linked_wide_row : stencil::linked_narrow_row);
  }
  ++sweep.count;
  return at <= (context.first ? 1 : 0);
}
bool along_next(const Context& context, Cursor& cursor, Sweep& sweep) {
  return next_along(context, false, cursor, sweep);
}
bool cascade_along_next(const Context& context, Cursor& cursor, Sweep& sweep) {
  return next_along(context, true, cursor, sweep);
}

}  // namespace dapple::evolve
