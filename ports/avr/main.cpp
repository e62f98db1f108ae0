// The self-test on an AVR. POOL: bytes of RAM for textures; the rest is stack and what C++ keeps in RAM.
// SPDX-License-Identifier: MIT
#include "selftest.hpp"

extern "C" void host_put(char c);

static uint8_t memory[POOL];
extern uint8_t __heap_start[];  // the first byte behind .bss: as far down as the stack may come
static constexpr uint8_t kGuard = 16;

// Sets the bytes there, or says whether they are as they were.
static bool guard(bool set) {
  bool whole = true;
  for (uint8_t i = 0; i < kGuard; ++i) {
    volatile uint8_t& byte = __heap_start[i];
    if (set) byte = 0xa5;
    whole = whole && byte == 0xa5;
  }
  return whole;
}

extern "C" int main() {
  guard(true);
  selftest(host_put, sizeof memory, memory);
  if (!guard(false))
    for (const char* text = "the stack ran into the textures\n"; *text != 0;) host_put(*text++);
  host_put('\n');
  return 0;
}
