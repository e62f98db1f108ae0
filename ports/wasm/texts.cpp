// Prints every preset's name, sentence and recipe, each ended by a zero: what ports/wasm/build compresses for the module.
// SPDX-License-Identifier: MIT
#include <stdio.h>

constexpr char kTexts[] =
#define DAPPLE_PRESET(name, sentence, text) #name "\0" sentence "\0" text "\0"
#include "recipe/presets.def"
#undef DAPPLE_PRESET
    ;

int main() { return fwrite(kTexts, 1, sizeof kTexts - 1, stdout) == sizeof kTexts - 1 ? 0 : 1; }
