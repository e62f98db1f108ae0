// Reading pictures. See pixmap.hpp.
// SPDX-License-Identifier: MIT
#include "pixmap.hpp"

#include <algorithm>
#include <cctype>

#include "errors.hpp"
#include "input.hpp"

namespace cli {

[[noreturn]] static void damaged(const std::string& path, const std::string& why) {
  fail("picture " + shown(path) + ": " + why);
}

// A decimal number of the header, behind blanks and remarks.
static uint32_t header_number(const std::string& text, size_t& at, const std::string& path) {
  while (at < text.size() && (std::isspace(static_cast<unsigned char>(text[at])) != 0 || text[at] == '#'))
    at = text[at] == '#' ? std::min(text.find('\n', at), text.size()) : at + 1;
  uint32_t value = 0;
  const size_t begin = at;
  for (; at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) != 0; ++at) {
    value = value * 10 + static_cast<uint32_t>(text[at] - '0');
    if (value > 1000000) break;
  }
  if (at == begin) damaged(path, "its header is damaged");
  return value;
}

static Pixmap read_pnm(const std::string& path, const std::string& text) {
  size_t at = 2;
  Pixmap picture{};
  picture.channels = text[1] == '5' ? 1 : 3;
  picture.width = header_number(text, at, path);
  picture.height = header_number(text, at, path);
  const uint32_t most = header_number(text, at, path);
  if (picture.width < 1 || picture.width > kLargestPicture || picture.height < 1 || picture.height > kLargestPicture)
    damaged(path, "has " + std::to_string(picture.width) + "x" + std::to_string(picture.height) +
                      " pixels; sides are 1 to " + std::to_string(kLargestPicture));
  if (most != 255) damaged(path, "has values up to " + std::to_string(most) + "; 255 is what is read");
  const size_t wanted = size_t{picture.width} * picture.height * picture.channels;
  picture.bytes = text.substr(std::min(text.size(), at + 1));
  if (picture.bytes.size() < wanted)
    damaged(path, "is cut short: " + std::to_string(picture.bytes.size()) + " bytes of pixels, not " +
                      std::to_string(wanted));
  return picture;
}

static Pixmap read_png(const std::string& path, const std::string& bytes) {
#ifdef DAPPLE_HAS_PNG
  Pixmap picture{};
  std::string why;
  if (!decode_png(bytes, picture, why)) damaged(path, why);
  return picture;
#else
  static_cast<void>(bytes);
  damaged(path, "is a PNG file, which this program reads only if it is built with libpng; give a PGM or PPM file");
#endif
}

Pixmap read_pixmap(const std::string& path) {
  const std::string bytes = read_file(path);
  if (bytes.compare(0, 2, "P5") == 0 || bytes.compare(0, 2, "P6") == 0) return read_pnm(path, bytes);
  if (bytes.compare(0, 4, "\x89PNG") == 0) return read_png(path, bytes);
  damaged(path, "is not a picture that is read: PGM or PPM (P5 or P6), or PNG");
}

}  // namespace cli
