// The presets, each a constant in read-only memory: firmware that names one links one.
// SPDX-License-Identifier: MIT
#pragma once
#include "text.hpp"

namespace dapple::presets {

#define DAPPLE_PRESET(name, sentence, text)                          \
  inline constexpr Preset name DAPPLE_ROM = recipe::preset(text);    \
  static_assert(name.recipe.stages > 0, "this preset's recipe is refused: " text);
#include "presets.def"
#undef DAPPLE_PRESET

}  // namespace dapple::presets
