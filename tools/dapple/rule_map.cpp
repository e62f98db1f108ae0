// Cell programs as text: a number, or Golly's MAP.
// SPDX-License-Identifier: MIT
#include "rule_map.hpp"

#include <cstring>

#include "recipe/word.hpp"

namespace cli {

static const char kBase64[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

// Golly's index of a neighbourhood, of ours: 16 left + 8 right + 4 upper + 2 lower + self.
static unsigned golly_index(unsigned index) {
  const unsigned left = index >> 4 & 1, right = index >> 3 & 1, upper = index >> 2 & 1, lower = index >> 1 & 1;
  return 16 * upper + 8 * left + 4 * (index & 1) + 2 * right + lower;
}

std::string map_of(uint32_t program) {
  uint32_t bits = 0;  // neighbourhood 0 in bit 31
  for (unsigned index = 0; index < 32; ++index) bits |= (program >> index & 1) << (31 - golly_index(index));
  std::string text = "MAP";
  for (int shift = 26; shift > 0; shift -= 6) text += kBase64[bits >> shift & 63];
  return text + kBase64[bits << 4 & 63];
}

static bool read_map(const std::string& text, uint32_t& program, ProgramTrouble& trouble) {
  size_t length = text.size();
  if (length == kMapLength + 2 && text.compare(kMapLength, 2, "==") == 0) length = kMapLength;
  uint64_t bits = 0;
  for (size_t i = 3; i < length && i < kMapLength; ++i) {
    const char* place = text[i] != 0 ? std::strchr(kBase64, text[i]) : nullptr;
    if (place == nullptr) {
      trouble = {i + 1, "it takes the characters A-Z, a-z, 0-9, + and /"};
      return false;
    }
    bits = bits << 6 | static_cast<uint64_t>(place - kBase64);
  }
  if (length != kMapLength) {
    trouble = {(length < kMapLength ? length : kMapLength) + 1,
               "MAP takes six characters, von Neumann's neighbourhood, and here are " + std::to_string(length - 3)};
    return false;
  }
  program = 0;
  for (unsigned index = 0; index < 32; ++index)
    program |= static_cast<uint32_t>(bits >> (35 - golly_index(index)) & 1) << index;
  return true;
}

bool read_cell_program(const std::string& text, uint32_t& program, ProgramTrouble& trouble) {
  if (text.size() > 2 && (text.compare(0, 3, "MAP") == 0 || text.compare(0, 3, "map") == 0))
    return read_map(text, program, trouble);
  const dapple::recipe::Word word = dapple::recipe::word_of(text.c_str());
  if (word.length == text.size() && dapple::recipe::read_program(word, program)) return true;
  const bool hex = text.size() > 2 && text[0] == '0' && text[1] == 'x';
  size_t bad = hex ? 2 : 0;
  while (bad < text.size() && (hex ? dapple::recipe::hex_digit(text[bad]) >= 0 : dapple::recipe::digit(text[bad])))
    ++bad;
  trouble.column = bad == text.size() ? 1 : bad + 1;
  trouble.reason = "give 0 to 4294967295, 0x and at most eight hexadecimal digits, or MAP and six characters of base64";
  return false;
}

std::string hexadecimal(uint32_t program) {
  std::string text = "0x";
  for (int shift = 28; shift >= 0; shift -= 4) text += "0123456789abcdef"[program >> shift & 15];
  return text;
}

}  // namespace cli
