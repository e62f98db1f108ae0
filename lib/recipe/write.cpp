// Recipes as text: the line that parses to the same recipe, every number spelt out.
// SPDX-License-Identifier: MIT
#include "list.hpp"

namespace dapple {

using recipe::Family;
using recipe::Word;

namespace recipe {

// Text being written; counts past the end of the buffer without writing there.
struct Writer {
  char* text;
  size_t size, length;
};

static void put(Writer& w, char c) {
  if (w.length + 1 < w.size) w.text[w.length] = c;
  ++w.length;
}
static void put(Writer& w, const char* text) {
  while (*text != 0) put(w, *text++);
}
static void put(Writer& w, Word word) {
  for (uint16_t i = 0; i < word.length; ++i) put(w, word.text[i]);
}

static void put_integer(Writer& w, uint32_t value) {
  char digits[10];
  uint8_t n = 0;
  do {
    digits[n++] = static_cast<char>('0' + value % 10);
    value /= 10;
  } while (value != 0);
  while (n > 0) put(w, digits[--n]);
}

static void put_hex(Writer& w, uint32_t value) {
  put(w, "0x");
  for (int8_t shift = 28; shift >= 0; shift = static_cast<int8_t>(shift - 4)) put(w, "0123456789abcdef"[(value >> shift) & 15]);
}

static void put_decimal(Writer& w, int32_t micro) {
  if (micro < 0) put(w, '-');
  uint32_t value = micro < 0 ? 0u - static_cast<uint32_t>(micro) : static_cast<uint32_t>(micro);
  put_integer(w, value / static_cast<uint32_t>(base::kMicro));
  uint32_t rest = value % static_cast<uint32_t>(base::kMicro);
  if (rest != 0) put(w, '.');
  for (uint32_t place = 100000; rest != 0; place /= 10) {
    put(w, static_cast<char>('0' + rest / place));
    rest %= place;
  }
}

static void put_key(Writer& w, const char* key) {
  put(w, ' ');
  put(w, key);
  put(w, '=');
}

static void put_pair(Writer& w, const char* key, int32_t value) {
  put_key(w, key);
  put_decimal(w, value);
}

static void put_word(Writer& w, const char* words, int32_t index) {
  Word rest = word_of(words), word{};
  for (int32_t i = 0; i <= index; ++i) word = take(rest, '|');
  put(w, word);
}

static void put_schedule(Writer& w, const int32_t* slot) {
  put_decimal(w, slot[0]);
  if (slot[1] == slot[0]) return;
  put(w, ':');
  put_decimal(w, slot[1]);
  put(w, '@');
  put_decimal(w, slot[2]);
  if (slot[3] == slot[2]) return;
  put(w, "..");
  put_decimal(w, slot[3]);
}

static void put_number(Writer& w, const Number& n, const int32_t* slot, int32_t pairs) {
  put_key(w, n.name);
  switch (n.kind) {
    case Number::decimal: put_decimal(w, *slot); break;
    case Number::integer: put_integer(w, static_cast<uint32_t>(*slot)); break;
    case Number::program: put_hex(w, static_cast<uint32_t>(*slot)); break;
    case Number::word: put_word(w, n.words, *slot); break;
    case Number::schedule: put_schedule(w, slot); break;
    case Number::angles:
      for (int32_t j = 0; j < pairs; ++j) {
        if (j > 0) put(w, ',');
        put_decimal(w, slot[j]);
      }
      break;
  }
}

static void put_numbers(Writer& w, const Family& f, const int32_t* number) {
  uint8_t slot = 0;
  for (uint8_t i = 0; i < f.number_count; ++i) {
    put_number(w, f.numbers[i], number + slot, number[0]);
    slot = static_cast<uint8_t>(slot + slots_of(f.numbers[i].kind));
  }
  for (uint8_t i = 0; i < map_numbers(f); ++i) put_number(w, along::numbers[i], number + along::map + i, 0);
}

static void put_solver(Writer& w, const Family& f, const evolve::Solver* solver) {
  put_key(w, "solver");
  int32_t index = 0;
  solver = evolve::with_places(solver, false, f.solvers + kPictured);
  while (solver != f.solvers[index] && index < 3) ++index;
  put_word(w, f.solver_names, index);
}

// The stages of a coarse-to-fine run, as the words that lay them.
static void put_multigrid(Writer& w, const Family& f, const Recipe& recipe) {
  put_numbers(w, f, recipe.stage[0].number);
  put_key(w, "solver");
  put(w, kMultigrid);
  put_key(w, "levels");
  put_integer(w, recipe.stages);
  put_key(w, "fine");
  put_integer(w, recipe.stage[1].steps);
  put_key(w, "steps");
  put_integer(w, total_steps(recipe));
}

static void put_stage(Writer& w, const Family& f, const Stage& stage) {
  put_numbers(w, f, stage.number);
  put_solver(w, f, stage.solver);
  put_key(w, "level");
  put_integer(w, stage.level);
  put_key(w, "steps");
  put_integer(w, stage.steps);
}

static void put_start(Writer& w, const Start& s) {
  put_key(w, "start");
  put_word(w, kStarts, s.kind);
  if (s.kind == Start::noise) return;
  put_pair(w, "pitch", s.pitch);
  put_pair(w, "aspect", s.aspect);
  put_pair(w, "jitter", s.jitter);
  put_pair(w, "radius", s.radius);
  put_pair(w, "amplitude", s.amplitude);
  if (s.kind == Start::seeds) return;
  put_pair(w, "length", s.length);
  put_pair(w, "lean", s.lean);
  put_pair(w, "fan", s.fan);
}

static void put_sides(Writer& w, const Sides& s) {
  put_key(w, "sides");
  bool held = false;
  for (uint8_t i = 0; i < kSides; ++i) {
    if (i > 0) put(w, ',');
    put_word(w, "repeat|closed|fixed", s.kind[i]);
    held = held || s.kind[i] == Sides::fixed;
  }
  if (!held) return;
  put_key(w, "fixed");
  put_decimal(w, s.held[0]);
  put(w, ',');
  put_decimal(w, s.held[1]);
}

static void put_ramp(Writer& w, const Ramp& ramp) {
  put_key(w, "ramp");
  for (const NamedRamp& named : ramps) {
    Ramp candidate{};
    read_stops(word_of(named.stops), candidate);
    if (equal(candidate, ramp)) return put(w, named.name);
  }
  const char* hex = "0123456789abcdef";
  for (uint8_t i = 0; i < ramp.count; ++i) {
    if (i > 0) put(w, ',');
    put_integer(w, ramp.stop[i].at);
    put(w, ':');
    const uint8_t rgb[3] = {ramp.stop[i].red, ramp.stop[i].green, ramp.stop[i].blue};
    for (const uint8_t c : rgb) {
      put(w, hex[c >> 4]);
      put(w, hex[c & 15]);
    }
  }
}

static void put_shares(Writer& w, const char* key, const uint8_t* shares) {
  put_key(w, key);
  put_decimal(w, times(shares[0], base::kMicro, 255));
  put(w, ',');
  put_decimal(w, times(shares[1], base::kMicro, 255));
}

static void put_paint(Writer& w, const Paint& p) {
  put_ramp(w, p.ramp);
  put_key(w, "range");
  put_decimal(w, p.low);
  put(w, ',');
  put_decimal(w, p.high);
  put_pair(w, "light", p.light);
  put_pair(w, "gloss", p.gloss);
  put_pair(w, "grain", p.grain);
  put_shares(w, "opacity", p.opacity);
  put_shares(w, "roughness", p.roughness);
}

}  // namespace recipe

size_t write(const Recipe& recipe, char* text, size_t size) {
  recipe::Writer w = {text, size, 0};
  const Family* family = recipe::family_of(recipe);
  recipe::put(w, family->name);
  if (recipe.stage[0].model != family->model) recipe::put(w, " cells=compact");
  const bool multigrid = recipe::is_multigrid(recipe, *family);
  if (multigrid) recipe::put_multigrid(w, *family, recipe);
  else recipe::put_stage(w, *family, recipe.stage[0]);
  recipe::put_start(w, recipe.start);
  if (has_sides(recipe)) recipe::put_sides(w, recipe.sides);
  recipe::put_paint(w, recipe.paint);
  for (uint8_t i = 1; i < recipe.stages && !multigrid; ++i) {
    recipe::put(w, " then ");
    recipe::put_word(w, recipe::kEntries, static_cast<int32_t>(recipe.stage[i].entry) - static_cast<int32_t>(Entry::carry));
    recipe::put_stage(w, *family, recipe.stage[i]);
  }
  if (size > 0) text[w.length < size ? w.length : size - 1] = 0;
  return w.length;
}

}  // namespace dapple
