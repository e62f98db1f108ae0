// Where a state of a cell program goes: a picture, run-length text, or plain text.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "recipes.hpp"
#include "rule_torus.hpp"

namespace cli {

// The file asked for is run-length text, by --rle or by its suffix.
bool wants_rle(const Options& options);

class StateOutput {
 public:
  // Refuses, and opens the file, before any work.
  StateOutput(const Options& options, const std::string& name);
  StateOutput(const StateOutput&) = delete;
  StateOutput& operator=(const StateOutput&) = delete;

  // The state of the recipe's program; the note says where it comes from.
  void write(const Torus& state, const dapple::Recipe& recipe, const std::string& note);

  // Only after StateOutput: what else is said would be between the bytes of the file.
  bool is_standard_output() const { return path_ == "-"; }

 private:
  void write_picture_of(const Torus& state, const dapple::Recipe& recipe, const std::string& note);

  const Options& options_;
  std::string name_, path_;
  std::optional<Target> target_;  // of a picture
  std::optional<Output> out_;
};

// FNV-1a, 64 bit, over the field a library texture of this state has: what 'grow --hash' prints.
uint64_t field_hash_of(const Torus& state);

uint32_t program_of(const dapple::Recipe& recipe);

}  // namespace cli
