// The passes of docs/numbers.md in plain integers, cell by cell over a whole torus.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "stencil/lattice.hpp"

namespace reference {

namespace stencil = dapple::stencil;
using Row = std::vector<int16_t>;  // a row, or a plane row by row

// floor(a / 65536) without a shift, |a| < 2^30.
inline int32_t floor_q16(int32_t a) { return (a + (INT32_C(1) << 30)) / 65536 - 16384; }

// The passes of a plane, written down from docs/numbers.md; the full passes of all directions take 2, 1, 2, 1 ... in
// turn.
struct Step {
  stencil::Direction v;
  stencil::Pass pass;
};
inline std::vector<Step> passes_of(const dapple::grid::Tensor& t) {
  std::vector<Step> all;
  const stencil::Lattice lattice = stencil::lattice_of(t);
  int32_t full = 0;
  for (int i = 0; i < lattice.count; ++i) {
    stencil::PassSeries series = stencil::series_of(lattice.direction[i].share, 0);
    for (stencil::Pass pass{}; stencil::next_pass(series, pass);) {
      if (pass.weight == 16384) pass.rounding = static_cast<int16_t>(full++ % 2 == 0 ? 2 : 1);
      all.push_back({lattice.direction[i], pass});
    }
  }
  return all;
}

// One pass over a torus, cell by cell.
inline Row naive_pass(const Row& old, int32_t width, int32_t height, const Step& step) {
  Row out(old.size());
  const int32_t dx = step.v.vx * step.pass.stride, dy = step.v.vy * step.pass.stride;
  const auto at = [&](int32_t x, int32_t y) {
    return int32_t{old[static_cast<size_t>(((y % height + height) % height) * width + (x % width + width) % width)]};
  };
  for (int32_t y = 0; y < height; ++y)
    for (int32_t x = 0; x < width; ++x) {
      const int32_t d = at(x + dx, y + dy) + at(x - dx, y - dy) - 2 * at(x, y);
      out[static_cast<size_t>(y * width + x)] =
          static_cast<int16_t>(at(x, y) + floor_q16((d + step.pass.rounding) * step.pass.weight));
    }
  return out;
}

}  // namespace reference
