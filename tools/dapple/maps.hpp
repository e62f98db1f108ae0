// The maps of a material: height, normal, colour, opacity, roughness, and their mip levels.
// SPDX-License-Identifier: MIT
#pragma once
#include "tile.hpp"

namespace cli {

// Refuses options that have no say in maps, before any work.
void check_maps(const Options& options);

// Grows the subject and writes its maps.
void grow_maps(Subject subject, const Options& options);

// FOLDER/NAME_height.png and so on, with --mips also NAME_height.1.png and on down to one pixel: all files or none.
class MapFiles {
 public:
  // Fails here, before any work, when a file cannot be written.
  MapFiles(const std::string& name, const Options& options);
  void write(dapple::Texture& texture);

 private:
  Folder folder_;
  int last_;  // level
  bool flip_y_;
  std::vector<std::unique_ptr<Output>> files_;  // map by map, level by level
};

}  // namespace cli
