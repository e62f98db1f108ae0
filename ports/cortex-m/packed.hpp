// Row kernels on packs of int16 cells: the walk along a row and what is read and written; helium.cpp and dsp.cpp say
// what a pack is and calculate on it. Every kernel has the bytes, the rows and the numbers of the portable one it is
// named after.
//
// A Machine M has: Cells, a pack; kCells of them; Part, the first few of a pack; part(count), load and store of packs
// and of parts; Quarter1, Quarter2, Weighted, Impulse, Five and Kinetics, the formulas.
// SPDX-License-Identifier: MIT
#pragma once
#include "model/gray_scott.hpp"
#include "model/threshold.hpp"
#include "stencil/laplacian.hpp"
#include "stencil/lattice.hpp"

namespace dapple::packed {

using i16 = int16_t;

inline i16 number(const grid::Rows& rows, uint8_t index) { return static_cast<i16>(rows.p[index]); }

// A pack of the row at hand, and the part of one that ends it.
template <class M>
struct Pack {
  size_t x;
  typename M::Cells of(const i16* row) const { return M::load(row + x); }
  void put(i16* row, typename M::Cells cells) const { M::store(row + x, cells); }
};
template <class M>
struct LastPack {
  size_t x;
  typename M::Part part;
  typename M::Cells of(const i16* row) const { return M::load(row + x, part); }
  void put(i16* row, typename M::Cells cells) const { M::store(row + x, cells, part); }
};

// formula(pack) for every pack of n cells.
template <class M, class Formula>
inline void along(uint16_t n, Formula formula) {
  const size_t whole = n - n % M::kCells;
  for (size_t x = 0; x < whole; x += M::kCells) formula(Pack<M>{x});
  if (whole < n) formula(LastPack<M>{whole, M::part(static_cast<uint16_t>(n - whole))});
}

template <class M, class Formula>
inline void each_three(const i16* l, const i16* c, const i16* r, i16* out, uint16_t n, Formula formula) {
  along<M>(n, [&](auto pack) { pack.put(out, formula(pack.of(l), pack.of(c), pack.of(r))); });
}

// A full pass has the rounding 1 or 2, which halves that round up or down make without an addition.
template <class M>
void three_point(const i16* l, const i16* c, const i16* r, i16* out, uint16_t n, i16 weight, i16 rounding) {
  if (weight == stencil::kQuarter && rounding == 1) each_three<M>(l, c, r, out, n, typename M::Quarter1());
  else if (weight == stencil::kQuarter && rounding == 2) each_three<M>(l, c, r, out, n, typename M::Quarter2());
  else each_three<M>(l, c, r, out, n, typename M::Weighted(weight, rounding));
}

template <class M>
void pass_row(const grid::Rows& rows) {
  stencil::pass_row_by(rows, three_point<M>);
}
template <class M>
void chain_row(const grid::Rows& rows) {
  stencil::chain_row_by(rows, three_point<M>);
}

// One pair; more of them are left to the portable kernel.
template <class M>
void impulse_row(const grid::Rows& rows) {
  if (rows.p[0] != 1) return threshold::impulse_row(rows);
  i16 *a = grid::out16(rows, 0), *b = grid::out16(rows, 1);
  const typename M::Impulse impulse(number(rows, 2), number(rows, 3));
  along<M>(rows.n, [&](auto pack) {
    const typename M::Cells activator = pack.of(a), inhibitor = pack.of(b);
    const typename M::Cells amount = impulse.where_above(activator, inhibitor);
    pack.put(a, impulse.decayed(activator, amount));
    pack.put(b, impulse.decayed(inhibitor, amount));
  });
}

template <class M>
void five_row(const grid::Rows& rows) {
  const i16 *u = grid::in16(rows, 0), *c = grid::in16(rows, 1), *d = grid::in16(rows, 2);
  i16* out = grid::out16(rows, 0);
  const typename M::Five five(number(rows, 0), number(rows, 1));
  along<M>(rows.n,
           [&](auto pack) { pack.put(out, five(pack.of(u), pack.of(c - 1), pack.of(c), pack.of(c + 1), pack.of(d))); });
}

template <class M>
void gray_scott_row(const grid::Rows& rows) {
  const i16 *du = grid::in16(rows, 0), *dv = grid::in16(rows, 1);
  i16 *u = grid::out16(rows, 0), *v = grid::out16(rows, 1);
  const typename M::Kinetics kinetics(number(rows, 0), number(rows, 1), number(rows, 2), number(rows, 3));
  along<M>(rows.n, [&](auto pack) {
    const typename M::Cells substrate = pack.of(u), activator = pack.of(v);
    const typename M::Cells eaten = kinetics.eaten(substrate, activator);
    pack.put(u, kinetics.fed(substrate, pack.of(du), eaten));
    pack.put(v, kinetics.drained(activator, pack.of(dv), eaten));
  });
}

}  // namespace dapple::packed
