// lib/stencil/flux.cpp for engines with vectors of 128 bits: with pulls of its own, and everything small but the two
// loops over cells that the solvers of the page run most. ports/wasm/build links it instead.
// SPDX-License-Identifier: MIT
#pragma clang attribute push(__attribute__((minsize)), apply_to = function)
#define pull_row portable_pull_row
#include "../../lib/stencil/flux_cell.hpp"
#undef pull_row
#pragma clang attribute pop

#include "pulls.hpp"

namespace dapple::stencil {

static void pull_row(const FluxSet::Stream& s, uint8_t way, const i16* map, i16* out, uint16_t n) {
  pull_eights(s, way, map, out, n);
}

#define SMALL __attribute__((minsize))
struct Pulling;
SMALL static void add_row(const i16*, const i16*, const i16*, i16*, uint16_t);
SMALL static void between(const Pulling&, uint8_t);
SMALL static void carry_less(const i16*, const i16*, const i16*, const i16*, i16*, uint16_t, FluxStage);
SMALL static void carry_mean(const i16*, const i16*, const i16*, const i16*, i16*, uint16_t, FluxStage);
SMALL static void chain(const FluxSet&, const FluxWork&, uint8_t, const i16*, const i16*, i16*);
SMALL void flux_chain_row(const grid::Rows& rows);
SMALL void keep_map_row(const grid::Rows& rows);
SMALL static void lack_row(const i16*, const i16*, i16*, uint16_t);
SMALL static void link_row(const i16*, const i16*, i16*, uint16_t);
SMALL static void mean_row(const i16*, const i16*, i16*, uint16_t);
SMALL static void pull_at(const Pulling&, uint8_t, uint8_t);
SMALL static void pull_vectors(uint8_t, const i16*, const i16*, i16*, uint16_t);
SMALL static void warp_stream(const FluxSet&, const FluxWork&, uint8_t, uint8_t, uint8_t, uint16_t, const i16* const*);
#undef SMALL

}  // namespace dapple::stencil

#include "../../lib/stencil/flux.cpp"
