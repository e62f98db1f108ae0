// Grows the textures of tests/golden/targets.txt that fit the memory at hand, and prints a line for each.
// SPDX-License-Identifier: MIT
#pragma once
#include <stddef.h>
#include <stdint.h>

// put: takes the text, one character at a time. memory: any alignment. Needs a stack of about 1.5 KB beside it.
void selftest(void (*put)(char), size_t memory_bytes, void* memory);
