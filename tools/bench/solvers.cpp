// Work and time of each solver against resolution, 64 to 1024, for one picture: the wavelength is the same share of the
// side. Witkin & Kass 1991, section 5: r^4 for Euler, r^2 for the others. Work is exact; times are of one core.
// SPDX-License-Identifier: MIT
#include "solvers.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include "dapple.hpp"
#include "recipe/list.hpp"

namespace {

constexpr int kSides[] = {64, 128, 256, 512, 1024};
constexpr double kWaves = 1024 / 60.0;  // in a side

struct Solver {
  const char* name;
  const char* recipe;  // a preset and changes to it
  const char* changes;
};
const Solver kSolvers[] = {{"euler", "zebra", "solver=euler"},
                           {"gaussian", "zebra", "solver=gaussian"},
                           {"multigrid", "zebra", "solver=multigrid"},
                           {"binary", "zebra-bits", "level=0"},
                           {"binary", "zebra-bits", "level=1"},
                           {"binary", "zebra-bits", "level=2"}};

struct Point {
  int side;
  uint64_t updates;
  double seconds;
};

double grow(const dapple::Recipe& recipe, dapple::Domain domain, std::vector<uint8_t>& memory) {
  const auto start = std::chrono::steady_clock::now();
  dapple::Texture tile;
  if (tile.begin(recipe, domain, 1337, memory.data(), memory.size()) != dapple::ok) return 0;
  tile.finish();
  std::vector<int16_t> row(domain.width);
  for (uint16_t y = 0; y < domain.height; ++y) tile.row(y, row.data());
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// The exponent of y ~ r^e through all points from `least` on, least squares of logarithms.
template <class F> double exponent(const std::vector<Point>& points, int least, F value) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (const Point& p : points) {
    if (p.side < least) continue;
    const double x = std::log2(p.side), y = std::log2(value(p));
    n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

void print_exponents(const std::string& name, const std::vector<Point>& points) {
  if (points.size() < 3) return;
  const auto work = [](const Point& p) { return static_cast<double>(p.updates); };
  const auto time = [](const Point& p) { return p.seconds; };
  const int least = points.front().side;
  std::printf("| %s | %d to %d | %.2f | %.2f |", name.c_str(), least, points.back().side, exponent(points, least, work),
              exponent(points, least, time));
  if (points.size() > 3) std::printf(" %.2f | %.2f |\n", exponent(points, 256, work), exponent(points, 256, time));
  else std::printf(" | |\n");
}

bool measure(const Solver& solver, int side, std::vector<Point>& points) {
  dapple::Recipe recipe = dapple::load(*dapple::find_preset(solver.recipe));
  dapple::Trouble trouble{};
  char changes[100];
  std::snprintf(changes, sizeof changes, "wavelength=%.4f %s", side / kWaves, solver.changes);
  const dapple::Domain domain = dapple::torus(static_cast<uint16_t>(side), static_cast<uint16_t>(side));
  if (dapple::parse(changes, recipe, trouble) != dapple::ok) return false;
  std::vector<uint8_t> memory(dapple::bytes_for(recipe, domain));
  if (memory.empty()) return false;
  uint64_t updates = static_cast<uint64_t>(side) * static_cast<uint64_t>(side);  // the field, once
  for (uint8_t i = 0; i < recipe.stages; ++i) updates += dapple::evolve::updates_of(recipe.stage[i], domain.width, domain.height);
  double best = 1e9, all = 0;
  for (int run = 0; run < 9 && (run == 0 || all < 5); ++run) {
    const double once = grow(recipe, domain, memory);
    best = std::min(best, once);
    all += once;
  }
  points.push_back({side, updates, best});
  const int coarsest = recipe.stage[0].level;
  std::printf("| %s | %d | %.2f | %d | %.1f | %.2f | %.2f |\n", solver.name, side, side / kWaves, side >> coarsest,
              static_cast<double>(updates) / 1e6, best * 1e3, best * 1e9 / side / side);
  std::fflush(stdout);
  return true;
}

// A texture that grows by hand, in seconds of the CPU.
struct Growing {
  dapple::Recipe recipe{};
  std::vector<uint8_t> memory;
  dapple::Texture texture;
  double seconds = 0;

  Growing(const char* text, dapple::Domain domain) {
    dapple::Trouble trouble{};
    dapple::parse(text, recipe, trouble);
    memory.resize(dapple::bytes_for(recipe, domain));
    texture.begin(recipe, domain, 1337, memory.data(), memory.size());
  }
  void grow(uint32_t rows) {
    const std::clock_t start = std::clock();
    texture.step(rows);
    seconds += static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  }
  std::vector<bool> on() {
    const dapple::Domain d = texture.domain();
    std::vector<int16_t> row(d.width);
    std::vector<bool> cells;
    for (uint16_t y = 0; y < d.height; ++y) {
      texture.row(y, row.data());
      for (const int16_t value : row) cells.push_back(value > texture.cell_level());
    }
    return cells;
  }
  // Of all cells, those that are on.
  double fill() {
    const std::vector<bool> cells = on();
    return static_cast<double>(std::count(cells.begin(), cells.end(), true)) / static_cast<double>(cells.size());
  }
  // Places of cells that are on, joined side by side, on the torus.
  int spots() {
    const size_t w = texture.domain().width;
    std::vector<bool> cells = on();
    std::vector<size_t> open;
    const auto visit = [&](size_t at) {
      if (cells[at]) open.push_back(at);
      cells[at] = false;
    };
    int count = 0;
    for (size_t first = 0; first < cells.size(); ++first) {
      visit(first);
      count += open.empty() ? 0 : 1;
      while (!open.empty()) {
        const size_t at = open.back(), x = at % w, row = at - x;
        open.pop_back();
        visit(row + (x + 1) % w), visit(row + (x + w - 1) % w);
        visit((at + w) % cells.size()), visit((at + cells.size() - w) % cells.size());
      }
    }
    return count;
  }
};

}  // namespace

// s = .003. A wave is 25 cells long, 6.2 of the coarsest grid, where five points see 4 sin^2(k / 2) for k^2: what grows
// there is 4.6 % shorter. It asks for 6.3 % more, for as many spots as on the finest grid alone, which stops where its
// share is that of the three grids, looked at every 500 steps.
void print_grids() {
  constexpr uint32_t kMost = 24000, kLook = 500, kSide = 1024;
  const dapple::Domain domain = dapple::torus(kSide, kSide);
  Growing grids("turing scale=19.4 decay=12.25 level=2 steps=1000 then refine scale=18.257419 steps=200 then refine "
                "steps=150", domain);
  grids.grow(UINT32_MAX);
  const double wanted = grids.fill();
  const int spots = grids.spots();
  std::printf("| grids | steps | s | cells on | spots |\n|---|---|---|---|---|\n| 3 | 1000, 200, 150 | %.2f | %.4f | %d |\n", grids.seconds,
              wanted, spots);
  std::fflush(stdout);
  Growing direct("turing scale=18.257419 decay=12.25 steps=24000", domain);
  direct.grow(2 * kSide);
  while (direct.texture.steps_done() < kMost && direct.fill() < wanted) direct.grow(kLook * kSide);
  const double fill = direct.fill();
  const int others = direct.spots();
  std::printf("| 1 | %u | %.2f | %.4f | %d |\n%s%.1f times as fast, %+.1f %% of the spots\n", static_cast<unsigned>(direct.texture.steps_done()),
              direct.seconds, fill, others, fill < wanted ? "more than " : "", direct.seconds / grids.seconds,
              100.0 * (spots - others) / std::max(1, others));
}

void print_solvers() {
  std::printf("| solver | side | wavelength | coarsest grid | million cell updates | ms | ns a pixel |\n|---|---|---|---|---|---|---|\n");
  std::vector<std::vector<Point>> all;
  std::vector<std::string> names;
  for (const Solver& solver : kSolvers) {
    if (names.empty() || names.back() != solver.name) {
      names.push_back(solver.name);
      all.emplace_back();
    }
    for (const int side : kSides)
      if (all.back().empty() || side > all.back().back().side)
        if (!measure(solver, side, all.back()) && !all.back().empty()) break;
  }
  std::printf("\n| exponent of the side | sides | work | time | work from 256 | time from 256 |\n|---|---|---|---|---|---|\n");
  for (size_t i = 0; i < all.size(); ++i) print_exponents(names[i], all[i]);
}
