// Interleaved timing. See bench_clock.hpp.
// SPDX-License-Identifier: MIT
#include "bench_clock.hpp"

#include <time.h>

#include <algorithm>
#include <chrono>

namespace cli::measure {

double thread_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::vector<Seconds> take_turns(const std::vector<std::function<double()>>& works, int rounds) {
  std::vector<std::vector<double>> times(works.size());
  for (const auto& work : works) work();  // memory and caches are warm
  for (int round = 0; round < rounds; ++round)
    for (size_t i = 0; i < works.size(); ++i) times[i].push_back(works[i]());
  std::vector<Seconds> all;
  for (std::vector<double>& t : times) {
    std::sort(t.begin(), t.end());
    all.push_back({t.front(), t[t.size() / 2]});
  }
  return all;
}

}  // namespace cli::measure
