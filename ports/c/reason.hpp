// Why something was refused, as one sentence in a buffer of fixed size.
// SPDX-License-Identifier: MIT
#pragma once
#include "dapple.h"
#include "dapple.hpp"
#include "recipe/list.hpp"

namespace dapple::c {

// A sentence being written; what does not fit is left out.
struct Sentence {
  char* text;
  size_t size, length;
};

static void put(Sentence& s, char c) {
  if (s.length + 1 >= s.size) return;
  s.text[s.length++] = c;
  s.text[s.length] = 0;
}

static void put(Sentence& s, const char* text) {
  while (*text != 0) put(s, *text++);
}

static void put(Sentence& s, uint64_t value) {
  char digits[20];
  uint8_t n = 0;
  do {
    digits[n++] = static_cast<char>('0' + value % 10);
    value /= 10;
  } while (value != 0);
  while (n > 0) put(s, digits[--n]);
}

static void put_limit(Sentence& s, int32_t limit, bool whole) {
  const int64_t one = whole ? 1 : base::kMicro;
  const int64_t value = limit < 0 ? -static_cast<int64_t>(limit) : limit;
  if (limit < 0) put(s, '-');
  put(s, static_cast<uint64_t>(value / one));
  int64_t rest = value % one;
  if (rest != 0) put(s, '.');
  for (int64_t place = one / 10; rest != 0; place /= 10) {
    put(s, static_cast<char>('0' + rest / place));
    rest %= place;
  }
}

// The word between quotes, its first forty characters, what is not plain ASCII as '?'.
static void put_shown(Sentence& s, recipe::Word word) {
  constexpr uint16_t kMost = 40;
  put(s, '\'');
  for (uint16_t i = 0; i < word.length && i < kMost; ++i)
    put(s, word.text[i] >= ' ' && word.text[i] <= '~' ? word.text[i] : '?');
  put(s, word.length > kMost ? "...'" : "'");
}

static bool names_family(const char* name) {
  return name != nullptr && recipe::family_named(recipe::word_of(name)) >= 0;
}

static void say_unknown(Sentence& s, const Trouble& trouble) {
  put_shown(s, trouble.word);
  if (trouble.allowed == nullptr) return put(s, " is no preset and no model");
  put(s, names_family(trouble.allowed) ? " is not a key of " : " is not one of ");
  put(s, trouble.allowed);
}

static void say_broken(Sentence& s, const Trouble& trouble, bool begins_word) {
  if (trouble.word.length == 0) return put(s, "a value is missing");
  put_shown(s, trouble.word);
  put(s, begins_word ? " is not key=value"
                     : " is not what this key takes; numbers have at most six digits after the point");
}

// What parse says of `text`. Only what several numbers bring about has the whole text for a word.
static void explain(Sentence& s, const Trouble& trouble, const char* text) {
  const size_t at = trouble.column - size_t{1};
  switch (trouble.status) {
    case unknown_word:
      return say_unknown(s, trouble);
    case broken_text:
      return say_broken(s, trouble, at == 0 || text[at - 1] == ' ');
    case out_of_range:
      if (at == 0) put(s, "the wavelength, scale or rho that follows from this");
      else put_shown(s, trouble.word);
      put(s, " is out of range: ");
      put_limit(s, trouble.low, trouble.whole);
      put(s, " to ");
      return put_limit(s, trouble.high, trouble.whole);
    case unstable: {
      const bool least = trouble.value < trouble.low;
      put(s, trouble.allowed);
      put(s, least ? " is too small for the stage's grid; the least is " : " makes the steps diverge; the most is ");
      return put_limit(s, least ? trouble.low : trouble.high, false);
    }
    default:
      put_shown(s, trouble.word);
      return put(s, " does not go with the other words");
  }
}

// What begin says.
static void explain(Sentence& s, const Need& need) {
  switch (need.status) {
    case bad_side:
      return put(s, "sides are 8 to 65535 cells");
    case not_a_multiple:
      put(s, "sides must be multiples of ");
      return put(s, uint64_t{need.multiple});
    case tile_too_small:
      put(s, "the torus must have at least ");
      put(s, uint64_t{need.width});
      put(s, " x ");
      put(s, uint64_t{need.height});
      return put(s, " cells");
    case too_little_memory:
      put(s, "the texture needs ");
      put(s, uint64_t{need.bytes});
      return put(s, " bytes of memory");
    case too_large:
      return put(s, "the texture does not fit the address space, or its sides with halo 65000 cells");
    case too_far:
      return put(s, "windows lie within 2^30 - 2048 cells of the origin");
    case halo_too_wide:
      put(s, "the window would be grown with ");
      put(s, uint64_t{need.halo});
      put(s, " more cells on every side; the most are ");
      return put(s, uint64_t{kWidestHalo});
    case unstable:
      return put(s, "a number makes the steps diverge, or is too small for the stage's grid");
    case bad_map:
      return put(s, "map=image, solver=styled, solver=pictured and grade=image need images, 1 to 256 cells a side");
    case bad_sides:
      return put(s, "a recipe with sides needs a patch, which is for C++");
    case bad_surface:
      return put(s, "solver=surface needs a surface, which is for C++");
    case no_coverage:
      return put(s, "coverage= is a share of a whole tile, of which the endless plane has none");
    default:
      return put(s, "the stages do not fit each other, or the last is not on the finest grid");
  }
}

}  // namespace dapple::c
