// What growing and painting cost, between calls of `mark`: steps of textures of several families, then their rows as
// pixels. Counted from outside by tools/footprint/. A case says "name updates pixels hash": how many cell updates and
// pixels were counted, and FNV-1a 32 over the pixels. It has five marks: around steps, around rows of l1, of rgb565.
// POOL: bytes for textures; a case that needs more is left out.
// SPDX-License-Identifier: MIT
#include "marks.hpp"

using dapple::Domain;
using dapple::Fixed;
using dapple::Pixels;
using dapple::Preset;
using dapple::Texture;
namespace presets = dapple::presets;

namespace {

constexpr uint16_t kSteps = 2;  // counted ones, of a recipe's eight or more
constexpr uint16_t kWidest = 64;

template <const Preset& preset, uint8_t count> constexpr auto masks DAPPLE_ROM = dapple::stored_masks<count>(preset);
template <const Preset& preset, uint8_t count>
constexpr Fixed stored DAPPLE_ROM = dapple::fixed(preset, masks<preset, count>, dapple::torus(64, 64), true);
template <const Preset& preset, uint16_t side>
constexpr Fixed kept DAPPLE_ROM = dapple::fixed(preset, dapple::torus(side, side), true);

constexpr Preset gray_scott DAPPLE_ROM = dapple::recipe::preset(
    "gray-scott feed=0.0367 kill=0.0649 steps=8 pitch=20 radius=4 ramp=lichen range=0,0.37");

alignas(4) uint8_t memory[POOL];

// Whole rows of work to the end of the next time step.
uint16_t rows_of_a_step(Texture& texture) {
  const uint32_t steps = texture.steps_done();
  uint16_t rows = 0;
  for (; texture.steps_done() == steps; ++rows) texture.step(1);
  return rows;
}

// Both formats, counted; then the hash of what they gave.
uint32_t paint(Texture& texture, uint16_t side) {
  uint8_t line[2 * kWidest];
  mark();
  for (uint16_t y = 0; y < side; ++y) texture.paint(y, Pixels::l1_msb, line);
  mark();
  for (uint16_t y = 0; y < side; ++y) texture.paint(y, Pixels::rgb565_swapped, line);
  mark();
  uint32_t hash = kFirst;
  for (uint16_t y = 0; y < side; ++y) {
    texture.paint(y, Pixels::rgb565_swapped, line);
    for (uint16_t i = 0; i < 2 * side; ++i) add(hash, line[i]);
    texture.paint(y, Pixels::l1_msb, line);
    for (uint16_t i = 0; i < side / 8; ++i) add(hash, line[i]);
  }
  return hash;
}

// The first step ends the start; the second says how many rows one has; then those that count.
DAPPLE_APART void measure(const char* name, const Fixed& fixed, uint16_t side, uint8_t level) {
  Texture texture;
  if (texture.begin(fixed, 7, memory, sizeof memory) != dapple::ok) return print("refused\n");
  rows_of_a_step(texture);
  const uint16_t rows = rows_of_a_step(texture);
  mark();
  texture.step(static_cast<uint32_t>(kSteps) * rows);
  mark();
  if (texture.steps_done() != 2 + kSteps) return print("not whole steps\n");
  texture.finish();
  const uint32_t hash = paint(texture, side);
  const uint32_t pixels = static_cast<uint32_t>(side) * side;
  say(name, (pixels >> (2 * level)) * kSteps, pixels, hash);
}

template <const Fixed& fixed, uint16_t side> void run(const char* name) {
  constexpr dapple::Need need = fixed.need;
  static_assert(need.status == dapple::ok, "a domain is refused");
  constexpr uint8_t level = fixed.recipe.stage[0].level;
  if constexpr (need.bytes <= POOL) measure(name, fixed, side, level);
}

}  // namespace

int main() {
  run<stored<presets::zebra_bits, 1>, 64>("zebra-bits");
  run<stored<presets::weave_bits, 2>, 64>("weave-bits");
  run<kept<presets::weave_bits, 64>, 64>("weave-bits/sliced");
  run<kept<presets::zebra, 40>, 40>("zebra");
  run<kept<gray_scott, 40>, 40>("gray-scott");
  return 0;
}
