// Random cell programs, and when two of them are one.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

namespace cli {

// How the 32 bits of a program are thrown.
enum class Style : uint8_t {
  uniform,           // each on its own
  inertia,           // each is, with even odds, the cell's own state, or thrown
  mirror,            // the same for a neighbourhood and its mirror images, left with right and upper with lower
  outer_totalistic,  // by the cell's own state and the number of its neighbours that are on: 1024 programs in all
};
constexpr const char* kStyles = "uniform|inertia|mirror|outer-totalistic";

// Program `index` of the style: a function of its arguments alone.
uint32_t random_program(Style style, uint32_t seed, uint32_t index);

// Turns and mirror images of the plane, and on for off, lead from a program to those whose pictures are the same but
// for that. The least of these up to sixteen programs.
uint32_t representative(uint32_t program);

}  // namespace cli
