// Sums of neighbours for kinetics, one row. See diffuse.hpp for formats.
// SPDX-License-Identifier: MIT
#include "diffuse.hpp"

namespace dapple::stencil {

// Neighbours come as pointers of their own: compilers then vectorise without a recurrence.
template <class T>
static void five(const T* DAPPLE_RESTRICT u, const T* DAPPLE_RESTRICT l, const T* DAPPLE_RESTRICT c,
                 const T* DAPPLE_RESTRICT r, const T* DAPPLE_RESTRICT d, int32_t* DAPPLE_RESTRICT out, uint16_t n) {
  for (uint16_t x = 0; x < n; ++x)
    out[x] = static_cast<int32_t>(l[x]) + r[x] + u[x] + d[x] - 4 * static_cast<int32_t>(c[x]);
}

template <class T>
static void five_of(const grid::Rows& rows) {
  const T* c = static_cast<const T*>(rows.in[1]);
  five(static_cast<const T*>(rows.in[0]), c - 1, c, c + 1, static_cast<const T*>(rows.in[2]), grid::out32(rows, 0),
       rows.n);
}
void five_wide_row(const grid::Rows& rows) { five_of<int32_t>(rows); }
void five_narrow_row(const grid::Rows& rows) { five_of<int16_t>(rows); }

// One pair of opposite neighbours; cut: bits that go before the product.
template <class T, uint8_t cut>
DAPPLE_INLINE int32_t pair(const T* a, const T* b, const T* c, uint16_t x, int32_t weight) {
  const int32_t sum = static_cast<int32_t>(a[x]) + b[x] - 2 * static_cast<int32_t>(c[x]);
  return ((sum + ((1 << cut) >> 1)) >> cut) * weight;
}

template <class T, uint8_t cut>
static void eight(const T* DAPPLE_RESTRICT u, const T* DAPPLE_RESTRICT c, const T* DAPPLE_RESTRICT d,
                  int32_t* DAPPLE_RESTRICT out, uint16_t n, EightWeights w) {
  constexpr uint8_t shift = 10 - cut;
  for (uint16_t x = 0; x < n; ++x) {
    const int32_t sum = pair<T, cut>(c - 1, c + 1, c, x, w.x) + pair<T, cut>(u, d, c, x, w.y) +
                        pair<T, cut>(u - 1, d + 1, c, x, w.fall) + pair<T, cut>(d - 1, u + 1, c, x, w.rise);
    out[x] = (sum + (1 << (shift - 1))) >> shift;
  }
}

template <class T, uint8_t cut>
static void eight_of(const grid::Rows& rows) {
  const int32_t* w = rows.table;
  eight<T, cut>(static_cast<const T*>(rows.in[0]), static_cast<const T*>(rows.in[1]), static_cast<const T*>(rows.in[2]),
                grid::out32(rows, 0), rows.n, {w[0], w[1], w[2], w[3]});
}
void eight_wide_row(const grid::Rows& rows) { eight_of<int32_t, 6>(rows); }
void eight_narrow_row(const grid::Rows& rows) { eight_of<int16_t, 0>(rows); }

void share_sums(int32_t* DAPPLE_RESTRICT sums, const void* shares, bool wide, uint16_t n) {
  const uint8_t cut = wide ? 6 : 0, shift = static_cast<uint8_t>(9 - cut);
  const int32_t half = (1 << cut) >> 1, rest = 1 << (shift - 1);
  for (uint16_t x = 0; x < n; ++x) {
    const int32_t share = wide ? static_cast<const int32_t*>(shares)[x] : static_cast<const int16_t*>(shares)[x];
    sums[x] = (((sums[x] + half) >> cut) * share + rest) >> shift;
  }
}

// --- Along a map ---

static int16_t* slot(uint8_t* links, uint8_t row, uint16_t n) {
  return reinterpret_cast<int16_t*>(links + row * grid::scratch_bytes(grid::Cell::int16, n, 1) +
                                    grid::halo_bytes(grid::Cell::int16, 1));
}
// The set of links across that is below row y, or above it.
static uint8_t set_at(const grid::Rows& rows, bool below) {
  return static_cast<uint8_t>(((rows.run & 1) != 0) == below ? kAcross : 0);
}

// Of a cell: mean - |v| +- u, or, along a diagonal, +-v; slope has the sign.
DAPPLE_INLINE int32_t weight_of(int32_t cell, LinkWeights w, int16_t slope, bool diagonal) {
  const int16_t c = static_cast<int16_t>(static_cast<uint16_t>(cell) << 8), s = static_cast<int16_t>(cell & ~255);
  const int16_t v = base::mulhi(s, w.slope);
  const int32_t rest = w.mean - (v < 0 ? -v : v);
  return base::max(diagonal ? base::mulhi(s, slope) : rest + base::mulhi(c, slope), 0);
}
// The mean of two.
static void link(const int32_t* from, const int32_t* to, int16_t* DAPPLE_RESTRICT out, uint16_t n, LinkWeights w,
                 int16_t slope, bool diagonal) {
  const int32_t* const ends[2] = {from, to};
  for (uint16_t x = 0; x < n; ++x) {
    int32_t sum = 8;
    for (uint8_t k = 0; k < 2; ++k) sum += weight_of(ends[k][x], w, slope, diagonal);
    out[x] = static_cast<int16_t>(sum >> 4);
  }
}
// From a row to the next, into a set.
static void link_across(const int32_t* from, const int32_t* to, uint8_t* links, uint8_t set, uint16_t n,
                        LinkWeights w) {
  const auto out = [&](uint8_t link) { return slot(links, static_cast<uint8_t>(set + link), n); };
  const int16_t back = static_cast<int16_t>(-w.slope);
  const uint16_t more = static_cast<uint16_t>(n + 1);
  link(from, to, out(straight), n, w, back, false);
  link(from - 1, to, out(falling) - 1, more, w, w.slope, true);
  link(from, to - 1, out(rising), more, w, back, true);
}

// Row k of three as int32: cells without the last `cut` bits, rounded, from -1 to n.
static const int32_t* cut_row(const void* cells, bool wide, uint8_t cut, uint8_t* links, uint8_t k, uint16_t n) {
  const int32_t half = (1 << cut) >> 1;
  int16_t* const first = slot(links, static_cast<uint8_t>(kRowsOfCells + 2 * k), n);
  int32_t* DAPPLE_RESTRICT const row = reinterpret_cast<int32_t*>(first) + 1;
  for (int32_t x = -1; x <= n; ++x)
    row[x] = ((wide ? static_cast<const int32_t*>(cells)[x] : static_cast<const int16_t*>(cells)[x]) + half) >> cut;
  return row;
}

void link_row(const grid::Rows& rows, const void* const* map, bool wide, LinkWeights w) {
  const uint16_t n = rows.n;
  uint8_t* const links = rows.scratch;
  const int32_t* row[3];
  for (uint8_t k = 0; k < 3; ++k) row[k] = cut_row(map[k], wide, 0, links, k, n);
  if (rows.run == 0) link_across(row[0], row[1], links, set_at(rows, false), n, w);
  link_across(row[1], row[2], links, set_at(rows, true), n, w);
  link(row[1] - 1, row[1], slot(links, beside, n) - 1, static_cast<uint16_t>(n + 1), w, w.slope, false);
}

// The links of a cell: row and column of the neighbour, whose row of links, which of them.
struct To {
  int8_t dy, dx;
  uint8_t link;
  int8_t at;
};
constexpr To kTo[8] = {{0, 1, beside, 0},     {0, -1, beside, -1}, {-1, 0, straight, 0}, {1, 0, straight, 0},
                       {-1, -1, falling, -1}, {1, 1, falling, 0},  {-1, 1, rising, 1},   {1, -1, rising, 0}};

static void linked_of(const grid::Rows& rows, bool wide) {
  const uint8_t cut = wide ? 6 : 0, shift = static_cast<uint8_t>(10 - cut);
  uint8_t* const links = rows.scratch - link_bytes(rows.n);
  const int32_t *cells[3], *to[8];
  const int16_t* weight[8];
  for (uint8_t k = 0; k < 3; ++k) cells[k] = cut_row(rows.in[k], wide, cut, links, k, rows.n);
  for (uint8_t k = 0; k < 8; ++k) {
    const uint8_t set = kTo[k].dy == 0 ? uint8_t{0} : set_at(rows, kTo[k].dy > 0);
    to[k] = cells[kTo[k].dy + 1] + kTo[k].dx;
    weight[k] = slot(links, static_cast<uint8_t>(set + kTo[k].link), rows.n) + kTo[k].at;
  }
  int32_t* DAPPLE_RESTRICT const out = grid::out32(rows, 0);
  for (int32_t x = 0; x < rows.n; ++x) {
    int32_t sum = (1 << shift) >> 1;
    for (uint8_t k = 0; k < 8; ++k) sum += (to[k][x] - cells[1][x]) * weight[k][x];
    out[x] = sum >> shift;
  }
}
void linked_wide_row(const grid::Rows& rows) { linked_of(rows, true); }
void linked_narrow_row(const grid::Rows& rows) { linked_of(rows, false); }

}  // namespace dapple::stencil
