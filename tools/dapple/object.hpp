// A shaded picture of a surface with a texture on it: the only place where the command line counts with fractions, and
// nothing is grown of it.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "atlas.hpp"

namespace cli {

// Rows of rgb, `width` pixels each.
struct Raster {
  uint32_t width, height;
  std::vector<uint8_t> rgb;
};

// The textures of all patches from left to right, as they are written.
struct Skin {
  const dapple::Surface& surface;
  const Raster& strip;
  bool round_x, round_y;  // it repeats in the direction
};

// The object in light, its texture as it was grown behind it.
Raster object_picture(const Skin& skin, uint32_t width, uint32_t height);

}  // namespace cli
