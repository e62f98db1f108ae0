// The self-test on an lx106 (the core of the ESP8266), text through the simulator's host. POOL: bytes for textures.
// SPDX-License-Identifier: MIT
#include "selftest.hpp"

extern "C" {
void host_write(const char* text, size_t count);
int main();
}

alignas(4) static uint8_t memory[POOL];

static void put(char c) { host_write(&c, 1); }

int main() {
  selftest(put, sizeof memory, memory);
  return 0;
}
