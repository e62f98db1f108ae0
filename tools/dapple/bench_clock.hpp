// Times that can be trusted on a machine with other work: time of this thread only, rounds that take turns, least and
// median.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <vector>

namespace cli::measure {

// Seconds this thread has been at work.
double thread_seconds();
// Seconds on the wall, for work of several threads.
double wall_seconds();

struct Seconds {
  double least = 0, median = 0;
};

// Runs every piece of work `rounds` times, one after the other in every round; each returns the seconds of what it has
// timed.
std::vector<Seconds> take_turns(const std::vector<std::function<double()>>& works, int rounds);

}  // namespace cli::measure
