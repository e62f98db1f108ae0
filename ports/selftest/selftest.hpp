// Grows the textures of tests/golden/targets.txt that fit the memory at hand, and prints a line for each.
// SPDX-License-Identifier: MIT
#pragma once
#include <stddef.h>
#include <stdint.h>

namespace dapple::grid { struct KernelSwap; }

// put: takes the text, one character at a time. memory: any alignment. Needs 5.5 KB of stack beside it; 10.5 KB where
// there is memory enough (11 KB) for the recipes of flow.
// kernels: Options::kernels of every texture that is not begun from a Fixed.
void selftest(void (*put)(char), size_t memory_bytes, void* memory, const dapple::grid::KernelSwap* kernels = nullptr);
