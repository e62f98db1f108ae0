// Binary convolution by masks the compiler knows: straight-line code without a table of taps, the smallest and fastest there
// is on cores with 8-bit words. Taps go one by one into a carry-save sum in which at most two words wait at every binary
// place. The sum is D modulo 256 in two's complement, and |D| <= 127, so nothing is lost. Same bits as convolve.hpp.
// SPDX-License-Identifier: MIT
#pragma once
#include "slices.hpp"

namespace dapple::stencil {

constexpr uint8_t kDifferenceBits = 8;

// Masks as constants. running: weights are what the mask of the next row has more than this one's, in 2 radius + 2 rows,
// D(y + 1) = D(y) + change * R; else the masks themselves. count 0: they cannot be made.
struct KnownMasks {
  uint8_t count, radius;
  int16_t sum;  // P of the first mask
  bool running;
  int8_t weight[kMaxMasks][(kLargestSide + 1) * kLargestSide];
};

constexpr uint8_t window_rows_of(const KnownMasks& m) { return static_cast<uint8_t>(2 * m.radius + (m.running ? 2 : 1)); }

constexpr uint16_t unit_taps(const int8_t* weight, uint16_t cells) {
  uint16_t taps = 0;
  for (uint16_t i = 0; i < cells; ++i)
    for (uint8_t w = static_cast<uint8_t>(weight[i] < 0 ? -weight[i] : weight[i]); w > 0; w = static_cast<uint8_t>(w & (w - 1))) ++taps;
  return taps;
}

// Runs down the rows where that takes fewer taps, although `rows` rows then cost 2 radius + 1 more.
constexpr KnownMasks known_masks(const Mask* masks, uint8_t count, uint16_t rows) {
  KnownMasks whole{count, masks[0].radius, masks[0].sum, false, {}}, change = whole;
  change.running = true;
  const uint16_t side = static_cast<uint16_t>(2 * masks[0].radius + 1), cells = static_cast<uint16_t>(side * side);
  uint32_t whole_taps = 0, change_taps = 0;
  for (uint8_t j = 0; j < count; ++j) {
    for (uint16_t i = 0; i < cells + side; ++i) {
      const int8_t here = i < cells ? masks[j].weight[i] : static_cast<int8_t>(0);
      const int8_t next = i >= side ? masks[j].weight[i - side] : static_cast<int8_t>(0);
      if (i < cells) whole.weight[j][i] = here;
      change.weight[j][i] = static_cast<int8_t>(next - here);
    }
    whole_taps += unit_taps(whole.weight[j], cells);
    change_taps += unit_taps(change.weight[j], static_cast<uint16_t>(cells + side)) + kDifferenceBits;
  }
  return change_taps * (rows + side) < whole_taps * rows ? change : whole;
}

// --- the sum: one[i] and two[i] are the words that wait at place i; two bits of `waiting` for each place say how many. -----

template <class W> struct WaitingSum {
  W one[kDifferenceBits], two[kDifferenceBits];
};

constexpr uint32_t one_at(uint8_t place) { return UINT32_C(1) << (2 * place); }
constexpr uint8_t waiting_at(uint32_t waiting, uint8_t place) { return static_cast<uint8_t>((waiting >> (2 * place)) & 3); }

// What waits after one more word at `place`: a third becomes one and a carry.
constexpr uint32_t after_push(uint32_t waiting, uint8_t place) {
  while (place < kDifferenceBits && waiting_at(waiting, place) == 2) waiting -= one_at(place++);
  return place < kDifferenceBits ? waiting + one_at(place) : waiting;
}
constexpr uint32_t after_weight(uint32_t waiting, uint8_t magnitude) {
  for (uint8_t place = 0; magnitude >> place != 0; ++place)
    if ((magnitude >> place) & 1) waiting = after_push(waiting, place);
  return waiting;
}

template <uint8_t place, uint32_t waiting, class W> DAPPLE_INLINE void push(WaitingSum<W>& s, W bits) {
  if constexpr (place < kDifferenceBits) {
    if constexpr (waiting_at(waiting, place) == 0) s.one[place] = bits;
    else if constexpr (waiting_at(waiting, place) == 1) s.two[place] = bits;
    else {
      W carry;
      full_add(s.one[place], s.two[place], bits, s.one[place], carry);
      base::in_order(s.one[place]);
      base::in_order(carry);
      push<place + 1, waiting - one_at(place)>(s, carry);
    }
  }
}

template <uint8_t magnitude, uint8_t place, uint32_t waiting, class W> DAPPLE_INLINE void push_weight(WaitingSum<W>& s, W bits) {
  if constexpr (magnitude >> place != 0) {
    constexpr bool on = (magnitude >> place) & 1;
    if constexpr (on) push<place, waiting>(s, bits);
    push_weight<magnitude, place + 1, on ? after_push(waiting, place) : waiting>(s, bits);
  }
}

// Two that wait become one, from the lowest place up.
template <uint8_t place, uint32_t waiting, class W> DAPPLE_INLINE void settle(WaitingSum<W>& s, W* out) {
  if constexpr (place < kDifferenceBits) {
    constexpr uint8_t count = waiting_at(waiting, place);
    out[place] = count == 0 ? W{0} : count == 1 ? s.one[place] : static_cast<W>(s.one[place] ^ s.two[place]);
    if constexpr (count == 2) {
      push<place + 1, waiting>(s, static_cast<W>(s.one[place] & s.two[place]));
      settle<place + 1, after_push(waiting, place + 1)>(s, out);
    } else {
      settle<place + 1, waiting>(s, out);
    }
  }
}

// --- the taps --------------------------------------------------------------------------------------------------------------

// Word `at` of the rows of the window, and the words beside it, around the torus.
template <class W> struct WordPlace {
  const W* const* row;
  uint8_t at, before, after;
};

// Three words of a row, moved cell by cell to the right and then to the left: `now` holds cells x + distance.
template <class W> struct Shifter {
  W here, before, after, now;
  uint16_t pair;  // 8-bit words: two of them, moved a bit at a time
};

template <int8_t distance, class W> DAPPLE_INLINE void shift(Shifter<W>& s) {
  constexpr uint8_t bits = 8 * sizeof(W), by = distance < 0 ? -distance : distance;
  if constexpr (distance == 0) {
    s.now = s.here;
  } else if constexpr (bits == 8) {
    if constexpr (distance == -1) s.pair = base::join(s.before, s.here);
    if constexpr (distance == 1) s.pair = base::join(s.here, s.after);
    s.pair = static_cast<uint16_t>(distance < 0 ? s.pair << 1 : s.pair >> 1);
    base::in_order(s.pair);
    s.now = static_cast<W>(distance < 0 ? s.pair >> 8 : s.pair);
  } else {
    s.now = static_cast<W>(distance < 0 ? (s.here << by) | (s.before >> (bits - by)) : (s.here >> by) | (s.after << (bits - by)));
  }
}

// Columns in the order 0, -1 .. -r, 1 .. r.
constexpr int8_t distance_of(uint8_t column, uint8_t radius) {
  return static_cast<int8_t>(column <= radius ? -static_cast<int16_t>(column) : column - radius);
}
constexpr int8_t weight_of(const KnownMasks& m, uint8_t mask, uint16_t cell) {
  const uint16_t side = static_cast<uint16_t>(2 * m.radius + 1);
  return m.weight[mask][cell / side * side + m.radius + distance_of(static_cast<uint8_t>(cell % side), m.radius)];
}

// Is there a weight at a cell, or further out on its side of the row? In the row?
constexpr bool weighs(const KnownMasks& m, uint8_t mask, uint16_t cell) {
  const uint16_t side = static_cast<uint16_t>(2 * m.radius + 1), column = cell % side;
  for (uint16_t c = column; c < (column <= m.radius ? m.radius + 1u : side); ++c)
    if (weight_of(m, mask, static_cast<uint16_t>(cell - column + c)) != 0) return true;
  return false;
}
constexpr bool row_weighs(const KnownMasks& m, uint8_t mask, uint16_t row) {
  const uint16_t first = static_cast<uint16_t>(row * (2 * m.radius + 1));
  return weighs(m, mask, first) || weighs(m, mask, static_cast<uint16_t>(first + m.radius + 1));
}

template <const KnownMasks& masks, uint8_t mask, uint16_t cell, uint32_t waiting, class W>
DAPPLE_INLINE void add_cells(const WordPlace<W>& place, Shifter<W>& s, WaitingSum<W>& sum, W* out) {
  constexpr uint8_t side = 2 * masks.radius + 1;
  if constexpr (cell == window_rows_of(masks) * side) {
    settle<0, waiting>(sum, out);
  } else {
    if constexpr (cell % side == 0 && row_weighs(masks, mask, cell / side)) {
      const W* const row = place.row[cell / side];
      s.here = row[place.at];
      s.before = row[place.before];
      s.after = row[place.after];
    }
    constexpr int8_t weight = weight_of(masks, mask, cell);
    constexpr uint8_t magnitude = weight < 0 ? -weight : weight;
    if constexpr (weighs(masks, mask, cell)) shift<distance_of(cell % side, masks.radius)>(s);
    if constexpr (weight != 0) {
      base::in_order(s.now);
      push_weight<magnitude, 0, waiting>(sum, weight < 0 ? static_cast<W>(~s.now) : s.now);
    }
    add_cells<masks, mask, cell + 1, after_weight(waiting, magnitude)>(place, s, sum, out);
  }
}

// -w R = w (1 - R) - w: what all negative weights leave over, modulo 256.
constexpr uint8_t left_over(const KnownMasks& m, uint8_t mask) {
  uint8_t sum = 0;
  for (uint16_t i = 0; i < window_rows_of(m) * (2 * m.radius + 1); ++i)
    if (m.weight[mask][i] < 0) sum = static_cast<uint8_t>(sum + m.weight[mask][i]);
  return sum;
}
constexpr uint32_t at_first(const KnownMasks& m, uint8_t mask) {
  uint32_t waiting = 0;
  for (uint8_t i = 0; i < kDifferenceBits; ++i)
    waiting += one_at(i) * ((m.running ? 1u : 0u) + ((left_over(m, mask) >> i) & 1u));
  return waiting;
}

template <const KnownMasks& masks, uint8_t mask, uint8_t place, class W> DAPPLE_INLINE void begin_sum(const W* d, WaitingSum<W>& s) {
  if constexpr (place < kDifferenceBits) {
    constexpr bool more = (left_over(masks, mask) >> place) & 1;
    s.one[place] = masks.running ? d[place] : static_cast<W>(~W{0});
    if constexpr (masks.running && more) s.two[place] = static_cast<W>(~W{0});
    begin_sum<masks, mask, place + 1>(d, s);
  }
}

// D of one word of cells in two's complement, d[0] the lowest bits. running: d is that of the row before.
template <const KnownMasks& masks, uint8_t mask, class W> DAPPLE_APART void known_difference(const WordPlace<W>& place, W* d) {
  WaitingSum<W> sum;
  Shifter<W> shifter;
  begin_sum<masks, mask, 0>(d, sum);
  add_cells<masks, mask, 0, at_first(masks, mask)>(place, shifter, sum, d);
}

// Bit i: D of cell i > threshold.
template <class W> inline W above(const W* d, int8_t threshold) {
  W result = 0;
  uint8_t bits = static_cast<uint8_t>(threshold);
  for (uint8_t i = 0; i + 1 < kDifferenceBits; ++i, bits = static_cast<uint8_t>(bits >> 1))
    result = (bits & 1) != 0 ? static_cast<W>(result & d[i]) : static_cast<W>(result | d[i]);
  const W positive = static_cast<W>(~d[kDifferenceBits - 1]);
  return threshold < 0 ? static_cast<W>(result | positive) : static_cast<W>(result & positive);
}

// most = the larger of both, cell by cell.
template <class W> inline void take_larger(const W* d, W* most) {
  W larger = 0;  // d > most
  for (uint8_t i = 0; i < kDifferenceBits; ++i) {
    const bool sign = i + 1 == kDifferenceBits;
    const W a = sign ? most[i] : d[i], b = sign ? d[i] : most[i];
    larger = static_cast<W>((a & ~b) | (larger & ~(a ^ b)));
  }
  for (uint8_t i = 0; i < kDifferenceBits; ++i) most[i] = static_cast<W>(most[i] ^ ((most[i] ^ d[i]) & larger));
}

}  // namespace dapple::stencil
