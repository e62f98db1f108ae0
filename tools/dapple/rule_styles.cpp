// Random cell programs, and when two of them are one.
// SPDX-License-Identifier: MIT
#include "rule_styles.hpp"

#include <algorithm>

#include "base/hash.hpp"

namespace cli {

constexpr unsigned kLeft = 16, kRight = 8, kUpper = 4, kLower = 2, kSelf = 1;

// The neighbourhood with two neighbours exchanged.
static unsigned exchanged(unsigned index, unsigned a, unsigned b) {
  const bool both = ((index & a) != 0) == ((index & b) != 0);
  return both ? index : index ^ (a | b);
}

static unsigned neighbours_on(unsigned index) {
  return (index >> 4 & 1) + (index >> 3 & 1) + (index >> 2 & 1) + (index >> 1 & 1);
}

uint32_t random_program(Style style, uint32_t seed, uint32_t index) {
  const uint32_t stream = static_cast<uint32_t>(style);
  const uint32_t thrown = dapple::base::hash(seed, stream, 0, static_cast<int32_t>(index));
  const uint32_t keep = dapple::base::hash(seed, stream, 1, static_cast<int32_t>(index));
  uint32_t program = 0;
  for (unsigned k = 0; k < 32; ++k) {
    unsigned source = k;
    if (style == Style::mirror)
      source = std::min({k, exchanged(k, kLeft, kRight), exchanged(k, kUpper, kLower),
                         exchanged(exchanged(k, kLeft, kRight), kUpper, kLower)});
    if (style == Style::outer_totalistic) source = 2 * neighbours_on(k) + (k & kSelf);
    uint32_t bit = thrown >> source & 1;
    if (style == Style::inertia && (keep >> k & 1) != 0) bit = k & kSelf;
    program |= bit << k;
  }
  return program;
}

template <class Change>
static uint32_t changed(uint32_t program, Change change) {
  uint32_t result = 0;
  for (unsigned k = 0; k < 32; ++k) result |= (program >> change(k) & 1) << k;
  return result;
}

uint32_t representative(uint32_t program) {
  const auto mirror = [](unsigned k) { return exchanged(k, kLeft, kRight); };
  const auto flip = [](unsigned k) { return exchanged(k, kUpper, kLower); };
  const auto transpose = [](unsigned k) { return exchanged(exchanged(k, kLeft, kUpper), kRight, kLower); };
  const auto inverse = [](unsigned k) { return k ^ 31; };
  uint32_t least = program;
  for (unsigned way = 0; way < 16; ++way) {
    uint32_t p = program;
    if ((way & 1) != 0) p = changed(p, mirror);
    if ((way & 2) != 0) p = changed(p, flip);
    if ((way & 4) != 0) p = changed(p, transpose);
    if ((way & 8) != 0) p = ~changed(p, inverse);
    least = std::min(least, p);
  }
  return least;
}

}  // namespace cli
