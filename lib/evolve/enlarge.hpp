// Twofold enlargement of a field, bilinear: cell X of the finer grid is 3/4 of the cell it lies in and 1/4 of the one beside
// it, in either direction.
// SPDX-License-Identifier: MIT
#pragma once
#include "../base/port.hpp"

namespace dapple::evolve {

// put(i, value) for i = 0 .. count - 1. near: the row the fine row lies in; other: the one beside it. The first of the cells
// is the half `odd` of cell 0; cells -1 to (count + odd) / 2 are read. Values within +-8000: every sum fits int16.
template <class Put>
DAPPLE_INLINE void enlarged(const int16_t* near, const int16_t* other, uint8_t odd, uint16_t count, const Put& put) {
  const auto mixed = [&](int32_t x) { return static_cast<int16_t>((3 * near[x] + other[x] + 2) >> 2); };
  int32_t x = 0;
  int16_t before = mixed(-1), here = mixed(0), after = mixed(1);
  for (uint16_t i = 0; i < count; ++i) {
    put(i, static_cast<int16_t>((3 * here + (odd ? after : before) + 2) >> 2));
    if (odd) {
      ++x;
      before = here;
      here = after;
      if (i + 1 < count) after = mixed(x + 1);
    }
    odd ^= 1;
  }
}

// Which row is beside a fine row's own.
constexpr int8_t beside(uint32_t y) { return (y & 1) != 0 ? 1 : -1; }

}  // namespace dapple::evolve
