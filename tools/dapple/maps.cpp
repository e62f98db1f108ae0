// The maps of a material: height, normal, colour, opacity, roughness, and their mip levels.
// SPDX-License-Identifier: MIT
#include "maps.hpp"

#include <cstring>

#include "errors.hpp"

namespace cli {

using dapple::Pixels;
using dapple::View;

namespace {

struct Map {
  const char* name;
  dapple::Brush brush;
};

// Heights have sixteen bits, because eight show as terraces; colours are unlit, because what shows them lights them.
std::vector<Map> maps_of(bool flip_y) {
  return {{"height", {View::height, Pixels::l16_swapped}},
          {"normal", {View::normal, Pixels::rgb888, false, flip_y}},
          {"colour", {View::colour, Pixels::rgb888, false, false, true}},
          {"opacity", {View::opacity, Pixels::l8}},
          {"roughness", {View::roughness, Pixels::l8}}};
}

// A map or one of its levels, in memory.
struct Level {
  dapple::Mip mip;
  std::vector<uint8_t> pixels;

  explicit Level(const dapple::Mip& m) : mip(m), pixels(line() * m.height) {}
  size_t line() const { return dapple::pixel_bytes(mip.format, mip.width); }
  uint8_t* row(uint32_t y) { return pixels.data() + line() * y; }
};

Level below(Level& level) {
  Level next(mip_below(level.mip));
  for (uint16_t y = 0; y < next.mip.height; ++y) {
    const uint8_t* rows[3] = {};
    for (uint8_t k = 0; k < dapple::mip_rows(level.mip.height); ++k) rows[k] = level.row(2u * y + k);
    dapple::mip_row(level.mip, rows, y, next.row(y));
  }
  return next;
}

void write_level(Level& level, Output& out) {
  Picture picture;
  picture.width = level.mip.width;
  picture.height = level.mip.height;
  picture.pixels = level.mip.format;
  picture.row = [&level](uint16_t y, uint8_t* to) { std::memcpy(to, level.row(y), level.line()); };
  Lines lines(picture, level.mip.format, false);
  write_picture(lines, Format::png, out);
}

// Every row of every map, a row at a time for all of them.
std::vector<Level> painted(dapple::Texture& texture, const std::vector<Map>& maps) {
  const dapple::Domain domain = texture.domain();
  std::vector<Level> levels;
  std::vector<dapple::Layer> layers;
  for (const Map& map : maps) {
    levels.emplace_back(dapple::Mip{map.brush.format, map.brush.view == View::normal, domain.width, domain.height});
    layers.push_back({map.brush, nullptr});
  }
  for (uint16_t y = 0; y < domain.height; ++y) {
    for (size_t i = 0; i < layers.size(); ++i) layers[i].row = levels[i].row(y);
    texture.paint(y, layers.data(), static_cast<uint8_t>(layers.size()));
  }
  return levels;
}

}  // namespace

void check_maps(const Options& options) {
  if (options.mips && options.maps.empty()) refuse("--mips is for --maps only");
  if (options.maps.empty()) return;
  const bool pixels = options.pixels.has_value() || options.dither;
  const char* const other = !options.output.empty()            ? "-o"
                            : options.format                   ? "--format"
                            : options.view != View::colour     ? "--view"
                            : pixels                           ? "--pixels and --dither"
                            : options.repeat                   ? "--repeat"
                            : options.hash                     ? "--hash"
                                                               : nullptr;
  if (other != nullptr)
    refuse(std::string("--maps writes five files of their own formats; ") + other + " is for one picture");
}

MapFiles::MapFiles(const std::string& name, const Options& options)
    : folder_(options.maps),
      last_(options.mips ? dapple::mip_levels(options.width, options.height) : 0),
      flip_y_(options.flip_y) {
  for (const Map& map : maps_of(flip_y_))
    for (int k = 0; k <= last_; ++k) {
      const std::string level = k > 0 ? "." + std::to_string(k) : "";
      files_.push_back(std::make_unique<Output>(folder_.file(name + "_" + map.name + level + ".png")));
    }
}

void MapFiles::write(dapple::Texture& texture) {
  size_t file = 0;
  std::vector<Level> levels = painted(texture, maps_of(flip_y_));
  for (Level& level : levels)
    for (int k = 0; k <= last_; ++k) {
      if (k > 0) level = below(level);
      write_level(level, *files_[file++]);
    }
  Output::finish_all(files_);
  folder_.keep();
}

}  // namespace cli
