// Rows of pictures as bytes, file formats, and the formats that are little more than those bytes: PNM and raw.
// SPDX-License-Identifier: MIT
#include "image.hpp"

#include <algorithm>

#include "recipe/word.hpp"

namespace cli {

using dapple::Pixels;

// Word `index` of words separated by '|'.
static std::string word_at(const char* words, int index) {
  dapple::recipe::Word rest = dapple::recipe::word_of(words), word{};
  for (int i = 0; i <= index; ++i) word = take(rest, '|');
  return std::string(word.text, word.length);
}

std::string name_of(Format format) { return word_at(kFormats, static_cast<int>(format)); }
std::string name_of(Pixels pixels) { return word_at(kPixels, static_cast<int>(pixels)); }

std::string suffix_of(Format format) {
  if (format == Format::png_own) return ".png";
  if (format == Format::c) return ".h";
  return "." + name_of(format);
}

bool format_of(const std::string& path, Format& format) {
  const size_t dot = path.find_last_of("./");
  if (dot == std::string::npos || path[dot] == '/') return false;
  const std::string suffix = path.substr(dot);
  for (const Format f : {Format::png, Format::pgm, Format::ppm, Format::pbm, Format::qoi, Format::raw, Format::c})
    if (suffix == suffix_of(f) || (f == Format::c && suffix == ".c")) {
      format = f;
      return true;
    }
  return false;
}

std::vector<Pixels> pixels_of(Format format) {
  switch (format) {
    case Format::png:
    case Format::png_own:
      return {Pixels::rgb888, Pixels::l8, Pixels::rgba8888, Pixels::l16_swapped};
    case Format::pgm:
      return {Pixels::l8, Pixels::l16_swapped};
    case Format::ppm:
      return {Pixels::rgb888};
    case Format::pbm:
      return {Pixels::l1_msb};
    case Format::qoi:
      return {Pixels::rgb888, Pixels::rgba8888};
    case Format::raw:
    case Format::c:
      break;
  }
  return {Pixels::rgba8888, Pixels::l8,     Pixels::rgb888,   Pixels::rgb565, Pixels::rgb565_swapped,
          Pixels::l1_msb,   Pixels::l1_lsb, Pixels::l1_pages, Pixels::l16,    Pixels::l16_swapped};
}

Lines::Lines(const Picture& picture, Pixels pixels, bool dither)
    : picture_(picture), rgb_(size_t{3} * picture.width), line_(dapple::pixel_bytes(pixels, picture.width)) {
  brush_.format = pixels;
  brush_.dither = dither;
}

uint32_t Lines::count() const { return brush_.format == Pixels::l1_pages ? (height() + 7u) / 8u : height(); }

const uint8_t* Lines::next() {
  if (picture_.pixels != Pixels::rgb888) {
    picture_.row(static_cast<uint16_t>(y_++), line_.data());
    return line_.data();
  }
  constexpr uint32_t kBlock = 240;  // pixels that pack takes at once
  std::fill(line_.begin(), line_.end(), uint8_t{0});
  for (int rows = brush_.format == Pixels::l1_pages ? 8 : 1; rows > 0 && y_ < height(); --rows, ++y_) {
    const uint16_t y = static_cast<uint16_t>(y_);
    picture_.row(y, rgb_.data());
    const dapple::paint::Source place{nullptr, nullptr, nullptr, picture_.width, y, 0, y};
    for (uint32_t x = 0; x < width(); x += kBlock) {
      const uint8_t count = static_cast<uint8_t>(std::min(kBlock, width() - x));
      dapple::paint::pack(brush_, place, rgb_.data() + size_t{3} * x, static_cast<uint16_t>(x), count, line_.data());
    }
  }
  return line_.data();
}

static void write_lines(Lines& lines, Output& out) {
  for (uint32_t i = lines.count(); i > 0; --i) out.write(lines.next(), lines.bytes());
}

// The binary kinds P4 (bit 1: set, or light), P5 and P6.
static void write_pnm(Lines& lines, char kind, Output& out) {
  out.write("P" + std::string(1, kind) + "\n" + std::to_string(lines.width()) + " " + std::to_string(lines.height()) +
            (kind == '4' ? "\n" : lines.pixels() == Pixels::l16_swapped ? "\n65535\n" : "\n255\n"));
  write_lines(lines, out);
}

void write_picture(Lines& lines, Format format, Output& out) {
  switch (format) {
    case Format::png:
#ifdef DAPPLE_HAS_PNG
      return write_png_library(lines, out);
#endif
    case Format::png_own:
      return write_png_own(lines, out);
    case Format::pgm:
      return write_pnm(lines, '5', out);
    case Format::ppm:
      return write_pnm(lines, '6', out);
    case Format::pbm:
      return write_pnm(lines, '4', out);
    case Format::qoi:
      return write_qoi(lines, out);
    case Format::raw:
      return write_lines(lines, out);
    case Format::c:
      return write_c(lines, out);
  }
}

}  // namespace cli
