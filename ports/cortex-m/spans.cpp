// What row kernels take: calls mark() before and after each of them, for a tool that counts the instructions from one
// call of mark() to the next. Three spans each: the portable kernel, the fast one of SELFTEST_KERNELS, and what lies
// between. Every kernel on a row of 128 cells (passes with the roundings 1 and 2 and with another weight), then tiles
// of 64x64.
// SPDX-License-Identifier: MIT
#include "dapple.hpp"
#include "kernels.hpp"
#include "stencil/laplacian.hpp"

using namespace dapple;

extern "C" __attribute__((noinline)) void mark() { __asm volatile(""); }

namespace {

constexpr Preset mitosis = recipe::preset("gray-scott feed=0.0367 kill=0.0649 steps=40");
constexpr uint16_t kCells = 128, kBefore = 32;
alignas(4) uint8_t memory[200000];
int16_t in[3][kBefore + kCells + kBefore], out[2][kBefore + kCells + kBefore];

void both(grid::RowKernel portable, const int32_t* p) {
  grid::Rows rows{};
  for (uint8_t k = 0; k < 3; ++k) rows.in[k] = in[k] + kBefore;
  for (uint8_t k = 0; k < 2; ++k) rows.out[k] = out[k] + kBefore;
  rows.p = p;
  rows.scratch = memory;
  rows.n = kCells;
  rows.planes = 2;
  const grid::RowKernel fast = grid::choose(SELFTEST_KERNELS, portable);
  mark();
  portable(rows);
  mark();
  fast(rows);
  mark();
}

bool grow(const Preset& preset, const grid::KernelSwap* kernels) {
  Texture texture;
  mark();
  const Status status = texture.begin(preset, torus(64, 64), 7, memory, sizeof memory, Options{1, kernels});
  if (status == ok) texture.finish();
  return status == ok;
}

bool grow_both(const Preset& preset) {
  const bool good = grow(preset, nullptr) && grow(preset, SELFTEST_KERNELS);
  mark();
  return good;
}

}  // namespace

extern "C" int main() {
  const int32_t first[] = {3, stencil::kQuarter, 1}, second[] = {3, stencil::kQuarter, 2};
  const int32_t lighter[] = {3, 5000, base::rounding_for(5000)};
  const int32_t along[] = {4 * grid::kOneVariance, stencil::reach_of(4 * grid::kOneVariance), stencil::kWideShare};
  const int32_t one_pair[] = {1, threshold::max_difference, 0, threshold::kImpulse};
  const int32_t diffusion[] = {5242, base::rounding_for(5242)};
  int32_t number[gray_scott::slots], rates[4];
  for (uint8_t i = 0; i < gray_scott::slots; ++i) number[i] = mitosis.recipe.stage[0].number[i];
  gray_scott::values(number, Clock{}, rates);
  both(stencil::pass_row, first);
  both(stencil::pass_row, second);
  both(stencil::pass_row, lighter);
  both(stencil::chain_row, along);
  both(threshold::impulse_row, one_pair);
  both(stencil::five_row, diffusion);
  both(gray_scott::react_row, rates);
  return grow_both(presets::zebra) && grow_both(presets::coral) && grow_both(mitosis) ? 0 : 1;
}
