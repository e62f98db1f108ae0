// dapple rule random: looks for nice programs, prints them, and writes a sheet of them with their numbers.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <cstring>

#include "commands.hpp"
#include "errors.hpp"
#include "font.hpp"
#include "rule.hpp"
#include "rule_map.hpp"
#include "rule_search.hpp"
#include "tile.hpp"

namespace cli {

namespace {

constexpr uint32_t kColumns = 6, kGap = 8;
constexpr uint32_t kLabel = kGap / 2 + kLetterHeight;  // below a tile
constexpr uint8_t kPaper = 24, kInk = 208;
constexpr uint32_t kCount = 24, kSteps = 128;

// Pixels of the whole sheet.
struct Sheet {
  uint32_t width, height, columns;
  std::vector<uint8_t> rgb;

  uint8_t* at(uint32_t x, uint32_t y) { return rgb.data() + 3 * (size_t{width} * y + x); }
};

Sheet empty_sheet(const Options& options, uint32_t count) {
  Sheet sheet{};
  sheet.columns = std::clamp(count, 1u, kColumns);
  const uint32_t rows = (count + sheet.columns - 1) / sheet.columns;
  sheet.width = kGap + sheet.columns * (options.width + kGap);
  sheet.height = kGap + rows * (options.height + kLabel + kGap);
  if (sheet.width > UINT16_MAX || sheet.height > UINT16_MAX)
    refuse("--size " + size_text(options.width, options.height) + ", --count " + std::to_string(count) +
           ": the sheet would have " + size_text(sheet.width, sheet.height) + " pixels; 65535 a side are the most");
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

void add_tile(Sheet& sheet, uint32_t index, uint32_t program, const Options& options, uint32_t steps) {
  const uint32_t left = kGap + index % sheet.columns * (options.width + kGap);
  const uint32_t top = kGap + index / sheet.columns * (options.height + kLabel + kGap);
  Subject subject = rule_subject(options, program);
  change(subject.recipe, "steps=" + std::to_string(steps), "--steps");
  Progress progress;
  Tile tile(subject, dapple::torus(options.width, options.height), options.seed);
  tile.grow(options.budget, progress);
  dapple::Brush brush;
  brush.view = options.view;
  brush.format = dapple::Pixels::rgb888;
  brush.y_down = options.flip_y;
  for (uint16_t y = 0; y < options.height; ++y) tile.texture().paint(y, brush, sheet.at(left, top + y));
  write_label(sheet, hexadecimal(program), left, top + options.height + kGap / 2, options.width);
}

void print_list(const std::vector<Found>& found, bool json) {
  for (const Found& f : found) {
    const Score& s = f.score;
    const char* const layout =
        json ? "%s{\"rule\": \"%s\", \"map\": \"%s\", \"score\": %s, \"density\": %s, \"entropy\": %s, "
               "\"disorder\": %s, \"correlation\": %s, \"activity\": %s, \"settles\": \"%s\"}"
             : "%s%s  %s  score %s  density %s  entropy %s  disorder %s  correlation %6s  activity %s  settles %s\n";
    const char* const before = !json ? "" : &f == &found.front() ? "[\n  " : ",\n  ";
    std::printf(layout, before, hexadecimal(f.program).c_str(), map_of(f.program).c_str(), decimal(s.total).c_str(),
                decimal(s.density).c_str(), decimal(s.entropy).c_str(), decimal(s.disorder).c_str(),
                decimal(s.correlation).c_str(), decimal(s.activity).c_str(), name_of(s.settled.kind));
  }
  if (json) std::printf(found.empty() ? "[]\n" : "\n]\n");
  finish_standard_output();
}

}  // namespace

void rule_random(const Options& options) {
  const uint32_t steps = options.steps.value_or(kSteps), count = options.count.value_or(kCount);
  const Target target = target_of(options, "rules");
  if (target.path == "-") refuse("-o -: standard output is for the list of programs; give a file");
  empty_sheet(options, count);
  Output out(target.path);
  Progress progress;
  const Style style = static_cast<Style>(options.style.value_or(static_cast<uint8_t>(Style::inertia)));
  const std::vector<Found> found =
      search_nice({style, options.seed, count, steps, options.width, options.height},
                  [&](uint64_t done, uint64_t all) { progress.show("random programs", done, all); });
  if (found.empty()) fail("no nice program was found; try another --seed or --style");
  Sheet sheet = empty_sheet(options, static_cast<uint32_t>(found.size()));
  for (uint32_t i = 0; i < found.size(); ++i) add_tile(sheet, i, found[i].program, options, steps);
  Picture picture;
  picture.width = static_cast<uint16_t>(sheet.width);
  picture.height = static_cast<uint16_t>(sheet.height);
  picture.row = [&](uint16_t y, uint8_t* rgb) { std::memcpy(rgb, sheet.at(0, y), size_t{3} * sheet.width); };
  picture.name = "rules";
  picture.note = "Cell programs, seed " + std::to_string(options.seed) + ", dapple " + version_text();
  Lines lines(picture, target.pixels, options.dither);
  write_picture(lines, target.format, out);
  out.finish();
  print_list(found, options.json);
}

}  // namespace cli
