// dapple rule: grow a cell program, from noise or a given state; say when it settles, how nice it is, what is stable.
// SPDX-License-Identifier: MIT
#include "rule.hpp"

#include <cinttypes>
#include <cstdio>
#include <fstream>
#include <iterator>

#include "commands.hpp"
#include "errors.hpp"
#include "rule_complete.hpp"
#include "rule_map.hpp"
#include "rule_output.hpp"
#include "rule_rle.hpp"
#include "rule_score.hpp"
#include "tile.hpp"

namespace cli {

namespace {

constexpr uint32_t kLimit = 1000;     // steps in which a program may settle
constexpr uint32_t kChoices = 200000;  // of a search for a stable state

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) fail("cannot read " + shown(path));
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  if (file.bad()) fail("cannot read " + shown(path));
  return text;
}

Torus read_start(const Options& options) {
  Pattern pattern;
  RleTrouble trouble;
  if (!read_rle(read_file(options.start), pattern, trouble))
    fail(shown(options.start) + ", line " + std::to_string(trouble.line) + ", column " + std::to_string(trouble.column) +
         ": " + trouble.reason);
  if (pattern.width > options.width || pattern.height > options.height)
    refuse("--size " + size_text(options.width, options.height) + " is too small: the pattern in " + shown(options.start) +
           " needs " + size_text(pattern.width, pattern.height));
  Torus torus(options.width, options.height);
  place(pattern, torus);
  return torus;
}

// The cells of a texture after `steps` steps.
Torus state_of(Subject& subject, const Options& options, uint32_t steps) {
  const uint32_t all = steps_of(subject.recipe);
  if (steps > all) change(subject.recipe, "steps=" + std::to_string(steps), "--steps");
  Tile tile(subject, domain_of(options), options.seed, options.bands);
  Progress progress;
  if (steps < all) tile.grow_steps(steps, progress);
  else tile.grow(options.budget, progress);
  Torus torus(options.width, options.height);
  std::vector<int16_t> row(options.width);
  for (uint16_t y = 0; y < options.height; ++y) {
    tile.texture().row(y, row.data());
    for (uint16_t x = 0; x < options.width; ++x) torus.set(x, y, row[x] > tile.texture().cell_level());
  }
  return torus;
}

Torus start_of(Subject subject, const Options& options) {
  return options.start.empty() ? state_of(subject, options, 0) : read_start(options);
}

std::string note_of(const Subject& subject, const std::string& from) {
  return from + ", dapple " + version_text() + ": " + line_of(subject.recipe);
}

std::string origin(const Options& options) {
  return options.start.empty() ? "Seed " + std::to_string(options.seed) : "From " + shown(options.start);
}

void grow_state(Subject subject, const Options& options) {
  const uint32_t steps = options.steps.value_or(steps_of(subject.recipe));
  std::optional<StateOutput> out;
  if (!options.hash) out.emplace(options, subject.name);
  Torus torus = options.start.empty() ? state_of(subject, options, steps) : read_start(options);
  if (!options.start.empty()) run(torus, program_of(subject.recipe), steps);
  if (out) return out->write(torus, subject.recipe, note_of(subject, origin(options)));
  std::printf("%016" PRIx64 "\n", field_hash_of(torus));
  finish_standard_output();
}

void grow_program(const Subject& subject, Options options) {
  if (options.map) {
    std::printf("%s\n", map_of(program_of(subject.recipe)).c_str());
    return finish_standard_output();
  }
  if (!options.start.empty() || options.text || wants_rle(options)) return grow_state(subject, options);
  if (!options.hash) {
    const Target target = target_of(options, subject.name);
    options.output = target.path;
    options.format = target.format;
  }
  options.subject = "cells rule=" + hexadecimal(program_of(subject.recipe));
  grow(options);
}

// The opening of a JSON answer.
void print_json_head(const Subject& subject, const Options& options) {
  const uint32_t program = program_of(subject.recipe);
  std::printf("{\"rule\": \"%s\", \"map\": \"%s\", \"width\": %u, \"height\": %u, \"seed\": %" PRIu32,
              hexadecimal(program).c_str(), map_of(program).c_str(), unsigned{options.width}, unsigned{options.height},
              options.seed);
}

void print_json_settled(const Settled& settled) {
  std::printf(", \"settles\": \"%s\"", name_of(settled.kind));
  if (settled.kind != Settled::no) std::printf(", \"step\": %" PRIu32 ", \"period\": %" PRIu32, settled.step, settled.period);
}

std::string sentence_of(const Settled& settled, uint32_t steps) {
  const std::string step = std::to_string(settled.step);
  if (settled.kind == Settled::strong) return "settles at step " + step + ": nothing changes any more (strong)";
  if (settled.kind == Settled::weak)
    return "settles at step " + step + ": it repeats every " + std::to_string(settled.period) + " steps (weak)";
  return "does not settle in " + std::to_string(steps) + " steps";
}

void settle(const Subject& subject, const Options& options) {
  const uint32_t steps = options.steps.value_or(kLimit);
  Torus torus = start_of(subject, options);
  const Settled settled = run(torus, program_of(subject.recipe), steps);
  if (options.json) {
    print_json_head(subject, options);
    print_json_settled(settled);
    std::printf(", \"steps\": %" PRIu32 "}\n", steps);
  } else {
    std::printf("%s\n", sentence_of(settled, steps).c_str());
  }
  finish_standard_output();
}

void score(const Subject& subject, const Options& options) {
  const uint32_t steps = options.steps.value_or(steps_of(subject.recipe)), program = program_of(subject.recipe);
  Torus torus = start_of(subject, options);
  const Settled settled = run(torus, program, steps);
  const Score s = score_of(torus, program, settled);
  const struct {
    const char* name;
    int32_t value;
  } figures[] = {{"score", s.total},   {"density", s.density}, {"entropy", s.entropy},  {"disorder", s.disorder},
                 {"correlation", s.correlation}, {"activity", s.activity}};
  if (options.json) {
    print_json_head(subject, options);
    for (const auto& figure : figures) std::printf(", \"%s\": %s", figure.name, decimal(figure.value).c_str());
    std::printf(", \"nice\": %s", s.nice ? "true" : "false");
    print_json_settled(settled);
    std::printf(", \"steps\": %" PRIu32 "}\n", steps);
  } else {
    for (const auto& figure : figures) std::printf("%-12s %6s\n", figure.name, decimal(figure.value).c_str());
    std::printf("%-12s %6s\n%s\n", "nice", s.nice ? "yes" : "no", sentence_of(settled, steps).c_str());
  }
  finish_standard_output();
}

std::string sentence_of(const Completed& done, const Options& options) {
  const std::string size = size_text(options.width, options.height);
  const std::string effort = " (" + std::to_string(done.effort.choices) + " choices, " +
                             std::to_string(done.effort.dead_ends) + " dead ends)";
  const bool tiled = done.tile_width != options.width || done.tile_height != options.height;
  if (done.answer == Answer::none) return "none: no state of " + size + " cells is stable" + effort;
  if (done.answer == Answer::unknown) return "unknown: no stable state of " + size + " cells was found" + effort;
  return "stable: a state of " + size + " cells" +
         (tiled ? ", a tile of " + size_text(done.tile_width, done.tile_height) + " repeated" : "") + effort;
}

void print_answer(const Completed& done, const Subject& subject, const Options& options) {
  if (!options.json) {
    std::printf("%s\n", sentence_of(done, options).c_str());
    return finish_standard_output();
  }
  print_json_head(subject, options);
  std::printf(", \"answer\": \"%s\", \"choices\": %" PRIu64 ", \"dead_ends\": %" PRIu64 ", \"restarts\": %" PRIu32,
              name_of(done.answer), done.effort.choices, done.effort.dead_ends, done.effort.restarts);
  if (done.answer == Answer::stable)
    std::printf(", \"tile_width\": %u, \"tile_height\": %u", unsigned{done.tile_width}, unsigned{done.tile_height});
  std::printf("}\n");
  finish_standard_output();
}

void complete(const Subject& subject, const Options& options) {
  const uint32_t program = program_of(subject.recipe);
  StateOutput out(options, subject.name + "-stable");
  const Completed done = find_stable(program, options.width, options.height, options.seed, options.tries.value_or(kChoices));
  if (done.state && !done.state->stable(program)) fail("the state that was found is not stable");
  if (!out.is_standard_output()) print_answer(done, subject, options);
  if (done.state) out.write(*done.state, subject.recipe, note_of(subject, "Stable, " + origin(options)));
  else if (out.is_standard_output()) print_answer(done, subject, options);
}

// An option, whether it was given, and where it may be.
struct Use {
  const char* name;
  bool given;
  unsigned verbs;
};

enum Verb : unsigned { v_grow = 1, v_settle = 2, v_score = 4, v_complete = 8, v_random = 16 };
constexpr const char* kVerbs[] = {"", "settle", "score", "complete", "random"};

Verb verb_of(const Options& options) {
  if (options.subject == "random" && options.verb.empty()) return v_random;
  for (unsigned i = 0; i < 4; ++i)
    if (options.subject != "random" && options.verb == kVerbs[i]) return static_cast<Verb>(1u << i);
  refuse("unexpected argument " + shown(options.verb) + "; after a program may come settle, score or complete");
}

void check_uses(const Options& o, Verb verb) {
  const Use uses[] = {
      {"-o", !o.output.empty(), v_grow | v_complete | v_random},
      {"--rle", o.rle, v_grow | v_complete},
      {"--text", o.text, v_grow | v_complete},
      {"--start", !o.start.empty(), v_grow | v_settle | v_score},
      {"--map", o.map, v_grow},
      {"--hash", o.hash, v_grow},
      {"--at", o.at.has_value(), v_grow},
      {"--repeat", o.repeat, v_grow | v_complete},
      {"--steps", o.steps.has_value(), v_grow | v_settle | v_score | v_random},
      {"--json", o.json, v_settle | v_score | v_complete | v_random},
      {"--style", o.style.has_value(), v_random},
      {"--count", o.count.has_value(), v_random},
  };
  for (const Use& use : uses) {
    if (!use.given || (use.verbs & verb) != 0) continue;
    std::string allowed;
    for (unsigned i = 0; i < 5; ++i)
      if ((use.verbs >> i & 1) != 0) allowed += (allowed.empty() ? "" : ", ") + std::string(i == 0 ? "growing" : kVerbs[i]);
    refuse(std::string(use.name) + " does not go with " + (verb == v_grow ? "growing" : o.verb + (verb == v_random ? "random" : "")) +
           "; it is for " + allowed);
  }
  if (o.at && !o.start.empty()) refuse("--at does not go with --start: a given state is on a torus");
}

// Sides that were not given are those of the verb.
void set_size(Options& options, Verb verb) {
  if (options.width == 0) options.width = options.height = verb == v_random ? 128 : verb == v_complete ? 64 : 256;
  if (verb != v_complete && (options.width < dapple::kSmallestSide || options.height < dapple::kSmallestSide))
    refuse("--size " + size_text(options.width, options.height) + ": sides below 8 are for complete");
}

}  // namespace

Subject rule_subject(const Options& options, uint32_t program) {
  Options cells = options;
  cells.subject = "cells rule=" + hexadecimal(program);
  Subject subject = subject_of(cells);
  subject.name = "rule-" + hexadecimal(program_of(subject.recipe));
  return subject;
}

void rule(const Options& given) {
  Options options = given;
  const Verb verb = verb_of(options);
  check_uses(options, verb);
  set_size(options, verb);
  if (verb == v_random) return random_rules(options);
  uint32_t program = 0;
  ProgramTrouble trouble{};
  if (!read_cell_program(options.subject, program, trouble))
    refuse("program " + shown(options.subject) + ", column " + std::to_string(trouble.column) + ": " + trouble.reason);
  const Subject subject = rule_subject(options, program);
  switch (verb) {
    case v_settle: return settle(subject, options);
    case v_score: return score(subject, options);
    case v_complete: return complete(subject, options);
    default: return grow_program(subject, options);
  }
}

std::string rule_help() {
  return "\nN is the program: decimal, 0x and hexadecimal digits, or Golly's MAP and six characters. Bit\n"
         "16 left + 8 right + 4 upper + 2 lower + self of it is the next state of a cell. key=value as for grow.\n\n"
         "  rule N              grows it from noise, or from a pattern (--start)\n"
         "  rule N settle       says when its states begin to repeat, within --steps (1000)\n"
         "  rule N score        how nice its picture is, in figures\n"
         "  rule N complete     looks for a stable state: answers stable, none (proved) or unknown\n"
         "  rule random         looks for nice programs, prints them and writes a sheet (rules.png)\n\n"
         "--size is 256 if not given, of complete 64, of random 128.\n";
}

}  // namespace cli
