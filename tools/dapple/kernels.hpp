// Which row kernels grow a texture, a table of ports/desktop picked when the program runs, and on how many threads.
// Neither changes a byte.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "../../lib/chunks.hpp"

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

// The recipe with masks made once, for many textures, where there is ports/desktop; else as it is.
std::shared_ptr<const dapple::Recipe> ready_of(const dapple::Recipe& recipe);

// Grows at most so many of the chunks that are missing in sight, whole ones, on threads where there are any; says how
// many. For a cache that has begun, till it begins anew.
std::function<uint32_t(uint32_t most)> growers_of(dapple::Chunks& chunks, uint8_t threads);

}  // namespace cli
