// Mip levels of maps that tile: each level is the mean of 2 x 2 pixels of the one above, and tiles like it. A side of an
// odd number n = 2 m + 1 of pixels becomes m pixels of n / m pixels each: pixel i takes m - i, m and i + 1 parts of n of
// pixels 2 i, 2 i + 1 and 2 i + 2, so that every pixel of the torus counts for the same.
// SPDX-License-Identifier: MIT
#pragma once
#include "paint.hpp"

namespace dapple {

// A map, or a level of one. Pixels are l8, rgb888, rgba8888, l16 or l16_swapped; normals are made unit vectors again.
struct Mip {
  Pixels format;
  bool normal;  // rgb888 or rgba8888 as View::normal paints it, either way up
  uint16_t width, height;
};

// A side of the next level, down to 1; and the levels there are below a map.
constexpr uint16_t mip_side(uint16_t side) { return static_cast<uint16_t>(side > 1 ? side / 2 : 1); }
constexpr uint8_t mip_levels(uint16_t width, uint16_t height) {
  uint8_t levels = 0;
  for (uint16_t side = width > height ? width : height; side > 1; side = mip_side(side)) ++levels;
  return levels;
}
constexpr Mip mip_below(const Mip& mip) { return {mip.format, mip.normal, mip_side(mip.width), mip_side(mip.height)}; }

// The rows from 2 y on that row y of the next level is made of.
constexpr uint8_t mip_rows(uint16_t height) { return height == 1 ? 1 : height % 2 == 0 ? 2 : 3; }

// Row y of the level below `mip`: in[k] is row 2 y + k of it, mip_rows(mip.height) of them.
void mip_row(const Mip& mip, const uint8_t* const* in, uint16_t y, uint8_t* out);

}  // namespace dapple
