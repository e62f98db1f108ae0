// The reduction by two, exact sums and one rounding a value; colours as they are stored.
// SPDX-License-Identifier: MIT
#include "mip.hpp"

#include "../base/math.hpp"
#include "pixel.hpp"

namespace dapple::paint {

// How many parts of `whole` the pixels from 2 i on have in pixel i of the next level.
struct Parts {
  uint8_t count;
  uint32_t part[3], whole;
};

static Parts parts_of(uint16_t side, uint16_t i) {
  const uint32_t half = side / 2u;
  if (side == 1) return {1, {1, 0, 0}, 1};
  if (side % 2 == 0) return {2, {1, 1, 0}, 2};
  return {3, {half - i, half, i + 1u}, side};
}

static uint8_t channels_of(Pixels format) {
  return format == Pixels::rgb888 ? 3 : format == Pixels::rgba8888 ? 4 : 1;
}

static bool wide(Pixels format) { return format == Pixels::l16 || format == Pixels::l16_swapped; }

static uint16_t value_at(Pixels format, const uint8_t* row, size_t index) {
  if (!wide(format)) return row[index];
  const uint16_t one = row[2 * index], two = row[2 * index + 1];
  return static_cast<uint16_t>(format == Pixels::l16 ? one | two << 8 : one << 8 | two);
}

// The mean of a channel times `scale`, rounded. At most 65535 * 65535^2 * 256 < 2^57.
static uint32_t mean(Pixels format, const uint8_t* const* in, size_t index, uint8_t channels, const Parts& across,
                     const Parts& down, uint16_t scale) {
  uint64_t sum = 0;
  for (uint8_t k = 0; k < down.count; ++k) {
    uint64_t line = 0;
    for (uint8_t i = 0; i < across.count; ++i)
      line += static_cast<uint64_t>(across.part[i]) * value_at(format, in[k], index + static_cast<size_t>(i) * channels);
    sum += line * down.part[k];
  }
  const uint64_t whole = static_cast<uint64_t>(across.whole) * down.whole;
  return static_cast<uint32_t>((sum * scale + whole / 2) / whole);
}

// Three means in Q8 about 128 to 128 + 127 n, n the unit vector along them; towards the eye where they cancel. Means are
// within +-32768, so the sum of squares fits 32 bits.
static void put_normal(const uint32_t* mean_q8, uint8_t* out) {
  int32_t n[3];
  uint32_t square = 0;
  for (uint8_t c = 0; c < 3; ++c) {
    n[c] = static_cast<int32_t>(mean_q8[c]) - 32768;
    square += static_cast<uint32_t>(n[c] * n[c]);
  }
  const int32_t length = base::square_root(square);
  for (uint8_t c = 0; c < 3; ++c) {
    const int32_t part = length > 0 ? static_cast<int32_t>(base::divide_round(n[c] * 127, length)) : c == 2 ? 127 : 0;
    out[c] = to_byte(128 + part);
  }
}

static void put_value(Pixels format, uint8_t* row, size_t index, uint16_t value) {
  if (wide(format)) put_16(row + 2 * index, value, format == Pixels::l16_swapped);
  else row[index] = static_cast<uint8_t>(value);
}

}  // namespace dapple::paint

namespace dapple {

void mip_row(const Mip& mip, const uint8_t* const* in, uint16_t y, uint8_t* out) {
  const uint8_t channels = paint::channels_of(mip.format);
  const paint::Parts down = paint::parts_of(mip.height, y);
  const uint16_t width = mip_side(mip.width);
  for (uint16_t x = 0; x < width; ++x) {
    const paint::Parts across = paint::parts_of(mip.width, x);
    const size_t from = static_cast<size_t>(2) * x * channels, to = static_cast<size_t>(x) * channels;
    uint32_t vector[3];
    for (uint8_t c = 0; c < channels; ++c) {
      const bool part = mip.normal && c < 3;
      const uint32_t value = paint::mean(mip.format, in, from + c, channels, across, down, part ? 256 : 1);
      if (part) vector[c] = value;
      else paint::put_value(mip.format, out, to + c, static_cast<uint16_t>(value));
    }
    if (mip.normal) paint::put_normal(vector, out + to);
  }
}

}  // namespace dapple
