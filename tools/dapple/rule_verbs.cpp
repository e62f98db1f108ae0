// dapple rule N: grow the program from noise or a given state; say when it settles, how nice it is, what is stable.
// SPDX-License-Identifier: MIT
#include "rule.hpp"

#include <cinttypes>
#include <cstdio>

#include "commands.hpp"
#include "errors.hpp"
#include "input.hpp"
#include "maps.hpp"
#include "rule_complete.hpp"
#include "rule_map.hpp"
#include "rule_output.hpp"
#include "rule_rle.hpp"
#include "rule_score.hpp"
#include "tile.hpp"

namespace cli {

namespace {

constexpr uint32_t kLimit = 1000;      // steps in which a program may settle
constexpr uint32_t kChoices = 200000;  // of a search for a stable state

Torus read_start(const Options& options) {
  Pattern pattern;
  RleTrouble trouble;
  if (!read_rle(read_file(options.start), pattern, trouble))
    fail(shown(options.start) + ", line " + std::to_string(trouble.line) + ", column " +
         std::to_string(trouble.column) + ": " + trouble.reason);
  if (pattern.width > options.width || pattern.height > options.height)
    refuse("--size " + size_text(options.width, options.height) + " is too small: the pattern in " +
           shown(options.start) + " needs " + size_text(pattern.width, pattern.height));
  Torus torus(options.width, options.height);
  place(pattern, torus);
  return torus;
}

// The cells of a texture after `steps` steps.
Torus state_of(Subject& subject, const Options& options, uint32_t steps) {
  const uint32_t all = steps_of(subject.recipe);
  if (steps > all) change(subject.recipe, "steps=" + std::to_string(steps), "--steps");
  Tile tile(subject, domain_of(options), options.seed, options.bands, options.kernels);
  Progress progress;
  if (steps < all) tile.grow_steps(steps, options.budget, progress);
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

Settled run_shown(Torus& torus, const Subject& subject, uint32_t steps) {
  Progress progress;
  return run(torus, program_of(subject.recipe), steps,
             [&](uint64_t done, uint64_t all) { progress.show(subject.name, done, all); });
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
  if (!options.start.empty()) run_shown(torus, subject, steps);
  if (out) return out->write(torus, subject.recipe, note_of(subject, origin(options)));
  std::printf("%016" PRIx64 "\n", field_hash_of(torus));
  finish_standard_output();
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
  if (settled.kind != Settled::no)
    std::printf(", \"step\": %" PRIu32 ", \"period\": %" PRIu32, settled.step, settled.period);
}

std::string sentence_of(const Settled& settled, uint32_t steps) {
  const std::string step = std::to_string(settled.step);
  if (settled.kind == Settled::strong) return "settles at step " + step + ": nothing changes any more (strong)";
  if (settled.kind == Settled::weak)
    return "settles at step " + step + ": it repeats every " + std::to_string(settled.period) + " steps (weak)";
  return "does not settle in " + std::to_string(steps) + " steps";
}

std::string sentence_of(const Completed& done, const Options& options) {
  const std::string size = size_text(options.width, options.height);
  const std::string effort =
      " (" + std::to_string(done.effort.choices) + " choices, " + std::to_string(done.effort.dead_ends) + " dead ends)";
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
  std::printf(", \"answer\": \"%s\", \"choices\": %" PRIu64 ", \"dead_ends\": %" PRIu64 ", \"searches\": %" PRIu32,
              name_of(done.answer), done.effort.choices, done.effort.dead_ends, done.effort.searches);
  if (done.answer == Answer::stable)
    std::printf(", \"tile_width\": %u, \"tile_height\": %u", unsigned{done.tile_width}, unsigned{done.tile_height});
  std::printf("}\n");
  finish_standard_output();
}

Completed search_shown(uint32_t program, const Subject& subject, const Options& options) {
  Progress progress;
  return find_stable(program, options.width, options.height, options.seed, options.tries.value_or(kChoices),
                     [&](uint64_t done, uint64_t all) { progress.show(subject.name, done, all); });
}

}  // namespace

void rule_grow(const Subject& subject, Options options) {
  if (options.map) {
    std::printf("%s\n", map_of(program_of(subject.recipe)).c_str());
    return finish_standard_output();
  }
  if (!options.maps.empty() && (!options.start.empty() || options.text || options.rle))
    refuse("--maps does not go with --start, --text and --rle");
  if (!options.maps.empty()) return grow_maps(subject, options);
  if (!options.start.empty() || options.text || wants_rle(options)) return grow_state(subject, options);
  if (!options.hash) {
    const Target target = target_of(options, subject.name);
    options.output = target.path;
    options.format = target.format;
  }
  options.subject = "cells rule=" + hexadecimal(program_of(subject.recipe));
  grow(options);
}

void rule_settle(const Subject& subject, const Options& options) {
  const uint32_t steps = options.steps.value_or(kLimit);
  Torus torus = start_of(subject, options);
  const Settled settled = run_shown(torus, subject, steps);
  if (options.json) {
    print_json_head(subject, options);
    print_json_settled(settled);
    std::printf(", \"steps\": %" PRIu32 "}\n", steps);
  } else {
    std::printf("%s\n", sentence_of(settled, steps).c_str());
  }
  finish_standard_output();
}

void rule_score(const Subject& subject, const Options& options) {
  const uint32_t steps = options.steps.value_or(steps_of(subject.recipe)), program = program_of(subject.recipe);
  Torus torus = start_of(subject, options);
  const Settled settled = run_shown(torus, subject, steps);
  const Score s = score_of(torus, program, settled);
  const struct {
    const char* name;
    int32_t value;
  } figures[] = {{"score", s.total},       {"density", s.density},         {"entropy", s.entropy},
                 {"disorder", s.disorder}, {"correlation", s.correlation}, {"activity", s.activity}};
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

void rule_complete(const Subject& subject, const Options& options) {
  const uint32_t program = program_of(subject.recipe);
  StateOutput out(options, subject.name + "-stable");
  const Completed done = search_shown(program, subject, options);
  if (done.state && !done.state->stable(program)) fail("the state that was found is not stable");
  if (!out.is_standard_output()) print_answer(done, subject, options);
  if (done.state) out.write(*done.state, subject.recipe, note_of(subject, "Stable, " + origin(options)));
  else if (out.is_standard_output()) print_answer(done, subject, options);
}

}  // namespace cli
