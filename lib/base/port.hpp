// The only place in lib/ that looks at the compiler: read-only memory, restrict, copies.
// SPDX-License-Identifier: MIT
#pragma once
#include <stddef.h>
#include <stdint.h>

// Old C libraries hide these from C++ unless asked before the first inclusion of <stdint.h>.
#ifndef INT32_MAX
#define INT16_MAX 32767
#define UINT16_MAX 65535U
#define INT32_MAX 2147483647L
#define INT32_MIN (-INT32_MAX - 1)
#define UINT32_MAX 4294967295UL
#define INT64_MAX 9223372036854775807LL
#define UINT64_MAX 18446744073709551615ULL
#endif
#ifndef SIZE_MAX
#define SIZE_MAX static_cast<size_t>(-1)
#endif
#ifndef INT32_C
#define INT32_C(number) number##L
#define UINT32_C(number) number##UL
#define INT64_C(number) number##LL
#define UINT64_C(number) number##ULL
#endif

// DAPPLE_ROM marks constant data that must not cost RAM. On AVR flash is a second address space, so such data is read
// through rom_load and nothing else; everywhere else both are the plain thing.
#if defined(__AVR__)
#define DAPPLE_ROM __attribute__((section(".progmem.data")))
#else
#define DAPPLE_ROM
#endif

// Row kernels promise that their rows do not overlap.
#define DAPPLE_RESTRICT __restrict

// Functions whose arguments the compiler has to see, whatever it is asked to optimise for.
#if defined(__GNUC__)
#define DAPPLE_INLINE __attribute__((always_inline)) inline
#else
#define DAPPLE_INLINE inline
#endif

// Keeps a function's locals out of its caller's frame, where a deep call follows: the stack of firmware is short.
#if defined(__GNUC__)
#define DAPPLE_APART __attribute__((noinline))
#else
#define DAPPLE_APART
#endif

namespace dapple::base {

// rom_load(p) == *p for an object that was defined DAPPLE_ROM.
#if defined(__AVR__)
// One function for all of them: less flash, and no load is woven into large functions, where clang 14 was seen to copy
// pointers wrongly.
__attribute__((noinline)) inline void rom_copy(void* to, const void* from, uint16_t count) {
  uint8_t* byte = static_cast<uint8_t*>(to);
  const uint8_t* rom = static_cast<const uint8_t*>(from);
  for (; count > 0; --count) asm volatile("lpm %0, Z+" : "=r"(*byte++), "+z"(rom));
}
template <class T> inline T rom_load(const T* p) {
  T value;
  rom_copy(&value, p, sizeof value);
  return value;
}
#else
template <class T> inline T rom_load(const T* p) { return *p; }
#endif

// The first multiple of four bytes from `memory` on.
inline uint8_t* aligned4(void* memory) { return static_cast<uint8_t*>(memory) + (-reinterpret_cast<uintptr_t>(memory) & 3u); }

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

// Has x made here and now. Compilers for machines with few registers are tempted to make the parts of a long sum all at once.
template <class W> DAPPLE_INLINE void in_order([[maybe_unused]] W& x) {
#if defined(__GNUC__)
  __asm__ volatile("" : "+r"(x));
#endif
}

// low + 256 high.
DAPPLE_INLINE uint16_t join(uint8_t low, uint8_t high) {
#if defined(__AVR__)
  uint16_t both;
  __asm__("mov %A0, %1\n\tmov %B0, %2" : "=&r"(both) : "r"(low), "r"(high));
  return both;
#else
  return static_cast<uint16_t>(low | (high << 8));
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

// Where a program is sent anew to everybody who wants a texture, a loop at run time is preferred to copies of its body.
#if defined(__wasm__)
constexpr bool kSmallCode = true;
#else
constexpr bool kSmallCode = false;
#endif

// Bits of the widest word that kernels on one-bit cells may take: desktop processors have kernels on vectors (ports/desktop).
constexpr uint16_t kWidestWord = sizeof(Word) == 8 ? 256 : 8 * sizeof(Word);

// Where the stack is a few hundred bytes, larger work space comes from the caller's memory.
constexpr bool kSmallStack = sizeof(Word) == 1;

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
