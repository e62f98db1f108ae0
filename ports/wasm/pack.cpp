// Packs the presets as text for the module; runs where the module is built and prints a header. The pair of symbols that comes
// most often becomes a symbol of its own, again and again [Gage 1994, A New Algorithm for Data Compression].
// SPDX-License-Identifier: MIT
#include <stdint.h>
#include <stdio.h>

namespace {

// Of every preset name, sentence and recipe, each ended by a zero.
constexpr char kPlain[] =
#define DAPPLE_PRESET(name, sentence, text) #name "\0" sentence "\0" text "\0"
#include "recipe/presets.def"
#undef DAPPLE_PRESET
    ;
constexpr uint32_t kPlainBytes = sizeof kPlain - 1;
constexpr uint32_t kRarest = 3;  // a pair that comes no more often than that costs what it saves

// Symbols: letters, 0 first, then pairs.
uint8_t text[kPlainBytes], letter[256], pair[256][2];
uint32_t length, letters, symbols, counts[256][256];

void spell() {
  uint8_t symbol[256] = {};
  letters = 1;
  for (char c : kPlain) {
    uint8_t& known = symbol[static_cast<uint8_t>(c)];
    if (c != 0 && known == 0) {
      letter[letters] = static_cast<uint8_t>(c);
      known = static_cast<uint8_t>(letters++);
    }
    if (length < kPlainBytes) text[length++] = known;
  }
  symbols = letters;
}

// Replaces the pair that comes most often, the first of those; false: there is none worth it.
bool replace_pair() {
  uint32_t most = kRarest;
  uint8_t* const made = pair[symbols];
  for (auto& row : counts)
    for (uint32_t& count : row) count = 0;
  for (uint32_t i = 1; i < length; ++i) {
    if (text[i - 1] == 0 || text[i] == 0 || ++counts[text[i - 1]][text[i]] <= most) continue;
    most = counts[text[i - 1]][text[i]];
    made[0] = text[i - 1];
    made[1] = text[i];
  }
  if (most == kRarest) return false;
  uint32_t to = 0;
  for (uint32_t from = 0; from < length; ++from) {
    const bool found = from + 1 < length && text[from] == made[0] && text[from + 1] == made[1];
    text[to++] = found ? static_cast<uint8_t>(symbols) : text[from];
    if (found) ++from;
  }
  length = to;
  ++symbols;
  return true;
}

void print(const char* declaration, const uint8_t* bytes, uint32_t count) {
  printf("constexpr uint8_t %s = {", declaration);
  for (uint32_t i = 0; i < count; ++i) printf("%s%u,", i % 24 == 0 ? "\n    " : "", bytes[i]);
  printf("\n};\n");
}

}  // namespace

int main() {
  spell();
  while (symbols < 256 && replace_pair()) {
  }
  printf("// made by ports/wasm/pack.cpp\n");
  print("kText[]", text, length);
  print("kLetters[]", letter, letters);
  print("kPairs[]", pair[letters], 2 * (symbols - letters));
  return 0;
}
