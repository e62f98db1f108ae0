// Fourier transform and the figures of a pattern.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "reference.hpp"

namespace reference {

using Complex = std::complex<double>;
static const double kPi = std::acos(-1.0);

// Transforms every column at once: the butterflies of radix 2 are between whole rows.
static void transform_columns(std::vector<Complex>& values, size_t width, size_t height, bool inverse) {
  const auto row = [&](size_t y) { return reinterpret_cast<double*>(values.data() + y * width); };
  for (size_t i = 1, j = 0; i < height; ++i) {
    size_t bit = height >> 1;
    for (; j & bit; bit >>= 1) j ^= bit;
    j ^= bit;
    if (i < j) std::swap_ranges(row(i), row(i) + 2 * width, row(j));
  }
  for (size_t half = 1; half < height; half *= 2)
    for (size_t y = 0; y < height; ++y) {
      if (y & half) continue;
      const Complex w =
          std::polar(1.0, (inverse ? kPi : -kPi) * static_cast<double>(y % half) / static_cast<double>(half));
      const double re = w.real(), im = w.imag();
      double *a = row(y), *b = row(y + half);
      for (size_t x = 0; x < 2 * width; x += 2) {
        const double t = re * b[x] - im * b[x + 1], u = re * b[x + 1] + im * b[x];
        b[x] = a[x] - t;
        b[x + 1] = a[x + 1] - u;
        a[x] += t;
        a[x + 1] += u;
      }
    }
}

static void transpose(const std::vector<Complex>& from, std::vector<Complex>& to, size_t width, size_t height) {
  constexpr size_t kBlock = 16;
  for (size_t y = 0; y < height; y += kBlock)
    for (size_t x = 0; x < width; x += kBlock)
      for (size_t j = y; j < std::min(y + kBlock, height); ++j)
        for (size_t i = x; i < std::min(x + kBlock, width); ++i) to[i * height + j] = from[j * width + i];
}

void fourier(std::vector<Complex>& values, const Grid& grid, bool inverse) {
  const size_t width = static_cast<size_t>(grid.width), height = static_cast<size_t>(grid.height);
  std::vector<Complex> turned(values.size());
  transform_columns(values, width, height, inverse);
  transpose(values, turned, width, height);
  transform_columns(turned, height, width, inverse);
  transpose(turned, values, height, width);
  const double share = inverse ? 1.0 / static_cast<double>(grid.cells()) : 1;
  for (Complex& v : values) v *= share;
}

Figures measure(const Plane& field, const Grid& grid, double level) {
  double mean = 0;
  for (const double v : field) mean += v / static_cast<double>(field.size());
  std::vector<Complex> wave(field.size());
  for (size_t i = 0; i < field.size(); ++i) wave[i] = field[i] - mean;
  fourier(wave, grid, false);
  double power = 0, number = 0;
  Complex turn = 0;
  for (int y = 0; y < grid.height; ++y)
    for (int x = 0; x < grid.width; ++x) {
      const double kx = x < grid.width / 2 ? x : x - grid.width;
      const double ky = (y < grid.height / 2 ? y : y - grid.height) * static_cast<double>(grid.width) / grid.height;
      const double k = std::hypot(kx, ky), p = std::norm(wave[static_cast<size_t>(y * grid.width + x)]);
      if (k < 1 || k > grid.width / 2.0) continue;
      power += p;
      number += p * k;
      turn += p * std::polar(1.0, 2 * std::atan2(ky, kx));
    }
  const double along = std::fmod(std::arg(turn) * 90 / kPi + 90 + 180, 180);  // stripes lie across the wave vector
  const auto on = std::count_if(field.begin(), field.end(), [&](double v) { return v > level; });
  return {grid.width * power / number, std::abs(turn) / power, along,
          static_cast<double>(on) / static_cast<double>(field.size())};
}

double agreement(const Plane& a, const Plane& b, double level_a, double level_b) {
  size_t same = 0;
  for (size_t i = 0; i < a.size(); ++i) same += (a[i] > level_a) == (b[i] > level_b);
  return static_cast<double>(same) / static_cast<double>(a.size());
}

Distance distance(const Plane& have, const Plane& want, const Grid& grid, double have_level, double want_level) {
  const Figures a = measure(have, grid, have_level), b = measure(want, grid, want_level);
  double degrees = std::fabs(a.orientation - b.orientation);
  if (degrees > 90) degrees = 180 - degrees;
  const bool oriented = a.anisotropy > 0.5 && b.anisotropy > 0.5;
  return {a.wavelength / b.wavelength - 1, a.fill - b.fill, oriented ? degrees : 0,
          agreement(have, want, have_level, want_level)};
}

}  // namespace reference
