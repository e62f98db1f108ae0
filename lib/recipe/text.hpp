// Recipe text: one line, a model and its numbers; constexpr, because presets are such lines.
//
//   recipe = model { key=value } { "then" ("carry" | "refine" | "freeze" | "reset") { key=value } }
//
// Keys: the model's numbers; steps, level, solver of the stage; levels, fine, solver=multigrid (a whole coarse-to-fine run);
// wavelength (cells, sets scale); cells=wide|compact (of all stages: four bytes a cell of a plane or two); aspect and
// spot_size of spots (dials.hpp); start=noise|seeds|point|line|segments|phases with pitch, aspect, jitter, radius, amplitude,
// length, lean, fan;
// sides=repeat|closed|fixed, of all, across and down, or left, right, top and bottom, and fixed=A,B; ramp, range=LOW,HIGH, light,
// gloss, grain, opacity=LOW,HIGH, roughness=LOW,HIGH. After `then` a stage begins as a copy of the one before. Numbers are decimal, six
// digits after the point.
// SPDX-License-Identifier: MIT
#pragma once
#include "dials.hpp"
#include "start_text.hpp"

namespace dapple::recipe {

// Slot of the family's number of that name, or -1.
constexpr int8_t slot_named(const Family& f, const char* name) {
  uint8_t slot = 0;
  for (uint8_t i = 0; i < f.number_count; ++i) {
    if (equal(word_of(name), f.numbers[i].name)) return static_cast<int8_t>(slot);
    slot = static_cast<uint8_t>(slot + slots_of(f.numbers[i].kind));
  }
  return -1;
}

constexpr const char* name_at(const Family& f, uint8_t wanted) {
  uint8_t slot = 0;
  for (uint8_t i = 0; i < f.number_count; ++i) {
    if (slot == wanted) return f.numbers[i].name;
    slot = static_cast<uint8_t>(slot + slots_of(f.numbers[i].kind));
  }
  return nullptr;
}

// Slot of the family's angles of pairs, or -1.
constexpr int8_t angles_of(const Family& f) {
  for (uint8_t i = 0; i < f.number_count; ++i)
    if (f.numbers[i].kind == Number::angles) return slot_named(f, f.numbers[i].name);
  return -1;
}

constexpr bool model_key(Reader& r, Word key, Word value, bool& found) {
  if (equal(key, "scale")) r.length = value;
  if (equal(key, "coverage")) r.coverage_given = true;
  uint8_t slot = 0;
  const Family& f = *r.family;
  for (uint8_t i = 0; i < f.number_count + map_numbers(f); ++i) {
    if (i == f.number_count) slot = along::map;
    const Number& n = i < f.number_count ? f.numbers[i] : along::numbers[i - f.number_count];
    const bool named = equal(key, n.name) || (n.kind == Number::angles && equal(key, "angles"));
    if (named) {
      found = true;
      for (uint8_t s = r.stage; s < r.recipe->stages; ++s)
        if (!number_in(r, value, n, r.recipe->stage[s].number + slot)) return false;
      return true;
    }
    slot = static_cast<uint8_t>(slot + slots_of(n.kind));
  }
  return true;
}

DAPPLE_APART constexpr int32_t times(int32_t value, int32_t now, int32_t was) {
  return static_cast<int32_t>(base::divide_round(static_cast<int64_t>(value) * now, was));
}

constexpr const char* kCells = "wide|compact";

constexpr bool stage_key(Reader& r, Word key, Word value, bool& found) {
  Stage& stage = r.recipe->stage[r.stage];
  uint32_t whole = 0;
  int32_t index = 0;
  found = true;
  if (equal(key, "steps")) {
    if (!integer_in(r, value, 0, kMostSteps, whole)) return false;
    const uint32_t later = total_steps(*r.recipe) - stage.steps;  // stages of an overridden recipe keep theirs
    if (r.stage + 1 < r.recipe->stages && whole < later) return fail(r, out_of_range, value, static_cast<int32_t>(later), 1000000, true);
    stage.steps = r.stage + 1 < r.recipe->stages ? whole - later : whole;
    r.steps_given = true;
    return true;
  }
  if (equal(key, "level")) {
    if (!integer_in(r, value, 0, stage.model->coarse ? kMaxCoarse : kMaxLevel, whole)) return false;
    stage.level = static_cast<uint8_t>(whole);
    return true;
  }
  if (equal(key, "solver")) {
    if (equal(value, "binary") && stage.model == &threshold_model) return fail(r, not_possible, value);  // the family bits
    if (!word_in(r, value, r.family->solver_names, index)) return false;
    r.solver_given = true;
    r.multigrid = equal(value, kMultigrid);
    if (r.multigrid) index = 0;
    for (uint8_t s = r.stage; s < r.recipe->stages; ++s) r.recipe->stage[s].solver = r.family->solvers[index];
    return true;
  }
  if (equal(key, "cells") && r.family->compact != r.family->model) {
    if (!word_in(r, value, kCells, index)) return false;
    for (uint8_t s = 0; s < r.recipe->stages; ++s) r.recipe->stage[s].model = index == 0 ? r.family->model : r.family->compact;
    return true;
  }
  if (equal(key, "levels")) return integer_in(r, value, 1, kMaxLevel + 1, r.levels);
  if (equal(key, "fine")) return integer_in(r, value, 1, kMostFine, r.fine);
  if (equal(key, "wavelength")) return decimal_in(r, value, base::kMicro, 500 * base::kMicro, r.wavelength);
  found = false;
  return true;
}

// "LOW,HIGH", both 0..1, in 1/255.
constexpr bool shares_in(Reader& r, Word text, uint8_t* shares) {
  int32_t low = 0, high = 0;
  Word rest = text;
  if (!decimal_in(r, take(rest, ','), 0, base::kMicro, low) || !decimal_in(r, rest, 0, base::kMicro, high)) return false;
  shares[0] = static_cast<uint8_t>(times(low, 255, base::kMicro));
  shares[1] = static_cast<uint8_t>(times(high, 255, base::kMicro));
  return true;
}

constexpr int32_t kLargestShown = 20 * base::kMicro;

constexpr bool paint_key(Reader& r, Word key, Word value, bool& found) {
  Paint& p = r.recipe->paint;
  found = true;
  if (equal(key, "ramp")) return read_ramp(value, p.ramp) || fail(r, unknown_word, value, 0, 0, false, "a ramp's name|stops like 000000,ff8000,ffffff or 0:000000,255:ffffff");
  if (equal(key, "range")) {
    Word rest = value;
    r.range_given = true;
    return decimal_in(r, take(rest, ','), -kLargestShown, kLargestShown, p.low) &&
           decimal_in(r, rest, p.low + 1, kLargestShown, p.high);
  }
  if (equal(key, "light")) return decimal_in(r, value, 0, 100 * base::kMicro, p.light);
  if (equal(key, "gloss")) return decimal_in(r, value, 0, base::kMicro, p.gloss);
  if (equal(key, "grain")) return decimal_in(r, value, 0, base::kMicro, p.grain);
  if (equal(key, "opacity")) return shares_in(r, value, p.opacity);
  if (equal(key, "roughness")) return shares_in(r, value, p.roughness);
  found = false;
  return true;
}

constexpr bool key_value(Reader& r, Word word) {
  const uint16_t at = find(word, '=');
  if (at == word.length) return fail(r, broken_text, word);
  const Word key = part(word, 0, at), value = part(word, static_cast<uint16_t>(at + 1), word.length);
  bool found = false;
  if (!model_key(r, key, value, found) || found) return found && r.trouble.status == ok;
  if (!stage_key(r, key, value, found) || found) return r.trouble.status == ok;
  if (!dial_key(r, key, value, found) || found) return r.trouble.status == ok;
  if (!start_key(r, key, value, found) || found) return r.trouble.status == ok;
  if (!side_key(r, key, value, found) || found) return r.trouble.status == ok;
  if (!paint_key(r, key, value, found) || found) return r.trouble.status == ok;
  return fail(r, unknown_word, key, 0, 0, false, r.family->name);
}

constexpr const char* kEntries = "carry|refine|freeze|reset";  // Entry, from carry on

constexpr bool then_stage(Reader& r, Word word) {
  int32_t entry = 0;
  if (!word_in(r, word, kEntries, entry)) return false;
  if (r.recipe->stages == kMaxStages) return fail(r, not_possible, word);
  const Stage& before = r.recipe->stage[r.recipe->stages - 1];
  r.stage = r.recipe->stages++;
  Stage& stage = r.recipe->stage[r.stage];
  stage = before;
  stage.entry = static_cast<Entry>(entry + static_cast<int32_t>(Entry::carry));
  stage.refine = stage.entry == Entry::refine ? evolve::refine_row : nullptr;
  if (stage.entry == Entry::freeze || stage.entry == Entry::reset) {
    stage.solver = r.family->solvers[r.family->freezing];
    return r.family->freezing > 0 || fail(r, not_possible, word);
  }
  if (stage.entry == Entry::carry) return true;
  if (before.level == 0) return fail(r, not_possible, word);
  --stage.level;
  return true;
}

constexpr int32_t times(int32_t value, int32_t now, int32_t was, const int32_t* range) {
  const int64_t product = base::divide_round(static_cast<int64_t>(value) * now, was);
  return static_cast<int32_t>(product < range[0] ? range[0] : product > range[1] ? range[1] : product);
}

// An angle turned by another, within a turn either way.
DAPPLE_APART constexpr int32_t turned(int32_t angle, int32_t by) {
  const int64_t turn = 360 * base::kMicro, sum = static_cast<int64_t>(angle) + by;
  return static_cast<int32_t>(sum > turn || sum < -turn ? sum % turn : sum);
}

// The scale that grows a wavelength: its share where the wavelength is proportional, the nearest of a hundred in range where
// it is not (masks: rounding makes it uneven).
constexpr bool tune(Reader& r, Word all, Stage& stage, uint8_t slot, const Number& range) {
  const int32_t wanted = r.wavelength >> (stage.model->coarse ? stage.level : 0);
  int32_t* number = stage.number;
  if (!stage.model->coarse) {
    number[slot] = base::kMicro;
    const int32_t one = stage.model->wavelength(number);
    number[slot] = times(r.wavelength, base::kMicro, one);
    return within(number[slot], range.low, range.high) ||
           fail(r, out_of_range, all, times(range.low, one, base::kMicro), times(range.high, one, base::kMicro));
  }
  int32_t best = 0, error = INT32_MAX, low = INT32_MAX, high = 0;
  for (int32_t i = 0; i <= 100; ++i) {
    number[slot] = range.low + (range.high - range.low) / 100 * i;
    if (!stage.model->in_range(number)) continue;
    const int32_t grown = r.family->grown(number);
    if (grown == 0) continue;
    const int32_t off = grown > wanted ? grown - wanted : wanted - grown;
    if (off < error) {
      error = off;
      best = number[slot];
    }
    low = grown < low ? grown : low;
    high = grown > high ? grown : high;
  }
  number[slot] = best;
  return wanted >= low && wanted <= high ? true : fail(r, out_of_range, all, low << stage.level, high << stage.level);
}

// Numbers whose bounds others set: a scale too long for its window, a threshold that extinguishes the pattern.
constexpr bool living(Reader& r, Word all, const int32_t* number) {
  const int8_t rho = slot_named(*r.family, "rho"), scale = slot_named(*r.family, "scale");
  if (scale >= 0) {
    const bits::Living lengths = r.family->lengths(number);
    if (!within(number[scale], lengths.low, lengths.high)) return fail(r, out_of_range, r.length.length > 0 ? r.length : all, lengths.low, lengths.high);
  }
  if (rho < 0) return true;
  const bits::Living range = r.family->living(number);
  return schedule_within(number + rho, range.low, range.high) ||
         fail(r, out_of_range, r.schedule.length > 0 ? r.schedule : all, range.low, range.high);
}

// What a model cannot stand: steps that diverge, a grid too coarse. The number it is about is named.
constexpr bool bounded(Reader& r, Word all, const Stage& stage) {
  const Bound bound = stage.model->bound(stage.number, stage.level);
  if (within(stage.number[bound.slot], bound.low, bound.high)) return true;
  fail(r, unstable, all, bound.low, bound.high, false, name_at(*r.family, bound.slot));
  r.trouble.value = stage.number[bound.slot];
  return false;
}

// Stages that differ from place to place have a solver of their own, and segments before the first of them, along a map,
// a start. The shortest waves are to have cells enough, too, on the grid that is painted.
constexpr bool take_places(Reader& r, Word all, Stage& stage) {
  Start& start = r.recipe->start;
  const bool map = evolve::has_map(stage.number), grade = evolve::has_grade(stage.number);
  stage.solver = evolve::with_places(stage.solver, map || grade, r.family->solvers + kPictured);
  if (stage.entry == Entry::start && start.kind == Start::segments)
    start.row = map ? evolve::segments_along_row : start::segments_row;
  if (!grade || stage.level > 0) return true;
  int32_t& scale = stage.number[kinetics::scale];
  const int32_t longest = scale, share = stage.number[along::finest];
  scale = times(longest, share, base::kMicro);
  const Bound bound = stage.model->bound(stage.number, 0);
  const bool coarse = bound.slot == kinetics::scale && scale < bound.low;
  scale = longest;
  if (!coarse) return true;
  fail(r, unstable, all, times(bound.low, base::kMicro, share), INT32_MAX, false, name_at(*r.family, kinetics::scale));
  r.trouble.value = longest;
  return false;
}

// Numbers that follow from others: the scale from a wavelength, seeds from the scale, the angles of the pairs.
constexpr bool settle(Reader& r, Word all) {
  const int8_t scale = slot_named(*r.family, "scale"), angle = angles_of(*r.family);
  const int32_t scale_before = scale >= 0 ? r.recipe->stage[0].number[scale] : 0;
  if (!length_of_spots(r, all)) return false;
  for (uint8_t i = 0; i < r.recipe->stages; ++i) {
    int32_t* number = r.recipe->stage[i].number;
    for (uint8_t k = 0; k < r.family->number_count && r.wavelength != 0 && scale >= 0; ++k) {
      const Number& range = r.family->numbers[k];
      if (!equal(word_of(range.name), "scale")) continue;
      if (i > 0 && r.family->freezing > 0) number[scale] = times(number[scale], r.recipe->stage[0].number[scale], scale_before);
      else if (!tune(r, all, r.recipe->stage[i], static_cast<uint8_t>(scale), range)) return false;
    }
    if (!cover_spots(r, r.recipe->stage[i])) return false;
    if (map_numbers(*r.family) > 0 && !take_places(r, all, r.recipe->stage[i])) return false;
    if (!living(r, all, number) || !bounded(r, all, r.recipe->stage[i])) return false;
    if (angle < 0) continue;
    const int32_t pairs = number[0];
    const int32_t first = number[angle];
    for (uint8_t j = 1; j < 5 && !r.angles_given; ++j) {
      if (r.pairs_given)
        number[angle + j] = j < pairs ? turned(first, j * (180 * base::kMicro / pairs)) : 0;
      else if (r.angle_given)
        number[angle + j] = j < pairs ? turned(number[angle + j], first - r.first_angle) : 0;
    }
  }
  if (scale >= 0) {
    const int32_t now = r.recipe->stage[0].number[scale];
    Start& s = r.recipe->start;
    if (!r.pitch_given) s.pitch = times(s.pitch, now, r.scale, kPitch);
    if (!r.radius_given) s.radius = times(s.radius, now, r.scale, kRadius);
  }
  settle_spots(r);
  return spread_levels(r, all);
}

constexpr void defaults(Recipe& recipe, const Family& f) {
  recipe = Recipe{};
  recipe.start = f.start;
  read_stops(word_of(ramps[0].stops), recipe.paint.ramp);
  recipe.paint.low = f.low;
  recipe.paint.high = f.high;
  recipe.stages = 1;
  recipe.blocks = f.blocks;
  Stage& stage = recipe.stage[0];
  stage.model = f.model;
  stage.solver = f.solvers[0];
  stage.steps = f.steps;
  stage.level = f.level;
  uint8_t slot = 0;
  for (uint8_t i = 0; i < map_numbers(f); ++i) stage.number[along::map + i] = along::numbers[i].standard;
  for (uint8_t i = 0; i < f.number_count; ++i) {
    const Number& n = f.numbers[i];
    stage.number[slot] = n.standard;
    if (n.kind == Number::schedule) stage.number[slot + 1] = n.standard;
    slot = static_cast<uint8_t>(slot + slots_of(n.kind));
  }
}

// Index among the families, or -1.
constexpr int8_t family_named(Word name, const Families& known = kFamilies) {
  for (uint8_t i = 0; i < known.count; ++i)
    if (equal(name, known.first[i].name)) return static_cast<int8_t>(i);
  return -1;
}
constexpr const Family* family_of(const Recipe& recipe, const Families& known = kFamilies) {
  for (const Family* f = known.first; f < known.first + known.count; ++f)
    if (f->model == recipe.stage[0].model || f->compact == recipe.stage[0].model) return f;
  return nullptr;
}

constexpr Word next_word(Word& rest) {
  while (rest.length > 0 && rest.text[0] == ' ') rest = part(rest, 1, rest.length);
  return take(rest, ' ');
}

// Reads text into `recipe`: a whole recipe where it begins with a model's name, changes to it otherwise. The recipe is
// undefined after a failure.
constexpr Status read(const char* text, Recipe& recipe, Trouble& trouble, const Families& known = kFamilies) {
  Word rest = word_of(text);
  const Word all = rest;
  Reader r{};
  r.recipe = &recipe;
  r.origin = text;
  if (rest.length == kMaxText) {
    fail(r, broken_text, part(rest, kMaxText - 1, kMaxText));
    trouble = r.trouble;
    return broken_text;
  }
  Word word = next_word(rest);
  const int8_t named = family_named(word, known);
  const bool fresh = named >= 0;
  if (fresh) {
    r.family = known.first + named;
    defaults(recipe, *r.family);
  }
  if (!fresh && (recipe.stages == 0 || (find(word, '=') == word.length && word.length > 0))) {
    fail(r, unknown_word, word);
    trouble = r.trouble;
    return unknown_word;
  }
  if (fresh) {
    word = next_word(rest);
    r.pairs_given = true;
  } else {
    r.family = family_of(recipe, known);
    r.was_multigrid = is_multigrid(recipe, *r.family);
  }
  const int8_t angle = angles_of(*r.family), scale = slot_named(*r.family, "scale");
  r.first_angle = angle < 0 ? 0 : recipe.stage[0].number[angle];
  r.scale = scale < 0 ? base::kMicro : recipe.stage[0].number[scale];
  bool good = true;
  for (; good && word.length > 0; word = next_word(rest)) good = equal(word, "then") ? then_stage(r, next_word(rest)) : key_value(r, word);
  if (good) good = settle(r, all);
  trouble = r.trouble;
  return good ? ok : r.trouble.status;
}

// A preset's recipe, at compile time. Refused text does not compile: see presets.hpp.
constexpr Preset preset(const char* text) {
  Preset p{};
  Trouble trouble{};
  if (read(text, p.recipe, trouble) != ok) p.recipe.stages = 0;
  return p;
}

}  // namespace dapple::recipe
