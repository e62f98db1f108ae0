// What seed discs are drawn with, wherever their centres are.
// SPDX-License-Identifier: MIT
#pragma once
#include "../base/math.hpp"
#include "start.hpp"

namespace dapple::start {

constexpr uint32_t kJitterX = 64, kJitterY = 65;  // hash streams

// floor(a / b), b > 0.
constexpr int64_t floor_divide(int64_t a, int64_t b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

// U * jitter / 2 in units of 1/256 of a cell when `spacing` is (Q8): |result| <= jitter * spacing.
constexpr int64_t shake(uint32_t h, int32_t jitter, int64_t spacing) {
  const int64_t unit = static_cast<int64_t>(h >> 16) - 32768;  // U * 32768
  return ((unit * jitter / base::kMicro) * spacing) >> 15;
}

// A row of cells without discs.
void clear_row(const Place& place, const Levels& levels, void* row);

// Half the width of a disc on the row of cells whose centre line is y, all in 1/256 cell; negative where the row misses it.
// `high` is the height of the torus.
int64_t half_chord(const Place& place, const Start& start, int64_t high, int64_t centre_y, int64_t y);

// The cells whose centres lie within `half` of centre_x.
void fill_chord(const Place& place, int64_t centre_x, int64_t half, int32_t value, void* row);

}  // namespace dapple::start
