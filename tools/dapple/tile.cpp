// Textures with their memory, and the progress of growing them.
// SPDX-License-Identifier: MIT
#include "tile.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <new>

#include "errors.hpp"

namespace cli {

using std::chrono::steady_clock;

Progress::Progress() : terminal_(isatty(STDERR_FILENO) != 0), next_(steady_clock::now() + std::chrono::seconds(2)) {}

Progress::~Progress() {
  if (length_ > 0) std::fprintf(stderr, "\r%*s\r", static_cast<int>(length_), "");
}

void Progress::show(const std::string& name, uint64_t done, uint64_t all) {
  if (!terminal_ || steady_clock::now() < next_) return;
  next_ = steady_clock::now() + std::chrono::milliseconds(200);
  std::string line = "growing " + name + ": " + std::to_string(all == 0 ? 100 : done * 100 / all) + " %";
  line.resize(std::max(line.size(), length_), ' ');
  length_ = line.size();
  std::fprintf(stderr, "\r%s", line.c_str());
  std::fflush(stderr);
}

Tile::Tile(const Subject& subject, dapple::Domain domain, uint32_t seed, uint8_t bands, Kernels kernels)
    : name_(subject.name), recipe_(subject.recipe), driver_(driver_of(bands)) {
  const dapple::Need need = need_of(subject, domain, bands);
  if (has_sides(recipe_)) {
    patch_ = patch_of(recipe_);
    patches_ = {&patch_, 1, domain.width, domain.height};
    domain = on_patch(patches_, 0);
  }
  rows_ = dapple::api::ground_of(domain, need).height;
  memory_.reset(new (std::nothrow) uint8_t[need.bytes]);
  if (memory_ == nullptr) fail("not enough memory: " + name_ + " needs " + std::to_string(need.bytes) + " bytes");
  dapple::Options options;
  options.bands = bands;
  options.kernels = kernels;
  options.driver = driver_.get();
  texture_.begin(recipe_, domain, seed, memory_.get(), need.bytes, options);  // need_of has checked everything
}

// The most rows of work of one step.
static uint32_t step_rows(const dapple::Recipe& recipe, uint16_t height) {
  uint32_t most = 1024;
  for (uint8_t i = 0; i < recipe.stages; ++i) {
    const dapple::Stage& stage = recipe.stage[i];
    const dapple::evolve::Reach reach = stage.solver->reach(*stage.model, stage.number, stage.level, stage.stored);
    most = std::max(most, (uint32_t{reach.sweeps} + reach.once) * (height >> stage.level));
  }
  return most;
}

// A freeze that holds no cell or all of them is hardly meant; the texture is grown all the same.
void Tile::tell_held(const dapple::Stage& freeze) {
  const dapple::Domain domain = texture_.domain();
  const int16_t level = freeze.model->cell_level(freeze.number);
  const uint32_t cells = uint32_t{domain.width} * domain.height;
  uint32_t held = 0;
  std::vector<int16_t> row(domain.width);
  for (uint16_t y = 0; y < domain.height; ++y) {
    texture_.row(y, row.data());
    held += static_cast<uint32_t>(std::count_if(row.begin(), row.end(), [=](int16_t v) { return v > level; }));
  }
  if (held != 0 && held != cells) return;
  std::fprintf(stderr, "dapple: warning: 'then freeze' of %s holds %u of %u cells, by above=%s\n", name_.c_str(), held, cells,
               decimal_text(freeze.number[dapple::kinetics::above]).c_str());
}

void Tile::grow(uint32_t budget, Progress& progress) {
  if (budget == 0) budget = step_rows(recipe_, rows_);
  uint32_t before = 0;
  for (uint8_t i = 0; i < recipe_.stages; before += recipe_.stage[i++].steps)
    if (recipe_.stage[i].entry == dapple::Entry::freeze) {
      grow_steps(before, budget, progress);
      tell_held(recipe_.stage[i]);
      break;
    }
  while (texture_.step(budget) == dapple::more) progress.show(name_, texture_.rows_done(), texture_.rows_in_all());
}

void Tile::grow_steps(uint32_t steps, uint32_t budget, Progress& progress) {
  if (budget == 0) budget = step_rows(recipe_, rows_);
  const dapple::Stage& first = recipe_.stage[0];
  if (texture_.rows_done() == 0)
    texture_.step(static_cast<uint32_t>(first.model->planes(first.number)) * (rows_ >> first.level));
  uint8_t level = 0;
  for (uint8_t i = 0; i < recipe_.stages; ++i) level = std::max(level, recipe_.stage[i].level);
  const uint64_t least = texture_.domain().height >> level;  // rows of a step, or fewer
  for (uint32_t done; (done = texture_.steps_done()) < steps; progress.show(name_, done, steps)) {
    const uint64_t rows = std::clamp<uint64_t>((steps - done - 1) * least, 1, budget);
    if (texture_.step(static_cast<uint32_t>(rows)) != dapple::more) break;
  }
}

}  // namespace cli
