// The portable kernels of strips.hpp.
// SPDX-License-Identifier: MIT
#include "mixture.hpp"

namespace dapple::stencil {

static void make_directions(const Steered& s, uint32_t column, uint64_t* direction) {
  const int32_t x = static_cast<int32_t>(column);
  const uint8_t count = static_cast<uint8_t>(base::min(64, static_cast<int32_t>(s.strip.from.width) - x));
  for (int32_t y = s.strip.first; y < s.strip.end; ++y) {
    int8_t c2[64] = {}, s2[64] = {};
    directions(s.set->field, x, y, count, c2, s2);
    int8_t* const to = reinterpret_cast<int8_t*>(direction + kDirectionWords * y);
    for (uint8_t i = 0; i < 64; ++i) to[i % 8 * 8 + i / 8] = c2[i], to[64 + i % 8 * 8 + i / 8] = s2[i];
  }
}

void steer_strip_row(const grid::Rows& rows) { steer_strip_words<uint64_t>(*static_cast<const Steered*>(rows.in[0])); }
void strip_row(const grid::Rows& rows) { strip_words<uint64_t>(*static_cast<const Strip*>(rows.in[0])); }
void turn_row(const grid::Rows& rows) { turn_words<uint64_t>(*static_cast<const Turning*>(rows.in[0])); }

}  // namespace dapple::stencil
