// What a way gets of a stream's direction, eight cells at a time: pull_row of lib/stencil/flux_cell.hpp, whose formats
// and bounds these are. The upper half of a product takes five instructions here and eleven where compilers make the
// vectors.
// SPDX-License-Identifier: MIT
#pragma once
#include "../../lib/stencil/flux_cell.hpp"

namespace dapple::stencil {

typedef i16 Eight __attribute__((vector_size(16)));
typedef int32_t Four __attribute__((vector_size(16)));

inline Eight high_part(Eight a, Eight b) {
#define LOW(v) __builtin_convertvector(__builtin_shufflevector(v, v, 0, 1, 2, 3), Four)
#define HIGH(v) __builtin_convertvector(__builtin_shufflevector(v, v, 4, 5, 6, 7), Four)
  const Eight low = reinterpret_cast<Eight>(LOW(a) * LOW(b)), high = reinterpret_cast<Eight>(HIGH(a) * HIGH(b));
#undef HIGH
#undef LOW
  return __builtin_shufflevector(low, high, 1, 3, 5, 7, 9, 11, 13, 15);
}
inline Eight larger(Eight a, Eight b) { return a > b ? a : b; }
inline Eight smaller(Eight a, Eight b) { return a < b ? a : b; }
inline Eight positive(Eight a) { return larger(a, Eight{}); }
inline Eight third(Eight a) { return high_part(a, Eight{} + i16{21845}); }

// Halves of axis_of, diagonal_of and knight_of.
inline Eight pull_of(uint8_t way, Eight x, Eight y) {
  const Eight a = larger(x, -x), b = larger(y, -y), most = Eight{} + i16{16383};
  if (way < 2) {
    const Eight own = smaller(positive(x - (b - (b >> 2))), most);
    return (own + own - larger(a + (b >> 1), b + third(a))) >> 1;
  }
  const Eight up = positive(y);
  if (way < 4) return positive(up - (a + third(a))) >> 1;
  const Eight far = smaller(positive(x), most);
  return smaller(up + (up >> 2), far + far - third(far)) >> 1;
}

inline void pull_eights(const FluxSet::Stream& s, uint8_t way, const i16* map, i16* out, uint16_t n) {
  const Mirror m = mirror_of(s, way);
  for (uint16_t k = 0, count; k < n; k = static_cast<uint16_t>(k + count)) {
    count = static_cast<uint16_t>(base::min(8, n - k));
    Eight cells = {};
    if (count == 8) base::copy_bytes(&cells, map + k, sizeof cells);
    else base::copy_bytes(&cells, map + k, size_t{2} * count);
    const Eight c = cells << 8, sine = cells & ~i16{255};
    const Eight x = high_part(c, Eight{} + m.a) + high_part(sine, Eight{} + m.b),
                y = high_part(c, Eight{} + m.d) + high_part(sine, Eight{} + m.e), pull = pull_of(way, x, y);
    if (count == 8) base::copy_bytes(out + k, &pull, sizeof pull);
    else base::copy_bytes(out + k, &pull, size_t{2} * count);
  }
}

}  // namespace dapple::stencil
