// Reading the parts of recipe text: numbers and words with their ranges, and where and why they are refused.
// SPDX-License-Identifier: MIT
#pragma once
#include "ramps.hpp"
#include "recipe.hpp"

namespace dapple {

// Where and why text was refused. `word` points into the text.
struct Trouble {
  Status status;
  uint16_t column;         // 1-based
  recipe::Word word;
  int32_t low, high;       // of out_of_range and unstable, in 1/kMicro, or plain for whole numbers
  bool whole;
  const char* allowed;     // of unknown_word: words separated by '|', or null; of unstable, not_possible: the number's name, or null
  int32_t value;           // of unstable: what it is, and low and high what it may be
};

}  // namespace dapple

namespace dapple::recipe {

// Text being read into a recipe.
struct Reader {
  Recipe* recipe;
  const Family* family;
  const char* origin;  // for columns
  Trouble trouble;
  uint8_t stage;       // the one being written; numbers go to it and all later ones
  int32_t wavelength;  // 0: not given
  uint32_t levels, fine;
  bool angle_given, angles_given, pairs_given, pitch_given, radius_given, solver_given;
  bool multigrid, was_multigrid;  // now asked for; what the recipe is that is changed
  int32_t first_angle, scale;  // before
  Word schedule, length;       // the last schedule and the last scale read
  Word spot;                   // spot_size
  int32_t spot_size;           // 0: not given
  bool aspect_given, coverage_given, steps_given, range_given;
};

DAPPLE_APART constexpr bool fail(Reader& r, Status status, Word word, int32_t low = 0, int32_t high = 0, bool whole = false, const char* allowed = nullptr) {
  r.trouble = {status, static_cast<uint16_t>(word.text - r.origin + 1), word, low, high, whole, allowed, 0};
  return false;
}

constexpr bool decimal_in(Reader& r, Word text, int32_t low, int32_t high, int32_t& value) {
  int32_t read = 0;
  if (!read_decimal(text, read)) return fail(r, broken_text, text);
  if (read < low || read > high) return fail(r, out_of_range, text, low, high);
  value = read;
  return true;
}

constexpr bool integer_in(Reader& r, Word text, uint32_t low, uint32_t high, uint32_t& value) {
  uint32_t read = 0;
  if (!read_integer(text, read)) return fail(r, broken_text, text);
  if (read < low || read > high) return fail(r, out_of_range, text, static_cast<int32_t>(low), static_cast<int32_t>(high), true);
  value = read;
  return true;
}

constexpr bool word_in(Reader& r, Word text, const char* words, int32_t& value) {
  const int16_t index = index_of(text, words);
  if (index < 0) return fail(r, unknown_word, text, 0, 0, false, words);
  value = index;
  return true;
}

// A | A:B@F | A:B@F..G
constexpr bool schedule_in(Reader& r, Word text, const Number& n, int32_t* slot) {
  Word rest = text;
  r.schedule = text;
  const Word from = take(rest, ':');
  if (!decimal_in(r, from, n.low, n.high, slot[0])) return false;
  slot[1] = slot[0];
  slot[2] = slot[3] = 0;
  if (from.length == text.length) return true;
  if (!decimal_in(r, take(rest, '@'), n.low, n.high, slot[1])) return false;
  uint16_t dots = 0;
  while (dots + 1 < rest.length && !(rest.text[dots] == '.' && rest.text[dots + 1] == '.')) ++dots;
  const bool ramp = dots + 1 < rest.length;
  const Word begin = ramp ? part(rest, 0, dots) : rest;
  const Word end = ramp ? part(rest, static_cast<uint16_t>(dots + 2), rest.length) : rest;
  return decimal_in(r, begin, 0, base::kMicro, slot[2]) && decimal_in(r, end, slot[2], base::kMicro, slot[3]);
}

constexpr bool angles_in(Reader& r, Word text, const Number& n, int32_t* slot) {
  uint8_t count = 0;
  for (Word rest = text; rest.length > 0 || count == 0; ++count) {
    if (count == 5) return fail(r, broken_text, text);
    if (!decimal_in(r, take(rest, ','), n.low, n.high, slot[count])) return false;
  }
  r.angle_given = true;
  r.angles_given = count > 1;
  return true;
}

constexpr bool number_in(Reader& r, Word text, const Number& n, int32_t* slot) {
  uint32_t whole = 0;
  switch (n.kind) {
    case Number::decimal: return decimal_in(r, text, n.low, n.high, *slot);
    case Number::integer:
      if (!integer_in(r, text, static_cast<uint32_t>(n.low), static_cast<uint32_t>(n.high), whole)) return false;
      *slot = static_cast<int32_t>(whole);
      r.pairs_given = true;
      return true;
    case Number::program:
      if (!read_program(text, whole)) return fail(r, broken_text, text);
      *slot = static_cast<int32_t>(whole);
      return true;
    case Number::word: return word_in(r, text, n.words, *slot);
    case Number::schedule: return schedule_in(r, text, n, slot);
    case Number::angles: return angles_in(r, text, n, slot);
  }
  return false;
}

}  // namespace dapple::recipe
