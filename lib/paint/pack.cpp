// Pixel formats, in memory order, and ordered dither.
// SPDX-License-Identifier: MIT
#include "paint.hpp"

namespace dapple::paint {

// Bayer's 8 x 8 threshold at (x, y), 0..63: the bits of x ^ y and y interleaved, highest first.
static uint8_t bayer(uint8_t x, uint8_t y) {
  const uint8_t m = static_cast<uint8_t>(x ^ y);
  return static_cast<uint8_t>(((m & 1) << 5) | ((y & 1) << 4) | ((m & 2) << 2) | ((y & 2) << 1) | ((m & 4) >> 1) | ((y & 4) >> 2));
}

// luminance == (77 r + 150 g + 29 b) / 256, the weights of Rec. 601.
static uint8_t luminance(const uint8_t* rgb) {
  return static_cast<uint8_t>((77u * rgb[0] + 150u * rgb[1] + 29u * rgb[2] + 128u) >> 8);
}

// To `bits` bits: rounded, or with a threshold 0..63 between neighbouring levels.
static uint16_t reduce(uint8_t value, uint8_t bits, bool dither, uint8_t threshold) {
  const uint16_t levels = static_cast<uint16_t>((1u << bits) - 1u);
  const uint16_t scaled = static_cast<uint16_t>(static_cast<uint16_t>(value) * levels);  // at most 255 * 63
  return static_cast<uint16_t>((scaled + (dither ? (threshold * 4u + 2u) * 255u / 256u : 127u)) / 255u);
}

static void put_565(uint8_t* to, const uint8_t* rgb, bool swapped, bool dither, uint8_t threshold) {
  const uint16_t r = reduce(rgb[0], 5, dither, threshold), g = reduce(rgb[1], 6, dither, threshold),
                 b = reduce(rgb[2], 5, dither, threshold);
  const uint8_t high = static_cast<uint8_t>((r << 3) | (g >> 3)), low = static_cast<uint8_t>((g << 5) | b);
  to[0] = swapped ? high : low;
  to[1] = swapped ? low : high;
}

static void put_one(uint8_t* byte, uint8_t bit, bool on) {
  const uint8_t mask = static_cast<uint8_t>(1u << bit);
  *byte = static_cast<uint8_t>(on ? *byte | mask : *byte & ~mask);
}

void pack(const Brush& brush, const Source& source, const uint8_t* rgb, uint16_t x, uint8_t count, uint8_t* row) {
  for (uint8_t i = 0; i < count; ++i, ++x, rgb += 3) {
    const uint8_t threshold = bayer(static_cast<uint8_t>((source.world_x + x) & 7), static_cast<uint8_t>(source.world_y & 7));
    switch (brush.format) {
      case Pixels::l8: row[x] = luminance(rgb); break;
      case Pixels::rgb888:
        for (uint8_t c = 0; c < 3; ++c) row[3 * static_cast<size_t>(x) + c] = rgb[c];
        break;
      case Pixels::rgba8888:
        for (uint8_t c = 0; c < 3; ++c) row[4 * static_cast<size_t>(x) + c] = rgb[c];
        row[4 * static_cast<size_t>(x) + 3] = 255;
        break;
      case Pixels::rgb565: put_565(row + 2 * static_cast<size_t>(x), rgb, false, brush.dither, threshold); break;
      case Pixels::rgb565_swapped: put_565(row + 2 * static_cast<size_t>(x), rgb, true, brush.dither, threshold); break;
      case Pixels::l1_msb: put_one(row + x / 8, 7 - x % 8, reduce(luminance(rgb), 1, brush.dither, threshold) != 0); break;
      case Pixels::l1_lsb: put_one(row + x / 8, x % 8, reduce(luminance(rgb), 1, brush.dither, threshold) != 0); break;
      case Pixels::l1_pages: put_one(row + x, source.y % 8, reduce(luminance(rgb), 1, brush.dither, threshold) != 0); break;
    }
  }
}

void paint_row(const Shader& shader, const Brush& brush, const Source& source, uint8_t* row) {
  constexpr uint8_t kBlock = 16;
  uint8_t rgb[3 * kBlock];
  for (uint32_t x = 0; x < source.width; x += kBlock) {
    const uint32_t left = source.width - x;
    const uint8_t count = static_cast<uint8_t>(left < kBlock ? left : kBlock);
    shade(shader, source, static_cast<uint16_t>(x), count, rgb);
    pack(brush, source, rgb, static_cast<uint16_t>(x), count, row);
  }
}

}  // namespace dapple::paint
