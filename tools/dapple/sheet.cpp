// dapple sheet: every preset in one picture, six a row, with its name below.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstring>

#include "commands.hpp"
#include "errors.hpp"
#include "font.hpp"
#include "tile.hpp"

namespace cli {

namespace {

constexpr uint32_t kColumns = 6, kGap = 8;
constexpr uint32_t kLabel = kGap / 2 + kLetterHeight;  // below a tile
constexpr uint8_t kPaper = 24, kInk = 208;

// Pixels of the whole sheet.
struct Sheet {
  uint32_t width, height, columns;
  std::vector<uint8_t> rgb;

  uint8_t* at(uint32_t x, uint32_t y) { return rgb.data() + 3 * (size_t{width} * y + x); }
};

Sheet empty_sheet(const Options& options) {
  Sheet sheet{};
  const uint32_t count = dapple::preset_count();
  sheet.columns = std::min(kColumns, count);
  const uint32_t rows = (count + sheet.columns - 1) / sheet.columns;
  sheet.width = kGap + sheet.columns * (options.width + kGap);
  sheet.height = kGap + rows * (options.height + kLabel + kGap);
  if (sheet.width > UINT16_MAX || sheet.height > UINT16_MAX)
    refuse("--size " + size_text(options.width, options.height) + ": the sheet would have " +
           size_text(sheet.width, sheet.height) + " pixels; 65535 a side are the most");
  sheet.rgb.assign(size_t{3} * sheet.width * sheet.height, kPaper);
  return sheet;
}

void write_label(Sheet& sheet, const std::string& name, uint32_t x, uint32_t y, uint32_t width) {
  for (size_t i = 0; i < name.size() && (i + 1) * kLetterWidth <= width + 1; ++i)
    for (uint32_t column = 0; column < 5; ++column)
      for (uint32_t row = 0; row < kLetterHeight; ++row)
        if (columns_of(name[i])[column] >> row & 1)
          std::memset(sheet.at(x + static_cast<uint32_t>(i) * kLetterWidth + column, y + row), kInk, 3);
}

void add_tile(Sheet& sheet, uint32_t index, Tile& tile, const std::string& name, const Options& options) {
  const uint32_t left = kGap + index % sheet.columns * (options.width + kGap);
  const uint32_t top = kGap + index / sheet.columns * (options.height + kLabel + kGap);
  dapple::Brush brush;
  brush.view = options.view;
  brush.format = dapple::Pixels::rgb888;
  brush.y_down = options.flip_y;
  for (uint16_t y = 0; y < options.height; ++y) tile.texture().paint(y, brush, sheet.at(left, top + y));
  write_label(sheet, name, left, top + options.height + kGap / 2, options.width);
}

std::vector<Subject> subjects() {
  std::vector<Subject> all;
  for (uint16_t i = 0; i < dapple::preset_count(); ++i) {
    char name[dapple::kMaxName];
    const dapple::PresetEntry entry = dapple::preset_at(i, name);
    all.push_back({entry.name, entry.sentence, dapple::load(*entry.preset)});
  }
  return all;
}

}  // namespace

void sheet(const Options& options) {
  const Target target = target_of(options, "sheet");
  const dapple::Domain domain = dapple::torus(options.width, options.height);
  const std::vector<Subject> all = subjects();
  for (const Subject& subject : all) need_of(subject, domain, 1);
  Sheet pixels = empty_sheet(options);
  Output out(target.path);
  Progress progress;
  for (uint32_t i = 0; i < all.size(); ++i) {
    Tile tile(all[i], domain, options.seed);
    tile.grow(options.budget, progress);
    add_tile(pixels, i, tile, all[i].name, options);
  }
  Picture picture;
  picture.width = static_cast<uint16_t>(pixels.width);
  picture.height = static_cast<uint16_t>(pixels.height);
  picture.row = [&](uint16_t y, uint8_t* rgb) { std::memcpy(rgb, pixels.at(0, y), size_t{3} * pixels.width); };
  picture.name = "sheet";
  picture.note = "Every preset, seed " + std::to_string(options.seed) + ", dapple " + version_text();
  Lines lines(picture, target.pixels, options.dither);
  write_picture(lines, target.format, out);
  out.finish();
}

}  // namespace cli
