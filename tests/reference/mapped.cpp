// The mapped family in float64: the formulas of docs/numbers.md in exact arithmetic, and constant maps against the
// passes of the threshold family.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "reference.hpp"

using reference::Distance;
using reference::Grid;
using reference::Named;
using reference::Plane;
using reference::Threshold;
using reference::Vector;
namespace mapped = dapple::mapped;

namespace {

constexpr Grid kGrid = {256, 256};
const double kPi = std::acos(-1.0);

Vector doubled(double theta) { return {std::cos(2 * theta), std::sin(2 * theta)}; }
Vector unit(double c, double s) { return {c / std::hypot(c, s), s / std::hypot(c, s)}; }

Vector radial(double u, double v, double detail) {
  const double x = std::sin(2 * kPi * (u - 0.5)), y = std::sin(2 * kPi * (v - 0.5));
  const double length = x * x + y * y + detail * detail / 4;
  return {(x * x - y * y) / length, 2 * x * y / length};
}

// Discs of .6 pitches, rows half a pitch apart and shifted by half a pitch; the lowest that holds the cell.
Vector scallop(double u, double v, double detail) {
  const double pitch = 1 / std::round(1 / detail);
  for (int k = static_cast<int>(std::floor((v + 0.6 * pitch) / (pitch / 2))); k * pitch / 2 > v - 0.61 * pitch; --k)
    for (int i = -2; i * pitch < 1.5; ++i) {
      const double x = u - (i + (k % 2 != 0 ? 0.5 : 0)) * pitch, y = v - k * pitch / 2;
      if (std::hypot(x, y) <= 0.6 * pitch) return unit(y * y - x * x, -2 * x * y);
    }
  return {1, 0};
}

Vector haunch(double u, double v) {
  double c = 0, s = 0;
  for (int i = 0; i < 3; ++i) {
    const double weight = std::pow((1 + std::cos(2 * kPi * (u + 0.1 * std::sin(2 * kPi * v) - i / 3.0))) / 2, 8);
    c += weight * std::cos(kPi + 2 * kPi * i / 3);
    s += weight * std::sin(kPi + 2 * kPi * i / 3);
  }
  return unit(c, s);
}

Vector two_angle(double u, double v, int index) {
  const auto wave = [](double turns) { return std::sin(2 * kPi * turns); };
  return doubled(index == 0 ? kPi * wave(u) * wave(v) + 0.4 * wave(u + v)
                            : kPi / 2 + 0.9 * wave(2 * u - v) + 0.9 * wave(u + 2 * v + 0.25));
}

// Colours of the corners of 4 x 4 tiles, mixed by smoothstep weights.
Vector corners(double u, double v, double detail) {
  const int colours[4][4] = {{0, 0, 0, 1}, {0, 0, 1, 0}, {1, 0, 1, 1}, {0, 1, 1, 1}};
  const auto smooth = [](double t) { return t * t * (3 - 2 * t); };
  const int i = static_cast<int>(4 * u), j = static_cast<int>(4 * v);
  const double x = smooth(4 * u - i), y = smooth(4 * v - j), theta = std::min(detail, 0.9) * kPi / 4;
  Vector sum{0, 0};
  for (int right = 0; right < 2; ++right)
    for (int below = 0; below < 2; ++below) {
      const double weight = (right ? x : 1 - x) * (below ? y : 1 - y);
      const Vector d = doubled(colours[(j + below) % 4][(i + right) % 4] == 1 ? theta : -theta);
      sum.c += weight * d.c;
      sum.s += weight * d.s;
    }
  return unit(sum.c, sum.s);
}

}  // namespace

Vector reference::map_at(int32_t map, double detail, double u, double v, int pair) {
  switch (map) {
    case mapped::radial:
      return radial(u, v, detail);
    case mapped::scallop:
      return scallop(u, v, detail);
    case mapped::haunch:
      return haunch(u, v);
    case mapped::two_angle:
      return two_angle(u, v, pair % 2);
    case mapped::corners:
      return corners(u, v, detail);
    default:
      return {1, 0};
  }
}

namespace {

// The eight ways, and each one's share of A = m I + d [[c, s], [s, -c]]: the vector (c, s) is a sum of the two doubled
// ways beside it, and what the axes get less for that is m - d times the sum of both.
struct Step {
  int x, y;
};
constexpr Step kWays[8] = {{1, 0}, {0, 1}, {1, 1}, {-1, 1}, {2, 1}, {-2, 1}, {1, 2}, {-1, 2}};

// Two neighbouring ways, the second anticlockwise of the first: their doubled angles' sines and cosines.
struct Neighbours {
  int first, second;
  double sin[2], cos[2], det;
};

std::vector<Neighbours> neighbours() {
  const auto angle = [](Step w) { return std::atan2(2.0 * w.x * w.y, static_cast<double>(w.x * w.x - w.y * w.y)); };
  std::vector<Neighbours> all;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j) {
      const double a = angle(kWays[i]), turn = std::remainder(angle(kWays[j]) - a, 2 * kPi);
      if (turn < 0.1 || turn > 1) continue;
      all.push_back({i, j, {std::sin(a), std::sin(a + turn)}, {std::cos(a), std::cos(a + turn)}, std::sin(turn)});
    }
  return all;
}

double share(int way, double m, double d, Vector p) {
  static const std::vector<Neighbours> all = neighbours();
  double gain[8] = {}, sum = 0;
  for (const Neighbours& n : all) {
    const double first = (p.c * n.sin[1] - p.s * n.cos[1]) / n.det, second = (p.s * n.cos[0] - p.c * n.sin[0]) / n.det;
    if (first < 0 || second < 0) continue;
    gain[n.first] = first;
    gain[n.second] = second;
    sum = first + second;
  }
  const double square = kWays[way].x * kWays[way].x + kWays[way].y * kWays[way].y;
  return 2 * d * gain[way] / square + (way < 2 ? m - d * sum : 0);
}

// Strides 1, 1, 2, 3 ... along a way: each takes what is left of a link's share, the mean of its ends, up to s^2 / 2.
void diffuse(Plane& plane, const Plane& shares, Step way) {
  const double most = *std::max_element(shares.begin(), shares.end());
  double before = 0;
  for (int stage = 0; most - before >= std::max(1, stage * stage) / 512.0; ++stage) {
    const int stride = std::max(1, stage);
    Plane next = plane;
    for (int y = 0; y < kGrid.height; ++y)
      for (int x = 0; x < kGrid.width; ++x) {
        const int far_x = (x + stride * way.x + kGrid.width) % kGrid.width, far_y = (y + stride * way.y) % kGrid.height;
        const size_t here = static_cast<size_t>(y * kGrid.width + x),
                     there = static_cast<size_t>(far_y * kGrid.width + far_x);
        const double left = (shares[here] + shares[there]) / 2 - before;
        const double carried = std::clamp(left / (2 * stride * stride), 0.0, 0.25) * (plane[there] - plane[here]);
        next[here] += carried;
        next[there] -= carried;
      }
    plane = next;
    before += stride * stride / 2.0;
  }
}

Plane shares_of(const dapple::Recipe& recipe, const Threshold& t, int plane, int way) {
  const double a2 = plane % 2 == 0 ? t.scale : t.scale * t.ratio, a1 = t.scale * t.stretch;
  Plane all;
  for (int y = 0; y < kGrid.height; ++y)
    for (int x = 0; x < kGrid.width; ++x) {
      const int32_t* const number = recipe.stage[0].number;
      const Vector p = reference::map_at(number[mapped::map], number[mapped::detail] / 1e6, (x + 0.5) / kGrid.width,
                                         (y + 0.5) / kGrid.height, plane / 2);
      const Vector turn = doubled(t.angle[plane / 2]);
      all.push_back(share(way, (a1 * a1 + a2 * a2) / 2, (a1 * a1 - a2 * a2) / 2,
                          {p.c * turn.c - p.s * turn.s, p.c * turn.s + p.s * turn.c}));
    }
  return all;
}

Plane grow(const dapple::Recipe& recipe, uint32_t seed) {
  const Threshold t = reference::threshold_of(recipe);
  std::vector<Plane> planes = start_of(recipe, kGrid, seed);
  std::vector<Plane> shares[8];
  for (int way = 0; way < 8; ++way)
    for (int i = 0; i < 2 * t.pairs; ++i) shares[way].push_back(shares_of(recipe, t, i, way));
  for (uint32_t step = 0; step < t.steps; ++step) {
    impulse(t, planes, step);
    for (int k = 0; k < 8; ++k) {
      const int way = step % 2 == 0 ? k : 7 - k;
      for (size_t i = 0; i < planes.size(); ++i) diffuse(planes[i], shares[way][i], kWays[way]);
    }
  }
  return shading(t, planes);
}

}  // namespace

TEST_CASE("reference: mapped presets in exact arithmetic") {
  int compared = 0;
  for (const Named& preset : reference::presets_of(&dapple::mapped_model)) {
    if (preset.recipe.stages > 1) continue;  // coarse to fine: the same stages
    ++compared;
    const Plane want = grow(preset.recipe, 1);
    const Plane have = library_field(preset.recipe, kGrid, 1);
    REQUIRE(have.size() == want.size());
    const double level = dapple::threshold::cell_level(preset.recipe.stage[0].number);
    const Distance d = distance(have, want, kGrid, level, reference::threshold_of(preset.recipe).rho[1]);
    const reference::Figures f = measure(have, kGrid, level);
    std::printf("mapped   %-13s wavelength %5.2f %+6.2f %%  fill %.3f %+.4f  agreement %.4f\n", preset.name.c_str(),
                f.wavelength, 100 * d.wavelength, f.fill, d.fill, d.agreement);
    INFO(preset.name);
    CHECK(std::fabs(d.wavelength) <= 0.01);
    CHECK(std::fabs(d.fill) <= 0.01);
    CHECK(d.agreement >= 0.93);
  }
  CHECK(compared == 7);
}

TEST_CASE("reference: a constant map grows what the passes of the threshold family grow") {
  for (const char* numbers :
       {"stretch=2 scale=2.2 rho=0 angle=78.540844", "stretch=2.5 scale=1.7 rho=0 angle=13.3",
        "stretch=3 scale=1.9 pairs=2 rho=0.02 angle=0", "stretch=3 scale=1.8 pairs=2 rho=0.02 angle=31",
        "stretch=4 scale=2 rho=0 angle=18", "stretch=1.2 scale=2.2 rho=0 angle=40"}) {
    double wavelength = 0, fill = 0;
    constexpr uint32_t kSeeds = 4;
    for (uint32_t seed = 1; seed <= kSeeds; ++seed) {
      const dapple::Recipe flux = tests::recipe_of((std::string("mapped map=none ") + numbers).c_str());
      const dapple::Recipe passes = tests::recipe_of((std::string("threshold ") + numbers).c_str());
      const double level = dapple::threshold::cell_level(flux.stage[0].number);
      const Distance d =
          distance(library_field(flux, kGrid, seed), library_field(passes, kGrid, seed), kGrid, level, level);
      wavelength += d.wavelength / kSeeds;
      fill += d.fill / kSeeds;
    }
    std::printf("constant %-46s wavelength %+6.2f %%  fill %+.4f\n", numbers, 100 * wavelength, fill);
    INFO(numbers);
    CHECK(std::fabs(wavelength) <= 0.025);
    CHECK(std::fabs(fill) <= 0.02);
  }
}
