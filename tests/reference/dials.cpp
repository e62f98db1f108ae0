// What the dials of spots promise, of requests that nothing was tuned with: wavelength within 3 %, area of a spot 6 %,
// aspect 12 %, angle 3 degrees, and the share of cells to the cell.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "reference.hpp"

namespace {

const double kPi = std::acos(-1.0);

struct Request {
  const char* text;
  int side;
  double wavelength, share, aspect, degrees;
};
constexpr double kAny = 0;  // round spots have no angle

// A spot has 2 / root 3 wavelength^2 for itself. spot_size=5.5 of 9.5: pi root(3) / 8 (5.5 / 9.5)^2 = .2280; spot_size=4
// with coverage=.09: 4 root(pi root(3) / 8 / .09) = 10.996.
constexpr Request kRequests[] = {
    {"turing wavelength=8 coverage=0.3", 128, 8, .3, 1, kAny},
    {"turing wavelength=9.5 spot_size=5.5", 128, 9.5, .2280, 1, kAny},
    {"turing coverage=0.13 wavelength=11.2", 256, 11.2, .13, 1, kAny},
    {"turing wavelength=14 aspect=2 angle=30 coverage=0.35", 256, 14, .35, 2, 30},
    {"turing wavelength=15 aspect=1.5 angle=110 coverage=0.2", 256, 15, .2, 1.5, 110},
    {"turing wavelength=16 aspect=2.35 angle=-20 coverage=0.28", 256, 16, .28, 2.35, -20},
    {"turing wavelength=17 aspect=1.8 angle=65 coverage=0.1", 256, 17, .1, 1.8, 65},
    {"turing wavelength=18 coverage=0.42", 256, 18, .42, 1, kAny},
    {"meinhardt-spots wavelength=10 coverage=0.08", 128, 10, .08, 1, kAny},
    {"meinhardt-spots spot_size=4 coverage=0.09", 256, 10.996, .09, 1, kAny},
    {"meinhardt-spots wavelength=14 aspect=1.5 angle=40 coverage=0.12", 256, 14, .12, 1.5, 40},
    {"meinhardt-spots wavelength=15 aspect=2 angle=100 coverage=0.15", 256, 15, .15, 2, 100},
};

// Cells of spots, four neighbours, on the torus.
struct Spots {
  double count = 0, cells = 0, xx = 0, xy = 0, yy = 0;  // second moments, summed over the spots

  void add(const std::vector<std::pair<int, int>>& spot) {
    double mx = 0, my = 0, sxx = 1 / 12.0, sxy = 0, syy = 1 / 12.0;  // a cell is a square
    const double n = static_cast<double>(spot.size());
    for (const auto& [x, y] : spot) mx += x / n, my += y / n;
    for (const auto& [x, y] : spot) {
      sxx += (x - mx) * (x - mx) / n;
      sxy += (x - mx) * (y - my) / n;
      syy += (y - my) * (y - my) / n;
    }
    ++count, cells += n, xx += sxx, xy += sxy, yy += syy;
  }
  double aspect() const {
    const double mean = (xx + yy) / 2, off = std::hypot((xx - yy) / 2, xy);
    return std::sqrt((mean + off) / (mean - off));
  }
  double degrees() const { return std::atan2(2 * xy, xx - yy) * 90 / kPi; }
};

Spots spots_of(const std::vector<int16_t>& field, int side, int16_t level) {
  Spots spots;
  std::vector<bool> seen(field.size());
  const auto place = [&](int x, int y) {
    return static_cast<size_t>((y % side + side) % side * side + (x % side + side) % side);
  };
  for (int first = 0; first < side * side; ++first) {
    std::vector<std::pair<int, int>> spot;
    const auto visit = [&](int x, int y) {
      if (seen[place(x, y)] || field[place(x, y)] <= level) return;
      seen[place(x, y)] = true;
      spot.emplace_back(x, y);
    };
    visit(first % side, first / side);
    for (size_t i = 0; i < spot.size(); ++i) {
      const auto [x, y] = spot[i];
      visit(x + 1, y), visit(x - 1, y), visit(x, y + 1), visit(x, y - 1);
    }
    if (!spot.empty()) spots.add(spot);
  }
  return spots;
}

}  // namespace

TEST_CASE("reference: spots are as they are asked for") {
  for (const Request& r : kRequests) {
    const dapple::Recipe recipe = tests::recipe_of(r.text);
    REQUIRE_MESSAGE(recipe.stages == 1, r.text);
    tests::Grown tile(recipe, dapple::torus(static_cast<uint16_t>(r.side), static_cast<uint16_t>(r.side)), 1);
    REQUIRE(tile.status == dapple::ok);
    const Spots spots = spots_of(tile.field(), r.side, tile.texture.cell_level());
    const double cells = r.side * r.side, cell = cells / spots.count, room = 2 / std::sqrt(3.0);
    const double wavelength = std::sqrt(cell / room) / r.wavelength - 1;
    const double area = spots.cells / spots.count / (r.share * room * r.wavelength * r.wavelength) - 1;
    const double aspect = spots.aspect() / r.aspect - 1, degrees = std::remainder(spots.degrees() - r.degrees, 180);
    std::printf("%-66s %3.0f spots  wavelength %+.1f %%  area %+.1f %%  share %.4f  aspect %.2f %+.1f %%", r.text,
                spots.count, 100 * wavelength, 100 * area, spots.cells / cells, spots.aspect(), 100 * aspect);
    if (r.aspect > 1) std::printf("  %+.1f degrees", degrees);
    std::printf("\n");
    INFO(r.text);
    CHECK(std::fabs(wavelength) <= 0.03);
    CHECK(std::fabs(area) <= 0.06);
    CHECK(std::fabs(spots.cells / cells - r.share) <= 0.0005);
    CHECK(std::fabs(aspect) <= 0.12);
    if (r.aspect > 1) CHECK(std::fabs(degrees) <= 3);
  }
}
