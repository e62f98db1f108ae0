// Files that describe surfaces. See surface_files.hpp.
// SPDX-License-Identifier: MIT
#include "surface_files.hpp"

#include <algorithm>
#include <sstream>

#include "errors.hpp"
#include "input.hpp"
#include "pixmap.hpp"
#include "recipe/word.hpp"

namespace cli {

namespace {

constexpr const char* kSideNames[] = {"left", "right", "top", "bottom"};

[[noreturn]] void broken(const std::string& path, size_t line, const std::string& why) {
  fail(shown(path) + ", line " + std::to_string(line) + ": " + why);
}

// The words of a file with the lines they are in; '#' begins a remark.
struct Line {
  size_t number;
  std::vector<std::string> words;
};
std::vector<Line> lines_of(const std::string& path) {
  std::istringstream text(read_file(path));
  std::vector<Line> lines;
  size_t number = 0;
  for (std::string line; std::getline(text, line);) {
    std::istringstream rest(line.substr(0, line.find('#')));
    Line words{++number, {}};
    for (std::string word; rest >> word;) words.words.push_back(word);
    if (!words.words.empty()) lines.push_back(words);
  }
  return lines;
}

int32_t decimal(const std::string& path, size_t line, const std::string& word) {
  int32_t value = 0;
  if (word.size() > 40 || !dapple::recipe::read_decimal(dapple::recipe::word_of(word.c_str()), value))
    broken(path, line, shown(word) + " is not a decimal number below 2148 with at most six digits after the point");
  return value;
}

uint32_t whole(const std::string& path, size_t line, const std::string& word, uint32_t low, uint32_t high) {
  const bool digits = !word.empty() && word.size() < 9 && word.find_first_not_of("0123456789") == std::string::npos;
  const uint32_t value = digits ? static_cast<uint32_t>(std::stoul(word)) : 0;
  if (!digits || value < low || value > high)
    broken(path, line,
           shown(word) + " is not a whole number from " + std::to_string(low) + " to " + std::to_string(high));
  return value;
}

uint8_t side_named(const std::string& path, size_t line, const std::string& word) {
  for (uint8_t i = 0; i < dapple::kSides; ++i)
    if (word == kSideNames[i]) return i;
  broken(path, line, shown(word) + " is not one of left, right, top, bottom");
}

void put_side(std::vector<dapple::Patch>& all, uint8_t patch, uint8_t side, const dapple::Side& value) {
  constexpr dapple::Side kClosed = dapple::closed_side();
  while (all.size() <= patch) all.push_back({0, 0, {kClosed, kClosed, kClosed, kClosed}});
  all[patch].side[side] = value;
}

void read_side(const std::string& path, const Line& line, std::vector<dapple::Patch>& all) {
  const std::vector<std::string>& w = line.words;
  const auto patch = [&](size_t i) {
    return static_cast<uint8_t>(whole(path, line.number, w[i], 0, dapple::kMostPatches - 1));
  };
  const size_t count = w.size();
  const bool closed = count == 3 && w[2] == "closed", fixed = count == 5 && w[2] == "fixed",
             reversed = count == 5 && w[4] == "reversed";
  if (!closed && !fixed && !reversed && count != 4)
    broken(path, line.number, "give PATCH SIDE PATCH SIDE [reversed], PATCH SIDE closed, or PATCH SIDE fixed A B");
  const uint8_t first = patch(0), side = side_named(path, line.number, w[1]);
  if (closed) return put_side(all, first, side, dapple::closed_side());
  if (fixed)
    return put_side(all, first, side,
                    dapple::fixed_side(decimal(path, line.number, w[3]), decimal(path, line.number, w[4])));
  const uint8_t second = patch(2), other = side_named(path, line.number, w[3]);
  put_side(all, first, side, dapple::joined_side(second, other, reversed));
  put_side(all, second, other, dapple::joined_side(first, side, reversed));
}

std::string side_text(uint8_t patch, uint8_t side) {
  return std::string(kSideNames[side]) + " side of patch " + std::to_string(patch);
}

}  // namespace

std::vector<dapple::Patch> read_atlas(const std::string& path) {
  std::vector<dapple::Patch> all;
  for (const Line& line : lines_of(path)) read_side(path, line, all);
  if (all.empty()) fail(shown(path) + " names no patch");
  const dapple::Patches patches = {all.data(), static_cast<uint8_t>(all.size()), 64, 64};
  const dapple::Unpaired unpaired = first_unpaired(patches);
  if (!unpaired.found) return all;
  const dapple::Side& side = all[unpaired.patch].side[unpaired.side];
  const std::string name = shown(path) + ": the " + side_text(unpaired.patch, unpaired.side);
  if (side.kind == dapple::Side::fixed) fail(name + " is fixed at values outside 0 to 1");
  fail(name + " is joined to the " + side_text(side.patch, side.side) + ", which is joined to another or not at all");
}

MetricMap read_metric(const std::string& path) {
  const std::vector<Line> lines = lines_of(path);
  if (lines.empty() || lines[0].words.size() < 2 || lines[0].words.size() > 3)
    fail(shown(path) + " does not begin with WIDTH HEIGHT [PATCHES]");
  const std::vector<std::string>& first = lines[0].words;
  const size_t line = lines[0].number;
  MetricMap map{static_cast<uint16_t>(whole(path, line, first[0], dapple::kSmallestSide, 8192)),
                static_cast<uint16_t>(whole(path, line, first[1], dapple::kSmallestSide, 8192)),
                static_cast<uint8_t>(first.size() == 2 ? 1 : whole(path, line, first[2], 1, dapple::kMostPatches)),
                {}};
  const size_t wanted = size_t{map.width} * map.height * map.patches;
  std::vector<int32_t> numbers;
  for (size_t i = 1; i < lines.size(); ++i)
    for (const std::string& word : lines[i].words) {
      const int64_t micro = decimal(path, lines[i].number, word);
      numbers.push_back(static_cast<int32_t>(dapple::base::divide_round(micro * 65536, dapple::base::kMicro)));
    }
  if (numbers.size() != 3 * wanted)
    fail(shown(path) + " has " + std::to_string(numbers.size()) + " numbers; " + std::to_string(map.width) + " x " +
         std::to_string(map.height) + " cells of " + std::to_string(map.patches) + " patches have " +
         std::to_string(3 * wanted));
  for (size_t i = 0; i < wanted; ++i) map.cells.push_back({numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]});
  return map;
}

HeightMap read_heights(const std::string& path, int32_t tall) {
  const Pixmap picture = read_pixmap(path);
  if (picture.width < dapple::kSmallestSide || picture.height < dapple::kSmallestSide)
    fail("picture " + shown(path) + " is smaller than " + std::to_string(dapple::kSmallestSide) + " pixels a side");
  HeightMap map{static_cast<uint16_t>(picture.width), static_cast<uint16_t>(picture.height), {}};
  const int64_t white = dapple::base::divide_round(int64_t{tall} * picture.width * 256, dapple::base::kMicro);
  if (white > INT16_MAX)
    fail("picture " + shown(path) + ": white would be " + std::to_string(white / 256) +
         " cells high; the most are 127 (--tall)");
  for (uint32_t y = 0; y < picture.height; ++y)
    for (uint32_t x = 0; x < picture.width; ++x)
      map.heights.push_back(static_cast<int16_t>(white * picture.grey(x, y) / 255));
  return map;
}

}  // namespace cli
