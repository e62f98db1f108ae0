// Yardsticks, compiled once a set like set.cpp. See yardsticks.hpp.
// SPDX-License-Identifier: MIT
#include <stddef.h>
#include <stdint.h>

#define NAMED(set, name) dapple_##set##_##name
#define OURS(set, name) NAMED(set, name)

typedef uint64_t Lanes __attribute__((vector_size(DAPPLE_WIDE), may_alias, aligned(1)));

static void float_row(const float* __restrict uu, const float* __restrict ul, const float* __restrict u,
                      const float* __restrict ur, const float* __restrict ud, const float* __restrict vu,
                      const float* __restrict vl, const float* __restrict v, const float* __restrict vr,
                      const float* __restrict vd, float* __restrict out_u, float* __restrict out_v, size_t n) {
  for (size_t x = 0; x < n; ++x) {
    const float eaten = u[x] * v[x] * v[x];
    out_u[x] = u[x] + 0.16f * (ul[x] + ur[x] + uu[x] + ud[x] - 4 * u[x]) - eaten + 0.0367f * (1 - u[x]);
    out_v[x] = v[x] + 0.08f * (vl[x] + vr[x] + vu[x] + vd[x] - 4 * v[x]) + eaten - 0.1016f * v[x];
  }
}

extern "C" {

void OURS(DAPPLE_SET, float_gray_scott)(const float* const* u, const float* const* v, float* out_u, float* out_v,
                                        size_t n) {
  float_row(u[0], u[1] - 1, u[1], u[1] + 1, u[2], v[0], v[1] - 1, v[1], v[1] + 1, v[2], out_u, out_v, n);
}

uint64_t OURS(DAPPLE_SET, loads)(const uint8_t* block, size_t count, size_t offset) {
  Lanes sum[4] = {};
  const uint8_t* const from = block + offset;
  for (size_t i = 0; i < count; i += 8) {
    const uint8_t* const at = from + (i & 255) * DAPPLE_WIDE;
    for (size_t k = 0; k < 8; ++k) sum[k & 3] |= *reinterpret_cast<const Lanes*>(at + k * DAPPLE_WIDE);
    __asm__ volatile("" ::: "memory");  // load them again
  }
  sum[0] |= sum[1] | sum[2] | sum[3];
  return sum[0][0];
}

uint64_t OURS(DAPPLE_SET, operations)(size_t count) {
  Lanes a[8];
  for (uint64_t k = 0; k < 8; ++k) a[k] = Lanes{} + (k + 3);
  Lanes key = Lanes{} + UINT64_C(0x9e3779b97f4a7c15);
  for (size_t i = 0; i < count; i += 16) {
    for (size_t k = 0; k < 8; ++k) a[k] ^= key;
    for (size_t k = 0; k < 8; ++k)
      a[k] = a[k] + key;  // an addition between keeps the compiler from taking two for none
  }
  for (size_t k = 1; k < 8; ++k) a[0] ^= a[k];
  return a[0][0];
}

}  // extern "C"
