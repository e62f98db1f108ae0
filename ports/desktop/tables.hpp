// Tables of row kernels for desktop processors: what Options::kernels may point to. Every table gives the same bytes.
// SPDX-License-Identifier: MIT
#pragma once
#include "../../lib/grid/rows.hpp"

namespace dapple::desktop {

struct Table {
  const char* name;                 // "portable", or an instruction set
  const grid::KernelSwap* kernels;  // null: the portable ones
  bool (*runs)();                   // whether this processor has what it takes
};

// All tables of this build, the slowest first; the first one is the portable one.
uint8_t table_count();
const Table& table_at(uint8_t i);

// The last table that runs here.
const Table& best_table();

// The table called so, whether it runs here or not; null if there is none.
const Table* table_named(const char* name);

}  // namespace dapple::desktop
