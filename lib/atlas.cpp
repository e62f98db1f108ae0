// Patches taking turns, part by part: no ghost cell is copied before all patches have ended their sweep, and no sweep
// begins before all ghost cells are there.
// SPDX-License-Identifier: MIT
#include "atlas.hpp"

namespace dapple {

Status Atlas::begin(const Recipe& recipe, const Patches& patches, uint32_t seed, Texture* textures, void* memory,
                    size_t bytes, const Options& options, AtlasNeed* need) {
  AtlasNeed wanted = atlas_need(recipe, patches, options.bands);
  if (wanted.status == ok && (memory == nullptr || textures == nullptr || bytes < wanted.bytes))
    wanted.status = too_little_memory;
  if (need != nullptr) *need = wanted;
  if (wanted.status != ok) return wanted.status;
  texture_ = textures;
  count_ = patches.count;
  at_ = 0;
  part_ = 0;
  uint8_t* const first = base::aligned4(memory);
  for (uint8_t i = 0; i < count_; ++i) {
    const evolve::Ghosts ghosts = {evolve::seal_row, first, wanted.block, nullptr, false, false};
    texture_[i].begin_patch(recipe, on_patch(patches, i), seed, first + i * wanted.block, options, ghosts);
  }
  return ok;
}

Status Atlas::step(uint32_t rows) {
  uint8_t finished = 0;
  while (finished < count_) {
    evolve::Run& run = texture_[at_].run_;
    const uint64_t before = run.rows;
    const bool left = evolve::advance(run, rows, true);
    rows -= static_cast<uint32_t>(run.rows - before);
    if (left && run.parts == part_) return more;
    finished = static_cast<uint8_t>(left ? 0 : finished + 1);
    if (++at_ < count_) continue;
    at_ = 0;
    ++part_;
  }
  return done;
}

uint64_t Atlas::rows_done() const {
  uint64_t sum = 0;
  for (uint8_t i = 0; i < count_; ++i) sum += texture_[i].rows_done();
  return sum;
}

uint64_t Atlas::rows_in_all() const { return count_ * texture_[0].rows_in_all(); }

}  // namespace dapple
