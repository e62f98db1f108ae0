// dapple surface: a texture for a torus, a vase, a sphere, or a surface from files; and what it looks like on it.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <cstring>
#include <memory>

#include "commands.hpp"
#include "errors.hpp"
#include "field_hash.hpp"
#include "object.hpp"
#include "surface_files.hpp"
#include "tile.hpp"

namespace cli {

namespace {

enum Shape { torus, vase, sphere, flat };

// A surface and its patches, with what they point to.
struct Ground {
  dapple::Surface surface;
  std::vector<dapple::Patch> patch;  // none: a torus
  dapple::Patches patches;
  HeightMap heights;
  MetricMap metric;
  dapple::PlaceMaps maps;
};

// The size asked for, or else the usual one.
void set_size(const Options& options, uint16_t width, uint16_t height, dapple::Surface& surface) {
  surface.width = options.width != 0 ? options.width : width;
  surface.height = options.width != 0 ? options.height : height;
}

// Of a file that says itself how large it is.
void check_size(const Options& options, const std::string& path, uint16_t width, uint16_t height) {
  if (options.width == 0 || (options.width == width && options.height == height)) return;
  refuse("--size " + size_text(options.width, options.height) + ": " + shown(path) + " has " +
         size_text(width, height) + " cells");
}

// The recipe's sides; a vase ends above and below.
void set_sides(const Subject& subject, const std::string& shape, Ground& ground) {
  dapple::Recipe recipe = subject.recipe;
  dapple::Sides& sides = recipe.sides;
  const bool round = ground.surface.shape == dapple::Surface::vase;
  if (round && sides.kind[0] != dapple::Sides::repeat) refuse("sides= of a vase: left and right repeat");
  for (int i = 2; round && i < 4; ++i)
    if (sides.kind[i] == dapple::Sides::repeat) sides.kind[i] = dapple::Sides::closed;
  if (!has_sides(recipe)) return;
  if (ground.surface.shape == dapple::Surface::torus || !ground.patch.empty())
    refuse("sides= is not for a " + shape + ", whose sides are joined; it is for vase and flat");
  ground.patch.push_back(patch_of(recipe));
}

void read_atlas_for(const Options& options, Ground& ground) {
  ground.patch = read_atlas(options.atlas);
  if (ground.surface.width == 0) set_size(options, 96, 96, ground.surface);
  for (size_t i = 0; i < ground.patch.size(); ++i) ground.patch[i].x = static_cast<int32_t>(i) * ground.surface.width;
  if (ground.surface.shape != dapple::Surface::tensors) return;
  const size_t maps = ground.metric.patches;
  if (maps != 1 && maps != ground.patch.size())
    refuse("--metric " + shown(options.metric) + " has " + std::to_string(maps) + " patches and --atlas " +
           shown(options.atlas) + " " + std::to_string(ground.patch.size()));
}

void make_flat(const Options& options, Ground& ground) {
  if (!options.heights.empty() && !options.metric.empty()) refuse("give --heights or --metric, not both");
  ground.surface = dapple::surface_of(dapple::Surface::flat, 0, 0);
  if (!options.heights.empty()) {
    ground.heights = read_heights(options.heights, options.tall.value_or(100000));
    check_size(options, options.heights, ground.heights.width, ground.heights.height);
    ground.surface = dapple::height_surface(ground.heights.width, ground.heights.height, ground.heights.heights.data());
  } else if (!options.metric.empty()) {
    ground.metric = read_metric(options.metric);
    const MetricMap& m = ground.metric;
    check_size(options, options.metric, m.width, m.height);
    ground.surface = dapple::tensor_surface(m.width, m.height, m.cells.data(), m.patches);
  }
  if (!options.atlas.empty()) read_atlas_for(options, ground);
  if (ground.surface.width == 0) set_size(options, 256, 256, ground.surface);
}

void make_ready(const Options& options, Shape shape, Ground& ground) {
  ground.surface = shape == torus ? dapple::torus_surface(0, 0, options.ratio.value_or(500000))
                   : shape == vase
                       ? dapple::vase_surface(0, 0, options.ratio.value_or(450000), options.tall.value_or(900000))
                       : dapple::sphere_surface(0);
  dapple::Surface& s = ground.surface;
  set_size(options,
           shape == torus  ? 384
           : shape == vase ? 256
                           : 96,
           shape == torus  ? 192
           : shape == vase ? 256
                           : 96,
           s);
  if (shape != sphere) return;
  if (s.width != s.height) refuse("--size " + size_text(s.width, s.height) + ": the faces of a sphere are squares");
  ground.patch.resize(6);
  dapple::make_sphere(ground.patch.data(), s.width);
}

void measure_all(Ground& ground, const std::string& path) {
  dapple::Status status = dapple::more;
  while (status == dapple::more) status = measure(ground.surface, 64);
  if (status == dapple::done) return;
  const dapple::Surface& s = ground.surface;
  const dapple::Metric m = metric_at(s, s.patch, s.x, s.y);
  const auto number = [](int32_t q16) { return decimal_text(static_cast<int32_t>(int64_t{q16} * 15625 / 1024)); };
  const std::string where = s.patches > 1 ? " of patch " + std::to_string(s.patch) : "";
  fail((path.empty() ? "the surface" : shown(path)) + ": the metric of cell " + std::to_string(s.x) + "," +
       std::to_string(s.y) + where + " is xx " + number(m.xx) + ", xy " + number(m.xy) + ", yy " + number(m.yy) +
       "; xx, yy and the smaller principal value must be .004 to 16383");
}

// Patches grown together, or a torus.
class Cloth {
 public:
  Cloth(const Subject& subject, const Ground& ground, const dapple::Surface& surface, const Options& options)
      : name_(subject.name), recipe_(subject.recipe), ground_(ground), surface_(surface) {
    maps_ = ground.maps;
    maps_.surface = &surface_;
    set_surface(recipe_, maps_);
    recipe_.sides = {};
    texture_.resize(std::max<size_t>(1, ground.patch.size()));
    dapple::Options how;
    how.bands = options.bands;
    dapple::AtlasNeed need{};
    if (ground.patch.empty()) need.patch = need_for(recipe_, domain(), options.bands);
    else need = atlas_need(recipe_, ground.patches, options.bands);
    check(ground.patch.empty() ? need.patch.status : need.status, need.patch);
    const size_t bytes = ground.patch.empty() ? need.patch.bytes : need.bytes;
    memory_.reset(new uint8_t[bytes]);
    if (ground.patch.empty()) texture_[0].begin(recipe_, domain(), options.seed, memory_.get(), bytes, how);
    else atlas_.begin(recipe_, ground.patches, options.seed, texture_.data(), memory_.get(), bytes, how);
  }

  void grow(uint32_t budget, Progress& progress) {
    const bool alone = ground_.patch.empty();
    if (budget == 0) budget = 4096;
    while ((alone ? texture_[0].step(budget) : atlas_.step(budget)) == dapple::more)
      progress.show(name_, alone ? texture_[0].rows_done() : atlas_.rows_done(),
                    alone ? texture_[0].rows_in_all() : atlas_.rows_in_all());
  }

  uint32_t width() const { return static_cast<uint32_t>(texture_.size()) * surface_.width; }
  std::vector<dapple::Texture>& textures() { return texture_; }

  void row(uint16_t y, const dapple::Brush& brush, uint8_t* rgb) {
    for (size_t i = 0; i < texture_.size(); ++i) texture_[i].paint(y, brush, rgb + i * 3 * surface_.width);
  }

 private:
  dapple::Domain domain() const { return dapple::torus(surface_.width, surface_.height); }
  void check(dapple::Status status, const dapple::Need& need) const {
    const std::string size = "--size " + size_text(surface_.width, surface_.height);
    if (status == dapple::ok) return;
    if (status == dapple::not_a_multiple)
      refuse(size + ": the sides of " + name_ + " must be multiples of " + std::to_string(need.multiple));
    if (status == dapple::tile_too_small)
      refuse(size + " is too small: " + name_ + " needs at least " + size_text(need.width, need.height));
    if (status == dapple::bad_map) refuse("map=image takes a picture: give map=@FILE, a PGM, PPM or PNG file");
    if (status == dapple::bad_sides) fail(size + ": patches that are joined across and down must be squares");
    if (status == dapple::bad_surface || status == dapple::bad_recipe)
      fail(name_ + " is not for this surface: it has more than three pairs, or where the cells are smallest (" +
           decimal_text(static_cast<int32_t>(int64_t{surface_.least} * 15625 / 1024)) +
           ") a wavelength would be too many of them");
    fail(size + ": " + name_ + " needs more memory than this machine can address");
  }

  std::string name_;
  dapple::Recipe recipe_;
  const Ground& ground_;
  dapple::Surface surface_;
  dapple::PlaceMaps maps_;
  std::vector<dapple::Texture> texture_;
  dapple::Atlas atlas_;
  std::unique_ptr<uint8_t[]> memory_;
};

Raster raster_of(Cloth& cloth, uint16_t height) {
  Raster raster{cloth.width(), height, std::vector<uint8_t>(size_t{3} * cloth.width() * height)};
  dapple::Brush brush;
  brush.format = dapple::Pixels::rgb888;
  for (uint16_t y = 0; y < height; ++y) cloth.row(y, brush, raster.rgb.data() + size_t{3} * cloth.width() * y);
  return raster;
}

// Without correction: the same cells, as if they were all alike.
dapple::Surface uncorrected(const Ground& ground) {
  dapple::Surface plain = dapple::surface_of(dapple::Surface::flat, ground.surface.width, ground.surface.height);
  while (measure(plain, 64) == dapple::more) {
  }
  return plain;
}

void write_preview(const Subject& subject, const Ground& ground, Cloth& cloth, const Options& options, Output& out,
                   const Target& target) {
  constexpr uint32_t kWide = 480, kHigh = 540;
  const dapple::Surface plain_cells = uncorrected(ground);
  Cloth plain(subject, ground, plain_cells, options);
  Progress progress;
  plain.grow(options.budget, progress);
  const uint16_t height = ground.surface.height;
  const Raster before = raster_of(plain, height), after = raster_of(cloth, height);
  const auto repeats = [&](uint8_t side) {
    return ground.patch.empty() ||
           (ground.patch.size() == 1 && ground.patch[0].side[side].kind == dapple::Side::joined);
  };
  const bool round_x = repeats(dapple::Side::left), round_y = repeats(dapple::Side::top);
  const Raster left = object_picture({ground.surface, before, round_x, round_y}, kWide, kHigh),
               right = object_picture({ground.surface, after, round_x, round_y}, kWide, kHigh);
  Picture picture;
  picture.width = 2 * kWide;
  picture.height = kHigh;
  picture.name = subject.name;
  picture.note = "Without and with correction, dapple " + version_text();
  picture.row = [&](uint16_t y, uint8_t* rgb) {
    std::memcpy(rgb, left.rgb.data() + size_t{3} * kWide * y, 3 * kWide);
    std::memcpy(rgb + 3 * kWide, right.rgb.data() + size_t{3} * kWide * y, 3 * kWide);
  };
  Lines lines(picture, target.pixels, false);
  write_picture(lines, target.format, out);
}

// Discs close round the vase: their pitch is a share of its girth.
void fit_seeds(Subject& subject, const Ground& ground) {
  dapple::Start& start = subject.recipe.start;
  if (ground.patch.size() != 1 || ground.patch[0].side[0].kind != dapple::Side::joined) return;
  const int64_t around = int64_t{ground.surface.width} * dapple::base::kMicro;
  const int64_t count = std::max<int64_t>(1, dapple::base::divide_round(around, start.pitch));
  start.pitch = static_cast<int32_t>(std::min<int64_t>(around / count, dapple::kPitch[1]));
}

Target preview_target(const Options& options, const Ground& ground) {
  if (ground.surface.shape == dapple::Surface::flat || ground.surface.shape == dapple::Surface::tensors)
    refuse("--preview is for torus, vase, sphere and --heights, whose shape is known");
  Options other;
  other.output = options.preview;
  return target_of(other, "preview");
}

}  // namespace

std::string surface_help() {
  return "\nSHAPE is torus, vase, sphere (six faces: four around, then north and south, from left to right in one "
         "picture) or flat.\nThe recipe is of the family threshold or mapped, of at most three pairs; lengths are in "
         "cells of a flat surface: the ones\nof a torus' crown, a vase's mean girth, the middle of a sphere's face. "
         "Patches of an atlas are written from left to right.\n";
}

void surface(const Options& options) {
  Subject subject = subject_of(options);
  const Shape shape = options.shape == "torus"    ? torus
                      : options.shape == "vase"   ? vase
                      : options.shape == "sphere" ? sphere
                                                  : flat;
  dapple::PlaceMaps unused{};
  dapple::Recipe probe = subject.recipe;
  if (!set_surface(probe, unused))
    refuse("surfaces are for the families threshold and mapped; " + subject.name + " is of " +
           family_of(subject.recipe).name);
  Ground ground{};
  if (shape == flat) make_flat(options, ground);
  else make_ready(options, shape, ground);
  set_sides(subject, options.shape, ground);
  ground.patches = {ground.patch.data(), static_cast<uint8_t>(ground.patch.size()), ground.surface.width,
                    ground.surface.height};
  ground.surface.open = !ground.patch.empty();
  if (subject.maps != nullptr) ground.maps = subject.maps->maps;
  fit_seeds(subject, ground);
  measure_all(ground, options.metric.empty() ? options.heights : options.metric);
  Cloth cloth(subject, ground, ground.surface, options);
  if (cloth.width() > UINT16_MAX)
    refuse("the patches side by side are " + std::to_string(cloth.width()) + " pixels wide; 65535 are the most");
  Progress progress;
  if (options.hash) {
    cloth.grow(options.budget, progress);
    FieldHash hash;
    for (dapple::Texture& texture : cloth.textures()) hash.add(texture);
    return hash.print();
  }
  const Target target = target_of(options, subject.name);
  Output out(target.path);
  std::optional<Target> preview;
  std::unique_ptr<Output> second;
  if (!options.preview.empty()) {
    preview = preview_target(options, ground);
    second = std::make_unique<Output>(preview->path);
  }
  cloth.grow(options.budget, progress);
  Picture picture;
  picture.width = static_cast<uint16_t>(cloth.width());
  picture.height = ground.surface.height;
  picture.name = subject.name;
  picture.note = "Seed " + std::to_string(options.seed) + ", " + options.shape + ", dapple " + version_text() + ": " +
                 line_of(subject.recipe);
  dapple::Brush brush;
  brush.view = options.view;
  brush.format = dapple::Pixels::rgb888;
  brush.y_down = options.flip_y;
  picture.row = [&](uint16_t y, uint8_t* rgb) { cloth.row(y, brush, rgb); };
  Lines lines(picture, target.pixels, options.dither);
  write_picture(lines, target.format, out);
  if (second != nullptr) {
    write_preview(subject, ground, cloth, options, *second, *preview);
    second->finish();
  }
  out.finish();
}

}  // namespace cli
