// Where a texture lives. Sizes and places are in cells of the finest grid, which are the pixels of the picture.
// SPDX-License-Identifier: MIT
#pragma once
#include "../base/fixed.hpp"

namespace dapple::evolve {
struct Corners;
}

namespace dapple {

constexpr uint16_t kSmallestSide = 8;  // cells of a domain, either direction; the largest side is 65535

// A torus of width x height cells repeats without a seam in both directions; (x, y) rolls it: the cell (0, 0) of the
// tile shows the cell (x mod width, y mod height) of the unrolled one; x and y are multiples of what the recipe's
// coarsest grid asks of the sides.
// A window shows the cells (x, y) .. (x + width - 1, y + height - 1) of the infinite plane; it holds the same bits as that
// part of any other window. Its cells lie within -kFarthest .. kFarthest.
// Corner tiles are a torus too, a square one of 4 x 4 tiles that agree where they may meet: see corners.hpp.
struct Domain {
  uint16_t width, height;
  int32_t x, y;
  bool plane;
  const evolve::Corners* corners = nullptr;  // what makes tiles agree: firmware without them links none of it
};

constexpr int32_t kFarthest = INT32_C(1) << 30;

constexpr Domain torus(uint16_t width, uint16_t height) { return {width, height, 0, 0, false}; }
constexpr Domain torus(uint16_t width, uint16_t height, int32_t x, int32_t y) { return {width, height, x, y, false}; }
constexpr Domain window(int32_t x, int32_t y, uint16_t width, uint16_t height) { return {width, height, x, y, true}; }

}  // namespace dapple

namespace dapple::grid {

// The cells that are grown, finest grid: the torus itself, or a window of the plane with a halo wide enough that what
// enters at its edges never reaches the window. (x, y): the world's cell at (0, 0).
struct Ground {
  uint16_t width, height;
  int32_t x, y;
};

constexpr int32_t round_down(int32_t value, int32_t step) {
  return value >= 0 ? value - value % step : -((-value + step - 1) / step * step);
}

// `step` is what the coarsest grid's cells are to the finest.
constexpr Ground ground_of(const Domain& d, uint16_t halo, uint16_t step) {
  if (!d.plane) return {d.width, d.height, d.x % d.width, d.y % d.height};
  const int32_t left = round_down(d.x - halo, step), top = round_down(d.y - halo, step);
  const int32_t right = -round_down(-(d.x + d.width + halo), step), bottom = -round_down(-(d.y + d.height + halo), step);
  return {static_cast<uint16_t>(right - left), static_cast<uint16_t>(bottom - top), left, top};
}

}  // namespace dapple::grid
