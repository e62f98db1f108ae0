// Sweeps that make corner tiles agree. See corners.hpp. One row of work is the four rows of the torus that are one row of every
// tile: whatever a cell has to agree with lies in them, so every sweep works in place, in any order.
// SPDX-License-Identifier: MIT
#include "corners.hpp"

namespace dapple::evolve {

using grid::Alike;
using grid::Classes;
using i16 = int16_t;

// Numbers of the kernels, behind the model's own.
constexpr uint8_t kBand = kMaxValues - 1;

// Row `y` of every tile: sixteen tiles of `side` cells in four rows, `step` cells apart.
struct TileRow {
  i16* row;
  size_t step;
  uint16_t side, y;
};

static TileRow tile_row(void* row, const grid::Rows& rows) {
  const uint16_t side = static_cast<uint16_t>(rows.n / grid::kTilesAcross);
  return {static_cast<i16*>(row), side * grid::row_bytes(grid::Cell::int16, rows.n) / 2, side, rows.y};
}

static i16& cell(const TileRow& r, uint8_t tile, uint16_t x) {
  return r.row[(tile >> 2) * r.step + static_cast<uint32_t>(tile & 3) * r.side + x];
}

// work(x, alike, log2 of the cells of a class) for every place of the row that lies in the band.
template <class Work> static void each_shared(const TileRow& r, uint16_t band, const Work& work) {
  const Classes classes = base::rom_load(&grid::kClasses);
  const grid::Nearness down = grid::nearness(r.y, r.side);
  for (uint16_t x = 0; x < r.side; ++x) {
    const grid::Nearness across = grid::nearness(x, r.side);
    if (across.distance < band && down.distance < band)
      work(x, classes.corner[down.far][across.far], grid::kCornerShare);
    else if (down.distance < band)
      work(x, classes.across[down.far], grid::kEdgeShare);
    else if (across.distance < band)
      work(x, classes.down[across.far], grid::kEdgeShare);
    else
      x = static_cast<uint16_t>(r.side - band - 1);
  }
}

// The noise of the first tile of a class for all of them: an average would be fainter. In place: out[plane].
static void copy_first_row(const grid::Rows& rows) {
  for (uint8_t plane = 0; plane < rows.planes; ++plane) {
    const TileRow r = tile_row(rows.out[plane], rows);
    each_shared(r, static_cast<uint16_t>(rows.p[kBand]), [&](uint16_t x, const Alike& alike, uint8_t) {
      for (uint8_t t = 0; t < grid::kTiles; ++t) cell(r, t, x) = cell(r, alike.first[t], x);
    });
  }
}

// The sum over each class; |sum| <= 8 * 32767.
static void add_up(const TileRow& r, uint16_t x, const Alike& alike, int32_t* sum) {
  for (uint8_t t = 0; t < grid::kTiles; ++t) sum[t] = 0;
  for (uint8_t t = 0; t < grid::kTiles; ++t) sum[alike.first[t]] += cell(r, t, x);
}

// The mean over a class, rounded up: with n cells, ceil(sum / n) > rho exactly where sum > n rho.
static void average(const TileRow& r, uint16_t band) {
  each_shared(r, band, [&](uint16_t x, const Alike& alike, uint8_t share) {
    int32_t sum[grid::kTiles];
    add_up(r, x, alike, sum);
    const int32_t up = (INT32_C(1) << share) - 1;
    for (uint8_t t = 0; t < grid::kTiles; ++t) cell(r, t, x) = static_cast<i16>((sum[alike.first[t]] + up) >> share);
  });
}

// The model's impulse with the reaction decided in common. part: {field, decided}; scratch: four rows, then the model's own.
static void share_row(const grid::Rows& rows) {
  const size_t bytes = grid::row_bytes(grid::Cell::int16, rows.n);
  const TileRow first = tile_row(rows.out[0], rows);
  TileRow field = first;
  field.row = reinterpret_cast<i16*>(rows.scratch);
  field.step = bytes / 2;
  grid::Rows own = rows;
  own.scratch = rows.scratch + grid::kTilesAcross * bytes;
  for (uint8_t k = 0; k < grid::kTilesAcross; ++k) {
    for (uint8_t i = 0; i < rows.planes; ++i) own.in[i] = grid::out16(rows, i) + k * first.step;
    own.out[0] = field.row + k * field.step;
    own.part[0](own);
  }
  average(field, static_cast<uint16_t>(rows.p[kBand]));
  for (uint8_t k = 0; k < grid::kTilesAcross; ++k) {
    own.in[0] = field.row + k * field.step;
    for (uint8_t i = 0; i < rows.planes; ++i) own.out[i] = grid::out16(rows, i) + k * first.step;
    own.part[1](own);
  }
}

// What a class agrees on: its first cell, or the mean.
static void settle(const TileRow& r, uint16_t x, const Alike& alike, uint8_t share, bool first, int32_t* value) {
  add_up(r, x, alike, value);
  for (uint8_t t = 0; t < grid::kTiles; ++t)
    if (alike.first[t] == t) value[t] = first ? cell(r, t, x) : (value[t] + (INT32_C(1) << (share - 1))) >> share;
}

// How much a cell is that of its class, Q8: all of it in the two cells at an edge, then 1 - smoothstep down to 0 at the band's
// border. slope = 65536 / (band - 1).
static int32_t profile(uint16_t distance, uint16_t band, int32_t slope) {
  if (distance < 2) return 256;
  if (distance >= band) return 0;
  const int32_t t = ((distance - 1) * slope) >> 8;  // < 256
  return 256 - ((t * t * (768 - 2 * t)) >> 16);
}

// The blend of one plane, transfinite: h the profile of the horizontal edge, v of the vertical one,
//   C' = (1-h)(1-v) C + h (1-v) A_across + v (1-h) A_down + h v A_corner
// in one sum of weights 65536: |sum| <= 65536 * 32767 + 32768 < 2^31. On an edge no weight of C is left, nor of the other edge.
static void blend_plane(const TileRow& r, uint16_t band, int32_t slope, bool first, const Classes& classes) {
  const grid::Nearness down = grid::nearness(r.y, r.side);
  const int32_t h = profile(down.distance, band, slope);
  int32_t across[grid::kTiles] = {}, beside[grid::kTiles] = {}, corner[grid::kTiles] = {};
  for (uint16_t x = 0; x < r.side; ++x) {
    const grid::Nearness near = grid::nearness(x, r.side);
    const int32_t v = profile(near.distance, band, slope);
    if (h == 0 && v == 0) continue;
    const Alike &a = classes.across[down.far], &d = classes.down[near.far], &c = classes.corner[down.far][near.far];
    if (h > 0) settle(r, x, a, grid::kEdgeShare, first, across);
    if (v > 0) settle(r, x, d, grid::kEdgeShare, first, beside);
    if (h > 0 && v > 0) settle(r, x, c, grid::kCornerShare, first, corner);
    for (uint8_t t = 0; t < grid::kTiles; ++t) {
      i16& value = cell(r, t, x);
      value = static_cast<i16>(((256 - h) * (256 - v) * value + h * (256 - v) * across[a.first[t]] +
                                v * (256 - h) * beside[d.first[t]] + h * v * corner[c.first[t]] + 32768) >> 16);
    }
  }
}

// Every plane, in place: out[plane]. p[0]: 1 towards the first of a class, 0 towards the mean.
static void blend_row(const grid::Rows& rows) {
  const Classes classes = base::rom_load(&grid::kClasses);
  const uint16_t band = static_cast<uint16_t>(rows.p[kBand]);
  for (uint8_t plane = 0; plane < rows.planes; ++plane)
    blend_plane(tile_row(rows.out[plane], rows), band, rows.p[1], rows.p[0] == 1, classes);
}

static uint16_t band_of_percent(const Context& c, int32_t percent) {
  return band_of(*c.model, c.number, percent, tile_side(*c.ground, c.level), c.level);
}

static uint16_t band_now(const Context& c, const Solver& solver, const Start& start) {
  return band_of_percent(c, percent_at(band_width(solver.sharing, start.kind), c.clock));
}

// A sweep over all planes of the model, whose numbers the sweep has already if it needs them.
static void joint_sweep(const Context& c, grid::RowKernel row, uint16_t band, Sweep& sweep) {
  sweep.row = row;
  sweep.first = 0;
  sweep.count = c.model->planes(c.number);
  sweep.radius = 0;
  sweep.tile = tile_side(*c.ground, c.level);
  sweep.p[kBand] = band;
}

static bool copies(const Context& c, const Solver& solver, const Start& start, Sweep& sweep) {
  if (c.clock.step != 0 || start.kind != Start::noise) return false;
  joint_sweep(c, copy_first_row, band_now(c, solver, start), sweep);
  return true;
}

static bool blends(const Context& c, const Solver& solver, const Start& start, Sweep& sweep) {
  const bool last = c.clock.step + 1 == c.clock.steps, state = solver.sharing == Sharing::state;
  if (!last && !(state && (c.clock.step + 1) % solver.sharing_steps == 0)) return false;
  const uint16_t band = last ? band_of_percent(c, band_width(solver.sharing, start.kind).blend) : band_now(c, solver, start);
  joint_sweep(c, blend_row, band, sweep);
  sweep.p[0] = state;
  sweep.p[1] = 65536 / (static_cast<int32_t>(band) - 1);
  return true;
}

// cursor.part: 0 the start's copies, 1 the solver's sweeps, 2 the blend.
bool corners_next(const Context& context, const Solver& solver, const Start& start, Cursor& cursor, Sweep& sweep) {
  if (cursor.part == 0) {
    cursor.part = 1;
    if (copies(context, solver, start, sweep)) return true;
  }
  if (cursor.part == 1) {
    if (solver.next(context, cursor, sweep)) {
      if (solver.sharing == Sharing::reaction && sweep.row == grid::choose(context.kernels, context.model->impulse)) {
        joint_sweep(context, share_row, band_now(context, solver, start), sweep);
        sweep.part[0] = grid::choose(context.kernels, context.model->field);
        sweep.part[1] = grid::choose(context.kernels, context.model->decided);
      }
      return true;
    }
    cursor.part = 2;
    if (blends(context, solver, start, sweep)) return true;
  }
  cursor.part = 0;
  return false;
}

void corners_start_row(const start::Place& place, const Start& start, const Solver& solver, const Context& context, uint8_t plane,
                       uint16_t y, void* row) {
  const grid::Levels levels = context.model->levels(context.number, plane);
  if (start.kind == Start::noise) return start.row(place, start, levels, plane, y, row);
  start::corner_seeds_row(place, start, levels, band_of_percent(context, band_width(solver.sharing, start.kind).narrow), y, row);
}

}  // namespace dapple::evolve
