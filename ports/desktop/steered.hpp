// Steerable binary convolution a vector of cells at a time: what lib/stencil/steer.cpp and directions.cpp do for one
// cell after the other, as loops over arrays. Same numbers; bounds and formats are told there.
// SPDX-License-Identifier: MIT
#pragma once

namespace dapple::stencil {

constexpr uint16_t kCellsAtOnce = 8 * DAPPLE_WIDE;

// Unit vectors along (a, b), Q12, as to_q7 of unit_of.
static void units_of(const int32_t* DAPPLE_RESTRICT a, const int32_t* DAPPLE_RESTRICT b, int16_t* DAPPLE_RESTRICT c2,
                     int16_t* DAPPLE_RESTRICT s2, uint16_t n) {
  int32_t square[kCellsAtOnce], inverse[kCellsAtOnce];
  for (uint16_t i = 0; i < n; ++i) square[i] = a[i] * a[i] + b[i] * b[i];
  base::inverse_roots(square, inverse, n);
  for (uint16_t i = 0; i < n; ++i) {
    c2[i] = static_cast<int16_t>(base::clamp((a[i] * inverse[i] + 65536) >> 17, -127, 127));
    s2[i] = static_cast<int16_t>(base::clamp((b[i] * inverse[i] + 65536) >> 17, -127, 127));
  }
}

static void turns_of(const int32_t* DAPPLE_RESTRICT a, int16_t* DAPPLE_RESTRICT c2, int16_t* DAPPLE_RESTRICT s2,
                     uint16_t n, int16_t bend) {
  for (uint16_t i = 0; i < n; ++i) {
    const uint16_t turn = static_cast<uint16_t>((a[i] * bend) >> 11);
    c2[i] = static_cast<int16_t>(base::clamp((base::cosine(turn) + 128) >> 8, -127, 127));
    s2[i] = static_cast<int16_t>(base::clamp((base::sine(turn) + 128) >> 8, -127, 127));
  }
}

// The blend of three nodes where cells lie at `part`.
static void blended(const int32_t* DAPPLE_RESTRICT part, const Pair* nodes, int32_t* DAPPLE_RESTRICT a,
                    int32_t* DAPPLE_RESTRICT b, uint16_t n) {
  const Pair before = nodes[0], at = nodes[1], behind = nodes[2];
  for (uint16_t i = 0; i < n; ++i) {
    const int32_t f = part[i], w0 = ((256 - f) * (256 - f)) >> 10, w2 = (f * f) >> 10, w1 = 128 - w0 - w2;
    a[i] = (before.a * w0 + at.a * w1 + behind.a * w2) >> 14;
    b[i] = (before.b * w0 + at.b * w1 + behind.b * w2) >> 14;
  }
}

static void directions_wide(const DirectionField& f, int32_t x, int32_t y, uint16_t count, int16_t* c2, int16_t* s2) {
  const NodePlace row = node_place(folded(f.y + y, f.height, f.height), f.height, f.down);
  const Blend down = blend_of(row.part);
  int32_t part[kCellsAtOnce], a[kCellsAtOnce], b[kCellsAtOnce], world = folded(f.x + x, f.width, f.width), known = 0;
  NodePlace p = node_place(world, f.width, f.across);
  Pair nodes[3] = {};
  for (uint16_t first = 0, k = 0; k < count; first = k) {
    const int32_t node = p.node;
    const bool next = first > 0 && node == known + 1;
    if (next) nodes[0] = nodes[1], nodes[1] = nodes[2];
    for (uint8_t n = next ? 2 : 0; n < 3; ++n) nodes[n] = column(f, node + n - 1, row.node, down);
    known = node;
    for (; k < count && p.node == node; ++k) {
      part[k] = p.part;
      next_cell(p);
      if (++world != f.width || f.width == 0) continue;
      world = 0;
      p = node_place(0, f.width, f.across);
    }
    blended(part + first, nodes, a + first, b + first, static_cast<uint16_t>(k - first));
  }
  if (f.kind == scalars) turns_of(a, c2, s2, count, f.bend);
  else units_of(a, b, c2, s2, count);
}

struct WideSums {
  int8_t d[kSteerable][kCellsAtOnce];
};

static void steer_cells(const WideSums& sums, const int16_t* DAPPLE_RESTRICT c, const int16_t* DAPPLE_RESTRICT s,
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

static void mixed(const grid::Rows& rows, int32_t x, uint16_t count, const WideSums& sums, int32_t* most) {
  const SteerSet& set = steer_set(rows);
  int16_t c2[kCellsAtOnce] = {}, s2[kCellsAtOnce] = {};
  directions_wide(set.field, static_cast<int32_t>(rows.x) + x, rows.y, count, c2, s2);
  for (uint16_t i = 0; i < kCellsAtOnce; ++i) most[i] = INT32_MIN;
  for (uint8_t t = 0; t < set.threads; ++t) steer_cells(sums, c2, s2, most, set.c2[t], set.s2[t]);
}

// Cells above the threshold as a word: eight bytes of 0 or 1 become a byte of bits by one product.
static Wide word_above(const int32_t* DAPPLE_RESTRICT most, int32_t threshold) {
  uint8_t on[kCellsAtOnce], bits[DAPPLE_WIDE];
  for (uint16_t i = 0; i < kCellsAtOnce; ++i) on[i] = most[i] > threshold;
  for (uint16_t i = 0; i < DAPPLE_WIDE; ++i)
    bits[i] = static_cast<uint8_t>((base::load_word<uint64_t>(on + 8 * i) * UINT64_C(0x0102040810204080)) >> 56);
  return load_lanes(bits);
}

static uint16_t left_of(const grid::Rows& rows, size_t at) {
  return static_cast<uint16_t>(base::min(kCellsAtOnce, static_cast<int32_t>(rows.n - 8 * at)));
}

static void steer_wide(const grid::Rows& rows) {
  const MaskSet& set = steer_set(rows).masks;
  const int32_t threshold = INT32_C(128) * threshold_of(rows.p[1], set.sum);
  Kept<Wide> kept = kept_of<Wide>(set, rows.scratch);
  for (size_t at = 0; at < (rows.n + 7u) / 8; at += sizeof(Wide), kept.words += kept.column) {
    WideSums sums;
    int32_t most[kCellsAtOnce];
    keep_copies(rows, kept, at);
    for (uint8_t m = 0; m < kSteerable; ++m) values_of(keep_sum(rows, set, kept, m, -1), sums.d[m]);
    mixed(rows, static_cast<int32_t>(8 * at), left_of(rows, at), sums, most);
    store_cells(static_cast<uint8_t*>(rows.out[0]), at, rows.n, word_above(most, threshold));
  }
}

static void steer_field_wide(const grid::Rows& rows) {
  const MaskSet& set = steer_set(rows).masks;
  const uint8_t side = static_cast<uint8_t>(2 * set.radius + 1);
  const int32_t factor = field_scale(set.sum).factor;
  for (size_t at = 0; at < (rows.n + 7u) / 8; at += sizeof(Wide)) {
    WideSums sums;
    Wide copies[kCells], sum[kSumBits];
    int32_t most[kCellsAtOnce];
    for (uint8_t k = 0; k < side; ++k)
      shifted(static_cast<const uint8_t*>(rows.in[k]), at, set.radius, copies + k * side);
    for (uint8_t m = 0; m < kSteerable; ++m) {
      set_number(static_cast<int16_t>(-1), sum);
      add_taps<false>(whole_of(set, m), copies, sum);
      values_of(sum, sums.d[m]);
    }
    const uint16_t count = left_of(rows, at);
    mixed(rows, static_cast<int32_t>(8 * at), count, sums, most);
    int16_t* const out = grid::out16(rows, 0) + 8 * at;
    for (uint16_t i = 0; i < count; ++i)
      out[i] = static_cast<int16_t>(base::clamp((most[i] * factor + 16384) >> 15, -kFieldUnit, kFieldUnit));
  }
}

}  // namespace dapple::stencil
