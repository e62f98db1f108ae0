// From a coarse grid to one twice as fine, in place: the coarse planes lie at the start of the fine ones' memory.
// SPDX-License-Identifier: MIT
#pragma once
#include "sweep.hpp"

namespace dapple::evolve {

// Turns coarse row y of one plane into fine rows 2 y and 2 y + 1. Rows must come from height - 1 down to 0 (coarse sizes
// in `coarse`, whose scratch has room for four rows a plane with a halo of one). int16 and int32 cells.
//   fine = (9 near + 3 beside + 3 above or below + 1 across + 8) >> 4: bilinear at cell centres
void refine_row(const Field& coarse, uint8_t plane, uint16_t y);

}  // namespace dapple::evolve
