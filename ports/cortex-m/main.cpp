// The self-test on a Cortex-M. POOL: bytes of memory for textures. SELFTEST_KERNELS: one of the lists of kernels.hpp, which
// is compared with the portable kernels row by row, and then grows the textures.
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

static void put_remark(const char* before, uint32_t number, const char* after) {
  put(before);
  put_number(number);
  put(after);
}

#ifdef SELFTEST_KERNELS
static const dapple::grid::KernelSwap* const kernels = SELFTEST_KERNELS;

static bool rows_equal() {
  static_assert(sizeof memory >= kRowsMemory, "POOL is too small for rows");
  const RowsCompared rows = compare_rows(kernels, memory);
  if (rows.different > 0) put_remark("", rows.different, " rows of fast kernels differ\n");
  put_remark("# ", rows.equal, " rows of fast kernels equal\n");
  return rows.different == 0;
}
#else
static const dapple::grid::KernelSwap* const kernels = nullptr;

static bool rows_equal() { return true; }
#endif

extern "C" int main() {
  const bool equal = rows_equal();
  selftest(host_put, sizeof memory, memory, kernels);
  put_remark("# stack ", stack_used(), " bytes\n");
  // A stack used to its last word may have run into the textures.
  const bool shallow = stack_used() < reinterpret_cast<uintptr_t>(&stack_top) - reinterpret_cast<uintptr_t>(&stack_floor);
  return equal && shallow ? 0 : 1;
}
