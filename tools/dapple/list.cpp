// dapple list: every preset, a line each.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>

#include "commands.hpp"
#include "recipes.hpp"

namespace cli {

struct Entry {
  std::string name, family, sentence, recipe;
};

static std::vector<Entry> entries() {
  std::vector<Entry> all;
  for (uint16_t i = 0; i < dapple::preset_count(); ++i) {
    char name[dapple::kMaxName];
    const dapple::PresetEntry entry = dapple::preset_at(i, name);
    const dapple::Recipe recipe = dapple::load(*entry.preset);
    all.push_back({entry.name, family_of(recipe).name, entry.sentence, line_of(recipe)});
  }
  return all;
}

static void print_json(const std::vector<Entry>& all) {
  std::printf("[\n");
  for (const Entry& e : all)
    std::printf("  {\"name\": %s, \"family\": %s, \"sentence\": %s, \"recipe\": %s}%s\n", json_text(e.name).c_str(),
                json_text(e.family).c_str(), json_text(e.sentence).c_str(), json_text(e.recipe).c_str(),
                &e == &all.back() ? "" : ",");
  std::printf("]\n");
}

void list(const Options& options) {
  const std::vector<Entry> all = entries();
  if (options.json) {
    print_json(all);
  } else {
    int names = 0, families = 0;
    for (const Entry& e : all) {
      names = std::max(names, static_cast<int>(e.name.size()));
      families = std::max(families, static_cast<int>(e.family.size()));
    }
    for (const Entry& e : all)
      std::printf("%-*s  %-*s  %s\n", names, e.name.c_str(), families, e.family.c_str(), e.sentence.c_str());
  }
  finish_standard_output();
}

std::string json_text(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

}  // namespace cli
