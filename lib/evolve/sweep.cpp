// Sweeps in coset order. See sweep.hpp for the picture.
// SPDX-License-Identifier: MIT
#include "sweep.hpp"

namespace dapple::evolve {

// The windows of a band: per plane 2 r + 1 ring rows, r first rows, then (several bands) r rows before and r after the
// band's first part of a coset (head), and the same for its last part (tail).
struct Windows {
  uint8_t* base;
  size_t row, plane;  // bytes from row to row, from plane to plane
  uint8_t radius;
};

static Windows windows_of(const Field& field, const Sweep& sweep, uint8_t index) {
  const size_t before = grid::halo_bytes(field.cell, sweep.halo);
  const size_t row = grid::scratch_bytes(field.cell, field.width, sweep.halo);
  return {field.scratch + index * field.band_bytes + before, row,
          grid::align4(row * window_rows(sweep.radius, field.bands)), sweep.radius};
}

static uint8_t* slot_of(const Windows& w, uint8_t plane, uint16_t slot) { return w.base + plane * w.plane + slot * w.row; }
static uint16_t first_slot(uint8_t radius) { return static_cast<uint16_t>(2 * radius + 1); }
static uint16_t head_slot(uint8_t radius) { return static_cast<uint16_t>(3 * radius + 1); }
static uint16_t tail_slot(uint8_t radius) { return static_cast<uint16_t>(5 * radius + 1); }

struct Order {
  uint16_t stride, cosets, length;
};
static Order order_of(const Field& field, const Sweep& sweep) {
  if (sweep.radius == 0) return {1, 1, field.height};
  const uint16_t stride = static_cast<uint16_t>(sweep.stride % field.height);
  const uint16_t cosets = base::gcd(stride, field.height);
  return {stride, cosets, static_cast<uint16_t>(field.height / cosets)};
}

// Row of position index in a coset, index taken modulo the coset's length.
static uint16_t row_at(const Order& order, uint16_t height, uint16_t coset, int32_t index) {
  int32_t i = index % order.length;
  if (i < 0) i += order.length;
  return static_cast<uint16_t>((coset + static_cast<uint32_t>(i) * order.stride) % height);
}

static void save(const Field& field, const Sweep& sweep, const Windows& w, uint16_t slot, uint16_t y) {
  for (uint8_t i = 0; i < sweep.count; ++i)
    grid::copy_row(field.cell, slot_of(w, i, slot), row_of(field, static_cast<uint8_t>(sweep.first + i), y), field.width, sweep.halo);
}

static void copy_slots(const Field& field, const Sweep& sweep, const Windows& w, uint16_t to, uint16_t from) {
  const size_t before = grid::halo_bytes(field.cell, sweep.halo);
  for (uint8_t i = 0; i < sweep.count; ++i)
    grid::copy_bytes(slot_of(w, i, to) - before, slot_of(w, i, from) - before, w.row);
}

// Saves the r rows before `from` and the r rows from `stop` on, for a band that holds only a part of a coset.
static void save_edges(const Field& field, const Sweep& sweep, const Windows& w, const Order& order, uint16_t slot,
                       uint16_t coset, uint16_t from, uint16_t stop) {
  for (uint8_t k = 0; k < sweep.radius; ++k) {
    save(field, sweep, w, static_cast<uint16_t>(slot + k), row_at(order, field.height, coset, static_cast<int32_t>(from) - sweep.radius + k));
    save(field, sweep, w, static_cast<uint16_t>(slot + sweep.radius + k), row_at(order, field.height, coset, static_cast<int32_t>(stop) + k));
  }
}

// The first position of band `index`; of one past the last: the end. A margin is left out, which only sweeps over
// neighbouring rows have.
static uint16_t first_of(const Field& field, const Sweep& sweep, uint8_t index) {
  const uint32_t rows = sweep.tile > 0 ? sweep.tile : static_cast<uint32_t>(field.height) - 2u * sweep.margin;
  return static_cast<uint16_t>(sweep.margin + rows * index / field.bands);
}

// A single band inside a margin needs no saved rows: what lies before and behind it stays as it is.
static bool open_ended(const Field& field, const Sweep& sweep) { return sweep.margin > 0 && field.bands == 1; }

void begin_sweep(const Field& field, const Sweep& sweep, Band* bands) {
  const Order order = order_of(field, sweep);
  for (uint8_t b = 0; b < field.bands; ++b) {
    Band& band = bands[b];
    band.next = first_of(field, sweep, b);
    band.end = first_of(field, sweep, static_cast<uint8_t>(b + 1));
    band.coset = static_cast<uint16_t>(band.next / order.length);
    band.index = static_cast<uint16_t>(band.next % order.length);
    band.y = row_at(order, field.height, band.coset, band.index);
    band.run = 0;
    band.open = false;
    if (field.bands == 1 || sweep.radius == 0 || band.next == band.end) continue;
    const Windows w = windows_of(field, sweep, b);
    const uint16_t last = static_cast<uint16_t>((band.end - 1) / order.length);
    const uint16_t stop = static_cast<uint16_t>((band.end - 1) % order.length + 1);
    save_edges(field, sweep, w, order, head_slot(sweep.radius), band.coset, band.index, last == band.coset ? stop : order.length);
    save_edges(field, sweep, w, order, tail_slot(sweep.radius), last, last == band.coset ? band.index : 0, stop);
  }
}

// Fills the ring with the rows before and at the start of a coset part, and readies the rows after its end.
static void open_coset(const Field& field, const Sweep& sweep, const Windows& w, const Order& order, uint16_t start, Band& band) {
  const uint32_t left = static_cast<uint32_t>(band.end) - band.next;
  const uint32_t whole = static_cast<uint32_t>(order.length) - band.index;
  band.stop = static_cast<uint16_t>(band.index + (left < whole ? left : whole));
  const uint8_t r = sweep.radius;
  const bool part = (band.index != 0 || band.stop != order.length) && !open_ended(field, sweep);
  const uint16_t edges = band.next == start ? head_slot(r) : tail_slot(r);
  for (uint16_t k = 0; k < 2 * r; ++k) {
    const int32_t at = static_cast<int32_t>(band.index) - r + k;
    if (part && k < r)
      copy_slots(field, sweep, w, k, static_cast<uint16_t>(edges + k));
    else if (part && at >= band.stop)
      copy_slots(field, sweep, w, k, static_cast<uint16_t>(edges + r + at - band.stop));
    else
      save(field, sweep, w, k, row_at(order, field.height, band.coset, at));
  }
  for (uint16_t k = 0; k < r && !open_ended(field, sweep); ++k) {
    const uint16_t to = static_cast<uint16_t>(first_slot(r) + k);
    if (part)
      copy_slots(field, sweep, w, to, static_cast<uint16_t>(edges + r + k));
    else
      save(field, sweep, w, to, row_at(order, field.height, band.coset, static_cast<int32_t>(k)));
  }
  band.slot = 0;
  band.run = 0;
  band.open = true;
}

// The row r places ahead goes into `to`: from its plane, or from the saved rows past the end.
static void load_ahead(const Field& field, const Sweep& sweep, const Windows& w, const Order& order, const Band& band, uint16_t to) {
  const uint32_t ahead = static_cast<uint32_t>(band.index) + sweep.radius;
  if (ahead >= band.stop && !open_ended(field, sweep))
    return copy_slots(field, sweep, w, to, static_cast<uint16_t>(first_slot(sweep.radius) + ahead - band.stop));
  uint32_t y = band.y + static_cast<uint32_t>(sweep.radius) * order.stride;
  while (y >= field.height) y -= field.height;
  save(field, sweep, w, to, static_cast<uint16_t>(y));
}

// The kernel's rows: in[plane * ring + k] is the old row k - r places away, out[plane] the plane's own row.
static void set_rows(const Field& field, const Sweep& sweep, const Windows& w, const Band& band, uint8_t ring, grid::Rows& rows) {
  const size_t skip = grid::cell_bytes(field.cell, rows.x);
  uint8_t* out = row_of(field, sweep.first, band.y) + skip;
  for (uint8_t i = 0; i < sweep.count; ++i, out += field.plane_bytes) rows.out[i] = out;
  rows.y = band.y;
  rows.run = band.run;
  if (sweep.radius == 0) return;
  uint8_t* const end = w.base + ring * w.row;
  uint8_t* from = w.base + band.slot * w.row;
  for (uint8_t k = 0; k < ring; ++k) {
    for (uint8_t i = 0; i < sweep.count; ++i) rows.in[i * ring + k] = from + i * w.plane + skip;
    from += w.row;
    if (from == end) from = w.base;
  }
}

// Moves the band on by one position.
static void move_on(const Order& order, uint16_t height, uint8_t ring, Band& band) {
  ++band.next;
  ++band.run;
  band.slot = static_cast<uint8_t>(band.slot + 1 == ring ? 0 : band.slot + 1);
  const uint32_t y = static_cast<uint32_t>(band.y) + order.stride;
  band.y = static_cast<uint16_t>(y < height ? y : y - height);
  if (++band.index < order.length) return;
  band.index = 0;
  band.y = ++band.coset;
  band.open = false;
}

// The same rows as the loop of run_band, for the sweeps that matter most: one plane, away from the coset's end. Pointers move
// instead of being made afresh.
DAPPLE_APART static uint32_t run_ring(const Field& field, const Sweep& sweep, const Windows& w, const Order& order, grid::Rows& call,
                                      Band& band, uint32_t rows) {
  const uint8_t last = static_cast<uint8_t>(2 * sweep.radius);
  const uint32_t left = static_cast<uint32_t>(band.stop) - band.index;
  if (left <= sweep.radius) return 0;
  const uint32_t most = left - sweep.radius, count = most < rows ? most : rows;
  const size_t skip = grid::cell_bytes(field.cell, call.x);
  uint8_t* const plane = field.planes + sweep.first * field.plane_bytes;
  uint8_t slot = band.slot;
  for (uint8_t k = 0; k < last; ++k) call.in[k] = slot_of(w, 0, static_cast<uint16_t>((slot + k) % (last + 1))) + skip;
  uint32_t y = band.y, ahead = y;
  for (uint8_t k = 0; k < sweep.radius; ++k) ahead = ahead + order.stride < field.height ? ahead + order.stride : ahead + order.stride - field.height;
  for (uint32_t i = 0; i < count; ++i) {
    uint8_t* const newest = slot_of(w, 0, slot == 0 ? last : static_cast<uint16_t>(slot - 1));
    grid::copy_row(field.cell, newest, plane + ahead * field.row_bytes, field.width, sweep.halo);
    call.in[last] = newest + skip;
    call.out[0] = plane + y * field.row_bytes + skip;
    call.y = static_cast<uint16_t>(y);
    call.run = static_cast<uint16_t>(band.run + i);
    sweep.row(call);
    for (uint8_t k = 0; k < last; ++k) call.in[k] = call.in[k + 1];
    slot = slot == last ? uint8_t{0} : static_cast<uint8_t>(slot + 1);
    y = y + order.stride < field.height ? y + order.stride : y + order.stride - field.height;
    ahead = ahead + order.stride < field.height ? ahead + order.stride : ahead + order.stride - field.height;
  }
  band.y = static_cast<uint16_t>(y);
  band.next = static_cast<uint16_t>(band.next + count);
  band.index = static_cast<uint16_t>(band.index + count);
  band.run = static_cast<uint16_t>(band.run + count);
  band.slot = slot;
  return count;
}

// A kernel's own scratch memory, behind the windows of the planes. Apart: clang for AVR loses the product at -O1 and -O2,
// where it is short of registers (ports/avr/README.md).
DAPPLE_APART static uint8_t* kernel_scratch(const Field& field, const Sweep& sweep, size_t window_bytes, uint8_t index) {
  return field.scratch + index * field.band_bytes + (sweep.radius == 0 ? 0 : window_bytes * sweep.count);
}

uint32_t run_band(const Field& field, const Sweep& sweep, const int32_t* table, uint8_t index, Band& band, uint32_t rows) {
  const Order order = order_of(field, sweep);
  const Windows w = windows_of(field, sweep, index);
  const uint16_t start = first_of(field, sweep, index);
  const uint8_t ring = static_cast<uint8_t>(2 * sweep.radius + 1);
  grid::Rows call;
  call.p = sweep.p;
  call.table = table;
  call.part = sweep.part;
  call.x = static_cast<uint16_t>(sweep.margin & ~31u);  // whole words; rows stay aligned
  call.n = static_cast<uint16_t>(field.width - sweep.margin - call.x);
  call.planes = sweep.count;
  call.scratch = kernel_scratch(field, sweep, w.plane, index);
  uint32_t done = 0;
  for (; done < rows && band.next < band.end; ++done) {
    if (sweep.radius > 0) {
      if (!band.open) open_coset(field, sweep, w, order, start, band);
      if (sweep.count == 1) done += run_ring(field, sweep, w, order, call, band, rows - done);
      if (done == rows) break;
      load_ahead(field, sweep, w, order, band, static_cast<uint16_t>(band.slot == 0 ? ring - 1 : band.slot - 1));
    }
    set_rows(field, sweep, w, band, ring, call);
    sweep.row(call);
    move_on(order, field.height, ring, band);
  }
  return done;
}

}  // namespace dapple::evolve
