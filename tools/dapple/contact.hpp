// A contact sheet: tiles of one size, six a row, each with its name below.
// SPDX-License-Identifier: MIT
#pragma once
#include "options.hpp"
#include "output.hpp"
#include "tile.hpp"

namespace cli {

class Contact {
 public:
  // Room for `count` tiles of the options' size; refused when a side would be beyond 65535, with `said` behind the size.
  Contact(const Options& options, uint32_t count, const std::string& said = "");

  // The tile as it stands, in the next place.
  void add(Tile& tile, const std::string& label);

  void write(const Target& target, const std::string& name, const std::string& note, Output& out);

 private:
  uint8_t* at(uint32_t x, uint32_t y) { return rgb_.data() + 3 * (size_t{width_} * y + x); }
  void label(const std::string& text, uint32_t x, uint32_t y);

  const Options& options_;
  uint32_t width_, height_, columns_, added_ = 0;
  std::vector<uint8_t> rgb_;
};

}  // namespace cli
