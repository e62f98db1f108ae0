// Uniform noise: every cell of every plane on its own.
// SPDX-License-Identifier: MIT
#include "../base/hash.hpp"
#include "start.hpp"

namespace dapple::start {

static uint16_t roll(uint32_t at, uint16_t size) { return static_cast<uint16_t>(at % size); }

void noise_row(const Place& place, uint8_t plane, const Levels& levels, uint16_t y, void* row) {
  const uint16_t world_y = roll(static_cast<uint32_t>(y) + place.roll_y, place.height);
  const base::RowKey key = base::row_key(place.seed, plane, world_y);
  const uint32_t count = static_cast<uint32_t>(levels.high - levels.low) + 1;
  uint16_t world_x = roll(place.roll_x, place.width);
  for (uint16_t x = 0; x < place.width; ++x) {
    const int32_t value = levels.low + static_cast<int32_t>(base::below(base::hash(key, world_x), count));
    switch (place.cell) {
      case grid::Cell::bit: grid::put_bit(static_cast<uint8_t*>(row), x, value != 0); break;
      case grid::Cell::int16: static_cast<int16_t*>(row)[x] = static_cast<int16_t>(value); break;
      case grid::Cell::int32: static_cast<int32_t*>(row)[x] = value; break;
    }
    if (++world_x == place.width) world_x = 0;
  }
}

}  // namespace dapple::start
