// Where a texture lives. Sizes and places are in cells of the finest grid, which are the pixels of the picture.
// SPDX-License-Identifier: MIT
#pragma once
#include "patch.hpp"

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
// A patch ends at its sides.
struct Domain {
  uint16_t width, height;
  int32_t x, y;
  bool plane;                                // a window, or a patch
  const evolve::Corners* corners = nullptr;  // what makes tiles agree: firmware without them links none of it
  const Patches* patches = nullptr;          // patch `patch` of these
  uint8_t patch = 0;
};

constexpr int32_t kFarthest = INT32_C(1) << 30;

constexpr Domain torus(uint16_t width, uint16_t height) { return {width, height, 0, 0, false}; }
constexpr Domain torus(uint16_t width, uint16_t height, int32_t x, int32_t y) { return {width, height, x, y, false}; }
constexpr Domain window(int32_t x, int32_t y, uint16_t width, uint16_t height) { return {width, height, x, y, true}; }
constexpr Domain on_patch(Patches&& all, uint8_t patch) = delete;  // would dangle
constexpr Domain on_patch(const Patches& all, uint8_t patch) {
  const bool there = patch < all.count && all.count <= kMostPatches;
  return {all.width, all.height, there ? all.patch[patch].x : 0, there ? all.patch[patch].y : 0, true, nullptr, &all, patch};
}

}  // namespace dapple

namespace dapple::grid {

// The cells that are grown, finest grid: the torus itself, or a window of the plane with a halo wide enough that what
// enters at its edges never reaches the window; or a patch with `pad` ghost cells around it. (x, y): the world's cell at
// (0, 0).
struct Ground {
  uint16_t width, height;
  int32_t x, y;
  const Patches* patches = nullptr;
  uint8_t patch = 0;
  uint16_t pad = 0;
};

DAPPLE_APART constexpr int32_t round_down(int32_t value, int32_t step) {
  return value >= 0 ? value - value % step : -((-value + step - 1) / step * step);
}

// `step` is what the coarsest grid's cells are to the finest; a patch's halo is a multiple of it.
constexpr Ground ground_of(const Domain& d, uint16_t halo, uint16_t step) {
  if (!d.plane) return {d.width, d.height, d.x % d.width, d.y % d.height};
  if (d.patches != nullptr) {
    const Patch& p = d.patches->patch[d.patch];
    return {static_cast<uint16_t>(d.patches->width + 2 * halo), static_cast<uint16_t>(d.patches->height + 2 * halo),
            p.x - halo, p.y - halo, d.patches, d.patch, halo};
  }
  const int32_t left = round_down(d.x - halo, step), top = round_down(d.y - halo, step);
  const int32_t right = -round_down(-(d.x + d.width + halo), step), bottom = -round_down(-(d.y + d.height + halo), step);
  return {static_cast<uint16_t>(right - left), static_cast<uint16_t>(bottom - top), left, top};
}

}  // namespace dapple::grid
