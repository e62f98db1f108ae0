// What the float64 reference shares. Everything here is written from the equations (Witkin & Kass 1991, corrected as
// docs/numbers.md says) and knows no arithmetic of the library's: it takes the recipe's numbers, the bytes of the start
// and, as a definition, the lists of passes. Concentrations are in k/b.
// SPDX-License-Identifier: MIT
#pragma once
#include <complex>
#include <string>
#include <vector>

#include "grow.hpp"

namespace reference {

using Plane = std::vector<double>;

struct Grid {
  int width, height;
  size_t cells() const { return static_cast<size_t>(width) * static_cast<size_t>(height); }
};

// --- fourier.cpp ---
// Complex transform of a grid whose sides are powers of two; inverse divides by the number of cells.
void fourier(std::vector<std::complex<double>>& values, const Grid& grid, bool inverse);

// Mean wavelength: width / power-weighted mean wavenumber, wavenumbers 1..width / 2. Orientation of the pattern (along
// its stripes), degrees 0..180, from the power-weighted mean of the double angle, whose length is the anisotropy, 0..1.
// Fill: share of cells above the level.
struct Figures {
  double wavelength, anisotropy, orientation, fill;
};
Figures measure(const Plane& field, const Grid& grid, double level);
double agreement(const Plane& a, const Plane& b, double level_a, double level_b);

// Differences of two patterns: wavelength as a share, fill, degrees (0 unless both anisotropies are above .5), cells.
struct Distance {
  double wavelength, fill, degrees, agreement;
};
Distance distance(const Plane& have, const Plane& want, const Grid& grid, double have_level, double want_level);

// --- threshold.cpp ---
// A stage of the threshold family with its numbers in double.
struct Threshold {
  int pairs;
  bool difference_abs, isotropic;
  double scale, stretch, ratio, angle[5], rho[4], k[4];  // rho, k: from, to, begin, end
  uint32_t steps;
  const int32_t* number;  // for the lists of passes alone
};
Threshold threshold_of(const dapple::Recipe& recipe);

// Diffusion of a plane: eq. (6) with [cos, sin] the direction of rate a1, y downwards.
struct Matrix {
  double xx, xy, yy;
};
Matrix diffusion(const Threshold& t, int plane);

// The planes of a start, from the bytes of the library.
std::vector<Plane> start_of(const dapple::Recipe& recipe, const Grid& grid, uint32_t seed);

// The shading field, eq. (13) to (15).
Plane shading(const Threshold& t, const std::vector<Plane>& planes);

// C <- e^-1/2 C + (1 - e^-1/2) k R, R the strict threshold on the field: the impulse of b dt = 1/2 before its Gaussian.
void impulse(const Threshold& t, std::vector<Plane>& planes, uint32_t step);

// Grow the whole recipe: macro steps b dt = 1/2 of eq. (12) with the library's passes in exact arithmetic; the same
// with the true Gaussian, eq. (9), by Fourier transform; explicit steps, eq. (5) and (7), `sub_steps` to a macro step.
std::vector<Plane> grow_by_passes(const Threshold& t, std::vector<Plane> planes, const Grid& grid);
std::vector<Plane> grow_by_gaussian(const Threshold& t, std::vector<Plane> planes, const Grid& grid);
std::vector<Plane> grow_by_euler(const Threshold& t, std::vector<Plane> planes, const Grid& grid, int sub_steps);

// --- mapped.cpp ---
// (cos, sin) of the doubled direction of a mapped::Kind at a place of the tile, at most 1 long.
struct Vector {
  double c, s;
};
Vector map_at(int32_t map, double detail, double u, double v, int pair);

// --- Threshold presets and the library's result ---
struct Named {
  std::string name;
  dapple::Recipe recipe;
};
std::vector<Named> presets_of(const dapple::Model* model);
// In the model's own units.
Plane library_field(const dapple::Recipe& recipe, const Grid& grid, uint32_t seed);

}  // namespace reference
