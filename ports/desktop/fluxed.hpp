// Passes along a map of directions (lib/stencil/flux.hpp) that leave nothing to the row after: pulls are made
// beforehand, and every cell takes what both of its links carry. So rows may come in any order. Same bytes.
// SPDX-License-Identifier: MIT
#pragma once
#include "../../lib/stencil/flux.hpp"

namespace dapple::stencil {

// A way's pulls: a plane of int16 a stream, rows with halos.
struct Pulled {
  const FluxSet* set;
  uint8_t* cells;       // stream 0, row 0, cell 0
  size_t pitch, plane;  // bytes from row to row, from stream to stream
  uint16_t height;
};

// A row of the pulls along way p[0]. in[i]: map i. out[i]: stream i. table: FluxSet.
void pulled_row(const grid::Rows& rows);

// A pass of plane p[2], which takes it, along way p[0], stage p[1]. in[k]: rows y - S, y, y + S with halo, S = stride *
// vy. out[0]: row y. table: Pulled; several rows as one have its pitch.
void fluxed_row(const grid::Rows& rows);

}  // namespace dapple::stencil
