// Fast row kernels against the portable ones, row by row, where they run.
// SPDX-License-Identifier: MIT
#pragma once
#include "grid/rows.hpp"

struct RowsCompared {
  uint32_t equal, different;
};

// Every kernel of the list on rows of 1 to 130 cells at every offset from 0 to 7 cells: random values within the kernel's
// bounds, one cell in four at a bound, with random numbers within the range of recipes. A row counts as different too when
// what lies around it was written to, or when the list has a kernel that this test does not know.
// memory: 12 KB, aligned to four bytes.
constexpr size_t kRowsMemory = 12288;
RowsCompared compare_rows(const dapple::grid::KernelSwap* kernels, void* memory);
