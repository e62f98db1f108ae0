// The threshold family: activator-inhibitor pairs whose reaction is on or off. Witkin & Kass 1991, eq. 13 to 15.
// SPDX-License-Identifier: MIT
#pragma once
#include "../base/math.hpp"
#include "model.hpp"

namespace dapple::threshold {

constexpr int16_t kUnit = 8000;    // k/b = 1; concentrations are 0..kLargest
constexpr int16_t kLargest = 16000;
constexpr int16_t kDecay = 25786;  // 2 round(2^15 (1 - e^-1/2)): decay over a macro step b dt = 1/2
constexpr int32_t kImpulse = 3147; // round(8000 (1 - e^-1/2)): what the reaction adds over a macro step at k/b = 1

// Slots. Plane 2j is the activator of pair j, plane 2j + 1 its inhibitor.
enum Slot : uint8_t { pairs, react, diffusion, scale, stretch, ratio, angles, rho = angles + 5, k = rho + 4, slots = k + 4 };
enum React : uint8_t { max_difference, difference_abs };
enum Diffusion : uint8_t { oriented, isotropic };

constexpr int32_t kScale[2] = {400000, 8000000}, kStretch[2] = {1000000, 5000000}, kRatio[2] = {1100000, 3000000};
constexpr int32_t kLargestRho = 200000;
constexpr int32_t kTurn = 360000000;

inline constexpr Number numbers[] = {
    {Number::integer, "pairs", 1, 5, 1, nullptr, "activator-inhibitor pairs"},
    {Number::word, "react", 0, 1, 0, "md|da", "md: max of differences (14); da: difference of abs (15)"},
    {Number::word, "diffusion", 0, 1, 0, "oriented|isotropic", "shape of the diffusion tensors"},
    {Number::decimal, "scale", kScale[0], kScale[1], 2000000, nullptr, "cells: s, the activator's range across the stripes"},
    {Number::decimal, "stretch", kStretch[0], kStretch[1], 2000000, nullptr, "e, the range along the stripes in units of s"},
    {Number::decimal, "ratio", kRatio[0], kRatio[1], 1500000, nullptr, "d, the inhibitor's range in units of the activator's"},
    {Number::angles, "angle", -kTurn, kTurn, 0, nullptr, "degrees from x towards y (down), along the stripes"},
    {Number::schedule, "rho", -kLargestRho, kLargestRho, 0, nullptr, "k/b: the threshold on the difference"},
    {Number::schedule, "k", 0, base::kMicro, base::kMicro, nullptr, "k/b: the strength of the reaction"},
};

// All but the slot `diffusion`, which another family may use for something else.
constexpr bool shared_in_range(const int32_t* number, int32_t most_pairs) {
  for (uint8_t j = 0; j < 5; ++j)
    if (!within(number[angles + j], -2 * kTurn, 2 * kTurn)) return false;
  return within(number[pairs], 1, most_pairs) && within(number[react], 0, 1) &&
         within(number[scale], kScale[0], kScale[1]) && within(number[stretch], kStretch[0], kStretch[1]) &&
         within(number[ratio], kRatio[0], kRatio[1]) && schedule_within(number + rho, -kLargestRho, kLargestRho) &&
         schedule_within(number + k, 0, base::kMicro);
}
constexpr bool in_range(const int32_t* number) { return within(number[diffusion], 0, 1) && shared_in_range(number, 5); }

constexpr uint8_t planes(const int32_t* number) { return static_cast<uint8_t>(2 * number[pairs]); }

// [a1, a2] of a plane as variances over b dt = 1/2, 2 dt A = A, with e1 along x: P+ = [e s, s], P- = [e s, d s]; isotropic
// P+ = [s, s], P- = [d s, d s].
constexpr grid::Tensor axes_of(const int32_t* number, uint8_t plane, bool round) {
  const int64_t s = number[scale];
  const int64_t wide = plane & 1 ? s * number[ratio] / base::kMicro : s;
  const int64_t a1 = round ? wide : s * number[stretch] / base::kMicro, a2 = wide;  // 1/kMicro cells
  const int64_t scaled = INT64_C(1000000000000) / 65536;                            // kMicro^2 to Q16 (floor 15258789)
  return {static_cast<int32_t>(a1 * a1 / scaled), 0, static_cast<int32_t>(a2 * a2 / scaled)};
}

// A = a1^2 e1 e1^T + a2^2 e2 e2^T with e1 along the angle.
constexpr grid::Tensor tensor(const int32_t* number, uint8_t plane) {
  const grid::Tensor axes = axes_of(number, plane, number[diffusion] == isotropic);
  if (number[diffusion] == isotropic) return axes;
  const int64_t v1 = axes.xx, v2 = axes.yy;
  const uint16_t theta = base::angle_of(number[angles + plane / 2]);
  const int64_t c = base::cosine(theta), n = base::sine(theta);
  const int64_t one = INT64_C(32767) * 32767;
  return {static_cast<int32_t>(base::divide_round(v1 * c * c + v2 * n * n, one)),
          static_cast<int32_t>(base::divide_round((v1 - v2) * c * n, one)),
          static_cast<int32_t>(base::divide_round(v1 * n * n + v2 * c * c, one))};
}

// Noise is uniform over 0..16000 in every plane; seed discs hold k/b in both planes of every pair, so that the
// difference starts at 0 and turns positive in the middle first.
constexpr grid::Levels levels(const int32_t*, uint8_t) { return {0, kUnit, 0, kLargest}; }

// 2 pi s sqrt(d / b), the wavelength that grows fastest (closed form of eq. 3, 13), cells in 1/kMicro.
constexpr int32_t wavelength(const int32_t* number) {
  const int64_t root = base::square_root64(static_cast<uint64_t>(number[ratio]) * base::kMicro);  // sqrt(d), 1/kMicro
  return static_cast<int32_t>(static_cast<int64_t>(number[scale]) * root / base::kMicro * 6283185 / base::kMicro);
}

constexpr int16_t to_unit(int32_t micro) {
  return static_cast<int16_t>(base::divide_round(static_cast<int64_t>(micro) * kUnit, base::kMicro));
}

// Shading field above the final rho.
constexpr int16_t cell_level(const int32_t* number) { return to_unit(number[rho + 1]); }

// p: {pairs, react, rho in concentration units, impulse of a macro step, k in concentration units}
constexpr void values(const int32_t* number, Clock clock, int32_t* p) {
  const int32_t strength = scheduled(number + k, clock);
  p[0] = number[pairs];
  p[1] = number[react];
  p[2] = to_unit(scheduled(number + rho, clock));
  p[3] = static_cast<int32_t>(base::divide_round(static_cast<int64_t>(strength) * kImpulse, base::kMicro));
  p[4] = to_unit(strength);
}

// The reaction given as bits instead, on a whole grid: row y at bits + y row_bytes; but for a rectangle, where it lives.
struct Given {
  const uint8_t* bits;
  uint16_t row_bytes, left, right, top, bottom;
};

// rows.table holds the address of a Given. given_row: impulse_row with the reaction given; add_row: C' = C + (bit ? p[3] : 0),
// the rectangle too; C <= 16000 as long as what is added sums up to no more.
void given_row(const grid::Rows& rows);
void add_row(const grid::Rows& rows);

void impulse_row(const grid::Rows& rows);
// The same with a style for every cell, in the last plane: steps of kUnit / 1000 on rho in its high byte, the share of k in its low one.
void impulse_styled_row(const grid::Rows& rows);
void decided_row(const grid::Rows& rows);
void react_row(const grid::Rows& rows);
void field_row(const grid::Rows& rows);

}  // namespace dapple::threshold

namespace dapple {
inline constexpr Model threshold_model DAPPLE_ROM = {
    grid::Cell::int16,        0,                      threshold::kUnit,    2,
    threshold::in_range,      threshold::planes,      threshold::tensor,      threshold::levels,   threshold::wavelength,
    threshold::cell_level,    threshold::values,      threshold::impulse_row, threshold::react_row,
    nullptr,                  threshold::field_row,     false,               unbounded,
    threshold::decided_row};
}  // namespace dapple
