// dapple grows seamless organic textures from a recipe and a 32-bit seed, in integers only: the same bytes on every
// machine. This header is the reference; README.md is the manual; docs/numbers.md is the numeric contract.
//
//   alignas(4) static uint8_t memory[dapple::bytes_for(dapple::presets::zebra, dapple::torus(64, 64))];
//   dapple::Texture tile;
//   if (tile.begin(dapple::presets::zebra, dapple::torus(64, 64), 7, memory, sizeof memory) != dapple::ok) fault();
//   while (tile.step(8) == dapple::more) watchdog();
//   for (uint16_t y = 0; y < 64; ++y) { uint8_t line[128]; tile.paint(y, dapple::Pixels::rgb565_swapped, line); panel(line); }
//
// The domain is a torus, a window of the endless plane, dapple::window(x, y, width, height), or a patch whose sides are closed,
// fixed, or joined to each other, dapple::on_patch(patches, 0): recipes with sides have that; atlas.hpp grows many together.
// Recipes that run too long for a halo have no plane, but for the threshold family, which decides it in blocks.
//
// No heap, no globals, no exceptions, no floating point. The caller owns every byte; any call can stop after any row;
// two textures never share anything, so they may run on two threads.
// SPDX-License-Identifier: MIT
#pragma once
#include "evolve/work.hpp"
#include "needs.hpp"
#include "paint/mip.hpp"

namespace dapple {

// major * 10000 + minor * 100 + patch. The bytes of a preset change only with the major version (before 1.0: with a line
// under "Output" in CHANGES.md).
constexpr int32_t kVersion = 100;

// How a texture is grown; none of it changes a byte of the result.
struct Options {
  uint8_t bands = 1;                            // 1..64 bands of rows that could run at once; each has its own scratch
  const grid::KernelSwap* kernels = nullptr;    // faster row kernels with the same bytes; null: the portable ones
  evolve::Driver* driver = nullptr;             // does whole steps, for one texture at a time (threads: ports/desktop); null: row by row
  // Windows in blocks: cells beside the window, along either direction, for which there is room to keep what is decided; and
  // whether the memory is as a texture begun with the same arguments, but for the place, has left it: then that is not decided
  // again.
  uint16_t kept = 0;
  bool again = false;
};

// A preset on a domain, with every check and sum done by the compiler: what firmware puts in read-only memory and hands to
// begin. Status and bytes are in `need`.
//   constexpr auto masks DAPPLE_ROM = dapple::stored_masks<1>(dapple::presets::zebra_bits);
//   constexpr dapple::Fixed tile DAPPLE_ROM = dapple::fixed(dapple::presets::zebra_bits, masks, dapple::torus(64, 64), true);
//   alignas(4) static uint8_t memory[tile.need.bytes];
struct Fixed {
  Recipe recipe;
  Domain domain;
  Need need;
  evolve::Parts parts;
  grid::Ground ground;
  bool frugal;
};

// frugal: the memory of the sweeps is used again for painting. Then rows and pixels are there once the texture is done, and
// colours have no light and normal maps no slope. Windows in blocks are not for a Fixed.
constexpr Fixed fixed(const Recipe& recipe, const Domain& domain, bool frugal = false) {
  Fixed f{recipe, domain, Need{}, evolve::Parts{}, grid::Ground{}, frugal};
  f.recipe.blocks = nullptr;
  f.need = api::need_of(f.recipe, domain, 1, 0, f.parts);
  if (f.need.status == ok && domain.patches != nullptr) f.need.status = bad_sides;
  if (f.need.status != ok) return f;
  f.ground = api::ground_of(domain, f.need);
  if (!frugal) return f;
  f.need.paint -= 2 * grid::scratch_bytes(grid::Cell::int16, api::with_edge(domain).width, 1);
  f.need.bytes = f.need.planes + (f.need.scratch > f.need.paint ? f.need.scratch : f.need.paint) + f.need.rest;
  return f;
}
constexpr Fixed fixed(const Preset& preset, const Domain& domain, bool frugal = false) { return fixed(preset.recipe, domain, frugal); }

// The masks of a preset of the family bits, n of them; for one on the same numbers.
template <uint8_t n> constexpr stencil::StoredMasks<n> stored_masks(const Preset& preset) {
  return evolve::stored_masks<n>(preset.recipe.stage[0].number);
}
template <uint8_t n>
constexpr Fixed fixed(const Preset& preset, const stencil::StoredMasks<n>& masks, const Domain& domain, bool frugal = false) {
  Recipe recipe = preset.recipe;
  recipe.stage[0].solver = &evolve::stored;
  recipe.stage[0].stored = &masks;
  if (masks.set.count != n) recipe.stages = 0;
  return fixed(recipe, domain, frugal);
}

// One texture on its way. The struct and the memory are the whole state: copyable together, no destructor needed.
class Texture {
 public:
  // Checks everything, then readies the texture; grows nothing yet. Not on AVR, whose models lie in flash: begin with a Fixed. The recipe and the memory must outlive it. On an error
  // the object is as it was; `need`, if given, says what was wanted.
  Status begin(const Preset& preset, const Domain& domain, uint32_t seed, void* memory, size_t bytes,
               const Options& options = Options{}, Need* need = nullptr);
  Status begin(const Recipe& recipe, const Domain& domain, uint32_t seed, void* memory, size_t bytes,
               const Options& options = Options{}, Need* need = nullptr);
  Status begin(Recipe&& recipe, const Domain& domain, uint32_t seed, void* memory, size_t bytes,
               const Options& options = Options{}, Need* need = nullptr) = delete;  // would dangle
  // What the compiler has checked; a DAPPLE_ROM constant. Only the memory is looked at.
  Status begin(const Fixed& fixed, uint32_t seed, void* memory, size_t bytes);

  // Up to `rows` rows of work: more, or done. Whatever the slicing, the same bytes.
  Status step(uint32_t rows);

  // Everything that is left.
  void finish() { while (step(UINT32_MAX) == more) {} }

  // Disturbs a texture that is between two whole steps (a caller stops there by its count of rows, or finish) or done:
  // not_now elsewhere, and of corner tiles, patches, windows in blocks, one-bit cells and frugal textures. The same calls
  // after the same steps give the same bits, however the steps were sliced.
  //   stamp    a disc of pixels, radius at most 4096, becomes what discs of seeds are, or (on false) the uniform state
  //   change   number `slot` of the recipe's stage, 1/kMicro or a word's index, until the stage ends; explicit kinetics only.
  //            out_of_range, unstable: it cannot be that, and stays; not_now: a number that the stage's first step has laid
  //            into planes (vary, map, detail, grade, finest, a map's angle, a picture's growth, dark and lit), or a map
  //            or grade for a stage that began without either
  //   go_on    as many steps more of the last stage, once the texture is done; not of windows of the plane. Schedules then
  //            run over all the steps
  Status stamp(int32_t x, int32_t y, uint16_t radius, bool on);
  Status change(uint8_t slot, int32_t value);
  Status go_on(uint32_t steps);
  bool between_steps() const { return blocks_ == nullptr && !frugal_ && evolve::between_steps(run_); }

  // Progress: rows of work done and in all; steps done in all stages.
  uint64_t rows_done() const { return run_.rows; }
  uint64_t rows_in_all() const { return rows_in_all_; }
  uint32_t steps_done() const { return run_.clock.step; }

  // Row y of the field as it stands now: domain.width values; 1.0 of the recipe's range is unit().
  void row(uint16_t y, int16_t* out);
  int16_t unit() const { return run_.model.unit; }
  // A cell is on where the field is above this.
  int16_t cell_level() const { return run_.model.cell_level(run_.stage.number); }

  // Row y as pixels, as it stands now: pixel_bytes(format, width) bytes.
  void paint(uint16_t y, Pixels format, void* out);
  void paint(uint16_t y, const Brush& brush, void* out);
  // Row y as several pictures, the maps of a material say, all from one field whose rows are made once.
  void paint(uint16_t y, const Layer* layers, uint8_t count);
  // Instead of the recipe's paint; null: the recipe's again. It must outlive its use.
  void repaint(const Paint* paint) { paint_ = paint; }

  const Domain& domain() const { return domain_; }
  // Whether the field is there, or, in blocks, still to be decided: till then it is flat.
  bool decided() const { return blocks_ == nullptr || blocks_->doing == evolve::Doing::shading; }

 private:
  friend class Atlas;
  Status start(const Recipe& checked, const Recipe* stored, bool rom, const Domain& domain, uint32_t seed, void* memory,
               size_t bytes, const Options& options, Need* need);
  void begin_patch(const Recipe& recipe, const Domain& domain, uint32_t seed, uint8_t* memory, const Options& options, const evolve::Ghosts& ghosts);
  void lay_out(const evolve::Setup& setup, const Recipe* recipe, const Domain& domain);
  void look_again();
  bool look_at(uint16_t y, paint::Source& source);
  void colour(const Brush& brush, const paint::Source& source, uint8_t* out);
  int16_t* field_row(int32_t y, int32_t centre);

  evolve::Run run_;
  Domain domain_;
  const Recipe* recipe_;
  const Paint* paint_;
  uint8_t* field_;          // three rows with a halo of one
  uint8_t* work_;
  uint64_t rows_in_all_;
  evolve::Blocks* blocks_;  // null: not in blocks
  int32_t held_rows_[3];    // which row a slot holds, as of rows_seen_
  uint64_t rows_seen_;
  bool rom_;
  bool frugal_;
};

}  // namespace dapple
