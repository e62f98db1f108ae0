// Gray-Scott in integers against float64: point by point while errors have no time to grow, then as a pattern.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "reference.hpp"

using reference::Grid;
using reference::Plane;
namespace slot = dapple::gray_scott;

namespace {

constexpr Grid kGrid = {256, 256};

struct Rates {
  double du, dv, feed, kill;
};

// u' = u + Du lap u - u v^2 + F (1 - u), v' = v + Dv lap v + u v^2 - (F + k) v, five points, dt = 1.
void step(Plane& u, Plane& v, const Grid& grid, const Rates& rates) {
  const Plane a = u, b = v;
  const size_t width = static_cast<size_t>(grid.width), height = static_cast<size_t>(grid.height);
  for (size_t y = 0; y < height; ++y) {
    const size_t row = y * width, up = (y + height - 1) % height * width, down = (y + 1) % height * width;
    for (size_t x = 0; x < width; ++x) {
      const size_t l = row + (x == 0 ? width - 1 : x - 1), r = row + (x + 1 == width ? 0 : x + 1), here = row + x;
      const double c = a[here], d = b[here], z = c * d * d;
      u[here] += rates.du * (a[l] + a[r] + a[up + x] + a[down + x] - 4 * c) - z + rates.feed * (1 - c);
      v[here] += rates.dv * (b[l] + b[r] + b[up + x] + b[down + x] - 4 * d) + z - (rates.feed + rates.kill) * d;
    }
  }
}

}  // namespace

// The library's v after `steps` against the float64 one.
static void check_step(reference::Named preset, uint32_t steps, const Plane& want) {
  preset.recipe.stage[0].steps = steps;
  const double level = preset.recipe.stage[0].number[slot::above] / 1e6;
  Plane have = library_field(preset.recipe, kGrid, 1);
  REQUIRE(have.size() == want.size());
  double worst = 0, square = 0;
  for (size_t i = 0; i < have.size(); ++i) {
    have[i] /= slot::kUnit;
    worst = std::max(worst, std::fabs(have[i] - want[i]));
    square += (have[i] - want[i]) * (have[i] - want[i]);
  }
  const double rms = std::sqrt(square / static_cast<double>(have.size()));
  const reference::Distance d = distance(have, want, kGrid, level, level);
  const reference::Figures f = measure(have, kGrid, level);
  std::printf(
      "gray-scott %-8s %4u steps  v rms %.4f worst %.4f  wavelength %5.2f %+5.2f %%  fill %.3f %+.4f  agreement %.4f\n",
      preset.name.c_str(), steps, rms, worst, f.wavelength, 100 * d.wavelength, f.fill, d.fill, d.agreement);
  INFO(preset.name << " after " << steps);
  CHECK(std::fabs(d.wavelength) <= (steps <= 200 ? 0.01 : 0.025));
  CHECK(std::fabs(d.fill) <= (steps <= 200 ? 0.01 : 0.02));
  if (steps > 200) return;
  CHECK(d.agreement >= 0.99);
  CHECK(rms <= 0.005);
  CHECK(worst <= 0.03);
}

TEST_CASE("reference: Gray-Scott in float64") {
  for (const reference::Named& preset : reference::presets_of(&dapple::gray_scott_model)) {
    const int32_t* number = preset.recipe.stage[0].number;
    const double square = number[slot::scale] / 1e6 * number[slot::scale] / 1e6;
    const Rates rates = {0.16 * square, 0.08 * square, number[slot::feed] / 1e6, number[slot::kill] / 1e6};
    std::vector<Plane> planes = start_of(preset.recipe, kGrid, 1);
    for (double& u : planes[0]) u *= double{slot::kUnit} / slot::kOne;  // u = 1 is 16383
    uint32_t done = 0;
    for (const uint32_t steps : {50u, 200u, 1000u, 4000u}) {
      for (; done < steps; ++done) step(planes[0], planes[1], kGrid, rates);
      check_step(preset, steps, planes[1]);
    }
  }
}
