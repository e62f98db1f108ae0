// Patterns as run-length text, the format of Life programs (Golly, Help, Extended RLE format).
//
//   #C a remark
//   x = 3, y = 2, rule = MAPAP8A/w
//   bo$2o!
//
// b or . is off, o or A is on, $ ends a row, ! the pattern; a number before one of them repeats it.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "rule_torus.hpp"

namespace cli {

// Cells that are on, in the row y from x on.
struct Run {
  uint32_t x, y, count;
};

struct Pattern {
  uint32_t width, height;  // the header's, or more where the cells go beyond it
  std::vector<Run> runs;
  std::string rule;  // as the header has it; empty for none
};

// Where and why a text was refused, from 1 on.
struct RleTrouble {
  uint32_t line, column;
  std::string reason;
};

bool read_rle(const std::string& text, Pattern& pattern, RleTrouble& trouble);

// Switches on the pattern's cells in the middle of the torus, which is at least as large.
void place(const Pattern& pattern, Torus& torus);

// The whole torus; lines of at most 70 characters.
std::string write_rle(const Torus& torus, const std::string& rule, const std::string& remark);

}  // namespace cli
