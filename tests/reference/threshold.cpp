// The threshold family in float64.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <string>

#include "reference.hpp"

namespace reference {

namespace slot = dapple::threshold;
static const double kPi = std::acos(-1.0);

Threshold threshold_of(const dapple::Recipe& recipe) {
  const int32_t* n = recipe.stage[0].number;
  Threshold t{};
  t.pairs = n[slot::pairs];
  t.difference_abs = n[slot::react] == slot::difference_abs;
  t.isotropic = n[slot::diffusion] == slot::isotropic;
  t.scale = n[slot::scale] / 1e6;
  t.stretch = n[slot::stretch] / 1e6;
  t.ratio = n[slot::ratio] / 1e6;
  for (int j = 0; j < 5; ++j) t.angle[j] = n[slot::angles + j] / 1e6 * kPi / 180;
  for (int i = 0; i < 4; ++i) t.rho[i] = n[slot::rho + i] / 1e6;
  for (int i = 0; i < 4; ++i) t.k[i] = n[slot::k + i] / 1e6;
  t.steps = recipe.stage[0].steps;
  t.number = n;
  return t;
}

// P+ = [e s, s], P- = [e s, d s]; isotropic [s, s] and [d s, d s]. A = a1^2 e1 e1^T + a2^2 e2 e2^T.
Matrix diffusion(const Threshold& t, int plane) {
  const double a2 = plane % 2 == 0 ? t.scale : t.scale * t.ratio, a1 = t.isotropic ? a2 : t.scale * t.stretch;
  const double c = std::cos(t.angle[plane / 2]), s = std::sin(t.angle[plane / 2]);
  return {a1 * a1 * c * c + a2 * a2 * s * s, (a1 * a1 - a2 * a2) * c * s, a1 * a1 * s * s + a2 * a2 * c * c};
}

// A schedule at step n of N: the first value until begin, linear to the second at end, then that.
static double scheduled(const double (&s)[4], uint32_t step, uint32_t steps) {
  const double f = static_cast<double>(step) / steps;
  if (f < s[2]) return s[0];
  if (f >= s[3]) return s[1];
  return s[0] + (s[1] - s[0]) * (f - s[2]) / (s[3] - s[2]);
}

std::vector<Plane> start_of(const dapple::Recipe& recipe, const Grid& grid, uint32_t seed) {
  const dapple::Model& model = *recipe.stage[0].model;
  const int32_t* number = recipe.stage[0].number;
  const uint16_t width = static_cast<uint16_t>(grid.width), height = static_cast<uint16_t>(grid.height);
  const dapple::start::Place place = {dapple::grid::Cell::int16, width, height, 0, 0, 0, false, seed};
  std::vector<int16_t> row(width);
  std::vector<Plane> planes(model.planes(number));
  for (uint8_t i = 0; i < planes.size(); ++i)
    for (uint16_t y = 0; y < height; ++y) {
      recipe.start.row(place, recipe.start, model.levels(number, i), i, y, row.data());
      for (const int16_t v : row) planes[i].push_back(static_cast<double>(v) / model.unit);
    }
  return planes;
}

Plane shading(const Threshold& t, const std::vector<Plane>& planes) {
  Plane field(planes[0].size());
  for (size_t i = 0; i < field.size(); ++i) {
    double most = planes[0][i] - planes[1][i], least = most;
    for (size_t j = 1; j < static_cast<size_t>(t.pairs); ++j) {
      const double d = planes[2 * j][i] - planes[2 * j + 1][i];
      most = std::max(most, d);
      least = std::min(least, d);
    }
    field[i] = t.difference_abs && t.pairs > 1 ? most + least : most;
  }
  return field;
}

void impulse(const Threshold& t, std::vector<Plane>& planes, uint32_t step) {
  const Plane field = shading(t, planes);
  const double rho = scheduled(t.rho, step, t.steps), decay = std::exp(-0.5),
               add = (1 - decay) * scheduled(t.k, step, t.steps);
  for (Plane& plane : planes)
    for (size_t i = 0; i < plane.size(); ++i) plane[i] = decay * plane[i] + (field[i] > rho ? add : 0);
}

// One pass, C' = C + w (C[p + s] + C[p - s] - 2 C), every cell from the old plane.
static void pass(Plane& plane, const Grid& grid, int dx, int dy, double weight) {
  const Plane old = plane;
  const int width = grid.width, height = grid.height;
  const auto row = [&](int y) { return old.data() + static_cast<ptrdiff_t>((y % height + height) % height) * width; };
  const int turn = (dx % width + width) % width;
  std::vector<double> ahead(static_cast<size_t>(width)), behind(ahead);
  for (int y = 0; y < height; ++y) {
    std::rotate_copy(row(y + dy), row(y + dy) + turn, row(y + dy) + width, ahead.begin());
    std::rotate_copy(row(y - dy), row(y - dy) + width - turn, row(y - dy) + width, behind.begin());
    double* out = plane.data() + static_cast<ptrdiff_t>(y) * width;
    for (int x = 0; x < width; ++x)
      out[x] += weight * (ahead[static_cast<size_t>(x)] + behind[static_cast<size_t>(x)] - 2 * out[x]);
  }
}

static void passes(const Threshold& t, Plane& plane, const Grid& grid, int index) {
  namespace stencil = dapple::stencil;
  const stencil::Lattice lattice = stencil::lattice_of(slot::tensor(t.number, static_cast<uint8_t>(index)));
  for (int i = 0; i < lattice.count; ++i) {
    const stencil::Direction& d = lattice.direction[i];
    stencil::PassSeries series = stencil::series_of(d.share, 0);
    for (stencil::Pass p{}; stencil::next_pass(series, p);)
      pass(plane, grid, p.stride * d.vx, p.stride * d.vy, p.weight / 65536.0);
  }
}

std::vector<Plane> grow_by_passes(const Threshold& t, std::vector<Plane> planes, const Grid& grid) {
  for (uint32_t step = 0; step < t.steps; ++step) {
    impulse(t, planes, step);
    for (size_t i = 0; i < planes.size(); ++i) passes(t, planes[i], grid, static_cast<int>(i));
  }
  return planes;
}

// The Gaussian over dt = 1/2 in wave numbers: exp(-dt q^T A q).
static Plane gaussian_of(const Matrix& a, const Grid& grid) {
  Plane gain(grid.cells());
  for (int y = 0; y < grid.height; ++y)
    for (int x = 0; x < grid.width; ++x) {
      const double qx = 2 * kPi * (x <= grid.width / 2 ? x : x - grid.width) / grid.width;
      const double qy = 2 * kPi * (y <= grid.height / 2 ? y : y - grid.height) / grid.height;
      gain[static_cast<size_t>(y * grid.width + x)] =
          std::exp(-0.5 * (a.xx * qx * qx + 2 * a.xy * qx * qy + a.yy * qy * qy));
    }
  return gain;
}

// Both planes of a pair in one complex transform: a + i b, taken apart by the symmetry of the transforms of real
// planes.
static void convolve(Plane& a, Plane& b, const Plane& gain_a, const Plane& gain_b, const Grid& grid) {
  using Complex = std::complex<double>;
  std::vector<Complex> z(a.size()), out(a.size());
  for (size_t i = 0; i < a.size(); ++i) z[i] = {a[i], b[i]};
  fourier(z, grid, false);
  for (int y = 0; y < grid.height; ++y)
    for (int x = 0; x < grid.width; ++x) {
      const size_t here = static_cast<size_t>(y * grid.width + x);
      const size_t mirror =
          static_cast<size_t>((grid.height - y) % grid.height * grid.width + (grid.width - x) % grid.width);
      const Complex even = 0.5 * (z[here] + std::conj(z[mirror]));
      out[here] = gain_a[here] * even + gain_b[here] * (z[here] - even);
    }
  fourier(out, grid, true);
  for (size_t i = 0; i < a.size(); ++i) {
    a[i] = out[i].real();
    b[i] = out[i].imag();
  }
}

std::vector<Plane> grow_by_gaussian(const Threshold& t, std::vector<Plane> planes, const Grid& grid) {
  std::vector<Plane> gain;
  for (size_t i = 0; i < planes.size(); ++i) gain.push_back(gaussian_of(diffusion(t, static_cast<int>(i)), grid));
  for (uint32_t step = 0; step < t.steps; ++step) {
    impulse(t, planes, step);
    for (size_t i = 0; i < planes.size(); i += 2) convolve(planes[i], planes[i + 1], gain[i], gain[i + 1], grid);
  }
  return planes;
}

// C' = C + dt (A : H C - C + k R), H by eq. (7): corners +a12 at upper left and lower right, y downwards.
static void euler_step(Plane& plane, const Plane& source, const Matrix& a, const Grid& grid, double dt) {
  const size_t width = static_cast<size_t>(grid.width), height = static_cast<size_t>(grid.height), wide = width + 2;
  Plane old(wide * height);  // with a halo of one cell to the left and right
  for (size_t y = 0; y < height; ++y) {
    std::copy_n(plane.data() + y * width, width, old.data() + y * wide + 1);
    old[y * wide] = plane[y * width + width - 1];
    old[y * wide + width + 1] = plane[y * width];
  }
  for (size_t y = 0; y < height; ++y) {
    const double* up = old.data() + (y + height - 1) % height * wide + 1;
    const double* here = old.data() + y * wide + 1;
    const double* down = old.data() + (y + 1) % height * wide + 1;
    const double* from = source.data() + y * width;
    double* out = plane.data() + y * width;
    for (ptrdiff_t x = 0; x < grid.width; ++x) {
      const double corners = up[x - 1] + down[x + 1] - up[x + 1] - down[x - 1];
      const double spread = a.xx * (here[x - 1] + here[x + 1] - 2 * here[x]) + a.yy * (up[x] + down[x] - 2 * here[x]);
      out[x] = here[x] + dt * (spread + a.xy / 2 * corners - here[x] + from[x]);
    }
  }
}

std::vector<Plane> grow_by_euler(const Threshold& t, std::vector<Plane> planes, const Grid& grid, int sub_steps) {
  for (uint32_t step = 0; step < t.steps; ++step)
    for (int sub = 0; sub < sub_steps; ++sub) {
      Plane source = shading(t, planes);
      const double rho = scheduled(t.rho, step, t.steps), k = scheduled(t.k, step, t.steps);
      for (double& v : source) v = v > rho ? k : 0;
      for (size_t i = 0; i < planes.size(); ++i)
        euler_step(planes[i], source, diffusion(t, static_cast<int>(i)), grid, 0.5 / sub_steps);
    }
  return planes;
}

// On one grid: what coarse grids leave is another texture.
std::vector<Named> presets_of(const dapple::Model* model) {
  std::vector<Named> all;
  for (uint16_t i = 0; i < dapple::preset_count(); ++i) {
    char name[dapple::kMaxName];
    const dapple::Recipe recipe = dapple::load(*dapple::preset_at(i, name).preset);
    if (recipe.stage[0].model == model && recipe.stages == 1) all.push_back({name, recipe});
  }
  return all;
}

Plane library_field(const dapple::Recipe& recipe, const Grid& grid, uint32_t seed) {
  tests::Grown tile(recipe, dapple::torus(static_cast<uint16_t>(grid.width), static_cast<uint16_t>(grid.height)), seed);
  Plane field;
  for (const int16_t v : tile.field()) field.push_back(static_cast<double>(v));
  return field;  // empty where begin refuses
}

}  // namespace reference
