// Contact sheets. See contact.hpp.
// SPDX-License-Identifier: MIT
#include "contact.hpp"

#include <algorithm>
#include <cstring>

#include "errors.hpp"
#include "font.hpp"

namespace cli {

constexpr uint32_t kColumns = 6, kGap = 8;
constexpr uint32_t kLabel = kGap / 2 + kLetterHeight;  // below a tile
constexpr uint8_t kPaper = 24, kInk = 208;

Contact::Contact(const Options& options, uint32_t count, const std::string& said) : options_(options) {
  columns_ = std::clamp(count, 1u, kColumns);
  const uint32_t rows = (count + columns_ - 1) / columns_;
  width_ = kGap + columns_ * (options.width + kGap);
  height_ = kGap + rows * (options.height + kLabel + kGap);
  if (width_ > UINT16_MAX || height_ > UINT16_MAX)
    refuse("--size " + size_text(options.width, options.height) + said + ": the sheet would have " +
           size_text(width_, height_) + " pixels; 65535 a side are the most");
  rgb_.assign(size_t{3} * width_ * height_, kPaper);
}

void Contact::label(const std::string& text, uint32_t x, uint32_t y) {
  for (size_t i = 0; i < text.size() && (i + 1) * kLetterWidth <= options_.width + 1u; ++i)
    for (uint32_t column = 0; column < 5; ++column)
      for (uint32_t row = 0; row < kLetterHeight; ++row)
        if (columns_of(text[i])[column] >> row & 1)
          std::memset(at(x + static_cast<uint32_t>(i) * kLetterWidth + column, y + row), kInk, 3);
}

void Contact::add(Tile& tile, const std::string& text) {
  const uint32_t left = kGap + added_ % columns_ * (options_.width + kGap);
  const uint32_t top = kGap + added_ / columns_ * (options_.height + kLabel + kGap);
  dapple::Brush brush;
  brush.view = options_.view;
  brush.format = dapple::Pixels::rgb888;
  brush.y_down = options_.flip_y;
  for (uint16_t y = 0; y < options_.height; ++y) tile.texture().paint(y, brush, at(left, top + y));
  label(text, left, top + options_.height + kGap / 2);
  ++added_;
}

void Contact::write(const Target& target, const std::string& name, const std::string& note, Output& out) {
  Picture picture;
  picture.width = static_cast<uint16_t>(width_);
  picture.height = static_cast<uint16_t>(height_);
  picture.row = [&](uint16_t y, uint8_t* rgb) { std::memcpy(rgb, at(0, y), size_t{3} * width_); };
  picture.name = name;
  picture.note = note;
  Lines lines(picture, target.pixels, options_.dither);
  write_picture(lines, target.format, out);
  out.finish();
}

}  // namespace cli
