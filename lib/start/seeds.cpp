// Seed discs on a jittered diamond grid that closes on the torus: giraffe, reptile and the spots of the kinetics.
// SPDX-License-Identifier: MIT
#include "../base/hash.hpp"
#include "../base/math.hpp"
#include "start.hpp"

namespace dapple::start {

constexpr uint32_t kJitterX = 64, kJitterY = 65;  // hash streams

static void set_cell(const Place& place, void* row, uint16_t x, int32_t value) {
  switch (place.cell) {
    case grid::Cell::bit: grid::put_bit(static_cast<uint8_t*>(row), x, value != 0); break;
    case grid::Cell::int16: static_cast<int16_t*>(row)[x] = static_cast<int16_t>(value); break;
    case grid::Cell::int32: static_cast<int32_t*>(row)[x] = value; break;
  }
}

// U * jitter / 2 in units of 1/256 of a cell when `spacing` is (Q8): |result| <= jitter * spacing.
static int32_t shake(uint32_t h, int32_t jitter, int64_t spacing) {
  const int64_t unit = static_cast<int64_t>(h >> 16) - 32768;  // U * 32768
  return static_cast<int32_t>(((unit * jitter / base::kMicro) * spacing) >> 15);
}

static void fill_span(const Place& place, void* row, int32_t first, int32_t last, int32_t value) {
  if (last - first >= place.width) last = first + place.width - 1;
  const int32_t period = place.width;
  for (int32_t x = first; x <= last; ++x) {
    int32_t at = (x - place.roll_x) % period;
    if (at < 0) at += period;
    set_cell(place, row, static_cast<uint16_t>(at), value);
  }
}

// The part of the discs of grid row j, seen dy (Q8) above or below its centre line, that lies in this row of cells.
static void disc_row(const Place& place, const Start& start, uint16_t j, int32_t y_q8, DiscGrid discs, int32_t value, void* row) {
  const int64_t radius = (static_cast<int64_t>(start.radius) * 256 / base::kMicro) >> place.level;
  const int64_t height_q8 = static_cast<int64_t>(place.height) << 8;
  const base::RowKey key_x = base::row_key(place.seed, kJitterX, j), key_y = base::row_key(place.seed, kJitterY, j);
  for (uint16_t i = 0; i < discs.columns; ++i) {
    const int64_t space_y = height_q8 / discs.rows, space_x = (static_cast<int64_t>(place.width) << 8) / discs.columns;
    const int64_t centre_y = (2 * static_cast<int64_t>(j) + 1) * height_q8 / (2 * discs.rows) +
                             shake(base::hash(key_y, i), start.jitter, space_y);
    int64_t dy = (y_q8 - centre_y) % height_q8;  // to the nearest image on the torus
    if (dy < 0) dy += height_q8;
    if (dy > height_q8 / 2) dy -= height_q8;
    if (dy > radius || dy < -radius) continue;
    const int64_t centre_x = (4 * static_cast<int64_t>(i) + 1 + 2 * (j & 1)) * (static_cast<int64_t>(place.width) << 8) /
                                 (4 * discs.columns) +
                             shake(base::hash(key_x, i), start.jitter, space_x);
    const int64_t half = base::square_root64(static_cast<uint64_t>(radius * radius - dy * dy));
    // Cell x has its centre at 256 x + 128: first = ceil, last = floor.
    fill_span(place, row, static_cast<int32_t>((centre_x - half - 128 + 255) >> 8),
              static_cast<int32_t>((centre_x + half - 128) >> 8), value);
  }
}

void seeds_row(const Place& place, const Start& start, const Levels& levels, uint16_t y, void* row) {
  for (uint16_t x = 0; x < place.width; ++x) set_cell(place, row, x, levels.background);
  const DiscGrid discs = disc_grid(start, place.width, place.height, place.level);
  const int32_t y_q8 =
      static_cast<int32_t>((static_cast<uint32_t>(y) + place.roll_y) % place.height) * 256 + 128;
  const int32_t value = levels.background + static_cast<int32_t>(base::divide_round(
      static_cast<int64_t>(levels.disc - levels.background) * start.amplitude, base::kMicro));
  for (uint16_t j = 0; j < discs.rows; ++j) disc_row(place, start, j, y_q8, discs, value, row);
}

}  // namespace dapple::start
