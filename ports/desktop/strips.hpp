// Binary convolution of whole grids, a column of vectors at a time, for the driver: sums run down the rows in
// registers, and down rows that lean. Same bits as lib/stencil/sliced.cpp.
//
// A long mask changes least from one place to the next along its own direction. So sums run down the grid (0, 1), or
// down rows that lean by a cell each to the right or left, (1, 1) and (-1, 1); a mask along x wants the grid turned
// over (x and y exchanged). A world is a grid seen in one of these ways: of its row y, lane x holds cell x + lean y,
// and tap (dx, dy) of a mask lies in row dy at q = dx - lean dy.
//   D(y) = D(y - 1) + change * R,   change = the mask less the mask a row before
// SPDX-License-Identifier: MIT
#pragma once
#include "../../lib/stencil/convolve.hpp"
#include "../../lib/stencil/steer.hpp"

namespace dapple::stencil {

constexpr uint8_t kWidestStrip = 4 * kLargestMask + 1;  // columns of a leaning mask

// A mask in a world: taps are row * columns + q - first.
struct StripMask {
  Taps whole, change;  // 2 radius + 1 and 2 radius + 2 rows
  bool running;        // by `change`
};

struct World {
  int8_t lean, first;  // first: the least q
  uint8_t columns, radius, masks;
  StripMask mask[kMaxMasks];
};

// Rows of one-bit cells that start with a whole word of 32 bytes. Beside a row lie eight bytes before, and eight behind
// the last whole word; where worlds lean, as much as the row again.
struct BitGrid {
  uint8_t* rows;
  size_t pitch;     // bytes
  uint16_t height;  // row height + y is row y
  uint32_t period;  // cell period + x is cell x; at least 64
  uint32_t width;   // cells that are wanted of a row
};

// Rows first .. end - 1 of a step of all masks of a world: a cell is on where one of them says so.
struct Strip {
  const World* world;
  BitGrid from;
  uint8_t* to;        // row 0; rows are as far apart as those of `from`
  bool add;           // to the cells that are on there
  int16_t threshold;  // D > threshold
  uint16_t first, end;
  uint16_t left, right;  // cells of a row that are wanted, left .. right - 1; where a world leans, all are made
  uint8_t* leaning;      // room for rows first .. end - 1 of a world that leans
};

// in[0]: a Strip.
void strip_row(const grid::Rows& rows);

// Rows first .. end - 1 of a step along a field of directions: the sums of five masks in an upright world, mixed for
// every cell's direction.
struct Steered {
  Strip strip;  // add: no; threshold: of the mixture
  const SteerSet* set;
  uint8_t* directions;  // two bytes for every cell of the grid's whole words, kept from step to step; aligned to a word
  bool fresh;           // those of these rows are to be made
};

// in[0]: a Steered.
void steer_strip_row(const grid::Rows& rows);

// x and y exchanged: cells left .. right - 1 of rows first .. end - 1 of `from`, in blocks of 64 rows, become rows of
// `to`, which are to_pitch bytes apart. There is room for whole blocks, and whole words of 32 bytes, in both.
struct Turning {
  const uint8_t* from;
  uint8_t* to;
  size_t pitch, to_pitch;
  uint16_t first, end;   // first: a multiple of 64
  uint32_t left, right;  // left: a multiple of 64, whole words of 32 bytes before the end of whole words of a row
  bool add;              // to the cells that are on there
};

// in[0]: a Turning.
void turn_row(const grid::Rows& rows);

}  // namespace dapple::stencil
