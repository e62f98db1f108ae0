// The parts of the command rule that read and write: programs and patterns as text, and the torus.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "../tools/dapple/rule_map.hpp"
#include "../tools/dapple/rule_rle.hpp"
#include "../tools/dapple/rule_styles.hpp"
#include "grow.hpp"
#include "rule.hpp"

namespace {

using namespace cli;
using namespace tests;

constexpr uint32_t kParity = kLeft ^ kRight ^ kUpper ^ kLower;  // Fredkin's replicator

uint32_t program_named(const std::string& text) {
  uint32_t program = 0;
  ProgramTrouble trouble{};
  REQUIRE_MESSAGE(read_cell_program(text, program, trouble), text);
  return program;
}

Torus read(const std::string& text, uint16_t width, uint16_t height) {
  Pattern pattern;
  RleTrouble trouble{};
  REQUIRE_MESSAGE(read_rle(text, pattern, trouble), trouble.reason);
  Torus torus(width, height);
  place(pattern, torus);
  return torus;
}

}  // namespace

TEST_CASE("Programs are numbers or Golly's MAP") {
  CHECK(program_named("0") == 0);
  CHECK(program_named("4294967295") == 0xffffffff);
  CHECK(program_named("0xE8808000") == 0xe8808000);
  // Golly counts 16 N + 8 W + 4 C + 2 E + S: the program that copies W has the bits 00ff00ff, and so on.
  CHECK(map_of(kUpper) == "MAPAAD//w");
  CHECK(map_of(kLeft) == "MAPAP8A/w");
  CHECK(map_of(kSelf) == "MAPDw8PDw");
  CHECK(map_of(kRight) == "MAPMzMzMw");
  CHECK(map_of(kLower) == "MAPVVVVVQ");
  for (uint32_t i = 0; i < 2000; ++i) {
    const uint32_t program = random_program(Style::uniform, 3, i);
    CHECK(program_named(map_of(program)) == program);
    CHECK(program_named(hexadecimal(program)) == program);
  }
  CHECK(program_named("mapAP8A/w==") == kLeft);
  CHECK(program_named("MAPAP8A//") == kLeft);  // the last four bits say nothing
}

TEST_CASE("A refused program names its column") {
  const struct {
    const char* text;
    size_t column;
  } broken[] = {{"", 1},          {"x", 1},           {"12a", 3},         {"4294967296", 1},
                {"0x", 2},        {"0xg", 3},         {"0x12g4", 5},      {"0x123456789", 1},
                {"-1", 1},        {"MAP", 4},         {"MAPabcde", 9},    {"MAPab!def", 6},
                {"MAPabcde=", 9}, {"MAPabcdefg", 10}, {"MAPabcdef=", 10}, {"MAPabcdef==x", 10}};
  for (const auto& one : broken) {
    CAPTURE(one.text);
    uint32_t program = 0;
    ProgramTrouble trouble{};
    CHECK(!read_cell_program(one.text, program, trouble));
    CHECK(trouble.column == one.column);
    CHECK(!trouble.reason.empty());
  }
  uint32_t program = 0;
  ProgramTrouble trouble{};
  CHECK(!read_cell_program(std::string("1\0", 2), program, trouble));
}

TEST_CASE("A program from a MAP does what Golly does with it") {
  // The sum of the four neighbours modulo two: after 2^k steps four copies of the pattern, 2^k cells away.
  const uint32_t parity = program_named("MAPZpmZZg");
  CHECK(parity == kParity);
  const std::string pattern = "x = 3, y = 3\nobo$2o$2bo!";
  Torus torus = read(pattern, 64, 48);
  const Torus start = torus;
  for (int i = 0; i < 8; ++i) torus.step(parity);
  Torus copies(64, 48);
  for (uint16_t y = 8; y < 40; ++y)
    for (uint16_t x = 8; x < 56; ++x)
      if (start.get(x, y))
        for (const int away : {-8, 8}) {
          copies.set(static_cast<uint16_t>(x + away), y, true);
          copies.set(x, static_cast<uint16_t>(y + away), true);
        }
  CHECK(copies.count() == 20);
  CHECK(torus == copies);
  // Copying one neighbour moves the pattern: from the left it goes to the right, which tells the directions apart.
  const struct {
    const char* map;
    int x, y;
  } moves[] = {{"MAPAP8A/w", 1, 0}, {"MAPMzMzMw", -1, 0}, {"MAPAAD//w", 0, 1}, {"MAPVVVVVQ", 0, -1}};
  for (const auto& move : moves) {
    Torus moved(64, 48), expected(64, 48);
    moved.set(20, 20, true);
    moved.step(program_named(move.map));
    expected.set(static_cast<uint16_t>(20 + move.x), static_cast<uint16_t>(20 + move.y), true);
    CHECK(moved == expected);
  }
}

TEST_CASE("The torus steps as the definition says, at any size") {
  for (uint16_t width = 1; width <= 70; ++width) {
    const uint16_t height = static_cast<uint16_t>(1 + width * 5 % 13);
    Torus torus = noise(width, height, width), other = torus;
    for (uint32_t i = 0; i < 4; ++i) {
      const uint32_t program = random_program(Style::uniform, 5, 4 * width + i);
      torus.step(program);
      other = stepped(other, program);
      CHECK(torus == other);
      CHECK(torus.hash() == other.hash());
    }
  }
}

TEST_CASE("The torus is the library's texture") {
  const Size sizes[] = {{8, 8}, {64, 32}, {100, 77}, {129, 9}};
  for (const Size size : sizes) {
    tests::Grown grown(tests::recipe_of("cells rule=0xcbc0abaa steps=20"), dapple::torus(size.width, size.height), 77);
    Torus torus = noise(size.width, size.height, 77);
    for (int i = 0; i < 20; ++i) torus.step(0xcbc0abaa);
    const std::vector<int16_t> field = grown.field();
    uint32_t wrong = 0;
    for (uint16_t y = 0; y < size.height; ++y)
      for (uint16_t x = 0; x < size.width; ++x) wrong += (field[size_t{y} * size.width + x] > 0) != torus.get(x, y);
    CHECK(wrong == 0);
  }
}

TEST_CASE("Patterns survive as run-length text") {
  for (const Size size : {Size{1, 1}, {64, 48}, {97, 13}, {300, 5}}) {
    const Torus torus = noise(size.width, size.height, 9);
    const std::string text = write_rle(torus, "MAPAP8A/w", "noise");
    CHECK(read(text, size.width, size.height) == torus);
    size_t longest = 0, line = 0;
    for (const char c : text) longest = std::max(longest, line = c == '\n' ? 0 : line + 1);
    CHECK(longest <= 70);
  }
  const Torus empty(20, 10);
  CHECK(read(write_rle(empty, "MAPAP8A/w", "nothing"), 20, 10) == empty);
  const Torus glider =
      read("#C by hand\r\n\r\n#N Glider\r\n x=3 ,y = 3, rule = B3/S23:T9,9 \r\nb A$\r\n2.\n#\no$\t3o ! and more", 5, 5);
  CHECK(text_of(glider) == ".....\n..o..\n...o.\n.ooo.\n.....\n");
  CHECK(text_of(read("x = 0, y = 0\n!", 2, 1)) == "..\n");
  CHECK(text_of(read("x = 1, y = 1\n3$2bo!", 3, 4)) == "...\n...\n...\n..o\n");  // the header is too small
}

TEST_CASE("Refused run-length text names line and column") {
  const struct {
    const char* text;
    uint32_t line, column;
  } broken[] = {{"", 1, 1},
                {"#C\n#C\n", 3, 1},
                {"bo$2o!", 1, 1},
                {"y = 3, x = 3\no!", 1, 1},
                {"x = , y = 3\no!", 1, 5},
                {"x 3, y = 3\no!", 1, 3},
                {"x = 3 y = 3\no!", 1, 7},
                {"x = 3, y = 99999\no!", 1, 12},
                {"x = 3, y = 3, role = B3/S23\no!", 1, 15},
                {"x = 3, y = 3 o!", 1, 14},
                {"x = 3, y = 3\nbo$2o", 2, 6},
                {"x = 3, y = 3\nbo$2!", 2, 4},
                {"x = 3, y = 3\nbo$\n2x!", 3, 2},
                {"#\nx = 3, y = 3\n\nbo$2oB!", 4, 6},
                {"x = 3, y = 3\npA!", 2, 1},
                {"x = 3, y = 3\n65536o!", 2, 1},
                {"x = 3, y = 3\n65535o1o!", 2, 7},
                {"x = 3, y = 3\n9\n99999999$!", 2, 2}};
  for (const auto& one : broken) {
    CAPTURE(one.text);
    Pattern pattern;
    RleTrouble trouble{};
    CHECK(!read_rle(one.text, pattern, trouble));
    CHECK(trouble.line == one.line);
    CHECK(trouble.column == one.column);
    CHECK(!trouble.reason.empty());
  }
}
