// Steerable binary convolution a vector of cells at a time: what lib/stencil/steer.cpp does for one cell after the
// other. Same numbers; bounds and formats are told there.
// SPDX-License-Identifier: MIT
#pragma once
#include "mixture.hpp"

#include "directions.hpp"

namespace dapple::stencil {

typedef int16_t WideShorts __attribute__((vector_size(DAPPLE_WIDE)));
inline WideShorts shorts_of(Wide word) { return (WideShorts)word.lanes; }
inline void set_word(WideShorts shorts, Wide& word) { word = (Lanes)shorts; }
inline Lanes lanes_of(Wide word) { return word.lanes; }

static uint16_t left_of(uint32_t width, size_t at) {
  return static_cast<uint16_t>(base::min(kCellsAtOnce, static_cast<int32_t>(width - 8 * at)));
}

static void steer_wide(const grid::Rows& rows) {
  const SteerSet& set = steer_set(rows);
  const int16_t threshold = threshold_of(rows.p[1], set.masks.sum);
  Kept<Wide> kept = kept_of<Wide>(set.masks, rows.scratch);
  for (size_t at = 0; at < (rows.n + 7u) / 8; at += sizeof(Wide), kept.words += kept.column) {
    Between between;
    Nodes nodes;
    Wide sum[kSteerable][kTurnedWords], direction[kDirectionWords];
    between_of(set.field, static_cast<int32_t>(rows.x + 8 * at), left_of(rows.n, at), between);
    turned_directions(set.field, between, rows.y, nodes, direction);
    keep_copies(rows, kept, at);
    for (uint8_t m = 0; m < kSteerable; ++m) turned_sum(keep_sum(rows, set.masks, kept, m, -1), sum[m]);
    store_cells(static_cast<uint8_t*>(rows.out[0]), at, rows.n, mixed<Wide>(set, sum, direction, threshold));
  }
}

static void make_directions(const Steered& s, uint32_t column, Wide* direction) {
  const DirectionField& field = s.set->field;
  Between between;
  Nodes nodes;
  between_of(field, static_cast<int32_t>(column), left_of(s.strip.from.width, column / 8), between);
  for (int32_t y = s.strip.first; y < s.strip.end; ++y)
    turned_directions(field, between, y, nodes, direction + kDirectionWords * static_cast<size_t>(y));
}

inline void steer_strip_wide(const grid::Rows& rows) {
  steer_strip_words<Wide>(*static_cast<const Steered*>(rows.in[0]));
}

// --- the field -------------------------------------------------------------------------------------------------------

struct WideSums {
  int8_t d[kSteerable][kCellsAtOnce];
};

static void steer_cells(const WideSums& sums, const int8_t* DAPPLE_RESTRICT c, const int8_t* DAPPLE_RESTRICT s,
                        int32_t* DAPPLE_RESTRICT most, int16_t tc, int16_t ts) {
  for (uint16_t i = 0; i < kCellsAtOnce; ++i) {
    const int16_t c2 = static_cast<int16_t>((c[i] * tc - s[i] * ts + 64) >> 7),
                  s2 = static_cast<int16_t>((s[i] * tc + c[i] * ts + 64) >> 7);
    const int16_t c4 = static_cast<int16_t>((c2 * c2 - s2 * s2 + 64) >> 7),
                  s4 = static_cast<int16_t>((2 * c2 * s2 + 64) >> 7);
    const int32_t d =
        128 * sums.d[0][i] + c2 * sums.d[1][i] + s2 * sums.d[2][i] + c4 * sums.d[3][i] + s4 * sums.d[4][i];
    most[i] = d > most[i] ? d : most[i];
  }
}

static void mix_field(const grid::Rows& rows, size_t at, uint16_t count, const WideSums& sums) {
  const SteerSet& set = steer_set(rows);
  const int32_t factor = field_scale(set.masks.sum).factor;
  Between between;
  Nodes nodes;
  int8_t c2[kCellsAtOnce] = {}, s2[kCellsAtOnce] = {};
  int32_t most[kCellsAtOnce];
  between_of(set.field, static_cast<int32_t>(rows.x + 8 * at), count, between);
  directions_between(set.field, between, rows.y, nodes, c2, s2);
  for (uint16_t i = 0; i < kCellsAtOnce; ++i) most[i] = INT32_MIN;
  for (uint8_t t = 0; t < set.threads; ++t) steer_cells(sums, c2, s2, most, set.c2[t], set.s2[t]);
  int16_t* const out = grid::out16(rows, 0) + 8 * at;
  for (uint16_t i = 0; i < count; ++i)
    out[i] = static_cast<int16_t>(base::clamp((most[i] * factor + 16384) >> 15, -kFieldUnit, kFieldUnit));
}

static void steer_field_wide(const grid::Rows& rows) {
  const MaskSet& set = steer_set(rows).masks;
  const uint8_t side = static_cast<uint8_t>(2 * set.radius + 1);
  for (size_t at = 0; at < (rows.n + 7u) / 8; at += sizeof(Wide)) {
    WideSums sums;
    Wide copies[kCells], sum[kSumBits];
    for (uint8_t k = 0; k < side; ++k)
      shifted(static_cast<const uint8_t*>(rows.in[k]), at, set.radius, copies + k * side);
    for (uint8_t m = 0; m < kSteerable; ++m) {
      set_number(static_cast<int16_t>(-1), sum);
      add_taps<false>(whole_of(set, m), copies, sum);
      values_of(sum, sums.d[m]);
    }
    mix_field(rows, at, left_of(rows.n, at), sums);
  }
}

}  // namespace dapple::stencil
