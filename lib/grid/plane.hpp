// What a model says of one plane: how its concentrations diffuse and what it holds at the start.
// SPDX-License-Identifier: MIT
#pragma once
#include "rows.hpp"

namespace dapple::grid {

constexpr int32_t kOneVariance = 65536;  // variances are Q16, in cells^2

// Diffusion of one plane as the variance matrix of its Gaussian over one step, Q16: symmetric, positive; x to the
// right, y downwards. A Laplacian with coefficient D over a time dt has xx = yy = 2 D dt.
struct Tensor {
  int32_t xx, xy, yy;
};

// The same tensor on a grid coarser by 2^level.
constexpr Tensor at_level(const Tensor& t, uint8_t level) {
  const int32_t square = INT32_C(1) << (2 * level);
  return {static_cast<int32_t>(base::divide_round(t.xx, square)), static_cast<int32_t>(base::divide_round(t.xy, square)),
          static_cast<int32_t>(base::divide_round(t.yy, square))};
}

// The tensor of `length` steps, Q16: any length up to 16.
constexpr Tensor over(const Tensor& t, int32_t length) {
  const auto times = [&](int32_t variance) {
    return static_cast<int32_t>(base::divide_round(static_cast<int64_t>(variance) * length, kOneVariance));
  };
  return {times(t.xx), times(t.xy), times(t.yy)};
}

// Values of the start, in the model's own format.
struct Levels {
  int32_t background, disc;  // seeds: outside and inside the discs (at full amplitude)
  int32_t low, high;         // noise: uniform over low..high
};

}  // namespace dapple::grid
