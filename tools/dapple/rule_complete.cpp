// Stable states of cell programs, by constraint propagation.
// SPDX-License-Identifier: MIT
#include "rule_complete.hpp"

#include <algorithm>

#include "base/hash.hpp"

namespace cli {

// Slots of a neighbourhood: bit s of its index. The neighbourhoods in which slot s is on, and their complement.
constexpr unsigned kSlots = 5;
constexpr uint32_t kOn[kSlots] = {0xaaaaaaaa, 0xcccccccc, 0xf0f0f0f0, 0xff00ff00, 0xffff0000};
constexpr unsigned kMirrored[kSlots] = {0, 2, 1, 4, 3};  // the slot a cell has in the neighbourhood of its neighbour

constexpr uint32_t kLooks = 16;       // open cells among which one is chosen
constexpr uint64_t kFirstLimit = 50;  // dead ends before the first restart; half as many again each time
constexpr uint64_t kCellsEach = 100;  // that may be settled for each choice of the budget

static unsigned count_bits(uint32_t mask) {
  unsigned count = 0;
  for (; mask != 0; mask &= mask - 1) ++count;
  return count;
}

Completion::Completion(uint32_t program, uint16_t width, uint16_t height, const Report& report)
    : allowed_(0),
      report_(report),
      width_(width),
      height_(height),
      cells_(width_ * height_),
      mask_(cells_),
      value_(cells_),
      column_(cells_),
      next_(cells_ + 1),
      previous_(cells_ + 1) {
  for (uint32_t cell = 0; cell < cells_; ++cell) column_[cell] = static_cast<uint16_t>(cell % width_);
  for (unsigned k = 0; k < 32; ++k)
    if ((program >> k & 1) == (k & 1)) allowed_ |= UINT32_C(1) << k;
}

// The cell in slot 0 self, 1 lower, 2 upper, 3 right, 4 left.
uint32_t Completion::around(uint32_t cell, unsigned slot) const {
  const uint32_t x = column_[cell];
  switch (slot) {
    case 1:
      return cell + width_ < cells_ ? cell + width_ : x;
    case 2:
      return cell >= width_ ? cell - width_ : cells_ - width_ + x;
    case 3:
      return x + 1 < width_ ? cell + 1 : cell - x;
    case 4:
      return x > 0 ? cell - 1 : cell + width_ - 1;
    default:
      return cell;
  }
}

// False: no neighbourhood is left.
bool Completion::narrow(uint32_t cell, uint32_t mask) {
  const uint32_t left = mask_[cell] & mask;
  if (left == mask_[cell]) return left != 0;
  changes_.push_back({cell, mask_[cell]});
  mask_[cell] = left;
  if (left == 0) return false;
  for (unsigned slot = 0; slot < kSlots; ++slot) {
    const bool may_be_on = (left & kOn[slot]) != 0, may_be_off = (left & ~kOn[slot]) != 0;
    if (may_be_on != may_be_off && !settle(around(cell, slot), may_be_on ? on : off)) return false;
  }
  return true;
}

// False: it is settled otherwise.
bool Completion::settle(uint32_t cell, uint8_t value) {
  if (value_[cell] != open) return value_[cell] == value;
  value_[cell] = value;
  settled_.push_back(cell);
  next_[previous_[cell]] = next_[cell];
  previous_[next_[cell]] = previous_[cell];
  return true;
}

bool Completion::propagate() {
  for (; done_ < settled_.size(); ++done_) {
    const uint32_t cell = settled_[done_];
    for (unsigned slot = 0; slot < kSlots; ++slot)
      if (!narrow(around(cell, kMirrored[slot]), value_[cell] == on ? kOn[slot] : ~kOn[slot])) return false;
  }
  return true;
}

// Everything open; then what the program alone settles.
bool Completion::begin() {
  std::fill(mask_.begin(), mask_.end(), UINT32_MAX);
  std::fill(value_.begin(), value_.end(), static_cast<uint8_t>(open));
  changes_.clear();
  settled_.clear();
  choices_.clear();
  done_ = 0;
  for (uint32_t cell = 0; cell <= cells_; ++cell) {
    next_[cell] = cell == cells_ ? 0 : cell + 1;
    previous_[next_[cell]] = cell;
  }
  for (uint32_t cell = 0; cell < cells_; ++cell)
    if (!narrow(cell, allowed_)) return false;
  return propagate();
}

void Completion::take_back(size_t changes, size_t settled) {
  for (; changes_.size() > changes; changes_.pop_back()) mask_[changes_.back().cell] = changes_.back().mask;
  for (; settled_.size() > settled; settled_.pop_back()) {  // back into the ring, the last one first
    const uint32_t cell = settled_.back();
    value_[cell] = open;
    next_[previous_[cell]] = previous_[next_[cell]] = cell;
  }
  done_ = settled;
}

// Chooses the most constrained of the next open cells; false when all are settled.
bool Completion::choose(uint32_t seed) {
  uint32_t chosen = next_[cells_], seen = 0;
  if (chosen == cells_) return false;
  unsigned fewest = 33;
  for (uint32_t cell = chosen; cell != cells_ && seen < kLooks; cell = next_[cell], ++seen) {
    const unsigned count = count_bits(mask_[cell]);
    if (count >= fewest) continue;
    fewest = count;
    chosen = cell;
  }
  choices_.push_back({chosen, changes_.size(), settled_.size(), false});
  return settle(chosen, (dapple::base::hash(seed, 0, 0, static_cast<int32_t>(chosen)) & 1) != 0 ? on : off);
}

// Takes back to the latest choice whose other value was not tried yet, and tries it; false when there is none.
bool Completion::retreat() {
  for (; !choices_.empty(); choices_.pop_back()) {
    Choice& choice = choices_.back();
    const uint8_t other = value_[choice.cell] == on ? off : on;
    take_back(choice.changes, choice.settled);
    if (choice.second) continue;
    choice.second = true;
    return settle(choice.cell, other);
  }
  return false;
}

// From what is settled by now. Chronological backtracking.
Answer Completion::try_once(uint32_t seed, const Effort& end, Effort& effort) {
  for (;;) {
    const size_t before = done_;
    const bool possible = propagate();
    effort.cells += done_ - before;
    if (!possible) {
      ++effort.dead_ends;
      if (!retreat()) return Answer::none;
      if (effort.dead_ends == end.dead_ends) return Answer::unknown;
      continue;
    }
    if (effort.choices >= end.choices || effort.cells >= end.cells) return Answer::unknown;
    if (!choose(seed)) return Answer::stable;
    if (++effort.choices % 256 == 0 && report_) report_(effort.choices, end.choices);
  }
}

// From what is settled by now, with restarts.
Answer Completion::search_from(uint32_t seed, uint64_t budget, Effort& effort) {
  const size_t changes = changes_.size(), settled = settled_.size();
  Effort end = effort;
  end.choices += budget;
  end.cells += budget * kCellsEach;
  for (uint64_t limit = kFirstLimit; effort.choices < end.choices && effort.cells < end.cells; limit += limit / 2) {
    choices_.clear();
    take_back(changes, settled);
    end.dead_ends = effort.dead_ends + limit;
    const Answer answer = try_once(dapple::base::mix(seed + effort.searches++), end, effort);
    if (answer != Answer::unknown) return answer;
  }
  return Answer::unknown;
}

Answer Completion::search(uint32_t seed, uint64_t budget, Effort& effort) {
  return begin() ? search_from(seed, budget, effort) : Answer::none;
}

Answer Completion::search_with(uint16_t x, uint16_t y, bool is_on, uint32_t seed, uint64_t budget, Effort& effort) {
  const uint32_t cell = width_ * y + x;
  return begin() && settle(cell, is_on ? on : off) && propagate() ? search_from(seed, budget, effort) : Answer::none;
}

Torus Completion::state() const {
  Torus torus(static_cast<uint16_t>(width_), static_cast<uint16_t>(height_));
  for (uint32_t cell = 0; cell < cells_; ++cell)
    torus.set(static_cast<uint16_t>(cell % width_), static_cast<uint16_t>(cell / width_), value_[cell] == on);
  return torus;
}

static bool uniform(const Torus& torus) {
  const uint64_t on = torus.count();
  return on == 0 || on == torus.cells();
}

// A search that does not stay with a state that is the same everywhere: a cell of the other state is given, anywhere.
static Answer search_varied(Completion& completion, uint32_t seed, uint64_t budget, Effort& effort,
                            std::optional<Torus>& state) {
  const Answer answer = completion.search(seed, budget, effort);
  if (answer != Answer::stable) return answer;
  state = completion.state();
  if (!uniform(*state)) return answer;
  const uint16_t x = static_cast<uint16_t>(seed % state->width()),
                 y = static_cast<uint16_t>(seed / 65536 % state->height());
  if (completion.search_with(x, y, !state->get(0, 0), seed, budget, effort) == Answer::stable)
    state = completion.state();
  return answer;
}

static Torus repeated(const Torus& tile, uint16_t width, uint16_t height) {
  Torus torus(width, height);
  for (uint16_t y = 0; y < height; ++y)
    for (uint16_t x = 0; x < width; ++x)
      torus.set(x, y, tile.get(static_cast<uint16_t>(x % tile.width()), static_cast<uint16_t>(y % tile.height())));
  return torus;
}

struct TileSize {
  uint16_t width, height;
};

// Sizes that fill the torus when they are repeated, the widest first. Stripes may be as long as the torus.
static std::vector<TileSize> tile_sizes(uint16_t width, uint16_t height) {
  constexpr uint32_t kLongest = 16, kCells = 256, kStripe = 2;
  std::vector<TileSize> sizes;
  for (uint32_t w = 1; w <= width; ++w)
    for (uint32_t h = 1; h <= height; ++h) {
      if (w > kLongest && w != width) break;
      if (width % w != 0 || height % h != 0 || (w == width && h == height)) continue;
      const bool small = w <= kLongest && h <= kLongest && w * h <= kCells;
      const bool stripe = (w <= kStripe && h == height) || (h <= kStripe && w == width);
      if (small || stripe) sizes.push_back({static_cast<uint16_t>(w), static_cast<uint16_t>(h)});
    }
  std::stable_sort(sizes.begin(), sizes.end(), [](const TileSize& a, const TileSize& b) {
    const uint16_t narrow_a = std::min(a.width, a.height), narrow_b = std::min(b.width, b.height);
    return narrow_a != narrow_b ? narrow_a > narrow_b : a.width + a.height > b.width + b.height;
  });
  return sizes;
}

Completed find_stable(uint32_t program, uint16_t width, uint16_t height, uint32_t seed, uint64_t budget,
                      const Report& report) {
  Completed done{Answer::unknown, std::nullopt, width, height, {}};
  Completion whole(program, width, height, report);
  done.answer = search_varied(whole, seed, budget, done.effort, done.state);
  if (done.answer != Answer::unknown) return done;
  for (const TileSize& size : tile_sizes(width, height)) {
    Completion small(program, size.width, size.height);
    std::optional<Torus> tile;
    if (search_varied(small, seed, budget / 16 + 1, done.effort, tile) != Answer::stable) continue;
    if (done.state && uniform(*tile)) continue;  // another one of those
    done.answer = Answer::stable;
    done.state = repeated(*tile, width, height);
    done.tile_width = size.width;
    done.tile_height = size.height;
    if (!uniform(*tile)) break;
  }
  return done;
}

const char* name_of(Answer answer) {
  return answer == Answer::stable ? "stable" : answer == Answer::none ? "none" : "unknown";
}

}  // namespace cli
