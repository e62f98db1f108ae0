// Random numbers as a counter through a hash: hash(seed, stream, x, y) needs no order, so chunks, threads and slices
// agree. Two multiply-xorshift rounds a value with a 64-bit key per row; tests/hash.cpp holds the statistics.
// SPDX-License-Identifier: MIT
#pragma once
#include "port.hpp"

namespace dapple::base {

// A bijection of 32 bits in which every input bit flips every output bit with probability near one half
// (xorshift-multiply constants found by Chris Wellons' search, public domain).
constexpr uint32_t mix(uint32_t h) {
  h ^= h >> 16;
  h *= UINT32_C(0x7feb352d);
  h ^= h >> 15;
  h *= UINT32_C(0x846ca68b);
  h ^= h >> 16;
  return h;
}

// The key of one row of random numbers: made once a row, used for every x.
struct RowKey {
  uint32_t first, second;
};

// stream tells independent uses of one seed apart (planes, jitter in x, jitter in y, grain ...).
constexpr RowKey row_key(uint32_t seed, uint32_t stream, int32_t y) {
  const uint32_t base = mix(seed + UINT32_C(0x9e3779b9) * (stream + 1));
  const uint32_t row = mix(base ^ (static_cast<uint32_t>(y) * UINT32_C(0x85ebca6b)));
  return {row, mix(row + base)};
}

// Uniform over 0..2^32-1.
constexpr uint32_t hash(RowKey key, int32_t x) {
  uint32_t h = (static_cast<uint32_t>(x) * UINT32_C(0x9e3779b1)) ^ key.first;
  h ^= h >> 16;
  h *= UINT32_C(0x7feb352d);
  h += key.second;
  h ^= h >> 15;
  h *= UINT32_C(0x846ca68b);
  h ^= h >> 16;
  return h;
}

constexpr uint32_t hash(uint32_t seed, uint32_t stream, int32_t x, int32_t y) {
  return hash(row_key(seed, stream, y), x);
}

// below(h, count) == floor((h >> 16) * count / 2^16): uniform over 0..count-1, count <= 65536.
constexpr uint32_t below(uint32_t h, uint32_t count) { return ((h >> 16) * count) >> 16; }

}  // namespace dapple::base
