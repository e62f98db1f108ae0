// Yardsticks for dapple bench, one of each for every instruction set: plain float loops that do what a model does, and
// how fast this processor loads, computes and copies at most.
// SPDX-License-Identifier: MIT
#pragma once
#include <stddef.h>
#include <stdint.h>

namespace dapple::desktop {

struct Yardsticks {
  const char* table;  // whose instructions these are
  uint8_t bytes;      // of a vector
  // One row of a Gray-Scott step in float32: rows above, here, below of u and v, with a cell of halo; feed, kill and
  // rates fixed.
  void (*float_gray_scott)(const float* const* u, const float* const* v, float* out_u, float* out_v, size_t n);
  // Loads `count` vectors of a block that fits the first cache, beginning `offset` bytes into it.
  uint64_t (*loads)(const uint8_t* block, size_t count, size_t offset);
  // `count` bitwise operations on vectors.
  uint64_t (*operations)(size_t count);
};

// Those of the table called so; null if there are none.
const Yardsticks* yardsticks_of(const char* table);

}  // namespace dapple::desktop
