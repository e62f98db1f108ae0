// Prints or records the golden hashes of presets: one line `name WxH seed field rgba8888` per preset and size.
//   golden                      print the lines of every preset
//   golden NAME ...             print the lines of some
//   golden --plane              print the lines of windows in blocks: name X,Y WxH seed field rgba8888
//   golden --add FILE NAME ...  put the lines of some into FILE in place of the ones it has
// SPDX-License-Identifier: MIT
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "../../tests/grow.hpp"

namespace {

std::vector<std::string> lines_of(const char* name) {
  std::vector<std::string> lines;
  const dapple::Recipe recipe = dapple::load(*dapple::find_preset(name));
  for (const tests::Size wanted : tests::kGoldenSizes) {
    const tests::Size size = tests::fitting(wanted, recipe);
    tests::Grown tile(recipe, dapple::torus(size.width, size.height), tests::kGoldenSeed);
    char line[128];
    std::snprintf(line, sizeof line, "%s %ux%u %u %016" PRIx64 " %016" PRIx64, name, unsigned(size.width),
                  unsigned(size.height), unsigned(tests::kGoldenSeed), tile.field_hash(), tile.paint_hash());
    lines.push_back(line);
  }
  return lines;
}

void print_windows(const std::string& name) {
  const dapple::Recipe recipe = dapple::load(*dapple::find_preset(name.c_str()));
  if (!tests::in_blocks(recipe)) return;
  for (const dapple::Domain& d : tests::kGoldenWindows) {
    tests::Grown tile(recipe, d, tests::kGoldenSeed);
    std::printf("%s %d,%d %ux%u %u %016" PRIx64 " %016" PRIx64 "\n", name.c_str(), int(d.x), int(d.y), unsigned(d.width),
                unsigned(d.height), unsigned(tests::kGoldenSeed), tile.field_hash(), tile.paint_hash());
  }
}

std::vector<std::string> every_name() {
  std::vector<std::string> names;
  for (uint16_t i = 0; i < dapple::preset_count(); ++i) {
    char name[dapple::kMaxName];
    names.push_back(dapple::preset_at(i, name).name);
  }
  return names;
}

int add(const char* path, const std::vector<std::string>& names) {
  std::vector<std::string> kept;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    bool replaced = false;
    for (const std::string& name : names) replaced = replaced || line.rfind(name + " ", 0) == 0;
    if (!replaced) kept.push_back(line);
  }
  in.close();
  for (const std::string& name : names)
    for (const std::string& line : lines_of(name.c_str())) kept.push_back(line);
  std::ofstream out(path);
  for (const std::string& line : kept) out << line << '\n';
  out.close();
  if (out) return 0;
  std::cerr << "golden: cannot write " << path << '\n';
  return 1;
}

}  // namespace

int main(int count, char** words) {
  if (count == 2 && std::strcmp(words[1], "--plane") == 0) {
    for (const std::string& name : every_name()) print_windows(name);
    return 0;
  }
  const bool adding = count > 3 && std::strcmp(words[1], "--add") == 0;
  std::vector<std::string> names(words + (adding ? 3 : 1), words + count);
  if (names.empty()) names = every_name();
  for (const std::string& name : names)
    if (dapple::find_preset(name.c_str()) == nullptr) {
      std::cerr << "golden: no preset is called " << name << '\n';
      return 2;
    }
  if (adding) return add(words[2], names);
  for (const std::string& name : names)
    for (const std::string& line : lines_of(name.c_str())) std::cout << line << '\n';
}
