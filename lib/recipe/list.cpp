// Every preset by name.
// SPDX-License-Identifier: MIT
#include "list.hpp"

#include "presets.hpp"

namespace dapple {

static const PresetEntry kPresets[] = {
#define DAPPLE_PRESET(name, sentence, text) {#name, sentence, &presets::name},
#include "presets.def"
#undef DAPPLE_PRESET
};

uint16_t preset_count() { return static_cast<uint16_t>(sizeof kPresets / sizeof kPresets[0]); }

PresetEntry preset_at(uint16_t index, char* name) {
  PresetEntry entry = kPresets[index];
  uint16_t i = 0;
  for (; entry.name[i] != 0 && i + 1 < kMaxName; ++i) name[i] = entry.name[i] == '_' ? '-' : entry.name[i];
  name[i] = 0;
  entry.name = name;
  return entry;
}

const Preset* find_preset(const char* name) {
  for (const PresetEntry& entry : kPresets) {
    uint16_t i = 0;
    while (name[i] != 0 && (entry.name[i] == name[i] || (entry.name[i] == '_' && name[i] == '-'))) ++i;
    if (name[i] == 0 && entry.name[i] == 0) return entry.preset;
  }
  return nullptr;
}

Recipe load(const Preset& preset) { return base::rom_load(&preset.recipe); }

Status parse(const char* text, Recipe& recipe, Trouble& trouble) {
  Recipe copy = recipe;
  const Status status = recipe::read(text, copy, trouble);
  if (status == ok) recipe = copy;
  return status;
}

}  // namespace dapple
