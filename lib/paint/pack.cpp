// Pixel formats, in memory order, and ordered dither.
// SPDX-License-Identifier: MIT
#include "paint.hpp"

namespace dapple::paint {

// Bayer's 8 x 8 threshold at (x, y), 0..63: the bits of x ^ y and y interleaved, highest first.
static uint8_t bayer(uint8_t x, uint8_t y) {
  const uint8_t m = static_cast<uint8_t>(x ^ y);
  return static_cast<uint8_t>(((m & 1) << 5) | ((y & 1) << 4) | ((m & 2) << 2) | ((y & 2) << 1) | ((m & 4) >> 1) | ((y & 4) >> 2));
}

void pack(const Brush& brush, const Source& source, const uint8_t* rgb, uint16_t x, uint8_t count, uint8_t* row) {
  for (uint8_t i = 0; i < count; ++i, ++x, rgb += 3) {
    const uint8_t threshold = bayer(static_cast<uint8_t>((source.world_x + x) & 7), static_cast<uint8_t>(source.world_y & 7));
    put_pixel(brush.format, x, source.y, rgb, brush.dither, threshold, row);
  }
}

void paint_row(const Shader& shader, const Brush& brush, const Source& source, uint8_t* row) {
  if (deep(brush)) return shade_deep(shader, source, brush.format == Pixels::l16_swapped, row);
  constexpr uint8_t kBlock = 16;
  uint8_t rgb[3 * kBlock];
  for (uint32_t x = 0; x < source.width; x += kBlock) {
    const uint32_t left = source.width - x;
    const uint8_t count = static_cast<uint8_t>(left < kBlock ? left : kBlock);
    shade(shader, source, static_cast<uint16_t>(x), count, rgb);
    pack(brush, source, rgb, static_cast<uint16_t>(x), count, row);
  }
}

void job_row(const grid::Rows& rows) {
  const Job& job = *static_cast<const Job*>(rows.in[0]);
  paint_row(*job.shader, *job.brush, *job.source, job.row);
}

}  // namespace dapple::paint
