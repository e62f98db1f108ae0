// Where a texture lives. Sizes are in cells of the finest grid, which are the pixels of the picture.
// SPDX-License-Identifier: MIT
#pragma once
#include "../base/fixed.hpp"

namespace dapple {

constexpr uint16_t kSmallestSide = 8;  // cells of a torus, either direction; the largest side is 65535

// A torus of width x height cells: the texture repeats without a seam in both directions. (x, y) rolls it: the cell
// (0, 0) of the tile shows the cell (x mod width, y mod height) of the unrolled one.
struct Domain {
  uint16_t width, height;
  uint16_t x, y;
};

constexpr Domain torus(uint16_t width, uint16_t height) { return {width, height, 0, 0}; }
constexpr Domain torus(uint16_t width, uint16_t height, uint16_t x, uint16_t y) { return {width, height, x, y}; }

}  // namespace dapple
