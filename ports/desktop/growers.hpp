// Grows chunks of the plane (lib/chunks.hpp), one on each of several threads at a time. Same bytes, in the same slots.
//
//   dapple::desktop::Growers growers(2);
//   growers.begin(world);                // whenever the cache has begun
//   world.look_at(x, y, 240, 160);
//   growers.grow();
// SPDX-License-Identifier: MIT
#pragma once
#include <mutex>
#include <vector>

#include "../../lib/chunks.hpp"
#include "driver.hpp"

namespace dapple::desktop {

class Growers {
 public:
  explicit Growers(unsigned threads) : crew_(threads), hands_(threads) {}

  // For this cache, which must outlive its use, till the next begin.
  void begin(Chunks& chunks);

  // At most `most` of the chunks that are missing in sight, the nearest first; how many. None while Chunks::step is in
  // the midst of one.
  uint32_t grow(uint32_t most = UINT32_MAX);

 private:
  struct Hand {
    Texture texture;
    std::vector<uint8_t> memory;
    Driver driver{1};
    bool again = false;  // the memory is as the last chunk of this cache has left it
  };
  bool take(uint32_t most, TakenChunk& taken);

  Crew crew_;
  std::vector<Hand> hands_;
  std::mutex mutex_;
  Chunks* chunks_ = nullptr;
  uint32_t taken_ = 0;
};

}  // namespace dapple::desktop
