// The self-test on a Cortex-M. POOL: bytes of memory for textures.
// SPDX-License-Identifier: MIT
#include "selftest.hpp"

extern "C" {
void host_put(char c);
uint32_t stack_used();
extern uint32_t stack_top, stack_floor;
}

alignas(4) static uint8_t memory[POOL];

static void put_number(uint32_t number) {
  if (number >= 10) put_number(number / 10);
  host_put(static_cast<char>('0' + number % 10));
}

static void put(const char* text) {
  while (*text != 0) host_put(*text++);
}

extern "C" int main() {
  selftest(host_put, sizeof memory, memory);
  put("# stack ");
  put_number(stack_used());
  put(" bytes\n");
  // A stack used to its last word may have run into the textures.
  return stack_used() < reinterpret_cast<uintptr_t>(&stack_top) - reinterpret_cast<uintptr_t>(&stack_floor) ? 0 : 1;
}
