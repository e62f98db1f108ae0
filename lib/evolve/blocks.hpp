// Windows of the plane in blocks, for the threshold family, whose reaction is one bit a cell: what a window needs is decided
// block by block, and then shaded.
//
//   layer 0   chunks of a square lattice, grown a wavelength wider, from the start
//   layer 1   upright edges      |x| < half,           margin <= y < side - margin
//   layer 2   level edges        margin <= x < side - margin,           |y| < half
//   layer 3   corners            |x|, |y| < corner
//
// A block of layers 1 to 3 is solved again in a margin: it reads the bits of the layers below, has the concentrations settle
// on them, then lets its own reaction live while that of the margin stays. It reads lower layers only, and blocks of a layer
// and their margins keep clear of each other: whatever is asked for first, a block is the same. A cell's bit is that of the
// highest layer that covers it.
// Only bits pass between blocks: concentrations are a short filter of them, so there is no crease. Shading is a filter of
// finite support, so that the field is exact too.
// SPDX-License-Identifier: MIT
#pragma once
#include "../model/threshold.hpp"
#include "refine.hpp"
#include "run.hpp"

namespace dapple::evolve {

constexpr uint8_t kLayers = 4;
constexpr uint32_t kFineSteps = 6;            // the last ones of a chunk, on the finest grid
constexpr int32_t kCoarseLength = 16000000;   // half the resolution grows noise into stripes this wide as well, 1/kMicro cells
constexpr uint16_t kAlike = 8;                // a chunk's ground begins at a multiple of this: any coarse grid's

struct Span {
  int32_t from, to;
};
struct Box {
  Span x, y;
};

// The lattice, cells.
struct BlockGrid {
  uint16_t side, margin, half, corner;
  uint16_t around;  // chunks are grown with this much more on every side
};

// Eight lengths of the pattern a side, rounded up to whole 32 cells; margins of 5/4, 3/4, 3/2 and one of it.
constexpr BlockGrid block_grid(int32_t length) {
  const auto quarters = [&](int64_t count) {
    return static_cast<uint16_t>((count * length + 4 * base::kMicro - 1) / (4 * base::kMicro));
  };
  const int64_t sides = (static_cast<int64_t>(length) + 4 * base::kMicro - 1) / (4 * base::kMicro);
  return {static_cast<uint16_t>(32 * (sides < 2 ? 2 : sides)), quarters(5), quarters(3), quarters(6),
          static_cast<uint16_t>((quarters(4) + kAlike - 1) / kAlike * kAlike)};
}

// What block `index` of a layer covers along x (or y).
constexpr Span stretch(const BlockGrid& g, uint8_t layer, bool along_y, int32_t index) {
  const int32_t at = index * g.side;
  if (layer == 0) return {at, at + g.side};
  if (layer == 3) return {at - g.corner, at + g.corner};
  if ((layer == 2) == along_y) return {at - g.half, at + g.half};
  return {at + g.margin, at + g.side - g.margin};
}

constexpr Span wider(const Span& s, int32_t by) { return {s.from - by, s.to + by}; }
constexpr Span hull(const Span& a, const Span& b) { return {base::min(a.from, b.from), base::max(a.to, b.to)}; }
constexpr uint16_t length_of(const Span& s) { return static_cast<uint16_t>(s.to - s.from); }
constexpr uint16_t margin_of(const BlockGrid& g, uint8_t layer) { return layer == 0 ? g.around : g.margin; }

constexpr Box covered(const BlockGrid& g, uint8_t layer, int32_t i, int32_t j) {
  return {stretch(g, layer, false, i), stretch(g, layer, true, j)};
}
// With its margin: what is grown.
constexpr Box grown(const BlockGrid& g, uint8_t layer, int32_t i, int32_t j) {
  const Box box = covered(g, layer, i, j);
  return {wider(box.x, margin_of(g, layer)), wider(box.y, margin_of(g, layer))};
}

// Blocks first .. last along one direction; none when last < first.
struct Range {
  int32_t first, last;
};
constexpr uint32_t count_of(const Range& r) { return r.last < r.first ? 0 : static_cast<uint32_t>(r.last - r.first) + 1; }

// The blocks of a layer that meet a span.
constexpr Range meeting(const BlockGrid& g, uint8_t layer, bool along_y, const Span& s) {
  const Span zero = stretch(g, layer, along_y, 0);
  const auto floor_of = [&](int32_t value) { return grid::round_down(value, g.side) / g.side; };
  return {floor_of(s.from - zero.to) + 1, floor_of(s.to - zero.from - 1)};
}

// The blocks that a window needs, by layer.
struct Cover {
  Range x[kLayers], y[kLayers];
};
constexpr uint32_t count_of(const Cover& c, uint8_t layer) { return count_of(c.x[layer]) * count_of(c.y[layer]); }

constexpr Cover cover_of(const BlockGrid& g, Box wanted) {
  Cover cover{};
  for (uint8_t layer = kLayers; layer-- > 0;) {
    cover.x[layer] = meeting(g, layer, false, wanted.x);
    cover.y[layer] = meeting(g, layer, true, wanted.y);
    if (layer == 0 || count_of(cover, layer) == 0) continue;
    const Box first = grown(g, layer, cover.x[layer].first, cover.y[layer].first);
    const Box last = grown(g, layer, cover.x[layer].last, cover.y[layer].last);
    wanted = {hull(wanted.x, hull(first.x, last.x)), hull(wanted.y, hull(first.y, last.y))};
  }
  return cover;
}

// Chunks along one direction that a window may need, wherever it lies: a corner, the level edge beside it, the upright edge
// beside that and the chunk beside that reach beyond it.
constexpr uint32_t most_chunks(const BlockGrid& g, uint32_t length) {
  const uint32_t beyond = 2u * g.corner + g.side + 2u * g.half + g.margin;
  return (length + 2 * beyond + g.side - 2u) / g.side + 1;
}

// --- what runs in a block ------------------------------------------------------------------------------------------

// given_bits: macro steps with the reaction given as bits but for a rectangle, where it lives.
// shaded_bits: what concentrations settle to on given bits, as a filter of them, in three long steps from the oldest on.
//   C = sum over t >= 1 of k (1 - e^-1/2) e^-(t-1)/2 Gaussian(t V) * R,  with t = 1; 2 and 3 as 2.3775; the rest as 5.5415
// 1.6 % off for the activator at the pattern's wavelength, .5 % for the difference. Stage::stored: a threshold::Given.
constexpr uint8_t kShadeSteps = 3;
constexpr int32_t kShadeLength[kShadeSteps] = {207356, 90276, 65536};  // Q16 macro steps
constexpr int32_t kShadeAmount[kShadeSteps] = {1785, 3067, 3148};      // their sum is 8000

constexpr Reach given_reach(const Model& model, const int32_t* number, uint8_t level, const void*) {
  Reach reach = gaussian_reach(model, number, level, nullptr);
  reach.table = (sizeof(const void*) + 3) / 4;
  return reach;
}
// sweeps and spread are those of the three steps together.
constexpr Reach shading_reach(const Model& model, const int32_t* number, uint8_t level, const void*) {
  Reach most = given_reach(model, number, level, nullptr);
  most.sweeps = most.spread = 0;
  for (const int32_t length : kShadeLength) {
    const Reach reach = passes_reach(model, number, level, length);
    most.radius = reach.radius > most.radius ? reach.radius : most.radius;
    most.halo = wider(most.halo, reach.halo);
    most.halo_rows = reach.halo_rows > most.halo_rows ? reach.halo_rows : most.halo_rows;
    most.stride = wider(most.stride, reach.stride);
    most.sweeps = static_cast<uint16_t>(most.sweeps + reach.sweeps);
    most.spread = static_cast<uint16_t>(most.spread + reach.spread);
  }
  return most;
}
bool given_next(const Context& context, Cursor& cursor, Sweep& sweep);
bool shading_next(const Context& context, Cursor& cursor, Sweep& sweep);
void prepare_given(const Context& context);
inline constexpr Solver given_bits DAPPLE_ROM = {given_reach, given_next, prepare_given};
inline constexpr Solver shaded_bits DAPPLE_ROM = {shading_reach, shading_next, prepare_given};

void blank_row(const start::Place& place, const Start& start, const grid::Levels& levels, uint8_t plane, uint16_t y, void* row);

// A recipe's start and stages.
struct Growth {
  const Start* start;
  const Stage* stage;
  uint8_t stages;
};

struct BlockPlan {
  BlockGrid grid;
  Stage chunk[kMaxStages];  // the recipe's own
  Stage again[2];           // of layers 1 to 3: settle on the bits, then live
  Stage shade;              // of the window
  Start start, blank;
  uint8_t stages;
};

// A wavelength; longer where the activator reaches more than 4/3 times as far along the stripes as the inhibitor across them.
constexpr int32_t stripe_length(const Stage& stage) {
  const int32_t* const number = stage.number;
  const int32_t length = stage.model->wavelength(number);
  if (number[threshold::diffusion] == threshold::isotropic) return length;
  const int64_t along = static_cast<int64_t>(length) * 3 * number[threshold::stretch];
  return base::max(length, static_cast<int32_t>(along / (4 * static_cast<int64_t>(number[threshold::ratio]))));
}

// The longest length of the pattern: that of the stripes, or the side of the square that a seed has for itself.
constexpr int32_t pattern_length(const Growth& growth) {
  const Start& start = *growth.start;
  int32_t length = 0;
  for (uint8_t i = 0; i < growth.stages; ++i) length = base::max(length, stripe_length(growth.stage[i]));
  if (start.kind != Start::seeds) return length;
  const uint64_t square = static_cast<uint64_t>(start.pitch) * static_cast<uint64_t>(start.pitch) / base::kMicro;
  return base::max(length, static_cast<int32_t>(base::square_root64(square * static_cast<uint64_t>(start.aspect))));
}

constexpr BlockPlan block_plan(const Growth& growth) {
  const Start& start = *growth.start;
  BlockPlan plan{};
  plan.grid = block_grid(pattern_length(growth));
  uint32_t steps = 0;
  for (plan.stages = 0; plan.stages < growth.stages; ++plan.stages) {
    plan.chunk[plan.stages] = growth.stage[plan.stages];
    steps += growth.stage[plan.stages].steps;
  }
  const Stage& last = growth.stage[growth.stages - 1];
  if (plan.stages == 1 && start.kind == Start::noise && steps > 2 * kFineSteps &&
      last.model->wavelength(last.number) >= kCoarseLength) {
    plan.chunk[1] = last;
    plan.chunk[0].level = 1;
    plan.chunk[0].steps = steps - kFineSteps;
    plan.chunk[1].steps = kFineSteps;
    plan.chunk[1].entry = Entry::refine;
    plan.chunk[1].refine = refine_row;
    plan.stages = 2;
  }
  plan.shade = plan.again[1] = last;
  plan.shade.entry = Entry::start;
  plan.shade.solver = &shaded_bits;
  plan.shade.steps = kShadeSteps;
  plan.again[0] = plan.shade;
  plan.again[1].entry = Entry::carry;
  plan.again[1].solver = &given_bits;
  plan.again[1].steps = (steps * (start.kind == Start::seeds ? 3 : 6) + 9) / 10;
  plan.start = plan.blank = start;
  plan.blank.row = blank_row;
  return plan;
}

// --- memory and work -----------------------------------------------------------------------------------------------

// A chunk of the lattice, the edges at its left and its top, and the corner between them: which of them are decided, and
// behind this their bits, layer by layer, rows of whole bytes.
struct Decided {
  int32_t x, y;
  uint8_t layers;  // bit k: layer k
};

constexpr uint16_t bytes_of_bits(uint16_t width) { return static_cast<uint16_t>((width + 7u) / 8u); }
constexpr size_t bits_bytes(const Box& box) { return static_cast<size_t>(length_of(box.y)) * bytes_of_bits(length_of(box.x)); }
// Where a layer's bits begin; of kLayers: where the next record does.
constexpr size_t layer_offset(const BlockGrid& g, uint8_t layer) {
  size_t bytes = sizeof(Decided);
  for (uint8_t i = 0; i < layer; ++i) bytes += bits_bytes(covered(g, i, 0, 0));
  return layer == kLayers ? grid::align4(bytes) : bytes;
}

constexpr Box box_of(const Ground& g) { return {{g.x, g.x + g.width}, {g.y, g.y + g.height}}; }
constexpr Ground ground_of(const Box& b) { return {length_of(b.x), length_of(b.y), b.x.from, b.y.from}; }

// The bits that the block at work, or the window, reads.
constexpr size_t given_bytes(const BlockGrid& g, const Ground& window) {
  size_t most = bits_bytes(box_of(window));
  for (uint8_t layer = 1; layer < kLayers; ++layer) {
    const size_t bytes = bits_bytes(grown(g, layer, 0, 0));
    most = bytes > most ? bytes : most;
  }
  return grid::align4(most);
}

enum class Doing : uint8_t { gathering, solving, keeping, shading };

// The work on a window, in the texture's memory: this, the records, the bits given.
struct Blocks {
  bool (*advance)(Blocks& blocks, Run& run, uint32_t rows);  // as evolve::advance
  BlockPlan plan;
  Setup setup;             // the window's
  Cover cover;
  threshold::Given given;
  uint8_t *records, *bits;
  size_t record_bytes;
  uint16_t across, down;   // records
  int32_t x, y;            // the block at work
  uint16_t at_row;
  uint8_t layer;
  Doing doing;
};

// Bytes of it on `window`, with `kept` more cells on either side.
constexpr bool blocks_bytes(const BlockGrid& g, const Ground& window, uint16_t kept, size_t& total) {
  const uint32_t across = most_chunks(g, static_cast<uint32_t>(window.width) + kept);
  const uint32_t down = most_chunks(g, static_cast<uint32_t>(window.height) + kept);
  total = grid::align4(sizeof(Blocks) + alignof(Blocks));
  size_t row = 0;
  return base::add_bytes(row, across, layer_offset(g, kLayers)) && base::add_bytes(total, down, row) &&
         base::add_bytes(total, 1, given_bytes(g, window));
}

constexpr void add_blocks(Parts& parts, const BlockPlan& plan, const Ground& window, uint8_t bands, uint16_t kept) {
  const auto add = [&](const Stage& stage, const Ground& ground) {
    add_stage(parts, stage, *stage.model, *stage.solver, ground, stage.level, bands);
  };
  for (uint8_t i = 0; i < plan.stages; ++i) add(plan.chunk[i], ground_of(grown(plan.grid, 0, 0, 0)));
  for (uint8_t layer = 1; layer < kLayers; ++layer)
    for (const Stage& stage : plan.again) add(stage, ground_of(grown(plan.grid, layer, 0, 0)));
  add(plan.shade, window);
  parts.fits = parts.fits && blocks_bytes(plan.grid, window, kept, parts.blocks);
}

// Rows of work of a window once all is decided: gathered and shaded.
constexpr uint64_t shade_rows(const BlockPlan& plan, uint16_t height) {
  const Stage& s = plan.shade;
  const Reach reach = shading_reach(*s.model, s.number, 0, nullptr);
  return static_cast<uint64_t>(height) * (1u + s.model->planes(s.number) + reach.sweeps);
}
// Of a block: a chunk is grown, others are shaded and solved; then it is kept.
constexpr uint64_t block_rows(const BlockPlan& plan, uint8_t layer) {
  const Ground ground = ground_of(grown(plan.grid, layer, 0, 0));
  const bool chunk = layer == 0;
  uint64_t rows = length_of(covered(plan.grid, layer, 0, 0).y) + (chunk ? 0 : shade_rows(plan, ground.height));
  uint32_t spent = 0;
  for (uint8_t i = chunk ? 0 : 1; i < (chunk ? plan.stages : 2); ++i) {
    const Stage& s = chunk ? plan.chunk[i] : plan.again[i];
    rows += work_rows(s, *s.model, s.solver->reach(*s.model, s.number, s.level, s.stored), ground, false, spent);
  }
  return rows;
}

// What a recipe asks of every window; what it needs on one.
struct BlockShape {
  uint16_t side, halo;  // of the lattice; of the window
};
struct BlockNeed {
  Parts parts;
  uint16_t stride, sweeps;  // of the shading
  uint64_t rows;            // of work with nothing decided
};

constexpr BlockShape block_shape(const Growth& growth) {
  const Stage& last = growth.stage[growth.stages - 1];
  return {block_grid(pattern_length(growth)).side, shading_reach(*last.model, last.number, 0, nullptr).spread};
}

constexpr BlockNeed block_need(const Growth& growth, const Ground& window, uint8_t bands, uint16_t kept) {
  const BlockPlan plan = block_plan(growth);
  const Reach reach = shading_reach(*plan.shade.model, plan.shade.number, 0, nullptr);
  const Cover cover = cover_of(plan.grid, box_of(window));
  BlockNeed need{{0, 0, 0, sizeof(Band) * bands, true}, reach.stride, reach.sweeps, shade_rows(plan, window.height)};
  add_blocks(need.parts, plan, window, bands, kept);
  for (uint8_t layer = 0; layer < kLayers; ++layer) need.rows += count_of(cover, layer) * block_rows(plan, layer);
  return need;
}

// setup.ground: the window's; setup.memory: as the parts say. again: the memory is as it was left by a run that began with the
// same arguments, but for the place. run gets ready. Returns the rows of work in all.
uint64_t begin_blocks(const Growth& growth, const Setup& setup, uint16_t kept, bool again, Run& run);

// What a recipe carries whose windows can be in blocks: firmware links no other.
struct BlockWork {
  BlockShape (*shape)(const Growth& growth);
  BlockNeed (*need)(const Growth& growth, const Ground& window, uint8_t bands, uint16_t kept);
  uint64_t (*begin)(const Growth& growth, const Setup& setup, uint16_t kept, bool again, Run& run);
};
inline constexpr BlockWork block_work = {block_shape, block_need, begin_blocks};
// Sixteen bits cannot address what it takes.
inline constexpr const BlockWork* in_blocks = sizeof(size_t) > 2 ? &block_work : nullptr;

// Where in the memory it stands.
inline Blocks* blocks_in(uint8_t* memory, const Parts& parts) {
  uint8_t* const at = memory + parts.planes + parts.scratch + parts.table + parts.bands;
  const uintptr_t rest = reinterpret_cast<uintptr_t>(at) % alignof(Blocks);
  return reinterpret_cast<Blocks*>(at + (rest == 0 ? 0 : alignof(Blocks) - rest));
}

}  // namespace dapple::evolve
