// Metric tensors, heights and atlases from files, for dapple surface.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "atlas.hpp"

namespace cli {

// Text: WIDTH HEIGHT [PATCHES], then three decimal numbers a cell, row by row and patch by patch.
struct MetricMap {
  uint16_t width, height;
  uint8_t patches;
  std::vector<dapple::Metric> cells;
};
MetricMap read_metric(const std::string& path);

// A picture's grey as heights in 1/256 of a cell, white `tall` (1/1000000) widths high.
struct HeightMap {
  uint16_t width, height;
  std::vector<int16_t> heights;
};
HeightMap read_heights(const std::string& path, int32_t tall);

// Lines of text; what is not named is closed. Fails for a line it cannot read, and for the first side that does not
// pair up.
std::vector<dapple::Patch> read_atlas(const std::string& path);

}  // namespace cli
