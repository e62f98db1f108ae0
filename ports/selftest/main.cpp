// The self-test where nothing watches the stack. POOL: bytes for textures.
// SPDX-License-Identifier: MIT
#include "selftest.hpp"

extern "C" {
void host_put(char c);
int main();
}

alignas(8) static uint8_t memory[POOL];

int main() {
  selftest(host_put, sizeof memory, memory);
  return 0;
}
