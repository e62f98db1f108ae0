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

// A spot has 2 / root 3 wavelength^2 for itself. spot_size=6.2 of 10.3: pi root(3) / 8 (6.2 / 10.3)^2 = .2464;
// spot_size=4.6 with coverage=.1: 4.6 root(pi root(3) / 8 / .1) = 11.997.
constexpr Request kRequests[] = {
    {"turing wavelength=8.7 coverage=0.25", 128, 8.7, .25, 1, kAny},
    {"turing wavelength=10.3 spot_size=6.2", 128, 10.3, .2464, 1, kAny},
    {"turing coverage=0.17 wavelength=12.4", 256, 12.4, .17, 1, kAny},
    {"turing wavelength=14.8 aspect=1.7 angle=45 coverage=0.3", 256, 14.8, .3, 1.7, 45},
    {"turing wavelength=15.6 aspect=2.2 angle=125 coverage=0.24", 256, 15.6, .24, 2.2, 125},
    {"turing wavelength=16.7 aspect=1.4 angle=-50 coverage=0.33", 256, 16.7, .33, 1.4, -50},
    {"turing wavelength=17.5 aspect=2 angle=10 coverage=0.15", 256, 17.5, .15, 2, 10},
    {"turing wavelength=13.3 coverage=0.4", 256, 13.3, .4, 1, kAny},
    {"meinhardt-spots wavelength=11 coverage=0.1", 128, 11, .1, 1, kAny},
    {"meinhardt-spots spot_size=4.6 coverage=0.1", 256, 11.997, .1, 1, kAny},
    {"meinhardt-spots wavelength=14.5 aspect=1.7 angle=70 coverage=0.11", 256, 14.5, .11, 1.7, 70},
    {"meinhardt-spots wavelength=16 aspect=1.9 angle=15 coverage=0.13", 256, 16, .13, 1.9, 15},
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
