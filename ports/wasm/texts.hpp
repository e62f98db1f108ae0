// The presets as text, packed by pack.cpp: a symbol is a letter, or a pair of symbols that comes again and again. 5 KB in place
// of 12.
// SPDX-License-Identifier: MIT
#pragma once
#include <stdint.h>

namespace texts {

#include "texts_packed.hpp"

inline char* write(uint8_t symbol, char* out) {
  while (symbol >= sizeof kLetters) {
    const uint8_t* const pair = kPairs + 2 * (symbol - sizeof kLetters);
    out = write(pair[0], out);
    symbol = pair[1];
  }
  *out = static_cast<char>(kLetters[symbol]);
  return out + 1;
}

// Writes text `index`, of every preset its name, sentence and recipe, with its zero to `out`; false: there are not as many.
inline bool unpack(int32_t index, char* out) {
  const uint8_t* from = kText;
  const uint8_t* const end = kText + sizeof kText;
  for (; index > 0 && from < end; ++from)
    if (*from == 0) --index;
  if (from == end) return false;
  do out = write(*from, out);
  while (*from++ != 0);
  return true;
}

}  // namespace texts
