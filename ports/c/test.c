/* The C face grows the bytes of the goldens, refuses what it should, and keeps textures apart.
     test GOLDENS       tests/golden/presets.txt
     test --errors      all but the goldens
   SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "dapple.h"

static int failures = 0;

#define CHECK(condition)                                             \
  do {                                                               \
    if (!(condition)) {                                              \
      printf("%s:%d: not so: %s\n", __FILE__, __LINE__, #condition); \
      ++failures;                                                    \
    }                                                                \
  } while (0)

/* FNV-1a, 64 bit. */
static uint64_t with_byte(uint64_t hash, uint8_t byte) { return (hash ^ byte) * UINT64_C(0x100000001b3); }

static uint64_t with_number(uint64_t hash, int32_t number) {
  int shift;
  for (shift = 0; shift < 32; shift += 8) hash = with_byte(hash, (uint8_t)((uint32_t)number >> shift));
  return hash;
}

static uint64_t field_hash(dapple_texture* texture) {
  const dapple_domain domain = dapple_domain_of(texture);
  int16_t* row = malloc(domain.width * sizeof *row);
  uint64_t hash = UINT64_C(0xcbf29ce484222325);
  uint16_t x, y;
  for (y = 0; y < domain.height; ++y) {
    CHECK(dapple_row(texture, y, row) == domain.width);
    for (x = 0; x < domain.width; ++x) hash = with_number(hash, row[x]);
  }
  free(row);
  return hash;
}

static uint64_t pixels_hash(dapple_texture* texture, const dapple_brush* brush) {
  const dapple_domain domain = dapple_domain_of(texture);
  const size_t bytes = dapple_pixel_bytes(brush->format, domain.width);
  uint8_t* row = calloc(bytes, 1);
  uint64_t hash = UINT64_C(0xcbf29ce484222325);
  uint16_t y;
  size_t i;
  for (y = 0; y < domain.height; ++y) {
    CHECK(dapple_paint_with(texture, y, brush, row) == bytes);
    for (i = 0; i < bytes; ++i) hash = with_byte(hash, row[i]);
  }
  free(row);
  return hash;
}

static uint64_t colour_hash(dapple_texture* texture) {
  dapple_brush brush;
  memset(&brush, 0, sizeof brush);
  brush.format = DAPPLE_RGBA8888;
  return pixels_hash(texture, &brush);
}

/* Begins a texture in memory of exactly the bytes it asks for, dirty; null when it is refused. */
static void* begun(dapple_texture* texture, const char* text, dapple_domain domain, uint32_t seed) {
  const size_t bytes = dapple_bytes_for(text, domain);
  void* memory = malloc(bytes + 1);
  dapple_trouble trouble;
  memset(memory, 0xa5, bytes + 1);
  memset(texture, 0xa5, sizeof *texture);
  if (dapple_begin(texture, text, domain, seed, memory, bytes, &trouble) == DAPPLE_OK) return memory;
  printf("%s: %s\n", text, trouble.reason);
  ++failures;
  free(memory);
  return NULL;
}

static void finish(dapple_texture* texture, uint32_t rows) {
  while (dapple_step(texture, rows) == DAPPLE_MORE) {
  }
}

/* One line: name WxH seed field pixels. */
static void check_golden(const char* line) {
  char name[64];
  unsigned width, height, seed;
  unsigned long field[2], pixels[2];
  dapple_texture texture;
  void* memory;
  if (sscanf(line, "%63s %ux%u %u %8lx%8lx %8lx%8lx", name, &width, &height, &seed, &field[0], &field[1], &pixels[0],
             &pixels[1]) != 8) {
    printf("a broken line: %s", line);
    ++failures;
    return;
  }
  memory = begun(&texture, name, dapple_torus((uint16_t)width, (uint16_t)height), seed);
  if (memory == NULL) return;
  finish(&texture, 999);
  if (field_hash(&texture) != ((uint64_t)field[0] << 32 | field[1]) ||
      colour_hash(&texture) != ((uint64_t)pixels[0] << 32 | pixels[1])) {
    printf("%s %ux%u: other bytes than the golden\n", name, width, height);
    ++failures;
  }
  free(memory);
}

static void check_goldens(const char* path) {
  char line[256];
  unsigned lines = 0;
  FILE* file = fopen(path, "r");
  if (file == NULL) {
    printf("%s cannot be read\n", path);
    exit(1);
  }
  while (fgets(line, sizeof line, file) != NULL) {
    check_golden(line);
    ++lines;
  }
  fclose(file);
  CHECK(lines == 3u * dapple_preset_count());
  printf("%u textures\n", lines);
}

/* A refusal: its status, its column, a part of its reason; and the texture stays as it was. */
static void refused(const char* text, dapple_domain domain, size_t bytes, dapple_status status, unsigned column,
                    const char* reason) {
  static uint8_t memory[4096];
  dapple_texture texture, before;
  dapple_trouble trouble;
  dapple_need need;
  memset(&texture, 0x5a, sizeof texture);
  memcpy(&before, &texture, sizeof texture);
  memset(&trouble, 0x5a, sizeof trouble);
  const dapple_status answer = dapple_begin(&texture, text, domain, 1, bytes > 0 ? memory : NULL, bytes, &trouble);
  if (answer != status || trouble.status != status || trouble.column != column ||
      strstr(trouble.reason, reason) == NULL) {
    printf("'%.60s': %d (column %u): %s\n  instead of %d (column %u): %s\n", text != NULL ? text : "null", (int)answer,
           (unsigned)trouble.column, trouble.reason, (int)status, column, reason);
    ++failures;
  }
  CHECK(strlen(trouble.reason) > 0 && strlen(trouble.reason) < DAPPLE_REASON);
  CHECK(memcmp(&before, &texture, sizeof texture) == 0);
  CHECK(dapple_begin(&texture, text, domain, 1, bytes > 0 ? memory : NULL, bytes, NULL) == status);
  if (status == DAPPLE_TOO_LITTLE_MEMORY) return;
  CHECK(dapple_bytes_for(text, domain) == 0);
  CHECK(dapple_need_for(text, domain, &need, NULL) == status && need.status == status && need.bytes == 0);
}

static void check_text_errors(void) {
  const dapple_domain tile = dapple_torus(64, 64);
  static char endless[5000];
  const size_t some = 4096;
  refused("zebbra", tile, some, DAPPLE_UNKNOWN_WORD, 1, "'zebbra' is no preset and no model");
  refused("  zebbra wavelength=3", tile, some, DAPPLE_UNKNOWN_WORD, 3, "'zebbra'");
  refused("", tile, some, DAPPLE_UNKNOWN_WORD, 1, "no preset");
  refused(NULL, tile, some, DAPPLE_UNKNOWN_WORD, 1, "no preset");
  refused("wavelength=20", tile, some, DAPPLE_UNKNOWN_WORD, 1, "no preset");
  refused("zebra wavelenth=20", tile, some, DAPPLE_UNKNOWN_WORD, 7, "'wavelenth' is not a key of threshold");
  refused("zebra  scale=20", tile, some, DAPPLE_OUT_OF_RANGE, 14, "'20' is out of range: ");
  refused("zebra wavelength=400", tile, some, DAPPLE_OUT_OF_RANGE, 7, "the wavelength");
  refused("zebra rho=abc", tile, some, DAPPLE_BROKEN_TEXT, 11, "'abc'");
  refused("zebra rho=", tile, some, DAPPLE_BROKEN_TEXT, 11, "a value is missing");
  refused("zebra rho=0 stripes", tile, some, DAPPLE_BROKEN_TEXT, 13, "'stripes' is not key=value");
  refused("zebra gray-scott", tile, some, DAPPLE_NOT_POSSIBLE, 7, "model");
  refused("zebra ramp=rainbow", tile, some, DAPPLE_UNKNOWN_WORD, 12, "'rainbow' is not one of");
  refused("zebra rho=0 then jump", tile, some, DAPPLE_UNKNOWN_WORD, 18, "carry|refine|freeze|reset");
  refused("zebra fine=3", tile, some, DAPPLE_NOT_POSSIBLE, 7, "does not go");
  refused("zebra \xc3\xa4=1", tile, some, DAPPLE_UNKNOWN_WORD, 7, "'\?\?' is not a key");
  refused("gray-scott feed=2", tile, some, DAPPLE_OUT_OF_RANGE, 17, "'2' is out of range");
  refused("threshold diffusion=slow", tile, some, DAPPLE_UNKNOWN_WORD, 21, "oriented|isotropic");
  refused("a-name-of-far-more-than-thirty-two-characters", tile, some, DAPPLE_UNKNOWN_WORD, 1, "...'");
  memset(endless, ' ', sizeof endless - 1);
  refused(endless, tile, some, DAPPLE_BROKEN_TEXT, 4000, "too long");
}

static void check_domain_errors(void) {
  const size_t some = 4096;
  char bytes[64];
  dapple_domain torus = dapple_torus(64, 64);
  refused("zebra", dapple_torus(64, 7), some, DAPPLE_BAD_SIDE, 0, "8 to 65535");
  refused("zebra", dapple_torus(0, 0), some, DAPPLE_BAD_SIDE, 0, "8 to 65535");
  refused("zebra", dapple_torus(32, 32), some, DAPPLE_TILE_TOO_SMALL, 0, "at least 34 x 34 cells");
  refused("brain", dapple_torus(97, 100), some, DAPPLE_NOT_A_MULTIPLE, 0, "multiples of 4");
  refused("zebra level=1", torus, some, DAPPLE_BAD_RECIPE, 0, "finest grid");
  refused("mitosis", dapple_window(0, 0, 64, 64), some, DAPPLE_HALO_TOO_WIDE, 0, "the most are 1024");
  refused("zebra-bits", dapple_window(INT32_MAX, 0, 64, 64), some, DAPPLE_TOO_FAR, 0, "2^30");
  refused("zebra-bits", dapple_window(0, INT32_MIN, 64, 64), some, DAPPLE_TOO_FAR, 0, "2^30");
  refused("zebra-bits", dapple_window(0, 0, 65535, 64), some, DAPPLE_TOO_LARGE, 0, "65000");
  sprintf(bytes, "needs %lu bytes", (unsigned long)dapple_bytes_for("zebra", torus));
  refused("zebra", torus, some, DAPPLE_TOO_LITTLE_MEMORY, 0, bytes);
  refused("zebra", torus, 0, DAPPLE_TOO_LITTLE_MEMORY, 0, bytes);
}

/* A failed begin leaves a texture on its way alone. */
static void check_begin_again(void) {
  dapple_texture texture;
  dapple_trouble trouble;
  char before[DAPPLE_LINE], after[DAPPLE_LINE];
  uint64_t field, rows;
  void* memory = begun(&texture, "reptile steps=4", dapple_torus(64, 48), 5);
  if (memory == NULL) return;
  finish(&texture, 100);
  field = field_hash(&texture);
  rows = dapple_rows_done(&texture);
  CHECK(rows == dapple_rows_in_all(&texture) && rows > 0);
  CHECK(dapple_recipe_of(&texture, before, sizeof before) == strlen(before));
  CHECK(dapple_begin(&texture, "zebra", dapple_torus(64, 64), 5, memory, 10, &trouble) == DAPPLE_TOO_LITTLE_MEMORY);
  dapple_recipe_of(&texture, after, sizeof after);
  CHECK(strcmp(before, after) == 0 && field_hash(&texture) == field && dapple_rows_done(&texture) == rows);
  CHECK(dapple_step(&texture, 1) == DAPPLE_DONE);
  free(memory);
}

/* The place of a torus is not read, whatever stands there. */
static void check_placed_torus(void) {
  dapple_texture texture;
  dapple_domain domain = dapple_torus(48, 48);
  uint64_t hash[2];
  int i;
  for (i = 0; i < 2; ++i) {
    void* memory = begun(&texture, "zebra-bits", domain, 5);
    if (memory == NULL) return;
    finish(&texture, 100);
    hash[i] = colour_hash(&texture);
    CHECK(dapple_domain_of(&texture).x == 0 && dapple_domain_of(&texture).y == 0);
    free(memory);
    domain.x = INT32_MAX;
    domain.y = INT32_MIN;
  }
  CHECK(hash[0] == hash[1]);
}

/* Two textures step by turns and come out as each alone does. */
static void check_two_at_once(void) {
  const char* const text[2] = {"zebra-bits", "gray-scott steps=60"};
  const dapple_domain domain[2] = {dapple_window(-70, 1000, 40, 24), dapple_torus(72, 80)};
  uint64_t alone[2];
  dapple_texture texture[2], single;
  void* memory[2];
  dapple_status first;
  int i, turns = 0;
  for (i = 0; i < 2; ++i) {
    memory[i] = begun(&single, text[i], domain[i], 3);
    if (memory[i] == NULL) return;
    finish(&single, UINT32_MAX);
    alone[i] = colour_hash(&single);
    free(memory[i]);
  }
  for (i = 0; i < 2; ++i) memory[i] = begun(&texture[i], text[i], domain[i], 3);
  do {
    first = dapple_step(&texture[0], 7);
    ++turns;
  } while (dapple_step(&texture[1], 31) == DAPPLE_MORE || first == DAPPLE_MORE);
  CHECK(turns > 2);
  for (i = 0; i < 2; ++i) {
    CHECK(colour_hash(&texture[i]) == alone[i]);
    CHECK(dapple_domain_of(&texture[i]).x == domain[i].x && dapple_domain_of(&texture[i]).plane == domain[i].plane);
    free(memory[i]);
  }
}

/* What recipe_line writes grows the same, whole or from a preset with changes; short buffers are kept. */
static void check_recipe_line(void) {
  char line[DAPPLE_LINE], again[DAPPLE_LINE], few[8] = "#######";
  dapple_trouble trouble;
  uint64_t hash[2];
  int i;
  const size_t length = dapple_recipe_line("zebra  angle=20 ramp=ink", line, sizeof line, &trouble);
  CHECK(length == strlen(line) && length > 40 && trouble.status == DAPPLE_OK && trouble.reason[0] == 0);
  CHECK(dapple_recipe_line(line, again, sizeof again, NULL) == length && strcmp(line, again) == 0);
  CHECK(dapple_recipe_line(line, few, 5, NULL) == length && strcmp(few, "thre") == 0 && few[5] == '#');
  CHECK(dapple_recipe_line(line, NULL, 0, NULL) == length);
  CHECK(dapple_recipe_line("zebra angle=x", line + length, 1, &trouble) == 0 && trouble.column == 13);
  for (i = 0; i < 2; ++i) {
    dapple_texture texture;
    void* memory = begun(&texture, i == 0 ? "zebra angle=20 ramp=ink" : line, dapple_torus(64, 64), 9);
    if (memory == NULL) return;
    finish(&texture, 50);
    hash[i] = colour_hash(&texture);
    free(memory);
  }
  CHECK(hash[0] == hash[1]);
}

static void check_presets(void) {
  char name[DAPPLE_NAME], few[4];
  uint16_t i;
  for (i = 0; i < dapple_preset_count(); ++i) {
    CHECK(dapple_preset_name(i, name, sizeof name) == strlen(name) && strlen(name) > 0);
    CHECK(dapple_preset_sentence(i) != NULL && strlen(dapple_preset_sentence(i)) > 5);
    CHECK(dapple_bytes_for(name, dapple_torus(128, 128)) > 0);
  }
  CHECK(dapple_preset_name(0, few, sizeof few) == strlen("reptile") && strcmp(few, "rep") == 0);
  CHECK(dapple_preset_name(dapple_preset_count(), name, sizeof name) == 0 && name[0] == 0);
  CHECK(dapple_preset_sentence(dapple_preset_count()) == NULL);
  CHECK(dapple_bytes_for("twisty_maze", dapple_torus(128, 128)) ==
        dapple_bytes_for("twisty-maze", dapple_torus(128, 128)));
}

/* Every format and view has bytes of its own; what is none writes nothing. */
static void check_paint(void) {
  uint64_t seen[2 * 10 + 8];
  unsigned count = 0, i, format, view;
  uint8_t row[8] = {0};
  dapple_texture texture;
  dapple_brush brush;
  void* memory = begun(&texture, "maze steps=12 opacity=0.2,0.8", dapple_torus(48, 40), 11);
  if (memory == NULL) return;
  finish(&texture, 64);
  memset(&brush, 0, sizeof brush);
  for (format = 0; format < 10; ++format) {
    brush.format = (dapple_pixels)format;
    brush.view = format > 7 ? DAPPLE_HEIGHT : DAPPLE_COLOUR; /* 257 times eight bits has two equal bytes */
    for (brush.dither = 0; brush.dither < (format < 3 || format > 7 ? 1 : 2); ++brush.dither)
      seen[count++] = pixels_hash(&texture, &brush);
  }
  brush.format = DAPPLE_RGB888;
  brush.dither = 0;
  for (view = 1; view < 7; ++view) {
    brush.view = (dapple_view)view;
    seen[count++] = pixels_hash(&texture, &brush);
  }
  brush.view = DAPPLE_NORMAL;
  brush.y_down = 1;
  seen[count++] = pixels_hash(&texture, &brush);
  brush.view = DAPPLE_COLOUR;
  brush.unlit = 1;
  seen[count++] = pixels_hash(&texture, &brush);
  for (i = 0; i < count; ++i)
    for (format = 0; format < i; ++format) CHECK(seen[i] != seen[format]);
  CHECK(dapple_paint(&texture, 40, DAPPLE_L8, row) == 0 && dapple_row(&texture, 40, (int16_t*)(void*)row) == 0);
  CHECK(dapple_paint(&texture, 0, (dapple_pixels)10, row) == 0 && dapple_pixel_bytes((dapple_pixels)10, 9) == 0);
  brush.view = (dapple_view)7;
  CHECK(dapple_paint_with(&texture, 0, &brush, row) == 0 && row[0] == 0);
  CHECK(dapple_unit(&texture) > 0 && dapple_cell_level(&texture) < dapple_unit(&texture));
  free(memory);
}

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  CHECK(dapple_version() == DAPPLE_VERSION);
  check_text_errors();
  check_domain_errors();
  check_begin_again();
  check_placed_torus();
  check_two_at_once();
  check_recipe_line();
  check_presets();
  check_paint();
  if (strcmp(argv[1], "--errors") != 0) check_goldens(argv[1]);
  if (failures > 0) printf("%d failures\n", failures);
  return failures > 0;
}
