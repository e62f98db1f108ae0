// Several sweeps at a time while their rows are in cache: the passes of one plane, or steps of a model on all its
// planes.
// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <vector>

#include "../../lib/evolve/sweep.hpp"

namespace dapple::desktop {

// Sweeps go from one padded copy of the planes to another and back: sweep k does row y once sweep k - 1 has done all
// rows around it, so the rows between the first sweep at work and the last are all that moves through the cache. On a
// torus sweep k begins as many rows behind sweep k - 1 as either of them reaches, and goes round; no row is written
// before the sweep that reads it last is beyond it. Rows come from the planes and go back to them. Where it can be,
// rows are made with halos wide enough for several sweeps, each of which leaves them narrower: wrapping takes time.
class Fused {
 public:
  // All sweeps are over the same planes and leave no margin; with a stride of 0 all rows of a window are one. Their
  // kernels ask for nothing of Rows but rows, numbers, parts and the scratch of a band, and those whose `rows` is set
  // not even for that.
  struct Work {
    const evolve::Sweep* sweep;
    size_t count;
    bool rows;  // kernels may be given several rows as one, with what lies between them
    bool wide;  // and halos beside them: int16, and every cell is made alike
    const int32_t* table;
    uint8_t* scratch;
    uint16_t halo = 0;  // cells there is room for beside a row, or as many as the sweeps want
  };
  void run(const evolve::Field& field, const Work& work);

  // Rows in memory, with room for two halos between them.
  struct Layout {
    size_t before;  // bytes before the first cell of the first row
    size_t pitch;
    size_t bytes(size_t rows) const;
    uint8_t* first(uint8_t* memory) const;  // cell, in memory of so many bytes
  };
  static Layout layout_of(const evolve::Field& field, uint16_t halo, bool wide);

  // Whether there are rows enough for the sweep to go round.
  static bool fits(const evolve::Field& field, const evolve::Sweep& s) {
    return 4u * s.stride * s.radius <= field.height;
  }

 private:
  struct Stage {
    const evolve::Sweep* sweep;
    uint32_t first;  // row it begins with
    uint32_t done;
    uint32_t lag;   // rows that the stage before has to be ahead, beyond the row at hand
    uint16_t halo;  // cells wrapped beside its rows; 0: the next one wants none, or they are there
  };

  void lay_out(const evolve::Field& field, const Work& work);
  uint16_t widest_halo(const evolve::Field& field, const Work& work) const;
  void begin_stages(const evolve::Field& field);
  void load(const evolve::Field& field, const Work& work, uint32_t rows);
  void do_stage(const evolve::Field& field, const Work& work, size_t k);
  void flow(const evolve::Field& field, const Work& work);
  uint8_t* row(size_t buffer, uint8_t plane, uint32_t y) const {
    return buffer_[buffer & 1] + plane * plane_ + size_t{y} * pitch_;
  }

  std::vector<Stage> stages_;
  std::unique_ptr<uint8_t[]> memory_;
  uint8_t* buffer_[2];  // plane 0, row 0, cell 0
  size_t bytes_ = 0, pitch_ = 0, plane_ = 0;
  uint32_t loaded_ = 0, at_once_ = 1;  // rows; that are loaded
  uint16_t halo_ = 0;                  // cells there is room for beside a row
  bool wide_ = false;                  // rows are made with their halos
};

}  // namespace dapple::desktop
