// QOI files: the "Quite OK Image Format" 1.0 (qoiformat.org), three or four channels.
// SPDX-License-Identifier: MIT
#include "image.hpp"

namespace cli {

namespace {

struct Colour {
  uint8_t r, g, b, a;
};

bool operator==(const Colour& x, const Colour& y) { return x.r == y.r && x.g == y.g && x.b == y.b && x.a == y.a; }

struct Encoder {
  Output& out;
  Colour seen[64] = {};
  Colour before = {0, 0, 0, 255};
  uint8_t run = 0;

  // 11rrrrrr: the colour before, r + 1 times.
  void flush() {
    if (run > 0) out.put(static_cast<uint8_t>(0xc0 | (run - 1)));
    run = 0;
  }

  void colour(Colour c) {
    if (c == before) {
      if (++run == 62) flush();
      return;
    }
    flush();
    Colour& slot = seen[(c.r * 3 + c.g * 5 + c.b * 7 + c.a * 11) % 64];
    if (slot == c) out.put(static_cast<uint8_t>(&slot - seen));  // 00iiiiii: index
    else difference(c);
    slot = before = c;
  }

  // Alpha never changes here: every picture is opaque.
  void difference(Colour c) {
    const int8_t r = static_cast<int8_t>(c.r - before.r), g = static_cast<int8_t>(c.g - before.g),
                 b = static_cast<int8_t>(c.b - before.b);
    const int rg = r - g, bg = b - g;
    if (r >= -2 && r <= 1 && g >= -2 && g <= 1 && b >= -2 && b <= 1) {  // 01rrggbb, each + 2
      out.put(static_cast<uint8_t>(0x40 | (r + 2) << 4 | (g + 2) << 2 | (b + 2)));
    } else if (g >= -32 && g <= 31 && rg >= -8 && rg <= 7 && bg >= -8 && bg <= 7) {  // 10gggggg + 32, rrrrbbbb + 8
      const uint8_t bytes[2] = {static_cast<uint8_t>(0x80 | (g + 32)), static_cast<uint8_t>((rg + 8) << 4 | (bg + 8))};
      out.write(bytes, sizeof bytes);
    } else {
      const uint8_t bytes[4] = {0xfe, c.r, c.g, c.b};
      out.write(bytes, sizeof bytes);
    }
  }
};

}  // namespace

void write_qoi(Lines& lines, Output& out) {
  const uint8_t channels = lines.pixels() == dapple::Pixels::rgba8888 ? 4 : 3;
  const uint16_t w = lines.width(), h = lines.height();
  const uint8_t head[14] = {'q',
                            'o',
                            'i',
                            'f',
                            0,
                            0,
                            static_cast<uint8_t>(w >> 8),
                            static_cast<uint8_t>(w),
                            0,
                            0,
                            static_cast<uint8_t>(h >> 8),
                            static_cast<uint8_t>(h),
                            channels,
                            0};
  out.write(head, sizeof head);
  Encoder encoder{out};
  for (uint32_t i = lines.count(); i > 0; --i) {
    const uint8_t* pixel = lines.next();
    for (uint32_t x = 0; x < w; ++x, pixel += channels) encoder.colour({pixel[0], pixel[1], pixel[2], 255});
  }
  encoder.flush();
  const uint8_t end[8] = {0, 0, 0, 0, 0, 0, 0, 1};
  out.write(end, sizeof end);
}

}  // namespace cli
