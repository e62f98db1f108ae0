// What a program says on Linux: standard output.
// SPDX-License-Identifier: MIT
#include <stdio.h>

extern "C" void host_put(char c);

void host_put(char c) { putchar(c); }
