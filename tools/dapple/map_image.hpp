// Directions from pictures, for map=@FILE.
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

struct MapImage {
  std::vector<int8_t> pairs;
  dapple::DirectionImage image;
};

// Of a PGM or PPM file; fails where it cannot be read.
std::shared_ptr<const MapImage> read_map(const std::string& path, MapAs as);

}  // namespace cli
