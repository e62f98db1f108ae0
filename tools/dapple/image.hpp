// Pictures, and the files they can be written as.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "dapple.hpp"
#include "output.hpp"

namespace cli {

// A picture whose rows are asked for one by one, from top to bottom: as rgb888, which is packed into what a file holds, or
// as the very pixels of the file.
struct Picture {
  uint16_t width, height;
  std::function<void(uint16_t y, uint8_t* pixels)> row;
  dapple::Pixels pixels = dapple::Pixels::rgb888;
  std::string name;  // for a C header: an identifier is made of it
  std::string note;  // and where the picture comes from
};

enum class Format { png, png_own, pgm, ppm, pbm, qoi, raw, c };
constexpr const char* kFormats = "png|png-own|pgm|ppm|pbm|qoi|raw|c";
constexpr const char* kPixels = "l8|rgb888|rgba8888|rgb565|rgb565_swapped|l1_msb|l1_lsb|l1_pages|l16|l16_swapped";

std::string name_of(Format format);
std::string name_of(dapple::Pixels pixels);

// With the dot.
std::string suffix_of(Format format);
// The format a file name's suffix stands for; false when it stands for none.
bool format_of(const std::string& path, Format& format);

// The pixel formats a file format can hold, the usual one first.
std::vector<dapple::Pixels> pixels_of(Format format);

// A picture's rows as bytes of a pixel format, one line after the other.
class Lines {
 public:
  Lines(const Picture& picture, dapple::Pixels pixels, bool dither);

  uint16_t width() const { return picture_.width; }
  uint16_t height() const { return picture_.height; }
  dapple::Pixels pixels() const { return brush_.format; }
  const Picture& picture() const { return picture_; }
  uint32_t count() const;                        // rows, or pages of eight rows
  size_t bytes() const { return line_.size(); }  // of a line
  const uint8_t* next();

 private:
  const Picture& picture_;
  dapple::Brush brush_;
  uint32_t y_ = 0;
  std::vector<uint8_t> rgb_, line_;
};

void write_picture(Lines& lines, Format format, Output& out);

// The writers of single formats.
void write_png_own(Lines& lines, Output& out);
void write_png_library(Lines& lines, Output& out);  // only where libpng is
void write_qoi(Lines& lines, Output& out);
void write_c(Lines& lines, Output& out);

}  // namespace cli
