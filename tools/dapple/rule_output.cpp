// Where a state of a cell program goes: a picture, run-length text, or plain text.
// SPDX-License-Identifier: MIT
#include "rule_output.hpp"

#include <cstring>

#include "errors.hpp"
#include "rule_map.hpp"
#include "rule_rle.hpp"

namespace cli {

namespace {

// Rows of rgb of a state, as the library paints a texture of the recipe.
class Painter {
 public:
  Painter(const Torus& state, const dapple::Recipe& recipe, const Options& options) : state_(state) {
    brush_.view = options.view;
    brush_.format = dapple::Pixels::rgb888;
    brush_.y_down = options.flip_y;
    const int16_t level = dapple::cells::cell_level(recipe.stage[0].number);
    shader_ = dapple::paint::shader_of(recipe.paint, brush_, dapple::cells::kUnit, level, options.seed);
    for (std::vector<int16_t>& row : field_) row.resize(state.width() + 2u);
  }

  void paint(uint16_t y, uint8_t* rgb) {
    const uint32_t height = state_.height();
    for (uint32_t i = 0; i < 3; ++i) make_row(static_cast<uint16_t>((y + height + i - 1) % height), field_[i]);
    const dapple::paint::Source source = {
        field_[0].data() + 1, field_[1].data() + 1, field_[2].data() + 1, state_.width(), y, 0, y};
    dapple::paint::paint_row(shader_, brush_, source, rgb);
  }

 private:
  void make_row(uint16_t y, std::vector<int16_t>& field) {
    for (uint16_t x = 0; x < state_.width(); ++x) field[x + 1u] = state_.get(x, y) ? dapple::cells::kUnit : int16_t{0};
    field.front() = field[state_.width()];
    field.back() = field[1];
  }

  const Torus& state_;
  dapple::Brush brush_;
  dapple::paint::Shader shader_;
  std::vector<int16_t> field_[3];
};

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

uint16_t repeated(uint16_t side, uint16_t times) {
  const uint32_t all = uint32_t{side} * times;
  if (all > UINT16_MAX)
    refuse("--repeat: " + std::to_string(times) + " times " + std::to_string(side) + " pixels are more than 65535");
  return static_cast<uint16_t>(all);
}

}  // namespace

bool wants_rle(const Options& options) { return options.rle || ends_with(options.output, ".rle"); }

StateOutput::StateOutput(const Options& options, const std::string& name) : options_(options), name_(name) {
  if (options.text && wants_rle(options)) refuse("--text and run-length text exclude each other");
  if (options.text) path_ = options.output.empty() ? "-" : options.output;
  else if (wants_rle(options)) path_ = options.output.empty() ? name + ".rle" : options.output;
  else target_ = target_of(options, name);
  if (!target_ && options.format) refuse("--format is for pictures");
  if (!target_ && options.repeat) refuse("--repeat is for pictures");
  if (target_) path_ = target_->path;
  repeated(options.width, options.across);
  repeated(options.height, options.down);
  out_.emplace(path_);
}

void StateOutput::write(const Torus& state, const dapple::Recipe& recipe, const std::string& note) {
  if (options_.text) {
    out_->write(text_of(state));
  } else if (!target_) {
    const std::string torus = ":T" + std::to_string(state.width()) + "," + std::to_string(state.height());
    out_->write(write_rle(state, map_of(program_of(recipe)) + (options_.at ? "" : torus), note));
  } else {
    write_picture_of(state, recipe, note);
  }
  out_->finish();
}

void StateOutput::write_picture_of(const Torus& state, const dapple::Recipe& recipe, const std::string& note) {
  Painter painter(state, recipe, options_);
  Picture picture;
  picture.width = repeated(state.width(), options_.across);
  picture.height = repeated(state.height(), options_.down);
  picture.row = [&](uint16_t y, uint8_t* rgb) {
    painter.paint(static_cast<uint16_t>(y % state.height()), rgb);
    const size_t bytes = size_t{3} * state.width();
    for (uint16_t copy = 1; copy < options_.across; ++copy) std::memcpy(rgb + copy * bytes, rgb, bytes);
  };
  picture.name = name_;
  picture.note = note;
  Lines lines(picture, target_->pixels, options_.dither);
  write_picture(lines, target_->format, *out_);
}

uint64_t field_hash_of(const Torus& state) {
  uint64_t hash = UINT64_C(0xcbf29ce484222325);
  for (uint16_t y = 0; y < state.height(); ++y)
    for (uint16_t x = 0; x < state.width(); ++x) {
      const uint32_t value = state.get(x, y) ? static_cast<uint32_t>(dapple::cells::kUnit) : 0;
      for (int shift = 0; shift < 32; shift += 8) hash = (hash ^ (value >> shift & 255)) * UINT64_C(0x100000001b3);
    }
  return hash;
}

uint32_t program_of(const dapple::Recipe& recipe) {
  return static_cast<uint32_t>(recipe.stage[0].number[dapple::cells::program]);
}

}  // namespace cli
