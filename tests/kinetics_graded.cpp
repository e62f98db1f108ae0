// Explicit kinetics whose wavelength differs from place to place, by itself, along a map and with growth from a picture.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "kinetics.hpp"

namespace along = dapple::along;
using tests::field_of;
using tests::Grown;
using tests::recipe_of;
using tests::refusal;

namespace {

// White where x < width / 2, black elsewhere; one byte a cell.
std::vector<uint8_t> halves(int width, int height) {
  std::vector<uint8_t> cells;
  for (int i = 0; i < width * height; ++i) cells.push_back(i % width < width / 2 ? 255 : 0);
  return cells;
}

std::vector<int16_t> field_with(const std::string& text, const dapple::PlaceMaps& maps, dapple::Domain domain) {
  dapple::Recipe recipe = recipe_of(text.c_str());
  dapple::set_maps(recipe, maps);
  Grown grown(recipe, domain, 5);
  REQUIRE_MESSAGE(grown.status == dapple::ok, text);
  return grown.field();
}

// Spots whose highest cell is at a place that counts.
template <class Counts>
int spots_in(const std::vector<int16_t>& f, int side, Counts counts) {
  int spots = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const auto at = [&](int i, int j) {
        return f[static_cast<size_t>((j + side) % side * side + (i + side) % side)];
      };
      bool top = counts(x, y) && at(x, y) > 5 * 1024;
      for (int k = 0; k < 9 && top; ++k)
        if (k != 4) top = k < 4 ? at(x, y) > at(x + k % 3 - 1, y + k / 3 - 1) : at(x, y) >= at(x + k % 3 - 1, y + k / 3 - 1);
      spots += top;
    }
  return spots;
}

int differing(const std::vector<int16_t>& a, const std::vector<int16_t>& b) {
  int differ = 0;
  for (size_t i = 0; i < a.size(); ++i) differ += a[i] != b[i];
  return differ;
}

}  // namespace

// As many spots to an area as one wavelength there would make.
TEST_CASE("a grade: spots are as close as it says") {
  constexpr int kSide = 288, kBand = 24;
  const std::string text = "turing decay=12.25 scale=16 steps=6000";
  const std::vector<int16_t> even = field_of(text, dapple::torus(kSide, kSide));
  const double density = spots_in(even, kSide, [](int, int) { return true; }) / double(kSide * kSide);
  struct Case {
    const char* grade;
    double (*part)(double u, double v);
  };
  const Case cases[] = {{"across", [](double u, double) { return 0.5 + 0.5 * std::cos(2 * M_PI * u); }},
                        {"down", [](double, double v) { return 0.5 + 0.5 * std::cos(2 * M_PI * v); }},
                        {"centre", [](double u, double v) {
                           return 0.5 + 0.25 * (std::cos(2 * M_PI * u) + std::cos(2 * M_PI * v));
                         }}};
  for (const Case& c : cases) {
    const std::vector<int16_t> f = field_of(text + " finest=0.4 grade=" + c.grade, dapple::torus(kSide, kSide));
    for (int band = 0; band < 3; ++band) {  // places of long, of middling and of short waves
      const auto here = [&](int x, int y) {
        const double part = c.part((x + 0.5) / kSide, (y + 0.5) / kSide);
        return part >= band / 3.0 && part < (band + 1) / 3.0;
      };
      double wanted = 0;
      for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
          if (here(x, y)) wanted += density / std::pow(0.4 + 0.6 * c.part((x + 0.5) / kSide, (y + 0.5) / kSide), 2);
      const int found = spots_in(f, kSide, here);
      INFO(c.grade << ", third " << band << ": " << found << " spots, " << wanted << " wanted");
      REQUIRE(wanted > kBand);
      CHECK(std::fabs(found / wanted - 1) < 0.12);
    }
  }
}

TEST_CASE("a grade from a picture: the recipe's wavelength where it is white, the shortest where it is black") {
  constexpr int kSide = 256;
  const std::vector<uint8_t> cells = halves(32, 3);
  dapple::PlaceMaps maps{};
  maps.lengths = {cells.data(), 32, 3};
  const std::string text = "turing decay=12.25 scale=14 finest=0.5 grade=image steps=5000";
  const std::vector<int16_t> f = field_with(text, maps, dapple::torus(kSide, kSide));
  const int white = spots_in(f, kSide, [](int x, int) { return x > 20 && x < 108; }),
            black = spots_in(f, kSide, [](int x, int) { return x > 148 && x < 236; });
  INFO(white << " spots where it is white, " << black << " where it is black");
  CHECK(white > 30);
  CHECK(std::fabs(black / (4.0 * white) - 1) < 0.12);
}

TEST_CASE("a grade of one wavelength changes no bit") {
  const dapple::Domain domain = dapple::torus(60, 44);
  for (const char* text :
       {"turing scale=9 vary=0.1 steps=30", "meinhardt-spots scale=3 steps=30", "meinhardt-stripes steps=30",
        "fitzhugh-nagumo steps=30", "schnakenberg steps=30", "brusselator steps=30", "turing cells=compact steps=30",
        "turing map=swirl aspect=2 scale=9 steps=30", "turing stretch=2 angle=30 scale=9 steps=30"}) {
    INFO(text);
    CHECK(field_of(std::string(text) + " grade=centre finest=1", domain) == field_of(text, domain));
    CHECK(field_of(std::string(text) + " grade=centre finest=0.7", domain) != field_of(text, domain));
  }
}

TEST_CASE("a grade: what has grown has no seam, and windows agree") {
  for (const std::string grade : {"across", "down", "centre"}) {
    INFO(grade);
    const std::string turing = "turing scale=7 decay=12.25 stretch=1.5 steps=30 grade=" + grade;
    int differ = 0;
    for (const std::string& text : {turing, "fitzhugh-nagumo steps=30 grade=" + grade}) {
      const std::vector<int16_t> a = field_of(text, dapple::torus(64, 48)),
                                 b = field_of(text, dapple::torus(64, 48, 17, 9));
      for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x)
          differ += a[static_cast<size_t>((y + 9) % 48 * 64 + (x + 17) % 64)] != b[static_cast<size_t>(y * 64 + x)];
    }
    CHECK(differ == 0);
    const std::string more = turing + " map=bends vary=0.1 then freeze above=4 steps=5";
    const std::vector<int16_t> c = field_of(more, dapple::window(-30, -25, 60, 50)),
                               d = field_of(more, dapple::window(-10, -9, 60, 50));
    for (int y = 0; y < 34; ++y)
      for (int x = 0; x < 40; ++x)
        differ += c[static_cast<size_t>((y + 16) * 60 + x + 20)] != d[static_cast<size_t>(y * 60 + x)];
    CHECK(differ == 0);
  }
}

TEST_CASE("a grade: the same bits however the run is sliced and in however many bands") {
  tests::check_slices("grade=across finest=0.8", "grade=across finest=0.9", "map=radial grade=down finest=0.8", "map=none");
}

TEST_CASE("a grade: held cells never change") {
  const std::string grown = "turing scale=14 decay=12.25 grade=centre map=bends aspect=1.8 steps=2500";
  const dapple::Domain domain = dapple::torus(64, 64);
  const std::vector<int16_t> before = field_of(grown, domain),
                             after = field_of(grown + " then freeze scale=7 grade=down steps=300", domain);
  int held = 0, moved = 0;
  for (size_t i = 0; i < before.size(); ++i) {
    const bool holds = before[i] > 5 * 1024 + 1;
    held += holds;
    moved += !holds && after[i] != before[i];
    if (holds) REQUIRE(after[i] == before[i]);
  }
  CHECK(held > 100);
  CHECK(moved > 1000);
}

TEST_CASE("growth from a picture along a map, and with a grade") {
  const std::vector<uint8_t> black(12, 0), white(12, 255), cells = halves(16, 1);
  const dapple::Domain domain = dapple::torus(64, 48);
  dapple::PlaceMaps maps{};
  maps.lengths = {cells.data(), 16, 1};
  for (const std::string places : {"map=swirl aspect=2", "grade=across", "map=radial grade=image finest=0.6 stretch=1.5"}) {
    INFO(places);
    const std::string plain = "turing growth=15.25 scale=9 vary=0.1 decay=12 steps=40 " + places,
                      pictured = plain + " solver=pictured dark=15.25 lit=20";
    // vary is of the decay without a picture and of the growth with one.
    const std::string even = "turing growth=15.25 scale=9 decay=12 steps=40 " + places;
    maps.grey = {black.data(), 4, 3};
    const std::vector<int16_t> dark = field_with(even + " solver=pictured dark=15.25 lit=20", maps, domain);
    CHECK(dark == field_with(even, maps, domain));
    CHECK(field_with(pictured, maps, domain) != field_with(plain, maps, domain));
    maps.grey = {white.data(), 4, 3};
    // From the same start, as much growth everywhere.
    CHECK(field_with(even + " steps=0 then carry solver=pictured dark=15.25 lit=20 steps=40", maps, domain) ==
          field_with(even + " steps=0 then carry growth=20 steps=40", maps, domain));
    CHECK(differing(field_with(even + " solver=pictured dark=20 lit=15.25", maps, domain), dark) == 0);
  }
}

TEST_CASE("a grade: recipes with one, and what is refused") {
  CHECK(refusal("turing grade=upwards").status == dapple::unknown_word);
  CHECK(refusal("turing grade=across finest=0.2").status == dapple::out_of_range);
  CHECK(refusal("turing grade=across finest=1.1").status == dapple::out_of_range);
  CHECK(refusal("mapped grade=across").status == dapple::unknown_word);
  // The shortest waves want cells enough: three times 1 / sqrt(s).
  const dapple::Trouble coarse = refusal("turing grade=across finest=0.5 scale=5.9");
  CHECK(coarse.status == dapple::unstable);
  CHECK(std::string(coarse.allowed) == "scale");
  CHECK(coarse.low == 6000000);
  CHECK(refusal("turing grade=across finest=0.5 scale=6").status == dapple::ok);
  CHECK(refusal("turing grade=none finest=0.5 scale=5.9").status == dapple::ok);
  char line[dapple::recipe::kMaxText];
  const dapple::Recipe recipe = recipe_of("turing solver=pictured grade=image finest=0.4 map=swirl aspect=2");
  CHECK(recipe.stage[0].solver == &dapple::evolve::pictured_along);
  dapple::write(recipe, line, sizeof line);
  CHECK(recipe_of(line).stage[0].solver == &dapple::evolve::pictured_along);
  CHECK(recipe_of(line).stage[0].number[along::finest] == 400000);
  dapple::Recipe plain = recipe;
  dapple::Trouble trouble{};
  REQUIRE(dapple::parse("map=none grade=none", plain, trouble) == dapple::ok);
  CHECK(plain.stage[0].solver == &dapple::evolve::pictured);
}

TEST_CASE("a grade: begin looks at its picture and counts the memory; what has been laid stays") {
  const dapple::Domain domain = dapple::torus(64, 64);
  CHECK(dapple::need_for(recipe_of("turing grade=centre"), domain).planes == 3 * 4 * 64 * 64);
  CHECK(dapple::need_for(recipe_of("turing grade=centre map=swirl vary=0.1 then freeze"), domain).planes == 6 * 4 * 64 * 64);
  dapple::Recipe recipe = recipe_of("turing grade=image");
  CHECK(dapple::need_for(recipe, domain).status == dapple::bad_map);
  const std::vector<uint8_t> cells = halves(4, 4);
  dapple::PlaceMaps maps{};
  dapple::set_maps(recipe, maps);
  CHECK(dapple::need_for(recipe, domain).status == dapple::bad_map);
  maps.lengths = {cells.data(), 4, 4};
  CHECK(dapple::need_for(recipe, domain).status == dapple::ok);
  maps.lengths.height = 257;
  CHECK(dapple::need_for(recipe, domain).status == dapple::bad_map);
  for (const auto& [slot, value] : {std::pair{along::grade, 5}, {along::grade, -1}, {along::finest, 249999}}) {
    dapple::Recipe wrong = recipe_of("turing grade=centre");
    wrong.stage[0].number[slot] = value;
    CHECK(dapple::need_for(wrong, domain).status == dapple::bad_recipe);
  }
  Grown grown(recipe_of("turing grade=centre map=swirl aspect=2 vary=0.1 steps=5"), domain, 5);
  dapple::Texture& texture = grown.texture;
  CHECK(texture.change(along::finest, 600000) == dapple::not_now);
  CHECK(texture.change(along::grade, along::down) == dapple::not_now);
  CHECK(texture.change(along::detail, 300000) == dapple::not_now);
  CHECK(texture.change(dapple::kinetics::angle, 1000000) == dapple::not_now);
  CHECK(texture.change(dapple::kinetics::vary, 200000) == dapple::not_now);
  CHECK(texture.change(along::finest, 100000) == dapple::out_of_range);
  CHECK(texture.change(dapple::turing::decay, 12200000) == dapple::ok);
  dapple::Texture plain;  // before its first step, too: a map or a grade would take another solver
  const dapple::Recipe even = recipe_of("turing steps=5");
  std::vector<uint8_t> memory(dapple::bytes_for(even, domain));
  REQUIRE(plain.begin(even, domain, 5, memory.data(), memory.size()) == dapple::ok);
  REQUIRE(plain.step(2 * 64) == dapple::more);
  CHECK(plain.change(along::grade, along::down) == dapple::not_now);
  CHECK(plain.change(along::map, dapple::mapped::swirl) == dapple::not_now);
  CHECK(plain.change(dapple::turing::decay, 12200000) == dapple::ok);
}
