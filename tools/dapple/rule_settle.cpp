// Whether the states of a cell program begin to repeat.
// SPDX-License-Identifier: MIT
#include "rule_settle.hpp"

#include <algorithm>

namespace cli {

// The number of steps, at most `most`, after which the state comes again; 0 when it does not.
static uint32_t period_of(const Torus& state, uint32_t program, uint32_t most) {
  Torus later = state;
  for (uint32_t period = 1; period <= most; ++period) {
    later.step(program);
    if (later == state) return period;
  }
  return 0;
}

Settled run(Torus& torus, uint32_t program, uint32_t steps, const Report& report) {
  uint64_t ring[kLongestPeriod] = {torus.hash()};
  Settled settled{Settled::no, 0, 0};
  uint32_t step = 0;
  while (step < steps && settled.kind == Settled::no) {
    if (report) report(step, steps);
    torus.step(program);
    const uint64_t hash = torus.hash();
    ++step;
    for (uint32_t back = 1; back <= std::min(step, kLongestPeriod) && settled.kind == Settled::no; ++back) {
      if (ring[(step - back) % kLongestPeriod] != hash) continue;
      const uint32_t period = period_of(torus, program, back);
      if (period > 0) settled = {period == 1 ? Settled::strong : Settled::weak, step - back, period};
    }
    ring[step % kLongestPeriod] = hash;
  }
  const uint32_t left = settled.kind == Settled::no ? 0 : (steps - step) % settled.period;
  for (uint32_t i = 0; i < left; ++i) torus.step(program);
  return settled;
}

const char* name_of(Settled::Kind kind) {
  return kind == Settled::strong ? "strong" : kind == Settled::weak ? "weak" : "no";
}

}  // namespace cli
