// The only place in lib/ that looks at the compiler: read-only memory, restrict, copies.
// SPDX-License-Identifier: MIT
#pragma once
#include <stddef.h>
#include <stdint.h>

// DAPPLE_ROM marks constant data that must not cost RAM. On AVR flash is a second address space, so such data is read
// through rom_load and nothing else; everywhere else both are the plain thing.
#if defined(__AVR__)
#define DAPPLE_ROM __attribute__((section(".progmem.data")))
#else
#define DAPPLE_ROM
#endif

// Row kernels promise that their rows do not overlap.
#define DAPPLE_RESTRICT __restrict

namespace dapple::base {

// rom_load(p) == *p for an object that was defined DAPPLE_ROM.
#if defined(__AVR__)
template <class T> inline T rom_load(const T* p) {
  T value;
  uint8_t* to = reinterpret_cast<uint8_t*>(&value);
  const uint8_t* from = reinterpret_cast<const uint8_t*>(p);
  for (uint16_t i = 0; i < sizeof(T); ++i) {
    uint8_t byte;
    asm("lpm %0, Z" : "=r"(byte) : "z"(from + i));
    to[i] = byte;
  }
  return value;
}
#else
template <class T> inline T rom_load(const T* p) { return *p; }
#endif

// copy_bytes: count bytes, no overlap. Compilers turn even a freestanding program's copies into memcpy; where they offer
// the word for it, it is said outright.
inline void copy_bytes(void* to, const void* from, size_t count) {
#if defined(__GNUC__)
  __builtin_memcpy(to, from, count);
#else
  uint8_t* DAPPLE_RESTRICT t = static_cast<uint8_t*>(to);
  const uint8_t* DAPPLE_RESTRICT f = static_cast<const uint8_t*>(from);
  for (size_t i = 0; i < count; ++i) t[i] = f[i];
#endif
}

// The machine's word: cells of one bit are worked on a word at a time.
#if defined(__AVR__)
using Word = uint8_t;
#elif UINTPTR_MAX > 0xffffffffu || defined(__wasm__)
using Word = uint64_t;
#else
using Word = uint32_t;
#endif

// load_word(p): bytes in memory order, the first the least significant; p of any alignment. store_word: the reverse.
template <class W> inline W load_word(const uint8_t* from) {
  W word = 0;
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
  copy_bytes(&word, from, sizeof word);
#else
  for (uint8_t i = 0; i < sizeof word; ++i) word = static_cast<W>(word | (static_cast<W>(from[i]) << (8 * i)));
#endif
  return word;
}
template <class W> inline void store_word(uint8_t* to, W word) {
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
  copy_bytes(to, &word, sizeof word);
#else
  for (uint8_t i = 0; i < sizeof word; ++i) to[i] = static_cast<uint8_t>(word >> (8 * i));
#endif
}

}  // namespace dapple::base
