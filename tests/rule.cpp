// The parts of the command rule: programs as text, patterns as text, settling, scores, searches.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "../tools/dapple/rule_complete.hpp"
#include "../tools/dapple/rule_map.hpp"
#include "../tools/dapple/rule_rle.hpp"
#include "../tools/dapple/rule_search.hpp"
#include "grow.hpp"

namespace {

using namespace cli;

// The programs that copy one of the five cells, and those that add cells modulo two.
constexpr uint32_t kLeft = 0xffff0000, kRight = 0xff00ff00, kUpper = 0xf0f0f0f0, kLower = 0xcccccccc, kSelf = 0xaaaaaaaa;
constexpr uint32_t kParity = kLeft ^ kRight ^ kUpper ^ kLower;  // Fredkin's replicator

uint32_t program_named(const std::string& text) {
  uint32_t program = 0;
  ProgramTrouble trouble{};
  REQUIRE_MESSAGE(read_cell_program(text, program, trouble), text);
  return program;
}

Torus noise(uint16_t width, uint16_t height, uint32_t seed) {
  Torus torus(width, height);
  torus.noise(seed);
  return torus;
}

Torus read(const std::string& text, uint16_t width, uint16_t height) {
  Pattern pattern;
  RleTrouble trouble{};
  REQUIRE_MESSAGE(read_rle(text, pattern, trouble), trouble.reason);
  Torus torus(width, height);
  place(pattern, torus);
  return torus;
}

// The definition of a step, cell by cell.
Torus stepped(const Torus& torus, uint32_t program) {
  const int width = torus.width(), height = torus.height();
  const auto at = [&](int x, int y) {
    return torus.get(static_cast<uint16_t>((x + width) % width), static_cast<uint16_t>((y + height) % height));
  };
  Torus next(torus.width(), torus.height());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const unsigned k = 16u * at(x - 1, y) + 8u * at(x + 1, y) + 4u * at(x, y - 1) + 2u * at(x, y + 1) + at(x, y);
      next.set(static_cast<uint16_t>(x), static_cast<uint16_t>(y), (program >> k & 1) != 0);
    }
  return next;
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
  } broken[] = {{"", 1},        {"x", 1},           {"12a", 3},        {"4294967296", 1},  {"0x", 1},       {"0xg", 3},
                {"0x12g4", 5},  {"0x123456789", 1}, {"-1", 1},         {"MAP", 4},         {"MAPabcde", 9}, {"MAPab!def", 6},
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
  const tests::Size sizes[] = {{8, 8}, {64, 32}, {100, 77}, {129, 9}};
  for (const tests::Size size : sizes) {
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
  for (const tests::Size size : {tests::Size{1, 1}, {64, 48}, {97, 13}, {300, 5}}) {
    const Torus torus = noise(size.width, size.height, 9);
    const std::string text = write_rle(torus, "MAPAP8A/w", "noise");
    CHECK(read(text, size.width, size.height) == torus);
    size_t longest = 0, line = 0;
    for (const char c : text) longest = std::max(longest, line = c == '\n' ? 0 : line + 1);
    CHECK(longest <= 70);
  }
  const Torus empty(20, 10);
  CHECK(read(write_rle(empty, "MAPAP8A/w", "nothing"), 20, 10) == empty);
  const Torus glider = read("#C by hand\r\n\r\n#N Glider\r\n x=3 ,y = 3, rule = B3/S23:T9,9 \r\nb A$\r\n2.\n#\no$ 3\to! and more", 5, 5);
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

TEST_CASE("What settles is what comes again") {
  uint32_t kinds[3] = {};
  for (uint32_t i = 0; i < 300; ++i) {
    const uint32_t program = random_program(i % 2 == 0 ? Style::uniform : Style::inertia, 11, i), steps = 150;
    Torus torus = noise(9, 7, i);
    std::vector<Torus> states = {torus};
    Settled expected{Settled::no, 0, 0};
    for (uint32_t step = 1; step <= steps; ++step) {
      states.push_back(stepped(states.back(), program));
      for (uint32_t back = 1; back <= std::min(step, 64u) && expected.kind == Settled::no; ++back)
        if (states[step - back] == states[step])
          expected = {back == 1 ? Settled::strong : Settled::weak, step - back, back};
    }
    const Settled settled = run(torus, program, steps);
    CHECK(settled.kind == expected.kind);
    CHECK(settled.step == expected.step);
    CHECK(settled.period == expected.period);
    CHECK(torus == states.back());
    ++kinds[settled.kind];
  }
  for (const uint32_t count : kinds) CHECK(count > 20);
}

TEST_CASE("A period of 64 is found, one of 65 is not") {
  Torus torus(64, 8), wider(65, 8);
  torus.set(3, 3, true);
  wider.set(3, 3, true);
  const Settled settled = run(torus, kLeft, 100);
  CHECK(settled.kind == Settled::weak);
  CHECK(settled.step == 0);
  CHECK(settled.period == 64);
  CHECK(torus.get(39, 3));  // 100 steps all the same
  CHECK(run(wider, kLeft, 200).kind == Settled::no);
  CHECK(run(wider, kLeft, 0).kind == Settled::no);
}

TEST_CASE("Logarithms and decimals") {
  CHECK(log2_q16(1) == 0);
  CHECK(log2_q16(1024) == 10 * 65536);
  CHECK(log2_q16(UINT64_C(1) << 32) == 32 * 65536);
  CHECK(log2_q16(3) == 103872);  // 1.5849625
  CHECK(log2_q16(1000000) == 1306250);  // 19.9315686
  for (uint64_t n = 1; n < 3000; ++n) CHECK(log2_q16(n) < log2_q16(n + 1));
  CHECK(decimal(65536) == "1.000");
  CHECK(decimal(-32768) == "-0.500");
  CHECK(decimal(-10) == "0.000");
  CHECK(decimal(22938) == "0.350");
}

TEST_CASE("The figures of plain pictures") {
  const Settled no{Settled::no, 0, 0};
  Torus chess(64, 64), stripes(64, 64);
  for (uint16_t y = 0; y < 64; ++y)
    for (uint16_t x = 0; x < 64; ++x) {
      chess.set(x, y, (x + y) % 2 != 0);
      stripes.set(x, y, y % 2 != 0);
    }
  const Score off = score_of(Torus(64, 64), kSelf, no), random = score_of(noise(256, 256, 1), kSelf, no);
  CHECK(off.density == 0);
  CHECK(off.entropy == 0);
  CHECK(off.correlation == 0);
  CHECK(!off.nice);
  CHECK(std::abs(random.density - kOne / 2) < 300);
  CHECK(random.entropy > kOne * 99 / 100);
  CHECK(random.disorder > kOne * 99 / 100);
  CHECK(std::abs(random.correlation) < 400);
  CHECK(random.activity == 0);
  CHECK(!random.nice);
  const Score c = score_of(chess, kLeft, no), s = score_of(stripes, kUpper ^ 0xffffffff, no);
  CHECK(c.density == kOne / 2);
  CHECK(c.entropy == 0);
  CHECK(c.correlation == -kOne);
  CHECK(c.activity == kOne);
  CHECK(!c.nice);
  CHECK(s.correlation == 0);  // 1 across, -1 down
  CHECK(s.activity == 0);
}

TEST_CASE("Almost one random program in five is nice") {
  uint32_t nice = 0, count = 500;
  const Torus start = noise(128, 128, 4);
  for (uint32_t i = 0; i < count; ++i) {
    Torus torus = start;
    const uint32_t program = random_program(Style::uniform, 21, i);
    const Settled settled = run(torus, program, 128);
    nice += score_of(torus, program, settled).nice;
  }
  CHECK(nice > count * 13 / 100);
  CHECK(nice < count * 25 / 100);
}

TEST_CASE("Styles are what they say") {
  std::set<uint32_t> totalistic;
  uint32_t kept = 0;
  for (uint32_t i = 0; i < 4000; ++i) {
    totalistic.insert(random_program(Style::outer_totalistic, 1, i));
    const uint32_t mirror = random_program(Style::mirror, 1, i);
    CHECK((mirror >> 16 & 0x00ff) == (mirror >> 8 & 0x00ff));            // left alone, right alone
    CHECK((mirror >> 4 & 0x0f0f) % 4 == (mirror >> 2 & 0x0f0f) % 4);     // upper alone, lower alone
    for (unsigned k = 0; k < 32; ++k) kept += (random_program(Style::inertia, 1, i) >> k & 1) == (k & 1);
  }
  CHECK(totalistic.size() > 900);
  CHECK(totalistic.size() <= 1024);
  CHECK(kept > 4000 * 32 * 74 / 100);
  CHECK(kept < 4000 * 32 * 76 / 100);
}

TEST_CASE("Turned, mirrored and inverted programs are one") {
  for (uint32_t i = 0; i < 200; ++i) {
    const uint32_t program = random_program(Style::uniform, 8, i);
    uint32_t turned = 0, inverted = 0;
    for (unsigned k = 0; k < 32; ++k) {
      const unsigned left = k >> 4 & 1, right = k >> 3 & 1, upper = k >> 2 & 1, lower = k >> 1 & 1;
      turned |= (program >> k & 1) << (16 * lower + 8 * upper + 4 * left + 2 * right + (k & 1));  // left becomes upper
      inverted |= (~program >> k & 1) << (31 - k);
    }
    CHECK(representative(turned) == representative(program));
    CHECK(representative(inverted) == representative(program));
    CHECK(representative(representative(program)) == representative(program));
    CHECK(representative(program) <= program);
    const Torus torus = noise(32, 32, i);
    Torus inverse(32, 32), transposed(32, 32);
    for (uint16_t y = 0; y < 32; ++y)
      for (uint16_t x = 0; x < 32; ++x) {
        inverse.set(x, y, !torus.get(x, y));
        transposed.set(y, x, torus.get(x, y));
      }
    CHECK(distance_of(patches_of(torus), patches_of(inverse)) == 0);
    CHECK(distance_of(patches_of(torus), patches_of(transposed)) == 0);
  }
}

TEST_CASE("A search finds different nice programs") {
  for (const Style style : {Style::uniform, Style::inertia, Style::mirror, Style::outer_totalistic}) {
    const std::vector<Found> found = search_nice({style, 5, 12, 64, 64, 64}, {});
    CHECK(found.size() == 12);
    std::set<uint32_t> all;
    for (const Found& one : found) {
      CHECK(one.score.nice);
      all.insert(representative(one.program));
    }
    CHECK(all.size() == found.size());
    for (size_t i = 1; i < found.size(); ++i) CHECK(found[i - 1].score.total >= found[i].score.total);
    const std::vector<Found> again = search_nice({style, 5, 12, 64, 64, 64}, {});
    for (size_t i = 0; i < found.size(); ++i) CHECK(again[i].program == found[i].program);
  }
}

TEST_CASE("Completion agrees with trying every state") {
  const tests::Size sizes[] = {{1, 1}, {2, 1}, {1, 3}, {2, 2}, {3, 2}, {3, 3}, {4, 3}};
  uint32_t answers[3] = {};
  for (const tests::Size size : sizes)
    for (uint32_t i = 0; i < 40; ++i) {
      const uint32_t program = random_program(Style::uniform, 13, i), cells = uint32_t{size.width} * size.height;
      bool exists = false;
      for (uint32_t state = 0; state < UINT32_C(1) << cells && !exists; ++state) {
        Torus torus(size.width, size.height);
        for (uint32_t k = 0; k < cells; ++k)
          torus.set(static_cast<uint16_t>(k % size.width), static_cast<uint16_t>(k / size.width), (state >> k & 1) != 0);
        exists = stepped(torus, program) == torus;
      }
      Completion completion(program, size.width, size.height);
      Effort effort;
      const Answer answer = completion.search(i, 1000000, effort);
      CHECK(answer == (exists ? Answer::stable : Answer::none));
      if (answer == Answer::stable) CHECK(completion.state().stable(program));
      ++answers[static_cast<int>(answer)];
    }
  CHECK(answers[0] > 50);
  CHECK(answers[1] > 50);
}

TEST_CASE("Completion decides every program on 7 x 7 cells") {
  uint64_t most = 0;
  uint32_t stable = 0;
  for (uint32_t i = 0; i < 300; ++i) {
    const uint32_t program = random_program(Style::uniform, 1, i);
    Completion completion(program, 7, 7);
    Effort effort;
    const Answer answer = completion.search(1, UINT64_MAX / 2, effort);
    CHECK(answer != Answer::unknown);
    if (answer == Answer::stable) CHECK(completion.state().stable(program));
    stable += answer == Answer::stable;
    most = std::max(most, effort.choices);
  }
  CHECK(most < 4000);  // about a millisecond for a thousand
  CHECK(stable > 240);
  CHECK(stable < 290);
}

TEST_CASE("Completion of larger tori: found, tiled, proved to be none, given up") {
  uint32_t answers[3] = {}, tiled = 0, plain = 0;
  for (uint32_t i = 0; i < 60; ++i) {
    const uint32_t program = random_program(Style::uniform, 17, i);
    const Completed done = find_stable(program, 48, 32, i, 3000);
    ++answers[static_cast<int>(done.answer)];
    CHECK(done.state.has_value() == (done.answer == Answer::stable));
    if (!done.state) continue;
    CHECK(done.state->stable(program));
    CHECK(48 % done.tile_width == 0);
    CHECK(32 % done.tile_height == 0);
    tiled += done.tile_width < 48 || done.tile_height < 32;
    plain += done.state->count() == 0 || done.state->count() == done.state->cells();
  }
  CHECK(answers[0] > 45);
  CHECK(answers[1] > 0);
  CHECK(tiled > 3);
  CHECK(plain < 12);
  // The same seed, the same state; another, another.
  const Torus one = *find_stable(0xcbc0abaa, 32, 32, 1, 100000).state;
  CHECK(one == *find_stable(0xcbc0abaa, 32, 32, 1, 100000).state);
  CHECK(!(one == *find_stable(0xcbc0abaa, 32, 32, 2, 100000).state));
  CHECK(find_stable(~kSelf, 32, 32, 1, 100).answer == Answer::none);  // every cell changes at every step
  CHECK(find_stable(kSelf, 9, 9, 1, 100).answer == Answer::stable);   // none ever does
}
