// Recipe text of the start and of the sides. See text.hpp.
// SPDX-License-Identifier: MIT
#pragma once
#include "reader.hpp"

namespace dapple::recipe {

constexpr bool start_key(Reader& r, Word key, Word value, bool& found) {
  Start& s = r.recipe->start;
  int32_t index = 0;
  found = true;
  if (equal(key, "start")) {
    if (!word_in(r, value, kStarts, index)) return false;
    s.kind = static_cast<Start::Kind>(index);
    s.row = row_start(s.kind);
    return true;
  }
  if (equal(key, "pitch")) return (r.pitch_given = true) && decimal_in(r, value, kPitch[0], kPitch[1], s.pitch);
  if (equal(key, "radius")) return (r.radius_given = true) && decimal_in(r, value, kRadius[0], kRadius[1], s.radius);
  if (equal(key, "aspect")) return decimal_in(r, value, kAspect[0], kAspect[1], s.aspect);
  if (equal(key, "jitter")) return decimal_in(r, value, 0, base::kMicro, s.jitter);
  if (equal(key, "length")) return decimal_in(r, value, kLength[0], kLength[1], s.length);
  if (equal(key, "lean")) return decimal_in(r, value, kLean[0], kLean[1], s.lean);
  if (equal(key, "fan")) return decimal_in(r, value, kFan[0], kFan[1], s.fan);
  if (equal(key, "amplitude")) return decimal_in(r, value, 10000, base::kMicro, s.amplitude);
  found = false;
  return true;
}

// One word for all sides, two across and down, four one by one. Sides repeat in pairs.
constexpr bool sides_in(Reader& r, Word text) {
  Sides& sides = r.recipe->sides;
  int32_t index = 0;
  uint8_t count = 0;
  for (Word rest = text; rest.length > 0 || count == 0; ++count) {
    if (count == kSides) return fail(r, broken_text, text);
    if (!word_in(r, take(rest, ','), "repeat|closed|fixed", index)) return false;
    sides.kind[count] = static_cast<Sides::Kind>(index);
  }
  if (count == 3) return fail(r, broken_text, text);
  if (count == 1) sides.kind[1] = sides.kind[0];
  if (count < kSides) {
    sides.kind[2] = sides.kind[3] = sides.kind[1];
    sides.kind[1] = sides.kind[0];
  }
  for (uint8_t i = 0; i < kSides; ++i)
    if ((sides.kind[i] == Sides::repeat) != (sides.kind[i ^ 1] == Sides::repeat)) return fail(r, not_possible, text);
  return true;
}

constexpr bool side_key(Reader& r, Word key, Word value, bool& found) {
  found = true;
  if (equal(key, "sides")) return sides_in(r, value);
  if (equal(key, "fixed")) {
    Word rest = value;
    int32_t* const held = r.recipe->sides.held;
    return decimal_in(r, take(rest, ','), 0, base::kMicro, held[0]) && decimal_in(r, rest, 0, base::kMicro, held[1]);
  }
  found = false;
  return true;
}

}  // namespace dapple::recipe
