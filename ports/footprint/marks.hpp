// The moments that tools/footprint/ counts between, and what a counted program says of each case.
// SPDX-License-Identifier: MIT
#pragma once
#include "dapple.hpp"

extern "C" {
void host_put(char c);
void mark();
int main();
}

DAPPLE_APART void mark() { __asm__ volatile("" ::: "memory"); }

// FNV-1a 32.
constexpr uint32_t kFirst = UINT32_C(2166136261);
inline void add(uint32_t& hash, uint8_t byte) { hash = (hash ^ byte) * UINT32_C(16777619); }

inline void print(const char* text) {
  while (*text != 0) host_put(*text++);
}

inline void print_number(uint32_t number, uint8_t base, uint8_t digits) {
  char text[11];
  uint8_t at = sizeof text;
  text[--at] = 0;
  for (; number > 0 || digits > 0; number /= base) {
    const uint8_t digit = static_cast<uint8_t>(number % base);
    text[--at] = static_cast<char>(digit < 10 ? '0' + digit : 'a' + digit - 10);
    if (digits > 0) --digits;
  }
  print(text + at);
}

// "name updates pixels hash": how many cell updates and pixels were counted.
inline void say(const char* name, uint32_t updates, uint32_t pixels, uint32_t hash) {
  print(name);
  host_put(' ');
  print_number(updates, 10, 1);
  host_put(' ');
  print_number(pixels, 10, 1);
  host_put(' ');
  print_number(hash, 16, 8);
  host_put('\n');
}
