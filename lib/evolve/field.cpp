// The field as it stands. A field whose grid is coarser than the picture for good (masks on one-bit cells) is enlarged
// bilinearly, twofold at a time; one that is still on its way to the finest grid is shown cell by cell.
// SPDX-License-Identifier: MIT
#include "field.hpp"
#include "enlarge.hpp"

namespace dapple::evolve {

constexpr uint32_t kNoRow = UINT32_MAX;

// The parts of the work memory.
struct Work {
  uint8_t* window;       // rows with halo that the kernel reads, on a torus
  size_t window_row;
  uint8_t* space;        // of the kernel
  uint32_t* held;        // the numbers of the coarse rows
  int16_t* coarse;       // their cells, halo included
  size_t coarse_row;     // int16
  int16_t* middle;       // two rows between fourfold and twofold
  size_t middle_row;
  uint8_t radius;
};

static Work work_of(const Run& run, uint8_t* work) {
  Work w{};
  w.radius = run.field_radius;
  w.window_row = grid::scratch_bytes(run.field.cell, run.field.width, w.radius);
  w.window = work;
  w.space = work + window_bytes(run.field.cell, run.field.width, w.radius);
  w.held = reinterpret_cast<uint32_t*>(w.space + grid::align4(run.field_space));
  w.coarse = reinterpret_cast<int16_t*>(w.held + kCoarseRows);
  w.coarse_row = grid::scratch_bytes(grid::Cell::int16, run.field.width, 2) / 2;
  w.middle = w.coarse + kCoarseRows * w.coarse_row;
  w.middle_row = grid::row_bytes(grid::Cell::int16, static_cast<uint16_t>(run.domain.width / 2 + 4)) / 2;
  return w;
}

// On a torus that is not enlarged rows of the field are made where they are wanted.
static bool made_in_place(const Run& run) { return run.stage.level == 0 && !run.domain.plane; }

void forget_rows(const Run& run, int16_t* row, uint8_t* work) {
  if (run.solver.look != nullptr) run.solver.look(run, row, work);
  if (run.field_radius == 0 || made_in_place(run)) return;
  const Work w = work_of(run, work);
  for (uint8_t i = 0; i < kCoarseRows; ++i) w.held[i] = kNoRow;
}

static grid::Rows rows_of(const Run& run, int32_t* values) {
  run.model.values(run.stage.number, run.clock, values);
  grid::Rows rows;
  rows.p = values;
  rows.table = run.table;
  rows.part = nullptr;
  rows.planes = run.model.planes(run.stage.number);
  rows.x = rows.y = rows.run = 0;
  return rows;
}

// Where the domain's cell (0, 0) is in the grid of `level`, in cells of the finest grid.
static uint16_t offset_x(const Run& run) { return static_cast<uint16_t>(run.domain.plane ? run.domain.x - run.ground.x : 0); }
static uint16_t offset_y(const Run& run) { return static_cast<uint16_t>(run.domain.plane ? run.domain.y - run.ground.y : 0); }

// Without neighbours: cell by cell. While a stage refines, from the bottom up, the rows above still stand on the coarser grid.
DAPPLE_APART static void plain_row(const Run& run, uint16_t y, int16_t* out, uint8_t* work) {
  const uint16_t world = static_cast<uint16_t>(y + offset_y(run)), shift = offset_x(run);
  uint8_t level = run.stage.level;
  if (run.phase == Phase::refining && at_level(world, level) < 2 * static_cast<int32_t>(run.at_row)) ++level;
  int32_t values[kMaxValues] = {};
  grid::Rows rows = rows_of(run, values);
  const uint16_t first = at_level(shift, level);
  const uint16_t last = at_level(static_cast<uint16_t>(shift + run.domain.width - 1), level);
  rows.scratch = work;
  rows.x = first;
  rows.n = static_cast<uint16_t>(last - first + 1);
  const size_t bytes = grid::row_bytes(run.field.cell, at_level(run.ground.width, level));
  for (uint8_t i = 0; i < rows.planes + run.kept; ++i)
    rows.in[i] = run.field.planes + i * run.field.plane_bytes + at_level(world, level) * bytes;
  rows.out[0] = out;
  rows.run = run.step > 0 || run.stage.entry == Entry::carry;  // kept planes are filled by a stage's first step
  grid::choose(run.kernels, run.solver.field != nullptr ? run.solver.field : run.model.field)(rows);
  if (level == 0) return;
  for (uint16_t x = run.domain.width; x > 0; --x)
    out[x - 1] = out[at_level(static_cast<uint16_t>(shift + x - 1), level) - first];
}

// The field of the grid's row y: `count` cells from x on, which on the plane is a multiple of 32 and on a torus 0.
DAPPLE_APART static void make_row(const Run& run, const Work& w, int32_t y, uint16_t x, uint16_t count, int16_t* out) {
  int32_t values[kMaxValues] = {};
  grid::Rows rows = rows_of(run, values);
  const uint16_t height = run.field.height;
  rows.scratch = w.space;
  rows.x = x;
  rows.n = count;
  rows.y = static_cast<uint16_t>(y);
  for (int32_t k = -w.radius; k <= w.radius; ++k) {
    const int32_t at = run.domain.plane ? y + k : (y + k % height + height) % height;
    const uint8_t* row = row_of(run.field, 0, static_cast<uint16_t>(at)) + grid::cell_bytes(run.field.cell, x);
    if (!run.domain.plane) {
      uint8_t* copy = w.window + static_cast<size_t>(k + w.radius) * w.window_row + grid::halo_bytes(run.field.cell, w.radius);
      grid::copy_row(run.field.cell, copy, row, run.field.width, w.radius);
      row = copy;
    }
    rows.in[k + w.radius] = row;
  }
  rows.out[0] = out;
  grid::choose(run.kernels, run.solver.field)(rows);
}

// The same with two cells before and behind. Returns the place of cell `first`.
static int16_t* make_coarse(const Run& run, const Work& w, int32_t y, uint16_t first, uint16_t count, int16_t* out) {
  if (run.domain.plane) {
    const uint16_t x = static_cast<uint16_t>((first - 2) & ~31);
    make_row(run, w, y, x, static_cast<uint16_t>(first + count + 2 - x), out);
    return out + (first - x);
  }
  make_row(run, w, y, 0, run.field.width, out + 2);
  grid::wrap_row(grid::Cell::int16, out + 2, run.field.width, 2);
  return out + 2;
}

// The slot for a row that is not there: a free one, or that of the row furthest from y, but never `kept`'s.
DAPPLE_APART static uint8_t free_slot(const Work& w, int32_t y, int32_t kept) {
  uint8_t best = 0;
  int64_t furthest = -1;
  for (uint8_t i = 0; i < kCoarseRows; ++i) {
    const bool empty = w.held[i] == kNoRow;
    const int64_t off = static_cast<int64_t>(w.held[i]) - y;
    const int64_t distance = empty ? INT64_MAX : w.held[i] == static_cast<uint32_t>(kept) ? -1 : off < 0 ? -off : off;
    if (distance <= furthest) continue;
    furthest = distance;
    best = i;
  }
  return best;
}

// Row y of the coarse field, any y on a torus; made once while it is among the last ones asked for. Row `kept` stays.
DAPPLE_APART static const int16_t* coarse_row(const Run& run, const Work& w, int32_t y, int32_t kept) {
  const uint8_t level = run.stage.level;
  const uint16_t height = run.field.height;
  if (!run.domain.plane) {
    y = (y + height) % height;
    kept = (kept + height) % height;
  }
  const uint16_t first = at_level(offset_x(run), level);
  const uint16_t last = at_level(static_cast<uint16_t>(offset_x(run) + run.domain.width - 1), level);
  uint8_t slot = 0;
  while (slot < kCoarseRows && w.held[slot] != static_cast<uint32_t>(y)) ++slot;
  const bool held = slot < kCoarseRows;
  if (!held) slot = free_slot(w, y, kept);
  int16_t* const out = w.coarse + slot * w.coarse_row;
  if (held) return run.domain.plane ? out + (first - ((first - 2) & ~31)) : out + 2;
  w.held[slot] = static_cast<uint32_t>(y);
  return make_coarse(run, w, y, first, static_cast<uint16_t>(last - first + 1), out);
}

// Both rows mixed, cells x - 1 to x + n; values within +-8000, so that every sum fits int16.
static void mix(const int16_t* DAPPLE_RESTRICT near, const int16_t* DAPPLE_RESTRICT other, int16_t* DAPPLE_RESTRICT mixed, uint16_t n) {
  for (uint16_t i = 0; i < n; ++i) mixed[i] = static_cast<int16_t>(static_cast<int16_t>(3 * near[i] + other[i] + 2) >> 2);
}
static void widen(const int16_t* DAPPLE_RESTRICT mixed, int16_t* DAPPLE_RESTRICT out, uint16_t n) {
  for (uint16_t i = 0; i < n; ++i) {
    const int16_t here = static_cast<int16_t>(3 * mixed[i + 1] + 2);
    out[2 * i] = static_cast<int16_t>(static_cast<int16_t>(here + mixed[i]) >> 2);
    out[2 * i + 1] = static_cast<int16_t>(static_cast<int16_t>(here + mixed[i + 2]) >> 2);
  }
}

// `enlarged` by whole cells, in short loops without a branch; an odd one at either end by itself.
DAPPLE_APART static void enlarge(const int16_t* near, const int16_t* other, int16_t* out, uint8_t odd, uint16_t count) {
  constexpr uint16_t kBlock = 32;
  if (odd) {
    enlarged(near++, other++, 1, 1, [&](uint16_t, int16_t value) { *out++ = value; });
    --count;
  }
  int16_t mixed[kBlock + 2];
  for (uint16_t n; count > 1; count = static_cast<uint16_t>(count - 2 * n), near += n, other += n, out += 2 * n) {
    n = count / 2 < kBlock ? static_cast<uint16_t>(count / 2) : kBlock;
    mix(near - 1, other - 1, mixed, static_cast<uint16_t>(n + 2));
    widen(mixed, out, n);
  }
  if (count == 0) return;
  mix(near - 1, other - 1, mixed, 2);
  *out = static_cast<int16_t>(static_cast<int16_t>(3 * mixed[1] + 2 + mixed[0]) >> 2);
}

// Two middle rows of a fourfold enlargement: the one row `y` (finest grid) lies in, and the one beside it.
DAPPLE_APART static void fourfold(const Run& run, const Work& w, uint16_t y, int16_t* out) {
  const uint16_t shift = offset_x(run);
  const uint16_t first = static_cast<uint16_t>(shift >> 1), last = static_cast<uint16_t>((shift + run.domain.width - 1) >> 1);
  const int32_t rows[2] = {y >> 1, (y >> 1) + beside(y)};
  const int32_t height = run.field.height;
  for (uint8_t i = 0; i < 2; ++i) {
    const int32_t middle = run.domain.plane ? rows[i] : (rows[i] + 2 * height) % (2 * height);
    const int32_t coarse = middle >> 1;
    const int32_t other = coarse + beside(static_cast<uint32_t>(middle));
    // One cell to the left of `first`: the middle row needs a halo of one.
    const int32_t left = first - 1;
    const int32_t skip = (left >> 1) - (shift >> 2);
    const int16_t* const near = coarse_row(run, w, coarse, other);
    enlarge(near + skip, coarse_row(run, w, other, coarse) + skip, w.middle + i * w.middle_row,
            static_cast<uint8_t>(left & 1), static_cast<uint16_t>(last - left + 2));
  }
  enlarge(w.middle + 1, w.middle + w.middle_row + 1, out, static_cast<uint8_t>(shift & 1), run.domain.width);
}

void field_row(const Run& run, uint16_t y, int16_t* out, uint8_t* work) {
  if (run.field_radius == 0) return plain_row(run, y, out, work);
  const Work w = work_of(run, work);
  const uint16_t world = static_cast<uint16_t>(y + offset_y(run));
  const uint8_t level = run.stage.level;
  if (made_in_place(run)) {
    make_row(run, w, world, 0, run.domain.width, out);
  } else if (level == 0) {
    const int16_t* row = coarse_row(run, w, world, world);
    for (uint16_t x = 0; x < run.domain.width; ++x) out[x] = row[x];
  } else if (level == 1) {
    const int32_t coarse = world >> 1, other = coarse + beside(world);
    const int16_t* const near = coarse_row(run, w, coarse, other);
    enlarge(near, coarse_row(run, w, other, coarse), out, static_cast<uint8_t>(offset_x(run) & 1), run.domain.width);
  } else {
    fourfold(run, w, world, out);
  }
}

}  // namespace dapple::evolve
