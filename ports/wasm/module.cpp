// dapple as a WebAssembly module: exported functions over memory that the caller lays out. It imports nothing and keeps
// nothing but a text buffer; recipes, textures and caches are areas of the caller's, as large as the *_bytes functions
// say, anywhere from heap() on. Domains are given as plane (0: torus, 1: window), x, y, width, height. Numbers that are
// negative are the library's Status, and text() then says why.
// SPDX-License-Identifier: MIT
#include "chunks.hpp"
#include "words.hpp"

#define EXPORT(name) extern "C" __attribute__((export_name(#name))) auto name

namespace {

using namespace dapple;

constexpr int32_t kTextBytes = 6000;  // the longest recipe and more
constexpr int32_t kLongestSide = 65535;
char text_buffer[kTextBytes];

// Presets as text: recipes that are read when they are chosen take less room than recipes that are there.
struct Listed {
  const char *name, *sentence, *line;
};
constexpr Listed kEntries[] = {
#define DAPPLE_PRESET(name, sentence, text) {#name, sentence, text},
#include "recipe/presets.def"
#undef DAPPLE_PRESET
};
constexpr int32_t kEntryCount = sizeof kEntries / sizeof kEntries[0];

wasm::Text say() { return wasm::Text(text_buffer, sizeof text_buffer); }

Domain domain_of(int32_t plane, int32_t x, int32_t y, int32_t width, int32_t height) {
  const uint16_t w = static_cast<uint16_t>(width), h = static_cast<uint16_t>(height);
  return plane != 0 ? window(x, y, w, h) : torus(w, h);
}

bool is_side(int32_t side) { return side >= kSmallestSide && side <= kLongestSide; }

Brush brush_of(int32_t view, int32_t format) {
  Brush brush;
  brush.view = static_cast<View>(view);
  brush.format = static_cast<Pixels>(format);
  return brush;
}

int32_t refused(const Need& need, const Domain& domain) {
  wasm::Text out = say();
  wasm::tell_need(out, need, domain);
  return need.status;
}

}  // namespace

extern "C" {
extern uint8_t __heap_base;

// Compilers turn loops into calls of these; a program without a library brings them.
void* memset(void* to, int value, size_t count) {
  uint8_t* byte = static_cast<uint8_t*>(to);
  uint32_t word = static_cast<uint8_t>(value) * UINT32_C(0x01010101);
  for (; count > 0 && reinterpret_cast<uintptr_t>(byte) % 4 != 0; --count) *byte++ = static_cast<uint8_t>(value);
  for (; count >= 4; count -= 4, byte += 4) *reinterpret_cast<uint32_t*>(byte) = word;
  for (; count > 0; --count) *byte++ = static_cast<uint8_t>(value);
  return to;
}

void* memcpy(void* __restrict to, const void* __restrict from, size_t count) {
  uint8_t* t = static_cast<uint8_t*>(to);
  const uint8_t* f = static_cast<const uint8_t*>(from);
  for (; count >= 8; count -= 8, t += 8, f += 8) __builtin_memcpy(t, f, 8);
  for (; count > 0; --count) *t++ = *f++;
  return to;
}

void* memmove(void* to, const void* from, size_t count) {
  if (to <= from) return memcpy(to, from, count);
  for (size_t i = count; i > 0; --i) static_cast<uint8_t*>(to)[i - 1] = static_cast<const uint8_t*>(from)[i - 1];
  return to;
}
}

// Where the caller's memory begins, and the buffer that text goes through both ways, ended by a zero.
EXPORT(heap)() -> uint32_t { return (static_cast<uint32_t>(reinterpret_cast<uintptr_t>(&__heap_base)) + 15) & ~15u; }
EXPORT(text)() -> char* { return text_buffer; }
EXPORT(text_bytes)() -> int32_t { return kTextBytes; }
EXPORT(version)() -> int32_t { return kVersion; }

// Part 0 name, 1 sentence, 2 recipe line of preset `index` to text(); its length.
EXPORT(preset_count)() -> int32_t { return kEntryCount; }
EXPORT(preset)(int32_t index, int32_t part) -> int32_t {
  if (index < 0 || index >= kEntryCount) return 0;
  const Listed& entry = kEntries[index];
  wasm::Text out = say();
  out << (part == 0 ? entry.name : part == 1 ? entry.sentence : entry.line);
  for (char* c = text_buffer; part == 0 && *c != 0; ++c)
    if (*c == '_') *c = '-';
  return static_cast<int32_t>(out.length());
}

EXPORT(recipe_bytes)() -> int32_t { return sizeof(Recipe); }
EXPORT(texture_bytes)() -> int32_t { return sizeof(Texture); }
EXPORT(chunks_bytes)() -> int32_t { return sizeof(Chunks); }

// Reads text() as a whole recipe. 0; or the column, from 1, with text() saying what is wrong there.
EXPORT(parse)(Recipe* recipe) -> int32_t {
  static char given[kTextBytes];
  text_buffer[kTextBytes - 1] = 0;
  memcpy(given, text_buffer, sizeof given);
  Recipe fresh{};
  Trouble trouble{};
  if (recipe::read(given, fresh, trouble) == ok) {
    *recipe = fresh;
    return 0;
  }
  wasm::Text out = say();
  wasm::tell_trouble(out, given, trouble);
  return trouble.column;
}

// Bytes a texture needs.
EXPORT(need)(const Recipe* recipe, int32_t plane, int32_t x, int32_t y, int32_t width, int32_t height) -> int32_t {
  const Domain domain = domain_of(plane, x, y, width, height);
  Need need{};
  need.status = bad_side;
  if (is_side(width) && is_side(height)) Texture().begin(*recipe, domain, 0, nullptr, 0, Options{}, &need);
  if (need.status == too_little_memory && need.bytes <= INT32_MAX) return static_cast<int32_t>(need.bytes);
  if (need.status == too_little_memory) need.status = too_large;
  return refused(need, domain);
}

// Cells that a window is grown with on every side.
EXPORT(halo)(const Recipe* recipe) -> int32_t {
  Need need{};
  Texture().begin(*recipe, window(0, 0, 64, 64), 0, nullptr, 0, Options{}, &need);
  return static_cast<int32_t>(need.halo);
}

EXPORT(begin)(Texture* texture, const Recipe* recipe, int32_t plane, int32_t x, int32_t y, int32_t width, int32_t height,
              uint32_t seed, void* memory, uint32_t bytes) -> int32_t {
  if (!is_side(width) || !is_side(height)) return bad_side;
  const Domain domain = domain_of(plane, x, y, width, height);
  Need need{};
  *texture = Texture();
  const Status status = texture->begin(*recipe, domain, seed, memory, bytes, Options{}, &need);
  return status == ok ? ok : refused(need, domain);
}

// 1: more; 2: done.
EXPORT(step)(Texture* texture, uint32_t rows) -> int32_t { return texture->step(rows); }

// Thousandths of the work done.
EXPORT(progress)(const Texture* texture) -> int32_t {
  const uint64_t all = texture->rows_in_all();
  return all == 0 ? 1000 : static_cast<int32_t>(texture->rows_done() * 1000 / all);
}

// `rows` rows of pixels from row y on; bytes_a_row(format, width) each.
EXPORT(bytes_a_row)(int32_t format, int32_t width) -> int32_t {
  return static_cast<int32_t>(pixel_bytes(static_cast<Pixels>(format), static_cast<uint16_t>(width)));
}
EXPORT(paint)(Texture* texture, int32_t y, int32_t rows, int32_t view, int32_t format, uint8_t* out) -> void {
  const Brush brush = brush_of(view, format);
  const size_t bytes = pixel_bytes(brush.format, texture->domain().width);
  for (int32_t i = 0; i < rows; ++i) texture->paint(static_cast<uint16_t>(y + i), brush, out + static_cast<size_t>(i) * bytes);
}

// Row y of the field: width 16-bit numbers.
EXPORT(field)(Texture* texture, int32_t y, int16_t* out) -> void { texture->row(static_cast<uint16_t>(y), out); }

// FNV-1a, 64 bit, on from `hash` (0: from the beginning) over row y of the field, four bytes a cell; `row` is room for it.
EXPORT(field_hash)(Texture* texture, int32_t y, int16_t* row, uint64_t hash) -> uint64_t {
  if (hash == 0) hash = UINT64_C(0xcbf29ce484222325);
  texture->row(static_cast<uint16_t>(y), row);
  for (uint16_t x = 0; x < texture->domain().width; ++x)
    for (int32_t shift = 0; shift < 32; shift += 8)
      hash = (hash ^ static_cast<uint8_t>(static_cast<uint32_t>(int32_t{row[x]}) >> shift)) * UINT64_C(0x100000001b3);
  return hash;
}

// Bytes of memory a cache of chunks needs.
EXPORT(chunks_need)(const Recipe* recipe, int32_t side, int32_t slots) -> int32_t {
  Chunks chunks;
  ChunkNeed need{};
  const Brush brush = brush_of(0, static_cast<int32_t>(Pixels::rgba8888));
  chunks.begin(*recipe, 0, static_cast<uint16_t>(side), static_cast<uint16_t>(slots), brush, nullptr, 0, Options{}, &need);
  if (need.status == too_little_memory && need.bytes <= INT32_MAX) return static_cast<int32_t>(need.bytes);
  Need told{};
  told.status = need.status == too_little_memory ? too_large : need.status;
  told.halo = need.halo;
  if (told.status == halo_too_wide) told.halo = static_cast<uint32_t>(halo(recipe));
  return refused(told, torus(0, 0));
}

EXPORT(chunks_begin)(Chunks* chunks, const Recipe* recipe, uint32_t seed, int32_t side, int32_t slots, int32_t view,
                     void* memory, uint32_t bytes) -> int32_t {
  *chunks = Chunks();
  return chunks->begin(*recipe, seed, static_cast<uint16_t>(side), static_cast<uint16_t>(slots),
                       brush_of(view, static_cast<int32_t>(Pixels::rgba8888)), memory, bytes);
}

EXPORT(chunks_look_at)(Chunks* chunks, int32_t x, int32_t y, int32_t width, int32_t height) -> int32_t {
  if (width < 1 || height < 1 || width > kLongestSide || height > kLongestSide) return bad_side;
  return chunks->look_at(x, y, static_cast<uint16_t>(width), static_cast<uint16_t>(height));
}
EXPORT(chunks_step)(Chunks* chunks, uint32_t rows) -> int32_t { return chunks->step(rows); }
EXPORT(chunks_missing)(const Chunks* chunks) -> int32_t { return static_cast<int32_t>(chunks->missing()); }
// The chunk's pixels, rgba, or 0.
EXPORT(chunks_pixels)(const Chunks* chunks, int32_t cx, int32_t cy) -> const uint8_t* { return chunks->pixels(cx, cy); }
