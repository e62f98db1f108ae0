// Chunks on several threads. See growers.hpp.
// SPDX-License-Identifier: MIT
#include "growers.hpp"

namespace dapple::desktop {

void Growers::begin(Chunks& chunks) {
  chunks_ = &chunks;
  for (Hand& hand : hands_) {
    hand.memory.resize(chunks.working_bytes());
    hand.again = false;
  }
}

bool Growers::take(uint32_t most, TakenChunk& taken) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (taken_ == most || !chunks_->take(taken)) return false;
  ++taken_;
  return true;
}

uint32_t Growers::grow(uint32_t most) {
  taken_ = 0;
  crew_.all([&](unsigned index) {
    Hand& hand = hands_[index];
    for (TakenChunk taken; take(most, taken); hand.again = true)
      chunks_->fill(taken, hand.texture, hand.memory.data(), &hand.driver, hand.again);
  });
  return taken_;
}

}  // namespace dapple::desktop
