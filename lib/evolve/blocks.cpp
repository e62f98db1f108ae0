// The work on blocks: gather the bits a block reads, solve it, keep its bits; at last shade the window. See blocks.hpp.
// SPDX-License-Identifier: MIT
#include "blocks.hpp"
#include "field.hpp"

namespace dapple::evolve {

// --- the solvers ---------------------------------------------------------------------------------------------------

void prepare_given(const Context& context) { base::copy_bytes(context.table, &context.stored, sizeof context.stored); }

// Schedules stand where they end.
static void end_values(const Context& context, Sweep& sweep) { context.model->values(context.number, {1, 1}, sweep.p); }

bool given_next(const Context& context, Cursor& cursor, Sweep& sweep) {
  const bool first = cursor.sweep == 0;
  const bool some = passes_next(context, cursor, sweep, threshold::given_row, grid::kOneVariance);
  if (first) end_values(context, sweep);
  return some;
}

bool shading_next(const Context& context, Cursor& cursor, Sweep& sweep) {
  const bool first = cursor.sweep == 0;
  const uint32_t step = context.clock.step;
  const bool some = passes_next(context, cursor, sweep, threshold::add_row, kShadeLength[step]);
  if (first) {
    end_values(context, sweep);
    sweep.p[3] = static_cast<int32_t>(base::divide_round(static_cast<int64_t>(sweep.p[4]) * kShadeAmount[step], threshold::kUnit));
  }
  return some;
}

void blank_row(const start::Place& place, const Start&, const grid::Levels&, uint8_t, uint16_t, void* row) {
  int16_t* const cells = static_cast<int16_t*>(row);
  for (uint16_t x = 0; x < place.width; ++x) cells[x] = 0;
}

// --- records -------------------------------------------------------------------------------------------------------

// A record stands for every across-th chunk along x and every down-th along y: a window needs no two of them.
static Decided& record_of(const Blocks& b, int32_t x, int32_t y) {
  const uint32_t column = static_cast<uint32_t>(x - grid::round_down(x, b.across));
  const uint32_t row = static_cast<uint32_t>(y - grid::round_down(y, b.down));
  return *reinterpret_cast<Decided*>(b.records + (static_cast<size_t>(row) * b.across + column) * b.record_bytes);
}

static uint8_t* bits_of(const Blocks& b, int32_t x, int32_t y, uint8_t layer) {
  return reinterpret_cast<uint8_t*>(&record_of(b, x, y)) + layer_offset(b.plan.grid, layer);
}

// Makes the records of the chunks of the cover their own.
static void claim(const Blocks& b) {
  for (int32_t y = b.cover.y[0].first; y <= b.cover.y[0].last; ++y)
    for (int32_t x = b.cover.x[0].first; x <= b.cover.x[0].last; ++x) {
      Decided& record = record_of(b, x, y);
      if (record.x != x || record.y != y) record = {x, y, 0};
    }
}

static bool is_decided(const Blocks& b) { return (record_of(b, b.x, b.y).layers >> b.layer & 1) != 0; }

// --- bits ----------------------------------------------------------------------------------------------------------

// Eight cells from `at` on.
static uint8_t eight(const uint8_t* bits, uint32_t at) {
  const uint8_t shift = static_cast<uint8_t>(at & 7);
  const uint8_t low = static_cast<uint8_t>(bits[at >> 3] >> shift);
  return shift == 0 ? low : static_cast<uint8_t>(low | bits[(at >> 3) + 1] << (8 - shift));
}

static void copy_bits(uint8_t* to, uint32_t to_x, const uint8_t* from, uint32_t from_x, uint32_t count) {
  for (uint32_t i = 0; i < count;) {
    if ((to_x + i) % 8 == 0 && count - i >= 8) {
      to[(to_x + i) / 8] = eight(from, from_x + i);
      i += 8;
    } else {
      grid::put_bit(to, static_cast<int32_t>(to_x + i), grid::get_bit(from, static_cast<int32_t>(from_x + i)));
      ++i;
    }
  }
}

// Row y of the bits given to the run at work: of every cell that of the highest layer below b.layer.
static void gather_row(Blocks& b, const Run& run, uint16_t y) {
  const BlockGrid& g = b.plan.grid;
  const Box wanted = box_of(run.ground);
  uint8_t* const to = b.bits + static_cast<size_t>(y) * b.given.row_bytes;
  const int32_t world = wanted.y.from + y;
  for (uint8_t layer = 0; layer < b.layer; ++layer) {
    const Range rows = meeting(g, layer, true, {world, world + 1}), columns = meeting(g, layer, false, wanted.x);
    if (count_of(rows) == 0) continue;
    for (int32_t x = columns.first; x <= columns.last; ++x) {
      const Box box = covered(g, layer, x, rows.first);
      const int32_t from = base::max(box.x.from, wanted.x.from), end = base::min(box.x.to, wanted.x.to);
      const uint8_t* const bits = bits_of(b, x, rows.first, layer) +
                                  static_cast<size_t>(world - box.y.from) * bytes_of_bits(length_of(box.x));
      copy_bits(to, static_cast<uint32_t>(from - wanted.x.from), bits, static_cast<uint32_t>(from - box.x.from),
                static_cast<uint32_t>(end - from));
    }
  }
}

// Row y of what the block covers, as bits into its record.
static void keep_row(const Blocks& b, const Run& run, uint16_t y) {
  int16_t* const field = reinterpret_cast<int16_t*>(run.field.scratch);
  const uint16_t width = run.domain.width;
  field_row(run, y, field, run.field.scratch + grid::row_bytes(grid::Cell::int16, width));
  const int16_t level = run.model.cell_level(run.stage.number);
  uint8_t* const bits = bits_of(b, b.x, b.y, b.layer) + static_cast<size_t>(y) * bytes_of_bits(width);
  for (uint16_t x = 0; x < width; ++x) grid::put_bit(bits, x, field[x] > level);
}

// --- blocks --------------------------------------------------------------------------------------------------------

static void open_run(Blocks& b, Run& run, const Plan& plan, const Domain& domain, const Ground& ground) {
  Setup setup = b.setup;
  setup.plan = plan;
  setup.domain = domain;
  setup.ground = ground;
  const uint64_t rows = run.rows;
  begin(run, setup);
  run.rows = rows;
  b.at_row = 0;
}

static void give(Blocks& b, const Domain& live, const Ground& ground) {
  const uint16_t left = static_cast<uint16_t>(live.x - ground.x), top = static_cast<uint16_t>(live.y - ground.y);
  b.given = {b.bits, bytes_of_bits(ground.width), left, static_cast<uint16_t>(left + live.width), top,
             static_cast<uint16_t>(top + live.height)};
}

static void open_block(Blocks& b, Run& run) {
  const Box box = covered(b.plan.grid, b.layer, b.x, b.y);
  const Domain domain = window(box.x.from, box.y.from, length_of(box.x), length_of(box.y));
  const Ground ground = ground_of(grown(b.plan.grid, b.layer, b.x, b.y));
  b.doing = b.layer == 0 ? Doing::solving : Doing::gathering;
  give(b, domain, ground);
  if (b.layer == 0) open_run(b, run, {&b.plan.start, b.plan.chunk, b.plan.stages, false}, domain, ground);
  else open_run(b, run, {&b.plan.blank, b.plan.again, 2, false}, domain, ground);
}

static void open_window(Blocks& b, Run& run) {
  give(b, b.setup.domain, b.setup.ground);
  b.doing = Doing::gathering;
  open_run(b, run, {&b.plan.blank, &b.plan.shade, 1, false}, b.setup.domain, b.setup.ground);
}

// Moves on to the next block of the cover, from the lowest layer up; behind the last one b.layer is kLayers.
static void next_place(Blocks& b) {
  if (++b.x <= b.cover.x[b.layer].last) return;
  b.x = b.cover.x[b.layer].first;
  if (++b.y <= b.cover.y[b.layer].last) return;
  while (++b.layer < kLayers && count_of(b.cover, b.layer) == 0) {
  }
  if (b.layer == kLayers) return;
  b.x = b.cover.x[b.layer].first;
  b.y = b.cover.y[b.layer].first;
}

static void open_next(Blocks& b, Run& run) {
  while (b.layer < kLayers && is_decided(b)) next_place(b);
  if (b.layer < kLayers) open_block(b, run);
  else open_window(b, run);
}

// Up to `rows` rows of what the block at work is about; moves on when it is through.
static uint32_t work(Blocks& b, Run& run, uint32_t rows) {
  const uint64_t before = run.rows;
  switch (b.doing) {
    case Doing::gathering:
      gather_row(b, run, b.at_row++);
      ++run.rows;
      if (b.at_row == run.ground.height) b.doing = b.layer < kLayers ? Doing::solving : Doing::shading;
      break;
    case Doing::solving:
      if (advance(run, rows)) break;
      b.doing = Doing::keeping;
      b.at_row = 0;
      break;
    case Doing::keeping:
      keep_row(b, run, b.at_row++);
      ++run.rows;
      if (b.at_row < run.domain.height) break;
      record_of(b, b.x, b.y).layers = static_cast<uint8_t>(record_of(b, b.x, b.y).layers | 1u << b.layer);
      open_next(b, run);
      break;
    case Doing::shading: break;
  }
  return static_cast<uint32_t>(run.rows - before);
}

static bool advance_blocks(Blocks& b, Run& run, uint32_t rows) {
  while (b.doing != Doing::shading) {
    if (rows == 0) return true;
    rows -= work(b, run, rows);
  }
  return advance(run, rows);
}

uint64_t begin_blocks(const Growth& growth, const Setup& setup, uint16_t kept, bool again, Run& run) {
  Blocks& b = *blocks_in(setup.memory, setup.parts);
  b.advance = advance_blocks;
  b.plan = block_plan(growth);
  b.setup = setup;
  b.plan.again[0].stored = b.plan.again[1].stored = b.plan.shade.stored = &b.given;
  b.cover = cover_of(b.plan.grid, box_of(setup.ground));
  b.across = static_cast<uint16_t>(most_chunks(b.plan.grid, static_cast<uint32_t>(setup.ground.width) + kept));
  b.down = static_cast<uint16_t>(most_chunks(b.plan.grid, static_cast<uint32_t>(setup.ground.height) + kept));
  b.record_bytes = layer_offset(b.plan.grid, kLayers);
  const size_t records = static_cast<size_t>(b.across) * b.down;
  b.records = reinterpret_cast<uint8_t*>(&b + 1);
  b.bits = b.records + records * b.record_bytes;
  for (size_t i = 0; !again && i < records; ++i) *reinterpret_cast<Decided*>(b.records + i * b.record_bytes) = {0, 0, 0};
  claim(b);
  uint64_t rows = shade_rows(b.plan, setup.ground.height);
  for (uint8_t layer = 0; layer < kLayers; ++layer) {
    const uint64_t each = block_rows(b.plan, layer);
    b.layer = layer;
    for (b.y = b.cover.y[layer].first; b.y <= b.cover.y[layer].last; ++b.y)
      for (b.x = b.cover.x[layer].first; b.x <= b.cover.x[layer].last; ++b.x)
        if (!is_decided(b)) rows += each;
  }
  run.rows = 0;
  b.layer = 0;
  b.x = b.cover.x[0].first;
  b.y = b.cover.y[0].first;
  open_next(b, run);
  return rows;
}

}  // namespace dapple::evolve
