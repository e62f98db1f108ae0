// What a command line says.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "image.hpp"
#include "kernels.hpp"
#include "map_image.hpp"

namespace cli {

enum Command : unsigned {
  in_list = 1, in_grow = 2, in_info = 4, in_sheet = 8, in_stream = 16, in_rule = 32, in_tiles = 64, in_surface = 128, in_bench = 256
};
constexpr unsigned kTakesSubject = in_grow | in_info | in_stream | in_tiles | in_surface;  // NAME|RECIPE [key=value ...]

constexpr uint16_t kLargestSheetTile = 8191;  // of tiles: the preview has eight, and at most 65535 pixels
constexpr const char* kShapes = "torus|vase|sphere|flat";  // of surface

// A pixel of the endless plane.
struct Place {
  int32_t x, y;
};

struct Options {
  std::string subject;               // NAME or RECIPE
  std::vector<std::string> changes;  // key=value
  std::vector<std::string> wanted;   // of sheet: presets and recipes; of bench: parts of names; none: all
  uint16_t width = 256, height = 256;
  std::optional<Place> at;  // a window of the endless plane instead of a torus
  uint32_t seed = 1337;
  std::optional<uint32_t> steps;
  MapAs map_as = MapAs::structure;  // how map=@FILE is read
  std::string output;  // empty: after the subject
  std::string maps;    // the folder of a material's maps; empty: one picture
  std::optional<Format> format;
  dapple::View view = dapple::View::colour;
  std::optional<dapple::Pixels> pixels;
  std::optional<dapple::Ramp> ramp;
  uint16_t across = 1, down = 1;  // how often the tile is repeated
  bool repeat = false;            // --repeat was given
  uint32_t budget = 0;            // rows; 0: not given
  uint8_t bands = 1;
  Kernels kernels = best_kernels();
  uint32_t frames = 0;            // of stream; 0: not given
  uint32_t every = 0;             // steps from one frame of grow to the next; 0: one picture
  std::string verb, start;        // of rule: settle, score, complete; the file of the state to begin with
  std::optional<uint8_t> style;   // a Style
  std::optional<uint32_t> count, tries;
  bool mips = false;   // and their levels
  std::string shape, preview, heights, metric, atlas;  // of surface: its name, and files
  std::optional<int32_t> ratio, tall;                  // 1/1000000
  bool map = false, rle = false, text = false;
  bool dither = false, flip_y = false, hash = false, json = false, markdown = false;
};

// Reads the words behind the command's name into `options`, which hold the command's defaults.
void read_options(Command command, const std::vector<std::string>& words, Options& options);

// The options of a command, one line each.
std::string options_help(Command command);

std::string size_text(uint32_t width, uint32_t height);
std::string place_text(Place place);

// Where the options want a texture grown.
dapple::Domain domain_of(const Options& options);

// The file format and the pixel format the options ask for, and the file they go to.
struct Target {
  std::string path;
  Format format;
  dapple::Pixels pixels;
};
Target target_of(const Options& options, const std::string& name);

}  // namespace cli
