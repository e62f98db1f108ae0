// dapple rule: what it is asked for, and whether its options go with that.
// SPDX-License-Identifier: MIT
#include "rule.hpp"

#include "commands.hpp"
#include "errors.hpp"
#include "rule_map.hpp"
#include "rule_output.hpp"

namespace cli {

namespace {

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
      {"--maps", !o.maps.empty(), v_grow},
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
      if ((use.verbs >> i & 1) != 0)
        allowed += (allowed.empty() ? "" : ", ") + std::string(i == 0 ? "growing" : kVerbs[i]);
    refuse(std::string(use.name) + " does not go with " +
           (verb == v_grow ? "growing" : o.verb + (verb == v_random ? "random" : "")) + "; it is for " + allowed);
  }
  if (o.at && !o.start.empty()) refuse("--at does not go with --start: a given state is on a torus");
}

constexpr uint64_t kMostCells = UINT64_C(1) << 24;  // of complete, which keeps up to eighty bytes for each

// Sides that were not given are those of the verb.
void set_size(Options& options, Verb verb) {
  if (options.width == 0) options.width = options.height = verb == v_random ? 128 : verb == v_complete ? 64 : 256;
  if (verb != v_complete && (options.width < dapple::kSmallestSide || options.height < dapple::kSmallestSide))
    refuse("--size " + size_text(options.width, options.height) + ": sides below 8 are for complete");
  if (verb == v_complete && uint64_t{options.width} * options.height > kMostCells)
    refuse("--size " + size_text(options.width, options.height) + ": complete takes at most " +
           std::to_string(kMostCells) + " cells, 4096x4096");
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
  if (verb == v_random) return rule_random(options);
  uint32_t program = 0;
  ProgramTrouble trouble{};
  if (!read_cell_program(options.subject, program, trouble))
    refuse("program " + shown(options.subject) + ", column " + std::to_string(trouble.column) + ": " + trouble.reason);
  const Subject subject = rule_subject(options, program);
  switch (verb) {
    case v_settle:
      return rule_settle(subject, options);
    case v_score:
      return rule_score(subject, options);
    case v_complete:
      return rule_complete(subject, options);
    default:
      return rule_grow(subject, options);
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
