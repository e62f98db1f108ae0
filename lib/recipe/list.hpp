// The list of all presets, and recipes as text. Links every model: for tools and desktops, not for one-preset firmware.
// SPDX-License-Identifier: MIT
#pragma once
#include "text.hpp"

namespace dapple {

struct PresetEntry {
  const char* name;      // with hyphens
  const char* sentence;
  const Preset* preset;
};

constexpr uint16_t kMaxName = 32;

uint16_t preset_count();
// Entry `index`; its name is written to `name` (kMaxName bytes).
PresetEntry preset_at(uint16_t index, char* name);
// By name, '-' and '_' alike; null if there is none.
const Preset* find_preset(const char* name);
Recipe load(const Preset& preset);

// Reads text: a whole recipe where it begins with a model's name, changes to `recipe` otherwise. On failure recipe is
// untouched and trouble says where and why.
Status parse(const char* text, Recipe& recipe, Trouble& trouble);

// Writes the line that parses to the same recipe. Returns the length it has; writes nothing beyond `size` bytes and
// always terminates (size > 0).
size_t write(const Recipe& recipe, char* text, size_t size);

}  // namespace dapple
