// From rows of the field to rows of pixels: ramp, slope light, gloss, grain; views, the maps of a material among them
// (Witkin & Kass 1991, 1 and 6: displacement, colour, opacity, specularity); pixel formats; ordered dither.
// SPDX-License-Identifier: MIT
#pragma once
#include "../grid/rows.hpp"

namespace dapple {

// A colour ramp: up to eight stops, `at` rising from 0 to 255; linear between them.
struct Stop {
  uint8_t at, red, green, blue;
};
constexpr uint8_t kMaxStops = 8;
struct Ramp {
  uint8_t count;
  Stop stop[kMaxStops];
};

// How a recipe paints its field. low and high are in the recipe's units (k/b, concentration), 1/kMicro: the ramp maps
// this range, fixed per recipe and never measured on a tile, so that neighbouring tiles match.
struct Paint {
  Ramp ramp;
  int32_t low, high;
  int32_t light;  // slope light: a slope of the whole range over one cell is a gradient of `light`; 0: flat
  int32_t gloss;  // strength of the highlight, 0..1
  int32_t grain;  // noise of the brightness, 0..1
  uint8_t opacity[2] = {0, 255};      // at low and at high, 1/255, linear between them: 255 is opaque
  uint8_t roughness[2] = {204, 102};  // the same: 0 is a mirror, 255 is matt; low ground is rougher than what wears
};

constexpr bool in_range(const Paint& p) { return p.ramp.count >= 1 && p.ramp.count <= kMaxStops && p.low < p.high; }

enum class View : uint8_t {
  colour,  // ramp, light, gloss, grain
  field,   // grey: low..high to 0..255
  cells,   // white where the field is above the model's level
  height,  // grey over twice the range about its middle, so that peaks are not clipped
  normal,  // tangent-space normal map: x right, y up, z out of the picture, each 128 + 127 n
  opacity,    // grey: low..high to the paint's opacity, 255 opaque
  roughness,  // grey: low..high to the paint's roughness, 255 matt
};

// Named in memory order, byte by byte.
enum class Pixels : uint8_t {
  l8,              // luminance
  rgb888,          // red, green, blue
  rgba8888,        // red, green, blue, 255
  rgb565,          // little-endian 16 bit: gggbbbbb rrrrrggg
  rgb565_swapped,  // big-endian 16 bit:    rrrrrggg gggbbbbb, what most small panels take
  l1_msb,          // one bit a pixel, rows, leftmost pixel in bit 7; 1 = light
  l1_lsb,          // one bit a pixel, rows, leftmost pixel in bit 0
  l1_pages,        // one bit a pixel, bytes of eight pixels down, top pixel in bit 0: row y sets bit y mod 8 of width
                   // bytes and leaves the other bits, so eight rows painted into the same bytes make a page
  l16,             // little-endian 16 bit luminance; grey views but cells have all 16 bits, colours 257 times their eight
  l16_swapped,     // big-endian 16 bit luminance: what PNG and PGM hold
};

// Bytes one row of `width` pixels takes (of a page of eight rows for l1_pages).
constexpr size_t pixel_bytes(Pixels format, uint16_t width) {
  const size_t w = width;
  switch (format) {
    case Pixels::l8: return w;
    case Pixels::rgb888: return 3 * w;
    case Pixels::rgba8888: return 4 * w;
    case Pixels::rgb565:
    case Pixels::rgb565_swapped: return 2 * w;
    case Pixels::l1_msb:
    case Pixels::l1_lsb: return (w + 7) / 8;
    case Pixels::l1_pages: return w;
    case Pixels::l16:
    case Pixels::l16_swapped: return 2 * w;
  }
  return 0;
}

// How a row is painted, beside the recipe's Paint.
struct Brush {
  View view = View::colour;
  Pixels format = Pixels::rgba8888;
  bool dither = false;       // ordered 8 x 8, for the formats of less than eight bits a channel
  bool y_down = false;       // normal maps with green pointing down
  bool unlit = false;        // colours without light and gloss: what a renderer lights itself
};

// One of several pictures of the same row.
struct Layer {
  Brush brush;
  void* row;  // pixel_bytes(brush.format, width) bytes
};

}  // namespace dapple

namespace dapple::paint {

// Field rows y - 1, y, y + 1 with a halo of one, in model units.
struct Source {
  const int16_t *above, *here, *below;
  uint16_t width, y;
  int32_t world_x, world_y;  // of pixel (0, y), for grain and dither
};

// A ramp from one stop to the next.
struct Stretch {
  uint8_t at, base[3];
  int16_t step[3];  // per 1/256 of the ramp, Q7
};

// A Paint made ready for one field: everything that does not change from pixel to pixel.
struct Shader {
  int32_t low, span;         // field units; span >= 1
  int32_t slope;             // gradient Q8 per field unit of difference over two cells, Q16
  int32_t gloss, grain;      // Q8
  int16_t cell_level;
  uint32_t seed;
  View view;
  bool y_down;
  uint8_t from, to;          // what grey views make of low and high
  uint8_t stops;
  Stretch stretch[kMaxStops];
};
constexpr Shader shader_of(const Paint& paint, const Brush& brush, int16_t unit, int16_t cell_level, uint32_t seed);

// Paints pixels [x, x + count) into rgb[3 * count].
void shade(const Shader& shader, const Source& source, uint16_t x, uint8_t count, uint8_t* rgb);

// Packs rgb pixels from x on into a row of the format.
void pack(const Brush& brush, const Source& source, const uint8_t* rgb, uint16_t x, uint8_t count, uint8_t* row);

// Grey views at 16 bits a pixel, a whole row; which they are.
constexpr bool deep(const Brush& brush) {
  const bool wide = brush.format == Pixels::l16 || brush.format == Pixels::l16_swapped;
  return wide && brush.view != View::colour && brush.view != View::normal && brush.view != View::cells;
}
void shade_deep(const Shader& shader, const Source& source, bool swapped, uint8_t* row);

// A whole row.
void paint_row(const Shader& shader, const Brush& brush, const Source& source, uint8_t* row);

// The same as a row kernel, for ports that have a faster one: in[0] is a Job.
struct Job {
  const Shader* shader;
  const Brush* brush;
  const Source* source;
  uint8_t* row;
};
void job_row(const grid::Rows& rows);

}  // namespace dapple::paint

#include "pixel.hpp"
