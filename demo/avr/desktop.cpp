// The text of the AVR demo, grown here.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include "show.hpp"

int main() {
  static show::Memory memory;
  show::all(memory, 1, [](char c) { std::putchar(c); });
  return 0;
}
