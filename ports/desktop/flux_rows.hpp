// The kernels of fluxed.hpp, for every set and once portable.
// SPDX-License-Identifier: MIT
#pragma once
#include "fluxed.hpp"

#include "../../lib/stencil/flux_cell.hpp"

namespace dapple::stencil {

// What comes from ahead less what went on from behind. pull_from, from: the cells behind.
DAPPLE_APART static void flow_row(const i16* DAPPLE_RESTRICT pull_from, const i16* DAPPLE_RESTRICT pull,
                                  const i16* DAPPLE_RESTRICT pull_to, const i16* DAPPLE_RESTRICT from,
                                  const i16* DAPPLE_RESTRICT cell, const i16* DAPPLE_RESTRICT to,
                                  i16* DAPPLE_RESTRICT out, uint16_t n, FluxStage s) {
  for (uint16_t x = 0; x < n; ++x) {
    const i16 ahead = carried(static_cast<i16>(pull[x] + pull_to[x]), cell[x], to[x], s);
    const i16 behind = carried(static_cast<i16>(pull_from[x] + pull[x]), from[x], cell[x], s);
    out[x] = static_cast<i16>(cell[x] + ahead - behind);
  }
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
  flow_row(pull(rows.y + height - away) - shift, pull(rows.y), pull(rows.y + away) + shift, grid::in16(rows, 0) - shift,
           grid::in16(rows, 1), grid::in16(rows, 2) + shift, grid::out16(rows, 0), rows.n,
           stage_of(spread, way, stage));
}

}  // namespace dapple::stencil
