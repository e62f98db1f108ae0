// What models of explicit kinetics share: concentrations that react with rates per step and diffuse, u' = u + dt (R + D
// lap u). The first numbers of every such family, and rates in fixed point. Turk 1991; docs/numbers.md, "Kinetics".
// SPDX-License-Identifier: MIT
#pragma once
#include "../base/math.hpp"
#include "model.hpp"

namespace dapple::kinetics {

// Slots; a model's own numbers follow.
enum Slot : uint8_t { scale, dt, show, above, reset, held, stretch, angle, vary, coverage, own };
enum Reset : uint8_t { none, on, off };
enum Held : uint8_t { same, apart };

// Formats. Wide cells are int32 in Q20 and show in Q10, narrow ones int16 in Q14.
constexpr uint8_t kWide = 20, kShown = 10, kNarrow = 14;
constexpr int16_t kWideUnit = 1 << kShown, kNarrowUnit = 1 << kNarrow;
constexpr uint8_t kVaryBits = 12;  // per-cell deviations
constexpr uint8_t kGuard = 5;      // sums of a step carry this many bits more than the cells

constexpr int32_t kDt[2] = {10000, 2000000}, kStretch[2] = {1000000, 2414000};  // stretch^2 <= (1 + sqrt 2)^2
constexpr int32_t kTurn = 360000000;

constexpr Number decimal(const char* name, int32_t low, int32_t high, int32_t standard, const char* unit) {
  return {Number::decimal, name, low, high, standard, nullptr, unit};
}
constexpr const char* kSpeedUnit = "cells: 1 / sqrt(s), s the rate of the reaction per step; the wavelength follows it";
constexpr const char* kLengthUnit = "length: diffusion goes with its square, the wavelength with it";
constexpr Number scale_number(int32_t low, int32_t high, int32_t standard, const char* unit = kSpeedUnit) {
  return decimal("scale", low, high, standard, unit);
}
constexpr Number dt_number(int32_t standard) {
  return decimal("dt", kDt[0], kDt[1], standard, "the time of a step; less on coarser grids, where it has to be");
}
// morphogens: separated by '|'.
constexpr Number show_number(const char* morphogens) {
  int32_t last = 0;
  for (const char* c = morphogens; *c != 0; ++c) last += *c == '|' ? 1 : 0;
  return {Number::word, "show", 0, last, 0, morphogens, "the morphogen that paint reads and `above` is about"};
}
constexpr Number above_number(int32_t low, int32_t high, int32_t standard) {
  return decimal("above", low, high, standard,
                 "concentration of the shown morphogen above which a cell is on, and `then freeze` holds it");
}
constexpr Number vary_number(int32_t high, const char* unit) { return decimal("vary", 0, high, 0, unit); }
inline constexpr Number reset_number = {Number::word,
                                        "reset",
                                        0,
                                        2,
                                        0,
                                        "none|on|off",
                                        "the cells that `then freeze` and `then reset` put back to the uniform state"};
inline constexpr Number held_number = {
    Number::word, "held", 0, 1, 0, "same|apart", "apart: held cells show as their negative, for colours of their own"};
inline constexpr Number coverage_number =
    decimal("coverage", 0, 900000, 0,
            "share of a tile's cells that are on: the field is moved until `above` has them above it; 0: as it is");
inline constexpr Number stretch_number =
    decimal("stretch", kStretch[0], kStretch[1], 1000000,
            "length over width of a spot: diffusion is its square stronger along the angle");
inline constexpr Number angle_number =
    decimal("angle", -kTurn, kTurn, 0, "degrees from x towards y (down), along the stretch");

// The ranges of a table of decimal numbers and words alone, so that programs without texts keep no word of theirs.
struct Range {
  int32_t low, high;
};
template <uint8_t n> struct Ranges {
  Range range[n];
};
template <uint8_t n> constexpr Ranges<n> ranges_of(const Number (&numbers)[n]) {
  Ranges<n> all{};
  for (uint8_t i = 0; i < n; ++i) all.range[i] = {numbers[i].low, numbers[i].high};
  return all;
}

constexpr bool in_range(const Range* range, uint8_t count, const int32_t* number) {
  for (uint8_t i = 0; i < count; ++i)
    if (!within(number[i], range[i].low, range[i].high)) return false;
  return true;
}

// The variance of a step is unused: solvers of this kind read `values`.
constexpr grid::Tensor tensor(const int32_t*, uint8_t) { return {0, 0, 0}; }

constexpr uint8_t two_planes(const int32_t*) { return 2; }

// 1/kMicro in a format of n bits after the point.
constexpr int32_t fixed(int64_t micro, uint8_t bits) {
  return static_cast<int32_t>(base::divide_round(micro * (INT64_C(1) << bits), base::kMicro));
}

// s = 1 / scale^2 on a grid coarser by 2^level, where it is 4^level as large; Q30. scale / 2^level >= 1 cell.
constexpr int64_t speed_q30(const int32_t* number, uint8_t level) {
  const int64_t length = base::divide_round((static_cast<int64_t>(number[scale]) >> level) * 1024, base::kMicro);
  return (INT64_C(1) << 50) / (length * length);
}
constexpr int64_t micro_of(int64_t q30) { return (q30 * base::kMicro) >> 30; }
constexpr int64_t q30_of(int64_t micro) { return (micro << 30) / base::kMicro; }

// The largest dt with dt (8 D + rate) < 2, all in 1/kMicro and rounded down: beyond it the checkerboard grows.
constexpr int32_t largest_dt(int64_t diffusion, int64_t rate) {
  const int64_t dt = INT64_C(2) * base::kMicro * base::kMicro / (8 * diffusion + rate + 1);
  return static_cast<int32_t>(dt < kDt[1] ? dt : kDt[1]);
}

// (product / unit)^(1/4) in 1/kMicro, of a product of two diffusions in 1/kMicro^2 and its unit.
constexpr int64_t fourth_root(int64_t product, int64_t unit) {
  const int64_t share = product * 1000 / unit * 1000000;  // 1/10^9
  return base::square_root64(static_cast<uint64_t>(base::square_root64(static_cast<uint64_t>(share) * 1000)) * 1000000);
}

// A length in 1/kMicro of patterns stretched along a direction: `round` where they are not. Spots take room in proportion
// to 1 / stretch, so that the mean of the lengths along and across goes with its root.
constexpr int32_t stretched(int64_t round, int32_t stretch) {
  const int64_t root = base::square_root64(static_cast<uint64_t>(stretch) * base::kMicro);
  return static_cast<int32_t>(base::divide_round(round * base::kMicro, root));
}

// A scale below `least` cells of the grid is too coarse for the pattern; otherwise dt has a largest value.
constexpr Bound bound_of(const int32_t* number, uint8_t level, int32_t least, int32_t most) {
  if ((number[scale] >> level) < least) return {scale, least << level, INT32_MAX};
  return {dt, 0, level == 0 ? most : INT32_MAX};
}

// A rate per step: a mantissa of 9 to 10 bits and a shift. With x in Qn, (x mantissa) >> shift is x times the rate,
// within 1/1024 of it, floored in Q(bits + kGuard); what a step adds is rounded from there once.
struct Rate {
  int32_t mantissa, shift;
};
// from: n. rate_q30 < 2^(from + 35 - bits), so that the shift is not negative.
constexpr Rate rate_of(int64_t rate_q30, uint8_t from, uint8_t bits) {
  uint8_t cut = 0;
  while (cut < 30 && base::divide_round(rate_q30, INT64_C(1) << cut) >= 1024) ++cut;
  return {static_cast<int32_t>(base::divide_round(rate_q30, INT64_C(1) << cut)),
          static_cast<int32_t>(from) + 30 - cut - bits - kGuard};
}

// In one value of a kernel.
constexpr int32_t packed(Rate rate) { return rate.mantissa + rate.shift * (INT32_C(1) << 16); }
constexpr Rate unpacked(int32_t p) { return {p & 0xffff, p >> 16}; }

// x times a rate, in Q(bits + kGuard).
DAPPLE_INLINE int32_t times(int32_t x, Rate rate) { return (x * rate.mantissa) >> rate.shift; }
// A sum in Q20 as its part of a step: rounded to Q14 before the product. |lap| <= 80.
DAPPLE_INLINE int32_t diffused(int32_t lap, Rate rate) { return times((lap + 32) >> 6, rate); }
// A cell after a step: rounded once, then held within its range.
DAPPLE_INLINE int32_t stepped(int32_t cell, int32_t sum, int32_t low, int32_t high) {
  return base::clamp(cell + ((sum + 16) >> kGuard), low, high);
}

// One row of a wide reaction of two morphogens. in: sums of a and b, then deviations (Q12); out: a, b in place. A Reaction
// makes one step of a cell: step(a, b, sum of a, sum of b, deviation).
template <class Reaction>
void react_cells(int32_t* DAPPLE_RESTRICT a, int32_t* DAPPLE_RESTRICT b, const int32_t* DAPPLE_RESTRICT lap_a,
                 const int32_t* DAPPLE_RESTRICT lap_b, const int32_t* DAPPLE_RESTRICT more, uint16_t n,
                 Reaction reaction) {
  for (uint16_t x = 0; x < n; ++x) reaction.step(a[x], b[x], lap_a[x], lap_b[x], more[x]);
}
template <class Reaction>
void react_rows(const grid::Rows& rows, Reaction reaction) {
  react_cells(grid::out32(rows, 0), grid::out32(rows, 1), grid::in32(rows, 0), grid::in32(rows, 1),
              grid::in32(rows, 2), rows.n, reaction);
}

// What is above `above`, in the format that is shown.
constexpr int16_t wide_level(const int32_t* number) { return static_cast<int16_t>(fixed(number[above], kShown)); }
constexpr int16_t narrow_level(const int32_t* number) {
  return static_cast<int16_t>(base::min(fixed(number[above], kNarrow), INT32_C(32767)));
}

// A model of this kind, with what all of them share. rows: of work, for its reaction.
constexpr Model model_of(grid::Cell cell, uint8_t rows, bool (*in_range)(const int32_t*), uint8_t (*planes)(const int32_t*),
                         grid::Levels (*levels)(const int32_t*, uint8_t), int32_t (*wavelength)(const int32_t*),
                         void (*values)(const int32_t*, Clock, int32_t*), grid::RowKernel react,
                         Bound (*bound)(const int32_t*, uint8_t)) {
  const bool wide = cell == grid::Cell::int32;
  return {cell,   0,       wide ? kWideUnit : kNarrowUnit, rows,       in_range,
          planes, tensor,  levels,                         wavelength, wide ? wide_level : narrow_level,
          values, nullptr, react,                          nullptr,    nullptr,
          false,  bound};
}

// --- Compact cells: a wide model kept in int16, `cut` bits less of the Q20, which its steps are computed in. What is cut
// off is rounded up as often as it is large, by a hash of place and step: changes below the last bit are kept on the
// average, where rounding to nearest would stall (the solver does that, evolve/kinetics.cpp).
constexpr uint8_t kCompactVary = 9;  // bits of per-cell deviations
constexpr uint8_t cut_of(const Model& model) {
  uint8_t cut = 0;
  for (int32_t unit = model.unit; model.cell == grid::Cell::int16 && unit < kNarrowUnit; unit *= 2) ++cut;
  return static_cast<uint8_t>(cut == 0 ? 0 : cut + kWide - kNarrow);
}
template <uint8_t bits>
constexpr int16_t compact_level(const int32_t* number) {
  return static_cast<int16_t>(base::min(fixed(number[above], bits), INT32_C(32767)));
}
template <uint8_t bits, grid::Levels (*wide)(const int32_t*, uint8_t)>
constexpr grid::Levels compact_levels(const int32_t* number, uint8_t plane) {
  const grid::Levels l = wide(number, plane);
  const auto cut = [](int32_t level) { return base::min(level >> (kWide - bits), INT32_C(32767)); };
  return {cut(l.background), cut(l.disc), cut(l.low), cut(l.high)};
}
template <uint8_t bits, grid::Levels (*wide)(const int32_t*, uint8_t)>
constexpr Model compact_of(Model model) {
  model.cell = grid::Cell::int16;
  model.unit = static_cast<int16_t>(1 << bits);
  model.levels = compact_levels<bits, wide>;
  model.cell_level = compact_level<bits>;
  return model;
}

// dt of a step on this grid, 1/kMicro.
constexpr int32_t step_of(const int32_t* number, int32_t most) { return number[dt] < most ? number[dt] : most; }

// A rate of s dt, s in Q30.
constexpr int64_t times_dt(int64_t q30, int32_t step) { return base::divide_round(q30 * step, base::kMicro); }

}  // namespace dapple::kinetics
