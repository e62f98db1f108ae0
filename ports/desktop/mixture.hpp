// The mixture of steerable masks (lib/stencil/steer.hpp) on words of one-bit cells, in int16 and without putting cells
// in order: turned bits (turn_bits) leave byte b of word i to cell 8 b + i, and so do directions that are kept; what
// comes of a byte of word i is bit i of the new cells. Same bits as lib/stencil/steer.cpp.
// SPDX-License-Identifier: MIT
#pragma once
#include "../../lib/stencil/steer.hpp"
#include "strip_rows.hpp"

namespace dapple::stencil {

// A word as numbers of 16 bits and back, and as what bits are turned in; of Wide in steered.hpp.
typedef int16_t FourShorts __attribute__((vector_size(8)));
inline FourShorts shorts_of(uint64_t word) { return (FourShorts)word; }
inline void set_word(FourShorts shorts, uint64_t& word) { word = (uint64_t)shorts; }
inline uint64_t lanes_of(uint64_t word) { return word; }

template <class W>
using Shorts = decltype(shorts_of(W{}));

// The bytes at even and at odd places of a word, as numbers.
template <bool odd, class W>
DAPPLE_INLINE Shorts<W> bytes_of(W word) {
  if constexpr (odd) return shorts_of(word) >> 8;
  else return shorts_of(word) << 8 >> 8;
}

// Words of a row of cells: cos and sin of their doubled directions, Q7.
constexpr uint8_t kTurnedWords = 8, kDirectionWords = 2 * kTurnedWords;

// Whether 128 D > 128 threshold, of the cells at even or odd bytes of word i: -1 or 0.
//   c, s     Q7, |(c, s)| < 129.1: within +-127, a rounded unit vector or a shorter one (tests/desktop/steered.cpp)
//   c2, s2   c tc - s ts + 64 < 129.1^2 + 64 < 2^15 before the shift; |(c2, s2)| < 129.1^2 / 128 + .8 < 131.1
//   c4, s4   |c2^2 - s2^2|, |2 c2 s2| <= 131.1^2 < 2^15; |(c4, s4)| < 131.1^2 / 128 + .8 < 135.1
//   x, y     c2 d1 + s2 d2 and c4 d3 + s4 d4: at most 135.1 * 127 * sqrt(2) = 24265 < 2^15
// x + y would take 17 bits: 128 D > 128 threshold is x + y > 128 (threshold - d0), an even number, and so the half of
// x + y, rounded up, > 64 (threshold - d0), |.| <= 64 * 254 = 16256.
template <bool odd, class W>
DAPPLE_INLINE Shorts<W> above(const SteerSet& set, const W (*sum)[kTurnedWords], const W* direction, uint8_t i,
                              int16_t threshold) {
  using S = Shorts<W>;
  const S c = bytes_of<odd>(direction[i]), s = bytes_of<odd>(direction[kTurnedWords + i]);
  const S d1 = bytes_of<odd>(sum[1][i]), d2 = bytes_of<odd>(sum[2][i]), d3 = bytes_of<odd>(sum[3][i]),
          d4 = bytes_of<odd>(sum[4][i]);
  const S least = (threshold - bytes_of<odd>(sum[0][i])) * 64;
  S on = {};
  for (uint8_t t = 0; t < set.threads; ++t) {
    const int16_t tc = set.c2[t], ts = set.s2[t];
    const S c2 = (c * tc - s * ts + 64) >> 7, s2 = (s * tc + c * ts + 64) >> 7;
    const S c4 = (c2 * c2 - s2 * s2 + 64) >> 7, s4 = (2 * c2 * s2 + 64) >> 7;
    const S x = c2 * d1 + s2 * d2, y = c4 * d3 + s4 * d4;
    on |= (x >> 1) + (y >> 1) + ((x | y) & 1) > least;
  }
  return on;
}

// The new cells of a word; sum: of every mask, turned.
template <class W>
DAPPLE_INLINE W mixed(const SteerSet& set, const W (*sum)[kTurnedWords], const W* direction, int16_t threshold) {
  using L = decltype(lanes_of(W{}));
  L cells = {}, bit = cells + UINT64_C(0x0101010101010101);
  for (uint8_t i = 0; i < kTurnedWords; ++i) {
    const Shorts<W> even = above<false>(set, sum, direction, i, threshold);
    const Shorts<W> odd = above<true>(set, sum, direction, i, threshold);
    W both;
    set_word((even & 255) | (odd & -256), both);
    cells |= lanes_of(both) & bit;
    bit += bit;
  }
  return cells;
}

// The lower eight places of a sum, which all its cells fit, as bytes.
template <class W>
DAPPLE_INLINE void turned_sum(const W* sum, W* turned) {
  decltype(lanes_of(W{})) w[kTurnedWords];
  for (uint8_t k = 0; k < kTurnedWords; ++k) w[k] = lanes_of(sum[k]);
  turn_bits(w);
  for (uint8_t k = 0; k < kTurnedWords; ++k) turned[k] = w[k];
}

// A column after the other; make_directions(s, its first cell, words of its row 0) fills rows first .. end - 1.
template <class W>
static void steer_strip_words(const Steered& s) {
  const Strip& strip = s.strip;
  Strip sums = strip;
  sums.threshold = -1;  // D itself
  WorldTaps taps;
  reach<W>(*strip.world, taps);
  uint8_t* const to = strip.to + strip.from.pitch * strip.first;
  W* direction = reinterpret_cast<W*>(s.directions);
  for (uint32_t column = 0; column < strip.from.width; column += 8 * static_cast<uint32_t>(sizeof(W))) {
    if (s.fresh) make_directions(s, column, direction);
    strip_column<W>(sums, column, strip.end, 0, taps.whole, taps.change, to, strip.from.pitch,
                    [&](const W(*sum)[kSumBits], int32_t y, const uint8_t*) {
                      W turned[kSteerable][kTurnedWords];
                      for (uint8_t m = 0; m < kSteerable; ++m) turned_sum(sum[m], turned[m]);
                      return mixed<W>(*s.set, turned, direction + kDirectionWords * static_cast<size_t>(y),
                                      strip.threshold);
                    });
    direction += kDirectionWords * size_t{strip.from.height};
  }
}

}  // namespace dapple::stencil
