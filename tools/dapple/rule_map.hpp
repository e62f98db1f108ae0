// Cell programs as text: a number, or Golly's MAP.
//
// Golly (Help, QuickLife, MAP rules; gollybase/liferules.cpp) counts neighbourhoods in raster order, the first cell the
// most significant bit: of von Neumann's 16 upper + 8 left + 4 self + 2 right + 1 lower. The next states of the
// neighbourhoods 0 to 31 are a string of bits, which base64 packs six a character, the first in the highest bit; the
// last character holds two of them. A suffix :T64,48 says that the world is a torus of that size.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>

namespace cli {

constexpr size_t kMapLength = 3 + 6;

std::string map_of(uint32_t program);

// Why a program's text was refused; column 1 is the text's first character.
struct ProgramTrouble {
  size_t column;
  std::string reason;
};

// A decimal number, 0x and at most eight hexadecimal digits, or MAP and six characters of base64 (perhaps padded with
// ==). False: trouble says why.
bool read_cell_program(const std::string& text, uint32_t& program, ProgramTrouble& trouble);

// "0x" and eight digits.
std::string hexadecimal(uint32_t program);

}  // namespace cli
