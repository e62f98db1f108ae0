// How nice the state of a cell program looks, in integers: between order and noise, in patches, and at rest.
//
// All figures but counts are Q16: 65536 is 1.0.
// SPDX-License-Identifier: MIT
#pragma once
#include "rule_settle.hpp"

namespace cli {

struct Score {
  int32_t density;      // share of the cells that are on
  int32_t entropy;      // bits a cell, given the six cells W, N, NW, NE, WW and NN of it: 0 order, 1 noise
  int32_t disorder;     // entropy as a share of that of independent cells of this density
  int32_t correlation;  // of neighbouring cells, corrected for the density: 1 patches, 0 noise, -1 a chessboard
  int32_t activity;     // share of the cells that the next step changes
  Settled settled;
  int32_t total;  // (1 - |entropy - .35| / .35) + .8 max(0, correlation) + .4 if settled + .3 if activity < .1
  bool nice;      // density .05 to .95, entropy .08 to .60, disorder at most .58: sparse dots are noise too
};

constexpr int32_t kOne = 65536;

// log2_q16(n) == floor(65536 log2 n) within 16 units, n >= 1.
uint32_t log2_q16(uint64_t n);

Score score_of(const Torus& torus, uint32_t program, const Settled& settled);

// "0.350"
std::string decimal(int32_t q16);

}  // namespace cli
