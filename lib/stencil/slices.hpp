// The pieces of bit-sliced convolution: a machine word holds one bit of the sums of as many cells. Unit taps are added
// fifteen at a time by a carry-save tree of eleven full adders. Starting from a threshold t, ~(t + negative taps) + positive
// taps = D - t - 1, whose sign bit is the inverse of the new cell.
// SPDX-License-Identifier: MIT
#pragma once
#include "mask.hpp"

namespace dapple::stencil {

using base::load_word;

constexpr uint8_t kSumBits = 9;  // D - t - 1 lies within -2 * 127 - 1 .. 127 + 127

// Bytes of scratch a cell of a row takes for the kept copies (twice 2 r + 2 rows of 2 r + 1) and sums, rounded up.
constexpr uint8_t kept_bytes(uint8_t radius, uint8_t masks) {
  const uint16_t words = static_cast<uint16_t>(4 * (radius + 1) * (2 * radius + 1) + kSumBits * masks);
  return static_cast<uint8_t>((words + 7) / 8);
}

template <class W> inline void full_add(W a, W b, W c, W& sum, W& carry) {
  const W x = a ^ b;
  sum = x ^ c;
  carry = static_cast<W>((a & b) | (x & c));
}

// Adds the `count`-bit number n, times 2^place, to the sum.
template <uint8_t place, uint8_t count, class W> inline void add_number(const W* n, W* sum) {
  W carry = sum[place] & n[0];
  sum[place] ^= n[0];
  for (uint8_t i = 1; i < count; ++i)
    if (place + i < kSumBits) {
      const W x = sum[place + i] ^ n[i];
      const W next = static_cast<W>((sum[place + i] & n[i]) | (x & carry));
      sum[place + i] = x ^ carry;
      carry = next;
    }
  for (uint8_t i = place + count; i < kSumBits; ++i) {
    const W next = sum[i] & carry;
    sum[i] ^= carry;
    carry = next;
  }
}

// A tap's word among the shifted copies; taps may lie in read-only memory.
template <bool rom, class W> inline W tap(const W* c, const uint16_t* t) { return c[rom ? base::rom_load(t) : *t]; }

template <bool rom, class W> inline void fifteen(const W* c, const uint16_t* t, W* n) {
  W s1, s2, s3, s4, s5, s6, k1, k2, k3, k4, k5, k6, k7, t1, t2, u1, u2, u3;
  full_add(tap<rom>(c, t + 0), tap<rom>(c, t + 1), tap<rom>(c, t + 2), s1, k1);
  full_add(tap<rom>(c, t + 3), tap<rom>(c, t + 4), tap<rom>(c, t + 5), s2, k2);
  full_add(s1, s2, tap<rom>(c, t + 6), s3, k3);
  full_add(tap<rom>(c, t + 7), tap<rom>(c, t + 8), tap<rom>(c, t + 9), s4, k4);
  full_add(tap<rom>(c, t + 10), tap<rom>(c, t + 11), tap<rom>(c, t + 12), s5, k5);
  full_add(s4, s5, tap<rom>(c, t + 13), s6, k6);
  full_add(s3, s6, tap<rom>(c, t + 14), n[0], k7);
  full_add(k1, k2, k3, t1, u1);
  full_add(k4, k5, k6, t2, u2);
  full_add(t1, t2, k7, n[1], u3);
  full_add(u1, u2, u3, n[2], n[3]);
}

template <bool rom, class W> inline void seven(const W* c, const uint16_t* t, W* n) {
  W s1, s2, k1, k2, k3;
  full_add(tap<rom>(c, t + 0), tap<rom>(c, t + 1), tap<rom>(c, t + 2), s1, k1);
  full_add(tap<rom>(c, t + 3), tap<rom>(c, t + 4), tap<rom>(c, t + 5), s2, k2);
  full_add(s1, s2, tap<rom>(c, t + 6), n[0], k3);
  full_add(k1, k2, k3, n[1], n[2]);
}

template <bool rom, uint8_t place, class W> inline const uint16_t* add_list(const W* c, const uint16_t* t, uint8_t count, W* sum) {
  W n[4];
  for (; count >= 15; count = static_cast<uint8_t>(count - 15), t += 15) {
    fifteen<rom>(c, t, n);
    add_number<place, 4>(n, sum);
  }
  for (; count >= 7; count = static_cast<uint8_t>(count - 7), t += 7) {
    seven<rom>(c, t, n);
    add_number<place, 3>(n, sum);
  }
  for (; count >= 3; count = static_cast<uint8_t>(count - 3), t += 3) {
    full_add(tap<rom>(c, t), tap<rom>(c, t + 1), tap<rom>(c, t + 2), n[0], n[1]);
    add_number<place, 2>(n, sum);
  }
  for (; count > 0; --count, ++t) {
    n[0] = tap<rom>(c, t);
    add_number<place, 1>(n, sum);
  }
  return t;
}

// With small code numbers of every place are added by one loop, to the sum from that place on, and carry into words
// behind it.
constexpr uint8_t kRoomBehind = base::kSmallCode ? kPlaces - 1 : 0;

template <bool rom, class W> inline const uint16_t* add_sign(const W* c, const uint16_t* t, const uint8_t* count, W* sum) {
  if constexpr (base::kSmallCode) {
    for (uint8_t place = 0; place < kPlaces; ++place) t = add_list<rom, 0>(c, t, count[place], sum + place);
    return t;
  }
  t = add_list<rom, 0>(c, t, count[0], sum);
  t = add_list<rom, 1>(c, t, count[1], sum);
  t = add_list<rom, 2>(c, t, count[2], sum);
  return add_list<rom, 3>(c, t, count[3], sum);
}

struct TapCounts {
  uint8_t of[2][kPlaces];
};
template <bool rom> inline TapCounts counts_of(const Taps& taps) {
  const TapCounts* counts = reinterpret_cast<const TapCounts*>(taps.count);
  return rom ? base::rom_load(counts) : *counts;
}

// ~(sum + negative) + positive: from t to D - t - 1, or, begun with ~sum, from D - t - 1 to that of the next row.
template <bool rom, class W> inline void add_taps(const Taps& taps, const W* c, W* sum) {
  const TapCounts count = counts_of<rom>(taps);
  uint16_t positive = 0;
  for (uint8_t place = 0; place < kPlaces; ++place) positive = static_cast<uint16_t>(positive + count.of[0][place]);
  W s[kSumBits + kRoomBehind];
  for (uint8_t i = 0; i < kSumBits; ++i) s[i] = sum[i];
  for (uint8_t i = kSumBits; i < kSumBits + kRoomBehind; ++i) s[i] = 0;
  add_sign<rom>(c, taps.index + positive, count.of[1], s);
  for (W& bit : s) bit = static_cast<W>(~bit);
  add_sign<rom>(c, taps.index, count.of[0], s);
  for (uint8_t i = 0; i < kSumBits; ++i) sum[i] = s[i];
}

template <class W> inline void set_number(int16_t value, W* sum) {
  for (uint8_t i = 0; i < kSumBits; ++i) sum[i] = static_cast<W>(W{0} - static_cast<W>((value >> i) & 1));
}

// The 2 r + 1 copies of word `at` bytes into a row, shifted so that copy k holds cells x + k - r. Reads a byte either side.
template <class W> inline void shifted(const uint8_t* row, size_t at, uint8_t r, W* copy) {
  constexpr uint8_t bits = sizeof(W) * 8;
  const W here = load_word<W>(row + at);
  const uint8_t before = *(row + at - 1), after = row[at + sizeof(W)];
  copy[r] = here;
  for (uint8_t k = 1; k <= r; ++k) {
    copy[r - k] = static_cast<W>((here << k) | (before >> (8 - k)));
    copy[r + k] = static_cast<W>((here >> k) | (static_cast<W>(after) << (bits - k)));
  }
}

template <class W> inline void store_cells(uint8_t* out, size_t at, uint16_t n, W cells) {
  const size_t bytes = (n + 7u) / 8 - at;
  if (bytes >= sizeof(W)) return base::store_word(out + at, cells);
  for (uint8_t i = 0; i < bytes; ++i) out[at + i] = static_cast<uint8_t>(cells >> (8 * i));
}

// Of every word of a row the copies of 2 r + 2 rows are kept twice over in the scratch memory, so that those of any window
// lie in a line; the sums of every mask lie behind them.
template <class W> struct Kept {
  W* words;       // of the current word of the row
  size_t column;  // words from one word of the row to the next
  uint8_t side, ring;
};

template <class W> inline Kept<W> kept_of(const MaskSet& set, uint8_t* scratch) {
  const uint8_t side = static_cast<uint8_t>(2 * set.radius + 1), ring = static_cast<uint8_t>(side + 1);
  W* words = reinterpret_cast<W*>(scratch + (-reinterpret_cast<uintptr_t>(scratch) & (sizeof(W) - 1)));
  return {words, 2u * ring * side + kSumBits * static_cast<size_t>(set.count), side, ring};
}

// Brings the copies up to this row: all of them at the start of a run, the newest row later.
template <class W> inline void keep_copies(const grid::Rows& rows, const Kept<W>& kept, size_t at) {
  for (uint16_t k = rows.run == 0 ? 0 : static_cast<uint16_t>(kept.side - 1); k < kept.side; ++k) {
    W* copy = kept.words + (rows.run + k) % kept.ring * kept.side;
    shifted(static_cast<const uint8_t*>(rows.in[k]), at, static_cast<uint8_t>(kept.side / 2), copy);
    for (uint8_t i = 0; i < kept.side; ++i) copy[i + kept.ring * kept.side] = copy[i];
  }
}

// D - start - 1 of mask j for this word: from the row before where that takes fewer taps.
template <class W> inline W* keep_sum(const grid::Rows& rows, const MaskSet& set, const Kept<W>& kept, uint8_t j, int16_t start) {
  W* sum = kept.words + 2u * kept.ring * kept.side + kSumBits * j;
  if (set.running && rows.run > 0) {
    for (uint8_t i = 0; i < kSumBits; ++i) sum[i] = static_cast<W>(~sum[i]);
    add_taps<false>(change_of(set, j), kept.words + (rows.run - 1) % kept.ring * kept.side, sum);
  } else {
    set_number(start, sum);
    add_taps<false>(whole_of(set, j), kept.words + rows.run % kept.ring * kept.side, sum);
  }
  return sum;
}

// Bytes of work space for the shifted copies of one word, where the stack is too small for them.
constexpr uint16_t copies_space(uint8_t radius) {
  return base::kSmallStack ? static_cast<uint16_t>((2 * radius + 1) * (2 * radius + 1) * sizeof(base::Word)) : static_cast<uint16_t>(0);
}
constexpr uint16_t kLocalCopies = base::kSmallStack ? 1 : kCells;

// Turns an 8 x 8 matrix of bits: bit i of byte k becomes bit k of byte i [Warren, Hacker's Delight 7-3].
inline uint64_t turned(uint64_t x) {
  uint64_t t = (x ^ (x >> 7)) & UINT64_C(0x00aa00aa00aa00aa);
  x ^= t ^ (t << 7);
  t = (x ^ (x >> 14)) & UINT64_C(0x0000cccc0000cccc);
  x ^= t ^ (t << 14);
  t = (x ^ (x >> 28)) & UINT64_C(0x00000000f0f0f0f0);
  return x ^ t ^ (t << 28);
}

// Every cell of a bit-sliced number whose values fit int8.
template <class W> inline void values_of(const W* sum, int8_t* out) {
  for (uint8_t at = 0; at < sizeof(W) * 8; at = static_cast<uint8_t>(at + 8)) {
    uint64_t eight = 0;
    for (uint8_t k = 0; k < 8; ++k) eight |= static_cast<uint64_t>(static_cast<uint8_t>(sum[k] >> at)) << (8 * k);
    base::store_word(reinterpret_cast<uint8_t*>(out) + at, turned(eight));
  }
}

// Cell i of a bit-sliced number.
template <class W> inline int16_t cell_of(const W* sum, uint8_t i) {
  uint16_t d = 0;
  for (uint8_t b = 0; b < kSumBits; ++b) d = static_cast<uint16_t>(d | (static_cast<uint16_t>((sum[b] >> i) & 1) << b));
  return static_cast<int16_t>(d < 256 ? d : d - 512);
}

}  // namespace dapple::stencil
