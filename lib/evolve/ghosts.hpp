// Ghost cells around a patch: copied, before every sweep, from where a table says [Witkin & Kass 1991, 4.1, 6.5]. The
// sweeps then take patch and ring for a torus; what comes round its edges stays in the ring.
// SPDX-License-Identifier: MIT
#pragma once
#include "run.hpp"

namespace dapple::evolve {

// Cells of the ring, finest grid.
constexpr size_t ghost_cells(const Ground& g) {
  const size_t wide = g.width, pad = g.pad;
  return 2 * pad * wide + 2 * pad * (g.height - 2 * pad);
}

// What the table's numbers can tell apart.
constexpr uint32_t kMostGhostBytes = UINT32_C(0xffffff00);

// Copies the ghost cells of row run.at_row; at a level's first time their table is made.
void seal_row(Run& run);

}  // namespace dapple::evolve
