/* dapple grows seamless organic textures from a line of text and a 32-bit seed, in integers only: the same bytes on
   every machine. This is its C99 face; README.md beside it has an example, the README.md at the top is the manual.

   A texture is a struct of yours and memory of yours; both are all there is: no heap, no globals, no floating point.
   Any call can stop after any row. Two textures never share anything, so each may have a thread of its own; one texture
   is for one thread at a time.

   Text. Wherever a `text` is asked for it is one of
     "zebra"                              a preset, '-' and '_' alike
     "zebra wavelength=20 angle=30"       a preset and what to change of it
     "gray-scott feed=0.03 kill=0.06"     a whole recipe, a model and its numbers
   in at most 3999 characters. It is read during the call and not kept. Null is as good as "", and refused.

   SPDX-License-Identifier: MIT */
#ifndef DAPPLE_H
#define DAPPLE_H

#include <stddef.h>
#include <stdint.h>

/* Before every function; define it for a shared library's export or import. */
#ifndef DAPPLE_API
#define DAPPLE_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* major * 10000 + minor * 100 + patch, of this header; and of the library that was linked. */
#define DAPPLE_VERSION 100
DAPPLE_API int32_t dapple_version(void);

/* What calls answer; errors are negative. Enumerations are passed as numbers of one size, whatever the compiler's enums
   are, and what is none of them is refused. */
typedef int dapple_status;
enum dapple_status_values {
  DAPPLE_OK = 0,
  DAPPLE_MORE = 1, /* step: call again */
  DAPPLE_DONE = 2, /* step: the texture is complete */

  /* about text: dapple_trouble has the column */
  DAPPLE_UNKNOWN_WORD = -1, /* no such preset, model, key, word or ramp */
  DAPPLE_OUT_OF_RANGE = -2, /* a number outside its range */
  DAPPLE_BROKEN_TEXT = -3,  /* not a number, a missing '=', text without an end */
  DAPPLE_NOT_POSSIBLE = -4, /* words that exclude each other */

  /* about the domain and the memory: dapple_need says what was wanted */
  DAPPLE_BAD_RECIPE = -10,        /* stages that do not fit each other */
  DAPPLE_BAD_SIDE = -11,          /* a side below 8 cells */
  DAPPLE_NOT_A_MULTIPLE = -12,    /* a side that the recipe's coarsest grid does not divide */
  DAPPLE_TILE_TOO_SMALL = -13,    /* a side below what the pattern needs */
  DAPPLE_TOO_LARGE = -14,         /* the texture does not fit the address space */
  DAPPLE_TOO_LITTLE_MEMORY = -15, /* fewer bytes than needed, or null */
  DAPPLE_TOO_FAR = -17,           /* a window more than 2^30 - 2048 cells from the origin */
  DAPPLE_HALO_TOO_WIDE = -18,     /* a window whose recipe runs too long for the plane: take a torus */
  DAPPLE_BAD_MAP = -19,           /* map=image, solver=styled or pictured, which take images from C++ */
  DAPPLE_BAD_SIDES = -21,         /* a recipe with sides=, which takes a patch from C++ */
  DAPPLE_BAD_SURFACE = -22,       /* solver=surface, which takes a surface from C++ */
  DAPPLE_UNSTABLE = -23,          /* numbers with which steps diverge, or too small for their grid; text: see the reason */
  DAPPLE_NO_COVERAGE = -24        /* coverage= of a window: it is a share of a whole tile */
};

/* Where and why something was refused. */
#define DAPPLE_REASON 160
typedef struct dapple_trouble {
  dapple_status status;
  uint16_t column;            /* of the text, 1 is its first character; 0: it is not about the text */
  char reason[DAPPLE_REASON]; /* one sentence in English without a full stop, terminated; "" with DAPPLE_OK */
} dapple_trouble;

/* Where a texture lives, in cells, which are the pixels of the picture. Sides are from 8 to 65535. */
typedef struct dapple_domain {
  uint16_t width, height;
  int32_t x, y;  /* a window's cell (0, 0) in the plane; of a torus they are not read */
  uint8_t plane; /* 0: a torus, which tiles without a seam; 1: a window of the endless plane */
} dapple_domain;

static inline dapple_domain dapple_torus(uint16_t width, uint16_t height) {
  dapple_domain domain;
  domain.width = width;
  domain.height = height;
  domain.x = domain.y = 0;
  domain.plane = 0;
  return domain;
}

/* The cells (x, y) .. (x + width - 1, y + height - 1), the same bytes as in any other window over them; for recipes of
   few steps: the families bits, flow and cells. */
static inline dapple_domain dapple_window(int32_t x, int32_t y, uint16_t width, uint16_t height) {
  dapple_domain domain;
  domain.width = width;
  domain.height = height;
  domain.x = x;
  domain.y = y;
  domain.plane = 1;
  return domain;
}

/* What a recipe needs on a domain. */
typedef struct dapple_need {
  dapple_status status;                /* DAPPLE_OK, or why dapple_begin would refuse it, given memory enough */
  size_t bytes;                        /* of memory in all, at any alignment; 0 when status is not DAPPLE_OK */
  size_t planes, scratch, paint, rest; /* the parts of it, bytes */
  uint16_t width, height;              /* the smallest sides of a torus the pattern fits, cells */
  uint16_t multiple;                   /* a torus's sides must be multiples of this */
  uint16_t reach;                      /* largest distance, cells, of two cells that meet in one sweep */
  uint32_t halo;                       /* cells grown around a window on every side; at most 1024 */
  uint64_t sweeps;                     /* over the grid, in all */
  uint64_t rows;                       /* of work in all: what dapple_step counts */
} dapple_need;

/* Fills need; returns need->status. After an error about the text the numbers are all 0. trouble may be null. */
DAPPLE_API dapple_status dapple_need_for(const char* text, dapple_domain domain, dapple_need* need,
                                         dapple_trouble* trouble);

/* Bytes of memory dapple_begin asks for; 0 for what it refuses. */
DAPPLE_API size_t dapple_bytes_for(const char* text, dapple_domain domain);

/* A texture on its way, with its recipe. Its bytes are the library's own: it may be declared anywhere, but once begun
   it must stay where it is, for parts of it point to others. There is nothing to free. */
#if UINTPTR_MAX > 0xffffffffu
#define DAPPLE_TEXTURE_BYTES 1536
#else
#define DAPPLE_TEXTURE_BYTES 1280
#endif
typedef struct dapple_texture {
  union {
    uint64_t words;
    void* pointer;
    unsigned char bytes[DAPPLE_TEXTURE_BYTES];
  } opaque;
} dapple_texture;

/* Checks everything, then readies the texture; grows nothing yet. Returns DAPPLE_OK or an error; after an error the
   texture is as it was. The memory (`bytes` of it, at any alignment, whatever it holds) stays the caller's; it must
   outlive the texture, and nobody else writes there. trouble may be null. A texture may be begun again at any time.
   The functions below want one that was begun. */
DAPPLE_API dapple_status dapple_begin(dapple_texture* texture, const char* text, dapple_domain domain, uint32_t seed,
                                      void* memory, size_t bytes, dapple_trouble* trouble);

/* Up to `rows` rows of work: DAPPLE_MORE or DAPPLE_DONE, never an error. Whatever the slicing, the same bytes. */
DAPPLE_API dapple_status dapple_step(dapple_texture* texture, uint32_t rows);

/* Rows of work done, from 0 to rows_in_all. */
DAPPLE_API uint64_t dapple_rows_done(const dapple_texture* texture);
DAPPLE_API uint64_t dapple_rows_in_all(const dapple_texture* texture);

/* The domain it was begun with; of a torus x = y = 0. */
DAPPLE_API dapple_domain dapple_domain_of(const dapple_texture* texture);

/* Row y of the field as it stands now, 0 <= y < height, into `out`: width values; 1.0 of the recipe's range=LOW,HIGH is
   dapple_unit(). Returns how many values it wrote: width, or 0 for a y outside. */
DAPPLE_API size_t dapple_row(dapple_texture* texture, uint16_t y, int16_t* out);
DAPPLE_API int16_t dapple_unit(const dapple_texture* texture);
/* A cell is on where the field is above this. */
DAPPLE_API int16_t dapple_cell_level(const dapple_texture* texture);

/* Formats of pixels, named in memory order, byte by byte. */
typedef uint8_t dapple_pixels;
enum dapple_pixels_values {
  DAPPLE_L8 = 0,             /* luminance */
  DAPPLE_RGB888 = 1,         /* red, green, blue */
  DAPPLE_RGBA8888 = 2,       /* red, green, blue, 255 */
  DAPPLE_RGB565 = 3,         /* little-endian 16 bit: gggbbbbb rrrrrggg */
  DAPPLE_RGB565_SWAPPED = 4, /* big-endian 16 bit: rrrrrggg gggbbbbb, what most small panels take */
  DAPPLE_L1_MSB = 5,         /* one bit a pixel, leftmost pixel in bit 7; 1 = light */
  DAPPLE_L1_LSB = 6,         /* one bit a pixel, leftmost pixel in bit 0 */
  DAPPLE_L1_PAGES = 7,       /* one bit a pixel, bytes of eight pixels down: row y sets bit y mod 8 of width bytes and
                                leaves the other bits, so eight rows painted into the same bytes make a page */
  DAPPLE_L16 = 8,            /* little-endian 16 bit luminance; grey views but cells have all 16 bits */
  DAPPLE_L16_SWAPPED = 9     /* big-endian 16 bit luminance: what PNG and PGM hold */
};

typedef uint8_t dapple_view;
enum dapple_view_values {
  DAPPLE_COLOUR = 0, /* ramp, light, gloss, grain */
  DAPPLE_FIELD = 1,  /* grey: the recipe's range to 0..255 */
  DAPPLE_CELLS = 2,  /* white where the field is above dapple_cell_level */
  DAPPLE_HEIGHT = 3, /* grey over twice the range about its middle, so that peaks are not clipped */
  DAPPLE_NORMAL = 4, /* tangent-space normal map: x right, y up, z out of the picture, each 128 + 127 n */
  DAPPLE_OPACITY = 5,  /* grey: the range to the recipe's opacity=LOW,HIGH; 255 is opaque */
  DAPPLE_ROUGHNESS = 6 /* grey: the range to the recipe's roughness=LOW,HIGH; 255 is matt */
};

/* How a row is painted; all zero is DAPPLE_COLOUR as DAPPLE_L8. */
typedef struct dapple_brush {
  dapple_view view;
  dapple_pixels format;
  uint8_t dither; /* 1: ordered 8 x 8, for the formats of less than eight bits a channel */
  uint8_t y_down; /* 1: normal maps with green pointing down */
  uint8_t unlit;  /* 1: colours without light and gloss: what a renderer lights itself */
} dapple_brush;

/* Bytes a row of `width` pixels takes (of a page of eight rows for DAPPLE_L1_PAGES); 0 for what is no format. */
DAPPLE_API size_t dapple_pixel_bytes(dapple_pixels format, uint16_t width);

/* Row y as pixels, as it stands now, in colour or as the brush says, into `out`: dapple_pixel_bytes(format, width)
   bytes. Returns that number, or 0, with nothing written, for a y, format or view outside. At any time; what grows is
   not changed by it. */
DAPPLE_API size_t dapple_paint(dapple_texture* texture, uint16_t y, dapple_pixels format, void* out);
DAPPLE_API size_t dapple_paint_with(dapple_texture* texture, uint16_t y, const dapple_brush* brush, void* out);

/* The presets, 0 <= index < dapple_preset_count(). */
DAPPLE_API uint16_t dapple_preset_count(void);
/* Writes at most `size` bytes of the name, with hyphens and terminated, and returns the length it has, at most
   DAPPLE_NAME - 1; 0 for an index outside. */
#define DAPPLE_NAME 32
DAPPLE_API size_t dapple_preset_name(uint16_t index, char* name, size_t size);
/* What it shows, a constant of the library's; null for an index outside. */
DAPPLE_API const char* dapple_preset_sentence(uint16_t index);

/* The recipe's line with every number spelt out, which as a text grows the same bytes: of a texture that was begun, and
   of a text. Writes at most `size` bytes to `line`, terminated (with size 0 nothing, and line may be null), and returns
   the length it has; 0 and "" for a text that is refused. DAPPLE_LINE bytes hold any. */
#define DAPPLE_LINE 4000
DAPPLE_API size_t dapple_recipe_of(const dapple_texture* texture, char* line, size_t size);
DAPPLE_API size_t dapple_recipe_line(const char* text, char* line, size_t size, dapple_trouble* trouble);

#ifdef __cplusplus
}
#endif

#endif
