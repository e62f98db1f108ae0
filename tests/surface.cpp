// Surfaces: what a metric does to widths on them, what one that changes nothing does to the bytes, and what is refused.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "grow.hpp"

using dapple::Metric;
using dapple::Surface;
using tests::Grown;
using tests::measured;

namespace {

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
    const std::vector<int16_t> field =
        corrected ? grown_on(text, torus, domain, seed) : Grown(tests::recipe_of(text), domain, seed).field();
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
    for (const char* numbers :
         {"scale=2.2 stretch=2 steps=4", "scale=1.5 stretch=3 pairs=2 rho=0.02 angles=10,-31 steps=3",
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

namespace {

// Where measuring stops, "" if it goes through.
std::string refused_at(Surface surface) {
  dapple::Status status = dapple::more;
  while (status == dapple::more) status = measure(surface, 3);
  if (status == dapple::done) return "";
  CHECK(status == dapple::bad_surface);
  return std::to_string(surface.patch) + " " + std::to_string(surface.x) + "," + std::to_string(surface.y);
}

}  // namespace

TEST_CASE("surface: measuring names the first cell whose tensor is singular, negative or out of range") {
  std::vector<Metric> cells(2 * 12 * 9, Metric{70000, -20000, 60000});
  const auto at = [&](const Metric& m, size_t patch, size_t x, size_t y) {
    std::vector<Metric> all = cells;
    all[patch * 108 + y * 12 + x] = m;
    if (y < 8) all[patch * 108 + 107] = {0, 0, 0};  // a later one is not the first
    return refused_at(dapple::tensor_surface(12, 9, all.data(), 2));
  };
  CHECK(refused_at(dapple::tensor_surface(12, 9, cells.data(), 2)) == "");
  CHECK(at({65536, 65536, 65536}, 0, 3, 2) == "0 3,2");    // singular
  CHECK(at({65536, 70000, 65536}, 1, 11, 0) == "1 11,0");  // indefinite
  CHECK(at({-65536, 0, -65536}, 1, 0, 8) == "1 0,8");
  CHECK(at({65536, 0, 0}, 0, 0, 0) == "0 0,0");
  CHECK(at({65536, 0, dapple::kMostMetric}, 0, 5, 5) == "0 5,5");
  CHECK(refused_at(dapple::tensor_surface(7, 9, cells.data())) == "0 0,0");
  CHECK(refused_at(dapple::tensor_surface(12, 9, nullptr)) == "0 0,0");
  CHECK(refused_at(dapple::height_surface(12, 9, nullptr)) == "0 0,0");
  CHECK(refused_at(dapple::torus_surface(64, 32, 990000)) == "0 0,0");
  CHECK(refused_at(dapple::vase_surface(64, 32, 400000, 0)) == "0 0,0");
  CHECK(refused_at(dapple::surface_of(Surface::sphere, 64, 32, 6)) == "0 0,0");
}

TEST_CASE(
    "surface: begin refuses one that is missing, not measured, of another size, too fine, or for too many pairs") {
  const auto status = [](const char* text, const Surface* surface, const dapple::Domain& domain) {
    dapple::Recipe recipe = tests::recipe_of((std::string(text) + " solver=surface").c_str());
    dapple::PlaceMaps maps{};
    maps.surface = surface;
    set_maps(recipe, maps);
    return need_for(recipe, domain).status;
  };
  const dapple::Domain domain = dapple::torus(64, 48);
  const Surface good = measured(dapple::torus_surface(64, 48, 400000));
  CHECK(status("mapped", &good, domain) == dapple::ok);
  CHECK(status("mapped pairs=3", &good, domain) == dapple::ok);
  CHECK(dapple::need_for(tests::recipe_of("mapped solver=surface"), domain).status == dapple::bad_surface);
  CHECK(status("mapped", nullptr, domain) == dapple::bad_surface);
  const Surface begun = dapple::torus_surface(64, 48, 400000);
  CHECK(status("mapped", &begun, domain) == dapple::bad_surface);
  CHECK(status("mapped", &good, dapple::torus(64, 56)) == dapple::bad_surface);
  CHECK(status("mapped", &good, dapple::window(0, 0, 64, 48)) == dapple::bad_surface);
  CHECK(status("mapped pairs=4", &good, domain) == dapple::bad_surface);
  CHECK(status("mapped pairs=3 map=two-angle", &good, domain) == dapple::bad_surface);
  CHECK(status("mapped map=image", &good, domain) == dapple::bad_map);
  const std::vector<Metric> fine(64 * 48, Metric{1000, 0, 1000});
  const Surface small = measured(dapple::tensor_surface(64, 48, fine.data()));
  CHECK(status("mapped scale=1 stretch=1", &small, domain) == dapple::ok);
  const std::vector<Metric> tiny(128 * 128, Metric{1000, 0, 1000});
  const Surface steep = measured(dapple::tensor_surface(128, 128, tiny.data()));
  CHECK(status("mapped scale=4 stretch=2", &steep, dapple::torus(128, 128)) == dapple::bad_surface);
}

TEST_CASE("surface: the ready ones have the metrics of their shapes") {
  const double pi = std::acos(-1.0);
  const auto close = [](int32_t have, double want) {
    return std::fabs(have / 65536.0 - want) <= 0.002 * (1 + std::fabs(want));
  };
  const Surface torus = dapple::torus_surface(200, 100, 500000), vase = dapple::vase_surface(120, 90, 400000, 800000),
                sphere = dapple::sphere_surface(40);
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x) {
      const double v = 2 * pi * (y + 0.5), round = 1 + 0.5 * std::cos(v / 100), radius = 1 - 0.4 * std::sin(v / 90);
      const double out = 0.4 * std::cos(v / 90) * 120 / 90, down = 0.8 * 120 / 90;
      const Metric t = metric_at(torus, 0, x, y), u = metric_at(vase, 0, x, y), s = metric_at(sphere, 0, x, y);
      CHECK((close(t.xx, round * round) && t.xy == 0 && close(t.yy, 1)));
      CHECK((close(u.xx, radius * radius) && u.xy == 0 && close(u.yy, out * out + down * down)));
      const double a = std::tan((x - 19.5) * pi / 80), b = std::tan((y - 19.5) * pi / 80);
      const double d = 1 + a * a + b * b, factor = (1 + a * a) * (1 + b * b) / (d * d);
      CHECK((close(s.xx, factor * (1 + a * a)) && close(s.xy, -factor * a * b) && close(s.yy, factor * (1 + b * b))));
    }
  std::vector<int16_t> ramp;
  for (int i = 0; i < 20 * 10; ++i) ramp.push_back(static_cast<int16_t>(i % 20 * 128 + i / 20 * 64));
  const Surface slope = dapple::height_surface(20, 10, ramp.data(), true);
  for (const int x : {0, 7, 19}) {
    const Metric m = metric_at(slope, 0, x, 9);
    CHECK((close(m.xx, 1.25) && close(m.xy, 0.125) && close(m.yy, 1.0625)));
  }
}

TEST_CASE("surface: recipes of the threshold family turn into ones that grow on a surface") {
  dapple::PlaceMaps maps{};
  const Surface flat = measured(dapple::surface_of(Surface::flat, 96, 80));
  maps.surface = &flat;
  dapple::Recipe giraffe = tests::recipe_of("threshold diffusion=isotropic scale=1.5 steps=3"),
                 zebra = tests::preset_with("zebra", "steps=3"), grey = tests::preset_with("gs-maze", "steps=3");
  REQUIRE(set_surface(giraffe, maps));
  REQUIRE(set_surface(zebra, maps));
  CHECK_FALSE(set_surface(grey, maps));
  const dapple::Domain domain = dapple::torus(96, 80);
  CHECK(Grown(giraffe, domain, 1).field() ==
        Grown(tests::recipe_of("mapped map=isotropic scale=1.5 steps=3"), domain, 1).field());
  CHECK(Grown(zebra, domain, 1).field() ==
        Grown(tests::recipe_of("mapped map=none scale=2.2 stretch=2 angle=78.540844 steps=3"), domain, 1).field());
}
