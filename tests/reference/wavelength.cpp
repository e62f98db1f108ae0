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
    ring[static_cast<size_t>(std::lround(std::hypot(wrapped(i % side), wrapped(i / side))))] += std::norm(wave[static_cast<size_t>(i)]);
  size_t peak = 2;
  const auto smooth = [&](size_t k) { return ring[k - 1] + 2 * ring[k] + ring[k + 1]; };
  for (size_t k = 3; k < static_cast<size_t>(side / 2); ++k)
    if (smooth(k) > smooth(peak)) peak = k;
  double power = 0, number = 0;
  std::complex<double> turn = 0;
  for (int i = 0; i < side * side; ++i) {
    const double x = wrapped(i % side), y = wrapped(i / side), k = std::hypot(x, y), p = std::norm(wave[static_cast<size_t>(i)]);
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

TEST_CASE("wavelength: what is asked for is what grows, for every window") {
  for (const char* name : {"zebra-bits", "sand-bits", "labyrinth-bits"})
    for (int window = 4; window <= 8; ++window) {
      const std::string shape = "level=0 window=" + std::to_string(window) + " wavelength=";
      Recipe recipe = dapple::load(*dapple::find_preset(name));
      dapple::Trouble trouble{};
      REQUIRE(dapple::parse((shape + "1").c_str(), recipe, trouble) == dapple::out_of_range);
      const double low = trouble.low / 1e6, high = trouble.high / 1e6;
      std::printf("%-15s window %d: %5.2f .. %5.2f ", name, window, low, high);
      for (int i = 0; i < 6; ++i) {
        const double wanted = low + (high - low) * i / 5;
        char text[32];
        std::snprintf(text, sizeof text, "%.6f", i == 5 ? high : wanted);
        const Recipe tuned = tests::preset_with(name, (shape + text).c_str());
        REQUIRE(tuned.stages == 1);
        const double along = tuned.stage[0].number[dapple::bits::angles] / 1e6;
        const Spectrum s = mean_of(tuned, 256, along);
        std::printf(" %5.2f %+5.1f%% %+4.1f", wanted, 100 * (s.wavelength / wanted - 1), s.degrees);
      }
      std::printf("\n");
    }
}

TEST_CASE("wavelength: presets as they are") {
  for (uint16_t i = 0; i < dapple::preset_count(); ++i) {
    char name[dapple::kMaxName];
    const Recipe recipe = dapple::load(*dapple::preset_at(i, name).preset);
    if (!recipe.stage[0].model->coarse) continue;
    const Spectrum s = mean_of(recipe, 512, 0);
    std::printf("%-18s %5.2f px  %5.1f\n", name, s.wavelength, s.degrees);
  }
}
