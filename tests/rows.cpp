// Rows with wrapped halos against the definition.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include "grid/rows.hpp"

namespace grid = dapple::grid;

TEST_CASE("the halo of a row is the row again, however much wider") {
  for (uint16_t width = 1; width <= 40; ++width)
    for (uint16_t halo = 0; halo <= 90; ++halo) {
      int16_t cells[40 + 2 * 90] = {};
      uint8_t bits[32] = {};
      int16_t* const row = cells + 90;
      uint8_t* const packed = bits + 12;
      const auto on = [](int32_t x) { return (x * x + x / 3) % 5 < 2; };
      for (uint16_t x = 0; x < width; ++x) {
        row[x] = static_cast<int16_t>(x + 1);
        grid::put_bit(packed, x, on(x));
      }
      grid::wrap_row(grid::Cell::int16, row, width, halo);
      grid::wrap_row(grid::Cell::bit, packed, width, halo);
      bool same = true;
      for (int32_t x = -static_cast<int32_t>(halo); x < width + halo; ++x) {
        const int32_t place = ((x % width) + width) % width;
        same = same && row[x] == place + 1 && grid::get_bit(packed, x) == on(place);
      }
      CHECK_MESSAGE(same, width << " cells, halo " << halo);
    }
}
