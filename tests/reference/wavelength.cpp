// What wavelength= promises of masks in small integers: spectra of grown textures against the number asked for.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "reference.hpp"

using dapple::Recipe;
using reference::Grid;

namespace {

const double kPi = std::acos(-1.0);
constexpr uint32_t kSeeds = 3;

struct Spectrum {
  double wavelength, degrees;  // of the stripes, -90..90 from x towards y (down)
};

// Mean wavenumber, weighted by power, between .5 and 1.6 of the strongest ring's.
Spectrum measured(const Recipe& recipe, int side, uint32_t seed) {
  const Grid grid = {side, side};
  tests::Grown tile(recipe, dapple::torus(static_cast<uint16_t>(side), static_cast<uint16_t>(side)), seed);
  REQUIRE(tile.status == dapple::ok);
  double mean = 0;
  const std::vector<int16_t> field = tile.field();
  for (const int16_t v : field) mean += v / static_cast<double>(field.size());
  std::vector<std::complex<double>> wave(field.size());
  for (size_t i = 0; i < field.size(); ++i) wave[i] = field[i] - mean;
  reference::fourier(wave, grid, false);
  const auto wrapped = [&](int k) { return k < side / 2 ? k : k - side; };
  std::vector<double> ring(static_cast<size_t>(side) + 2);
  for (int i = 0; i < side * side; ++i)
    ring[static_cast<size_t>(std::lround(std::hypot(wrapped(i % side), wrapped(i / side))))] +=
        std::norm(wave[static_cast<size_t>(i)]);
  size_t peak = 2;
  const auto smooth = [&](size_t k) { return ring[k - 1] + 2 * ring[k] + ring[k + 1]; };
  for (size_t k = 3; k < static_cast<size_t>(side / 2); ++k)
    if (smooth(k) > smooth(peak)) peak = k;
  double power = 0, number = 0;
  std::complex<double> turn = 0;
  for (int i = 0; i < side * side; ++i) {
    const double x = wrapped(i % side), y = wrapped(i / side), k = std::hypot(x, y),
                 p = std::norm(wave[static_cast<size_t>(i)]);
    if (k < 0.5 * static_cast<double>(peak) || k > 1.6 * static_cast<double>(peak)) continue;
    power += p;
    number += p * k;
    turn += p * std::polar(1.0, 2 * std::atan2(y, x));
  }
  return {side * power / number, std::remainder(std::arg(turn) * 90 / kPi + 90, 180)};
}

// The mean over the seeds; degrees against `along`.
Spectrum mean_of(const Recipe& recipe, int side, double along) {
  Spectrum mean{0, 0};
  for (uint32_t seed = 1; seed <= kSeeds; ++seed) {
    const Spectrum one = measured(recipe, side, seed);
    mean.wavelength += one.wavelength / kSeeds;
    mean.degrees += std::remainder(one.degrees - along, 180) / kSeeds;
  }
  return mean;
}

}  // namespace

// The wavelengths parse accepts after these changes, in pixels, from its refusal of one that is too short.
static std::pair<double, double> range_of(const char* preset, const std::string& changes) {
  Recipe recipe = tests::preset(preset);
  dapple::Trouble trouble{};
  REQUIRE(dapple::parse((changes + " wavelength=1").c_str(), recipe, trouble) == dapple::out_of_range);
  return {trouble.low / 1e6, trouble.high / 1e6};
}

static Recipe tuned(const char* preset, const std::string& changes, double wavelength) {
  char text[32];
  std::snprintf(text, sizeof text, " wavelength=%.6f", wavelength);
  const Recipe recipe = tests::preset_with(preset, (changes + text).c_str());
  INFO(std::string(preset) << " " << changes << text);
  REQUIRE(recipe.stages == 1);
  return recipe;
}

// The worst of `count` wavelengths over the range, printed: its error as a share, and degrees off the angle, below 1.5
// windows and in all. Stripes nearly as long as the square is wide lean towards its axes.
struct Worst {
  double share, degrees, leaning;
};
static Worst worst_of(const char* preset, int window, int count) {
  const std::string changes = "level=0 window=" + std::to_string(window);
  const auto [low, high] = range_of(preset, changes);
  Worst worst{0, 0, 0};
  std::printf("%-15s window %d, %5.2f to %5.2f cells:", preset, window, low, high);
  for (int i = 0; i < count; ++i) {
    const double wanted = low + (high - low) * i / (count - 1);
    const Recipe recipe = tuned(preset, changes, wanted);
    const Spectrum s = mean_of(recipe, 256, recipe.stage[0].number[dapple::bits::angles] / 1e6);
    const double share = s.wavelength / wanted - 1;
    std::printf(" %+.1f", 100 * share);
    worst.share = std::max(worst.share, std::fabs(share));
    double& degrees = wanted < 1.5 * window ? worst.degrees : worst.leaning;
    degrees = std::max(degrees, std::fabs(s.degrees));
  }
  std::printf(" %%; degrees %.1f, long %.1f\n", worst.degrees, worst.leaning);
  return worst;
}

TEST_CASE("wavelength: what is asked for is what grows, for every window") {
  for (const char* preset : {"zebra-bits", "sand-bits", "labyrinth-bits"})
    for (int window = 4; window <= 8; ++window) {
      const Worst worst = worst_of(preset, window, 13);
      INFO(std::string(preset) << " window " << window);
      CHECK(worst.share <= 0.04);
      if (preset[0] == 'l') continue;  // a labyrinth has no direction
      CHECK(worst.degrees <= 2);
      CHECK(worst.leaning <= 3.3);
    }
}

TEST_CASE("wavelength: in pixels on the coarser grids") {
  for (const char* preset : {"zebra-bits", "labyrinth-bits"})
    for (const int level : {1, 2}) {
      const std::string changes = "level=" + std::to_string(level);
      const double wanted = 8.5 * (1 << level);
      const Spectrum s = mean_of(tuned(preset, changes, wanted), 256 << level, 0);
      INFO(std::string(preset) << " level " << level << ": " << s.wavelength << " of " << wanted);
      CHECK(std::fabs(s.wavelength / wanted - 1) <= 0.04);
    }
}

// Along fields of directions the five small masks add up to the mask of an angle only roughly: within 9 % for the
// windows of 6 cells and more, measured where the direction does not bend.
TEST_CASE("wavelength: of steered masks, roughly") {
  for (int window = 6; window <= 8; ++window)
    for (const int angle : {0, 25, 60}) {
      const std::string changes = "level=0 bend=0 window=" + std::to_string(window) + " angle=" + std::to_string(angle);
      const auto [low, high] = range_of("flowing-stripes", changes);
      std::printf("flowing-stripes window %d, %5.2f to %5.2f cells, angle %2d:", window, low, high, angle);
      for (int i = 0; i < 6; ++i) {
        const double wanted = low + (high - low) * i / 5;
        const Spectrum s = mean_of(tuned("flowing-stripes", changes, wanted), 256, angle);
        std::printf(" %+.1f", 100 * (s.wavelength / wanted - 1));
        CHECK(std::fabs(s.wavelength / wanted - 1) <= 0.09);
        CHECK(std::fabs(s.degrees) <= 2.5);
      }
      std::printf(" %%\n");
    }
}

// The wavelengths, pixels, of the float prototypes that the presets were tuned after (weights of masks rounded
// otherwise, scores of seeds other than here: maze, giraffe).
TEST_CASE("wavelength: presets against their prototypes") {
  struct Prototype {
    const char* name;
    double pixels, share;
  };
  const Prototype prototypes[] = {
      {"zebra-bits", 17.3, .06},    {"sand-bits", 14.7, .06},       {"weave-bits", 14.5, .06},
      {"maze-bits", 14.3, .13},     {"triweave-bits", 17.2, .06},   {"twisty-maze-bits", 17.0, .06},
      {"coral-bits", 16.0, .06},    {"labyrinth-bits", 17.6, .06},  {"spots-bits", 17.3, .06},
      {"holes-bits", 18.0, .06},    {"fingerprint", 16.0, .06},     {"swirl-weave", 14.3, .06},
      {"crossing-hair", 17.0, .06}, {"flowing-stripes", 15.7, .08}, {"swirl-triweave", 16.7, .06},
      {"reptile-bits", 21.0, .06},  {"giraffe-bits", 23.0, .11},    {"brain", 31.0, .06},
  };
  for (const Prototype& p : prototypes) {
    const double pixels = mean_of(tests::preset(p.name), 512, 0).wavelength;
    std::printf("%-17s %5.2f px  %5.1f  %+5.1f %%\n", p.name, pixels, p.pixels, 100 * (pixels / p.pixels - 1));
    INFO(std::string(p.name));
    CHECK(std::fabs(pixels / p.pixels - 1) <= p.share);
  }
}
