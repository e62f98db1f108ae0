// Seed discs on a jittered diamond grid that closes on the torus and goes on for ever on the plane.
// SPDX-License-Identifier: MIT
#include "../base/hash.hpp"
#include "discs.hpp"

namespace dapple::start {

// Compilers make no vectors of set_cell.
void clear_row(const Place& place, const Levels& levels, void* row) {
  if (place.cell == grid::Cell::int16 && !base::kSmallCode) {
    int16_t* const cells = static_cast<int16_t*>(row);
    for (uint16_t x = 0; x < place.width; ++x) cells[x] = static_cast<int16_t>(levels.background);
    return;
  }
  for (uint16_t x = 0; x < place.width; ++x) set_cell(place, row, x, levels.background);
}

// Cells first..last of the world that lie in this row.
static void fill_span(const Place& place, void* row, int64_t first, int64_t last, int32_t value) {
  const int32_t period = place.width;
  if (place.plane) {
    first = first < place.x ? place.x : first;
    last = last >= static_cast<int64_t>(place.x) + period ? static_cast<int64_t>(place.x) + period - 1 : last;
  } else if (last - first >= period) {
    last = first + period - 1;
  }
  for (int64_t x = first; x <= last; ++x)
    set_cell(place, row, static_cast<uint16_t>(world(static_cast<int32_t>(x - place.x), place.width, place.plane)), value);
}

int64_t half_chord(const Place& place, const Start& start, int64_t high, int64_t centre_y, int64_t y) {
  const int64_t radius = cells(place, start.radius);
  int64_t dy = y - centre_y;
  if (!place.plane) {  // to the nearest image on the torus
    dy %= high;
    if (dy < 0) dy += high;
    if (dy > high / 2) dy -= high;
  }
  if (dy > radius || dy < -radius) return -1;
  return base::square_root64(static_cast<uint64_t>(radius * radius - dy * dy));
}

// Cell x has its centre at 256 x + 128: first = ceil, last = floor.
void fill_chord(const Place& place, int64_t centre_x, int64_t half, int32_t value, void* row) {
  fill_span(place, row, (centre_x - half - 128 + 255) >> 8, (centre_x + half - 128) >> 8, value);
}

// The lattice places first..last along one direction whose discs may reach the stretch at..to of the plane or, as they
// repeat after `count` of them, of a torus of size `size`; all in 1/256 cell. A disc stands less than two spacings
// beyond its place: one that it is moved by, and less than one within it.
struct Span {
  int32_t first, last;
};
static Span near(int64_t at, int64_t to, int64_t size, int64_t count, int64_t radius) {
  const int64_t around = radius + 2 * (size / count + 1);
  return {static_cast<int32_t>(floor_divide((at - around) * count, size)),
          static_cast<int32_t>(floor_divide((to + around) * count, size))};
}

// The discs of row j of the lattice, seen in the row of cells whose centre line is y (1/256 cell).
static void discs_row(const Place& place, const Start& start, const DiscGrid& discs, Span columns, int32_t j, int64_t y,
                      int32_t value, void* row) {
  const int64_t down = place.plane ? 1 : discs.rows, across = place.plane ? 1 : discs.columns;
  const int64_t row_y = floor_divide((2 * static_cast<int64_t>(j) + 1) * discs.high, 2 * down);
  for (int32_t i = columns.first; i <= columns.last; ++i) {
    const int64_t centre_y = row_y + shake(base::hash(place.seed, kJitterY, i, j), start.jitter, discs.high / down);
    const int64_t half = half_chord(place, start, discs.high, centre_y, y);
    if (half < 0) continue;
    const int64_t centre_x = floor_divide((4 * static_cast<int64_t>(i) + 1 + 2 * (j & 1)) * discs.wide, 4 * across) +
                             shake(base::hash(place.seed, kJitterX, i, j), start.jitter, discs.wide / across);
    fill_chord(place, centre_x, half, value, row);
  }
}

void seeds_row(const Place& place, const Start& start, const Levels& levels, uint8_t, uint16_t y, void* row) {
  clear_row(place, levels, row);
  const DiscGrid discs = disc_grid(start, place);
  const int64_t at = static_cast<int64_t>(world(place.y + y, place.height, place.plane)) * 256 + 128;
  const int64_t left = static_cast<int64_t>(place.x) * 256, radius = cells(place, start.radius);
  const int32_t value = disc_level(start, levels);
  Span rows = near(at, at, discs.high, place.plane ? 1 : discs.rows, radius);
  Span columns = {0, discs.columns - 1};
  if (place.plane) columns = near(left, left + place.width * INT64_C(256), discs.wide, 1, radius);
  else if (rows.last - rows.first >= discs.rows) rows = {0, discs.rows - 1};
  for (int32_t k = rows.first; k <= rows.last; ++k)
    discs_row(place, start, discs, columns, world(k, discs.rows, place.plane), at, value, row);
}

}  // namespace dapple::start
