// Fast row kernels against the portable ones, row by row, where they run.
// SPDX-License-Identifier: MIT
#pragma once
#include "grid/rows.hpp"

struct RowsCompared {
  uint32_t equal, different;
};

// The two kernels on rows of 1 to 130 cells at every offset from 0 to 7 cells: random values within the kernel's
// bounds, one cell in four at a bound, with random numbers within the range of recipes. A row is different too when
// what lies around it was written to otherwise. A kernel that this test does not know counts as one different row.
// memory: kRowsMemory bytes, aligned to four.
constexpr size_t kRowsMemory = 8448;
RowsCompared compare_rows(const dapple::grid::KernelSwap& swap, void* memory);
