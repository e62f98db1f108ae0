// Every table of ports/desktop that this processor can run has the bytes of the portable kernels: all goldens, rows of
// every width, tori and windows whose width is no multiple of anything.
// SPDX-License-Identifier: MIT
#include "../goldens.hpp"
#include "each_table.hpp"
#include "rows.hpp"

namespace desktop = dapple::desktop;

namespace {

// Calls back for every table but the portable one.
template <class Work>
void each_table(const Work& work) {
  tests::each_table(work, 1);
}

#ifdef __x86_64__
// What Linux says of the processor; nothing elsewhere.
std::string processor_flags() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (line.rfind("flags", 0) == 0) return line + " ";
  return "";
}
#endif

constexpr uint32_t kSeed = 11;
constexpr const char* kRecipes[] = {
    "bits masks=1 level=0 steps=6",
    "bits masks=1 diffusion=isotropic level=0 window=5 rho=0.2 steps=5",
    "bits masks=3 angles=10,70,130 window=8 level=0 rho=0.2 steps=4",
    "bits masks=2 react=da angles=0,90 level=0 steps=5",
    "bits masks=5 react=da angles=0,36,72,108,144 level=0 steps=3",
    "bits masks=3 angles=10,70,130 solver=lean level=0 rho=0.2 steps=4",
    "bits masks=3 react=da angles=0,60,120 solver=lean level=0 steps=3",
    "flow threads=2 angles=0,90 level=0 steps=3",
    "cells rule=0xB5A3C96E steps=9",
    "cells rule=0x12345678 steps=9",
};

}  // namespace

TEST_CASE("desktop: the first table is the portable one, the best one runs, names find tables") {
  CHECK(std::string(desktop::table_at(0).name) == "portable");
  CHECK(desktop::table_at(0).kernels == nullptr);
  CHECK(desktop::best_table().runs());
  for (uint8_t i = 0; i < desktop::table_count(); ++i)
    CHECK(desktop::table_named(desktop::table_at(i).name) == &desktop::table_at(i));
  CHECK(desktop::table_named("sse") == nullptr);
  CHECK(desktop::table_named("") == nullptr);
}

#ifdef __x86_64__
TEST_CASE("desktop: on x86-64 there are three tables, and AVX2's runs where the processor has what it takes") {
  CHECK(desktop::table_count() == 3);
  REQUIRE(desktop::table_named("sse2") != nullptr);
  REQUIRE(desktop::table_named("avx2") != nullptr);
  CHECK(desktop::table_named("sse2")->runs());
  const std::string flags = processor_flags();
  if (flags.empty()) return;
  bool all = true;
  for (const char* flag : {" avx2 ", " bmi1 ", " bmi2 ", " fma "}) all = all && flags.find(flag) != std::string::npos;
  CHECK(desktop::table_named("avx2")->runs() == all);
  CHECK(std::string(desktop::best_table().name) == (all ? "avx2" : "sse2"));
}
#endif

TEST_CASE("desktop: every table has the goldens") {
  const std::vector<tests::Golden> goldens = tests::fewer_goldens();
  each_table([&](const desktop::Table& table) {
    for (const tests::Golden& g : goldens) {
      const dapple::Recipe recipe = tests::preset(g.name);
      dapple::Options options;
      options.kernels = table.kernels;
      const dapple::Domain domain = dapple::torus(static_cast<uint16_t>(g.width), static_cast<uint16_t>(g.height));
      tests::Grown tile(recipe, domain, g.seed, UINT32_MAX, options);
      REQUIRE(tile.status == dapple::ok);
      CAPTURE(std::string(g.name));
      CHECK(tile.field_hash() == g.field);
      CHECK(tile.paint_hash() == g.pixels);
    }
  });
}

TEST_CASE("desktop: rows of 1 to 130 cells at every offset") {
  std::vector<uint32_t> memory(kRowsMemory / 4);
  each_table([&](const desktop::Table& table) {
    uint32_t compared = 0;
    for (const dapple::grid::KernelSwap* swap = table.kernels; swap->portable != nullptr; ++swap) {
      const RowsCompared rows = compare_rows(*swap, memory.data());
      compared += rows.equal;
      if (rows.equal > 0) CHECK(rows.different == 0);
    }
    CHECK(compared >= 5 * 130 * 8);
  });
}

TEST_CASE("desktop: one-bit cells on tori and windows of any width, bands, budgets") {
  each_table([&](const desktop::Table& table) {
    for (const char* text : kRecipes) {
      const dapple::Recipe recipe = tests::recipe_of(text);
      CAPTURE(std::string(text));
      for (uint16_t width = 60; width < 620; width = static_cast<uint16_t>(width * 9 / 7)) {
        CAPTURE(width);
        for (const dapple::Domain& domain : {dapple::torus(width, 67), dapple::window(3 * width, -500, width, 40)}) {
          const uint64_t want = tests::field_hash_of(recipe, domain, kSeed);
          REQUIRE(want != 0);
          dapple::Options options;
          options.kernels = table.kernels;
          CHECK(tests::field_hash_of(recipe, domain, kSeed, options) == want);
          options.bands = 3;
          CHECK(tests::field_hash_of(recipe, domain, kSeed, options, 17) == want);
        }
      }
    }
  });
}
