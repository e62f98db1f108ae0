// Which row kernels grow a texture, a table of ports/desktop picked when the program runs, and on how many threads.
// Neither changes a byte.
// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "../../lib/evolve/run.hpp"

namespace cli {

using Kernels = const dapple::grid::KernelSwap*;

// The fastest this processor has.
Kernels best_kernels();

// "best", "portable" or the name of a table; refuses what is not there.
Kernels kernels_named(const std::string& name);

// The tables this processor can run, the portable one first.
std::vector<std::string> kernel_names();

// Null where there are no threads: bands are done one after the other.
std::shared_ptr<dapple::evolve::Driver> driver_of(uint8_t threads);

}  // namespace cli
