// The self-test on a Cortex-M. POOL: bytes of memory for textures. SELFTEST_KERNELS: a list of kernels.hpp; it is
// compared with the portable kernels row by row, and then grows the textures.
// SPDX-License-Identifier: MIT
#include "kernels.hpp"
#include "rows.hpp"
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

static void say(const char* before, uint32_t number, const char* after) {
  put(before);
  put_number(number);
  put(after);
}

#ifdef SELFTEST_KERNELS
static const dapple::grid::KernelSwap* const kernels = SELFTEST_KERNELS;

static bool rows_equal() {
  static_assert(sizeof memory >= kRowsMemory, "POOL is too small for rows");
  uint32_t equal = 0;
  bool all = true;
  for (const dapple::grid::KernelSwap* swap = kernels; swap->portable != nullptr; ++swap) {
    const RowsCompared rows = compare_rows(*swap, memory);
    equal += rows.equal;
    if (rows.different == 0) continue;
    all = false;
    say("kernel ", static_cast<uint32_t>(swap - kernels), " of the list differs on ");
    say("", rows.different, " rows\n");
  }
  say("# ", equal, " rows of fast kernels equal\n");
  return all;
}
#else
static const dapple::grid::KernelSwap* const kernels = nullptr;

static bool rows_equal() { return true; }
#endif

extern "C" int main() {
  const bool equal = rows_equal();
  selftest(host_put, sizeof memory, memory, kernels);
  say("# stack ", stack_used(), " bytes\n");
  // A stack used to its last word may have run into the textures.
  const uintptr_t room = reinterpret_cast<uintptr_t>(&stack_top) - reinterpret_cast<uintptr_t>(&stack_floor);
  return equal && stack_used() < room ? 0 : 1;
}
