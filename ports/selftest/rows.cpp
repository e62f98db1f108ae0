// Row kernels on random rows: what each one reads and writes, and within which bounds, as the headers in lib/ have it.
// SPDX-License-Identifier: MIT
#include "rows.hpp"
#include "base/hash.hpp"
#include "model/gray_scott.hpp"
#include "model/threshold.hpp"
#include "stencil/laplacian.hpp"
#include "stencil/lattice.hpp"

namespace grid = dapple::grid;
namespace stencil = dapple::stencil;
namespace threshold = dapple::threshold;
namespace gray_scott = dapple::gray_scott;
using dapple::base::rounding_for;

namespace {

constexpr uint16_t kWidest = 130, kOffsets = 8, kHalo = stencil::kLargestStride;
constexpr uint16_t kRowCells = kHalo + kOffsets + kWidest + kHalo + 2;  // a multiple of four bytes
constexpr uint8_t kIn = 3, kOut = 4;

struct Bench {
  int16_t in[kIn][kRowCells], out[kOut][kRowCells], other[kOut][kRowCells];
  uint8_t scratch[2 * grid::scratch_bytes(grid::Cell::int16, kWidest, kHalo)];
};
static_assert(sizeof(Bench) <= kRowsMemory, "more memory is needed");

struct Random {
  uint32_t state;
  int32_t below(uint32_t count) { return static_cast<int32_t>(dapple::base::below(dapple::base::mix(++state), count)); }
  int32_t between(int32_t low, int32_t high) { return low + below(static_cast<uint32_t>(high - low) + 1); }
  int32_t even(int32_t low, int32_t high) { return between(low / 2, high / 2) * 2; }
  int16_t cell(int16_t most) {
    const int32_t kind = below(8);
    return static_cast<int16_t>(kind == 0 ? 0 : kind == 1 ? most : below(most + 1u));
  }
};

void fill(int16_t* row, Random& random, int16_t most) {
  for (uint16_t x = 0; x < kRowCells; ++x) row[x] = random.cell(most);
}

// in[plane]: increments that take the cells of out[plane] to other cells.
void fill_increments(Bench& bench, uint8_t plane, Random& random, int16_t most) {
  for (uint16_t x = 0; x < kRowCells; ++x)
    bench.in[plane][x] = static_cast<int16_t>(random.cell(most) - bench.out[plane][x]);
}

// Each of these fills the rows and the numbers of one kernel, and says how many planes it writes.
uint8_t ready_pass(Bench& bench, Random& random, int32_t* p) {
  for (uint8_t k = 0; k < 3; ++k) fill(bench.in[k], random, threshold::kLargest);
  const bool full = random.below(2) == 0;
  p[0] = random.between(-kHalo, kHalo);
  p[1] = full ? stencil::kQuarter : random.even(stencil::kSmallestWeight, stencil::kQuarter - 2);
  p[2] = full ? random.between(1, 2) : rounding_for(static_cast<int16_t>(p[1]));
  return 1;
}

uint8_t ready_chain(Bench& bench, Random& random, int32_t* p) {
  fill(bench.out[0], random, threshold::kLargest);
  p[0] = random.between(1, 64) * random.between(stencil::kSmallestShare, stencil::kLargestShare / 4096);
  p[2] = random.below(2) == 0 ? stencil::kWideShare : p[0];
  p[1] = stencil::reach_of(p[0], p[2]);
  return 1;
}

uint8_t ready_impulse(Bench& bench, Random& random, int32_t* p) {
  for (uint8_t k = 0; k < 4; ++k) fill(bench.out[k], random, threshold::kLargest);
  p[0] = random.between(1, 2);
  p[1] = random.below(2);
  p[2] = random.between(-threshold::to_unit(threshold::kLargestRho), threshold::to_unit(threshold::kLargestRho));
  p[3] = random.between(0, threshold::kImpulse);
  for (uint16_t x = 0; x < kRowCells; x += 3) {  // differences at the threshold
    const int32_t other = bench.out[0][x] - p[2] - random.below(2);
    if (other >= 0 && other <= threshold::kLargest) bench.out[1][x] = static_cast<int16_t>(other);
  }
  return static_cast<uint8_t>(2 * p[0]);
}

uint8_t ready_five(Bench& bench, Random& random, int32_t* p) {
  for (uint8_t k = 0; k < 3; ++k) fill(bench.in[k], random, gray_scott::kOne);
  p[0] = random.even(stencil::kSmallestWeight, stencil::kQuarter);
  p[1] = rounding_for(static_cast<int16_t>(p[0]));
  return 1;
}

// v stays below .56.
uint8_t ready_gray_scott(Bench& bench, Random& random, int32_t* p) {
  constexpr int16_t kMostV = gray_scott::kUnit * 56 / 100;
  fill(bench.out[0], random, gray_scott::kOne);
  fill(bench.out[1], random, kMostV);
  fill_increments(bench, 0, random, gray_scott::kOne);
  fill_increments(bench, 1, random, kMostV);
  int32_t number[gray_scott::slots] = {};
  number[gray_scott::feed] = random.between(gray_scott::kFeed[0], gray_scott::kFeed[0] + 65535);
  number[gray_scott::kill] = random.between(gray_scott::kKill[0], gray_scott::kKill[1]);
  gray_scott::values(number, dapple::Clock{}, p);
  return 2;
}

struct Known {
  grid::RowKernel portable;
  uint8_t (*ready)(Bench&, Random&, int32_t* p);
};
constexpr Known known[] = {{stencil::pass_row, ready_pass},
                           {stencil::chain_row, ready_chain},
                           {threshold::impulse_row, ready_impulse},
                           {stencil::five_row, ready_five},
                           {gray_scott::react_row, ready_gray_scott}};

void call(grid::RowKernel kernel, Bench& bench, int16_t (*out)[kRowCells], const int32_t* p, uint8_t planes, uint16_t n,
          uint16_t offset) {
  grid::Rows rows{};
  for (uint8_t k = 0; k < kIn; ++k) rows.in[k] = bench.in[k] + kHalo + offset;
  for (uint8_t k = 0; k < kOut; ++k) rows.out[k] = out[k] + kHalo + offset;
  rows.p = p;
  rows.scratch = bench.scratch;
  rows.n = n;
  rows.planes = planes;
  kernel(rows);
}

bool same_row(const grid::KernelSwap& swap, const Known& what, Bench& bench, Random& random, uint16_t n,
              uint16_t offset) {
  int32_t p[8] = {};
  for (uint8_t k = 0; k < kOut; ++k) fill(bench.out[k], random, gray_scott::kOne);
  const uint8_t planes = what.ready(bench, random, p);
  grid::copy_bytes(bench.other, bench.out, sizeof bench.out);
  call(swap.portable, bench, bench.out, p, planes, n, offset);
  call(swap.fast, bench, bench.other, p, planes, n, offset);
  for (uint8_t k = 0; k < kOut; ++k)
    for (uint16_t x = 0; x < kRowCells; ++x)
      if (bench.out[k][x] != bench.other[k][x]) return false;
  return true;
}

const Known* find(grid::RowKernel portable) {
  for (const Known& entry : known)
    if (entry.portable == portable) return &entry;
  return nullptr;
}

}  // namespace

RowsCompared compare_rows(const grid::KernelSwap& swap, void* memory) {
  Bench& bench = *static_cast<Bench*>(memory);
  const Known* what = find(swap.portable);
  if (what == nullptr) return {0, 1};
  Random random{1};
  RowsCompared rows{0, 0};
  for (uint16_t n = 1; n <= kWidest; ++n)
    for (uint16_t offset = 0; offset < kOffsets; ++offset)
      ++(same_row(swap, *what, bench, random, n, offset) ? rows.equal : rows.different);
  return rows;
}
