// Explicit kinetics: rates and quotients, weights of stretched diffusion, bounds, starts, cells that are held.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/reciprocal.hpp"
#include "kinetics.hpp"

namespace kinetics = dapple::kinetics;
using tests::field_of;
using tests::Grown;
using tests::recipe_of;
using tests::refusal;

namespace {

constexpr const char* kFamilies[] = {"turing",          "meinhardt-spots", "meinhardt-stripes",
                                     "fitzhugh-nagumo", "schnakenberg",    "brusselator"};

}  // namespace

TEST_CASE("quotient: a 2^bits / b for the whole range, within one part in 12000 and what is floored") {
  for (uint32_t m = 32768; m < 65536; ++m)
    REQUIRE(std::fabs(dapple::base::inverse(m) * double(m) / 2147483648.0 - 1) < 1 / 12000.0);
  for (uint32_t b = 1 << 10; b < (1u << 23); b += 1 + b / 997)
    for (uint32_t a : {0u, 1u, 77u, 4096u, 32767u}) {
      const double exact = a * 8388608.0 / b, shifts = std::floor(23 - std::log2(b + 0.5));
      const double have = dapple::base::quotient<23>(a, b);
      REQUIRE(std::fabs(have - exact) <= exact / 12000 + std::exp2(shifts));
    }
}

TEST_CASE("rates: a mantissa and a shift are within one part in a thousand") {
  for (double rate = 0.0001; rate < 0.12; rate *= 1.07) {
    const kinetics::Rate r = kinetics::rate_of(static_cast<int64_t>(rate * 1073741824), 12, kinetics::kWide);
    CHECK(r.mantissa < 1024);
    REQUIRE(r.shift >= 0);
    const kinetics::Rate same = kinetics::unpacked(kinetics::packed(r));
    CHECK((same.mantissa == r.mantissa && same.shift == r.shift));
    const double have = kinetics::times(295 * 4096, r) / 33554432.0;  // Q25
    CHECK(have == doctest::Approx(295 * rate).epsilon(0.001));
  }
}

TEST_CASE("stretched diffusion: the tensor for every angle, no weight below 0") {
  for (int stretch = 1000000; stretch <= kinetics::kStretch[1]; stretch += 101000)
    for (int degrees = -360; degrees <= 360; ++degrees) {
      const dapple::stencil::EightWeights w = dapple::stencil::eight_weights(stretch, degrees * 1000000);
      REQUIRE((w.x >= 0 && w.y >= 0 && w.fall >= 0 && w.rise >= 0));
      const double c = std::cos(degrees * M_PI / 180), s = std::sin(degrees * M_PI / 180),
                   across = 1e12 / stretch / stretch;
      REQUIRE(std::fabs(w.x + w.fall + w.rise - 1024 * (c * c + across * s * s)) < 2.5);
      REQUIRE(std::fabs(w.y + w.fall + w.rise - 1024 * (s * s + across * c * c)) < 2.5);
      REQUIRE(std::fabs(w.fall - w.rise - 1024 * (1 - across) * c * s) < 1.5);
    }
}

TEST_CASE("stretched spots are longer along the angle") {
  for (const int degrees : {0, 30, 90, 135}) {
    const uint16_t side = 128;
    const std::vector<int16_t> f =
        field_of("turing scale=11.3 decay=12.25 stretch=1.73 steps=2400 angle=" + std::to_string(degrees),
                 dapple::torus(side, side));
    double xx = 0, xy = 0, yy = 0;  // structure tensor: least along the spots
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const auto at = [&](int dx, int dy) {
          return f[static_cast<size_t>((y + dy + side) % side * side + (x + dx + side) % side)];
        };
        const double gx = at(1, 0) - at(-1, 0), gy = at(0, 1) - at(0, -1);
        xx += gx * gx, xy += gx * gy, yy += gy * gy;
      }
    const double along = 0.5 * std::atan2(2 * xy, xx - yy) * 180 / M_PI + 90;
    const double off = std::fabs(std::remainder(along - degrees, 180));
    INFO(degrees << ": " << along);
    CHECK(off < 6);
  }
}

TEST_CASE("bounds: steps that would diverge are refused, with the number and what would do") {
  struct Case {
    const char *good, *bad;
    double largest;
  };
  const Case cases[] = {
      {"turing scale=11.3137 dt=1.2", "turing scale=11.3137 dt=1.25", 1.211},
      {"turing scale=4.0825 dt=1", "turing scale=4.0825 dt=1.1", 1.002},
      {"turing spread=0.125 scale=3 dt=1.1", "turing spread=0.125 scale=3 dt=1.2", 1.125},
      {"meinhardt-spots dt=1.249", "meinhardt-spots dt=2", 1.25},
      {"meinhardt-stripes reach=0.2 dt=1.2", "meinhardt-stripes reach=0.2 dt=2", 1.25},
      {"meinhardt-stripes reach=0.245", "meinhardt-stripes reach=0.245 dt=1.1", 1.0204},
      {"fitzhugh-nagumo dt=0.12", "fitzhugh-nagumo dt=0.13", 0.1242},
      {"schnakenberg dt=1.2", "schnakenberg dt=1.25", 1.2048},
      {"brusselator delta=5 dt=0.04", "brusselator delta=5 dt=0.05", 0.0444},
  };
  for (const Case& c : cases) {
    INFO(c.bad);
    CHECK(recipe_of(c.good).stages == 1);
    const dapple::Trouble t = refusal(c.bad);
    CHECK(t.status == dapple::unstable);
    REQUIRE(t.allowed != nullptr);
    CHECK(std::string(t.allowed) == "dt");
    CHECK(t.high / 1e6 == doctest::Approx(c.largest).epsilon(0.001));
    CHECK(t.value > t.high);
    const std::string would_do = std::string(c.bad) + " dt=" + std::to_string(t.high / 1e6 - 1e-6);
    CHECK(recipe_of(would_do.c_str()).stages == 1);
  }
  CHECK(refusal("turing scale=5 level=1").status == dapple::unstable);  // 2.5 cells of its grid
  CHECK(std::string(refusal("turing scale=5 level=1").allowed) == "scale");
  CHECK(refusal("turing scale=5 level=1").low == 6000000);
}

TEST_CASE("bounds: begin refuses what a hand has made, and says why") {
  for (const char* family : kFamilies) {
    dapple::Recipe recipe = recipe_of(family);
    REQUIRE(recipe.stages == 1);
    recipe.stage[0].number[kinetics::dt] = kinetics::kDt[1];
    const dapple::Need need = dapple::need_for(recipe, dapple::torus(256, 256));
    CHECK(need.status == dapple::unstable);
    CHECK(need.bytes == 0);
    CHECK(need.bound.slot == kinetics::dt);
    CHECK(need.bound.high < kinetics::kDt[1]);
    recipe.stage[0].number[kinetics::dt] = need.bound.high;
    CHECK(dapple::need_for(recipe, dapple::torus(256, 256)).status == dapple::ok);
  }
}

// At the largest dt that is let through the pattern is still there, and no checkerboard.
TEST_CASE("bounds: what is let through does not diverge") {
  for (const std::string family : kFamilies) {
    const dapple::Recipe recipe = recipe_of(family.c_str());
    const double most = recipe.stage[0].model->bound(recipe.stage[0].number, 0).high / 1e6;
    const std::string start = family == "brusselator" ? " start=phases pitch=40 delta=0 force=0.1"
                              : family == "turing"    ? " decay=12.25"
                                                      : "";
    const uint16_t side = 96;
    const std::vector<int16_t> f = field_of(
        family + start + " steps=3000 dt=" + std::to_string(std::min(most - 1e-6, 2.0)), dapple::torus(side, side));
    double rough = 0, spread = 0, mean = 0;
    for (const int16_t v : f) mean += v / double(f.size());
    for (size_t i = 0; i < f.size(); ++i) {
      spread += (f[i] - mean) * (f[i] - mean);
      const size_t row = i / side * side, right = row + (i + 1) % side, left = row + (i + side - 1) % side;
      const double bump = f[i] - 0.5 * (f[left] + f[right]);
      rough += bump * bump;
    }
    INFO(family << " " << most << " spread " << std::sqrt(spread / double(f.size())) << " rough "
                << std::sqrt(rough / double(f.size())));
    CHECK(rough < 0.5 * spread + double(f.size()));
    CHECK(spread > 400.0 * double(f.size()));
  }
}

TEST_CASE("then freeze: held cells never change, the others do; reset puts back what it says") {
  const dapple::Domain domain = dapple::torus(64, 64);
  for (const std::string show : {"a", "b"}) {
    const std::string grown = "turing scale=11.3 decay=12.25 steps=1500 show=" + show, above = show == "a" ? "5" : "6";
    const std::vector<int16_t> before = field_of(grown, domain);
    const std::vector<int16_t> after = field_of(grown + " then freeze scale=5.6 steps=400 above=" + above, domain);
    const std::vector<int16_t> apart =
        field_of(grown + " held=apart then freeze scale=5.6 steps=400 above=" + above, domain);
    const std::vector<int16_t> back =
        field_of(grown + " then freeze reset=on scale=5.6 steps=400 above=" + above, domain);
    const dapple::Recipe recipe = recipe_of(grown.c_str());
    const int32_t level = std::stoi(above) * 1024,
                  uniform = dapple::turing::levels(recipe.stage[0].number, show == "b").background >> 10;
    int held = 0, moved = 0;
    for (size_t i = 0; i < before.size(); ++i) {
      if (before[i] > level + 1) {
        ++held;
        REQUIRE(after[i] == before[i]);
        REQUIRE(apart[i] == -before[i]);
        REQUIRE(std::abs(back[i] - uniform) <= 1);
      } else if (before[i] < level - 1) {
        moved += after[i] != before[i];
        REQUIRE(apart[i] == after[i]);
      }
    }
    CHECK(held > 100);
    CHECK(moved > 1000);
  }
}

TEST_CASE("then freeze, then reset: the cells that are off go back, and nothing is held") {
  const dapple::Domain domain = dapple::torus(64, 64);
  const std::string grown = "fitzhugh-nagumo bias=-0.15 steps=800";
  const std::vector<int16_t> before = field_of(grown, domain);
  const std::vector<int16_t> off = field_of(grown + " then freeze reset=off steps=1", domain);
  const std::vector<int16_t> freed = field_of(grown + " then freeze steps=50 then reset reset=on steps=200", domain);
  const int32_t uniform = dapple::fitzhugh_nagumo::levels(recipe_of(grown.c_str()).stage[0].number, 0).background;
  int moved = 0;
  for (size_t i = 0; i < before.size(); ++i) {
    if (before[i] > 0) REQUIRE(off[i] == before[i]);
    else REQUIRE(std::abs(off[i] - uniform) < 7000);  // a step from the uniform state, beside what is held
    moved += before[i] > 0 && std::abs(freed[i] - uniform) > 100;
  }
  CHECK(moved > 100);
}

TEST_CASE("kinetics: the same bits however the run is sliced and in however many bands") {
  std::vector<std::string> families(std::begin(kFamilies), std::end(kFamilies));
  families.insert(families.end(), {"turing cells=compact", "meinhardt-spots cells=compact"});
  for (const std::string& family : families) {
    const auto is = [&](const char* name) { return family.find(name) == 0; };
    INFO(family);
    const std::string text =
        family + " vary=0.05 stretch=1.5 angle=20 level=1 scale=" +
        (is("turing") || is("schnakenberg") ? "12" : is("meinhardt-spots") ? "4" : "1.4") +
        " steps=9 then refine steps=5 dt=" + (is("fitzhugh-nagumo") || is("brusselator") ? "0.05" : "0.9") +
        " then freeze reset=off above=0.4 held=apart steps=7 then carry steps=3";
    const dapple::Domain domain = dapple::torus(74, 50);
    const std::vector<int16_t> whole = field_of(text, domain);
    for (const uint32_t budget : {1u, 7u, 1000u}) CHECK(field_of(text, domain, budget) == whole);
    for (const uint8_t bands : {uint8_t{2}, uint8_t{3}, uint8_t{9}}) CHECK(field_of(text, domain, 13, bands) == whole);
  }
}

TEST_CASE("kinetics: two windows of the plane agree, whatever the start") {
  for (const std::string start : {"noise", "seeds", "point", "line", "segments", "phases"}) {
    const std::string text =
        "turing start=" + start + " pitch=20 radius=3 vary=0.1 scale=6 steps=6 then freeze above=4 held=apart steps=5";
    const std::vector<int16_t> a = field_of(text, dapple::window(-30, -25, 60, 50)),
                               b = field_of(text, dapple::window(-10, -9, 60, 50));
    int differ = 0, distinct = 0;
    for (int y = 0; y < 34; ++y)
      for (int x = 0; x < 40; ++x) {
        differ += a[static_cast<size_t>((y + 16) * 60 + x + 20)] != b[static_cast<size_t>(y * 60 + x)];
        distinct += b[static_cast<size_t>(y * 60 + x)] != b[0];
      }
    INFO(start);
    CHECK(differ == 0);
    CHECK(distinct > 10);
  }
}

TEST_CASE("kinetics: stages that make no sense are refused") {
  CHECK(refusal("threshold then freeze").status == dapple::not_possible);
  CHECK(refusal("gray-scott then reset").status == dapple::not_possible);
  CHECK(refusal("turing then thaw").status == dapple::unknown_word);
  dapple::Recipe recipe = recipe_of("turing then carry solver=cascade");
  CHECK(dapple::need_for(recipe, dapple::torus(64, 64)).status == dapple::bad_recipe);
  recipe = recipe_of("turing then freeze steps=0 then carry steps=4");
  CHECK(dapple::need_for(recipe, dapple::torus(64, 64)).status == dapple::bad_recipe);
  recipe = recipe_of("turing then freeze level=1");
  CHECK(dapple::need_for(recipe, dapple::torus(64, 64)).status == dapple::bad_recipe);
}
