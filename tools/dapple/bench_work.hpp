// What dapple bench measures: pieces of work that any kernel table can do, and the limits they are held against.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "bench_clock.hpp"
#include "kernels.hpp"

namespace cli::measure {

// Done once, returns its seconds; `hash` is that of what came of it.
struct Done {
  double seconds;
  uint64_t hash;
};

struct Work {
  std::string name, unit;  // of `amount` a second: "Gcell/s" ...
  double amount;           // cells, passes of cells, pixels, chunks of one run
  double bytes;            // a cell, of state
  double loads_aligned, loads_askew,
      operations;  // that 256 bits of cells' worth of vectors take at least; 0: not known
  std::function<std::function<Done()>(Kernels)> with;  // made for a table
};

// Goes on with a hash over bytes.
uint64_t hashed(uint64_t hash, const void* bytes, size_t count);

// All of them, those of presets last.
std::vector<Work> all_work();

// What a set of instructions can do at most, 1/s.
struct Limits {
  double loads, loads_askew, operations;  // vectors
  double float_gray_scott;                // cells
  uint8_t bytes;                          // of a vector
};
Limits limits_of(const std::string& table);  // zero where there is no yardstick

// Bytes a second that a copy reads and writes: of `bytes` bytes.
double copied(size_t bytes);

}  // namespace cli::measure
