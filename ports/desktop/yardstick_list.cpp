// The yardsticks of the sets that are linked.
// SPDX-License-Identifier: MIT
#include "yardsticks.hpp"

#include <string.h>

namespace dapple::desktop {

#define DAPPLE_YARDSTICKS(set)                                                                                   \
  extern "C" {                                                                                                   \
  void dapple_##set##_float_gray_scott(const float* const* u, const float* const* v, float* out_u, float* out_v, \
                                       size_t n);                                                                \
  uint64_t dapple_##set##_loads(const uint8_t* block, size_t count, size_t offset);                              \
  uint64_t dapple_##set##_operations(size_t count);                                                              \
  }                                                                                                              \
  static const Yardsticks of_##set(uint8_t bytes) {                                                              \
    return {#set, bytes, dapple_##set##_float_gray_scott, dapple_##set##_loads, dapple_##set##_operations};      \
  }

#ifdef DAPPLE_X86
DAPPLE_YARDSTICKS(sse2)
DAPPLE_YARDSTICKS(avx2)
static const Yardsticks all[] = {of_sse2(16), of_avx2(32)};
#elif defined(DAPPLE_ARM)
DAPPLE_YARDSTICKS(neon)
static const Yardsticks all[] = {of_neon(16)};
#endif

const Yardsticks* yardsticks_of([[maybe_unused]] const char* table) {
#if defined(DAPPLE_X86) || defined(DAPPLE_ARM)
  for (const Yardsticks& y : all)
    if (strcmp(y.table, table) == 0) return &y;
#endif
  return nullptr;
}

}  // namespace dapple::desktop
