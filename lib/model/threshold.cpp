// Reaction and decay of the threshold family, one row. The shading field is
//   M-D (14): D = max_j (C+_j - C-_j);   D-A (15): D = max_j (..) + min_j (..);   one pair (13): D = C+ - C-
// and the reaction is on where D > rho, strictly, so that D = 0 keeps still.
// SPDX-License-Identifier: MIT
#include "threshold.hpp"

namespace dapple::threshold {

using base::mulhi;
using grid::in16;
using grid::out16;
using i16 = int16_t;

// The difference of one pair: |a - b| <= 16000.
static void difference(const i16* DAPPLE_RESTRICT a, const i16* DAPPLE_RESTRICT b, i16* DAPPLE_RESTRICT out, uint16_t n) {
  for (uint16_t x = 0; x < n; ++x) out[x] = static_cast<i16>(a[x] - b[x]);
}

static void difference_max(const i16* DAPPLE_RESTRICT a, const i16* DAPPLE_RESTRICT b, i16* DAPPLE_RESTRICT most, uint16_t n) {
  for (uint16_t x = 0; x < n; ++x) {
    const i16 d = static_cast<i16>(a[x] - b[x]);
    most[x] = d > most[x] ? d : most[x];
  }
}

static void difference_min(const i16* DAPPLE_RESTRICT a, const i16* DAPPLE_RESTRICT b, i16* DAPPLE_RESTRICT least, uint16_t n) {
  for (uint16_t x = 0; x < n; ++x) {
    const i16 d = static_cast<i16>(a[x] - b[x]);
    least[x] = d < least[x] ? d : least[x];
  }
}

static void add(i16* DAPPLE_RESTRICT sum, const i16* DAPPLE_RESTRICT other, uint16_t n) {
  for (uint16_t x = 0; x < n; ++x) sum[x] = static_cast<i16>(sum[x] + other[x]);  // |max + min| <= 32000
}

// The shading field of rows plane[0..2 pairs-1] into most[]; least[] is work space for D-A.
static void shade(const i16* const* plane, int32_t pairs, int32_t react, i16* most, i16* least, uint16_t n) {
  difference(plane[0], plane[1], most, n);
  if (pairs == 1) return;
  const bool sum = react == difference_abs;
  if (sum) difference(plane[0], plane[1], least, n);
  for (int32_t j = 1; j < pairs; ++j) {
    difference_max(plane[2 * j], plane[2 * j + 1], most, n);
    if (sum) difference_min(plane[2 * j], plane[2 * j + 1], least, n);
  }
  if (sum) add(most, least, n);
}

static void switch_on(i16* DAPPLE_RESTRICT field, uint16_t n, i16 rho, i16 amount) {
  for (uint16_t x = 0; x < n; ++x) field[x] = field[x] > rho ? amount : static_cast<i16>(0);
}

// C' = C - (((C + 1) * 25786) >> 16) + add. For C in 0..16000 the decay is at most C and leaves at most 9705; with the
// largest impulse, 3147, C' <= 12852.
static void decay(i16* DAPPLE_RESTRICT c, const i16* DAPPLE_RESTRICT amount, uint16_t n) {
  for (uint16_t x = 0; x < n; ++x)
    c[x] = static_cast<i16>(c[x] - mulhi(static_cast<i16>(c[x] + 1), kDecay) + amount[x]);
}

// One pair in one loop: the same numbers as shade, switch_on and decay.
static void impulse_pair(i16* DAPPLE_RESTRICT a, i16* DAPPLE_RESTRICT b, uint16_t n, i16 rho, i16 amount) {
  for (uint16_t x = 0; x < n; ++x) {
    const i16 on = static_cast<i16>(a[x] - b[x]) > rho ? amount : static_cast<i16>(0);
    a[x] = static_cast<i16>(a[x] - mulhi(static_cast<i16>(a[x] + 1), kDecay) + on);
    b[x] = static_cast<i16>(b[x] - mulhi(static_cast<i16>(b[x] + 1), kDecay) + on);
  }
}

static void gather(const grid::Rows& rows, const i16** plane) {
  for (uint8_t i = 0; i < rows.planes; ++i) plane[i] = out16(rows, i);
}

void impulse_row(const grid::Rows& rows) {
  const int32_t* p = rows.p;
  const i16 rho = static_cast<i16>(p[2]), amount = static_cast<i16>(p[3]);
  if (p[0] == 1) return impulse_pair(out16(rows, 0), out16(rows, 1), rows.n, rho, amount);
  const i16* plane[grid::kMaxPlanes];
  gather(rows, plane);
  i16* most = reinterpret_cast<i16*>(rows.scratch);
  shade(plane, p[0], p[1], most, most + rows.n, rows.n);
  switch_on(most, rows.n, rho, amount);
  for (uint8_t i = 0; i < rows.planes; ++i) decay(out16(rows, i), most, rows.n);
}

void decided_row(const grid::Rows& rows) {
  i16* const amount = reinterpret_cast<i16*>(rows.scratch);
  base::copy_bytes(amount, rows.in[0], static_cast<size_t>(rows.n) * 2);
  switch_on(amount, rows.n, static_cast<i16>(rows.p[2]), static_cast<i16>(rows.p[3]));
  for (uint8_t i = 0; i < rows.planes; ++i) decay(out16(rows, i), amount, rows.n);
}

static Given given_of(const grid::Rows& rows) {
  const Given* given = nullptr;
  base::copy_bytes(&given, rows.table, sizeof given);
  return *given;
}

// A row of bits as amounts.
static void amounts(const uint8_t* DAPPLE_RESTRICT bits, i16* DAPPLE_RESTRICT out, uint16_t n, i16 amount) {
  const uint16_t whole = static_cast<uint16_t>(n & ~7u);
  for (uint16_t x = 0; x < whole; x = static_cast<uint16_t>(x + 8))
    for (uint8_t k = 0; k < 8; ++k) out[x + k] = (bits[x >> 3] >> k & 1) != 0 ? amount : static_cast<i16>(0);
  for (uint16_t x = whole; x < n; ++x) out[x] = grid::get_bit(bits, x) ? amount : static_cast<i16>(0);
}

void given_row(const grid::Rows& rows) {
  const Given given = given_of(rows);
  const int32_t* p = rows.p;
  const i16 amount = static_cast<i16>(p[3]);
  i16* most = reinterpret_cast<i16*>(rows.scratch);
  amounts(given.bits + static_cast<size_t>(rows.y) * given.row_bytes, most, rows.n, amount);
  if (rows.y >= given.top && rows.y < given.bottom) {
    const uint16_t width = static_cast<uint16_t>(given.right - given.left);
    const i16* plane[grid::kMaxPlanes];
    for (uint8_t i = 0; i < rows.planes; ++i) plane[i] = out16(rows, i) + given.left;
    shade(plane, p[0], p[1], most + given.left, most + rows.n, width);
    switch_on(most + given.left, width, static_cast<i16>(p[2]), amount);
  }
  for (uint8_t i = 0; i < rows.planes; ++i) decay(out16(rows, i), most, rows.n);
}

void add_row(const grid::Rows& rows) {
  const Given given = given_of(rows);
  i16* most = reinterpret_cast<i16*>(rows.scratch);
  amounts(given.bits + static_cast<size_t>(rows.y) * given.row_bytes, most, rows.n, static_cast<i16>(rows.p[3]));
  for (uint8_t i = 0; i < rows.planes; ++i) add(out16(rows, i), most, rows.n);
}

// |rho| <= 1600 + 8 * 128; amount (share + 1) <= 3147 * 256.
static void switch_styled(i16* DAPPLE_RESTRICT field, const i16* DAPPLE_RESTRICT style, uint16_t n, i16 rho, i16 amount) {
  for (uint16_t x = 0; x < n; ++x) {
    const i16 level = static_cast<i16>(rho + 8 * (style[x] >> 8));
    const i16 strength = static_cast<i16>((static_cast<int32_t>(amount) * ((style[x] & 255) + 1)) >> 8);
    field[x] = field[x] > level ? strength : static_cast<i16>(0);
  }
}

void impulse_styled_row(const grid::Rows& rows) {
  const int32_t* p = rows.p;
  const i16* plane[grid::kMaxPlanes];
  gather(rows, plane);
  i16* most = reinterpret_cast<i16*>(rows.scratch);
  shade(plane, p[0], p[1], most, most + rows.n, rows.n);
  switch_styled(most, plane[rows.planes - 1], rows.n, static_cast<i16>(p[2]), static_cast<i16>(p[3]));
  for (uint8_t i = 0; i < 2 * p[0]; ++i) decay(out16(rows, i), most, rows.n);
}

// C' = C + round(stencil + dt (k [on] - C)), Q16 in int32. |stencil| <= 1.11e9, dt C <= 32768 * 16000 = 5.2e8, of
// opposite signs at the extremes; |sum| < 1.7e9 < 2^31. dt is p[5], Q16, at most 1/2. The nine-point stencil is not
// monotone, hence the clamp.
static void euler(i16* DAPPLE_RESTRICT c, const int32_t* DAPPLE_RESTRICT sum, const i16* DAPPLE_RESTRICT amount,
                  uint16_t n, int32_t dt) {
  for (uint16_t x = 0; x < n; ++x) {
    const int32_t change = (sum[x] + dt * (static_cast<int32_t>(amount[x]) - c[x]) + 32768) >> 16;
    c[x] = static_cast<i16>(base::clamp(c[x] + change, 0, kLargest));
  }
}

void react_row(const grid::Rows& rows) {
  const int32_t* p = rows.p;
  const i16* plane[grid::kMaxPlanes];
  gather(rows, plane);
  i16* most = reinterpret_cast<i16*>(rows.scratch);
  shade(plane, p[0], p[1], most, most + rows.n, rows.n);
  switch_on(most, rows.n, static_cast<i16>(p[2]), static_cast<i16>(p[4]));
  for (uint8_t i = 0; i < rows.planes; ++i)
    euler(out16(rows, i), static_cast<const int32_t*>(rows.in[i]), most, rows.n, p[5]);
}

void field_row(const grid::Rows& rows) {
  const i16* plane[grid::kMaxPlanes];
  for (uint8_t i = 0; i < rows.planes; ++i) plane[i] = in16(rows, i) + rows.x;
  shade(plane, rows.p[0], rows.p[1], out16(rows, 0), reinterpret_cast<i16*>(rows.scratch), rows.n);
}

}  // namespace dapple::threshold
