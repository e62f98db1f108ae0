// Dials of spots: what words become, what is refused, and the share of cells that are on.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "grow.hpp"

namespace kinetics = dapple::kinetics;
using tests::Grown;
using tests::recipe_of;
using tests::refusal;

namespace {

int32_t number_of(const char* text, uint8_t slot) {
  const dapple::Recipe recipe = recipe_of(text);
  REQUIRE_MESSAGE(recipe.stages > 0, text);
  return recipe.stage[0].number[slot];
}

std::string line_of(const dapple::Recipe& recipe) {
  std::string line(dapple::write(recipe, nullptr, 0), ' ');
  dapple::write(recipe, line.data(), line.size() + 1);
  return line;
}

size_t on_in(const std::vector<int16_t>& field, int32_t level) {
  return static_cast<size_t>(std::count_if(field.begin(), field.end(), [&](int16_t v) { return v > level; }));
}

}  // namespace

TEST_CASE("dials: aspect is the stretch, spot_size a share, and steps follow the scale") {
  CHECK(number_of("turing aspect=2", kinetics::stretch) == 2000000);
  CHECK(number_of("turing start=seeds aspect=0.5", kinetics::stretch) == 1000000);  // of the seeds
  CHECK(recipe_of("turing start=seeds aspect=0.5").start.aspect == 500000);
  CHECK(number_of("turing wavelength=12 spot_size=6", kinetics::coverage) == doctest::Approx(680175 / 4).epsilon(1e-4));
  CHECK(number_of("meinhardt-spots spot_size=4 coverage=0.09", kinetics::coverage) == 90000);
  const dapple::Recipe both = recipe_of("meinhardt-spots coverage=0.09 spot_size=4");
  CHECK(both.stage[0].model->wavelength(both.stage[0].number) == doctest::Approx(10996000).epsilon(1e-4));
  const dapple::Recipe one = recipe_of("turing wavelength=14"), oval = recipe_of("turing wavelength=14 aspect=2");
  CHECK(one.stage[0].steps == 4000);
  const double scale = oval.stage[0].number[kinetics::scale] / 1e6;
  CHECK(scale * scale == doctest::Approx(2 * one.stage[0].number[kinetics::scale] / 1e6 *
                                         one.stage[0].number[kinetics::scale] / 1e6).epsilon(1e-4));
  CHECK(oval.stage[0].steps == doctest::Approx(60 * scale * scale).epsilon(1e-3));
  CHECK(recipe_of("turing wavelength=14 aspect=2 steps=77").stage[0].steps == 77);
  const dapple::Recipe share = recipe_of("turing coverage=0.3"), plain = recipe_of("turing coverage=0");
  CHECK(share.paint.low + share.paint.high == 2 * share.stage[0].number[kinetics::above]);
  CHECK((plain.paint.low == 2500000 && plain.stage[0].steps == 4000));
  CHECK(recipe_of("turing range=1,9.5 coverage=0.3").paint.low == 1000000);
}

TEST_CASE("dials: a written recipe reads back as it is") {
  for (const char* text : {"turing wavelength=14 aspect=2 angle=30 coverage=0.35", "meinhardt-spots spot_size=4 coverage=0.09",
                           "turing start=seeds aspect=0.7 spot_size=6", "schnakenberg coverage=0.4 range=0,2"}) {
    const dapple::Recipe recipe = recipe_of(text);
    REQUIRE_MESSAGE(recipe.stages == 1, text);
    const std::string line = line_of(recipe);
    CHECK(line_of(recipe_of(line.c_str())) == line);
  }
}

TEST_CASE("dials: what cannot be is refused, with what can") {
  struct Case {
    const char* text;
    dapple::Status status;
    double low, high;
  };
  const Case cases[] = {
      {"turing aspect=0.9", dapple::out_of_range, 1, 2.414},
      {"turing aspect=3", dapple::out_of_range, 1, 2.414},
      {"meinhardt-spots aspect=2.5", dapple::out_of_range, 1, 2.414},
      {"turing coverage=0.95", dapple::out_of_range, 0, 0.9},
      {"turing coverage=-0.1", dapple::out_of_range, 0, 0.9},
      {"turing wavelength=12 spot_size=14", dapple::out_of_range, 1.455, 13.804},
      {"turing wavelength=12 spot_size=1.2", dapple::out_of_range, 1.455, 13.804},
      {"turing wavelength=14 spot_size=6 coverage=0.2", dapple::not_possible, 0, 0},
      {"turing spot_size=100 coverage=0.02", dapple::out_of_range, 1, 500},
      {"turing spot_size=60 coverage=0.2", dapple::out_of_range, 4.1517, 88.57},
      {"schnakenberg spot_size=5", dapple::unknown_word, 0, 0},
      {"threshold coverage=0.2", dapple::unknown_word, 0, 0},
      {"turing spot_size=x", dapple::broken_text, 0, 0},
  };
  for (const Case& c : cases) {
    INFO(c.text);
    const dapple::Trouble t = refusal(c.text);
    CHECK(t.status == c.status);
    if (c.status != dapple::out_of_range) continue;
    CHECK(t.low / 1e6 == doctest::Approx(c.low).epsilon(0.002));
    CHECK(t.high / 1e6 == doctest::Approx(c.high).epsilon(0.002));
  }
}

TEST_CASE("coverage: the exact quantile, moved to `above`, of every kind of cell and however it is grown") {
  const dapple::Domain domain = dapple::torus(60, 44);
  for (const char* text : {"turing scale=6 decay=12.25 steps=400", "turing scale=6 show=b steps=300", "meinhardt-spots scale=1.6 steps=500",
                           "fitzhugh-nagumo steps=200", "schnakenberg scale=7 steps=600 level=1 then refine steps=60",
                           "turing scale=6 steps=300 then freeze scale=5 steps=90 held=apart"})
    for (const char* share : {"0.05", "0.35", "0.9"}) {
      INFO(std::string(text) << " " << share);
      Grown plain(recipe_of(text), domain, 9);
      dapple::Recipe recipe = plain.recipe;
      dapple::Trouble trouble{};
      const std::string words = std::string("coverage=") + share;
      REQUIRE(dapple::parse(words.c_str(), recipe, trouble) == dapple::ok);
      for (uint8_t i = 0; i < recipe.stages; ++i) recipe.stage[i].steps = plain.recipe.stage[i].steps;
      Grown covered(recipe, domain, 9);
      REQUIRE(covered.status == dapple::ok);
      std::vector<int16_t> was = plain.field(), is = covered.field(), sorted = was;
      const size_t wanted = static_cast<size_t>(std::stod(share) * static_cast<double>(was.size()) + 0.5);
      std::sort(sorted.rbegin(), sorted.rend());
      const int16_t level = sorted[wanted];  // no more than `wanted` cells are above it, and one less would be too many
      const int16_t on = covered.texture.cell_level();
      CHECK(on_in(is, on) <= wanted);
      CHECK(on_in(is, on) == on_in(was, level));
      size_t moved = 0;
      for (size_t i = 0; i < is.size(); ++i)
        if (is[i] - was[i] == on - level) ++moved;
        else CHECK((was[i] < 0 || is[i] == 32767 || is[i] == -32767));  // held and apart, or at the end of int16
      CHECK(moved > is.size() / 2);
      dapple::Options options;
      options.bands = 3;
      Grown banded(recipe, domain, 9, 7, options);
      CHECK(banded.field() == is);
    }
}

TEST_CASE("coverage: seen on the way as at the end, and changed while it runs") {
  const dapple::Domain domain = dapple::torus(48, 40);
  Grown whole(recipe_of("turing scale=6 steps=50 coverage=0.2"), domain, 3);
  Grown plain(recipe_of("turing scale=6 steps=50"), domain, 3);
  const dapple::Recipe recipe = recipe_of("turing scale=6 steps=90 coverage=0.2");
  std::vector<uint8_t> memory(dapple::bytes_for(recipe, domain));
  dapple::Texture texture;
  REQUIRE(texture.begin(recipe, domain, 3, memory.data(), memory.size()) == dapple::ok);
  const auto field = [&] {
    std::vector<int16_t> all(48 * 40);
    for (uint16_t y = 0; y < 40; ++y) texture.row(y, all.data() + size_t{y} * 48);
    return all;
  };
  field();  // while it starts: as it is
  texture.step((2 + 50) * 40);
  REQUIRE(texture.steps_done() == 50);
  texture.step(0);
  CHECK(field() == whole.field());
  REQUIRE(texture.change(kinetics::coverage, 600000) == dapple::ok);
  CHECK(on_in(field(), texture.cell_level()) == doctest::Approx(0.6 * 48 * 40).epsilon(0.01));
  CHECK(texture.change(kinetics::coverage, 950000) == dapple::out_of_range);
  REQUIRE(texture.change(kinetics::coverage, 0) == dapple::ok);
  CHECK(field() == plain.field());
}

TEST_CASE("coverage: of tiles, not of windows, nor of patches that are joined") {
  const dapple::Recipe recipe = recipe_of("turing scale=6 steps=6 coverage=0.3");
  CHECK(dapple::need_for(recipe, dapple::torus(64, 64)).status == dapple::ok);
  CHECK(dapple::need_for(recipe, dapple::window(0, 0, 64, 64)).status == dapple::no_coverage);
  CHECK(dapple::need_for(recipe_of("turing scale=6 steps=6"), dapple::window(0, 0, 64, 64)).status == dapple::ok);
  const dapple::Recipe closed = recipe_of("turing scale=6 steps=60 coverage=0.3 sides=closed");
  const dapple::Patch patch = dapple::patch_of(closed);
  const dapple::Patches one = {&patch, 1, 64, 48}, two = {&patch, 2, 64, 48};
  Grown grown(closed, dapple::on_patch(one, 0), 4);
  REQUIRE(grown.status == dapple::ok);
  CHECK(on_in(grown.field(), grown.texture.cell_level()) == doctest::Approx(0.3 * 64 * 48).epsilon(0.01));
  CHECK(dapple::need_for(closed, dapple::on_patch(two, 0)).status == dapple::no_coverage);
  CHECK(dapple::need_for(recipe, dapple::torus(64, 64)).bytes ==
        dapple::need_for(recipe_of("turing scale=6 steps=6"), dapple::torus(64, 64)).bytes);
}
