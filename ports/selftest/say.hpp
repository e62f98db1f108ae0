// How self-tests say "name WxH seed hash": FNV-1a 64 over the field's values, as little-endian int32, or over painted bytes.
// SPDX-License-Identifier: MIT
#pragma once
#include "dapple.hpp"

namespace selftest_say {

using Put = void (*)(char);

inline void print(Put put, const char* text) {
  while (*text != 0) put(*text++);
}

inline void print_number(Put put, uint32_t number) {
  char digit[10];
  uint8_t count = 0;
  do {
    digit[count++] = static_cast<char>('0' + number % 10);
    number /= 10;
  } while (number > 0);
  while (count > 0) put(digit[--count]);
}

inline void print_hex(Put put, uint64_t number) {
  for (uint8_t i = 0; i < 16; ++i) {
    const uint8_t digit = static_cast<uint8_t>(number >> 60);
    put(static_cast<char>(digit < 10 ? '0' + digit : 'a' + digit - 10));
    number <<= 4;
  }
}

constexpr uint64_t kFirstHash = UINT64_C(0xcbf29ce484222325);
inline void add_byte(uint64_t& hash, uint8_t byte) { hash = (hash ^ byte) * UINT64_C(0x100000001b3); }

// flat: all values are the same, so the hash says little. `row` has room for a row of the field.
template <class Grown> DAPPLE_APART uint64_t hash_of_field(Grown& texture, uint16_t width, uint16_t height, int16_t* row, bool& flat) {
  uint64_t hash = kFirstHash;
  int16_t first = 0;
  flat = true;
  for (uint16_t y = 0; y < height; ++y) {
    texture.row(y, row);
    if (y == 0) first = row[0];
    for (uint16_t x = 0; x < width; ++x) {
      flat = flat && row[x] == first;
      const uint8_t sign = row[x] < 0 ? 255 : 0;
      add_byte(hash, static_cast<uint8_t>(static_cast<uint16_t>(row[x])));
      add_byte(hash, static_cast<uint8_t>(static_cast<uint16_t>(row[x]) >> 8));
      add_byte(hash, sign);
      add_byte(hash, sign);
    }
  }
  return hash;
}

// One line. By reference: clang 16 looks for arguments on the stack of an ATmega2560 a byte beside where they are.
struct Line {
  const char *name, *kind;
  uint16_t width, height;
  uint32_t seed;
  uint64_t hash;
};
inline void tell(Put put, const Line& line) {
  print(put, line.name);
  print(put, line.kind);
  put(' ');
  print_number(put, line.width);
  put('x');
  print_number(put, line.height);
  put(' ');
  print_number(put, line.seed);
  put(' ');
  print_hex(put, line.hash);
  put('\n');
}

}  // namespace selftest_say
