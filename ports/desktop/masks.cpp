// Steps of binary convolution in worlds. See masks.hpp.
// SPDX-License-Identifier: MIT
#include "masks.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "../../lib/evolve/steering.hpp"

namespace dapple::desktop {

using stencil::StripMask;
using stencil::World;

constexpr uint16_t kLeastSide = 64;                    // of a torus: rows go round a word at a time
constexpr uint32_t kOwnWorld = 20;                     // taps that a world of its own costs
constexpr uint32_t kSmallGrid = 16384;                 // cells; below, a step is not worth two threads
constexpr size_t kWidest = 32;                         // bytes of a word
constexpr size_t kMostDirections = size_t{128} << 20;  // bytes that are kept

static size_t rounded_up(size_t count, size_t to) { return (count + to - 1) / to * to; }

static size_t direction_bytes(const evolve::Field& field) { return 2 * rounded_up(field.width, 256) * field.height; }

static bool steers(const evolve::Run& run) { return run.solver.next == &evolve::steered_next; }

static const stencil::SteerSet& steer_set(const evolve::Run& run) {
  return *reinterpret_cast<const stencil::SteerSet*>(run.table);
}

bool Masks::fits(const evolve::Run& run) {
  const bool wide = run.domain.plane || (run.field.width >= kLeastSide && run.field.height >= kLeastSide);
  const auto next = run.solver.next;
  if (steers(run))
    return wide && grid::choose(run.kernels, stencil::steer_strip_row) != &stencil::steer_strip_row &&
           direction_bytes(run.field) <= kMostDirections;
  if (next != &evolve::sliced_next && next != &evolve::lean_next && next != &evolve::stored_next) return false;
  if (grid::choose(run.kernels, stencil::strip_row) == &stencil::strip_row) return false;
  const int32_t* const number = run.stage.number;
  const bool signs = number[bits::react] == stencil::max_difference || number[bits::masks] <= 2;
  return signs && wide;
}

Masks::Given Masks::given(const evolve::Run& run) {
  if (run.solver.next == &evolve::stored_next) {
    const auto& masks = *static_cast<const stencil::StoredMasks<1>*>(run.stage.stored);
    return {masks.set.count, masks.set.radius, masks.set.sum, masks.taps};
  }
  const stencil::MaskSet& set =
      steers(run) ? steer_set(run).masks : *reinterpret_cast<const stencil::MaskSet*>(run.table);
  return {set.count, set.radius, set.sum, set.whole};
}

// --- worlds ----------------------------------------------------------------------------------------------------------

namespace {

// A square of weights, seen from a world.
struct Seen {
  const int8_t* weight;
  int radius, lean;
  bool over;

  // At q of row dy, both against the centre.
  int at(int q, int dy) const {
    const int dx = q + lean * dy, side = 2 * radius + 1;
    if (std::abs(dx) > radius || std::abs(dy) > radius) return 0;
    return over ? weight[(dx + radius) * side + dy + radius] : weight[(dy + radius) * side + dx + radius];
  }
  int widest() const { return radius * (lean == 0 ? 1 : 2); }
};

uint32_t units(int weight) {
  return static_cast<uint32_t>(__builtin_popcount(static_cast<unsigned>(std::abs(weight))));
}

struct Counts {
  uint32_t whole = 0, change = 0;
  uint32_t least() const { return std::min(whole, change); }
};
Counts counts_of(const Seen& seen) {
  Counts counts;
  for (int dy = -seen.radius - 1; dy <= seen.radius; ++dy)
    for (int q = -seen.widest(); q <= seen.widest(); ++q) {
      counts.whole += units(seen.at(q, dy));
      counts.change += units(seen.at(q, dy) - seen.at(q, dy + 1));
    }
  return counts;
}

// The columns a mask has weights in, added to those of the world.
void widen(const Seen& seen, int& first, int& last) {
  for (int dy = -seen.radius; dy <= seen.radius; ++dy)
    for (int q = -seen.widest(); q <= seen.widest(); ++q)
      if (seen.at(q, dy) != 0) first = std::min(first, q), last = std::max(last, q);
}

StripMask mask_of(const Seen& seen, const World& world) {
  int8_t whole[(2 * stencil::kLargestMask + 1) * stencil::kWidestStrip];
  int8_t change[(2 * stencil::kLargestMask + 2) * stencil::kWidestStrip];
  const int r = seen.radius;
  int8_t *to = whole, *to_change = change;
  for (int dy = -r - 1; dy <= r; ++dy)
    for (int q = world.first; q < world.first + world.columns; ++q) {
      if (dy >= -r) *to++ = static_cast<int8_t>(seen.at(q, dy));
      *to_change++ = static_cast<int8_t>(seen.at(q, dy) - seen.at(q, dy + 1));
    }
  StripMask mask;
  const Counts counts = counts_of(seen);
  stencil::make_taps(whole, static_cast<uint8_t>(2 * r + 1), world.columns, mask.whole);
  mask.running = counts.change < counts.whole &&
                 stencil::make_taps(change, static_cast<uint8_t>(2 * r + 2), world.columns, mask.change);
  return mask;
}

constexpr int kLean[] = {0, 1, -1, 0};  // of the worlds

}  // namespace

// Every mask in the world where it takes the fewest taps, with the grid kept so that they are fewest in all; upright as
// it is where sums are mixed.
void Masks::plan(const Given& set, bool steered) {
  const size_t cells = (2u * set.radius + 1) * (2u * set.radius + 1);
  std::vector<int8_t> weights(cells * set.count);
  for (uint8_t i = 0; i < set.count; ++i) stencil::weights_of(set.taps[i], set.radius, &weights[i * cells]);
  if (weights == weights_ && steered == steered_) return;
  uint8_t choice[2][stencil::kMaxMasks];
  uint32_t cost[2] = {0, 0};
  const auto seen = [&](size_t i, int world, bool over) {
    return Seen{&weights[i * cells], set.radius, kLean[world], over != (world == turned)};
  };
  for (const bool over : {false, true})
    for (size_t i = 0; i < set.count; ++i) {
      uint32_t best = UINT32_MAX;
      for (uint8_t world = 0; world < (steered ? right : worlds); ++world) {
        const uint32_t taps = counts_of(seen(i, world, over)).least() + (world == upright ? 0 : kOwnWorld);
        if (taps >= best) continue;
        best = taps;
        choice[over][i] = world;
      }
      cost[over] += best;
    }
  over_ = !steered && cost[1] < cost[0];
  for (uint8_t k = 0; k < worlds; ++k) {
    World& world = world_[k];
    int first = 0, last = 0;
    for (size_t i = 0; i < set.count; ++i)
      if (choice[over_][i] == k) widen(seen(i, k, over_), first, last);
    world.lean = static_cast<int8_t>(kLean[k]);
    world.first = static_cast<int8_t>(first);
    world.columns = static_cast<uint8_t>(last - first + 1);
    world.radius = set.radius;
    world.masks = 0;
    for (size_t i = 0; i < set.count; ++i)
      if (choice[over_][i] == k) world.mask[world.masks++] = mask_of(seen(i, k, over_), world);
  }
  weights_ = weights;
  steered_ = steered;
}

// --- the grid --------------------------------------------------------------------------------------------------------

void Masks::Grid::lay_out(uint16_t width, uint16_t height, bool plane, bool leans) {
  constexpr size_t kBeside = 32;  // bytes
  const size_t cells = rounded_up(width, 256);
  bits.pitch = kBeside + cells / 8 * (leans ? 2 : 1) + (leans ? 3 * kBeside : kBeside);
  bits.height = height;
  bits.width = width;
  bits.period = static_cast<uint32_t>(plane ? cells : width);
  memory.resize(bits.pitch * rounded_up(height, 256));
  bits.rows = memory.data() + kBeside;
}

// Cells beside rows first .. end - 1: 64 of them, or as many as rows that lean come to.
void Masks::Grid::go_round(uint16_t first, uint16_t end, bool leans) {
  const uint32_t period = bits.period, whole = period / 64, part = period % 64;
  const uint32_t words = leans ? whole + 6 : 1;
  for (uint16_t y = first; y < end; ++y) {
    uint8_t* const row = bits.rows + bits.pitch * y;
    uint64_t carried = 0;
    if (part != 0) carried = base::load_word<uint64_t>(row + 8 * whole) & ((UINT64_C(1) << part) - 1);
    for (uint32_t i = 0; i < words; ++i) {
      const uint64_t cells = base::load_word<uint64_t>(row + 8 * i);
      base::store_word(row + 8 * (whole + i), carried | (cells << part));
      if (part != 0) carried = cells >> (64 - part);
    }
    base::store_word(row + 8 * (whole + words), carried);
    const uint8_t* const last = row + (period - 64) / 8;
    const uint64_t low = base::load_word<uint64_t>(last) >> (part % 8);
    base::store_word(row - 8, part % 8 == 0 ? low : low | static_cast<uint64_t>(last[8]) << (64 - part % 8));
  }
}

// Ends with the first row that differs.
bool Masks::Grid::same_cells(const Grid& as) const {
  const size_t whole = bits.width / 8;
  const unsigned rest = (1u << bits.width % 8) - 1;
  for (uint16_t y = 0; y < bits.height; ++y) {
    const uint8_t *const a = bits.rows + bits.pitch * y, *const b = as.bits.rows + as.bits.pitch * y;
    if (std::memcmp(a, b, whole) != 0 || ((a[whole] ^ b[whole]) & rest) != 0) return false;
  }
  return true;
}

void Masks::lay_out(const evolve::Run& run) {
  const evolve::Field& f = run.field;
  const uint16_t width = over_ ? f.height : f.width, height = over_ ? f.width : f.height;
  const bool plane = run.domain.plane;
  now_.lay_out(width, height, plane, leans());
  next_.lay_out(width, height, plane, leans());
  if (over_ || world_[turned].masks > 0) {
    turned_now_.lay_out(height, width, plane, false);
    turned_next_.lay_out(height, width, plane, false);
  }
  if (leans()) leaning_.resize(now_.bits.pitch * (size_t{height} + 1));
  if (steered_) directions_.resize(direction_bytes(f) + kWidest);
  fresh_ = true;
}

void Masks::load(const evolve::Field& field) {
  const stencil::BitGrid& to = over_ ? turned_now_.bits : now_.bits;
  for (uint16_t y = 0; y < field.height; ++y)
    std::memcpy(to.rows + to.pitch * y, evolve::row_of(field, 0, y), field.row_bytes);
  if (over_) turn(turned_now_, now_, 0, field.height, 0, false);
}

void Masks::store(const evolve::Field& field) {
  if (over_) turn(now_, turned_now_, 0, field.width, 0, false);
  const stencil::BitGrid& from = over_ ? turned_now_.bits : now_.bits;
  for (uint16_t y = 0; y < field.height; ++y)
    std::memcpy(evolve::row_of(field, 0, y), from.rows + from.pitch * y, field.row_bytes);
}

// --- steps -----------------------------------------------------------------------------------------------------------

// Of every row the cells within the margin.
void Masks::turn(const Grid& from, Grid& to, uint16_t first, uint16_t end, uint16_t margin, bool add) {
  const uint32_t right = from.bits.width - margin, room = static_cast<uint32_t>(rounded_up(from.bits.width, 256));
  const uint32_t words = (right - (margin & ~63u) + 255) / 256, left = std::min(margin & ~63u, room - 256 * words);
  const stencil::Turning turning = {from.bits.rows, to.bits.rows, from.bits.pitch, to.bits.pitch, first, end, left,
                                    right,          add};
  grid::Rows call{};
  call.in[0] = &turning;
  turn_row_(call);
}

void Masks::strip(const evolve::Run& run, uint8_t world, uint16_t first, uint16_t end, bool add, uint8_t* leaning) {
  const Grid &from = world == turned ? turned_now_ : now_, &to = world == turned ? turned_next_ : next_;
  const int16_t threshold = stencil::threshold_of(run.sweep.p[1], given(run).sum);
  const uint16_t margin = run.sweep.margin, right = static_cast<uint16_t>(from.bits.width - margin);
  const stencil::Strip strip = {&world_[world], from.bits, to.bits.rows, add,   threshold,
                                first,          end,       margin,       right, leaning};
  grid::Rows call{};
  call.in[0] = &strip;
  strip_row_(call);
}

void Masks::steer(const evolve::Run& run, uint16_t first, uint16_t end) {
  const int16_t threshold = stencil::threshold_of(run.sweep.p[1], given(run).sum);
  const uintptr_t memory = reinterpret_cast<uintptr_t>(directions_.data());
  const stencil::Steered steered = {
      {&world_[upright], now_.bits, next_.bits.rows, false, threshold, first, end, 0, run.field.width, nullptr},
      &steer_set(run),
      directions_.data() + (-memory & (kWidest - 1)),
      fresh_};
  grid::Rows call{};
  call.in[0] = &steered;
  steer_row_(call);
}

// Calls work(first, end) for parts of from .. end - 1, multiples of `whole` rows, on all hands.
template <class Work>
static void in_parts(Crew* crew, uint16_t from, uint16_t to, uint16_t whole, const Work& work) {
  if (crew == nullptr) return work(from, to);
  const uint32_t blocks = (to - from + whole - 1u) / whole, hands = crew->size();
  crew->all([&](unsigned hand) {
    const uint32_t first = from + blocks * hand / hands * whole, end = from + blocks * (hand + 1) / hands * whole;
    if (first < end) work(static_cast<uint16_t>(first), static_cast<uint16_t>(std::min<uint32_t>(end, to)));
  });
}

void Masks::one_step(const evolve::Run& run, Crew* crew) {
  const uint16_t margin = run.sweep.margin, height = now_.bits.height, width = static_cast<uint16_t>(now_.bits.width);
  const bool turns = world_[turned].masks > 0, goes_round = !run.domain.plane || leans();
  if (goes_round)
    in_parts(crew, 0, height, 1, [&](uint16_t first, uint16_t end) { now_.go_round(first, end, leans()); });
  if (steered_) {
    in_parts(crew, margin, static_cast<uint16_t>(height - margin), 1,
             [&](uint16_t first, uint16_t end) { steer(run, first, end); });
    fresh_ = false;
    return std::swap(now_, next_);
  }
  bool add = false;
  for (uint8_t k = upright; k < turned; ++k) {
    if (world_[k].masks == 0) continue;
    in_parts(crew, margin, static_cast<uint16_t>(height - margin), 1, [&](uint16_t first, uint16_t end) {
      strip(run, k, first, end, add, leaning_.data() + now_.bits.pitch * first);
    });
    add = true;
  }
  if (turns) {
    const uint16_t reach = run.domain.plane ? static_cast<uint16_t>(margin - world_[turned].radius) : uint16_t{0};
    in_parts(crew, static_cast<uint16_t>(reach & ~63u), static_cast<uint16_t>(height - reach), 64,
             [&](uint16_t first, uint16_t end) { turn(now_, turned_now_, first, end, reach, false); });
    if (!run.domain.plane)
      in_parts(crew, 0, width, 1, [&](uint16_t first, uint16_t end) { turned_now_.go_round(first, end, false); });
    in_parts(crew, margin, static_cast<uint16_t>(width - margin), 1,
             [&](uint16_t first, uint16_t end) { strip(run, turned, first, end, false, nullptr); });
    in_parts(crew, static_cast<uint16_t>(margin & ~63u), static_cast<uint16_t>(width - margin), 64,
             [&](uint16_t first, uint16_t end) { turn(turned_next_, next_, first, end, margin, add); });
  }
  std::swap(now_, next_);
}

uint32_t Masks::steps(evolve::Run& run, Crew& crew, uint32_t rows, uint64_t& left_out) {
  const evolve::Field& field = run.field;
  strip_row_ = grid::choose(run.kernels, stencil::strip_row);
  turn_row_ = grid::choose(run.kernels, stencil::turn_row);
  steer_row_ = grid::choose(run.kernels, stencil::steer_strip_row);
  plan(given(run), steers(run));
  lay_out(run);
  load(field);
  const bool alone = crew.size() == 1 || uint32_t{field.width} * field.height < kSmallGrid;
  uint32_t done = 0;
  bool still = false;  // a step of `threshold` changes nothing
  int32_t threshold = 0;
  while (rows - done >= field.height && run.step < run.stage.steps && evolve::take_sweep(run)) {
    done += field.height - 2u * run.sweep.margin;
    if (still && run.sweep.p[1] == threshold) {
      ++left_out;
    } else {
      threshold = run.sweep.p[1];
      one_step(run, alone ? nullptr : &crew);
      still = !run.domain.plane && now_.same_cells(next_);
    }
    evolve::take_sweep(run);  // the step is complete
  }
  store(field);
  return done;
}

}  // namespace dapple::desktop
