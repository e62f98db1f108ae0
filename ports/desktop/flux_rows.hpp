// The kernels of fluxed.hpp, for every set and once portable.
// SPDX-License-Identifier: MIT
#pragma once
#include "fluxed.hpp"

#include "../../lib/stencil/flux_cell.hpp"
#include "rounded.hpp"

namespace dapple::stencil {

// A link's weight halved, of pulls at its ends: carried_of up to there.
DAPPLE_APART static void weights_row(const i16* DAPPLE_RESTRICT pull, const i16* DAPPLE_RESTRICT pull_to,
                                     i16* DAPPLE_RESTRICT weight, uint16_t n, FluxStage s) {
  for (uint16_t x = 0; x < n; ++x) {
    const i16 q = static_cast<i16>(mulhi(static_cast<i16>(pull[x] + pull_to[x]), s.slope) + s.offset);
    const i16 t = positive(q < s.cap ? q : s.cap);
    weight[x] = mulhi(static_cast<i16>(static_cast<uint16_t>(t) * static_cast<uint16_t>(s.scale)), s.factor);
  }
}

// What comes from ahead less what went on from behind; a link carries floor((to - from) weight / 2^15 + 1/2).
// weight_from, from: of the cells behind.
DAPPLE_APART static void flow_row(const i16* DAPPLE_RESTRICT weight_from, const i16* DAPPLE_RESTRICT weight,
                                  const i16* DAPPLE_RESTRICT from, const i16* DAPPLE_RESTRICT cell,
                                  const i16* DAPPLE_RESTRICT to, i16* DAPPLE_RESTRICT out, uint16_t n) {
  for (uint16_t x = 0; x < n; ++x) {
    const i16 ahead = rounded_product(static_cast<i16>(to[x] - cell[x]), weight[x]);
    const i16 behind = rounded_product(static_cast<i16>(cell[x] - from[x]), weight_from[x]);
    out[x] = static_cast<i16>(cell[x] + ahead - behind);
  }
}

// Cells from a row of pulls to the one ahead of it where it is as far from the one behind: a cell's link ahead is that
// behind of the cell so much further on. 0 where it is not, or too far for a block.
constexpr uint16_t kFluxBlock = 2048;
static uint16_t pulls_apart(const i16* behind, const i16* here, const i16* ahead) {
  const intptr_t on = reinterpret_cast<intptr_t>(ahead) - reinterpret_cast<intptr_t>(here);
  const intptr_t back = reinterpret_cast<intptr_t>(here) - reinterpret_cast<intptr_t>(behind);
  return on == back && on > 0 && on < 2 * kFluxBlock ? static_cast<uint16_t>(on / 2) : uint16_t{0};
}

void pulled_row(const grid::Rows& rows) {
  const FluxSet& set = *reinterpret_cast<const FluxSet*>(rows.table);
  for (uint8_t i = 0; i < set.streams; ++i)
    pull_row(set.stream[i], static_cast<uint8_t>(rows.p[0]), grid::in16(rows, set.stream[i].map), grid::out16(rows, i),
             rows.n);
}

void fluxed_row(const grid::Rows& rows) {
  const Pulled& pulled = *reinterpret_cast<const Pulled*>(rows.table);
  const uint8_t way = static_cast<uint8_t>(rows.p[0]), stage = static_cast<uint8_t>(rows.p[1]);
  const Spread& spread = pulled.set->spread[rows.p[2]];
  const int32_t stride = stride_of(stage), shift = stride * way_of(way).vx;
  const uint32_t height = pulled.height, away = static_cast<uint32_t>(stride * way_of(way).vy);
  const auto pull = [&](uint32_t y) {
    return reinterpret_cast<const i16*>(pulled.cells + spread.stream * pulled.plane + y % height * pulled.pitch);
  };
  const i16 *pull_from = pull(rows.y + height - away) - shift, *pull_here = pull(rows.y),
            *pull_to = pull(rows.y + away) + shift;
  const i16 *from = grid::in16(rows, 0) - shift, *cell = grid::in16(rows, 1), *to = grid::in16(rows, 2) + shift;
  const FluxStage s = stage_of(spread, way, stage);
  const uint16_t apart = pulls_apart(pull_from, pull_here, pull_to);
  i16 weight[2 * kFluxBlock];
  for (uint32_t x = 0; x < rows.n; x += kFluxBlock) {
    const uint16_t n = static_cast<uint16_t>(base::min(kFluxBlock, static_cast<int32_t>(rows.n - x)));
    const bool shared = apart > 0 && apart < n;
    weights_row(pull_from + x, pull_here + x, weight, static_cast<uint16_t>(shared ? apart + n : n), s);
    if (!shared) weights_row(pull_here + x, pull_to + x, weight + kFluxBlock, n, s);
    flow_row(weight, weight + (shared ? apart : kFluxBlock), from + x, cell + x, to + x, grid::out16(rows, 0) + x, n);
  }
}

}  // namespace dapple::stencil
