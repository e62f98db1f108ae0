// Speed, as figures beside plain reference loops measured in the same minutes: each line alternates between the two and
// prints the best of both and their ratio. Portable kernels, one core.
//   bench [NAME ...]    lines whose name contains one of the words
//   bench --solvers     the tables of docs/bench/solvers.md
//   bench --grids       kinetics over three grids and over one
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "chunks.hpp"
#include "recipe/list.hpp"
#include "solvers.hpp"

namespace {

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

dapple::Recipe recipe_of(const std::string& name, const std::string& changes) {
  dapple::Recipe recipe{};
  dapple::Trouble trouble{};
  const dapple::Preset* preset = dapple::find_preset(name.c_str());
  if (preset != nullptr) recipe = dapple::load(*preset);
  else dapple::parse(name.c_str(), recipe, trouble);
  if (!changes.empty()) dapple::parse(changes.c_str(), recipe, trouble);
  return recipe;
}

// Grows a texture again and again in the same memory.
struct Ours {
  dapple::Recipe recipe;
  dapple::Domain domain;
  std::vector<uint8_t> memory;
  bool field;  // also every row of the field

  Ours(const std::string& name, const std::string& changes, dapple::Domain d, bool rows = false)
      : recipe(recipe_of(name, changes)), domain(d), memory(dapple::bytes_for(recipe, d)), field(rows) {}
  void operator()() {
    dapple::Texture tile;
    if (tile.begin(recipe, domain, 1337, memory.data(), memory.size()) != dapple::ok) return;
    tile.finish();
    std::vector<int16_t> row(domain.width);
    for (uint16_t y = 0; field && y < domain.height; ++y) tile.row(y, row.data());
  }
};

// A square of the plane through a fresh cache, chunk by chunk from the middle on.
struct Patch {
  dapple::Recipe recipe;
  uint16_t side, across;
  std::vector<uint8_t> memory;

  Patch(const std::string& name, uint16_t chunk, uint16_t count)
      : recipe(recipe_of(name, "")), side(chunk), across(count),
        memory(dapple::chunk_bytes(recipe, side, static_cast<uint16_t>(across * across), dapple::Pixels::rgb888)) {}
  void operator()() {
    dapple::Chunks chunks;
    dapple::Brush brush;
    brush.format = dapple::Pixels::rgb888;
    if (chunks.begin(recipe, 1337, side, static_cast<uint16_t>(across * across), brush, memory.data(), memory.size()) != dapple::ok) return;
    const uint16_t wide = static_cast<uint16_t>(side * across);
    if (chunks.look_at(40 * side, -3 * side, wide, wide) == dapple::ok) chunks.finish();
  }
};

// --- reference loops: what one would write first -------------------------------------------------------------------

// A Gray-Scott step of two float planes of 256 x 256, the torus by masking indices, ten times.
void float_gray_scott() {
  static std::vector<float> u(256 * 256, 1.0f), v(256 * 256, 0.01f), u2(256 * 256), v2(256 * 256);
  for (int step = 0; step < 10; ++step) {
    for (int y = 0; y < 256; ++y)
      for (int x = 0; x < 256; ++x) {
        const int c = y * 256 + x, l = y * 256 + ((x - 1) & 255), r = y * 256 + ((x + 1) & 255);
        const int a = ((y - 1) & 255) * 256 + x, b = ((y + 1) & 255) * 256 + x;
        const float react = u[c] * v[c] * v[c];
        u2[c] = u[c] + 0.16f * (u[l] + u[r] + u[a] + u[b] - 4 * u[c]) - react + 0.0367f * (1 - u[c]);
        v2[c] = v[c] + 0.08f * (v[l] + v[r] + v[a] + v[b] - 4 * v[c]) + react - 0.1016f * v[c];
      }
    u.swap(u2);
    v.swap(v2);
  }
}

// Byte cells, the program looked up, 1024 x 1024, once.
void byte_program() {
  static std::vector<uint8_t> from(1024 * 1024, 1), to(1024 * 1024);
  const uint32_t program = 0xB5A3C96Eu;
  for (int y = 0; y < 1024; ++y)
    for (int x = 0; x < 1024; ++x) {
      const auto at = [&](int dx, int dy) { return from[((y + dy) & 1023) * 1024 + ((x + dx) & 1023)]; };
      to[y * 1024 + x] = (program >> (16 * at(-1, 0) + 8 * at(1, 0) + 4 * at(0, -1) + 2 * at(0, 1) + at(0, 0))) & 1;
    }
  from.swap(to);
}

// Byte cells, 13 x 13 int weights added up, 256 x 256, once.
void byte_convolution() {
  static std::vector<uint8_t> from(256 * 256, 1), to(256 * 256);
  static int weight[169] = {1, -1};
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x) {
      int sum = 0;
      for (int k = 0; k < 169; ++k) sum += weight[k] * from[((y + k / 13 - 6) & 255) * 256 + ((x + k % 13 - 6) & 255)];
      to[y * 256 + x] = sum > 0;
    }
  from.swap(to);
}

struct Line {
  std::string name, unit;
  double ours_cells, reference_cells;  // cell updates (or pixels) of one run; unit ms: 0
  std::function<void()> ours, reference;
};

void print(const Line& line) {
  double ours = 1e9, reference = 1e9;
  for (int round = 0; round < 9; ++round) {
    ours = std::min(ours, seconds(line.ours));
    reference = std::min(reference, seconds(line.reference));
  }
  if (line.ours_cells == 0) {
    std::printf("%-34s %9.2f ms      = %.1f steps of a float Gray-Scott loop\n", line.name.c_str(), ours * 1e3, 10 * ours / reference);
  } else {
    const double a = line.ours_cells / ours / 1e9, b = line.reference_cells / reference / 1e9;
    std::printf("%-34s %9.3f %s  %8.1f times the reference loop\n", line.name.c_str(), a, line.unit.c_str(), a / b);
  }
  std::fflush(stdout);
}

std::vector<Line> lines() {
  const dapple::Domain square = dapple::torus(256, 256);
  const std::string cells = "Gcell/s";
  std::vector<Line> all;
  for (uint16_t i = 0; i < dapple::preset_count(); ++i) {
    char name[dapple::kMaxName];
    dapple::preset_at(i, name);
    all.push_back({std::string(name) + " 256x256", "", 0, 0, Ours(name, "", square), float_gray_scott});
  }
  all.push_back({"zebra levels=2 256x256", "", 0, 0, Ours("zebra", "levels=2", square), float_gray_scott});
  all.push_back({"gray-scott 256x256", cells, 200.0 * 65536, 10.0 * 65536, Ours("mitosis", "steps=200", square), float_gray_scott});
  all.push_back({"turing 256x256", cells, 200.0 * 65536, 10.0 * 65536, Ours("turing", "steps=200", square), float_gray_scott});
  for (const char* name : {"zebra-bits", "weave-bits", "maze-bits", "labyrinth-bits", "coral-bits", "fingerprint"})
    all.push_back({std::string("convolution ") + name, cells, 40.0 * 65536, 65536, Ours(name, "level=0 steps=40", square), byte_convolution});
  all.push_back({"cell program 1024x1024", cells, 50.0 * 1048576, 1048576, Ours("cells rule=0xB5A3C96E", "steps=50", dapple::torus(1024, 1024)), byte_program});
  all.push_back({"plane, 128x128 pixels zebra-bits", "Gpixel/s", 16384, 65536, Ours("zebra-bits", "", dapple::window(5000, -700, 128, 128), true), byte_convolution});
  for (const char* name : {"zebra", "giraffe", "reptile", "maze"})
    all.push_back({std::string("plane, 8x8 of 128x128 ") + name, "", 0, 0, Patch(name, 128, 8), float_gray_scott});
  return all;
}

}  // namespace

int main(int count, char** words) {
  if (count == 2 && std::strcmp(words[1], "--solvers") == 0) return print_solvers(), 0;
  if (count == 2 && std::strcmp(words[1], "--grids") == 0) return print_grids(), 0;
  for (const Line& line : lines()) {
    bool wanted = count == 1;
    for (int i = 1; i < count; ++i) wanted = wanted || line.name.find(words[i]) != std::string::npos;
    if (wanted) print(line);
  }
}
