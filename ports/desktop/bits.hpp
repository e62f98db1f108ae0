// Binary convolution a vector at a time: the templates of lib/stencil/sliced.cpp on wide words.
// SPDX-License-Identifier: MIT
#pragma once

namespace dapple::stencil {

inline void strip_wide(const grid::Rows& rows) { strip_words<Wide>(*static_cast<const Strip*>(rows.in[0])); }
inline void turn_wide(const grid::Rows& rows) { turn_words<Wide>(*static_cast<const Turning*>(rows.in[0])); }

// Where a cell is on as soon as one mask says so, no sums need be compared: signs are enough.
static void convolve_signs(const grid::Rows& rows, const Job<Wide>& job) {
  const MaskSet& set = mask_set(rows);
  Kept<Wide> kept = kept_of<Wide>(set, rows.scratch);
  for (size_t at = 0; at < (rows.n + 7u) / 8; at += sizeof(Wide), kept.words += kept.column) {
    keep_copies(rows, kept, at);
    Wide cells = 0;
    for (uint8_t j = 0; j < job.count; ++j) cells |= ~keep_sum(rows, set, kept, j, job.threshold)[kSumBits - 1];
    store_cells(static_cast<uint8_t*>(rows.out[0]), at, rows.n, cells);
  }
}

static void convolve_wide(const grid::Rows& rows) {
  const Job<Wide> job = job_of<Wide>(rows, false);
  if (job.sums) convolve_kept<Wide>(rows);
  else convolve_signs(rows, job);
}

// max + min of several masks do not fit int8.
static void store_values(const Wide* most, bool both, int16_t* d) {
  constexpr uint16_t bits = sizeof(Wide) * 8;
  int8_t low[bits];
  values_of(most, low);
  if (!both) {
    for (uint16_t i = 0; i < bits; ++i) d[i] = low[i];
    return;
  }
  uint8_t sign[sizeof(Wide)];
  base::copy_bytes(sign, most + kSumBits - 1, sizeof sign);
  for (uint16_t i = 0; i < bits; ++i)
    d[i] = static_cast<int16_t>(static_cast<uint8_t>(low[i]) - (((sign[i >> 3] >> (i & 7)) & 1) << 8));
}

static void scale_values(const int16_t* DAPPLE_RESTRICT d, int16_t* DAPPLE_RESTRICT out, uint16_t n, FieldScale scale) {
  for (uint16_t i = 0; i < n; ++i) out[i] = field_value(scale, d[i]);
}

// max_j D_j, or with min_j D_j added to it.
static void most_of(const Job<Wide>& job, const Wide* copies, Wide* most) {
  Wide sum[kSumBits], least[kSumBits], cells = 0;
  for (uint8_t j = 0; j < job.count; ++j) {
    set_number(static_cast<int16_t>(-1), sum);
    add_taps<false>(job.taps[j], copies, sum);
    if (j == 0) copy_sum(sum, most), copy_sum(sum, least);
    else gather(job, j, sum, most, least, cells);
  }
  if (job.both) add_least(most, least);
}

static void field_of(const grid::Rows& rows, const Job<Wide>& job) {
  constexpr uint16_t bits = sizeof(Wide) * 8;
  const FieldScale scale = field_scale(job.sum);
  const uint8_t side = static_cast<uint8_t>(2 * job.radius + 1);
  for (size_t at = 0; at < (rows.n + 7u) / 8; at += sizeof(Wide)) {
    Wide copies[kCells], most[kSumBits];
    for (uint8_t k = 0; k < side; ++k)
      shifted(static_cast<const uint8_t*>(rows.in[k]), at, job.radius, copies + k * side);
    if (job.count == 1) {
      set_number(static_cast<int16_t>(-1), most);
      add_taps<false>(job.taps[0], copies, most);
    } else {
      most_of(job, copies, most);
    }
    int16_t d[bits];
    store_values(most, job.both, d);
    scale_values(d, grid::out16(rows, 0) + 8 * at,
                 static_cast<uint16_t>(base::min(bits, static_cast<int32_t>(rows.n - 8 * at))), scale);
  }
}

static void field_wide(const grid::Rows& rows) { field_of(rows, job_of<Wide>(rows, true)); }
inline void field_stored_wide(const grid::Rows& rows) { field_of(rows, stored_job<Wide>(rows, true)); }

inline void lean_wide(const grid::Rows& rows) { lean_row<false>(rows, job_of<Wide>(rows, false)); }
inline void stored_wide(const grid::Rows& rows) { lean_row<false>(rows, stored_job<Wide>(rows, false)); }

}  // namespace dapple::stencil
