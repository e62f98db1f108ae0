// Uniform noise: every cell of every plane on its own.
// SPDX-License-Identifier: MIT
#include "../base/hash.hpp"
#include "start.hpp"

namespace dapple::start {

// Cells [x, x + 32) of a row of the world, cell x in bit 0.
static uint32_t thirty_two(const base::RowKey& key, int32_t x) {
  const uint32_t first = base::hash(key, x >> 5);
  const uint8_t shift = static_cast<uint8_t>(x & 31);
  return shift == 0 ? first : (first >> shift) | (base::hash(key, (x >> 5) + 1) << (32 - shift));
}

// Rows of bits end at a multiple of 32 cells.
static void noise_bits(const Place& place, const base::RowKey& key, uint8_t* row) {
  for (uint32_t x = 0; x < place.width; x += 32) {
    const int32_t at = world(place.x + static_cast<int32_t>(x), place.width, place.plane);
    uint32_t bits = thirty_two(key, at);
    const int32_t left = static_cast<int32_t>(place.width) - at;  // to the torus' edge
    if (!place.plane && left < 32) bits = (bits & ((UINT32_C(1) << left) - 1)) | (thirty_two(key, 0) << left);
    base::store_word(row + x / 8, bits);
  }
}

// Uniform over 0..count - 1. Spans of more than 16 bits, which int32 cells can have, by a count cut to 256ths: count <= 2^24.
template <class T> static int32_t share(uint32_t h, uint32_t count) {
  return static_cast<int32_t>(sizeof(T) == 4 && count > 65536 ? ((h >> 16) * (count >> 8)) >> 8 : base::below(h, count));
}

template <class T> static void noise_cells(const Place& place, const base::RowKey& key, const Levels& levels, T* row) {
  const uint32_t count = static_cast<uint32_t>(levels.high - levels.low) + 1;
  int32_t at = world(place.x, place.width, place.plane);
  for (uint16_t x = 0; x < place.width; ++x) {
    row[x] = static_cast<T>(levels.low + share<T>(base::hash(key, at), count));
    if (++at == place.width && !place.plane) at = 0;
  }
}

void noise_row(const Place& place, const Start&, const Levels& levels, uint8_t plane, uint16_t y, void* row) {
  const base::RowKey key = base::row_key(place.seed, plane, world(place.y + y, place.height, place.plane));
  switch (place.cell) {
    case grid::Cell::bit: noise_bits(place, key, static_cast<uint8_t*>(row)); break;
    case grid::Cell::int16: noise_cells(place, key, levels, static_cast<int16_t*>(row)); break;
    case grid::Cell::int32: noise_cells(place, key, levels, static_cast<int32_t*>(row)); break;
  }
}

}  // namespace dapple::start
