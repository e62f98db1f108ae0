// dapple sheet: every preset in one picture, or those that are wanted.
// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "contact.hpp"

namespace cli {

static std::vector<Subject> subjects(const Options& options) {
  std::vector<Subject> all;
  for (const std::string& wanted : options.wanted) {
    Options one = options;
    one.subject = wanted;
    all.push_back(subject_of(one));
  }
  if (!all.empty()) return all;
  for (uint16_t i = 0; i < dapple::preset_count(); ++i) {
    char name[dapple::kMaxName];
    const dapple::PresetEntry entry = dapple::preset_at(i, name);
    all.push_back({entry.name, entry.sentence, dapple::load(*entry.preset)});
  }
  return all;
}

void sheet(const Options& options) {
  const Target target = target_of(options, "sheet");
  const dapple::Domain domain = dapple::torus(options.width, options.height);
  const std::vector<Subject> all = subjects(options);
  for (const Subject& subject : all) need_of(subject, domain, 1);
  Contact contact(options, static_cast<uint32_t>(all.size()));
  Output out(target.path);
  Progress progress;
  for (const Subject& subject : all) {
    Tile tile(subject, domain, options.seed);
    tile.grow(options.budget, progress);
    contact.add(tile, subject.name);
  }
  contact.write(target, "sheet", (options.wanted.empty() ? "Every preset" : "Presets and recipes") + std::string(", seed ") + std::to_string(options.seed) + ", dapple " + version_text(), out);
}

}  // namespace cli
