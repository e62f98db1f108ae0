// Stable states of cell programs, by constraint propagation (Borovsky's completion of textures, for a whole torus).
//
// A state is stable where the five cells around every cell are one of the neighbourhoods that keep it: program bit k is
// bit 0 of k. For every cell there is a mask of the neighbourhoods that are still possible; a cell that has the same
// state in all of them is settled, which narrows the masks of the five cells around it, and so on (generalised arc
// consistency). Then a cell is chosen, and what it leads to is taken back when it ends in an empty mask.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "rule_torus.hpp"

namespace cli {

enum class Answer : uint8_t { stable, none, unknown };

// How a search went.
struct Effort {
  uint64_t choices = 0;    // cells chosen
  uint64_t dead_ends = 0;  // choices taken back
  uint64_t cells = 0;      // settled by choices and what followed from them
  uint32_t searches = 0;   // the first one and restarts
};

// One search on one torus.
class Completion {
 public:
  Completion(uint32_t program, uint16_t width, uint16_t height, const Report& report = {});

  // `none` is proved. Gives up, with `unknown`, after `budget` choices, or when a hundred times as many cells were
  // settled. The seed decides the states that are tried first. budget <= 10^12.
  Answer search(uint32_t seed, uint64_t budget, Effort& effort);
  // The same, with one cell given.
  Answer search_with(uint16_t x, uint16_t y, bool on, uint32_t seed, uint64_t budget, Effort& effort);
  // After `stable`.
  Torus state() const;

 private:
  enum : uint8_t { off, on, open };
  struct Change {
    uint32_t cell, mask;  // the mask it had
  };
  struct Choice {
    uint32_t cell;
    size_t changes, settled;  // how many there were before it
    bool second;
  };

  uint32_t around(uint32_t cell, unsigned slot) const;
  bool narrow(uint32_t cell, uint32_t mask);
  bool settle(uint32_t cell, uint8_t value);
  bool propagate();
  bool begin();
  void take_back(size_t changes, size_t settled);
  bool choose(uint32_t seed);
  bool retreat();
  Answer search_from(uint32_t seed, uint64_t budget, Effort& effort);
  Answer try_once(uint32_t seed, const Effort& end, Effort& effort);

  uint32_t allowed_;
  Report report_;
  uint32_t width_, height_, cells_;
  size_t done_ = 0;  // settled cells whose consequences are drawn
  std::vector<uint32_t> mask_;
  std::vector<uint8_t> value_;
  std::vector<uint16_t> column_;
  std::vector<uint32_t> next_, previous_;  // open cells in raster order, a ring through cells_
  std::vector<Change> changes_;
  std::vector<uint32_t> settled_;
  std::vector<Choice> choices_;
};

struct Completed {
  Answer answer;
  std::optional<Torus> state;        // of stable
  uint16_t tile_width, tile_height;  // of the part that was searched and then repeated; the whole size where it was not
  Effort effort;
};

// Searches the torus itself and, when the budget is spent, small ones that fill it when they are repeated. A state that
// is the same everywhere is the last resort. A stable state is checked by a step.
Completed find_stable(uint32_t program, uint16_t width, uint16_t height, uint32_t seed, uint64_t budget,
                      const Report& report = {});

const char* name_of(Answer answer);

}  // namespace cli
