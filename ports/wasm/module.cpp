// dapple as a WebAssembly module: exported functions over memory that the caller lays out. It imports nothing and keeps
// nothing but a text buffer and the numbers of the last answer, told(); a recipe and a texture are areas of the caller's,
// as large as the *_bytes functions say, anywhere from heap() on. Domains are given as plane (0: torus, 1: window), x, y,
// width, height. Negative answers are the library's Status; dapple.js puts them, and the numbers told, into words.
// SPDX-License-Identifier: MIT
#include "dapple.hpp"
#include "families.hpp"

#define EXPORT(name) extern "C" __attribute__((export_name(#name))) auto name

namespace {

using namespace dapple;

#include "texts_packed.hpp"

constexpr int32_t kTextBytes = recipe::kMaxText;  // the longest line and its zero
constexpr int32_t kLongestSide = 65535;
char text_buffer[kTextBytes];
int32_t told_numbers[8];

constexpr int32_t kRampCount = sizeof recipe::ramps / sizeof recipe::ramps[0];

bool is_side(int32_t side) { return side >= kSmallestSide && side <= kLongestSide; }
int32_t address(const char* text) { return static_cast<int32_t>(reinterpret_cast<uintptr_t>(text)); }

}  // namespace

extern "C" uint8_t __heap_base;

// Where the caller's memory begins; the buffer that recipes are handed over in, ended by a zero; the numbers told.
EXPORT(heap)() -> uint32_t { return (static_cast<uint32_t>(reinterpret_cast<uintptr_t>(&__heap_base)) + 15) & ~15u; }
EXPORT(text)() -> char* { return text_buffer; }
EXPORT(text_bytes)() -> int32_t { return kTextBytes; }
EXPORT(told)() -> int32_t* { return told_numbers; }

// Told: the most stages, the widest halo, the smallest side.
EXPORT(limits)() -> void {
  told_numbers[0] = kMaxStages;
  told_numbers[1] = kWidestHalo;
  told_numbers[2] = kSmallestSide;
}

EXPORT(recipe_bytes)() -> int32_t { return sizeof(Recipe); }
EXPORT(texture_bytes)() -> int32_t { return sizeof(Texture); }

// In gzip's format [RFC 1952] what texts.cpp says: of every preset its name (an underscore is a hyphen), sentence and recipe line,
// an empty text, and a sentence about every number of every family. Told: bytes.
EXPORT(texts)() -> const uint8_t* {
  told_numbers[0] = sizeof kTexts;
  return kTexts;
}
// Lists, each ended by 0.
EXPORT(ramp)(int32_t index) -> const char* { return index < kRampCount ? recipe::ramps[index].name : nullptr; }
// A family's name; told: the steps it takes by itself.
EXPORT(family)(int32_t index) -> const char* {
  if (index >= offered::kCount) return nullptr;
  told_numbers[0] = static_cast<int32_t>(offered::kAll.family[index].steps);
  return offered::kAll.family[index].name;
}

// Number `index` of a family: its name, or 0; told: Number::Kind, low, high, standard, words.
EXPORT(number)(int32_t family, int32_t index) -> const char* {
  const recipe::Family& f = offered::kAll.family[family];
  const int32_t of_map = index - f.number_count;
  if (of_map >= recipe::map_numbers(f)) return nullptr;
  const Number& n = of_map < 0 ? f.numbers[index] : along::numbers[of_map];
  const int32_t told[] = {n.kind, n.low, n.high, n.standard, address(n.words)};
  for (uint8_t i = 0; i < 5; ++i) told_numbers[i] = told[i];
  return n.name;
}

// Reads text() as a whole recipe: ok; or why not, told: column from 1, place and length of the word, low, high, whether
// they are whole numbers (else 1/kMicro), and the words allowed, separated by '|', or 0.
EXPORT(parse)(Recipe* recipe) -> int32_t {
  text_buffer[kTextBytes - 1] = 0;
  Recipe fresh{};
  Trouble t{};
  const Status status = recipe::read(text_buffer, fresh, t, offered::kFamilies);
  if (status == ok) *recipe = fresh;
  const int32_t told[] = {t.column, address(t.word.text), t.word.length, t.low, t.high, t.whole, address(t.allowed)};
  for (uint8_t i = 0; i < 7; ++i) told_numbers[i] = told[i];
  return status;
}

// Readies a texture. Whatever the answer, told: bytes wanted, halo, smallest width, smallest height, multiple. With no memory
// it only asks, and too_little_memory is the answer to what would do.
EXPORT(begin)(Texture* texture, const Recipe* recipe, int32_t plane, int32_t x, int32_t y, int32_t width, int32_t height,
              uint32_t seed, void* memory, uint32_t bytes) -> int32_t {
  if (!is_side(width) || !is_side(height)) return bad_side;
  const uint16_t w = static_cast<uint16_t>(width), h = static_cast<uint16_t>(height);
  const Domain domain = plane != 0 ? window(x, y, w, h) : torus(w, h);
  Need need{};
  const Status status = texture->begin(*recipe, domain, seed, memory, bytes, Options{}, &need);
  told_numbers[0] = static_cast<int32_t>(need.bytes);
  told_numbers[1] = static_cast<int32_t>(need.halo);
  told_numbers[2] = need.width;
  told_numbers[3] = need.height;
  told_numbers[4] = need.multiple;
  return need.bytes > INT32_MAX ? too_large : status;
}

// 1: more; 2: done.
EXPORT(step)(Texture* texture, uint32_t rows) -> int32_t { return texture->step(rows); }

// Thousandths of the work done.
EXPORT(progress)(const Texture* texture) -> int32_t {
  const uint64_t all = texture->rows_in_all();
  return all == 0 ? 1000 : static_cast<int32_t>(texture->rows_done() * 1000 / all);
}

// Row y as pixels, and as numbers of 16 bits.
EXPORT(paint)(Texture* texture, int32_t y, int32_t view, int32_t format, uint8_t* out) -> void {
  Brush brush;
  brush.view = static_cast<View>(view);
  brush.format = static_cast<Pixels>(format);
  texture->paint(static_cast<uint16_t>(y), brush, out);
}
EXPORT(field)(Texture* texture, int32_t y, int16_t* out) -> void { texture->row(static_cast<uint16_t>(y), out); }
