// Wide reactions of two morphogens in one loop: stencil of lib/stencil/diffuse.cpp and Reaction of lib/model, with no
// row of sums between them. All other steps of explicit kinetics are those of lib/evolve/kinetic_rows.cpp.
// SPDX-License-Identifier: MIT
#pragma once

namespace dapple::evolve {

using i32 = int32_t;

// lap: l + r + u + d - 4 c, exactly, as five_wide_row has it. varied: there is a row of deviations.
template <bool varied, class Reaction>
static void reaction_cells(const i32* DAPPLE_RESTRICT au, const i32* DAPPLE_RESTRICT al, const i32* DAPPLE_RESTRICT a,
                           const i32* DAPPLE_RESTRICT ar, const i32* DAPPLE_RESTRICT ad, const i32* DAPPLE_RESTRICT bu,
                           const i32* DAPPLE_RESTRICT bl, const i32* DAPPLE_RESTRICT b, const i32* DAPPLE_RESTRICT br,
                           const i32* DAPPLE_RESTRICT bd, const i32* DAPPLE_RESTRICT more, i32* DAPPLE_RESTRICT out_a,
                           i32* DAPPLE_RESTRICT out_b, uint16_t n, Reaction reaction) {
  for (uint16_t x = 0; x < n; ++x) {
    i32 new_a = a[x], new_b = b[x];
    const i32 lap_a = al[x] + ar[x] + au[x] + ad[x] - 4 * new_a, lap_b = bl[x] + br[x] + bu[x] + bd[x] - 4 * new_b;
    reaction.step(new_a, new_b, lap_a, lap_b, varied ? more[x] : 0);
    out_a[x] = new_a;
    out_b[x] = new_b;
  }
}

template <class Reaction>
static void reaction_row(const grid::Rows& rows, Reaction reaction) {
  const auto cells = rows.table[has_rates] != 0 ? reaction_cells<true, Reaction> : reaction_cells<false, Reaction>;
  const i32 *a = grid::in32(rows, 1), *b = grid::in32(rows, 4);
  cells(grid::in32(rows, 0), a - 1, a, a + 1, grid::in32(rows, 2), grid::in32(rows, 3), b - 1, b, b + 1,
        grid::in32(rows, 5), grid::in32(rows, 7), grid::out32(rows, 0), grid::out32(rows, 1), rows.n, reaction);
}

// Whether there is a loop for this stencil and reaction: then the step is done.
static bool reacted(const grid::Rows& rows) {
  const grid::RowKernel react = rows.part[1];
  const i32* p = rows.p;
  if (rows.part[0] != DAPPLE_OURS(DAPPLE_SET, stencil_five_wide_row)) return false;
  if (react == DAPPLE_OURS(DAPPLE_SET, turing_react_row)) {
    reaction_row(rows, turing::reaction_of(p));
  } else if (react == DAPPLE_OURS(DAPPLE_SET, meinhardt_spots_react_row)) {
    reaction_row(rows, meinhardt_spots::reaction_of(p));
  } else if (react == DAPPLE_OURS(DAPPLE_SET, schnakenberg_react_row)) {
    reaction_row(rows, schnakenberg::reaction_of(p));
  } else if (react == DAPPLE_OURS(DAPPLE_SET, brusselator_react_row)) {
    reaction_row(rows, brusselator::reaction_of(p));
  } else {
    return false;
  }
  return true;
}

// Old rows of some planes from their windows: rows that are written to need not hold them, as they must for
// kinetics_row.
static void take_old(const grid::Rows& rows, uint8_t from, uint8_t to) {
  const size_t bytes = (rows.table[wide_cells] != 0 ? size_t{4} : size_t{2}) * rows.n;
  for (uint8_t i = from; i < to; ++i) base::copy_bytes(rows.out[i], rows.in[3 * i + 1], bytes);
}

static void kinetics_wide(const grid::Rows& rows) {
  take_old(rows, kept_at(rows), rows.planes);
  if (reacted(rows)) return;
  take_old(rows, 0, kept_at(rows));
  kinetics_row(rows);
}

static void cascade_wide(const grid::Rows& rows) {
  kinetics_wide(rows);
  hold_row(rows);
}

}  // namespace dapple::evolve
