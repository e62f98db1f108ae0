// Words and decimal numbers of recipe text, by integer code; constexpr, so that presets are text too.
// SPDX-License-Identifier: MIT
#pragma once
#include "../base/fixed.hpp"
#include "../base/status.hpp"

namespace dapple::recipe {

// A stretch of text, not terminated.
struct Word {
  const char* text;
  uint16_t length;
};

constexpr uint16_t kMaxText = 4000;  // characters of a recipe's line; what is behind them is not read

constexpr uint16_t length_of(const char* text) {
  uint16_t n = 0;
  while (n < kMaxText && text[n] != 0) ++n;
  return n;
}
constexpr Word word_of(const char* text) { return {text, length_of(text)}; }

constexpr bool equal(Word a, Word b) {
  if (a.length != b.length) return false;
  for (uint16_t i = 0; i < a.length; ++i)
    if (a.text[i] != b.text[i]) return false;
  return true;
}
constexpr bool equal(Word a, const char* b) { return equal(a, word_of(b)); }

constexpr Word part(Word w, uint16_t from, uint16_t to) { return {w.text + from, static_cast<uint16_t>(to - from)}; }

// Index of the first `mark` from `from` on, or the length.
constexpr uint16_t find(Word w, char mark, uint16_t from = 0) {
  while (from < w.length && w.text[from] != mark) ++from;
  return from;
}

// Splits off what stands before the next `mark`; `rest` keeps what is behind it.
constexpr Word take(Word& rest, char mark) {
  const uint16_t at = find(rest, mark);
  const Word head = part(rest, 0, at);
  rest = at < rest.length ? part(rest, static_cast<uint16_t>(at + 1), rest.length) : part(rest, at, at);
  return head;
}

// Index of `name` among words separated by '|', or -1.
constexpr int16_t index_of(Word name, const char* words) {
  Word rest = word_of(words);
  for (int16_t i = 0; rest.length > 0; ++i)
    if (equal(take(rest, '|'), name)) return i;
  return -1;
}

constexpr bool digit(char c) { return c >= '0' && c <= '9'; }

// Decimal text to 1/kMicro: sign, digits, at most six digits after the point; exact. false: not such a number.
constexpr bool read_decimal(Word w, int32_t& value) {
  uint16_t i = 0;
  const bool negative = w.length > 0 && w.text[0] == '-';
  if (negative) ++i;
  int64_t sum = 0;
  uint8_t digits = 0, after = 0;
  bool point = false;
  for (; i < w.length; ++i) {
    if (w.text[i] == '.' && !point) {
      point = true;
    } else if (digit(w.text[i])) {
      if (point && after++ == 6) return false;
      ++digits;
      sum = sum * 10 + (w.text[i] - '0');
      if (sum > INT64_C(4000000000000000)) return false;
    } else {
      return false;
    }
  }
  for (; after < 6; ++after) sum *= 10;
  if (digits == 0 || sum > INT32_MAX) return false;
  value = static_cast<int32_t>(negative ? -sum : sum);
  return true;
}

// Decimal digits only.
constexpr bool read_integer(Word w, uint32_t& value) {
  uint64_t sum = 0;
  if (w.length == 0) return false;
  for (uint16_t i = 0; i < w.length; ++i) {
    if (!digit(w.text[i])) return false;
    sum = sum * 10 + static_cast<uint64_t>(w.text[i] - '0');
    if (sum > UINT32_MAX) return false;
  }
  value = static_cast<uint32_t>(sum);
  return true;
}

constexpr int8_t hex_digit(char c) {
  return static_cast<int8_t>(digit(c) ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1);
}

// 32 bits as decimal digits, or as 0x and up to eight hexadecimal ones.
constexpr bool read_program(Word w, uint32_t& value) {
  if (w.length < 3 || w.text[0] != '0' || w.text[1] != 'x') return read_integer(w, value);
  if (w.length > 10) return false;
  value = 0;
  for (uint16_t i = 2; i < w.length; ++i) {
    if (hex_digit(w.text[i]) < 0) return false;
    value = value * 16 + static_cast<uint32_t>(hex_digit(w.text[i]));
  }
  return true;
}

// "rrggbb" to three bytes.
constexpr bool read_colour(Word w, uint8_t* rgb) {
  if (w.length != 6) return false;
  for (uint8_t i = 0; i < 3; ++i) {
    const int8_t high = hex_digit(w.text[2 * i]), low = hex_digit(w.text[2 * i + 1]);
    if (high < 0 || low < 0) return false;
    rgb[i] = static_cast<uint8_t>(16 * high + low);
  }
  return true;
}

}  // namespace dapple::recipe
