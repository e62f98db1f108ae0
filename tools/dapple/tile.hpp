// Textures with their memory, and the progress of growing them.
// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <memory>
#include <optional>

#include "recipes.hpp"

namespace cli {

// A line on a terminal's standard error while work takes longer than two seconds.
class Progress {
 public:
  Progress();
  ~Progress();  // clears the line
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(const std::string& name, uint64_t done, uint64_t all);

 private:
  bool terminal_;
  std::chrono::steady_clock::time_point next_;
  size_t length_ = 0;
};

class Tile {
 public:
  Tile(const Subject& subject, dapple::Domain domain, uint32_t seed, uint8_t bands = 1,
       Kernels kernels = best_kernels());
  Tile(const Tile&) = delete;
  Tile& operator=(const Tile&) = delete;

  // To the end, `budget` rows at a time; 0: a step or so at a time.
  void grow(uint32_t budget, Progress& progress);
  // Until exactly `steps` steps are done in all, from where it is.
  void grow_steps(uint32_t steps, uint32_t budget, Progress& progress);

  dapple::Texture& texture() { return texture_; }

 private:
  void tell_held(const dapple::Stage& freeze);

  std::string name_;
  dapple::Recipe recipe_;
  dapple::Patch patch_;  // of a recipe with sides
  dapple::Patches patches_;
  std::shared_ptr<dapple::evolve::Driver> driver_;
  uint16_t rows_;  // that are grown: the tile's, or the window's with its halo
  std::unique_ptr<uint8_t[]> memory_;
  dapple::Texture texture_;
};

}  // namespace cli
