// Steps of explicit kinetics that differ from place to place. See along.hpp.
// SPDX-License-Identifier: MIT
#include "along.hpp"

namespace dapple::evolve {

// In the places of the constant weights: those of a cell of the map, and the turn of its doubled direction, Q15.
enum AlongTable : uint8_t { mean_weight, slope_weight, turn_c, turn_s };

static stencil::DirectionMap& map_in(int32_t* table) {
  return *reinterpret_cast<stencil::DirectionMap*>(table + table_count + kPictureWords);
}
static const stencil::DirectionMap& map_in(const int32_t* table) {
  return *reinterpret_cast<const stencil::DirectionMap*>(table + table_count + kPictureWords);
}

void prepare_along(const Context& context) {
  const int32_t* const number = context.number;
  int32_t* const table = context.table;
  prepare_kinetics(context);
  base::copy_bytes(table + table_count, &context.stored, sizeof context.stored);
  make_map(context, number[along::map], number[along::detail], map_in(table));
  table[linked] = has_map(number) ? 1 : 0;
  const int64_t finest = base::divide_round(number[along::finest] * INT64_C(4096), base::kMicro);
  table[graded] = has_grade(number) ? static_cast<int32_t>(finest) * 8 + number[along::grade] - along::across : 0;
  if (table[linked] == 0) return;
  const bool round = number[along::map] == mapped::isotropic_pairs;
  const stencil::LinkWeights w = stencil::link_weights(round ? base::kMicro : number[kinetics::stretch]);
  const uint16_t turn = static_cast<uint16_t>(2 * base::angle_of(number[kinetics::angle]));
  table[mean_weight] = w.mean;
  table[slope_weight] = w.slope;
  table[turn_c] = base::cosine(turn);
  table[turn_s] = base::sine(turn);
}
void prepare_pictured_along(const Context& context) {
  prepare_along(context);
  context.table[has_rates] = 1;
}

// A sum of products of Q7 and Q15, rounded.
static int8_t turned(int32_t a, int32_t c, int32_t b, int32_t s) {
  return stencil::to_q7((a * c + b * s + 16384) >> 15);
}

// What the first sweep of a stage lays behind the planes of its kernel: directions, then shares.
static void lay_directions(const grid::Rows& rows, void* plane) {
  const int32_t* const t = rows.table;
  int16_t* const map = reinterpret_cast<int16_t*>(rows.scratch);
  stencil::place_row(map_in(t), 0, rows.y, rows.n, map);
  for (uint16_t x = 0; x < rows.n; ++x) {
    const int32_t c = static_cast<int8_t>(map[x] & 255), s = map[x] >> 8;
    set_cell(rows, plane, x,
             stencil::packed({turned(c, t[turn_c], -s, t[turn_s]), turned(s, t[turn_c], c, t[turn_s])}));
  }
}
static void lay_shares(const grid::Rows& rows, void* plane) {
  int16_t* const shares = reinterpret_cast<int16_t*>(rows.scratch);
  const int32_t grade = rows.table[graded];
  stencil::grade_row(map_in(rows.table), {static_cast<stencil::Grade::Kind>(grade & 7), grade >> 3}, rows.y, rows.n,
                     shares);
  for (uint16_t x = 0; x < rows.n; ++x) set_cell(rows, plane, x, shares[x]);
}
static void lay_places(const grid::Rows& rows) {
  const int32_t* const t = rows.table;
  if (t[linked] != 0) lay_directions(rows, rows.out[rows.planes - (t[graded] != 0 ? 2 : 1)]);
  if (t[graded] != 0) lay_shares(rows, rows.out[rows.planes - 1]);
}
static void enter_along_row(const grid::Rows& rows) {
  enter_row(rows);
  lay_places(rows);
}
static void picture_along_row(const grid::Rows& rows) {
  picture_row(rows);
  lay_places(rows);
}

// Along half of the angle of a cell's vector (c, s) of length l, either way: (l + c, s), or (s, l - c) where that is
// longer; so 1.4 l or more, scaled to 1.4 * 2^11 .. 2^12 for unit_of. Where there is no vector, along x.
static start::Way way_at(const start::Place& place, int32_t x, int32_t y) {
  stencil::DirectionMap m = map_in(place.table);
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

// A row of a step of kinetics, behind the links of its cells if there are directions. part: {stencil, reaction}; scratch:
// links first.
static void along_row(const grid::Rows& rows) {
  grid::Rows on = rows;
  const int32_t* const t = rows.table;
  const int32_t places = t[linked] + (t[graded] != 0 ? 1 : 0);
  const bool holds = rows.planes > t[morphogens] + t[has_rates] + places;
  if (t[linked] != 0) {
    stencil::link_row(rows, rows.in + 3 * (rows.planes - places), t[wide_cells] != 0,
                      {static_cast<int16_t>(t[mean_weight]), static_cast<int16_t>(t[slope_weight])});
    on.scratch += stencil::link_bytes(rows.n);
  }
  (holds ? cascade_row : kinetics_row)(on);
}

enum class Way : uint8_t { plain, holds, grows };

static void first_sweep(const Context& context, Way way, Sweep& sweep) {
  if (way == Way::grows) picture_sweep(context, sweep);
  else enter_sweep(context, way == Way::holds, sweep);
  sweep.row = way == Way::grows ? picture_along_row : enter_along_row;
}
static void next_sweep(const Context& context, Way way, Sweep& sweep) {
  const bool wide = context.model->cell == grid::Cell::int32;
  if (way == Way::grows) pictured_sweep(context, along_row, sweep);
  else step_sweep(context, way == Way::holds, along_row, sweep);
  if (has_map(context.number))
    sweep.part[0] = grid::choose(context.kernels, wide ? stencil::linked_wide_row : stencil::linked_narrow_row);
}
static bool next_along(const Context& context, Way way, Cursor& cursor, Sweep& sweep) {
  const uint16_t at = cursor.sweep++;
  if (context.first && at == 0) first_sweep(context, way, sweep);
  else next_sweep(context, way, sweep);
  sweep.count = static_cast<uint8_t>(sweep.count + planes_along(context.number));
  return at <= (context.first ? 1 : 0);
}
bool along_next(const Context& context, Cursor& cursor, Sweep& sweep) {
  return next_along(context, Way::plain, cursor, sweep);
}
bool cascade_along_next(const Context& context, Cursor& cursor, Sweep& sweep) {
  return next_along(context, Way::holds, cursor, sweep);
}
bool pictured_along_next(const Context& context, Cursor& cursor, Sweep& sweep) {
  return next_along(context, Way::grows, cursor, sweep);
}

}  // namespace dapple::evolve
