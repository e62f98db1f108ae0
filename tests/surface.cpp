// Surfaces: what a metric does to widths on them, what one that changes nothing does to the bytes, and what is refused.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "grow.hpp"

using dapple::Metric;
using dapple::Surface;
using tests::Grown;

namespace {

Surface measured(Surface surface, uint32_t rows = 5) {
  dapple::Status status = dapple::more;
  while (status == dapple::more) status = measure(surface, rows);
  CHECK(status == dapple::done);
  return surface;
}

std::vector<int16_t> grown_on(const char* text, const Surface& surface, dapple::Domain domain, uint32_t seed,
                              uint32_t budget = UINT32_MAX, uint8_t bands = 1) {
  dapple::Recipe recipe = tests::recipe_of((std::string(text) + " solver=surface").c_str());
  dapple::PlaceMaps maps{};
  maps.surface = &surface;
  set_maps(recipe, maps);
  dapple::Options options;
  options.bands = bands;
  Grown tile(recipe, domain, seed, budget, options);
  REQUIRE(tile.status == dapple::ok);
  CHECK(tile.texture.rows_done() == tile.texture.rows_in_all());
  return tile.field();
}

// 2 pi sqrt(mean D^2 / mean |grad D|^2), the gradient's length on the surface, of rows first .. last of a torus.
struct Sums {
  double square = 0, slope = 0;
  double width() const { return 2 * std::acos(-1.0) * std::sqrt(square / slope); }
};
void add_rows(const std::vector<int16_t>& field, const Surface& s, int first, int last, Sums& sums) {
  for (int y = first; y < last; ++y)
    for (int x = 0; x < s.width; ++x) {
      const auto at = [&](int i, int j) {
        return field[static_cast<size_t>((j + s.height) % s.height * s.width + (i + s.width) % s.width)] / 8000.0;
      };
      const Metric m = metric_at(s, 0, x, y);
      const double xx = m.xx / 65536.0, xy = m.xy / 65536.0, yy = m.yy / 65536.0;
      const double u = (at(x + 1, y) - at(x - 1, y)) / 2, v = (at(x, y + 1) - at(x, y - 1)) / 2;
      sums.square += at(x, y) * at(x, y);
      sums.slope += (yy * u * u - 2 * xy * u * v + xx * v * v) / (xx * yy - xy * xy);
    }
}

// Standard deviation over mean of the widths in eight bands around a torus.
double variation(const char* text, const Surface& torus, bool corrected, double* mean = nullptr) {
  Sums band[8];
  for (uint32_t seed = 1; seed <= 4; ++seed) {
    const dapple::Domain domain = dapple::torus(torus.width, torus.height);
    const std::vector<int16_t> field = corrected ? grown_on(text, torus, domain, seed)
                                                 : Grown(tests::recipe_of(text), domain, seed).field();
    for (int i = 0; i < 8; ++i) add_rows(field, torus, i * torus.height / 8, (i + 1) * torus.height / 8, band[i]);
  }
  double sum = 0, squares = 0;
  for (const Sums& b : band) {
    sum += b.width() / 8;
    squares += b.width() * b.width() / 8;
  }
  if (mean != nullptr) *mean = sum;
  return std::sqrt(squares - sum * sum) / sum;
}

}  // namespace

TEST_CASE("surface: on a torus widths vary little, without correction much") {
  const Surface torus = measured(dapple::torus_surface(224, 112, 500000));
  struct Case {
    const char* text;
    double most, least;
  };
  for (const Case& c : {Case{"mapped map=isotropic scale=1.6 steps=30", 0.04, 0.12},
                        Case{"mapped map=none stretch=2 scale=1.6 angle=70 steps=30", 0.08, 0.2}}) {
    double width = 0;
    const double without = variation(c.text, torus, false), with = variation(c.text, torus, true, &width);
    INFO(c.text << ": width " << width << " varies by " << with << ", uncorrected by " << without);
    CHECK(with <= c.most);
    CHECK(without >= c.least);
  }
}

TEST_CASE("surface: a metric that changes nothing changes no byte") {
  const dapple::Domain domain = dapple::torus(52, 44, 8, -12), large = dapple::torus(80, 72);
  const std::vector<Metric> twice(80 * 72, Metric{4 * 65536, 0, 4 * 65536});
  const Surface flat = measured(dapple::surface_of(Surface::flat, 52, 44)),
                wide = measured(dapple::tensor_surface(80, 72, twice.data()));
  for (const char* map : {"none", "isotropic", "radial", "scallop", "haunch", "two-angle", "swirl", "bends"})
    for (const char* numbers : {"scale=2.2 stretch=2 steps=4", "scale=1.5 stretch=3 pairs=2 rho=0.02 angles=10,-31 steps=3",
                                "scale=1.3 stretch=1 ratio=1.4 steps=5 levels=2 fine=2"}) {
      const std::string text = std::string("mapped map=") + map + " " + numbers;
      INFO(text);
      const std::vector<int16_t> plain = Grown(tests::recipe_of(text.c_str()), domain, 11).field();
      CHECK(grown_on(text.c_str(), flat, domain, 11) == plain);
      CHECK(grown_on(text.c_str(), flat, domain, 11, 3, 4) == plain);
    }
  // Cells twice as large: a pattern half as large.
  for (const char* map : {"none", "isotropic", "haunch"}) {
    const std::string text = std::string("mapped stretch=2 angle=20 map=") + map;
    CHECK(grown_on((text + " scale=4").c_str(), wide, large, 11) ==
          Grown(tests::recipe_of((text + " scale=2").c_str()), large, 11).field());
  }
}
