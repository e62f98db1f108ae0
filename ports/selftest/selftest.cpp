// Grows textures by every solver and prints "name WxH seed hash": FNV-1a 64 over the field's values, as little-endian
// int32, or over painted bytes. Whoever has less memory leaves lines out; no line may differ.
// SPDX-License-Identifier: MIT
#include "selftest.hpp"
#include "say.hpp"

using dapple::Domain;
using dapple::Preset;
using dapple::Texture;
using namespace selftest_say;
namespace presets = dapple::presets;

namespace {

// Presets as they are, and recipes with fewer steps or other numbers. The cell program: on, where an odd number of the
// five is on; it never dies out.
constexpr Preset cell_program DAPPLE_ROM = dapple::recipe::preset("cells rule=0x96696996 steps=24");
constexpr Preset lean_maze DAPPLE_ROM =
    dapple::recipe::preset("bits masks=2 react=da window=6 scale=8 stretch=3 angle=0 steps=4 solver=lean");
constexpr Preset short_mitosis DAPPLE_ROM = dapple::recipe::preset("gray-scott feed=0.0367 kill=0.0649 steps=40");
constexpr Preset finer DAPPLE_ROM = dapple::recipe::preset(
    "threshold pairs=1 react=md scale=2.2 stretch=2 angle=78.5 rho=0 solver=euler levels=2 steps=8");
// Explicit kinetics, one of each; cells that are held, a share of cells, compact cells.
constexpr Preset turing DAPPLE_ROM = dapple::recipe::preset("turing scale=5 vary=0.1 steps=20 then freeze above=4.3 steps=8");
constexpr Preset spots DAPPLE_ROM = dapple::recipe::preset("meinhardt-spots scale=1.6 coverage=0.2 steps=20");
constexpr Preset stripes DAPPLE_ROM = dapple::recipe::preset("meinhardt-stripes spread=0.02 vary=0.05 steps=12");
constexpr Preset walls DAPPLE_ROM = dapple::recipe::preset("fitzhugh-nagumo scale=0.5 stretch=1.5 angle=20 steps=40");
constexpr Preset schnakenberg DAPPLE_ROM = dapple::recipe::preset("schnakenberg steps=20");
constexpr Preset phases DAPPLE_ROM = dapple::recipe::preset("brusselator start=phases pitch=12 scale=0.6 force=0.2 steps=20");
constexpr Preset compact DAPPLE_ROM = dapple::recipe::preset("turing cells=compact scale=5 stretch=1.6 angle=65 steps=28");
constexpr bool good(const Preset& preset) { return preset.recipe.stages > 0; }
static_assert(good(cell_program) && good(lean_maze) && good(short_mitosis) && good(finer), "a recipe is refused");
static_assert(good(turing) && good(spots) && good(stripes) && good(walls) && good(schnakenberg) && good(phases) && good(compact),
              "a recipe of kinetics is refused");

// What firmware does: masks and sizes made by the compiler, kept in read-only memory.
template <const Preset& preset, uint8_t count> constexpr auto masks DAPPLE_ROM = dapple::stored_masks<count>(preset);
template <const Preset& preset, uint8_t count, uint16_t side>
constexpr dapple::Fixed stored DAPPLE_ROM =
    dapple::fixed(preset, masks<preset, count>, dapple::torus(side, side), true);
template <const Preset& preset, uint16_t width, uint16_t height, int32_t x, int32_t y, bool plane>
[[maybe_unused]] constexpr dapple::Fixed kept DAPPLE_ROM = dapple::fixed(preset, Domain{width, height, x, y, plane});

// SELFTEST_FIXED: every texture by begin(Fixed), the only one that reads its recipe from the flash of an AVR.
#ifdef SELFTEST_FIXED
constexpr bool kFixed = true;
#else
constexpr bool kFixed = false;
#endif

constexpr uint16_t kWidest = 128;

struct Host {
  void (*put)(char);
  size_t bytes;
  void* memory;
  dapple::Options options;
};

DAPPLE_APART uint64_t hash_of_pixels(Texture& texture, const Domain& d) {
  uint64_t hash = kFirstHash;
  uint8_t line[2 * kWidest];
  for (uint16_t y = 0; y < d.height; ++y) {
    texture.paint(y, dapple::Pixels::rgb565_swapped, line);
    for (uint16_t x = 0; x < 2 * d.width; ++x) add_byte(hash, line[x]);
  }
  return hash;
}

void finish(const Host& host, Texture& texture, dapple::Status status, const char* name, const Domain& d, uint32_t seed,
            bool pixels) {
  if (status != dapple::ok) {
    print(host.put, name);
    print(host.put, " is refused\n");
    return;
  }
  while (texture.step(16) == dapple::more) {
  }
  bool flat = false;
  int16_t row[kWidest];
  const uint64_t hash = hash_of_field(texture, d.width, d.height, row, flat);
  tell(host.put, {name, flat ? " is flat" : "", d.width, d.height, seed, hash});
  if (pixels) tell(host.put, {name, "/rgb565", d.width, d.height, seed, hash_of_pixels(texture, d)});
}

// source: a Preset or a Fixed
[[maybe_unused]] dapple::Status begun(const Host& host, Texture& texture, const Preset& preset, const Domain& d,
                                      uint32_t seed) {
  return texture.begin(preset, d, seed, host.memory, host.bytes, host.options);
}
[[maybe_unused]] dapple::Status begun(const Host& host, Texture& texture, const dapple::Fixed& fixed, const Domain&,
                                      uint32_t seed) {
  return texture.begin(fixed, seed, host.memory, host.bytes);
}

template <class Source>
DAPPLE_APART void grow(const Host& host, const char* name, const Source& source, const Domain& d, uint32_t seed,
                       bool pixels) {
  Texture texture;
  finish(host, texture, begun(host, texture, source, d, seed), name, d, seed, pixels);
}

// The bytes are counted by the compiler. Where an object of that size is beyond the address space, or beyond POOL, the
// line and what it would link are left out.
constexpr bool good(const dapple::Need& need) { return need.status == dapple::ok || need.status == dapple::too_large; }
#ifdef POOL
constexpr size_t kPool = POOL;
#else
constexpr size_t kPool = SIZE_MAX;
#endif
constexpr bool fits(const dapple::Need& need) { return need.status == dapple::ok && need.bytes <= kPool; }

template <const Preset& preset, uint16_t width, uint16_t height, int32_t x = 0, int32_t y = 0, bool plane = false>
void tile(const Host& host, const char* name, uint32_t seed = 7, bool pixels = false) {
  constexpr Domain domain = {width, height, x, y, plane};
  constexpr dapple::Need need = dapple::need_for(preset, domain);
  static_assert(good(need), "a domain is refused");
  if constexpr (fits(need)) {
    if (need.bytes > host.bytes) return;
    if constexpr (kFixed) grow(host, name, kept<preset, width, height, x, y, plane>, domain, seed, pixels);
    else grow(host, name, preset, domain, seed, pixels);
  }
}

template <const Preset& preset, int32_t x, int32_t y>
void far_window(const Host& host, const char* name) { tile<preset, 40, 24, x, y, true>(host, name); }

template <const Preset& preset, uint8_t count>
void stored_tile(const Host& host, const char* name) {
  constexpr size_t bytes = dapple::fixed(preset, masks<preset, count>, dapple::torus(64, 64), true).need.bytes;
  static_assert(bytes > 0, "a size is refused");
  if (bytes <= host.bytes) grow(host, name, stored<preset, count, 64>, dapple::torus(64, 64), 7, true);
}

}  // namespace

void selftest(void (*put)(char), size_t memory_bytes, void* memory, const dapple::grid::KernelSwap* kernels) {
  const Host host{put, memory_bytes, memory, {1, kernels}};
  tile<cell_program, 64, 64>(host, "cell-program");
  stored_tile<presets::zebra_bits, 1>(host, "zebra-bits/stored");
  stored_tile<presets::weave_bits, 2>(host, "weave-bits/stored");
  tile<presets::zebra_bits, 64, 64>(host, "zebra-bits");
  tile<presets::weave_bits, 64, 64>(host, "weave-bits", 7, true);
  tile<presets::labyrinth_bits, 64, 64>(host, "labyrinth-bits");
  tile<lean_maze, 64, 64>(host, "lean-maze");
  tile<presets::fingerprint, 64, 64>(host, "fingerprint");
  tile<presets::giraffe_bits, 64, 64>(host, "giraffe-bits", 7, true);
  far_window<cell_program, -1000000007, 999999937>(host, "cell-program@-1000000007,999999937");
  far_window<presets::weave_bits, 999999937, -1000000007>(host, "weave-bits@999999937,-1000000007");
  tile<presets::stucco, 32, 32>(host, "stucco", 7, true);
  tile<finer, 48, 48>(host, "finer");
  tile<short_mitosis, 60, 36>(host, "short-mitosis");
#ifndef SELFTEST_SHORT  // an ATmega1284P has no room for these beside the others
  tile<turing, 24, 20>(host, "turing");
  tile<spots, 28, 20>(host, "meinhardt-spots");
  tile<stripes, 24, 24>(host, "meinhardt-stripes");
  tile<walls, 32, 24>(host, "fitzhugh-nagumo");
  tile<schnakenberg, 24, 24>(host, "schnakenberg");
  tile<phases, 24, 24>(host, "brusselator");
  tile<compact, 32, 24>(host, "compact-turing");
#endif
  tile<presets::zebra, 64, 64>(host, "zebra", 7, true);
  tile<presets::weave, 48, 48>(host, "weave");
  tile<short_mitosis, 64, 64>(host, "short-mitosis");
  tile<presets::weave_bits, 128, 128>(host, "weave-bits", 1337);
  tile<presets::fingerprint, 128, 128>(host, "fingerprint", 1337);
  tile<presets::zebra, 128, 128>(host, "zebra", 1337);
  tile<presets::coral, 128, 128>(host, "coral", 1337);
}
