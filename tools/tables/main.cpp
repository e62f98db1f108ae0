// Makes the table of presets in README.md.
//   tables README.md           rewrites the part between the marks; times are measured here and now
//   tables --check README.md   fails when that part is not up to date, times aside
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "dapple.hpp"
#include "recipe/list.hpp"

namespace {

const char* const kBegin = "<!-- made by `build/tables README.md`; do not edit between the marks -->\n";
const char* const kEnd = "<!-- presets end -->\n";

// The best of five runs, 256 x 256 cells, in milliseconds.
double milliseconds(const dapple::Recipe& recipe) {
  const dapple::Domain domain = dapple::torus(256, 256);
  std::vector<uint8_t> memory(dapple::bytes_for(recipe, domain));
  double best = 0;
  for (int run = 0; run < 5; ++run) {
    dapple::Texture tile;
    if (tile.begin(recipe, domain, 1337, memory.data(), memory.size()) != dapple::ok) return 0;
    const auto start = std::chrono::steady_clock::now();
    tile.finish();
    const double time = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    best = run == 0 ? time : std::min(best, time);
  }
  return best;
}

// The least square tile in steps of eight cells.
uint16_t smallest_side(const dapple::Recipe& recipe) {
  uint16_t side = 8;
  while (dapple::bytes_for(recipe, dapple::torus(side, side)) == 0) side = static_cast<uint16_t>(side + 8);
  return side;
}

std::string table(bool timed) {
  std::ostringstream out;
  out << "| preset | what it shows | least side | RAM there | RAM 256 x 256 | time 256 x 256 |\n|---|---|---|---|---|---|\n";
  for (uint16_t i = 0; i < dapple::preset_count(); ++i) {
    char name[dapple::kMaxName], time[32] = "";
    const dapple::PresetEntry entry = dapple::preset_at(i, name);
    const dapple::Recipe recipe = dapple::load(*entry.preset);
    const uint16_t side = smallest_side(recipe);
    if (timed) {
      const double ms = milliseconds(recipe);
      std::snprintf(time, sizeof time, ms < 1 ? "%.2f ms" : "%.1f ms", ms);
    }
    out << "| " << entry.name << " | " << entry.sentence << " | " << side << " | "
        << dapple::bytes_for(recipe, dapple::torus(side, side)) << " | "
        << dapple::bytes_for(recipe, dapple::torus(256, 256)) << " | " << time << " |\n";
  }
  return out.str();
}

std::string read(const char* path) {
  std::ifstream in(path);
  std::ostringstream all;
  all << in.rdbuf();
  return all.str();
}

// The lines without their last column.
std::string untimed(const std::string& part) {
  std::istringstream in(part);
  std::string all;
  for (std::string line; std::getline(in, line);) all += line.substr(0, line.rfind('|', line.size() - 2)) + "\n";
  return all;
}

}  // namespace

int main(int count, char** words) {
  const bool check = count == 3 && std::strcmp(words[1], "--check") == 0;
  if (count != 2 && !check) return std::cerr << "usage: tables [--check] README.md\n", 2;
  const char* path = words[count - 1];
  const std::string text = read(path);
  const size_t begin = text.find(kBegin), end = text.find(kEnd);
  if (begin == std::string::npos || end == std::string::npos) return std::cerr << "tables: no marks in " << path << '\n', 1;
  const size_t from = begin + std::strlen(kBegin);
  if (check) {
    if (untimed(text.substr(from, end - from)) == untimed(table(false))) return 0;
    return std::cerr << "tables: " << path << " is not up to date; run build/tables " << path << '\n', 1;
  }
  const std::string made = text.substr(0, from) + table(true) + text.substr(end);
  std::ofstream(path) << made;
}
