// dapple grow: one texture to one file, or to its hash.
// SPDX-License-Identifier: MIT
#include <cinttypes>
#include <cstdio>
#include <cstring>

#include "commands.hpp"
#include "errors.hpp"
#include "tile.hpp"

namespace cli {

// FNV-1a, 64 bit, over the field as little-endian int32, row by row.
static uint64_t hash_of(dapple::Texture& texture) {
  uint64_t hash = UINT64_C(0xcbf29ce484222325);
  const dapple::Domain domain = texture.domain();
  std::vector<int16_t> row(domain.width);
  for (uint16_t y = 0; y < domain.height; ++y) {
    texture.row(y, row.data());
    for (const int32_t value : row)
      for (int shift = 0; shift < 32; shift += 8)
        hash = (hash ^ (static_cast<uint32_t>(value) >> shift & 255)) * UINT64_C(0x100000001b3);
  }
  return hash;
}

// More steps than the recipe has make it a longer recipe; fewer stop it on the way, but for windows in blocks, which have no
// way that all cells go together: there it is a shorter recipe.
static void set_steps(Subject& subject, const Options& options) {
  if (!options.steps || *options.steps == steps_of(subject.recipe)) return;
  const bool blocks = options.at && need_of(subject, domain_of(options), options.bands).block != 0;
  if (blocks || *options.steps > steps_of(subject.recipe))
    change(subject.recipe, "steps=" + std::to_string(*options.steps), "--steps");
}

static void grow_tile(Tile& tile, const Subject& subject, const Options& options) {
  Progress progress;
  if (options.steps && *options.steps < steps_of(subject.recipe)) tile.grow_steps(*options.steps, progress);
  else tile.grow(options.budget, progress);
}

static uint16_t repeated(uint16_t side, uint16_t times) {
  const uint32_t all = uint32_t{side} * times;
  if (all > UINT16_MAX)
    refuse("--repeat: " + std::to_string(times) + " times " + std::to_string(side) + " pixels are more than 65535");
  return static_cast<uint16_t>(all);
}

static Picture picture_of(dapple::Texture& texture, const Options& options) {
  Picture picture;
  picture.width = repeated(options.width, options.across);
  picture.height = repeated(options.height, options.down);
  dapple::Brush brush;
  brush.view = options.view;
  brush.format = dapple::Pixels::rgb888;
  brush.y_down = options.flip_y;
  picture.row = [&texture, &options, brush](uint16_t y, uint8_t* rgb) {
    texture.paint(static_cast<uint16_t>(y % options.height), brush, rgb);
    const size_t bytes = size_t{3} * options.width;
    for (uint16_t copy = 1; copy < options.across; ++copy) std::memcpy(rgb + copy * bytes, rgb, bytes);
  };
  return picture;
}

static void print_hash(const Subject& subject, const Options& options) {
  Tile tile(subject, domain_of(options), options.seed, options.bands, options.kernels);
  grow_tile(tile, subject, options);
  std::printf("%016" PRIx64 "\n", hash_of(tile.texture()));
  finish_standard_output();
}

void grow(const Options& options) {
  Subject subject = subject_of(options);
  set_steps(subject, options);
  if (options.hash) return print_hash(subject, options);
  const Target target = target_of(options, subject.name);
  Tile tile(subject, domain_of(options), options.seed, options.bands, options.kernels);
  Picture picture = picture_of(tile.texture(), options);
  picture.name = subject.name;
  const std::string place = options.at ? ", at " + place_text(*options.at) + " of the plane" : "";
  picture.note = "Seed " + std::to_string(options.seed) + place + ", dapple " + version_text() + ": " + line_of(subject.recipe);
  Output out(target.path);
  grow_tile(tile, subject, options);
  Lines lines(picture, target.pixels, options.dither);
  write_picture(lines, target.format, out);
  out.finish();
}

}  // namespace cli
