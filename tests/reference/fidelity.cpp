// The threshold presets in integers against float64: the same passes in exact arithmetic, the true Gaussian, Euler.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "reference.hpp"

using reference::Distance;
using reference::Grid;
using reference::Named;
using reference::Plane;
using reference::Threshold;

namespace {

constexpr Grid kGrid = {256, 256};
constexpr uint32_t kSeeds = 3;

// The library's tile against a float64 field; a cell is on above the final rho, in the library rounded to its units.
Distance compare(const Named& preset, uint32_t seed, const Plane& want, const char* what, const Grid& grid = kGrid) {
  Plane have = library_field(preset.recipe, grid, seed);
  REQUIRE(have.size() == want.size());
  const double level = dapple::threshold::cell_level(preset.recipe.stage[0].number);
  const Distance d = distance(have, want, grid, level, reference::threshold_of(preset.recipe).rho[1]);
  const reference::Figures f = measure(have, grid, level);
  std::printf(
      "%-9s%-13s seed %u  wavelength %5.2f %+6.2f %%  fill %.3f %+.4f  along %5.1f (%.2f) %4.2f deg  agreement %.4f\n",
      what, preset.name.c_str(), seed, f.wavelength, 100 * d.wavelength, f.fill, d.fill, f.orientation, f.anisotropy,
      d.degrees, d.agreement);
  return d;
}

}  // namespace

TEST_CASE("reference: the same passes in float64") {
  const std::vector<Named> presets = reference::presets_of(&dapple::threshold_model);
  CHECK(presets.size() == 12);
  for (const Named& preset : presets)
    for (uint32_t seed = 1; seed <= kSeeds; ++seed) {
      const Threshold t = reference::threshold_of(preset.recipe);
      const Plane want = shading(t, grow_by_passes(t, start_of(preset.recipe, kGrid, seed), kGrid));
      const Distance d = compare(preset, seed, want, "passes");
      INFO(preset.name << " seed " << seed);
      CHECK(std::fabs(d.wavelength) <= 0.01);
      CHECK(std::fabs(d.fill) <= 0.01);
      CHECK(d.degrees <= 1);
      CHECK(d.agreement >= (t.pairs >= 3 ? 0.93 : 0.96));
    }
}

// The passes are not the Gaussian to the last digit: of the presets weave, maze and reptile move most, by -1.8 %. One
// tile of 256 cells measures its wavelength within .7 % (weave, 12 seeds), so the mean of the seeds is what is held.
TEST_CASE("reference: the true Gaussian of eq. (12)") {
  for (const Named& preset : reference::presets_of(&dapple::threshold_model)) {
    double wavelength = 0, fill = 0;
    for (uint32_t seed = 1; seed <= kSeeds; ++seed) {
      const Threshold t = reference::threshold_of(preset.recipe);
      const Plane want = shading(t, grow_by_gaussian(t, start_of(preset.recipe, kGrid, seed), kGrid));
      const Distance d = compare(preset, seed, want, "gaussian");
      wavelength += d.wavelength / kSeeds;
      fill += d.fill / kSeeds;
    }
    std::printf("gaussian %-13s mean    wavelength       %+6.2f %%  fill       %+.4f\n", preset.name.c_str(),
                100 * wavelength, fill);
    INFO(preset.name);
    CHECK(std::fabs(wavelength) <= 0.025);
    CHECK(std::fabs(fill) <= 0.02);
  }
}

// Kernels whose strides grow by the root of 2: variances of 46 and more along a direction. All grow from noise.
TEST_CASE("reference: the true Gaussian of eq. (12), wide kernels") {
  constexpr Grid kWide = {512, 512};
  for (Named preset : reference::presets_of(&dapple::threshold_model)) {
    if (preset.name != "zebra" && preset.name != "weave" && preset.name != "giraffe") continue;
    int32_t& scale = preset.recipe.stage[0].number[dapple::threshold::scale];
    scale *= preset.name == "giraffe" ? 2 : 3;
    preset.recipe.start.kind = dapple::Start::noise;
    preset.recipe.start.row = dapple::row_start(preset.recipe.start.kind);
    double wavelength = 0, fill = 0;
    for (uint32_t seed = 1; seed <= kSeeds; ++seed) {
      const Threshold t = reference::threshold_of(preset.recipe);
      const Plane want = shading(t, grow_by_gaussian(t, start_of(preset.recipe, kWide, seed), kWide));
      const Distance d = compare(preset, seed, want, "wide", kWide);
      wavelength += d.wavelength / kSeeds;
      fill += d.fill / kSeeds;
    }
    std::printf("wide     %-13s mean    wavelength       %+6.2f %%  fill       %+.4f\n", preset.name.c_str(),
                100 * wavelength, fill);
    INFO(preset.name);
    CHECK(std::fabs(wavelength) <= 0.025);
    CHECK(std::fabs(fill) <= 0.02);
  }
}

TEST_CASE("reference: explicit steps in float64") {
  for (Named preset : reference::presets_of(&dapple::threshold_model)) {
    dapple::Trouble trouble{};
    REQUIRE(dapple::parse("solver=euler", preset.recipe, trouble) == dapple::ok);
    const Threshold t = reference::threshold_of(preset.recipe);
    double largest = 0;
    for (int i = 0; i < 2 * t.pairs; ++i) largest = std::max(largest, diffusion(t, i).xx + diffusion(t, i).yy);
    const int sub_steps = static_cast<int>(std::ceil(0.5 * (4 * largest + 1) / 1.7));
    const Plane want = shading(t, grow_by_euler(t, start_of(preset.recipe, kGrid, 1), kGrid, sub_steps));
    const Distance d = compare(preset, 1, want, "euler");
    INFO(preset.name);
    CHECK(std::fabs(d.wavelength) <= 0.01);
    CHECK(std::fabs(d.fill) <= 0.01);
    CHECK(d.degrees <= 1);
    CHECK(d.agreement >= (t.pairs >= 3 ? 0.93 : 0.96));
  }
}
