// dapple tiles: sixteen corner tiles, the sheet of them, a floor laid with them, and how to lay one.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <cstring>

#include "commands.hpp"
#include "corners.hpp"
#include "errors.hpp"
#include "tile.hpp"

namespace cli {

constexpr uint16_t kFloor = 8;  // tiles of the preview, either way

[[noreturn]] static void refuse_recipe(const Subject& subject) {
  const dapple::Recipe& recipe = subject.recipe;
  const std::string no = "corner tiles are not for " + subject.name + ": ";
  for (uint8_t i = 0; i < recipe.stages; ++i) {
    if (recipe.stage[i].model->cell == dapple::grid::Cell::bit)
      refuse(no + "cells of one bit have the endless plane (dapple grow --at X,Y, dapple stream)");
    if (recipe.stage[i].steps == 0) refuse(no + "every stage must have steps");
    if (recipe.stage[i].model->cell != dapple::grid::Cell::int16 ||
        recipe.stage[i].solver->sharing == dapple::evolve::Sharing::none)
      refuse(no + "they are for the threshold family and Gray-Scott");
  }
  refuse(no + "a map says where in the tile a direction is, which differs from tile to tile");
}

static uint32_t rounded_up(uint32_t side, uint32_t multiple) { return (side + multiple - 1) / multiple * multiple; }

// What a tile's side must be and what it must be a multiple of; refuses recipes that have none.
struct Least {
  uint32_t side, multiple;
};
static Least least_of(const Subject& subject, uint16_t side) {
  const dapple::Need need = dapple::need_for(subject.recipe, dapple::corner_tiles(side));
  if (need.status == dapple::no_corners) refuse_recipe(subject);
  const uint32_t multiple = std::max(need.multiple / 4, 1);
  return {rounded_up((need.width + 3u) / 4, multiple), multiple};
}

// By how much the lattice of seeds has to be stretched to fit a tile, 1/1000000, both ways added.
static int64_t misfit(const dapple::Start& start, uint16_t side) {
  const dapple::start::Place tile = {dapple::grid::Cell::int16, side, side, 0, 0, 0, false, 0};
  const dapple::start::DiscGrid discs = dapple::start::disc_grid(start, tile);
  const int64_t across = int64_t{side} * dapple::base::kMicro / discs.columns, down = int64_t{side} * dapple::base::kMicro / discs.rows;
  const int64_t high = int64_t{start.pitch} * start.aspect / dapple::base::kMicro;
  return std::abs(across - start.pitch) * dapple::base::kMicro / start.pitch + std::abs(down - high) * dapple::base::kMicro / high;
}

// Eight wavelengths, and five seeds; up to half as much again where the seeds then fit better.
static uint16_t usual_side(const Subject& subject) {
  const dapple::Recipe& recipe = subject.recipe;
  int64_t wave = 0;
  for (uint8_t i = 0; i < recipe.stages; ++i)
    wave = std::max<int64_t>(wave, recipe.stage[i].model->wavelength(recipe.stage[i].number));
  const bool seeds = recipe.start.kind == dapple::Start::seeds;
  const int64_t wanted = std::max(8 * wave, seeds ? int64_t{5} * recipe.start.pitch : 0) / dapple::base::kMicro;
  const uint32_t step = 16;  // divided by every multiple there is
  const uint32_t first = std::max(rounded_up(static_cast<uint32_t>(wanted), step), step);
  uint32_t best = first;
  for (uint32_t side = first; seeds && side <= first * 3 / 2 && side <= kLargestSheetTile; side += step)
    if (misfit(recipe.start, static_cast<uint16_t>(side)) < misfit(recipe.start, static_cast<uint16_t>(best))) best = side;
  return static_cast<uint16_t>(std::min<uint32_t>(best, kLargestSheetTile));
}

static uint16_t side_of(const Subject& subject, const Options& options) {
  const uint16_t side = options.width != 0 ? options.width : usual_side(subject);
  const Least least = least_of(subject, side);
  const std::string size = "--size " + std::to_string(side);
  if (side % least.multiple != 0)
    refuse(size + ": the tiles of " + subject.name + " must have a multiple of " + std::to_string(least.multiple));
  if (side < least.side)
    refuse(size + " is too small: a tile of " + subject.name + " needs at least " + std::to_string(least.side));
  return side;
}

// The sheet, painted once it is grown.
class Sheet {
 public:
  explicit Sheet(uint16_t side) : side_(side), all_(static_cast<uint16_t>(4 * side)), rgb_(size_t{3} * all_ * all_) {}

  void paint(dapple::Texture& texture, const Options& options) {
    dapple::Brush brush;
    brush.view = options.view;
    brush.format = dapple::Pixels::rgb888;
    brush.y_down = options.flip_y;
    for (uint16_t y = 0; y < all_; ++y) texture.paint(y, brush, rgb_.data() + size_t{3} * all_ * y);
  }

  Picture whole() {
    return picture(all_, [this](uint16_t y, uint8_t* rgb) { std::memcpy(rgb, at(0, y), size_t{3} * all_); });
  }
  Picture tile(uint8_t number) {
    return picture(side_, [this, number](uint16_t y, uint8_t* rgb) { copy_row(number & 3, number >> 2, y, rgb); });
  }
  Picture floor(uint32_t seed) {
    return picture(static_cast<uint16_t>(kFloor * side_), [this, seed](uint16_t y, uint8_t* rgb) {
      for (uint16_t x = 0; x < kFloor; ++x) {
        const dapple::CornerTile tile = dapple::tile_at(seed, x, y / side_);
        copy_row(tile.column, tile.row, static_cast<uint16_t>(y % side_), rgb + size_t{3} * side_ * x);
      }
    });
  }

 private:
  const uint8_t* at(size_t x, size_t y) const { return rgb_.data() + 3 * (all_ * y + x); }
  void copy_row(size_t column, size_t row, uint16_t y, uint8_t* rgb) const {
    std::memcpy(rgb, at(column * side_, row * side_ + y), size_t{3} * side_);
  }
  static Picture picture(uint16_t side, std::function<void(uint16_t, uint8_t*)> row) {
    Picture p;
    p.width = p.height = side;
    p.row = std::move(row);
    return p;
  }

  uint16_t side_, all_;
  std::vector<uint8_t> rgb_;
};

// How to lay a floor, in C, for programs that have the pictures alone.
static std::string laying_text(const std::string& note, uint16_t side) {
  char table[20];
  std::snprintf(table, sizeof table, "%016" PRIx64, dapple::kCornerTable);
  const std::string number = std::to_string(side);
  return note + "\n\nSixteen tiles of " + number + " x " + number +
         " pixels; in the sheet tile t is in column t % 4 and row t / 4. Any two tiles whose common corners have the same\n"
         "colours may meet. tile_at says which one to lay at column x and row y of the floor: a hash of seed and place gives every\n"
         "corner a colour, and a table the tile with four such corners. The preview is the floor of x, y = 0 .. 7 and this seed.\n\n"
         "#include <stdint.h>\n\n"
         "static uint32_t mix(uint32_t h) {\n"
         "  h = (h ^ h >> 16) * UINT32_C(0x7feb352d);\n"
         "  h = (h ^ h >> 15) * UINT32_C(0x846ca68b);\n"
         "  return h ^ h >> 16;\n"
         "}\n\n"
         "static int colour_at(uint32_t seed, int32_t column, int32_t row) {\n"
         "  const uint32_t x = (uint32_t)((column - (column & 1)) / 2), y = (uint32_t)((row - (row & 1)) / 2);\n"
         "  const uint32_t base = mix(seed + UINT32_C(0x9e3779b9) * " + std::to_string(dapple::kCornerStream + 1) + "u);\n"
         "  const uint32_t line = mix(base ^ y * UINT32_C(0x85ebca6b));\n"
         "  uint32_t h = x * UINT32_C(0x9e3779b1) ^ line;\n"
         "  h = (h ^ h >> 16) * UINT32_C(0x7feb352d) + mix(line + base);\n"
         "  h = (h ^ h >> 15) * UINT32_C(0x846ca68b);\n"
         "  return (int)((1 + ((h ^ h >> 16) >> 16) * 14 / 65536) >> ((column & 1) + 2 * (row & 1)) & 1);\n"
         "}\n\n"
         "static int tile_at(uint32_t seed, int32_t column, int32_t row) {\n"
         "  const int32_t right = column == INT32_MAX ? INT32_MIN : column + 1, below = row == INT32_MAX ? INT32_MIN : row + 1;\n"
         "  const int key = colour_at(seed, column, row) | colour_at(seed, right, row) << 1 |\n"
         "                  colour_at(seed, column, below) << 2 | colour_at(seed, right, below) << 3;\n"
         "  return (int)(UINT64_C(0x" + table + ") >> (4 * key) & 15);\n"
         "}\n";
}

static std::string tile_name(uint8_t number) {
  char name[12];
  std::snprintf(name, sizeof name, "tile-%02u", unsigned{number});
  return name;
}

void tiles(const Options& options) {
  const Subject subject = subject_of(options);
  if (options.output == "-") refuse("-o '-': tiles are several files; give a folder");
  const uint16_t side = side_of(subject, options);
  Options file_options = options;
  file_options.output.clear();
  const Target target = target_of(file_options, "tile");
  Tile grown(subject, dapple::corner_tiles(side), options.seed, options.bands);
  Sheet sheet(side);
  std::vector<std::pair<std::string, Picture>> pictures;
  for (uint8_t t = 0; t < 16; ++t) pictures.emplace_back(tile_name(t), sheet.tile(t));
  pictures.emplace_back("sheet", sheet.whole());
  pictures.emplace_back("preview", sheet.floor(options.seed));

  Folder folder(options.output.empty() ? subject.name + "-tiles" : options.output);
  std::vector<std::unique_ptr<Output>> files;
  for (const auto& [name, picture] : pictures) files.push_back(std::make_unique<Output>(folder.file(name + suffix_of(target.format))));
  files.push_back(std::make_unique<Output>(folder.file("tiles.txt")));
  Progress progress;
  grown.grow(options.budget, progress);
  sheet.paint(grown.texture(), options);
  const std::string note = "Corner tiles, seed " + std::to_string(options.seed) + ", dapple " + version_text() + ": " + line_of(subject.recipe);
  for (size_t i = 0; i < pictures.size(); ++i) {
    pictures[i].second.name = pictures[i].first;
    pictures[i].second.note = note;
    Lines lines(pictures[i].second, target.pixels, options.dither);
    write_picture(lines, target.format, *files[i]);
  }
  files.back()->write(laying_text(note, side));
  Output::finish_all(files);
  folder.keep();
}

}  // namespace cli
