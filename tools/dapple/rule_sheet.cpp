// dapple rule random: looks for nice programs, prints them, and writes a sheet of them with their numbers.
// SPDX-License-Identifier: MIT
#include <cstdio>

#include "commands.hpp"
#include "contact.hpp"
#include "errors.hpp"
#include "rule.hpp"
#include "rule_map.hpp"
#include "rule_search.hpp"

namespace cli {

namespace {

constexpr uint32_t kCount = 24, kSteps = 128;

void print_list(const std::vector<Found>& found, bool json) {
  for (const Found& f : found) {
    const Score& s = f.score;
    const char* const layout =
        json ? "%s{\"rule\": \"%s\", \"map\": \"%s\", \"score\": %s, \"density\": %s, \"entropy\": %s, "
               "\"disorder\": %s, \"correlation\": %s, \"activity\": %s, \"settles\": \"%s\"}"
             : "%s%s  %s  score %s  density %s  entropy %s  disorder %s  correlation %6s  activity %s  settles %s\n";
    const char* const before = !json ? "" : &f == &found.front() ? "[\n  " : ",\n  ";
    std::printf(layout, before, hexadecimal(f.program).c_str(), map_of(f.program).c_str(), decimal(s.total).c_str(),
                decimal(s.density).c_str(), decimal(s.entropy).c_str(), decimal(s.disorder).c_str(),
                decimal(s.correlation).c_str(), decimal(s.activity).c_str(), name_of(s.settled.kind));
  }
  if (json) std::printf(found.empty() ? "[]\n" : "\n]\n");
  finish_standard_output();
}

}  // namespace

void rule_random(const Options& options) {
  const uint32_t steps = options.steps.value_or(kSteps), count = options.count.value_or(kCount);
  const Target target = target_of(options, "rules");
  if (target.path == "-") refuse("-o -: standard output is for the list of programs; give a file");
  const auto said = [](size_t tiles) { return ", --count " + std::to_string(tiles); };
  Contact(options, count, said(count));
  Output out(target.path);
  Progress progress;
  const Style style = static_cast<Style>(options.style.value_or(static_cast<uint8_t>(Style::inertia)));
  const std::vector<Found> found =
      search_nice({style, options.seed, count, steps, options.width, options.height},
                  [&](uint64_t done, uint64_t all) { progress.show("random programs", done, all); });
  if (found.empty()) fail("no nice program was found; try another --seed or --style");
  Contact contact(options, static_cast<uint32_t>(found.size()), said(found.size()));
  for (const Found& f : found) {
    Subject subject = rule_subject(options, f.program);
    change(subject.recipe, "steps=" + std::to_string(steps), "--steps");
    Tile tile(subject, dapple::torus(options.width, options.height), options.seed);
    tile.grow(options.budget, progress);
    contact.add(tile, hexadecimal(f.program));
  }
  contact.write(target, "rules", "Cell programs, seed " + std::to_string(options.seed) + ", dapple " + version_text(), out);
  print_list(found, options.json);
}

}  // namespace cli
