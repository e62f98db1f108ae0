// Directions, styles, growth and wavelengths from pictures, for map=@FILE, style=@FILE, growth=@FILE and grade=@FILE.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "stencil/maps.hpp"

namespace cli {

// What a picture says of the directions of stripes.
//   structure  they run along its edges and lines (structure tensor), where it has any
//   values     grey: 0..255 are 0..180 degrees; colour: (red - 128, green - 128) is the doubled direction
enum class MapAs : uint8_t { structure, values };
constexpr const char* kMapAs = "structure|values";

// The bytes that a recipe's stages point to.
struct PictureMaps {
  std::vector<int8_t> pairs;
  std::vector<uint8_t> styles, greys, lengths;
  dapple::PlaceMaps maps{};
};

// Of a picture file (pixmap.hpp); they fail where it cannot be read. Styles are red, green and blue; a grey picture is of
// wavelengths.
void read_map(const std::string& path, MapAs as, PictureMaps& to);
void read_styles(const std::string& path, PictureMaps& to);
void read_growth(const std::string& path, PictureMaps& to);
void read_grade(const std::string& path, PictureMaps& to);

}  // namespace cli
