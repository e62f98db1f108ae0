// From a ghost cell to the cell it stands for. See patch.hpp.
// SPDX-License-Identifier: MIT
#include "patch.hpp"

namespace dapple::grid {

// Across one side. `depth` cells beyond it, 0 the nearest; `along` it.
static void cross(const Side& side, uint8_t from, int32_t depth, int32_t along, int32_t wide, int32_t high, Source& s) {
  const bool mirror = side.kind != Side::joined;
  const uint8_t to = mirror ? from : side.side;
  const bool down = to < Side::top;  // places along it go down
  const int32_t across = down ? wide : high, length = down ? high : wide;
  const int32_t in = (to & 1) != 0 ? across - 1 - depth : depth;
  const int32_t place = !mirror && side.reversed ? length - 1 - along : along;
  s.x = down ? in : place;
  s.y = down ? place : in;
  if (!mirror) s.patch = side.patch;
  // Outwards is along the axis at odd sides, inwards at even ones.
  const bool turned = (from & 1) == (to & 1);
  s.mirrored = s.mirrored != (turned != (!mirror && side.reversed));
  s.swapped = s.swapped != ((from < Side::top) != down);
}

Source source_of(const Patches& all, uint8_t level, uint8_t patch, int32_t x, int32_t y) {
  const int32_t wide = all.width >> level, high = all.height >> level;
  Source s = {patch, x, y, false, false, nullptr};
  for (uint8_t crossed = 0; crossed < 2; ++crossed) {
    const bool beside = s.x < 0 || s.x >= wide;
    if (!beside && s.y >= 0 && s.y < high) break;
    const uint8_t from = beside ? (s.x < 0 ? Side::left : Side::right) : (s.y < 0 ? Side::top : Side::bottom);
    const int32_t at = beside ? s.x : s.y, size = beside ? wide : high;
    const Side& side = all.patch[s.patch].side[from];
    if (side.kind == Side::fixed && s.fixed == nullptr) s.fixed = &side;
    cross(side, from, at < 0 ? -1 - at : at - size, beside ? s.y : s.x, wide, high, s);
  }
  return s;
}

}  // namespace dapple::grid
