// Smooth noise: hashed values at nodes a pitch apart, blended by quadratic B-splines over 3 x 3 of them.
// SPDX-License-Identifier: MIT
#include "../base/hash.hpp"
#include "start.hpp"

namespace dapple::start {

constexpr uint32_t kPhases = 72;  // hash streams, one a plane

// A place between nodes: the middle one of three, and their weights in Q7.
struct Nodes {
  int32_t middle, count;  // count: on the ring, 0 on the plane
  int32_t weight[3];
};
DAPPLE_APART static Nodes nodes_at(int32_t cell, uint16_t size, bool plane, int64_t pitch) {
  Nodes n{};
  const int64_t rounds = (size * INT64_C(256) + pitch / 2) / pitch;
  n.count = plane ? 0 : rounds < 3 ? 3 : static_cast<int32_t>(rounds);
  const int64_t twice = 2 * static_cast<int64_t>(cell) + 1;  // the cell's middle
  const int64_t at =
      plane ? (twice * 32768 - (twice < 0 ? pitch - 1 : 0)) / pitch : twice * n.count * 128 / size;  // Q8
  n.middle = static_cast<int32_t>(at >> 8);
  const int32_t f = static_cast<int32_t>(at & 255);
  n.weight[0] = ((256 - f) * (256 - f)) >> 10;
  n.weight[2] = (f * f) >> 10;
  n.weight[1] = 128 - n.weight[0] - n.weight[2];
  return n;
}

static int32_t node(const Nodes& n, int32_t k) {
  const int32_t at = n.middle + k;
  if (n.count == 0) return at;
  return at < 0 ? at + n.count : at >= n.count ? at - n.count : at;
}

// Uniform nodes of +-1 in Q14; weights of 2^14 in all: |sum| <= 2^28. Five halves of it have the spread of a circle's
// coordinates.
void phases_row(const Place& place, const Start& start, const Levels& levels, uint8_t plane, uint16_t y, void* row) {
  const int64_t pitch = base::max(static_cast<int32_t>(cells(place, start.pitch)), 256);
  const Nodes down = nodes_at(world(place.y + y, place.height, place.plane), place.height, place.plane, pitch);
  base::RowKey key[3] = {};
  for (uint8_t k = 0; k < 3; ++k) key[k] = base::row_key(place.seed, kPhases + plane, node(down, k - 1));
  const int64_t far = levels.high - levels.background;
  for (uint16_t x = 0; x < place.width; ++x) {
    const Nodes across = nodes_at(world(place.x + x, place.width, place.plane), place.width, place.plane, pitch);
    int32_t sum = 0;
    for (uint8_t k = 0; k < 3; ++k)
      for (uint8_t i = 0; i < 3; ++i)
        sum += down.weight[k] * across.weight[i] *
               (static_cast<int32_t>(base::hash(key[k], node(across, i - 1)) >> 17) - 16384);
    const int32_t value = levels.background + static_cast<int32_t>((far * (sum >> 14) * 5) >> 15);
    set_cell(place, row, x, base::clamp(value, levels.low, levels.high));
  }
}

}  // namespace dapple::start
