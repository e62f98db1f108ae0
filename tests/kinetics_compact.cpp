// Compact cells of kinetics: half of the memory, the same bytes however grown, all that wide ones can do.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <string>

#include "grow.hpp"

namespace kinetics = dapple::kinetics;
using tests::Grown;
using tests::recipe_of;

namespace {

std::vector<int16_t> field_of(const std::string& text, dapple::Domain domain, uint32_t budget = UINT32_MAX, uint8_t bands = 1) {
  dapple::Options options;
  options.bands = bands;
  Grown grown(recipe_of(text.c_str()), domain, 5, budget, options);
  REQUIRE_MESSAGE(grown.status == dapple::ok, text);
  return grown.field();
}

double mean_of(const std::vector<int16_t>& field, double unit) {
  double sum = 0;
  for (const int16_t v : field) sum += v / unit;
  return sum / double(field.size());
}

}  // namespace

TEST_CASE("compact: four bytes a cell") {
  for (const std::string family : {"turing", "meinhardt-spots"}) {
    const dapple::Domain domain = dapple::torus(160, 96);
    const dapple::Need wide = dapple::need_for(recipe_of(family.c_str()), domain),
                       compact = dapple::need_for(recipe_of((family + " cells=compact").c_str()), domain);
    CHECK(wide.planes == 8u * 160 * 96);
    CHECK(compact.planes == 4u * 160 * 96);
    CHECK(compact.scratch <= wide.scratch);
    CHECK(compact.bytes < wide.bytes);
  }
}

TEST_CASE("compact: a word for all stages, written and read back") {
  for (const char* text : {"turing cells=compact", "turing then freeze cells=compact", "meinhardt-spots cells=compact coverage=0.1"}) {
    const dapple::Recipe recipe = recipe_of(text);
    REQUIRE_MESSAGE(recipe.stages > 0, text);
    for (uint8_t i = 0; i < recipe.stages; ++i) CHECK(recipe.stage[i].model->cell == dapple::grid::Cell::int16);
    std::string line(dapple::write(recipe, nullptr, 0), ' ');
    dapple::write(recipe, line.data(), line.size() + 1);
    CHECK(line.find(" cells=compact ") != std::string::npos);
    const dapple::Recipe again = recipe_of(line.c_str());
    CHECK(again.stages == recipe.stages);
    CHECK(again.stage[again.stages - 1].model == recipe.stage[0].model);
  }
  dapple::Recipe recipe = recipe_of("turing cells=compact");
  dapple::Trouble trouble{};
  REQUIRE(dapple::parse("cells=wide", recipe, trouble) == dapple::ok);
  CHECK(recipe.stage[0].model == &dapple::turing_model);
  CHECK(dapple::parse("cells=narrow", recipe, trouble) == dapple::unknown_word);
  CHECK(recipe_of("schnakenberg cells=compact").stages == 0);
}

TEST_CASE("compact: windows of the plane agree, and a rolled torus is the torus rolled") {
  const std::string text = "turing cells=compact vary=0.1 scale=6 steps=9";
  const std::vector<int16_t> a = field_of(text, dapple::window(-30, -25, 60, 50)), b = field_of(text, dapple::window(-10, -9, 60, 50));
  for (size_t y = 0; y < 34; ++y)
    for (size_t x = 0; x < 40; ++x) REQUIRE(a[(y + 16) * 60 + x + 20] == b[y * 60 + x]);
  dapple::Domain rolled = dapple::torus(40, 32);
  const std::vector<int16_t> still = field_of(text, rolled);
  rolled.x = 13, rolled.y = 7;
  const std::vector<int16_t> moved = field_of(text, rolled);
  for (size_t y = 0; y < 32; ++y)
    for (size_t x = 0; x < 40; ++x) REQUIRE(moved[y * 40 + x] == still[(y + 7) % 32 * 40 + (x + 13) % 40]);
}

// What changes by less than a bit a step still moves: a uniform state that is no longer one, against wide cells.
TEST_CASE("compact: slow changes are not lost") {
  const std::string first = "meinhardt-spots scale=8 start=point radius=0.5 amplitude=0.01 steps=1", more = " then carry drain=0.036 steps=60";
  const dapple::Domain domain = dapple::torus(128, 128);
  const double start = mean_of(field_of(first + " show=b", domain), 1024), wide = mean_of(field_of(first + " show=b" + more, domain), 1024),
               compact = mean_of(field_of(first + " show=b cells=compact" + more, domain), 4096);
  INFO(start << " to " << wide << ", compact " << compact);
  CHECK(std::fabs(wide - start) > 0.0015);
  CHECK(std::fabs(wide - start) < 60 / 8192.0);  // under half a bit of 1/4096 a step
  CHECK(std::fabs(compact - wide) < 0.001);      // what is shown is rounded to 1/1024
}

TEST_CASE("compact: held cells stay, a picture sets the growth") {
  const std::string grown = "turing cells=compact decay=12.25 steps=1500";
  const dapple::Domain domain = dapple::torus(64, 64);
  const std::vector<int16_t> before = field_of(grown, domain), after = field_of(grown + " then freeze scale=5.6 steps=300 above=5", domain);
  int held = 0, moved = 0;
  for (size_t i = 0; i < before.size(); ++i) {
    if (before[i] > 5 * 2048) {
      ++held;
      REQUIRE(after[i] == before[i]);
    } else moved += after[i] != before[i];
  }
  CHECK(held > 100);
  CHECK(moved > 1000);
  const uint8_t halves[2] = {0, 255};
  dapple::PlaceMaps maps{};
  maps.grey = {halves, 2, 1};
  std::vector<int16_t> field[2];
  for (const bool compact : {false, true}) {
    dapple::Recipe recipe = recipe_of(("turing solver=pictured dark=17 lit=15.7 steps=1500 decay=12" + std::string(compact ? " cells=compact" : "")).c_str());
    REQUIRE(recipe.stages == 1);
    recipe.stage[0].stored = &maps;
    Grown picture(recipe, domain, 5);
    REQUIRE(picture.status == dapple::ok);
    field[compact] = picture.field();
  }
  double mean[2][2] = {};  // wide and compact, of the columns that are dark and lit
  for (int compact : {0, 1})
    for (size_t i = 0; i < field[0].size(); ++i) mean[compact][i / 16 % 4 == 1] += i / 16 % 2 == 0 ? 0 : field[compact][i] / (compact + 1) / 1048576.0;
  for (int lit : {0, 1}) CHECK(std::fabs(mean[1][lit] - mean[0][lit]) < 0.1);
  CHECK(std::fabs(mean[0][1] - mean[0][0]) > 0.3);
}
