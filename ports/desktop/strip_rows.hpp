// The kernels of strips.hpp, on words of any width.
// SPDX-License-Identifier: MIT
#pragma once
#include "strips.hpp"

namespace dapple::stencil {

inline void get_word(const uint8_t* from, uint64_t& word) { word = load_word<uint64_t>(from); }
inline void put_word(uint8_t* to, uint64_t word) { base::store_word(to, word); }

// --- bits and bytes in another order ---------------------------------------------------------------------------------

// Exchanges the part of a above `shift` bits with the part of b below, in every block of twice as many bits.
template <class L>
inline void exchange(L& a, L& b, uint8_t shift, uint64_t low) {
  const L t = ((a >> shift) ^ b) & low;
  b ^= t;
  a ^= t << shift;
}

// Exchanges words k and k + apart of eight like that, all of them.
template <uint8_t apart, class L>
inline void exchange_all(L* w, uint8_t shift, uint64_t low) {
  for (uint8_t i = 0; i < 4; ++i) {
    const uint8_t k = static_cast<uint8_t>((i & ~(apart - 1)) * 2 + (i & (apart - 1)));
    exchange(w[k], w[k + apart], shift, low);
  }
}

// Bit i of byte b of word k becomes bit k of byte b of word i: of eight places of numbers, a word each, come eight
// words of numbers, a byte each; byte b of word i is cell 8 b + i.
template <class L>
inline void turn_bits(L* w) {
  exchange_all<4>(w, 4, UINT64_C(0x0f0f0f0f0f0f0f0f));
  exchange_all<2>(w, 2, UINT64_C(0x3333333333333333));
  exchange_all<1>(w, 1, UINT64_C(0x5555555555555555));
}

// In every 64 bits byte i of word k becomes byte k of word i.
template <class L>
inline void turn_bytes(L* w) {
  exchange_all<4>(w, 32, UINT64_C(0x00000000ffffffff));
  exchange_all<2>(w, 16, UINT64_C(0x0000ffff0000ffff));
  exchange_all<1>(w, 8, UINT64_C(0x00ff00ff00ff00ff));
}

// Where rows are short a word has half of one row and, `apart` bytes further on, half of another; 0: one row's.
template <class W>
DAPPLE_INLINE void get_cells(const uint8_t* from, size_t apart, W& word) {
  if constexpr (sizeof(W) == 32) {
    if (apart != 0) return get_halves(from, from + apart, word);
  }
  get_word(from, word);
}
template <class W>
DAPPLE_INLINE void put_cells(uint8_t* to, size_t apart, W word) {
  if constexpr (sizeof(W) == 32) {
    if (apart != 0) return put_halves(to, to + apart, word);
  }
  put_word(to, word);
}

// --- sums ------------------------------------------------------------------------------------------------------------

template <bool minus, class W>
DAPPLE_INLINE void take_two(W& sum, W a, W b, W& carry) {
  const W x = a ^ b, before = sum;
  carry = (a & b) | (x & (minus ? ~before : before));
  sum = x ^ before;
}

// Adds a carry, or takes away a borrow, from place `at` on.
template <bool minus, uint8_t at, class W>
DAPPLE_INLINE void ripple(W* sum, W carry) {
  for (uint8_t i = at; i < kSumBits; ++i) {
    const W next = carry & (minus ? ~sum[i] : sum[i]);
    sum[i] ^= carry;
    carry = next;
  }
}

// A tap among the copies: by its bytes, or by its number.
template <class W>
DAPPLE_INLINE W tap_at(const W* copies, const uint32_t* tap) {
  return *reinterpret_cast<const W*>(reinterpret_cast<const uint8_t*>(copies) + *tap);
}
template <class W>
DAPPLE_INLINE W tap_at(const W* copies, const uint16_t* tap) {
  return copies[*tap];
}

// Takes `count` = 2, 4, 8 or 16 taps at `place` into the sum: a tree of full adders whose last operands are the sum's
// own bits. carry: at place + 1, 2, 3 or 4.
template <bool minus, uint8_t place, uint8_t count, class W, class Tap>
DAPPLE_INLINE void take_taps(W* sum, const W* copies, const Tap* tap, W& carry) {
  if constexpr (count == 2) {
    take_two<minus>(sum[place], tap_at(copies, tap), tap_at(copies, tap + 1), carry);
  } else {
    constexpr uint8_t half = count / 2, to = place + (count == 4 ? 1 : count == 8 ? 2 : 3);
    W a, b;
    take_taps<minus, place, half>(sum, copies, tap, a);
    take_taps<minus, place, half>(sum, copies, tap + half, b);
    take_two<minus>(sum[to], a, b, carry);
  }
}

template <bool minus, uint8_t place, class W, class Tap>
DAPPLE_INLINE const Tap* take_list(W* sum, const W* copies, const Tap* tap, uint8_t count) {
  W carry;
  for (; count >= 16; count = static_cast<uint8_t>(count - 16), tap += 16) {
    take_taps<minus, place, 16>(sum, copies, tap, carry);
    ripple<minus, place + 4>(sum, carry);
  }
  if (count & 8) {
    take_taps<minus, place, 8>(sum, copies, tap, carry);
    ripple<minus, place + 3>(sum, carry);
    tap += 8;
  }
  if (count & 4) {
    take_taps<minus, place, 4>(sum, copies, tap, carry);
    ripple<minus, place + 2>(sum, carry);
    tap += 4;
  }
  if (count & 2) {
    take_taps<minus, place, 2>(sum, copies, tap, carry);
    ripple<minus, place + 1>(sum, carry);
    tap += 2;
  }
  if (count & 1) ripple<minus, place>(sum, tap_at(copies, tap++));
  return tap;
}

// One by one: as a loop gcc makes it a copy of bytes, which takes longer than the sum.
template <uint8_t i = 0, class W>
DAPPLE_INLINE void copy_sum(const W* from, W* to) {
  to[i] = from[i];
  if constexpr (i + 1 < kSumBits) copy_sum<i + 1>(from, to);
}

// sum += all of a mask's taps.
template <class W, class Tap>
DAPPLE_INLINE void take_all(const uint8_t (*count)[kPlaces], const Tap* tap, const W* copies, W* sum) {
  W s[kSumBits];
  copy_sum(sum, s);
  tap = take_list<false, 0>(s, copies, tap, count[0][0]);
  tap = take_list<false, 1>(s, copies, tap, count[0][1]);
  tap = take_list<false, 2>(s, copies, tap, count[0][2]);
  tap = take_list<false, 3>(s, copies, tap, count[0][3]);
  tap = take_list<true, 0>(s, copies, tap, count[1][0]);
  tap = take_list<true, 1>(s, copies, tap, count[1][1]);
  tap = take_list<true, 2>(s, copies, tap, count[1][2]);
  take_list<true, 3>(s, copies, tap, count[1][3]);
  copy_sum(s, sum);
}

// A list of taps in bytes.
struct Reached {
  uint8_t count[2][kPlaces];
  uint32_t at[kMaxTaps];
};
template <class W>
static void reach(const Taps& taps, Reached& reached) {
  base::copy_bytes(reached.count, taps.count, sizeof reached.count);
  const uint16_t count = count_of(taps);
  for (uint16_t i = 0; i < count; ++i) reached.at[i] = static_cast<uint32_t>(taps.index[i] * sizeof(W));
}

// --- shifted copies --------------------------------------------------------------------------------------------------

constexpr size_t kCopiesBytes = 24 * 1024;  // that stay in the first-level cache

// The copies of a column's rows, one row behind the other; when there is no more room, the newest rows go to the front.
struct Copies {
  alignas(64) uint8_t bytes[kCopiesBytes];
  size_t row;         // bytes
  int32_t top, next;  // rows of the grid: the first that is there, the first that is not
  int32_t room;       // rows
  uint32_t y, x;      // of row `next` in the grid: round its height, lane 0 round its period
};

// Where `count` cells of lean come to round the period.
inline uint32_t round(int64_t count, uint32_t period) {
  const int64_t place = count % static_cast<int64_t>(period);
  return static_cast<uint32_t>(place < 0 ? place + period : place);
}

// Words of cells x - k and x + k, k = 1 .. count.
template <int k, class W>
DAPPLE_INLINE void copy_back(W here, W before, int count, W* copy) {
  if (k > count) return;
  copy[-k] = (here << k) | (before >> (64 - k));
  if constexpr (k < 2 * kLargestMask) copy_back<k + 1>(here, before, count, copy);
}
template <int k, class W>
DAPPLE_INLINE void copy_on(W here, W after, int count, W* copy) {
  if (k > count) return;
  copy[k] = (here >> k) | (after << (64 - k));
  if constexpr (k < 2 * kLargestMask) copy_on<k + 1>(here, after, count, copy);
}

// Cells x + q of the word at cell x of a row, q = first .. first + columns - 1.
template <class W>
DAPPLE_INLINE void copy_shifted(const World& w, const uint8_t* row, uint32_t x, size_t apart, W* copy) {
  const uint8_t* const from = row + (x >> 3);
  const int by = static_cast<int>(x & 7);
  W here, before, after, behind;
  get_cells(from, apart, here);
  get_cells(from - 8, apart, before);
  get_cells(from + 8, apart, after);
  if (by != 0) {
    get_cells(from + 16, apart, behind);
    before = (before >> by) | (here << (64 - by));
    here = (here >> by) | (after << (64 - by));
    after = (after >> by) | (behind << (64 - by));
  }
  copy -= w.first;
  copy[0] = here;
  copy_back<1>(here, before, -w.first, copy);
  copy_on<1>(here, after, w.first + w.columns - 1, copy);
}

template <class W>
static void begin_copies(const Strip& s, Copies& copies) {
  const int32_t first = static_cast<int32_t>(s.first) - s.world->radius;
  copies.row = sizeof(W) * s.world->columns;
  copies.room = static_cast<int32_t>(kCopiesBytes / copies.row);
  copies.top = copies.next = first;
  copies.y = static_cast<uint32_t>(first < 0 ? first + s.from.height : first);
  copies.x = round(static_cast<int64_t>(s.world->lean) * first, s.from.period);
}

// Copies of rows from `from` on up to the one before `end`, of the word at cell `column`.
template <class W>
DAPPLE_INLINE void bring(const Strip& s, uint32_t column, size_t apart, int32_t from, int32_t end, Copies& copies) {
  if (end - copies.top > copies.room) {
    const size_t bytes = copies.row * static_cast<size_t>(copies.next - from);
    __builtin_memmove(copies.bytes, copies.bytes + copies.row * static_cast<size_t>(from - copies.top), bytes);
    copies.top = from;
  }
  const BitGrid& grid = s.from;
  for (; copies.next < end; ++copies.next) {
    uint8_t* const at = copies.bytes + copies.row * static_cast<size_t>(copies.next - copies.top);
    copy_shifted(*s.world, grid.rows + grid.pitch * copies.y, copies.x + column, apart, reinterpret_cast<W*>(at));
    if (++copies.y == grid.height) copies.y = 0;
    if (s.world->lean > 0) copies.x = copies.x + 1 == grid.period ? 0 : copies.x + 1;
    if (s.world->lean < 0) copies.x = copies.x == 0 ? grid.period - 1 : copies.x - 1;
  }
}

// --- strips ----------------------------------------------------------------------------------------------------------

// The column of words at a cell, from the first row to the one before `end`: decide(sums, y, out) makes cells of the sums
// of a row. Sanitizers leave it alone: with a look at every tap it takes minutes to compile.
template <class W, class Decide>
__attribute__((no_sanitize("address", "undefined"))) static void strip_column(const Strip& s, uint32_t column,
                                                                              int32_t end, size_t apart,
                                                                              const Reached* whole,
                                                                              const Reached* change, uint8_t* to,
                                                                              size_t pitch, const Decide& decide) {
  const World& w = *s.world;
  Copies copies;
  begin_copies<W>(s, copies);
  W sums[kMaxMasks][kSumBits];
  for (int32_t y = s.first; y < end; ++y, to += pitch) {
    const int32_t before = y > s.first ? y - 1 - w.radius : y - w.radius;
    bring<W>(s, column, apart, before, y + w.radius + 1, copies);
    const W* const row =
        reinterpret_cast<const W*>(copies.bytes + copies.row * static_cast<size_t>(before - copies.top));
    for (uint8_t i = 0; i < w.masks; ++i) {
      if (w.mask[i].running && y > s.first) {
        take_all(change[i].count, change[i].at, row, sums[i]);
      } else {
        set_number(static_cast<int16_t>(-1 - s.threshold), sums[i]);
        take_all(whole[i].count, whole[i].at, y > s.first ? row + w.columns : row, sums[i]);
      }
    }
    uint8_t* const out = to + column / 8;
    put_cells(out, apart, decide(sums, y, out));
  }
}

// Cells that one of the masks is for.
template <class W>
DAPPLE_INLINE W any_of(const W (*sums)[kSumBits], uint8_t masks, bool add, size_t apart, const uint8_t* out) {
  W cells = 0;
  if (add) get_cells(out, apart, cells);
  for (uint8_t i = 0; i < masks; ++i) cells |= ~sums[i][kSumBits - 1];
  return cells;
}

// Cells at .. at + 63, at < period, of a row that goes round.
inline uint64_t around(const uint8_t* row, uint32_t at, uint32_t period) {
  const uint8_t* const from = row + (at >> 3);
  const uint8_t shift = static_cast<uint8_t>(at & 7);
  const uint64_t cells = (load_word<uint64_t>(from) >> shift) | ((static_cast<uint64_t>(from[8]) << 1) << (63 - shift));
  const uint32_t left = period - at;
  if (left >= 64) return cells;
  return (cells & ((UINT64_C(1) << left) - 1)) | (load_word<uint64_t>(row) << left);
}

// Rows of a world that leans, put upright.
static void stand_up(const Strip& s, const uint8_t* leaning, size_t pitch) {
  const uint32_t period = s.from.period;
  for (int32_t y = s.first; y < s.end; ++y, leaning += pitch) {
    uint8_t* to = s.to + s.from.pitch * static_cast<size_t>(y);
    uint32_t x = round(-static_cast<int64_t>(s.world->lean) * y, period);
    for (uint32_t at = 0; at < s.from.width; at += 64, to += 8) {
      uint64_t cells = around(leaning, x, period);
      if (s.add) cells |= load_word<uint64_t>(to);
      base::store_word(to, cells);
      x += 64;
      if (x >= period) x -= period;
    }
  }
}

// The lists of a world's masks.
struct WorldTaps {
  Reached whole[kMaxMasks], change[kMaxMasks];
};
template <class W>
static void reach(const World& w, WorldTaps& taps) {
  for (uint8_t i = 0; i < w.masks; ++i) {
    reach<W>(w.mask[i].whole, taps.whole[i]);
    if (w.mask[i].running) reach<W>(w.mask[i].change, taps.change[i]);
  }
}

// Of an upright grid whose rows do not go round, and of which no more than 128 cells of a row are wanted, the lower
// half of the rows goes beside the upper one: bytes from a row to the one beside it. Of an odd number both have the
// middle one.
inline size_t apart_of(const Strip& s, uint32_t cells) {
  const bool inside = s.first >= s.world->radius && s.end + s.world->radius <= s.from.height;
  return s.world->lean == 0 && inside && cells <= 128 ? s.from.pitch * static_cast<size_t>((s.end - s.first) / 2) : 0;
}

template <class W>
static void strip_words(const Strip& s) {
  const World& w = *s.world;
  WorldTaps taps;
  reach<W>(w, taps);
  // Of a torus that leans every cell of the period is wanted.
  const uint32_t left = w.lean != 0 ? 0 : s.left & ~7u, right = w.lean != 0 ? s.from.period : s.right;
  const bool add = w.lean == 0 && s.add;
  uint8_t* const to = w.lean != 0 ? s.leaning : s.to + s.from.pitch * s.first;
  const size_t apart = sizeof(W) == 32 ? apart_of(s, right - left) : 0;
  const int32_t end = s.end - static_cast<int32_t>(apart / s.from.pitch);
  for (uint32_t column = left; column < right; column += 8 * static_cast<uint32_t>(sizeof(W)))
    strip_column<W>(s, column, end, apart, taps.whole, taps.change, to, s.from.pitch,
                    [&](const W(*sums)[kSumBits], int32_t, const uint8_t* out) {
                      return any_of(sums, w.masks, add, apart, out);
                    });
  if (w.lean != 0) stand_up(s, s.leaning, s.from.pitch);
}

// --- turned over -----------------------------------------------------------------------------------------------------

// 64 x 64 cells in every lane of 64 words: bit i of word k becomes bit k of word i [Warren, Hacker's Delight 7-3].
template <class W>
static void turn_block(W* word) {
  uint64_t low = UINT64_C(0xffffffff);
  for (int shift = 32; shift > 0; shift /= 2, low ^= low << shift)
    for (int k = 0; k < 64; k = (k + shift + 1) & ~shift) {
      W mask;
      uint64_t lanes[sizeof(W) / 8];
      for (uint64_t& lane : lanes) lane = low;
      base::copy_bytes(&mask, lanes, sizeof mask);
      const W t = ((word[k] >> shift) ^ word[k + shift]) & mask;
      word[k + shift] ^= t;
      word[k] ^= t << shift;
    }
}

template <class W>
static void turn_words(const Turning& t) {
  for (uint32_t y = t.first; y < t.end; y += 64)
    for (uint32_t x = t.left; x < t.right; x += 8 * sizeof(W)) {
      W word[64];
      for (uint32_t k = 0; k < 64; ++k) get_word(t.from + (y + k) * t.pitch + x / 8, word[k]);
      turn_block(word);
      for (uint32_t lane = 0; lane < sizeof(W) / 8; ++lane)
        for (uint32_t k = 0; k < 64; ++k) {
          uint8_t* const to = t.to + (x + 64 * lane + k) * t.to_pitch + y / 8;
          uint64_t cells = load_word<uint64_t>(reinterpret_cast<const uint8_t*>(word + k) + 8 * lane);
          if (t.add) cells |= load_word<uint64_t>(to);
          base::store_word(to, cells);
        }
    }
}

}  // namespace dapple::stencil
