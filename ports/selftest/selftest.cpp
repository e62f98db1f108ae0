// Grows textures by every solver and prints "name WxH seed hash": FNV-1a 64 over the field's values, as little-endian
// int32, or over painted bytes. Whoever has less memory leaves lines out; no line may differ.
// SPDX-License-Identifier: MIT
#include "selftest.hpp"
#include "dapple.hpp"

using dapple::Domain;
using dapple::Preset;
using dapple::Texture;
namespace presets = dapple::presets;

namespace {

// Presets as they are, and recipes with fewer steps or other numbers.
constexpr Preset cell_program DAPPLE_ROM = dapple::recipe::preset("cells rule=0xe8808000 steps=24");
constexpr Preset lean_maze DAPPLE_ROM = dapple::recipe::preset("bits masks=2 react=da window=6 scale=8 stretch=3 angle=0 steps=4 solver=lean");
constexpr Preset short_mitosis DAPPLE_ROM = dapple::recipe::preset("gray-scott feed=0.0367 kill=0.0649 steps=40");
constexpr Preset finer DAPPLE_ROM = dapple::recipe::preset("threshold pairs=1 react=md scale=2.2 stretch=2 angle=78.5 rho=0 solver=euler levels=2 steps=8");
static_assert(cell_program.recipe.stages > 0 && lean_maze.recipe.stages > 0 && short_mitosis.recipe.stages > 0 && finer.recipe.stages > 0,
              "a recipe is refused");

// What firmware does: masks and sizes made by the compiler, kept in read-only memory.
constexpr auto masks DAPPLE_ROM = dapple::stored_masks<1>(presets::zebra_bits);
constexpr dapple::Fixed fixed_zebra DAPPLE_ROM = dapple::fixed(presets::zebra_bits, masks, dapple::torus(64, 64), true);
constexpr size_t kFixedBytes = fixed_zebra.need.bytes;

constexpr uint16_t kWidest = 128;

struct Host {
  void (*put)(char);
  size_t bytes;
  void* memory;
};

void print(const Host& host, const char* text) {
  while (*text != 0) host.put(*text++);
}

void print_number(const Host& host, uint32_t number) {
  char digit[10];
  uint8_t count = 0;
  do {
    digit[count++] = static_cast<char>('0' + number % 10);
    number /= 10;
  } while (number > 0);
  while (count > 0) host.put(digit[--count]);
}

void print_hex(const Host& host, uint64_t number) {
  for (uint8_t i = 0; i < 16; ++i) {
    const uint8_t digit = static_cast<uint8_t>(number >> 60);
    host.put(static_cast<char>(digit < 10 ? '0' + digit : 'a' + digit - 10));
    number <<= 4;
  }
}

void add_byte(uint64_t& hash, uint8_t byte) { hash = (hash ^ byte) * UINT64_C(0x100000001b3); }

DAPPLE_APART uint64_t hash_of_field(Texture& texture, const Domain& d) {
  uint64_t hash = UINT64_C(0xcbf29ce484222325);
  int16_t row[kWidest];
  for (uint16_t y = 0; y < d.height; ++y) {
    texture.row(y, row);
    for (uint16_t x = 0; x < d.width; ++x) {
      const uint8_t sign = row[x] < 0 ? 255 : 0;
      add_byte(hash, static_cast<uint8_t>(static_cast<uint16_t>(row[x])));
      add_byte(hash, static_cast<uint8_t>(static_cast<uint16_t>(row[x]) >> 8));
      add_byte(hash, sign);
      add_byte(hash, sign);
    }
  }
  return hash;
}

DAPPLE_APART uint64_t hash_of_pixels(Texture& texture, const Domain& d) {
  uint64_t hash = UINT64_C(0xcbf29ce484222325);
  uint8_t line[2 * kWidest];
  for (uint16_t y = 0; y < d.height; ++y) {
    texture.paint(y, dapple::Pixels::rgb565_swapped, line);
    for (uint16_t x = 0; x < 2 * d.width; ++x) add_byte(hash, line[x]);
  }
  return hash;
}

void tell(const Host& host, const char* name, const char* kind, const Domain& d, uint32_t seed, uint64_t hash) {
  print(host, name);
  print(host, kind);
  host.put(' ');
  print_number(host, d.width);
  host.put('x');
  print_number(host, d.height);
  host.put(' ');
  print_number(host, seed);
  host.put(' ');
  print_hex(host, hash);
  host.put('\n');
}

void finish(const Host& host, Texture& texture, dapple::Status status, const char* name, const Domain& d, uint32_t seed, bool pixels) {
  if (status != dapple::ok) {
    print(host, name);
    print(host, " is refused\n");
    return;
  }
  while (texture.step(16) == dapple::more) {
  }
  tell(host, name, "", d, seed, hash_of_field(texture, d));
  if (pixels) tell(host, name, "/rgb565", d, seed, hash_of_pixels(texture, d));
}

DAPPLE_APART void grow(const Host& host, const char* name, const Preset& preset, const Domain& d, uint32_t seed, bool pixels) {
  Texture texture;
  finish(host, texture, texture.begin(preset, d, seed, host.memory, host.bytes), name, d, seed, pixels);
}

// The bytes are counted by the compiler, so that no table in flash is read as if it were RAM.
template <const Preset& preset, uint16_t width, uint16_t height>
void tile(const Host& host, const char* name, uint32_t seed = 7, bool pixels = false) {
  constexpr size_t bytes = dapple::bytes_for(preset, dapple::torus(width, height));
  static_assert(bytes > 0, "a size is refused");
  if (bytes <= host.bytes) grow(host, name, preset, dapple::torus(width, height), seed, pixels);
}

template <const Preset& preset, int32_t x, int32_t y>
void far_window(const Host& host, const char* name) {
  constexpr Domain domain = dapple::window(x, y, 40, 24);
  constexpr size_t bytes = dapple::bytes_for(preset, domain);
  static_assert(bytes > 0, "a window is refused");
  if (bytes <= host.bytes) grow(host, name, preset, domain, 7, false);
}

DAPPLE_APART void fixed_tile(const Host& host) {
  if (kFixedBytes > host.bytes) return;
  Texture texture;
  finish(host, texture, texture.begin(fixed_zebra, 7, host.memory, host.bytes), "zebra-bits/fixed", dapple::torus(64, 64), 7, true);
}

}  // namespace

void selftest(void (*put)(char), size_t memory_bytes, void* memory) {
  const Host host{put, memory_bytes, memory};
  tile<cell_program, 64, 64>(host, "cell-program");
  fixed_tile(host);
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
  tile<presets::zebra, 64, 64>(host, "zebra", 7, true);
  tile<presets::weave, 48, 48>(host, "weave");
  tile<short_mitosis, 64, 64>(host, "short-mitosis");
  tile<presets::weave_bits, 128, 128>(host, "weave-bits", 1337);
  tile<presets::fingerprint, 128, 128>(host, "fingerprint", 1337);
  tile<presets::zebra, 128, 128>(host, "zebra", 1337);
  tile<presets::coral, 128, 128>(host, "coral", 1337);
}
