// Recipes as the command line names them: a preset or a line of text, with changes.
// SPDX-License-Identifier: MIT
#pragma once
#include "options.hpp"
#include "recipe/list.hpp"

namespace cli {

struct Subject {
  std::string name;      // of the preset, "texture" for a line of text
  std::string sentence;  // empty for a line of text
  dapple::Recipe recipe;
  std::shared_ptr<const PictureMaps> maps = nullptr;  // of map=@FILE, style=@FILE: the recipe points to them
};

// Reads the subject and its changes; refuses what cannot be read.
Subject subject_of(const Options& options);

// Reads changes to a recipe; `where` says what the text is, for refusals.
void change(dapple::Recipe& recipe, const std::string& text, const std::string& where);

// The line that parses to the recipe.
std::string line_of(const dapple::Recipe& recipe);

const dapple::recipe::Family& family_of(const dapple::Recipe& recipe);

// Steps of all stages.
uint32_t steps_of(const dapple::Recipe& recipe);

// What the recipe needs on a grid; refuses sizes that do not do.
dapple::Need need_of(const Subject& subject, dapple::Domain domain, uint8_t bands);

// Says that a window of the plane, or every chunk of it, would need more halo than there may be.
[[noreturn]] void fail_for_halo(const Subject& subject, uint32_t halo);

// The names of a family's numbers, and of what every recipe has.
std::vector<std::string> keys_of(const dapple::recipe::Family& family);
std::vector<std::string> common_keys();

// 1/kMicro as decimal text.
std::string decimal_text(int32_t micro);

}  // namespace cli
