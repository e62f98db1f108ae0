// Surfaces a texture is grown for [Witkin & Kass 1991, 4]: the metric tensor of every cell, and what undoes it. A
// pattern grown with V A V^T, V V^T the inverse metric, has on the surface the sizes that one grown with A has in the
// plane.
// SPDX-License-Identifier: MIT
#pragma once
#include "../base/math.hpp"
#include "../base/status.hpp"
#include "../grid/domain.hpp"

namespace dapple::stencil {
struct SurfaceWork;
extern const SurfaceWork surface_work;
}  // namespace dapple::stencil

namespace dapple {

// Squared lengths on the surface of a step to the next cell, and their product: x_u x_u, x_u x_v, x_v x_v; Q16, one
// cell of the plane is 65536.
struct Metric {
  int32_t xx, xy, yy;
};
constexpr int32_t kMostMetric = INT32_C(1) << 30;
constexpr int32_t kLeastMetric = 256;  // of the smaller principal value

// A surface and what has been measured of it. `measure` goes over all cells before a texture may begin on it; the
// struct and what it points to must outlive the texture.
struct Surface {
  enum Shape : uint8_t {
    flat,
    torus,    // around the hole along x, around the tube along y; `ratio` of the radii of tube and ring
    vase,     // around the axis along x, down it along y; a radius of 1 - ratio sin 2 pi v, `tall` its height, ...
    sphere,   // a face of a cube blown up to a sphere, equal angles from cell to cell; square patches
    heights,  // a cell for every height, in 1/256 of a cell, patch after patch
    tensors,  // a metric for every cell, patch after patch
  } shape;
  uint16_t width, height;  // cells of the torus or patch
  uint8_t patches;         // 1..kMostPatches
  bool open;               // heights: the patch ends at its sides, instead of repeating
  int32_t ratio, tall;     // 1/kMicro; ... in circumferences
  const int16_t* height_of;
  const Metric* metric_of;

  // Measured:
  int32_t least;  // principal value of any cell, Q16
  int32_t lean;   // the most that two principal values of an inverse differ, half of it, against 1 / least, Q14
  // The next cell to measure; after bad_surface the first one whose tensor is not positive, or not in range.
  uint8_t patch;
  uint16_t x, y;
  int64_t spread;  // of inverses, so far

  const stencil::SurfaceWork* work = &stencil::surface_work;  // flux.hpp: programs without surfaces link none of it
};

// A torus that is `ratio` as thick as wide; the length of x at the tube's crown is a cell.
constexpr Surface surface_of(Surface::Shape shape, uint16_t width, uint16_t height, uint8_t patches = 1) {
  return {shape, width, height, patches, false, 500000, 1000000, nullptr, nullptr, INT32_MAX, 0, 0, 0, 0, 0};
}
constexpr Surface torus_surface(uint16_t width, uint16_t height, int32_t ratio) {
  Surface s = surface_of(Surface::torus, width, height);
  s.ratio = ratio;
  return s;
}
constexpr Surface vase_surface(uint16_t width, uint16_t height, int32_t ratio, int32_t tall) {
  Surface s = surface_of(Surface::vase, width, height);
  s.ratio = ratio;
  s.tall = tall;
  return s;
}
constexpr Surface sphere_surface(uint16_t side, uint8_t patches = 6) {
  return surface_of(Surface::sphere, side, side, patches);
}
constexpr Surface height_surface(uint16_t width, uint16_t height, const int16_t* heights, bool open = false) {
  Surface s = surface_of(Surface::heights, width, height);
  s.height_of = heights;
  s.open = open;
  return s;
}
constexpr Surface tensor_surface(uint16_t width, uint16_t height, const Metric* metric, uint8_t patches = 1) {
  Surface s = surface_of(Surface::tensors, width, height, patches);
  s.metric_of = metric;
  return s;
}

constexpr bool is_measured(const Surface& s) { return s.patch == s.patches && s.patches > 0; }

// Up to `rows` rows of cells: more, done, or bad_surface (Surface::patch, x, y say where; also for a ratio that leaves
// no radius, a missing map, sides below kSmallestSide).
Status measure(Surface& surface, uint32_t rows);

// The metric of a cell, 0 <= x < width, 0 <= y < height.
Metric metric_at(const Surface& surface, uint8_t patch, int32_t x, int32_t y);

}  // namespace dapple

namespace dapple::stencil {

// V = [[p, q], [0, r]] times the root of Surface::least, Q14: all within +-16384.
struct Inverse {
  int16_t p, q, r;
};

// Of the mean metric of a cell of a grid coarser by 2^level.
Inverse inverse_at(const Surface& surface, uint8_t level, uint8_t patch, int32_t x, int32_t y);

// The same with axes exchanged or mirrored.
Inverse turned_inverse(Inverse v, bool swapped, bool mirrored);

}  // namespace dapple::stencil
