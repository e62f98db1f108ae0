// Initiator cells in a uniform state: a point, a line, segments that lean one way.
// SPDX-License-Identifier: MIT
#include "../base/hash.hpp"
#include "../base/math.hpp"
#include "discs.hpp"

namespace dapple::start {

constexpr uint32_t kSegments = 68;  // hash streams: x, y, length, angle

// The distance of cell `at` of the place from the middle, or on the plane the origin, in 1/256 cells.
static int64_t from_middle(int32_t at, uint16_t size, bool plane) {
  return static_cast<int64_t>(world(at, size, plane)) * 256 - (plane ? 0 : static_cast<int64_t>(size / 2) * 256);
}

void point_row(const Place& place, const Start& start, const Levels& levels, uint8_t, uint16_t y, void* row) {
  const int64_t radius = cells(place, start.radius), dy = from_middle(place.y + y, place.height, place.plane);
  const int32_t value = disc_level(start, levels);
  clear_row(place, levels, row);
  for (uint16_t x = 0; x < place.width; ++x) {
    const int64_t dx = from_middle(place.x + x, place.width, place.plane);
    if (dx * dx + dy * dy <= radius * radius) set_cell(place, row, x, value);
  }
}

void line_row(const Place& place, const Start& start, const Levels& levels, uint8_t, uint16_t y, void* row) {
  const uint16_t lean = base::angle_of(start.lean);
  const int16_t along = base::cosine(lean), down = base::sine(lean);
  const bool flat = (along < 0 ? -along : along) > (down < 0 ? -down : down);
  const int64_t radius = cells(place, start.radius), dy = from_middle(place.y + y, place.height, place.plane);
  const int32_t value = disc_level(start, levels);
  clear_row(place, levels, row);
  for (uint16_t x = 0; x < place.width; ++x) {
    const int64_t off = flat ? dy : from_middle(place.x + x, place.width, place.plane);
    if (off <= radius && off >= -radius) set_cell(place, row, x, value);
  }
}

// A segment, 1/256 cells: its middle, half its length, its direction in Q15.
struct Segment {
  int64_t x, y, half;
  int32_t c, s;
};

// The segment of square (i, j) of the lattice, somewhere within it. A way turns it: Q15 products, < 2^31.
static Segment segment_of(const Place& place, const Start& start, int64_t wide, int64_t high, int32_t i, int32_t j,
                          WayAt way_at) {
  const auto share = [&](uint8_t k) { return static_cast<int64_t>(base::hash(place.seed, kSegments + k, i, j) >> 16); };
  const int64_t length = cells(place, start.length);
  const uint16_t fan =
      static_cast<uint16_t>(static_cast<int64_t>(start.fan) * 65536 / (360 * static_cast<int64_t>(base::kMicro)));
  const uint16_t angle = static_cast<uint16_t>(base::angle_of(start.lean) + ((2 * share(3) - 65536) * fan >> 16));
  Segment g = {i * wide + (share(0) * wide >> 16), j * high + (share(1) * high >> 16),
               (length + (share(2) * length >> 16)) / 4, base::cosine(angle), base::sine(angle)};
  if (way_at == nullptr) return g;
  const Way way = way_at(place, static_cast<int32_t>(g.x >> 8), static_cast<int32_t>(g.y >> 8));
  const int32_t c = (g.c * way.c - g.s * way.s) >> 15;
  g.s = (g.c * way.s + g.s * way.c) >> 15;
  g.c = c;
  return g;
}

// The way from b to a, on a torus the nearest one.
static int64_t way(int64_t a, int64_t b, uint16_t size, bool plane) {
  const int64_t round = static_cast<int64_t>(size) * 256, d = a - b;
  if (plane) return d;
  return d > round / 2 ? d - round : d < -round / 2 ? d + round : d;
}

static void segment_row(const Place& place, const Start& start, const Segment& g, int64_t y, int32_t value, void* row) {
  const int64_t width = cells(place, start.radius), dy = way(y, g.y, place.height, place.plane);
  if (dy > g.half + width || dy < -g.half - width) return;
  for (uint16_t x = 0; x < place.width; ++x) {
    const int64_t dx = way(static_cast<int64_t>(world(place.x + x, place.width, place.plane)) * 256 + 128, g.x,
                           place.width, place.plane);
    const int64_t along = (dx * g.c + dy * g.s) >> 15, across = (dy * g.c - dx * g.s) >> 15;
    if (along <= g.half && along >= -g.half && across <= width && across >= -width) set_cell(place, row, x, value);
  }
}

void lay_segments(const Place& place, const Start& start, const Levels& levels, uint16_t y, void* row, WayAt way_at) {
  clear_row(place, levels, row);
  const int32_t value = disc_level(start, levels);
  if (value == levels.background) return;
  const int64_t pitch = base::max(static_cast<int32_t>(cells(place, start.pitch)), 256);
  const int64_t across =
      place.plane ? 0 : base::max(1, static_cast<int32_t>((place.width * INT64_C(256) + pitch / 2) / pitch));
  const int64_t down =
      place.plane ? 0 : base::max(1, static_cast<int32_t>((place.height * INT64_C(256) + pitch / 2) / pitch));
  const int64_t wide = place.plane ? pitch : place.width * INT64_C(256) / across,
                high = place.plane ? pitch : place.height * INT64_C(256) / down;
  const int64_t at = static_cast<int64_t>(world(place.y + y, place.height, place.plane)) * 256 + 128;
  const int64_t reach = cells(place, start.length) + pitch, left = static_cast<int64_t>(place.x) * 256;
  const int32_t first_i = place.plane ? static_cast<int32_t>((left - reach) / pitch - 1) : 0;
  const int32_t last_i = place.plane ? static_cast<int32_t>((left + place.width * INT64_C(256) + reach) / pitch + 1)
                                     : static_cast<int32_t>(across - 1);
  const int32_t first_j = place.plane ? static_cast<int32_t>((at - reach) / pitch - 1) : 0;
  const int32_t last_j = place.plane ? static_cast<int32_t>((at + reach) / pitch + 1) : static_cast<int32_t>(down - 1);
  for (int32_t j = first_j; j <= last_j; ++j)
    for (int32_t i = first_i; i <= last_i; ++i)
      segment_row(place, start, segment_of(place, start, wide, high, i, j, way_at), at, value, row);
}

void segments_row(const Place& place, const Start& start, const Levels& levels, uint8_t, uint16_t y, void* row) {
  lay_segments(place, start, levels, y, row, nullptr);
}

}  // namespace dapple::start
