// The passes of one plane, several at a time while their rows are in cache.
// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <vector>

#include "../../lib/evolve/sweep.hpp"

namespace dapple::desktop {

// Passes go from one padded copy of the plane to another and back: pass k does row y once pass k - 1 has done all rows around
// it, so the rows between the first pass at work and the last are all that moves through the cache. On a torus pass k begins
// as many rows behind pass k - 1 as either of them reaches, and goes round; no row is written before the pass that reads
// it last is beyond it. Rows come from the plane, after the chain along x if there is one, and go back to it.
class Fused {
 public:
  // All sweeps are passes (a chain may come first) over the one plane `sweep[0].first`; scratch: that of a band.
  void run(const evolve::Field& field, const evolve::Sweep* sweep, size_t count, bool chain, uint8_t* scratch);

  // Whether rows are enough for the passes to go round.
  static bool fits(const evolve::Field& field, const evolve::Sweep& pass) { return 4u * pass.stride <= field.height; }

 private:
  struct Stage {
    const evolve::Sweep* sweep;
    uint32_t first;  // row it begins with
    uint32_t done;
    uint32_t lag;    // rows that the stage before has to be ahead, beyond the row at hand
  };

  void load(const evolve::Field& field, uint8_t plane, const evolve::Sweep* chain, uint8_t* scratch, uint32_t rows);
  void pass(const evolve::Field& field, uint8_t plane, size_t k);
  void flow(const evolve::Field& field, uint8_t plane, const evolve::Sweep* chain, uint8_t* scratch);
  uint8_t* row(size_t buffer, uint32_t y) { return buffer_[buffer & 1] + size_t{y} * pitch_; }

  std::vector<Stage> stages_;
  std::unique_ptr<uint8_t[]> memory_;
  uint8_t* buffer_[2];  // row 0, cell 0
  size_t bytes_ = 0, pitch_ = 0;
  uint32_t loaded_ = 0;
  uint16_t halo_ = 0;
};

}  // namespace dapple::desktop
