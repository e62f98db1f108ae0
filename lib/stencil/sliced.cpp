// Bit-sliced binary convolution: a machine word holds one bit of the sums of as many cells. Unit taps are added fifteen at
// a time by a carry-save tree of eleven full adders. Starting from the threshold, sum = ~(threshold + negative taps) +
// positive taps = D - threshold - 1, whose sign bit is the inverse of the new cell.
// SPDX-License-Identifier: MIT
#include "convolve.hpp"

namespace dapple::stencil {

using base::load_word;

template <class W> static void full_add(W a, W b, W c, W& sum, W& carry) {
  const W x = a ^ b;
  sum = x ^ c;
  carry = static_cast<W>((a & b) | (x & c));
}

// Adds the `count`-bit number n, times 2^place, to the sum.
template <uint8_t place, uint8_t count, class W> static void add_number(const W* n, W* sum) {
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

template <class W> static void fifteen(const W* c, const uint16_t* t, W* n) {
  W s1, s2, s3, s4, s5, s6, k1, k2, k3, k4, k5, k6, k7, t1, t2, u1, u2, u3;
  full_add(c[t[0]], c[t[1]], c[t[2]], s1, k1);
  full_add(c[t[3]], c[t[4]], c[t[5]], s2, k2);
  full_add(s1, s2, c[t[6]], s3, k3);
  full_add(c[t[7]], c[t[8]], c[t[9]], s4, k4);
  full_add(c[t[10]], c[t[11]], c[t[12]], s5, k5);
  full_add(s4, s5, c[t[13]], s6, k6);
  full_add(s3, s6, c[t[14]], n[0], k7);
  full_add(k1, k2, k3, t1, u1);
  full_add(k4, k5, k6, t2, u2);
  full_add(t1, t2, k7, n[1], u3);
  full_add(u1, u2, u3, n[2], n[3]);
}

template <class W> static void seven(const W* c, const uint16_t* t, W* n) {
  W s1, s2, k1, k2, k3;
  full_add(c[t[0]], c[t[1]], c[t[2]], s1, k1);
  full_add(c[t[3]], c[t[4]], c[t[5]], s2, k2);
  full_add(s1, s2, c[t[6]], n[0], k3);
  full_add(k1, k2, k3, n[1], n[2]);
}

template <uint8_t place, class W> static const uint16_t* add_list(const W* c, const uint16_t* tap, uint8_t count, W* sum) {
  W n[4];
  for (; count >= 15; count = static_cast<uint8_t>(count - 15), tap += 15) {
    fifteen(c, tap, n);
    add_number<place, 4>(n, sum);
  }
  for (; count >= 7; count = static_cast<uint8_t>(count - 7), tap += 7) {
    seven(c, tap, n);
    add_number<place, 3>(n, sum);
  }
  for (; count >= 3; count = static_cast<uint8_t>(count - 3), tap += 3) {
    full_add(c[tap[0]], c[tap[1]], c[tap[2]], n[0], n[1]);
    add_number<place, 2>(n, sum);
  }
  for (; count > 0; --count, ++tap) {
    n[0] = c[*tap];
    add_number<place, 1>(n, sum);
  }
  return tap;
}

template <class W> static const uint16_t* add_sign(const W* c, const uint16_t* tap, const uint8_t* count, W* sum) {
  tap = add_list<0>(c, tap, count[0], sum);
  tap = add_list<1>(c, tap, count[1], sum);
  tap = add_list<2>(c, tap, count[2], sum);
  return add_list<3>(c, tap, count[3], sum);
}

// ~(sum + negative) + positive: from t to D - t - 1, or, begun with ~sum, from D - t - 1 to that of the next row.
template <class W> static void add_taps(const Taps& taps, const W* c, W* sum) {
  uint16_t positive = 0;
  for (uint8_t place = 0; place < kPlaces; ++place) positive = static_cast<uint16_t>(positive + taps.count[0][place]);
  W s[kSumBits];
  for (uint8_t i = 0; i < kSumBits; ++i) s[i] = sum[i];
  add_sign(c, taps.index + positive, taps.count[1], s);
  for (W& bit : s) bit = static_cast<W>(~bit);
  add_sign(c, taps.index, taps.count[0], s);
  for (uint8_t i = 0; i < kSumBits; ++i) sum[i] = s[i];
}

template <class W> static void set_number(int16_t value, W* sum) {
  for (uint8_t i = 0; i < kSumBits; ++i) sum[i] = static_cast<W>(W{0} - static_cast<W>((value >> i) & 1));
}

// The 2 r + 1 copies of word `at` bytes into a row, shifted so that copy k holds cells x + k - r. Reads a byte either side.
template <class W> static void shifted(const uint8_t* row, size_t at, uint8_t r, W* copy) {
  constexpr uint8_t bits = sizeof(W) * 8;
  const W here = load_word<W>(row + at);
  const uint8_t before = *(row + at - 1), after = row[at + sizeof(W)];
  copy[r] = here;
  for (uint8_t k = 1; k <= r; ++k) {
    copy[r - k] = static_cast<W>((here << k) | (before >> (8 - k)));
    copy[r + k] = static_cast<W>((here >> k) | (static_cast<W>(after) << (bits - k)));
  }
}

// a < b of two's complement numbers, bit for bit.
template <class W> static W less(const W* a, const W* b) {
  W result = 0;
  for (uint8_t i = 0; i < kSumBits; ++i) {
    const bool sign = i + 1 == kSumBits;
    const W low = sign ? b[i] : a[i], high = sign ? a[i] : b[i];
    const W differ = low ^ high;
    result = static_cast<W>((result & ~differ) | (high & differ));
  }
  return result;
}

template <class W> static void take(const W* from, W mask, W* to) {
  for (uint8_t i = 0; i < kSumBits; ++i) to[i] ^= (to[i] ^ from[i]) & mask;
}

// most + least; one bit more than they fit is not needed: |max + min| <= 2 * 127.
template <class W> static void add_least(W* most, const W* least) {
  W carry = 0;
  for (uint8_t i = 0; i < kSumBits; ++i) {
    W sum, next;
    full_add(most[i], least[i], carry, sum, next);
    most[i] = sum;
    carry = next;
  }
}

// What one row's kernel works with.
template <class W> struct Job {
  const MaskSet* set;
  int16_t threshold;
  bool sums;  // max and min are needed, so sums begin at -1 and hold D itself
  bool both;  // max + min
};

template <class W> static Job<W> job_of(const grid::Rows& rows, bool field) {
  const MaskSet& set = mask_set(rows);
  const bool both = rows.p[0] == difference_abs && set.count > 1;
  return {&set, threshold_of(rows.p[1], set.sum), field || both, both};
}

// Takes the sum of mask j into the result: OR of the new cells, or max (and min).
template <class W> static void gather(const Job<W>& job, uint8_t j, const W* sum, W* most, W* least, W& cells) {
  if (!job.sums) {
    cells |= static_cast<W>(~sum[kSumBits - 1]);
    return;
  }
  const W every = static_cast<W>(~W{0});
  take(sum, j == 0 ? every : less(most, sum), most);
  if (job.both) take(sum, j == 0 ? every : less(sum, least), least);
}

// The new cells from what gather left.
template <class W> static W cells_of(const Job<W>& job, W* most, const W* least, W cells) {
  if (!job.sums) return cells;
  if (job.both) add_least(most, least);
  W threshold[kSumBits];
  set_number(job.threshold, threshold);
  return less(threshold, most);
}

template <class W> static void store_cells(uint8_t* out, size_t at, uint16_t n, W cells) {
  const size_t bytes = (n + 7u) / 8 - at;
  if (bytes >= sizeof(W)) return base::store_word(out + at, cells);
  for (uint8_t i = 0; i < bytes; ++i) out[at + i] = static_cast<uint8_t>(cells >> (8 * i));
}

// --- with kept copies ----------------------------------------------------------------------------------------------
// Of every word of a row the copies of 2 r + 2 rows are kept twice over, so that those of any window lie in a line.

template <class W> static void convolve_kept(const grid::Rows& rows) {
  const Job<W> job = job_of<W>(rows, false);
  const MaskSet& set = *job.set;
  const uint8_t r = set.radius, side = static_cast<uint8_t>(2 * r + 1), ring = static_cast<uint8_t>(side + 1);
  const size_t column = 2u * ring * side + kSumBits * set.count;  // words kept for a word of the row
  W* kept = reinterpret_cast<W*>(rows.scratch + (-reinterpret_cast<uintptr_t>(rows.scratch) & (sizeof(W) - 1)));
  const uint16_t first = rows.run == 0 ? 0 : static_cast<uint16_t>(side - 1);  // rows whose copies are not there yet
  const bool going = set.running && rows.run > 0;
  for (size_t at = 0; at < (rows.n + 7u) / 8; at += sizeof(W), kept += column) {
    for (uint16_t k = first; k < side; ++k) {
      W* copy = kept + (rows.run + k) % ring * side;
      shifted(static_cast<const uint8_t*>(rows.in[k]), at, r, copy);
      for (uint8_t i = 0; i < side; ++i) copy[i + ring * side] = copy[i];
    }
    W* sums = kept + 2u * ring * side;
    W most[kSumBits] = {}, least[kSumBits] = {}, cells = 0;
    for (uint8_t j = 0; j < set.count; ++j) {
      W* sum = sums + kSumBits * j;
      if (going) {
        for (uint8_t i = 0; i < kSumBits; ++i) sum[i] = static_cast<W>(~sum[i]);
        add_taps(change_of(set, j), kept + (rows.run - 1) % ring * side, sum);
      } else {
        set_number(job.sums ? static_cast<int16_t>(-1) : job.threshold, sum);
        add_taps(whole_of(set, j), kept + rows.run % ring * side, sum);
      }
      gather(job, j, sum, most, least, cells);
    }
    store_cells(static_cast<uint8_t*>(rows.out[0]), at, rows.n, cells_of(job, most, least, cells));
  }
}

void convolve_row(const grid::Rows& rows) { convolve_kept<base::Word>(rows); }
void convolve_row8(const grid::Rows& rows) { convolve_kept<uint8_t>(rows); }
void convolve_row32(const grid::Rows& rows) { convolve_kept<uint32_t>(rows); }
void convolve_row64(const grid::Rows& rows) { convolve_kept<uint64_t>(rows); }

// --- without ---------------------------------------------------------------------------------------------------------

// The result of one word of the row: most[] for the field, the cells for a step.
template <class W> static W one_word(const grid::Rows& rows, const Job<W>& job, size_t at, W* most) {
  const MaskSet& set = *job.set;
  const uint8_t side = static_cast<uint8_t>(2 * set.radius + 1);
  W copies[kLargestSide * kLargestSide], least[kSumBits] = {}, cells = 0;
  for (uint8_t k = 0; k < side; ++k) shifted(static_cast<const uint8_t*>(rows.in[k]), at, set.radius, copies + k * side);
  for (uint8_t j = 0; j < set.count; ++j) {
    W sum[kSumBits];
    set_number(job.sums ? static_cast<int16_t>(-1) : job.threshold, sum);
    add_taps(whole_of(set, j), copies, sum);
    gather(job, j, sum, most, least, cells);
  }
  return cells_of(job, most, least, cells);
}

void convolve_lean(const grid::Rows& rows) {
  using W = base::Word;
  const Job<W> job = job_of<W>(rows, false);
  for (size_t at = 0; at < (rows.n + 7u) / 8; at += sizeof(W)) {
    W most[kSumBits] = {};
    store_cells(static_cast<uint8_t*>(rows.out[0]), at, rows.n, one_word(rows, job, at, most));
  }
}

void field_row(const grid::Rows& rows) {
  using W = base::Word;
  const Job<W> job = job_of<W>(rows, true);
  const FieldScale scale = field_scale(job.set->sum);
  constexpr uint8_t bits = sizeof(W) * 8;
  for (size_t at = 0; at < (rows.n + 7u) / 8; at += sizeof(W)) {
    W most[kSumBits] = {};
    one_word(rows, job, at, most);
    int16_t* out = grid::out16(rows, 0) + 8 * at;
    const uint8_t count = static_cast<uint8_t>(base::min(bits, static_cast<int32_t>(rows.n - 8 * at)));
    for (uint8_t i = 0; i < count; ++i) {
      uint16_t d = 0;
      for (uint8_t b = 0; b < kSumBits; ++b) d = static_cast<uint16_t>(d | (static_cast<uint16_t>((most[b] >> i) & 1) << b));
      out[i] = field_value(scale, static_cast<int16_t>(d < 256 ? d : d - 512));
    }
  }
}

}  // namespace dapple::stencil
