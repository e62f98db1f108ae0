// Steerable binary convolution of rows. See steer.hpp.
// SPDX-License-Identifier: MIT
#include "steer.hpp"

namespace dapple::stencil {

constexpr uint8_t kAngles = 16;  // of the mean over a half turn

// Factor of mask m at theta = pi k / kAngles, Q15, for the mean of kAngles terms: 1, 2 cos 2 theta, 2 sin 2 theta ...
static int16_t harmonic(uint8_t m, uint8_t k) {
  const uint16_t doubled = static_cast<uint16_t>(65536u / kAngles * k);
  const uint16_t angle = static_cast<uint16_t>(m > 2 ? 2 * doubled : doubled);
  if (m == 0) return 32767 / kAngles;
  return static_cast<int16_t>((m & 1 ? base::cosine(angle) : base::sine(angle)) * INT32_C(2) / kAngles);
}

// Rounds one kernel to weights that sum to zero: those of 1 and cos 4 theta have all symmetries of the square, the others
// sum to zero by theirs.
static bool round_kernel(const int32_t* kernel, int32_t tenths, int32_t peak, Mask& mask) {
  int16_t scaled[kCells];
  const uint16_t cells = static_cast<uint16_t>((2 * mask.radius + 1) * (2 * mask.radius + 1));
  for (uint16_t i = 0; i < cells; ++i)
    scaled[i] = static_cast<int16_t>(static_cast<int64_t>(kernel[i]) * tenths * 256 / (INT64_C(10) * peak));
  return round_mask(scaled, true, kLargestWeight, mask);
}

bool make_steerable(const MaskShape& shape, Mask* masks, int16_t& sum) {
  int32_t kernel[kSteerable * kCells] = {};
  MaskShape turned = shape;
  for (uint8_t k = 0; k < kAngles; ++k) {
    turned.angle = static_cast<uint16_t>(32768u / kAngles * k);
    int16_t factor[kSteerable];
    for (uint8_t m = 0; m < kSteerable; ++m) factor[m] = harmonic(m, k);
    add_kernels(turned, factor, kSteerable, kernel, kCells);
  }
  const uint16_t cells = static_cast<uint16_t>((2 * shape.radius + 1) * (2 * shape.radius + 1));
  int32_t peak = 1;
  for (const int32_t value : kernel) peak = base::max(peak, value < 0 ? -value : value);
  for (int32_t tenths = 74; tenths >= 15; --tenths) {
    bool good = true;
    for (uint8_t m = 0; m < kSteerable && good; ++m) {
      masks[m].radius = shape.radius;
      good = round_kernel(kernel + m * kCells, tenths, peak, masks[m]);
    }
    if (!good) continue;
    sum = 0;
    for (uint16_t i = 0; i < cells; ++i)
      sum = static_cast<int16_t>(sum + base::max(0, masks[0].weight[i] + masks[1].weight[i] + masks[3].weight[i]));
    return sum > 0;
  }
  return false;
}

constexpr uint8_t kBlock = 64;  // cells at a time

// What the five masks give in a block of cells: |d| <= 127.
struct Sums {
  int8_t d[kSteerable][kBlock];
};

// 128 D of thread t, and the maximum with what is there. Products and sums of two fit int16: (c, s) and a thread's own are
// unit vectors in Q7 or shorter, rounded, |.| < 129.1 (unit_of, doubled_of; tests/desktop/steered.cpp). So
// |(c2, s2)| < 129.1^2 / 128 + .8 < 131.1, |(c4, s4)| < 131.1^2 / 128 + .8 < 135.1, and 135.1 * 127 sqrt 2 = 24265.
static void steer(const SteerSet& set, uint8_t t, const Sums& sums, const int8_t* c, const int8_t* s, int32_t* most) {
  const int16_t tc = set.c2[t], ts = set.s2[t];
  for (uint8_t i = 0; i < kBlock; ++i) {
    const int16_t c2 = static_cast<int16_t>((c[i] * tc - s[i] * ts + 64) >> 7);
    const int16_t s2 = static_cast<int16_t>((s[i] * tc + c[i] * ts + 64) >> 7);
    const int16_t c4 = static_cast<int16_t>((c2 * c2 - s2 * s2 + 64) >> 7);
    const int16_t s4 = static_cast<int16_t>((2 * c2 * s2 + 64) >> 7);
    const int16_t two = static_cast<int16_t>(c2 * sums.d[1][i] + s2 * sums.d[2][i]);
    const int16_t four = static_cast<int16_t>(c4 * sums.d[3][i] + s4 * sums.d[4][i]);
    const int32_t d = INT32_C(128) * sums.d[0][i] + two + four;
    most[i] = d > most[i] ? d : most[i];
  }
}

static const SteerSet& steer_set(const grid::Rows& rows) { return *reinterpret_cast<const SteerSet*>(rows.table); }

// Hands `count` cells from x on to the row's end: bits of a step, or values of the field (8000 D / P; 81280 * 20480 < 2^31).
static void finish(const grid::Rows& rows, bool field, int32_t x, uint8_t count, const Sums& sums) {
  const SteerSet& set = steer_set(rows);
  int8_t c2[kBlock] = {}, s2[kBlock] = {};
  int32_t most[kBlock];
  for (int32_t& d : most) d = INT32_MIN;
  directions(set.field, static_cast<int32_t>(rows.x) + x, rows.y, count, c2, s2);
  for (uint8_t t = 0; t < set.threads; ++t) steer(set, t, sums, c2, s2, most);
  const int32_t threshold = INT32_C(128) * threshold_of(rows.p[1], set.masks.sum);
  const int32_t factor = field_scale(set.masks.sum).factor;
  for (uint8_t i = 0; i < count; ++i) {
    if (field)
      grid::out16(rows, 0)[x + i] = static_cast<int16_t>(base::clamp((most[i] * factor + 16384) >> 15, -kFieldUnit, kFieldUnit));
    else
      grid::put_bit(static_cast<uint8_t*>(rows.out[0]), x + i, most[i] > threshold);
  }
}

using W = base::Word;
constexpr uint8_t kBits = sizeof(W) * 8;

static uint8_t cells_left(const grid::Rows& rows, size_t at) {
  return static_cast<uint8_t>(base::min(kBits, static_cast<int32_t>(rows.n - 8 * at)));
}

void steer_row(const grid::Rows& rows) {
  const MaskSet& set = steer_set(rows).masks;
  Kept<W> kept = kept_of<W>(set, rows.scratch);
  for (size_t at = 0; at < (rows.n + 7u) / 8; at += sizeof(W), kept.words += kept.column) {
    Sums sums = {};
    keep_copies(rows, kept, at);
    for (uint8_t m = 0; m < kSteerable; ++m) values_of(keep_sum(rows, set, kept, m, -1), sums.d[m]);
    finish(rows, false, static_cast<int32_t>(8 * at), cells_left(rows, at), sums);
  }
}

void steer_field(const grid::Rows& rows) {
  const MaskSet& set = steer_set(rows).masks;
  const uint8_t side = static_cast<uint8_t>(2 * set.radius + 1);
  for (size_t at = 0; at < (rows.n + 7u) / 8; at += sizeof(W)) {
    Sums sums = {};
    W local[kLocalCopies], sum[kSumBits];
    W* const copies = base::kSmallStack ? reinterpret_cast<W*>(rows.scratch) : local;
    for (uint8_t k = 0; k < side; ++k) shifted(static_cast<const uint8_t*>(rows.in[k]), at, set.radius, copies + k * side);
    for (uint8_t m = 0; m < kSteerable; ++m) {
      set_number(static_cast<int16_t>(-1), sum);
      add_taps<false>(whole_of(set, m), copies, sum);
      values_of(sum, sums.d[m]);
    }
    finish(rows, true, static_cast<int32_t>(8 * at), cells_left(rows, at), sums);
  }
}

// The definition: sums by table, then the same mixture.
static void by_table(const grid::Rows& rows, bool field) {
  const MaskSet& set = steer_set(rows).masks;
  for (uint32_t x = 0; x < rows.n; x += kTableBlock) {
    const uint8_t count = static_cast<uint8_t>(base::min(kTableBlock, static_cast<int32_t>(rows.n - x)));
    Sums sums = {};
    for (uint8_t m = 0; m < kSteerable; ++m) {
      int16_t d[kTableBlock];
      sums_by_table(set, m, rows, static_cast<int32_t>(x), count, d);
      for (uint8_t i = 0; i < count; ++i) sums.d[m][i] = static_cast<int8_t>(d[i]);
    }
    finish(rows, field, static_cast<int32_t>(x), count, sums);
  }
}

void steer_by_table(const grid::Rows& rows) { by_table(rows, false); }
void steer_field_by_table(const grid::Rows& rows) { by_table(rows, true); }

}  // namespace dapple::stencil
