// dapple grow: one texture to one file, or to its hash.
// SPDX-License-Identifier: MIT
#include <cstring>

#include "commands.hpp"
#include "errors.hpp"
#include "field_hash.hpp"
#include "maps.hpp"
#include "tile.hpp"

namespace cli {

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
  if (options.steps && *options.steps < steps_of(subject.recipe)) tile.grow_steps(*options.steps, options.budget, progress);
  else tile.grow(options.budget, progress);
}

static uint16_t repeated(uint16_t side, uint16_t times) {
  const uint32_t all = uint32_t{side} * times;
  if (all > UINT16_MAX)
    refuse("--repeat: " + std::to_string(times) + " times " + std::to_string(side) + " pixels are more than 65535");
  return static_cast<uint16_t>(all);
}

static Picture picture_of(dapple::Texture& texture, dapple::Pixels pixels, const Options& options) {
  Picture picture;
  picture.width = repeated(options.width, options.across);
  picture.height = repeated(options.height, options.down);
  dapple::Brush brush;
  brush.view = options.view;
  brush.format = picture.pixels = pixels == dapple::Pixels::l16 || pixels == dapple::Pixels::l16_swapped ? pixels : dapple::Pixels::rgb888;
  brush.y_down = options.flip_y;
  picture.row = [&texture, &options, brush](uint16_t y, uint8_t* row) {
    texture.paint(static_cast<uint16_t>(y % options.height), brush, row);
    const size_t bytes = dapple::pixel_bytes(brush.format, options.width);
    for (uint16_t copy = 1; copy < options.across; ++copy) std::memcpy(row + copy * bytes, row, bytes);
  };
  return picture;
}

static void print_hash(const Subject& subject, const Options& options) {
  Tile tile(subject, domain_of(options), options.seed, options.bands, options.kernels);
  grow_tile(tile, subject, options);
  FieldHash hash;
  hash.add(tile.texture());
  hash.print();
}

void grow_maps(Subject subject, const Options& options) {
  check_maps(options);
  set_steps(subject, options);
  Tile tile(subject, domain_of(options), options.seed, options.bands, options.kernels);
  MapFiles files(subject.name, options);
  grow_tile(tile, subject, options);
  files.write(tile.texture());
}

// -o of an animation: one number of a fixed width, %01d to %09d.
struct Numbered {
  std::string before, after;
  size_t digits;

  std::string name(uint32_t frame) const {
    const std::string number = std::to_string(frame);
    return before + std::string(digits - number.size(), '0') + number + after;
  }
};

static Numbered numbered(const std::string& pattern) {
  const size_t at = pattern.find('%');
  const bool good = at != std::string::npos && pattern.size() > at + 3 && pattern[at + 1] == '0' && pattern[at + 2] > '0' &&
                    pattern[at + 2] <= '9' && pattern[at + 3] == 'd' && pattern.find('%', at + 1) == std::string::npos;
  if (!good) refuse("-o " + shown(pattern) + ": with --every it has one number of a fixed width in it, as in frames/%04d.png");
  return {pattern.substr(0, at), pattern.substr(at + 4), static_cast<size_t>(pattern[at + 2] - '0')};
}

// Frame k shows the texture after k times --every steps. Every file is complete when it has its name.
static void write_frames(const Subject& subject, const Options& options, const Target& target) {
  const Numbered names = numbered(target.path);
  const uint32_t frames = options.steps.value_or(steps_of(subject.recipe)) / options.every + 1;
  if (std::to_string(frames - 1).size() > names.digits)
    refuse("-o " + shown(target.path) + ": there will be " + std::to_string(frames) + " frames, whose numbers do not fit " +
           std::to_string(names.digits) + (names.digits == 1 ? " digit" : " digits"));
  if (options.at && need_of(subject, domain_of(options), options.bands).block != 0)
    refuse("--every: a window of " + subject.name + " is decided in blocks and has no frames on the way");
  Tile tile(subject, domain_of(options), options.seed, options.bands, options.kernels);
  Picture picture = picture_of(tile.texture(), target.pixels, options);
  picture.name = subject.name;
  Progress progress;
  for (uint32_t frame = 0; frame < frames; ++frame) {
    Output out(names.name(frame));
    tile.grow_steps(frame * options.every, options.budget, progress);
    picture.note = "Seed " + std::to_string(options.seed) + ", step " + std::to_string(frame * options.every) + ", dapple " +
                   version_text() + ": " + line_of(subject.recipe);
    Lines lines(picture, target.pixels, options.dither);
    write_picture(lines, target.format, out);
    out.finish();
  }
}

void grow(const Options& options) {
  check_maps(options);
  if (options.every != 0 && (options.hash || !options.maps.empty()))
    refuse(std::string("--every writes pictures, and has no ") + (options.hash ? "--hash" : "--maps"));
  Subject subject = subject_of(options);
  if (!options.maps.empty()) return grow_maps(subject, options);
  set_steps(subject, options);
  if (options.hash) return print_hash(subject, options);
  const Target target = target_of(options, subject.name);
  if (options.every != 0) return write_frames(subject, options, target);
  Tile tile(subject, domain_of(options), options.seed, options.bands, options.kernels);
  Picture picture = picture_of(tile.texture(), target.pixels, options);
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
