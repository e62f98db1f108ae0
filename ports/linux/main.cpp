// The self-test as a Linux program: text on standard output.
// SPDX-License-Identifier: MIT
#include <stdio.h>
#include "selftest.hpp"

alignas(4) static uint8_t memory[512 * 1024];

int main() {
  selftest([](char c) { putchar(c); }, sizeof memory, memory);
  return fflush(stdout) == 0 ? 0 : 1;
}
