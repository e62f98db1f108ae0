// Textures that are disturbed while they run: between whole steps only, the same bits however sliced, and they heal.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstdlib>
#include <string>

#include "grow.hpp"

using dapple::Texture;
using tests::Grown;
using tests::recipe_of;

namespace {

constexpr uint16_t kSide = 64;

struct Running {
  dapple::Recipe recipe;
  std::vector<uint8_t> memory;
  Texture texture;
  uint32_t budget;

  Running(const char* text, uint32_t rows, uint8_t bands = 1, dapple::Domain domain = dapple::torus(kSide, kSide))
      : recipe(recipe_of(text)), memory(dapple::bytes_for(recipe, domain, bands)), budget(rows) {
    dapple::Options options;
    options.bands = bands;
    REQUIRE(texture.begin(recipe, domain, 5, memory.data(), memory.size(), options) == dapple::ok);
  }
  Running(const Running&) = delete;

  // To the end of row `rows` of work, `budget` at a time.
  void to(uint64_t rows) {
    while (texture.rows_done() < rows) {
      const uint64_t left = rows - texture.rows_done();
      texture.step(left < budget ? static_cast<uint32_t>(left) : budget);
    }
  }
  void to_step(uint32_t steps) { to((2 + uint64_t{steps}) * kSide); }
  std::vector<int16_t> field() {
    std::vector<int16_t> all(size_t{kSide} * kSide);
    for (uint16_t y = 0; y < kSide; ++y) texture.row(y, all.data() + size_t{y} * kSide);
    return all;
  }
  int spots() {
    const std::vector<int16_t> f = field();
    int count = 0;
    const auto at = [&](int x, int y) { return f[static_cast<size_t>((y & 63) * kSide + (x & 63))]; };
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        bool peak = at(x, y) > texture.cell_level();
        for (int k = 0; k < 9; ++k) {
          const int16_t other = at(x + k % 3 - 1, y + k / 3 - 1);
          peak = peak && (k < 4 ? at(x, y) > other : at(x, y) >= other);
        }
        count += peak;
      }
    return count;
  }
};

constexpr const char* kText = "turing decay=12.25 scale=8 steps=900";

// Stamped, wiped and changed after 40 and 300 steps.
std::vector<int16_t> disturbed(uint32_t budget, uint8_t bands) {
  Running running(kText, budget, bands);
  Texture& t = running.texture;
  running.to_step(40);
  REQUIRE(t.stamp(60, 5, 9, true) == dapple::ok);
  REQUIRE(t.stamp(20, 40, 12, false) == dapple::ok);
  running.to_step(300);
  REQUIRE(t.change(dapple::turing::growth, 15700000) == dapple::ok);
  t.finish();
  REQUIRE(t.go_on(17) == dapple::ok);
  CHECK(t.rows_done() < t.rows_in_all());
  t.finish();
  CHECK(t.rows_done() == t.rows_in_all());
  CHECK(t.steps_done() == 917);
  return running.field();
}

}  // namespace

TEST_CASE("disturb: the same calls give the same bits however sliced, in however many bands") {
  const std::vector<int16_t> whole = disturbed(UINT32_MAX, 1);
  for (const uint32_t budget : {1u, 7u, 1000u}) CHECK(disturbed(budget, 1) == whole);
  for (const uint8_t bands : {uint8_t{2}, uint8_t{3}, uint8_t{9}}) CHECK(disturbed(13, bands) == whole);
  Running plain("turing decay=12.25 scale=8 steps=917", UINT32_MAX);
  plain.texture.finish();
  CHECK(plain.field() != whole);
}

TEST_CASE("disturb: what is wiped heals") {
  Running running("turing decay=12.25 scale=8 steps=1500", UINT32_MAX);
  running.texture.finish();
  const int before = running.spots();
  CHECK(before > 12);
  REQUIRE(running.texture.stamp(32, 32, 24, false) == dapple::ok);
  const int wiped = running.spots();
  CHECK(wiped <= before - 6);
  REQUIRE(running.texture.go_on(1500) == dapple::ok);
  running.texture.finish();
  INFO(before << " spots, " << wiped << " after the wipe, " << running.spots() << " healed");
  CHECK(std::abs(running.spots() - before) <= 3);
}

TEST_CASE("disturb: a disc around a corner of the torus, and only it") {
  Running running(kText, UINT32_MAX);
  running.to_step(3);
  const std::vector<int16_t> before = running.field();
  REQUIRE(running.texture.stamp(-1, 64, 5, true) == dapple::ok);
  const std::vector<int16_t> after = running.field();
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const int dx = x < 32 ? x + 1 : 63 - x, dy = y < 32 ? y : 64 - y;
      const size_t i = static_cast<size_t>(y * kSide + x);
      if (dx * dx + dy * dy > 25) REQUIRE(after[i] == before[i]);
      else REQUIRE(after[i] == after[63]);
    }
}

TEST_CASE("disturb: more steps are what a longer recipe has") {
  for (const char* family : {"turing scale=8", "meinhardt-stripes", "gray-scott", "threshold", "bits"}) {
    const std::string text = family;
    Running some((text + " steps=20").c_str(), 11), all((text + " steps=29").c_str(), UINT32_MAX);
    some.texture.finish();
    REQUIRE(some.texture.go_on(9) == (text == "bits" ? dapple::not_now : dapple::ok));
    if (text == "bits") continue;
    some.texture.finish();
    all.texture.finish();
    INFO(text);
    CHECK(some.field() == all.field());
  }
}

TEST_CASE("disturb: refused within a step, before the start, and where it cannot be") {
  Running running(kText, UINT32_MAX);
  Texture& t = running.texture;
  const auto refuses = [&] {
    return t.stamp(1, 1, 3, true) == dapple::not_now && t.change(dapple::turing::growth, 15700000) == dapple::not_now &&
           t.go_on(5) == dapple::not_now && !t.between_steps();
  };
  CHECK(refuses());
  running.to(70);
  CHECK(refuses());
  running.to_step(4);
  CHECK(t.between_steps());
  CHECK(t.go_on(5) == dapple::not_now);
  CHECK(t.stamp(1, 1, 5000, true) == dapple::out_of_range);
  CHECK(t.change(dapple::turing::growth, 31000000) == dapple::out_of_range);
  CHECK(t.change(dapple::kinetics::vary, 100000) == dapple::out_of_range);  // a plane that is not there
  CHECK(t.change(dapple::kinetics::dt, 1900000) == dapple::unstable);
  CHECK(t.change(200, 1) == dapple::out_of_range);
  t.step(1);
  CHECK(refuses());
  t.step(kSide - 2);
  CHECK(refuses());
  t.step(1);
  CHECK(t.between_steps());
  t.finish();
  CHECK(t.go_on(dapple::kMaxSteps) == dapple::out_of_range);
  Running same(kText, UINT32_MAX);
  same.texture.finish();
  CHECK(same.field() == running.field());
  Running window("turing scale=6 steps=5", UINT32_MAX, 1, dapple::window(3, 4, kSide, kSide));
  window.texture.finish();
  CHECK(window.texture.go_on(5) == dapple::not_now);
}

// A texture that was looked at before it is disturbed shows what one does that was not: no row of before is kept.
TEST_CASE("disturb: what is done to a texture is seen at once, by row and by paint") {
  using Pixels = std::vector<uint8_t>;
  const auto pixels = [](Running& running) {
    Pixels all(size_t{3 * kSide} * kSide);
    for (uint16_t y = 0; y < kSide; ++y) running.texture.paint(y, dapple::Pixels::rgb888, all.data() + size_t{3 * kSide} * y);
    return all;
  };
  for (const char* text : {"turing decay=12.25 scale=8 steps=90 light=1", "turing decay=12.25 scale=8 level=1 steps=60 then refine steps=30 light=1"}) {
    INFO(text);
    Running looked(text, UINT32_MAX), blind(text, UINT32_MAX);
    const auto both = [&](dapple::Status (*act)(Texture& t)) {
      const Pixels before = pixels(looked);
      REQUIRE(act(looked.texture) == dapple::ok);
      REQUIRE(act(blind.texture) == dapple::ok);
      const Pixels after = pixels(looked);
      CHECK(after == pixels(blind));
      CHECK(looked.field() == blind.field());
      return after != before;
    };
    looked.texture.finish(), blind.texture.finish();
    CHECK(both([](Texture& t) { return t.stamp(32, 62, 9, true); }));
    CHECK(both([](Texture& t) { return t.stamp(10, 1, 9, false); }));
    CHECK(both([](Texture& t) { return t.change(dapple::kinetics::coverage, 400000); }));
    both([](Texture& t) { return t.go_on(0); });
    CHECK(both([](Texture& t) {
      const dapple::Status status = t.go_on(9);
      t.finish();
      return status;
    }));
  }
}
