// Recipe text: what is read, what is refused and where, and that the written line grows the same bytes.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstring>
#include <string>

#include "grow.hpp"

using dapple::Recipe;
using dapple::Status;
using dapple::Trouble;

namespace {

std::string line_of(const Recipe& recipe) {
  char text[2000];
  CHECK(dapple::write(recipe, text, sizeof text) < sizeof text);
  return text;
}

void check_refused(const char* text, Status status, uint16_t column) {
  CAPTURE(text);
  Recipe recipe = dapple::load(dapple::presets::zebra);
  const std::string before = line_of(recipe);
  Trouble trouble{};
  CHECK(dapple::parse(text, recipe, trouble) == status);
  CHECK(trouble.status == status);
  CHECK(trouble.column == column);
  CHECK(line_of(recipe) == before);
}

}  // namespace

TEST_CASE("text: the line of every preset parses to the same recipe") {
  for (uint16_t i = 0; i < dapple::preset_count(); ++i) {
    char name[dapple::kMaxName];
    const Recipe recipe = dapple::load(*dapple::preset_at(i, name).preset);
    CAPTURE(name);
    const std::string line = line_of(recipe);
    Recipe again{};
    Trouble trouble{};
    REQUIRE(dapple::parse(line.c_str(), again, trouble) == dapple::ok);
    CHECK(line_of(again) == line);
    CHECK(std::memcmp(again.stage[0].number, recipe.stage[0].number, sizeof recipe.stage[0].number) == 0);
    CHECK(again.stage[0].steps == recipe.stage[0].steps);
    CHECK(again.start.pitch == recipe.start.pitch);
    CHECK(again.paint.low == recipe.paint.low);
  }
}

TEST_CASE("text: stages, levels and odd values survive the round trip") {
  for (const char* text :
       {"threshold pairs=3 angles=1.5,-20,0.000001 scale=1.234567 rho=0.1:-0.05@0.25..0.75 k=0.5:1@0.125 steps=40 levels=3 fine=4",
        "threshold diffusion=isotropic start=seeds pitch=40 ramp=0:102030,17:ffffff range=-0.000001,0.000002 steps=0",
        "gray-scott feed=0.02 kill=0.055 start=noise above=0.3 steps=17 then carry feed=0.03 steps=5",
        "threshold scale=3.5 solver=multigrid", "threshold pairs=2 scale=4 solver=multigrid levels=2 fine=3 steps=17",
        "threshold solver=euler steps=9 level=1 then refine rho=0.01 steps=2 then carry k=0.5 steps=1"}) {
    CAPTURE(text);
    const Recipe recipe = tests::recipe_of(text);
    REQUIRE(recipe.stages > 0);
    const std::string line = line_of(recipe);
    const Recipe again = tests::recipe_of(line.c_str());
    REQUIRE(again.stages == recipe.stages);
    CHECK(line_of(again) == line);
    if (recipe.stage[0].steps == 0) continue;
    tests::Grown a(recipe, dapple::torus(96, 96), 3), b(again, dapple::torus(96, 96), 3);
    REQUIRE(a.status == dapple::ok);
    CHECK(a.field_hash() == b.field_hash());
    CHECK(a.paint_hash() == b.paint_hash());
  }
}

TEST_CASE("text: refused words, and where") {
  check_refused("zebraa", dapple::unknown_word, 1);
  check_refused("threshold pears=2", dapple::unknown_word, 11);
  check_refused("threshold pairs=6", dapple::out_of_range, 17);
  check_refused("threshold pairs=2x", dapple::broken_text, 17);
  check_refused("threshold pairs=", dapple::broken_text, 17);
  check_refused("threshold  react=sum", dapple::unknown_word, 18);
  check_refused("threshold scale=2.2.2", dapple::broken_text, 17);
  check_refused("threshold scale=1e3", dapple::broken_text, 17);
  check_refused("threshold scale=nan", dapple::broken_text, 17);
  check_refused("threshold scale=0.1", dapple::out_of_range, 17);
  check_refused("threshold scale=2.1234567", dapple::broken_text, 17);
  check_refused("threshold scale=99999999999999999999", dapple::broken_text, 17);
  check_refused("threshold rho=0:1@0.5", dapple::out_of_range, 17);
  check_refused("threshold rho=0:0.1@0.5..0.2", dapple::out_of_range, 26);
  check_refused("threshold rho=0:0.1", dapple::broken_text, 20);
  check_refused("threshold angles=1,2,3,4,5,6", dapple::broken_text, 18);
  check_refused("threshold steps=-1", dapple::broken_text, 17);
  check_refused("threshold steps=5 garbage", dapple::broken_text, 19);
  check_refused("threshold ramp=mauve", dapple::unknown_word, 16);
  check_refused("threshold ramp=00000g", dapple::unknown_word, 16);
  check_refused("threshold range=0.1,0.1", dapple::out_of_range, 21);
  check_refused("threshold then fine", dapple::unknown_word, 16);
  check_refused("threshold then refine", dapple::not_possible, 16);
  check_refused("threshold steps=8 levels=3 fine=4", dapple::not_possible, 1);
  check_refused("threshold solver=binary", dapple::not_possible, 18);
  check_refused("threshold solver=multigrid levels=5", dapple::out_of_range, 35);
  check_refused("gray-scott solver=multigrid", dapple::unknown_word, 19);
  check_refused("threshold wavelength=200", dapple::out_of_range, 1);
  check_refused("gray-scott pairs=2", dapple::unknown_word, 12);
  check_refused("gray-scott solver=euler", dapple::unknown_word, 19);
}

TEST_CASE("text: changes to a preset") {
  const Recipe weave = dapple::load(dapple::presets::weave);
  Recipe turned = tests::preset_with("weave", "angle=30");
  CHECK(turned.stage[0].number[dapple::threshold::angles] == 30000000);
  CHECK(turned.stage[0].number[dapple::threshold::angles + 1] == 120000000);
  CHECK(turned.stage[0].number[dapple::threshold::rho] == weave.stage[0].number[dapple::threshold::rho]);
  const Recipe giraffe = tests::preset_with("giraffe", "scale=1.35");
  CHECK(giraffe.start.pitch == 25600000);
  CHECK(giraffe.start.radius == 2500000);
  CHECK(tests::preset_with("giraffe", "scale=1.35 pitch=30").start.pitch == 30000000);
  const Recipe fine = tests::preset_with("zebra", "levels=2");
  REQUIRE(fine.stages == 2);
  CHECK(fine.stage[0].steps == 26);
  CHECK(fine.stage[1].steps == 6);
  CHECK(tests::preset_with("zebra", "wavelength=12").stage[0].number[dapple::threshold::scale] == doctest::Approx(1559390).epsilon(.001));
}

TEST_CASE("text: solver=multigrid lays the stages of levels=, as many as resolve the pattern") {
  const auto stages = [](const char* text) { return int{tests::recipe_of(text).stages}; };
  CHECK(stages("threshold wavelength=13.9 solver=multigrid") == 1);
  CHECK(stages("threshold wavelength=14.1 solver=multigrid") == 2);
  CHECK(stages("threshold wavelength=28.1 solver=multigrid") == 3);
  CHECK(stages("threshold wavelength=60 solver=multigrid") == 4);
  CHECK(stages("threshold wavelength=60 solver=multigrid steps=18") == 3);  // six on each finer grid, one at least before
  CHECK(stages("threshold wavelength=60 solver=multigrid steps=6") == 1);
  CHECK(stages("threshold wavelength=60 solver=multigrid fine=20") == 2);
  const Recipe word = tests::preset_with("zebra", "solver=multigrid");
  CHECK(line_of(word) == line_of(tests::preset_with("zebra", "levels=2")));
  CHECK(line_of(word).find(" solver=multigrid levels=2 fine=6 steps=32 ") != std::string::npos);
  CHECK(line_of(word).find("then") == std::string::npos);
}

TEST_CASE("text: changes to a recipe of solver=multigrid") {
  const auto changed = [](const char* changes) {
    Recipe recipe = tests::preset_with("zebra", "solver=multigrid levels=3 fine=4");
    Trouble trouble{};
    REQUIRE(dapple::parse(changes, recipe, trouble) == dapple::ok);
    return line_of(recipe);
  };
  CHECK(changed("solver=gaussian") == line_of(tests::preset_with("zebra", "")));
  CHECK(changed("solver=euler") == line_of(tests::preset_with("zebra", "solver=euler")));
  CHECK(changed("levels=1") == line_of(tests::preset_with("zebra", "")));
  CHECK(changed("steps=50") == line_of(tests::preset_with("zebra", "levels=3 fine=4 steps=50")));
  CHECK(changed("rho=0.01") == line_of(tests::preset_with("zebra", "levels=3 fine=4 rho=0.01")));
  CHECK(changed("solver=euler levels=2").find("then refine") != std::string::npos);
  // Stages laid by hand are written one by one.
  const Recipe hand = tests::recipe_of("threshold level=1 steps=9 then refine steps=5 rho=0.01");
  CHECK(line_of(hand).find("solver=gaussian level=1 steps=9") != std::string::npos);
}

TEST_CASE("text: opacity and roughness, in 255 parts") {
  const Recipe plain = tests::recipe_of("threshold"), given = tests::recipe_of("threshold opacity=1,0.25 roughness=0,0.999");
  CHECK(line_of(plain).find(" opacity=0,1 roughness=0.8,0.4") != std::string::npos);
  CHECK((given.paint.opacity[0] == 255 && given.paint.opacity[1] == 64));
  CHECK((given.paint.roughness[0] == 0 && given.paint.roughness[1] == 255));
  for (int part = 0; part < 256; ++part) {
    Recipe recipe = plain;
    recipe.paint.opacity[1] = static_cast<uint8_t>(part);
    CHECK(tests::recipe_of(line_of(recipe).c_str()).paint.opacity[1] == part);
  }
  check_refused("threshold opacity=0", dapple::broken_text, 20);
  check_refused("threshold opacity=0,1.1", dapple::out_of_range, 21);
  check_refused("threshold roughness=-0.1,1", dapple::out_of_range, 21);
}

TEST_CASE("text: write never runs past its buffer") {
  const Recipe recipe = dapple::load(dapple::presets::coral);
  const std::string line = line_of(recipe);
  for (size_t size : {size_t(1), size_t(2), size_t(17), line.size(), line.size() + 1}) {
    std::vector<char> text(size + 4, '#');
    CHECK(dapple::write(recipe, text.data(), size) == line.size());
    CHECK(std::string(text.data()) == line.substr(0, size - 1));
    for (size_t i = size; i < text.size(); ++i) CHECK(text[i] == '#');
  }
}

TEST_CASE("text: a list of families of one's own knows no others") {
  const dapple::recipe::Families known = {dapple::recipe::families + 2, 1};
  REQUIRE(std::string(known.first->name) == "gray-scott");
  dapple::Recipe recipe{};
  dapple::Trouble trouble{};
  CHECK(dapple::recipe::read("gray-scott feed=0.03", recipe, trouble, known) == dapple::ok);
  CHECK(dapple::recipe::read("kill=0.06", recipe, trouble, known) == dapple::ok);
  CHECK(recipe.stage[0].number[1] == 60000);
  CHECK(dapple::recipe::read("bits", recipe, trouble, known) == dapple::unknown_word);
}
