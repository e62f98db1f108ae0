// Pictures that are read: PGM and PPM, and PNG where libpng is.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>

namespace cli {

constexpr uint32_t kLargestPicture = 8192;  // pixels a side

struct Pixmap {
  uint32_t width, height, channels;  // channels: 1 grey, 3 red, green and blue
  std::string bytes;                 // 8 bits a channel, row by row

  // Any place: a tile's picture repeats.
  uint8_t at(int64_t x, int64_t y, uint32_t channel) const {
    const uint64_t column = static_cast<uint64_t>((x % width + width) % width),
                   row = static_cast<uint64_t>((y % height + height) % height);
    return static_cast<uint8_t>(bytes[(row * width + column) * channels + channel]);
  }
  int32_t grey(int64_t x, int64_t y) const {
    return channels == 1 ? at(x, y, 0) : (77 * at(x, y, 0) + 150 * at(x, y, 1) + 29 * at(x, y, 2)) >> 8;
  }
};

// The file's picture; fails, naming the file, where there is none.
Pixmap read_pixmap(const std::string& path);

// Of the bytes of a PNG file, transparent pixels on black. False, with `why`, where they are damaged or a side is not 1 to
// kLargestPicture. Only where libpng is.
bool decode_png(const std::string& bytes, Pixmap& picture, std::string& why);

}  // namespace cli
