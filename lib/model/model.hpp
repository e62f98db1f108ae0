// What a model tells the machinery: its cells, its planes, its numbers, its row kernels. A model knows no neighbours
// (those are the stencils' business) and no grid.
// SPDX-License-Identifier: MIT
#pragma once
#include "../grid/plane.hpp"

namespace dapple {

constexpr uint8_t kMaxNumbers = 20;  // slots of one stage
constexpr uint8_t kMaxValues = 8;    // numbers a kernel is called with

// When a step happens: `step` of `steps`, the whole run of the stages that continue each other; and on which grid, coarser by
// 2^level than the finest.
struct Clock {
  uint32_t step, steps;
  uint8_t level = 0;
};

// The range of one number, 1/kMicro, that the others leave it: beyond it steps diverge, or the grid is too coarse for the pattern.
struct Bound {
  uint8_t slot;
  int32_t low, high;
};

constexpr Bound unbounded(const int32_t*, uint8_t) { return {0, INT32_MIN, INT32_MAX}; }

// A model. `number` is always the stage's slots, see Number. Unused kernels are null.
struct Model {
  grid::Cell cell;
  uint8_t radius;                 // of `window`, rows and cells
  int16_t unit;                   // what the recipe's 1.0 is in the field
  uint8_t work_rows;              // int16 rows of scratch that the kernels use
  bool (*in_range)(const int32_t* number);                        // every number within its range
  uint8_t (*planes)(const int32_t* number);
  grid::Tensor (*tensor)(const int32_t* number, uint8_t plane);   // per step, finest grid
  grid::Levels (*levels)(const int32_t* number, uint8_t plane);
  int32_t (*wavelength)(const int32_t* number);                   // cells, 1/kMicro
  int16_t (*cell_level)(const int32_t* number);                   // a cell is "on" where the field is above this
  void (*values)(const int32_t* number, Clock clock, int32_t* p); // the kernels' p for this step
  grid::RowKernel impulse;        // one macro step of reaction and decay; in place: out[plane]; scratch: work rows
  grid::RowKernel react;          // Euler: in[plane] sums of the stencil; in place: out[plane]; scratch: work rows
  grid::RowKernel window;         // a whole step: in[plane * (2 radius + 1) + k] rows y - radius + k; out[plane]
  grid::RowKernel field;          // in[plane] rows; out[0] the int16 field of n cells from x on
  bool coarse = false;            // lengths are in cells of the stage's own grid, which may stay coarser than the picture
  Bound (*bound)(const int32_t* number, uint8_t level) = unbounded;  // of what can diverge
  grid::RowKernel decided = nullptr;  // `impulse` where in[0] says what `field` would: the reaction is decided elsewhere
};

// One number of a recipe, for text, ranges and user interfaces. Values are in 1/kMicro, but for integer and word.
struct Number {
  enum Kind : uint8_t {
    decimal,   // one slot
    integer,   // one slot
    program,   // one slot: any 32 bits; text: decimal or 0x...
    word,      // one slot: index into `words`, separated by '|'
    schedule,  // four slots: from value, to value, begin, end. text: A, or A:B@BEGIN..END (ramp), or A:B@BEGIN (step)
    angles,    // five slots: degrees, one per pair
  } kind;
  const char* name;
  int32_t low, high, standard;
  const char* words;  // of Kind::word
  const char* unit;   // and what it means
};

constexpr uint8_t slots_of(Number::Kind kind) {
  return kind == Number::schedule ? 4 : kind == Number::angles ? 5 : 1;
}

constexpr bool within(int32_t value, int32_t low, int32_t high) { return value >= low && value <= high; }

// The four slots of a schedule: both values in range, begin and end ordered fractions.
constexpr bool schedule_within(const int32_t* slot, int32_t low, int32_t high) {
  return within(slot[0], low, high) && within(slot[1], low, high) && within(slot[2], 0, slot[3]) &&
         within(slot[3], 0, base::kMicro);
}

// The value of a schedule at a step, 1/kMicro: the first value until `begin`, linear to the second at `end`, then
// that. Fractions are step / steps; a step change has begin == end.
constexpr int32_t scheduled(const int32_t* slot, Clock clock) {
  const int64_t at = static_cast<int64_t>(clock.step) * base::kMicro;
  const int64_t begin = static_cast<int64_t>(slot[2]) * clock.steps, end = static_cast<int64_t>(slot[3]) * clock.steps;
  if (at < begin) return slot[0];
  if (at >= end) return slot[1];
  return slot[0] + static_cast<int32_t>(base::divide_round((static_cast<int64_t>(slot[1]) - slot[0]) * (at - begin), end - begin));
}

}  // namespace dapple
