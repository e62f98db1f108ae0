// Whether the states of a cell program begin to repeat.
// SPDX-License-Identifier: MIT
#pragma once
#include "rule_torus.hpp"

namespace cli {

constexpr uint32_t kLongestPeriod = 64;

// weak and strong after Borovsky: the states repeat with a period of 2 or more, or nothing changes any more.
struct Settled {
  enum Kind { no, weak, strong } kind;
  uint32_t step, period;  // the first state that comes again, and after how many steps
};

// Steps the torus `steps` times. States are compared by hashes of the last kLongestPeriod; what looks like a period is
// then stepped through and compared cell by cell, so two states that share a hash do no harm but to the first step.
Settled run(Torus& torus, uint32_t program, uint32_t steps, const Report& report = {});

const char* name_of(Settled::Kind kind);

}  // namespace cli
