// Explicit kinetics along a map of directions: where spots point, the same bits however grown.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "kinetics.hpp"
#include "stencil/diffuse.hpp"

namespace stencil = dapple::stencil;
using tests::field_of;
using tests::Grown;
using tests::recipe_of;
using tests::refusal;

namespace {

const char* const kMaps[] = {"none", "radial", "scallop", "haunch", "two-angle", "swirl", "bends", "corners"};

// Where the spots of a square point (degrees), by the structure tensor, and how sure that is, 0..1.
struct Lean {
  double degrees, sure;
};
Lean lean_of(const std::vector<int16_t>& f, int side, int left, int top, int size) {
  double xx = 0, xy = 0, yy = 0;
  for (int y = top; y < top + size; ++y)
    for (int x = left; x < left + size; ++x) {
      const auto at = [&](int i, int j) {
        return f[static_cast<size_t>((j + side) % side * side + (i + side) % side)];
      };
      const double gx = at(x + 1, y) - at(x - 1, y), gy = at(x, y + 1) - at(x, y - 1);
      xx += gx * gx, xy += gx * gy, yy += gy * gy;
    }
  return {0.5 * std::atan2(2 * xy, xx - yy) * 180 / M_PI + 90, std::hypot(xx - yy, 2 * xy) / (xx + yy)};
}

}  // namespace

TEST_CASE("along a map: spots point where the map does") {
  constexpr int kSide = 256, kSquare = 32;
  struct Case {
    const char* text;
    double (*angle)(double u, double v);  // degrees
    double beside;                        // angle=
  };
  const auto radial = [](double u, double v) {
    return std::atan2(std::sin(2 * M_PI * (v - 0.5)), std::sin(2 * M_PI * (u - 0.5))) * 180 / M_PI;
  };
  const auto haunch = [](double u, double v) {
    double c = 0, s = 0;
    for (int i = 0; i < 3; ++i) {
      const double weight = std::pow((1 + std::cos(2 * M_PI * (u + 0.1 * std::sin(2 * M_PI * v) - i / 3.0))) / 2, 8);
      c += weight * std::cos(M_PI + 2 * M_PI * i / 3), s += weight * std::sin(M_PI + 2 * M_PI * i / 3);
    }
    return std::atan2(s, c) * 90 / M_PI;
  };
  const Case cases[] = {
      {"turing scale=12 decay=12.25 aspect=2 steps=2600 map=radial detail=0.1", radial, 0},
      {"turing scale=12 decay=12.25 aspect=2 steps=2600 map=radial detail=0.1 angle=90", radial, 90},
      {"turing scale=12 decay=12.25 aspect=2 steps=2600 map=radial detail=0.1 angle=30", radial, 30},
      {"turing scale=12 decay=12.25 aspect=2.4 steps=3000 map=haunch", haunch, 0},
      {"fitzhugh-nagumo stretch=2 steps=1500 map=haunch", haunch, 0},
      {"schnakenberg stretch=2 steps=3000 map=radial detail=0.1", radial, 0},
  };
  for (const Case& c : cases) {
    const std::vector<int16_t> f = field_of(c.text, dapple::torus(kSide, kSide));
    double off = 0, worst = 0;
    int squares = 0;
    for (int y = 0; y < kSide; y += kSquare / 2)
      for (int x = 0; x < kSide; x += kSquare / 2) {
        double cc = 0, ss = 0;  // the map's mean over the square
        for (int j = 0; j < kSquare; j += 4)
          for (int i = 0; i < kSquare; i += 4) {
            const double angle = c.angle((x + i + 2.0) / kSide, (y + j + 2.0) / kSide) * M_PI / 90;
            cc += std::cos(angle) / 64, ss += std::sin(angle) / 64;
          }
        if (std::hypot(cc, ss) < 0.85) continue;  // it turns too much to be one direction
        const Lean lean = lean_of(f, kSide, x, y, kSquare);
        const double d = std::fabs(std::remainder(lean.degrees - c.beside - std::atan2(ss, cc) * 90 / M_PI, 180));
        off += d, ++squares;
        worst = std::max(worst, d);
      }
    INFO(c.text << ": " << off / squares << " degrees off on average in " << squares << " squares, " << worst
                << " at most");
    REQUIRE(squares > 60);
    CHECK(off / squares < 6);
    CHECK(worst < 25);
  }
}

TEST_CASE("along a map: what has grown has no seam") {
  for (const char* map : kMaps) {
    const std::string text = std::string("turing scale=6 decay=12.25 aspect=2 steps=60 map=") + map;
    const dapple::Domain here = dapple::torus(64, 48), rolled = dapple::torus(64, 48, 17, 9);
    const std::vector<int16_t> a = field_of(text, here), b = field_of(text, rolled);
    int differ = 0;
    for (int y = 0; y < 48; ++y)
      for (int x = 0; x < 64; ++x)
        differ += a[static_cast<size_t>((y + 9) % 48 * 64 + (x + 17) % 64)] != b[static_cast<size_t>(y * 64 + x)];
    INFO(map);
    CHECK(differ == 0);
  }
}

TEST_CASE("along a map: the same bits however the run is sliced and in however many bands") {
  tests::check_slices("map=swirl", "map=bends", "map=radial", "");
}

TEST_CASE("along a map: two windows of the plane agree") {
  for (const char* map : kMaps) {
    const std::string text =
        std::string("turing vary=0.1 scale=6 aspect=2 map=") + map + " steps=6 then freeze above=4 steps=5";
    const std::vector<int16_t> a = field_of(text, dapple::window(-30, -25, 60, 50)),
                               b = field_of(text, dapple::window(-10, -9, 60, 50));
    int differ = 0;
    for (int y = 0; y < 34; ++y)
      for (int x = 0; x < 40; ++x)
        differ += a[static_cast<size_t>((y + 16) * 60 + x + 20)] != b[static_cast<size_t>(y * 60 + x)];
    INFO(map);
    CHECK(differ == 0);
  }
}

TEST_CASE("along a map: segments of the start lie along it, those of a recipe without one as they lean") {
  constexpr int kSide = 256, kSquare = 64;
  const std::string segments = "meinhardt-stripes start=segments pitch=14 length=26 radius=1 amplitude=1 steps=0 ";
  for (const int lean : {0, 30, 90}) {
    const std::string leaning = segments + "fan=0 lean=" + std::to_string(lean);
    const std::vector<int16_t> f = field_of(leaning + " map=radial detail=0.05", dapple::torus(kSide, kSide));
    double worst = 0;
    for (int y = 0; y < kSide; y += kSquare)
      for (int x = 0; x < kSide; x += kSquare) {
        const double u = (x + kSquare / 2.0) / kSide - 0.5, v = (y + kSquare / 2.0) / kSide - 0.5;
        const double map = std::atan2(std::sin(2 * M_PI * v), std::sin(2 * M_PI * u)) * 180 / M_PI;
        worst = std::max(worst, std::fabs(std::remainder(lean_of(f, kSide, x, y, kSquare).degrees - map - lean, 180)));
      }
    INFO(lean << ": " << worst << " degrees off at most");
    CHECK(worst < 12);
    const std::vector<int16_t> plain = field_of(leaning, dapple::torus(kSide, kSide));
    CHECK(plain != f);
    // A map of one direction, x, turns nothing.
    int differ = 0;
    const std::vector<int16_t> round = field_of(leaning + " map=isotropic", dapple::torus(kSide, kSide));
    for (size_t i = 0; i < plain.size(); ++i) differ += plain[i] != round[i];
    CHECK(differ < 400);
  }
  const dapple::Recipe back = [&] {
    dapple::Recipe recipe = recipe_of((segments + "map=swirl").c_str());
    dapple::Trouble trouble{};
    CHECK((recipe.start.row == dapple::evolve::segments_along_row));
    REQUIRE(dapple::parse("map=none", recipe, trouble) == dapple::ok);
    return recipe;
  }();
  CHECK((back.start.row == dapple::start::segments_row));
  // Windows of the plane agree.
  const std::string text = segments + "map=bends detail=0.2 scale=1.4 level=1 then refine steps=3";
  const std::vector<int16_t> a = field_of(text, dapple::window(-30, -26, 60, 50)),
                             b = field_of(text, dapple::window(-10, -10, 60, 50));
  int differ = 0;
  for (int y = 0; y < 34; ++y)
    for (int x = 0; x < 40; ++x)
      differ += a[static_cast<size_t>((y + 16) * 60 + x + 20)] != b[static_cast<size_t>(y * 60 + x)];
  CHECK(differ == 0);
}

TEST_CASE("along a map: held cells never change") {
  const std::string grown = "turing scale=11.3 decay=12.25 map=bends aspect=1.8 steps=1200";
  const dapple::Domain domain = dapple::torus(64, 64);
  const std::vector<int16_t> before = field_of(grown, domain),
                             after = field_of(grown + " then freeze scale=5.6 map=radial steps=300", domain);
  int held = 0, moved = 0;
  for (size_t i = 0; i < before.size(); ++i) {
    if (before[i] > 5 * 1024 + 1) {
      ++held;
      REQUIRE(after[i] == before[i]);
    } else {
      moved += after[i] != before[i];
    }
  }
  CHECK(held > 100);
  CHECK(moved > 1000);
}

// At the largest dt, directions as wild as a picture can be.
TEST_CASE("along a map: what the bound lets through does not diverge, and no more is let through") {
  std::mt19937 random(4);
  std::vector<int8_t> pairs;
  constexpr uint16_t kSide = 96;
  for (int i = 0; i < kSide * kSide; ++i) {
    const stencil::Doubled d = stencil::doubled_of(static_cast<uint16_t>(random()));
    pairs.push_back(d.c2), pairs.push_back(d.s2);
  }
  dapple::PlaceMaps maps{};
  maps.direction = {pairs.data(), kSide, kSide};
  for (const std::string family : {"turing decay=12.25", "fitzhugh-nagumo", "schnakenberg"}) {
    const std::string text = family + " map=image stretch=2.414 steps=2000";
    dapple::Recipe recipe = recipe_of(text.c_str());
    const dapple::Bound bound = recipe.stage[0].model->bound(recipe.stage[0].number, 0);
    const dapple::Trouble t = refusal((text + " dt=" + std::to_string(bound.high / 1e6 + 1e-6)).c_str());
    CHECK(t.status == dapple::unstable);
    CHECK(t.high == bound.high);
    recipe.stage[0].number[dapple::kinetics::dt] = bound.high;
    dapple::set_maps(recipe, maps);
    Grown grown(recipe, dapple::torus(kSide, kSide), 5);
    REQUIRE(grown.status == dapple::ok);
    const std::vector<int16_t> f = grown.field();
    double rough = 0, spread = 0, mean = 0;
    for (const int16_t v : f) mean += v / double(f.size());
    for (size_t i = 0; i < f.size(); ++i) {
      const size_t row = i / kSide * kSide;
      const double bump = f[i] - 0.5 * (f[row + (i + 1) % kSide] + f[row + (i + kSide - 1) % kSide]);
      spread += (f[i] - mean) * (f[i] - mean);
      rough += bump * bump;
    }
    INFO(family);
    CHECK(rough < 0.5 * spread + double(f.size()));
    CHECK(spread > 400.0 * double(f.size()));
    recipe.stage[0].number[dapple::kinetics::dt] = bound.high + 1;
    CHECK(dapple::need_for(recipe, dapple::torus(kSide, kSide)).status == dapple::unstable);
  }
}

TEST_CASE("along a map: recipes with one, and what is refused") {
  CHECK(refusal("turing map=swril").status == dapple::unknown_word);
  CHECK(refusal("turing map=swirl detail=0").status == dapple::out_of_range);
  CHECK(refusal("turing map=swirl detail=1.1").status == dapple::out_of_range);
  CHECK(refusal("gray-scott map=swirl").status == dapple::unknown_word);
  // A line says the same again; taking the map away gives the plain solver back.
  const char* const text = "turing map=swirl detail=0.4 aspect=2 steps=30 then freeze map=none steps=9";
  char line[dapple::recipe::kMaxText];
  const dapple::Recipe recipe = recipe_of(text);
  dapple::write(recipe, line, sizeof line);
  const dapple::Domain domain = dapple::torus(40, 40);
  CHECK(tests::field_hash_of(recipe_of(line), domain, 5) == tests::field_hash_of(recipe, domain, 5));
  CHECK(recipe.stage[0].solver == &dapple::evolve::along_solver);
  CHECK(recipe.stage[1].solver == &dapple::evolve::cascade_solver);
  dapple::Recipe plain = recipe_of("turing map=swirl aspect=2 steps=30");
  dapple::Trouble trouble{};
  REQUIRE(dapple::parse("map=none", plain, trouble) == dapple::ok);
  CHECK(tests::field_hash_of(plain, domain, 5) ==
        tests::field_hash_of(recipe_of("turing aspect=2 steps=30"), domain, 5));
}

TEST_CASE("along a map: begin looks at the map and counts the memory") {
  const dapple::Domain domain = dapple::torus(64, 64);
  dapple::Recipe recipe = recipe_of("turing map=swirl aspect=2 steps=30");
  const dapple::Need need = dapple::need_for(recipe, domain);
  REQUIRE(need.status == dapple::ok);
  CHECK(need.planes == 3 * 4 * 64 * 64);
  CHECK(dapple::need_for(recipe_of("turing cells=compact map=swirl"), domain).planes == 3 * 2 * 64 * 64);
  CHECK(dapple::need_for(recipe_of("turing vary=0.1 map=swirl then freeze"), domain).planes == 5 * 4 * 64 * 64);
  std::vector<uint8_t> memory(need.bytes);
  dapple::Texture texture;
  CHECK(texture.begin(recipe, domain, 1, memory.data(), memory.size() - 1) == dapple::too_little_memory);
  CHECK(texture.begin(recipe, domain, 1, memory.data(), memory.size()) == dapple::ok);
  texture.finish();
  CHECK(texture.rows_done() == texture.rows_in_all());
  CHECK(texture.change(dapple::along::detail, 0) == dapple::out_of_range);
  CHECK(texture.change(dapple::along::map, 10) == dapple::out_of_range);
  for (const auto& [slot, value] :
       {std::pair{dapple::along::map, 10}, {dapple::along::map, -1}, {dapple::along::detail, 9999}}) {
    dapple::Recipe wrong = recipe;
    wrong.stage[0].number[slot] = value;
    CHECK(dapple::need_for(wrong, domain).status == dapple::bad_recipe);
  }
  dapple::Recipe pictured = recipe_of("turing map=image aspect=2");
  CHECK(dapple::need_for(pictured, domain).status == dapple::bad_map);
  const int8_t pairs[] = {127, 0, 0, 127, -127, 0, 0, -127};
  dapple::PlaceMaps maps{};
  maps.direction = {pairs, 2, 2};
  dapple::set_maps(pictured, maps);
  CHECK(dapple::need_for(pictured, domain).status == dapple::ok);
  maps.direction.width = 257;
  CHECK(dapple::need_for(pictured, domain).status == dapple::bad_map);
}
