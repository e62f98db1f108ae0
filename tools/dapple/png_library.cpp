// PNG files by libpng, which packs them well and reads all of them.
// SPDX-License-Identifier: MIT
#include <png.h>

#include "errors.hpp"
#include "image.hpp"
#include "pixmap.hpp"

namespace cli {

static void write_bytes(png_structp png, png_bytep bytes, size_t count) {
  static_cast<Output*>(png_get_io_ptr(png))->write(bytes, count);
}

static void flush_nothing(png_structp) {}

static int colour_type(dapple::Pixels pixels) {
  if (pixels == dapple::Pixels::l8 || pixels == dapple::Pixels::l16_swapped) return PNG_COLOR_TYPE_GRAY;
  return pixels == dapple::Pixels::rgba8888 ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB;
}

// libpng jumps out of a failing call: nothing here may need a destructor.
static bool write_all(png_structp png, png_infop info, Lines& lines, Output& out) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_write_fn(png, &out, write_bytes, flush_nothing);
  png_set_user_limits(png, 65535, 65535);
  const int depth = lines.pixels() == dapple::Pixels::l16_swapped ? 16 : 8;
  png_set_IHDR(png, info, lines.width(), lines.height(), depth, colour_type(lines.pixels()), PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  for (uint32_t i = lines.count(); i > 0; --i) png_write_row(png, lines.next());
  png_write_end(png, nullptr);
  return true;
}

void write_png_library(Lines& lines, Output& out) {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  const bool good = info != nullptr && write_all(png, info, lines, out);
  png_destroy_write_struct(&png, &info);
  if (!good) fail("libpng cannot write the picture");
}

bool decode_png(const std::string& bytes, Pixmap& picture, std::string& why) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0) {
    why = std::string("libpng says: ") + image.message;
    return false;
  }
  if (image.width > kLargestPicture || image.height > kLargestPicture) {
    why = "has " + std::to_string(image.width) + "x" + std::to_string(image.height) + " pixels; sides are 1 to " +
          std::to_string(kLargestPicture);
    png_image_free(&image);
    return false;
  }
  image.format = (image.format & PNG_FORMAT_FLAG_COLOR) != 0 ? PNG_FORMAT_RGB : PNG_FORMAT_GRAY;
  picture = {image.width, image.height, image.format == PNG_FORMAT_RGB ? 3u : 1u, std::string(PNG_IMAGE_SIZE(image), '\0')};
  if (png_image_finish_read(&image, nullptr, &picture.bytes[0], 0, nullptr) == 0) {
    why = std::string("libpng says: ") + image.message;
    return false;
  }
  return true;
}

}  // namespace cli
