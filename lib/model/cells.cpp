// A row of cells by a 32-bit program, a word at a time: eight functions of (lower, self), one for each state of (left, right,
// upper), each as m0 ^ m1 self ^ m2 lower ^ m3 lower self, and then seven choices. No branch, any program.
// SPDX-License-Identifier: MIT
#include "cells.hpp"

namespace dapple::cells {

using base::load_word;

// The four coefficients of leaf `leaf` (16 left + 8 right + 4 upper, / 4), spread over a word.
template <class W> static void coefficients(uint32_t program, uint8_t leaf, W* m) {
  const uint8_t table = static_cast<uint8_t>((program >> (4 * leaf)) & 15);  // bit 2 lower + self
  const uint8_t s = static_cast<uint8_t>(table ^ ((table << 1) & 0x0a));     // Reed-Muller transform over self ...
  const uint8_t both = static_cast<uint8_t>(s ^ ((s << 2) & 0x0c));          // ... and over lower
  for (uint8_t i = 0; i < 4; ++i) m[i] = static_cast<W>(W{0} - static_cast<W>((both >> i) & 1));
}

template <class W> static W choose(W off, W on, W by) { return static_cast<W>(off ^ ((off ^ on) & by)); }

template <class W> static void whole_words(const uint8_t* DAPPLE_RESTRICT u, const uint8_t* DAPPLE_RESTRICT c,
                                           const uint8_t* DAPPLE_RESTRICT d, uint8_t* DAPPLE_RESTRICT out, uint16_t count,
                                           const W* DAPPLE_RESTRICT m) {
  constexpr uint8_t top = sizeof(W) * 8 - 1;
  for (size_t at = 0; at < count * sizeof(W); at += sizeof(W)) {
    const W self = load_word<W>(c + at), upper = load_word<W>(u + at), lower = load_word<W>(d + at);
    const W left = static_cast<W>((self << 1) | (load_word<W>(c + at - sizeof(W)) >> top));
    const W right = static_cast<W>((self >> 1) | (load_word<W>(c + at + sizeof(W)) << top));
    const W both = lower & self;
    W leaf[8];
    for (uint8_t i = 0; i < 8; ++i)
      leaf[i] = static_cast<W>(m[4 * i] ^ (m[4 * i + 1] & self) ^ (m[4 * i + 2] & lower) ^ (m[4 * i + 3] & both));
    for (uint8_t i = 0; i < 4; ++i) leaf[i] = choose(leaf[2 * i], leaf[2 * i + 1], upper);
    for (uint8_t i = 0; i < 2; ++i) leaf[i] = choose(leaf[2 * i], leaf[2 * i + 1], right);
    base::store_word(out + at, choose(leaf[0], leaf[1], left));
  }
}

template <class W> static void by_words(const grid::Rows& rows) {
  W m[32];
  for (uint8_t leaf = 0; leaf < 8; ++leaf) coefficients(static_cast<uint32_t>(rows.p[0]), leaf, m + 4 * leaf);
  const uint8_t* u = static_cast<const uint8_t*>(rows.in[0]);
  const uint8_t* c = static_cast<const uint8_t*>(rows.in[1]);
  const uint8_t* d = static_cast<const uint8_t*>(rows.in[2]);
  uint8_t* out = static_cast<uint8_t*>(rows.out[0]);
  const uint16_t whole = static_cast<uint16_t>(rows.n / (8 * sizeof(W)));
  whole_words(u, c, d, out, whole, m);
  const size_t at = whole * sizeof(W), bytes = (rows.n + 7u) / 8 - at;
  if (bytes == 0) return;
  uint8_t last[sizeof(W)];
  whole_words(u + at, c + at, d + at, last, 1, m);
  for (uint8_t i = 0; i < bytes; ++i) out[at + i] = last[i];
}

void window_row(const grid::Rows& rows) { by_words<base::Word>(rows); }
void window_row8(const grid::Rows& rows) { by_words<uint8_t>(rows); }
void window_row32(const grid::Rows& rows) { by_words<uint32_t>(rows); }
void window_row64(const grid::Rows& rows) { by_words<uint64_t>(rows); }

void window_by_cell(const grid::Rows& rows) {
  const uint8_t* u = static_cast<const uint8_t*>(rows.in[0]);
  const uint8_t* c = static_cast<const uint8_t*>(rows.in[1]);
  const uint8_t* d = static_cast<const uint8_t*>(rows.in[2]);
  for (int32_t x = 0; x < rows.n; ++x) {
    const uint8_t index = static_cast<uint8_t>(16 * grid::get_bit(c, x - 1) + 8 * grid::get_bit(c, x + 1) +
                                               4 * grid::get_bit(u, x) + 2 * grid::get_bit(d, x) + grid::get_bit(c, x));
    grid::put_bit(static_cast<uint8_t*>(rows.out[0]), x, (static_cast<uint32_t>(rows.p[0]) >> index) & 1);
  }
}

void field_row(const grid::Rows& rows) {
  const uint8_t* cell = static_cast<const uint8_t*>(rows.in[0]);
  for (uint16_t i = 0; i < rows.n; ++i)
    grid::out16(rows, 0)[i] = grid::get_bit(cell, static_cast<int32_t>(rows.x) + i) ? kUnit : static_cast<int16_t>(0);
}

}  // namespace dapple::cells
