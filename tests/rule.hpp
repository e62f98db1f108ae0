// What the tests of the command rule share.
// SPDX-License-Identifier: MIT
#pragma once
#include "../tools/dapple/rule_torus.hpp"

namespace tests {

// The programs that copy one of the five cells.
constexpr uint32_t kLeft = 0xffff0000, kRight = 0xff00ff00, kUpper = 0xf0f0f0f0, kLower = 0xcccccccc,
                   kSelf = 0xaaaaaaaa;

inline cli::Torus noise(uint16_t width, uint16_t height, uint32_t seed) {
  cli::Torus torus(width, height);
  torus.noise(seed);
  return torus;
}

// The definition of a step, cell by cell.
inline cli::Torus stepped(const cli::Torus& torus, uint32_t program) {
  const int width = torus.width(), height = torus.height();
  const auto at = [&](int x, int y) {
    return torus.get(static_cast<uint16_t>((x + width) % width), static_cast<uint16_t>((y + height) % height));
  };
  cli::Torus next(torus.width(), torus.height());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const unsigned k = 16u * at(x - 1, y) + 8u * at(x + 1, y) + 4u * at(x, y - 1) + 2u * at(x, y + 1) + at(x, y);
      next.set(static_cast<uint16_t>(x), static_cast<uint16_t>(y), (program >> k & 1) != 0);
    }
  return next;
}

}  // namespace tests
