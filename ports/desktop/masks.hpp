// Steps of binary convolution (lib/evolve/convolution.hpp) where a cell is on as soon as one mask says so: every mask
// in the world in which it takes the fewest taps (strips.hpp), the grid in memory of its own. And those along a field
// of directions (lib/evolve/steering.hpp), whose masks stay upright since their sums are mixed; the directions are
// kept.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "../../lib/evolve/run.hpp"
#include "crew.hpp"
#include "strips.hpp"

namespace dapple::desktop {

class Masks {
 public:
  static bool fits(const evolve::Run& run);

  // As many whole steps of the stage as `rows` rows of work allow; the rows done. Those that need not be done, since
  // one of the same numbers has changed no cell, are added to left_out.
  uint32_t steps(evolve::Run& run, Crew& crew, uint32_t rows, uint64_t& left_out);

 private:
  enum { upright, right, left, turned, worlds };

  // Rows of a grid of width x height, and what is made of them.
  struct Grid {
    std::vector<uint8_t> memory;
    stencil::BitGrid bits;
    void lay_out(uint16_t width, uint16_t height, bool plane, bool leans);
    void go_round(uint16_t first, uint16_t end, bool leans);
    bool same_cells(const Grid& as) const;
  };

  // The masks of a stage, made when it began or stored.
  struct Given {
    uint8_t count, radius;
    int16_t sum;
    const stencil::Taps* taps;
  };
  static Given given(const evolve::Run& run);

  void plan(const Given& set, bool steered);
  void lay_out(const evolve::Run& run);
  void load(const evolve::Field& field);
  void store(const evolve::Field& field);
  bool leans() const { return world_[right].masks + world_[left].masks > 0; }
  void one_step(const evolve::Run& run, Crew* crew);
  void strip(const evolve::Run& run, uint8_t world, uint16_t first, uint16_t end, bool add, uint8_t* leaning);
  void steer(const evolve::Run& run, uint16_t first, uint16_t end);
  void turn(const Grid& from, Grid& to, uint16_t first, uint16_t end, uint16_t margin, bool add);

  std::vector<int8_t> weights_;  // of all masks, that the worlds were made for
  bool steered_ = false;         // and whether upright ones alone
  bool over_ = false;            // the grid is kept turned over
  stencil::World world_[worlds];
  Grid now_, next_;                // as it is kept
  Grid turned_now_, turned_next_;  // for the world that is turned against that
  std::vector<uint8_t> leaning_;
  std::vector<uint8_t> directions_;
  bool fresh_ = false;  // they are still to be made
  grid::RowKernel strip_row_ = nullptr, turn_row_ = nullptr, steer_row_ = nullptr;
};

}  // namespace dapple::desktop
