// Passes in divergence form along a map of directions. See flux.hpp.
// SPDX-License-Identifier: MIT
#include "flux_cell.hpp"

namespace dapple::stencil {

using grid::Cell;

// The same of vectors that are mirrored already.
static void pull_vectors(uint8_t way, const i16* DAPPLE_RESTRICT x, const i16* DAPPLE_RESTRICT y,
                         i16* DAPPLE_RESTRICT out, uint16_t n) {
  for (uint16_t k = 0; k < n && way < 2; ++k) out[k] = half(axis_of(x[k], y[k]));
  for (uint16_t k = 0; k < n && way >= 2 && way < 4; ++k) out[k] = half(diagonal_of(x[k], y[k]));
  for (uint16_t k = 0; k < n && way >= 4; ++k) out[k] = half(knight_of(x[k], y[k]));
}

// The pull of every link.
static void link_row(const i16* DAPPLE_RESTRICT from, const i16* DAPPLE_RESTRICT to, i16* DAPPLE_RESTRICT out,
                     uint16_t n) {
  for (uint16_t x = 0; x < n; ++x) out[x] = static_cast<i16>(from[x] + to[x]);
}
// What it lacks by its styles, the mean of both ends.
static void lack_row(const i16* DAPPLE_RESTRICT from, const i16* DAPPLE_RESTRICT to, i16* DAPPLE_RESTRICT out,
                     uint16_t n) {
  for (uint16_t x = 0; x < n; ++x) out[x] = static_cast<i16>(half(from[x]) + half(to[x]));
}

// Where styles shorten the wavelength the share is less by its lack, Q15: q (1 - lack).
static inline i16 carried_less(i16 link, i16 lack, i16 from, i16 to, FluxStage s) {
  const i16 q = static_cast<i16>(mulhi(link, s.slope) + s.mean);
  return carried_of(static_cast<i16>(q - static_cast<i16>(2 * mulhi(q, lack)) - s.before), from, to, s);
}
// On a surface the mean is the link's own.
DAPPLE_APART static void carry_mean(const i16* DAPPLE_RESTRICT link, const i16* DAPPLE_RESTRICT mean,
                                    const i16* DAPPLE_RESTRICT from, const i16* DAPPLE_RESTRICT to,
                                    i16* DAPPLE_RESTRICT flux, uint16_t n, FluxStage s) {
  for (uint16_t x = 0; x < n; ++x)
    flux[x] =
        carried_of(static_cast<i16>(mulhi(link[x], s.slope) + static_cast<i16>(mean[x] - s.before)), from[x], to[x], s);
}
// Means are at most 16000.
static void mean_row(const i16* DAPPLE_RESTRICT from, const i16* DAPPLE_RESTRICT to, i16* DAPPLE_RESTRICT out,
                     uint16_t n) {
  for (uint16_t x = 0; x < n; ++x) out[x] = static_cast<i16>((from[x] + to[x]) >> 1);
}
DAPPLE_APART static void carry_row(const i16* DAPPLE_RESTRICT pull, const i16* DAPPLE_RESTRICT pull_to,
                                   const i16* DAPPLE_RESTRICT from, const i16* DAPPLE_RESTRICT to,
                                   i16* DAPPLE_RESTRICT flux, uint16_t n, FluxStage s) {
  for (uint16_t x = 0; x < n; ++x) flux[x] = carried(static_cast<i16>(pull[x] + pull_to[x]), from[x], to[x], s);
}
// The same, and what comes of it: plus what comes from ahead, less what went on from behind.
DAPPLE_APART static void move_row(const i16* DAPPLE_RESTRICT pull, const i16* DAPPLE_RESTRICT pull_to,
                                  const i16* DAPPLE_RESTRICT from, const i16* DAPPLE_RESTRICT to,
                                  const i16* DAPPLE_RESTRICT behind, i16* DAPPLE_RESTRICT flux,
                                  i16* DAPPLE_RESTRICT out, uint16_t n, FluxStage s) {
  for (uint16_t x = 0; x < n; ++x) {
    const i16 ahead = carried(static_cast<i16>(pull[x] + pull_to[x]), from[x], to[x], s);
    flux[x] = ahead;
    out[x] = static_cast<i16>(from[x] + ahead - behind[x]);
  }
}

DAPPLE_APART static void carry_less(const i16* DAPPLE_RESTRICT link, const i16* DAPPLE_RESTRICT lack,
                                    const i16* DAPPLE_RESTRICT from, const i16* DAPPLE_RESTRICT to,
                                    i16* DAPPLE_RESTRICT flux, uint16_t n, FluxStage s) {
  for (uint16_t x = 0; x < n; ++x) flux[x] = carried_less(link[x], lack[x], from[x], to[x], s);
}

static void add_row(const i16* DAPPLE_RESTRICT from, const i16* DAPPLE_RESTRICT ahead,
                    const i16* DAPPLE_RESTRICT behind, i16* DAPPLE_RESTRICT out, uint16_t n) {
  for (uint16_t x = 0; x < n; ++x) out[x] = static_cast<i16>(from[x] + ahead[x] - behind[x]);
}

static FluxWork work_of(const grid::Rows& rows, const FluxSet& set) {
  return {rows.scratch + grid::halo_bytes(Cell::int16, set.halo), grid::scratch_bytes(Cell::int16, rows.n, set.halo),
          rows.n, set.halo};
}
static i16* slot(const FluxWork& w, uint8_t i) { return reinterpret_cast<i16*>(w.base + i * w.row); }
static void wrap(const FluxWork& w, i16* row, uint16_t halo) { grid::wrap_row(Cell::int16, row, w.n, halo); }

// Slots: two rows of every stream's pulls, two of every plane's flux, which take turns; the links; the maps.
static uint8_t pull_slot(uint8_t stream, uint8_t turn) { return static_cast<uint8_t>(2 * stream + turn); }
static uint8_t flux_slot(const FluxSet& set, uint8_t plane, uint8_t turn) {
  return static_cast<uint8_t>(2 * (set.streams + plane) + turn);
}
static uint8_t link_slot(const FluxSet& set) { return static_cast<uint8_t>(2 * (set.streams + set.planes)); }
static uint8_t map_slot(const FluxSet& set, uint8_t map) { return static_cast<uint8_t>(link_slot(set) + 1 + map); }
// On a surface in their places: the links' means, a vector, and two rows of means of every stream.
static uint8_t mean_slot(const FluxSet& set, uint8_t stream, uint8_t turn) {
  return map_slot(set, static_cast<uint8_t>(3 + 2 * stream + turn));
}

static const FluxSet& set_of(const grid::Rows& rows) { return *reinterpret_cast<const FluxSet*>(rows.table); }

static const SurfaceWork& work_on(const FluxSet& set) { return *images_of(set.map).surface->work; }
static const StyleWork& styles_of(const FluxSet& set) { return *images_of(set.map).style.work; }

void keep_map_row(const grid::Rows& rows) {
  const FluxSet& set = set_of(rows);
  for (uint8_t i = 0; i < set.maps; ++i) place_row(set.map, i, rows.y, rows.n, grid::out16(rows, i));
  if (set.warped) {
    int16_t* out[kInverseRows];
    for (uint8_t i = 0; i < kInverseRows; ++i) out[i] = grid::out16(rows, static_cast<uint8_t>(set.maps + i));
    work_on(set).inverse_row(set.map, rows.y, rows.n, out);
  }
  if (set.styled)
    styles_of(set).row(set.map, rows.y, rows.n, grid::out16(rows, set.maps),
                       grid::out16(rows, static_cast<uint8_t>(set.maps + 1)));
}

// A stream's pulls and means on a surface; cells: the rows of its map and of V.
static void warp_stream(const FluxSet& set, const FluxWork& w, uint8_t way, uint8_t stream, uint8_t turn, uint16_t halo,
                        const i16* const* cells) {
  const FluxSet::Stream& s = set.stream[stream];
  const Spread& spread = set.spread[stream];
  const Warp& warp = reinterpret_cast<const Warp*>(&set + 1)[stream];
  i16 *const x = slot(w, map_slot(set, 1)), *const y = slot(w, map_slot(set, 2));
  i16 *const means = slot(w, mean_slot(set, stream, turn)), *const out = slot(w, pull_slot(stream, turn));
  warp_row({cells[0], cells[1], cells[2], cells[3], s.c, s.s, static_cast<int8_t>(flip_x_of(way)),
            static_cast<int8_t>(flip_y_of(way))},
           warp, spread.mean, x, y, means, w.n);
  pull_vectors(way, x, y, out, w.n);
  wrap(w, means, halo);
  wrap(w, out, halo);
}

// A pass, and the row it is at. turn: which of two slots holds what belongs to the links behind row y.
struct Pulling {
  const grid::Rows* rows;
  const FluxSet* set;
  FluxWork work;
  int32_t shift;  // cells from a link's one end to the other
  uint16_t halo;
  uint8_t way, stage, turn;
};

// Row k of the windows: every stream's pulls into its slot of turn `turn`.
static void pull_at(const Pulling& p, uint8_t k, uint8_t turn) {
  const FluxSet& set = *p.set;
  const int32_t stride = static_cast<int32_t>(stride_of(p.stage)) * way_of(p.way).vy;
  for (uint8_t i = 0; i < set.maps && !set.kept; ++i)
    place_row(set.map, i, p.rows->y + (k - INT32_C(1)) * stride, p.work.n, slot(p.work, map_slot(set, i)));
  for (uint8_t stream = 0; stream < set.streams && set.warped; ++stream) {
    const i16* cells[1 + kInverseRows] = {
        grid::in16(*p.rows, static_cast<uint8_t>(3 * (set.planes + set.stream[stream].map) + k))};
    for (uint8_t i = 0; i < kInverseRows; ++i)
      cells[1 + i] = grid::in16(*p.rows, static_cast<uint8_t>(3 * (set.planes + set.maps + i) + k));
    work_on(set).stream(set, p.work, p.way, stream, turn, p.halo, cells);
  }
  for (uint8_t stream = 0; stream < set.streams && !set.warped; ++stream) {
    const uint8_t map = set.stream[stream].map;
    const i16* cells = set.kept ? grid::in16(*p.rows, static_cast<uint8_t>(3 * (set.planes + map) + k))
                                : slot(p.work, map_slot(set, map));
    i16* const out = slot(p.work, pull_slot(stream, turn));
    pull_row(set.stream[stream], p.way, cells, out, p.work.n);
    wrap(p.work, out, p.halo);
  }
}

// The links between rows k and k + 1; from row y on (k = 1) also what comes of it.
static void between(const Pulling& p, uint8_t k) {
  const FluxSet& set = *p.set;
  const uint8_t here = static_cast<uint8_t>(p.turn ^ (k ^ 1)), ahead = static_cast<uint8_t>(here ^ 1);
  i16* const link = slot(p.work, link_slot(set));
  pull_at(p, static_cast<uint8_t>(k + 1), ahead);
  i16* const lack = slot(p.work, map_slot(set, 0));  // or means
  const bool own_means = set.warped && p.way < 2;
  const uint8_t style = static_cast<uint8_t>(3 * (set.planes + set.maps) + k);
  if (set.styled)
    lack_row(grid::in16(*p.rows, style), grid::in16(*p.rows, static_cast<uint8_t>(style + 1)) + p.shift, lack,
             p.work.n);
  for (uint8_t stream = 0; stream < set.streams; ++stream) {
    const i16* const pull = slot(p.work, pull_slot(stream, here));
    const i16* const pull_to = slot(p.work, pull_slot(stream, ahead)) + p.shift;
    if (set.styled || own_means) link_row(pull, pull_to, link, p.work.n);
    if (own_means)
      mean_row(slot(p.work, mean_slot(set, stream, here)), slot(p.work, mean_slot(set, stream, ahead)) + p.shift, lack,
               p.work.n);
    for (uint8_t plane = 0; plane < set.planes; ++plane) {
      const Spread& spread = set.spread[plane];
      if (spread.stream != stream || !takes(spread, p.way, p.stage)) continue;
      const FluxStage stage = stage_of(spread, p.way, p.stage);
      const i16* const from = grid::in16(*p.rows, static_cast<uint8_t>(3 * plane + k));
      const i16* const to = grid::in16(*p.rows, static_cast<uint8_t>(3 * plane + k + 1)) + p.shift;
      const i16* const behind = slot(p.work, flux_slot(set, plane, here)) - p.shift;
      i16* const flux = slot(p.work, flux_slot(set, plane, ahead));
      i16* const out = grid::out16(*p.rows, plane);
      if (own_means) work_on(set).carry(link, lack, from, to, flux, p.work.n, stage);
      else if (set.styled) styles_of(set).carry(link, lack, from, to, flux, p.work.n, stage);
      else if (k == 0) carry_row(pull, pull_to, from, to, flux, p.work.n, stage);
      else move_row(pull, pull_to, from, to, behind, flux, out, p.work.n, stage);
      if ((set.styled || own_means) && k == 1) add_row(from, flux, behind, out, p.work.n);
      wrap(p.work, flux, p.halo);
    }
  }
}

void flux_row(const grid::Rows& rows) {
  const FluxSet& set = set_of(rows);
  const uint8_t way = static_cast<uint8_t>(rows.p[0]), stage = static_cast<uint8_t>(rows.p[1]);
  const int32_t shift = static_cast<int32_t>(stride_of(stage)) * way_of(way).vx;
  const Pulling p = {&rows,
                     &set,
                     work_of(rows, set),
                     shift,
                     static_cast<uint16_t>(shift < 0 ? -shift : shift),
                     way,
                     stage,
                     static_cast<uint8_t>(rows.run & 1)};
  if (rows.run == 0) {
    pull_at(p, 0, 1);
    between(p, 0);
  }
  between(p, 1);
}

// All stages of a plane along a row. lack: of the cells, or on a surface their means.
static void chain(const FluxSet& set, const FluxWork& w, uint8_t plane, const i16* pull, const i16* lack, i16* row) {
  const Spread& spread = set.spread[plane];
  i16* const link = slot(w, link_slot(set));
  i16* const copy = slot(w, flux_slot(set, 0, 0));
  i16* const flux = slot(w, flux_slot(set, 0, 1));
  for (uint8_t stage = 0; takes(spread, 0, stage); ++stage) {
    const uint16_t stride = stride_of(stage);
    grid::copy_row(Cell::int16, copy, row, w.n, stride);
    if (set.styled || set.warped) link_row(pull, pull + stride, link, w.n);
    if (set.warped) {
      i16* const mean = slot(w, map_slot(set, 0));
      mean_row(lack, lack + stride, mean, w.n);
      work_on(set).carry(link, mean, copy, copy + stride, flux, w.n, stage_of(spread, 0, stage));
    } else if (set.styled) {
      i16* const less = slot(w, flux_slot(set, 1, 0));
      lack_row(lack, lack + stride, less, w.n);
      styles_of(set).carry(link, less, copy, copy + stride, flux, w.n, stage_of(spread, 0, stage));
    } else {
      carry_row(pull, pull + stride, copy, copy + stride, flux, w.n, stage_of(spread, 0, stage));
    }
    wrap(w, flux, stride);
    add_row(copy, flux, flux - stride, row, w.n);
  }
}

void flux_chain_row(const grid::Rows& rows) {
  const FluxSet& set = set_of(rows);
  const FluxWork w = work_of(rows, set);
  for (uint8_t i = 0; i < set.maps && !set.kept; ++i) place_row(set.map, i, rows.y, w.n, slot(w, map_slot(set, i)));
  i16* const lack = slot(w, map_slot(set, 0));
  if (set.styled)
    grid::copy_row(Cell::int16, lack, grid::out16(rows, static_cast<uint8_t>(set.planes + set.maps)), w.n, w.halo);
  for (uint8_t stream = 0; stream < set.streams && set.warped; ++stream) {
    const i16* cells[1 + kInverseRows] = {grid::out16(rows, static_cast<uint8_t>(set.planes + set.stream[stream].map))};
    for (uint8_t i = 0; i < kInverseRows; ++i)
      cells[1 + i] = grid::out16(rows, static_cast<uint8_t>(set.planes + set.maps + i));
    work_on(set).stream(set, w, 0, stream, 0, w.halo, cells);
    chain(set, w, stream, slot(w, pull_slot(stream, 0)), slot(w, mean_slot(set, stream, 0)), grid::out16(rows, stream));
  }
  for (uint8_t stream = 0; stream < set.streams && !set.warped; ++stream) {
    i16* const pull = slot(w, pull_slot(stream, 0));
    const uint8_t map = set.stream[stream].map;
    pull_row(set.stream[stream], 0,
             set.kept ? grid::out16(rows, static_cast<uint8_t>(set.planes + map)) : slot(w, map_slot(set, map)), pull,
             w.n);
    wrap(w, pull, w.halo);
    for (uint8_t plane = 0; plane < set.planes; ++plane)
      if (set.spread[plane].stream == stream) chain(set, w, plane, pull, lack, grid::out16(rows, plane));
  }
}

extern const StyleWork style_work = {style_row, carry_less};
extern const SurfaceWork surface_work = {inverse_row, warp_stream, carry_mean};

}  // namespace dapple::stencil
