// Bit-sliced binary convolution of rows. See slices.hpp for how sums are made.
// SPDX-License-Identifier: MIT
#include "convolve.hpp"
#include "slices.hpp"

namespace dapple::stencil {

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
  uint8_t count, radius;
  int16_t threshold, sum;
  const Taps* taps;
  bool sums;  // max and min are needed, so sums begin at -1 and hold D itself
  bool both;  // max + min
};

template <class W> static Job<W> job_of(const grid::Rows& rows, bool field, uint8_t count, uint8_t radius, int16_t sum, const Taps* taps) {
  const bool both = rows.p[0] == difference_abs && count > 1;
  return {count, radius, threshold_of(rows.p[1], sum), sum, taps, field || both, both};
}

template <class W> static Job<W> job_of(const grid::Rows& rows, bool field) {
  const MaskSet& set = mask_set(rows);
  return job_of<W>(rows, field, set.count, set.radius, set.sum, set.whole);
}

// The same with masks in read-only memory: the table is the place of a StoredMasks.
template <class W> static Job<W> stored_job(const grid::Rows& rows, bool field) {
  const StoredMasks<1>* masks = nullptr;
  base::copy_bytes(&masks, rows.table, sizeof masks);  // the table is aligned to four bytes only
  const StoredSet set = base::rom_load(&masks->set);
  return job_of<W>(rows, field, set.count, set.radius, set.sum, masks->taps);
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

// --- with kept copies ------------------------------------------------------------------------------------------------

template <class W> static void convolve_kept(const grid::Rows& rows) {
  const Job<W> job = job_of<W>(rows, false);
  const MaskSet& set = mask_set(rows);
  Kept<W> kept = kept_of<W>(set, rows.scratch);
  for (size_t at = 0; at < (rows.n + 7u) / 8; at += sizeof(W), kept.words += kept.column) {
    keep_copies(rows, kept, at);
    W most[kSumBits] = {}, least[kSumBits] = {}, cells = 0;
    for (uint8_t j = 0; j < set.count; ++j)
      gather(job, j, keep_sum(rows, set, kept, j, job.sums ? static_cast<int16_t>(-1) : job.threshold), most, least, cells);
    store_cells(static_cast<uint8_t*>(rows.out[0]), at, rows.n, cells_of(job, most, least, cells));
  }
}

void convolve_row(const grid::Rows& rows) { convolve_kept<base::Word>(rows); }
void convolve_row8(const grid::Rows& rows) { convolve_kept<uint8_t>(rows); }
void convolve_row32(const grid::Rows& rows) { convolve_kept<uint32_t>(rows); }
void convolve_row64(const grid::Rows& rows) { convolve_kept<uint64_t>(rows); }

// --- without ---------------------------------------------------------------------------------------------------------

// The result of one word of the row: most[] for the field, the cells for a step.
template <bool rom, class W> static W one_word(const grid::Rows& rows, const Job<W>& job, size_t at, W* most) {
  const uint8_t side = static_cast<uint8_t>(2 * job.radius + 1);
  W local[kLocalCopies], least[kSumBits] = {}, cells = 0;
  W* const copies = base::kSmallStack ? reinterpret_cast<W*>(rows.scratch) : local;
  for (uint8_t k = 0; k < side; ++k) shifted(static_cast<const uint8_t*>(rows.in[k]), at, job.radius, copies + k * side);
  for (uint8_t j = 0; j < job.count; ++j) {
    W sum[kSumBits];
    set_number(job.sums ? static_cast<int16_t>(-1) : job.threshold, sum);
    add_taps<rom>(job.taps[j], copies, sum);
    gather(job, j, sum, most, least, cells);
  }
  return cells_of(job, most, least, cells);
}

template <bool rom, class W> static void lean_row(const grid::Rows& rows, const Job<W>& job) {
  for (size_t at = 0; at < (rows.n + 7u) / 8; at += sizeof(W)) {
    W most[kSumBits] = {};
    store_cells(static_cast<uint8_t*>(rows.out[0]), at, rows.n, one_word<rom>(rows, job, at, most));
  }
}

template <bool rom> static void lean_field(const grid::Rows& rows, const Job<base::Word>& job) {
  using W = base::Word;
  const FieldScale scale = field_scale(job.sum);
  constexpr uint8_t bits = sizeof(W) * 8;
  for (size_t at = 0; at < (rows.n + 7u) / 8; at += sizeof(W)) {
    W most[kSumBits] = {};
    one_word<rom>(rows, job, at, most);
    int16_t* out = grid::out16(rows, 0) + 8 * at;
    const uint8_t count = static_cast<uint8_t>(base::min(bits, static_cast<int32_t>(rows.n - 8 * at)));
    if (job.both) {
      for (uint8_t i = 0; i < count; ++i) out[i] = field_value(scale, cell_of(most, i));
      continue;
    }
    int8_t d[bits];
    values_of(most, d);
    for (uint8_t i = 0; i < count; ++i) out[i] = field_value(scale, d[i]);
  }
}

void convolve_lean(const grid::Rows& rows) { lean_row<false>(rows, job_of<base::Word>(rows, false)); }
void convolve_stored(const grid::Rows& rows) { lean_row<true>(rows, stored_job<base::Word>(rows, false)); }
void field_row(const grid::Rows& rows) { lean_field<false>(rows, job_of<base::Word>(rows, true)); }
void field_stored(const grid::Rows& rows) { lean_field<true>(rows, stored_job<base::Word>(rows, true)); }

}  // namespace dapple::stencil
