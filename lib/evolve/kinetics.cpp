// Steps of explicit kinetics. See kinetics.hpp.
// SPDX-License-Identifier: MIT
#include "kinetics.hpp"

#include "../base/hash.hpp"
#include "../start/start.hpp"
#include "field.hpp"

namespace dapple::evolve {

constexpr uint32_t kVaryStream = 160;  // of the hash

// What the first sweep of a stage does, p[2].
enum Mode : uint8_t { freezes = 1, resets_on = 2, resets_off = 4, leaves = 8, holds = 16 };

static bool wide(const Model& model) { return model.cell == grid::Cell::int32; }

// Bits after the point of a cell.
static uint8_t bits_of(const Model& model) {
  const uint8_t cut = kinetics::cut_of(model);
  return cut > 0 ? static_cast<uint8_t>(kinetics::kWide - cut) : wide(model) ? kinetics::kWide : kinetics::kNarrow;
}

void prepare_kinetics(const Context& context) {
  const int32_t* number = context.number;
  int32_t* table = context.table;
  const stencil::EightWeights w = stencil::eight_weights(number[kinetics::stretch], number[kinetics::angle]);
  table[0] = w.x;
  table[1] = w.y;
  table[2] = w.fall;
  table[3] = w.rise;
  table[shown_plane] = number[kinetics::show];
  table[held_apart] = number[kinetics::held];
  table[morphogens] = context.model->planes(number);
  table[varies] = kinetics::fixed(number[kinetics::vary], kinetics::kVaryBits);
  table[vary_count] = 2 * table[varies] + 1;
  table[origin_x] = context.ground->x >> context.level;
  table[origin_y] = context.ground->y >> context.level;
  table[ring_x] = context.ground->width >> context.level;
  table[ring_y] = context.ground->height >> context.level;
  table[on_plane] = context.plane;
  table[seed_of] = static_cast<int32_t>(context.seed);
  table[wide_cells] = wide(*context.model);
  table[has_rates] = table[varies] > 0;
  table[level_of] = context.level;
  table[cut_bits] = kinetics::cut_of(*context.model);
  table[linked] = table[graded] = 0;
  table[moved] = 0;
}

void prepare_pictured(const Context& context) {
  prepare_kinetics(context);
  context.table[has_rates] = 1;
  base::copy_bytes(context.table + table_count, &context.stored, sizeof context.stored);
}

// Cells of either width, where there are few: once a stage.
DAPPLE_APART static int32_t cell_at(const grid::Rows& rows, const void* row, uint16_t x) {
  return rows.table[wide_cells] != 0 ? static_cast<const int32_t*>(row)[x] : static_cast<const int16_t*>(row)[x];
}
DAPPLE_APART void set_cell(const grid::Rows& rows, void* row, uint16_t x, int32_t value) {
  if (rows.table[wide_cells] != 0) static_cast<int32_t*>(row)[x] = value;
  else static_cast<int16_t*>(row)[x] = static_cast<int16_t>(value);
}

// A uniform deviation for every cell, the same whatever the order.
static void vary_cells(const grid::Rows& rows, void* row) {
  const int32_t* t = rows.table;
  const uint16_t width = static_cast<uint16_t>(t[ring_x]), height = static_cast<uint16_t>(t[ring_y]);
  const bool plane = t[on_plane] != 0;
  const base::RowKey key =
      base::row_key(static_cast<uint32_t>(t[seed_of]), kVaryStream, start::world(t[origin_y] + rows.y, height, plane));
  int32_t at = start::world(t[origin_x] + rows.x, width, plane);
  for (uint16_t x = 0; x < rows.n; ++x) {
    const uint32_t share = base::below(base::hash(key, at), static_cast<uint32_t>(t[vary_count]));
    const int32_t off = static_cast<int32_t>(share) - t[varies];
    set_cell(rows, row, x, t[cut_bits] != 0 ? off / kVaryCut : off);
    if (++at == width && !plane) at = 0;
  }
}

// The first sweep of a stage: what varies, what is held, what goes back to the uniform state. All planes in place.
// p: {threshold, shown plane, Mode, uniform state of every morphogen}, in the cells' format.
void enter_row(const grid::Rows& rows) {
  const uint8_t planes = kept_at(rows);
  const int32_t mode = rows.p[2];
  if (rows.table[varies] > 0) vary_cells(rows, rows.out[planes]);
  if ((mode & holds) == 0) return;
  void* const mask = rows.out[held_at(rows)];
  const void* const shown = rows.out[rows.p[1]];
  for (uint16_t x = 0; x < rows.n; ++x) {
    const bool on = cell_at(rows, shown, x) > rows.p[0];
    if ((mode & leaves) == 0) set_cell(rows, mask, x, on && (mode & freezes) != 0 ? -1 : 0);
    if ((mode & (on ? resets_on : resets_off)) == 0) continue;
    for (uint8_t i = 0; i < planes; ++i) set_cell(rows, rows.out[i], x, rows.p[3 + i]);
  }
}

// The first sweep of a stage that grows by a picture: what growth has more than the recipe's number. p: {where the
// picture is black, how much more where it is white}, Q12, |.| <= 28 * 2^12; grey in Q6 <= 16320: products < 2^31.
void picture_row(const grid::Rows& rows) {
  const int32_t* t = rows.table;
  const bool plane = t[on_plane] != 0;
  const uint16_t period = static_cast<uint16_t>(stencil::kPlanePeriod >> t[level_of]);
  void* const more = rows.out[kept_at(rows)];
  const int32_t unit = t[cut_bits] != 0 ? kVaryCut : 1;
  int32_t* const grey = reinterpret_cast<int32_t*>(rows.scratch);
  const void* maps = nullptr;
  base::copy_bytes(&maps, t + table_count, sizeof maps);
  vary_cells(rows, more);
  stencil::grey_row(static_cast<const PlaceMaps*>(maps)->grey, t[origin_x] + rows.x, t[origin_y] + rows.y,
                    plane ? period : static_cast<uint16_t>(t[ring_x]),
                    plane ? period : static_cast<uint16_t>(t[ring_y]), rows.n, grey);
  for (uint16_t x = 0; x < rows.n; ++x)
    set_cell(rows, more, x, cell_at(rows, more, x) + (rows.p[0] + rows.p[1] * (grey[x] >> 2) / 16320) / unit);
}

static int32_t mode_of(const Context& context, bool has_mask) {
  const bool begins = context.entry == Entry::freeze || context.entry == Entry::reset;
  const int32_t reset = begins ? context.number[kinetics::reset] : 0;
  return (has_mask ? holds : 0) | (context.entry == Entry::freeze ? freezes : 0) |
         (context.entry == Entry::carry ? leaves : 0) |
         (reset == kinetics::on    ? resets_on
          : reset == kinetics::off ? resets_off
                                   : 0);
}

static void all_planes(const Context& context, bool has_mask, Sweep& sweep) {
  sweep.first = 0;
  sweep.count = static_cast<uint8_t>(context.model->planes(context.number) + kept_by(context.number, has_mask));
}

void enter_sweep(const Context& context, bool has_mask, Sweep& sweep) {
  const Model& model = *context.model;
  all_planes(context, has_mask, sweep);
  sweep.radius = 0;
  sweep.row = enter_row;
  sweep.p[0] = kinetics::fixed(context.number[kinetics::above], bits_of(model));
  sweep.p[1] = context.number[kinetics::show];
  sweep.p[2] = mode_of(context, has_mask);
  for (uint8_t i = 0; i < model.planes(context.number); ++i)
    sweep.p[3 + i] = model.levels(context.number, i).background;
}

void step_sweep(const Context& context, bool has_mask, grid::RowKernel row, Sweep& sweep) {
  const bool isotropic = context.number[kinetics::stretch] == base::kMicro;
  const grid::RowKernel round = wide(*context.model) ? stencil::five_wide_row : stencil::five_narrow_row;
  const grid::RowKernel oval = wide(*context.model) ? stencil::eight_wide_row : stencil::eight_narrow_row;
  all_planes(context, has_mask, sweep);
  sweep.radius = 1;
  sweep.stride = sweep.halo = 1;
  sweep.row = grid::choose(context.kernels, row);
  sweep.part[0] = grid::choose(context.kernels, isotropic ? round : oval);
  sweep.part[1] = grid::choose(context.kernels, context.model->react);
  context.model->values(context.number, context.clock, sweep.p);
  sweep.p[kStepOf] = context.table[cut_bits] != 0 ? static_cast<int32_t>(context.clock.step) : 0;
}

bool kinetics_next(const Context& context, Cursor& cursor, Sweep& sweep) {
  const bool enters = context.first && context.number[kinetics::vary] > 0;
  const uint16_t at = cursor.sweep++;
  if (enters && at == 0) enter_sweep(context, false, sweep);
  else step_sweep(context, false, kinetics_row, sweep);
  return at <= (enters ? 1 : 0);
}

void picture_sweep(const Context& context, Sweep& sweep) {
  const int32_t* number = context.number;
  sweep.first = 0;
  sweep.count = static_cast<uint8_t>(context.model->planes(number) + 1);
  sweep.radius = 0;
  sweep.row = picture_row;
  sweep.p[0] = kinetics::fixed(number[turing::dark] - number[turing::growth], kinetics::kVaryBits);
  sweep.p[1] = kinetics::fixed(number[turing::lit] - number[turing::dark], kinetics::kVaryBits);
}
void pictured_sweep(const Context& context, grid::RowKernel row, Sweep& sweep) {
  step_sweep(context, false, row, sweep);
  sweep.count = static_cast<uint8_t>(context.model->planes(context.number) + 1);
  sweep.p[turing::kGrown] = 1;
}

bool pictured_next(const Context& context, Cursor& cursor, Sweep& sweep) {
  const uint16_t at = cursor.sweep++;
  if (context.first && at == 0) picture_sweep(context, sweep);
  else pictured_sweep(context, kinetics_row, sweep);
  return at <= (context.first ? 1 : 0);
}

bool cascade_next(const Context& context, Cursor& cursor, Sweep& sweep) {
  const uint16_t at = cursor.sweep++;
  if (context.first && at == 0) enter_sweep(context, true, sweep);
  else step_sweep(context, true, cascade_row, sweep);
  return at <= (context.first ? 1 : 0);
}

template <class T>
static int16_t field_of(T cell) {
  return static_cast<int16_t>(sizeof(T) == 4 ? (cell + (1 << (kinetics::kWide - kinetics::kShown - 1))) >>
                                                   (kinetics::kWide - kinetics::kShown)
                                             : cell);
}
template <class T>
static void field_row_of(const void* cells, uint16_t x, uint16_t n, int16_t* out) {
  const T* const from = static_cast<const T*>(cells) + x;
  for (uint16_t i = 0; i < n; ++i) out[i] = field_of(from[i]);
}

// The shown morphogen.
static void shown_row(const grid::Rows& rows) {
  const void* const shown = rows.in[rows.table[shown_plane]];
  if (rows.table[wide_cells] != 0) field_row_of<int32_t>(shown, rows.x, rows.n, grid::out16(rows, 0));
  else field_row_of<int16_t>(shown, rows.x, rows.n, grid::out16(rows, 0));
}

static int16_t moved_by(int16_t value, int32_t more) {
  return static_cast<int16_t>(base::clamp(value + more, -32767, 32767));
}

void kinetics_field(const grid::Rows& rows) {
  shown_row(rows);
  int16_t* const out = grid::out16(rows, 0);
  const int32_t more = rows.table[moved];
  for (uint16_t x = 0; x < rows.n && more != 0; ++x) out[x] = moved_by(out[x], more);
}

// Held cells show as their negative, and are not moved, where they are to look apart.
void cascade_field(const grid::Rows& rows) {
  if (rows.run == 0 || rows.table[held_apart] == 0) return kinetics_field(rows);
  shown_row(rows);
  const uint8_t cell = rows.table[wide_cells] != 0 ? 4 : 2;
  const uint8_t* const mask = static_cast<const uint8_t*>(rows.in[held_at(rows)]) + static_cast<size_t>(rows.x) * cell;
  int16_t* const out = grid::out16(rows, 0);
  for (uint16_t x = 0; x < rows.n; ++x) {
    const bool held = mask[static_cast<size_t>(x) * cell] != 0;
    out[x] = held ? static_cast<int16_t>(-out[x]) : moved_by(out[x], rows.table[moved]);
  }
}

// Of the tile; a patch is grown with an edge of one cell more.
static uint8_t edge_of(const Run& run) { return run.domain.plane ? 1 : 0; }
static uint32_t cells_above(const Run& run, int32_t level, int16_t* row, uint8_t* work) {
  const uint8_t edge = edge_of(run);
  uint32_t count = 0;
  for (uint16_t y = edge; y < run.domain.height - edge; ++y) {
    field_row(run, y, row, work);
    for (uint16_t x = edge; x < run.domain.width - edge; ++x) count += row[x] > level ? 1 : 0;
  }
  return count;
}

// The least level with at most the share of cells above it, an exact quantile, in seventeen looks at all cells and no
// memory; the field is then moved from there to `above`.
void look_at_share(const Run& run, int16_t* row, uint8_t* work) {
  run.table[moved] = 0;
  const int32_t share = run.stage.number[kinetics::coverage];
  const bool whole = run.phase == Phase::sweeping || run.phase == Phase::sealing || run.phase == Phase::done;
  if (share == 0 || !whole) return;
  const uint16_t width = static_cast<uint16_t>(run.domain.width - 2 * edge_of(run));
  const uint64_t cells = static_cast<uint64_t>(width) * static_cast<uint16_t>(run.domain.height - 2 * edge_of(run));
  const uint32_t wanted = static_cast<uint32_t>((cells * static_cast<uint32_t>(share) + base::kMicro / 2) / base::kMicro);
  int32_t low = -32768, high = 32767;
  while (low < high) {
    const int32_t middle = (low + high + 65536) / 2 - 32768;
    if (cells_above(run, middle, row, work) > wanted) low = middle + 1;
    else high = middle;
  }
  run.table[moved] = run.model.cell_level(run.stage.number) - low;
}

}  // namespace dapple::evolve
