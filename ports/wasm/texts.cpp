// Prints what ports/wasm/build compresses for the module, ended by zeros: every preset's name, sentence and recipe; an empty
// text; the sentence about every number of every family.
// SPDX-License-Identifier: MIT
#include <stdio.h>

#include "dapple.hpp"
#include "recipe/text.hpp"

constexpr char kPresets[] =
#define DAPPLE_PRESET(name, sentence, text) #name "\0" sentence "\0" text "\0"
#include "recipe/presets.def"
#undef DAPPLE_PRESET
    ;

int main() {
  fwrite(kPresets, 1, sizeof kPresets, stdout);
  for (const dapple::recipe::Family& family : dapple::recipe::families) {
    for (uint8_t i = 0; i < family.number_count; ++i) printf("%s%c", family.numbers[i].unit, 0);
    for (uint8_t i = 0; i < map_numbers(family); ++i) printf("%s%c", dapple::along::units[i], 0);
  }
  return ferror(stdout) != 0 || fflush(stdout) != 0;
}
