// Which row kernels grow a texture: a table of ports/desktop, picked when the program runs. It never changes a byte.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "../../lib/grid/rows.hpp"

namespace cli {

using Kernels = const dapple::grid::KernelSwap*;

// The fastest this processor has.
Kernels best_kernels();

// "best", "portable" or the name of a table; refuses what is not there.
Kernels kernels_named(const std::string& name);

}  // namespace cli
