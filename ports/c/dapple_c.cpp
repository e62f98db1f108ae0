// The C99 face of dapple. Between C and the library stand only copies of small structs; every error is found before
// the caller's texture is touched.
// SPDX-License-Identifier: MIT
#include "reason.hpp"

namespace dapple::c {

// What a dapple_texture is.
struct Held {
  Recipe recipe;
  Texture texture;
};
static_assert(sizeof(Held) <= sizeof(dapple_texture), "raise DAPPLE_TEXTURE_BYTES in dapple.h");
static_assert(alignof(Held) <= alignof(dapple_texture), "dapple_texture needs a member of a stricter alignment");
static_assert(__is_trivially_copyable(Held), "C neither constructs nor destroys");

static Held& held(dapple_texture* texture) { return *reinterpret_cast<Held*>(texture->opaque.bytes); }
static const Held& held(const dapple_texture* texture) { return *reinterpret_cast<const Held*>(texture->opaque.bytes); }

static_assert(DAPPLE_VERSION == kVersion, "dapple.h is of another version");
static_assert(DAPPLE_NAME == kMaxName, "names are longer");

static_assert(DAPPLE_OK == int{ok} && DAPPLE_MORE == int{more} && DAPPLE_DONE == int{done}, "");
static_assert(DAPPLE_UNKNOWN_WORD == int{unknown_word} && DAPPLE_OUT_OF_RANGE == int{out_of_range}, "");
static_assert(DAPPLE_BROKEN_TEXT == int{broken_text} && DAPPLE_NOT_POSSIBLE == int{not_possible}, "");
static_assert(DAPPLE_BAD_RECIPE == int{bad_recipe} && DAPPLE_BAD_SIDE == int{bad_side}, "");
static_assert(DAPPLE_NOT_A_MULTIPLE == int{not_a_multiple} && DAPPLE_TILE_TOO_SMALL == int{tile_too_small}, "");
static_assert(DAPPLE_TOO_LARGE == int{too_large} && DAPPLE_TOO_LITTLE_MEMORY == int{too_little_memory}, "");
static_assert(DAPPLE_TOO_FAR == int{too_far} && DAPPLE_HALO_TOO_WIDE == int{halo_too_wide}, "");
static_assert(DAPPLE_BAD_MAP == int{bad_map} && DAPPLE_UNSTABLE == int{unstable}, "");
static_assert(DAPPLE_BAD_SIDES == int{bad_sides}, "");
static_assert(DAPPLE_BAD_SURFACE == int{bad_surface} && DAPPLE_NO_COVERAGE == int{no_coverage}, "");

constexpr bool same(int a, Pixels b) { return a == static_cast<int>(b); }
static_assert(same(DAPPLE_L8, Pixels::l8) && same(DAPPLE_RGB888, Pixels::rgb888), "");
static_assert(same(DAPPLE_RGBA8888, Pixels::rgba8888) && same(DAPPLE_RGB565, Pixels::rgb565), "");
static_assert(same(DAPPLE_RGB565_SWAPPED, Pixels::rgb565_swapped) && same(DAPPLE_L1_MSB, Pixels::l1_msb), "");
static_assert(same(DAPPLE_L1_LSB, Pixels::l1_lsb) && same(DAPPLE_L1_PAGES, Pixels::l1_pages), "");
static_assert(same(DAPPLE_L16, Pixels::l16) && same(DAPPLE_L16_SWAPPED, Pixels::l16_swapped), "");

constexpr bool same(int a, View b) { return a == static_cast<int>(b); }
static_assert(same(DAPPLE_COLOUR, View::colour) && same(DAPPLE_FIELD, View::field), "");
static_assert(same(DAPPLE_CELLS, View::cells) && same(DAPPLE_HEIGHT, View::height), "");
static_assert(same(DAPPLE_NORMAL, View::normal) && same(DAPPLE_OPACITY, View::opacity), "");
static_assert(same(DAPPLE_ROUGHNESS, View::roughness), "");

static Domain domain_of(const dapple_domain& d) {
  return d.plane != 0 ? window(d.x, d.y, d.width, d.height) : torus(d.width, d.height);
}

// Says it to the caller, if he wants to hear; an empty sentence to write on.
static Sentence open(dapple_trouble* to, Status status, uint16_t column) {
  if (to == nullptr) return {nullptr, 0, 0};
  to->status = status;
  to->column = column;
  to->reason[0] = 0;
  return {to->reason, sizeof to->reason, 0};
}

// The preset that text begins with, or null; rest: what follows its name and spaces.
static const Preset* preset_before(const char* text, const char*& rest) {
  char name[kMaxName];
  uint8_t length = 0;
  while (*text == ' ') ++text;
  for (; *text != 0 && *text != ' '; ++text) {
    if (length + 1 == kMaxName) return nullptr;
    name[length++] = *text;
  }
  name[length] = 0;
  while (*text == ' ') ++text;
  rest = text;
  return find_preset(name);
}

// Refuses a text as a whole.
static Status refuse(dapple_trouble* to, Status status, uint16_t column, const char* why) {
  Sentence sentence = open(to, status, column);
  put(sentence, why);
  return status;
}

// The recipe of a text; says what is wrong with it.
static Status read(const char* text, Recipe& recipe, dapple_trouble* to) {
  if (text == nullptr) text = "";
  if (recipe::length_of(text) == recipe::kMaxText)
    return refuse(to, broken_text, recipe::kMaxText, "the text is too long");
  const char* changes = text;
  const Preset* preset = preset_before(text, changes);
  if (preset == nullptr) changes = text;
  const uint16_t before = static_cast<uint16_t>(changes - text);
  recipe = preset != nullptr ? load(*preset) : Recipe{};
  open(to, ok, 0);
  if (preset != nullptr && *changes == 0) return ok;

  recipe::Word rest = recipe::word_of(changes);
  if (preset != nullptr && recipe::family_named(recipe::next_word(rest)) >= 0)
    return refuse(to, not_possible, static_cast<uint16_t>(before + 1), "a preset's changes cannot begin with a model");
  Trouble trouble{};
  const Status status = parse(changes, recipe, trouble);
  if (status == ok) return ok;
  Sentence sentence = open(to, status, static_cast<uint16_t>(before + trouble.column));
  explain(sentence, trouble, changes);
  return status;
}

// The recipe of a text and what it needs on a domain; says what is wrong with either.
static Need read(const char* text, const dapple_domain& domain, Recipe& recipe, dapple_trouble* to) {
  Need need{};
  need.status = read(text, recipe, to);
  if (need.status != ok) return need;
  need = need_for(recipe, domain_of(domain));
  if (need.status == ok) return need;
  Sentence sentence = open(to, need.status, 0);
  explain(sentence, need);
  return need;
}

}  // namespace dapple::c

using namespace dapple::c;

int32_t dapple_version(void) { return dapple::kVersion; }

dapple_status dapple_need_for(const char* text, dapple_domain domain, dapple_need* need, dapple_trouble* trouble) {
  dapple::Recipe recipe;
  const dapple::Need n = read(text, domain, recipe, trouble);
  *need = {n.status, n.bytes,    n.planes, n.scratch, n.paint,  n.rest, n.width,
           n.height, n.multiple, n.reach,  n.halo,    n.sweeps, n.rows};
  return need->status;
}

size_t dapple_bytes_for(const char* text, dapple_domain domain) {
  dapple::Recipe recipe;
  return read(text, domain, recipe, nullptr).bytes;
}

dapple_status dapple_begin(dapple_texture* texture, const char* text, dapple_domain domain, uint32_t seed, void* memory,
                           size_t bytes, dapple_trouble* trouble) {
  dapple::Recipe recipe;
  dapple::Need need = read(text, domain, recipe, trouble);
  if (need.status == dapple::ok && (memory == nullptr || bytes < need.bytes)) {
    need.status = dapple::too_little_memory;
    Sentence sentence = open(trouble, need.status, 0);
    explain(sentence, need);
  }
  if (need.status != dapple::ok) return need.status;
  Held& h = held(texture);
  h.recipe = recipe;
  return h.texture.begin(h.recipe, domain_of(domain), seed, memory, bytes);
}

dapple_status dapple_step(dapple_texture* texture, uint32_t rows) { return held(texture).texture.step(rows); }

uint64_t dapple_rows_done(const dapple_texture* texture) { return held(texture).texture.rows_done(); }
uint64_t dapple_rows_in_all(const dapple_texture* texture) { return held(texture).texture.rows_in_all(); }

dapple_domain dapple_domain_of(const dapple_texture* texture) {
  const dapple::Domain& d = held(texture).texture.domain();
  return {d.width, d.height, d.x, d.y, static_cast<uint8_t>(d.plane)};
}

size_t dapple_row(dapple_texture* texture, uint16_t y, int16_t* out) {
  dapple::Texture& t = held(texture).texture;
  if (y >= t.domain().height) return 0;
  t.row(y, out);
  return t.domain().width;
}

int16_t dapple_unit(const dapple_texture* texture) { return held(texture).texture.unit(); }
int16_t dapple_cell_level(const dapple_texture* texture) { return held(texture).texture.cell_level(); }

size_t dapple_pixel_bytes(dapple_pixels format, uint16_t width) {
  if (format > DAPPLE_L16_SWAPPED) return 0;
  return dapple::pixel_bytes(static_cast<dapple::Pixels>(format), width);
}

size_t dapple_paint_with(dapple_texture* texture, uint16_t y, const dapple_brush* brush, void* out) {
  dapple::Texture& t = held(texture).texture;
  const size_t bytes = dapple_pixel_bytes(brush->format, t.domain().width);
  if (bytes == 0 || y >= t.domain().height || brush->view > DAPPLE_ROUGHNESS) return 0;
  const dapple::Brush b = {static_cast<dapple::View>(brush->view), static_cast<dapple::Pixels>(brush->format),
                           brush->dither != 0, brush->y_down != 0, brush->unlit != 0};
  t.paint(y, b, out);
  return bytes;
}

size_t dapple_paint(dapple_texture* texture, uint16_t y, dapple_pixels format, void* out) {
  const dapple_brush brush = {DAPPLE_COLOUR, format, 0, 0, 0};
  return dapple_paint_with(texture, y, &brush, out);
}

uint16_t dapple_preset_count(void) { return dapple::preset_count(); }

size_t dapple_preset_name(uint16_t index, char* name, size_t size) {
  char buffer[dapple::kMaxName] = "";
  if (index < dapple::preset_count()) dapple::preset_at(index, buffer);
  size_t length = 0;
  for (; buffer[length] != 0; ++length)
    if (length + 1 < size) name[length] = buffer[length];
  if (size > 0) name[length < size ? length : size - 1] = 0;
  return length;
}

const char* dapple_preset_sentence(uint16_t index) {
  char name[dapple::kMaxName];
  return index < dapple::preset_count() ? dapple::preset_at(index, name).sentence : nullptr;
}

size_t dapple_recipe_of(const dapple_texture* texture, char* line, size_t size) {
  return dapple::write(held(texture).recipe, line, size);
}

size_t dapple_recipe_line(const char* text, char* line, size_t size, dapple_trouble* trouble) {
  dapple::Recipe recipe;
  if (read(text, recipe, trouble) == dapple::ok) return dapple::write(recipe, line, size);
  if (size > 0) line[0] = 0;
  return 0;
}
