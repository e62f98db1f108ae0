// A vector of DAPPLE_WIDE bytes as a machine word: what the templates of bit-sliced kernels (lib/stencil/slices.hpp)
// ask of one. GNU vector types, so that one text serves SSE2, AVX2, NEON and simd128.
// SPDX-License-Identifier: MIT
#pragma once
#include "strip_rows.hpp"

namespace dapple::stencil {

typedef uint64_t Lanes __attribute__((vector_size(DAPPLE_WIDE)));
constexpr uint8_t kLanes = DAPPLE_WIDE / 8;
static_assert(kLanes == 2 || kLanes == 4, "vectors of 16 or 32 bytes");

struct Wide {
  Lanes lanes;

  Wide() = default;
  Wide(Lanes l) : lanes(l) {}
  Wide(int value) : lanes(Lanes{} + static_cast<uint64_t>(static_cast<int64_t>(value))) {}  // in every lane
  Wide operator~() const { return ~lanes; }
  Wide operator-(Wide b) const { return lanes - b.lanes; }
  Wide operator&(Wide b) const { return lanes & b.lanes; }
  Wide operator|(Wide b) const { return lanes | b.lanes; }
  Wide operator^(Wide b) const { return lanes ^ b.lanes; }
  Wide operator<<(int by) const { return lanes << by; }  // in every lane
  Wide operator>>(int by) const { return lanes >> by; }
  Wide& operator&=(Wide b) { return *this = *this & b; }
  Wide& operator|=(Wide b) { return *this = *this | b; }
  Wide& operator^=(Wide b) { return *this = *this ^ b; }
};

// Lane i from lane i - 1, the first from `first`; and lane i from lane i + 1, the last from `last`.
template <class L>
inline L moved_up(L l, uint64_t first) {
  const L other = {first};
  if constexpr (sizeof(L) == 16) return __builtin_shufflevector(l, other, 2, 0);
  else return __builtin_shufflevector(l, other, 4, 0, 1, 2);
}
template <class L>
inline L moved_down(L l, uint64_t last) {
  const L other = {last};
  if constexpr (sizeof(L) == 16) return __builtin_shufflevector(l, other, 1, 2);
  else return __builtin_shufflevector(l, other, 1, 2, 3, 4);
}

// Lanes hold cells in memory order on little-endian machines, which all of these are. By a type that may lie anywhere:
// gcc copies bytes to a vector through the stack, in halves.
typedef Lanes AnyLanes __attribute__((aligned(1), may_alias));
inline Lanes load_lanes(const uint8_t* from) { return *reinterpret_cast<const AnyLanes*>(from); }
inline void get_word(const uint8_t* from, Wide& word) { word = load_lanes(from); }
inline void put_word(uint8_t* to, Wide word) { *reinterpret_cast<AnyLanes*>(to) = word.lanes; }

// Two words of half the width as one.
typedef uint64_t HalfLanes __attribute__((vector_size(16), aligned(1), may_alias));
template <class W>
inline void get_halves(const uint8_t* low, const uint8_t* high, W& word) {
  word = __builtin_shufflevector(*reinterpret_cast<const HalfLanes*>(low), *reinterpret_cast<const HalfLanes*>(high), 0,
                                 1, 2, 3);
}
template <class W>
inline void put_halves(uint8_t* low, uint8_t* high, W word) {
  *reinterpret_cast<HalfLanes*>(low) = __builtin_shufflevector(word.lanes, word.lanes, 0, 1);
  *reinterpret_cast<HalfLanes*>(high) = __builtin_shufflevector(word.lanes, word.lanes, 2, 3);
}

// Words moved by one to eight cells: `back` holds cells x - k, `on` cells x + k. before, after: the bytes around them.
inline void shifted(const uint8_t* row, size_t at, uint8_t r, Wide* copy) {
  const Lanes here = load_lanes(row + at);
  const Lanes before = moved_up(here, static_cast<uint64_t>(*(row + at - 1)) << 56),
              after = moved_down(here, row[at + sizeof here]);
  copy[r] = here;
  for (uint8_t k = 1; base::kSmallCode && k <= r; ++k) {
    copy[r - k] = (here << k) | (before >> (64 - k));
    copy[r + k] = (here >> k) | (after << (64 - k));
  }
  if constexpr (base::kSmallCode) return;
  copy_back<1>(Wide(here), Wide(before), r, copy + r);
  copy_on<1>(Wide(here), Wide(after), r, copy + r);
}

// The first bytes of a word, as many as there are left of a row.
inline void store_cells(uint8_t* out, size_t at, uint16_t n, Wide cells) {
  const size_t bytes = (n + 7u) / 8 - at;
  if (bytes >= sizeof cells) return put_word(out + at, cells);
  uint8_t all[sizeof cells];
  base::copy_bytes(all, &cells, sizeof cells);
  size_t i = 0;
  for (; i + 8 <= bytes; i += 8) base::copy_bytes(out + at + i, all + i, 8);
  for (; i < bytes; ++i) out[at + i] = all[i];
}

// Every cell of a bit-sliced number whose values fit int8: turned to bytes, and those put in order.
inline void values_of(const Wide* sum, int8_t* out) {
  Lanes w[8];
  for (uint8_t k = 0; k < 8; ++k) w[k] = sum[k].lanes;
  turn_bits(w);
  turn_bytes(w);
  for (uint8_t k = 0; k < 8; ++k)
    for (uint8_t lane = 0; lane < kLanes; ++lane) {
      const uint64_t eight = w[k][lane];
      base::copy_bytes(out + 64 * lane + 8 * k, &eight, sizeof eight);
    }
}

}  // namespace dapple::stencil
