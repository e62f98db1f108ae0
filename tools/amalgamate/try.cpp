// Grows presets with the two files that tools/amalgamate/run makes, and prints them as tests/golden/presets.txt does.
//   try NAME WIDTH HEIGHT SEED ...
// SPDX-License-Identifier: MIT
#include "dapple.hpp"

#include <cstdio>
#include <cstdlib>
#include <vector>

size_t from_another_file();

namespace {

// FNV-1a, 64 bit.
void add(uint64_t& hash, uint32_t number, int bytes) {
  for (int i = 0; i < bytes; ++i) hash = (hash ^ ((number >> 8 * i) & 255)) * UINT64_C(0x100000001b3);
}

bool grow(const char* name, uint16_t width, uint16_t height, uint32_t seed) {
  const dapple::Preset* preset = dapple::find_preset(name);
  if (preset == nullptr) return false;
  const dapple::Domain domain = dapple::torus(width, height);
  std::vector<uint8_t> memory(dapple::bytes_for(*preset, domain)), line(4u * width);
  std::vector<int16_t> row(width);
  dapple::Texture tile;
  if (tile.begin(*preset, domain, seed, memory.data(), memory.size()) != dapple::ok) return false;
  tile.finish();
  uint64_t field = UINT64_C(0xcbf29ce484222325), pixels = field;
  for (uint16_t y = 0; y < height; ++y) {
    tile.row(y, row.data());
    for (const int16_t value : row) add(field, static_cast<uint32_t>(int32_t{value}), 4);
    tile.paint(y, dapple::Pixels::rgba8888, line.data());
    for (const uint8_t byte : line) add(pixels, byte, 1);
  }
  std::printf("%s %ux%u %lu %016llx %016llx\n", name, unsigned{width}, unsigned{height},
              static_cast<unsigned long>(seed), static_cast<unsigned long long>(field),
              static_cast<unsigned long long>(pixels));
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  const auto number = [&](int i) { return std::strtoul(argv[i], nullptr, 10); };
  for (int i = 1; i + 3 < argc; i += 4) {
    const auto width = static_cast<uint16_t>(number(i + 1)), height = static_cast<uint16_t>(number(i + 2));
    if (!grow(argv[i], width, height, static_cast<uint32_t>(number(i + 3)))) return 1;
  }
  return from_another_file() == dapple::bytes_for(dapple::presets::zebra, dapple::torus(64, 64)) ? 0 : 1;
}
