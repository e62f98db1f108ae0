// PNG files (ISO 15948) without libpng: eight bits a channel or sixteen of grey, filters None, Sub and Up.
// SPDX-License-Identifier: MIT
#include <array>
#include <cstdlib>

#include "deflate.hpp"
#include "image.hpp"

namespace cli {

static constexpr std::array<uint32_t, 256> crc_table() {
  std::array<uint32_t, 256> table{};
  for (uint32_t i = 0; i < 256; ++i) {
    uint32_t crc = i;
    for (int bit = 0; bit < 8; ++bit) crc = crc & 1 ? 0xedb88320 ^ crc >> 1 : crc >> 1;
    table[i] = crc;
  }
  return table;
}
static constexpr std::array<uint32_t, 256> kCrc = crc_table();

static void put_big_endian(std::vector<uint8_t>& to, uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) to.push_back(static_cast<uint8_t>(value >> shift));
}

// Length, kind, bytes, and the CRC-32 of kind and bytes.
static void write_chunk(Output& out, const char* kind, const std::vector<uint8_t>& bytes) {
  std::vector<uint8_t> length, body(kind, kind + 4), sum;
  put_big_endian(length, static_cast<uint32_t>(bytes.size()));
  body.insert(body.end(), bytes.begin(), bytes.end());
  uint32_t crc = 0xffffffff;
  for (const uint8_t byte : body) crc = kCrc[(crc ^ byte) & 255] ^ crc >> 8;
  put_big_endian(sum, ~crc);
  for (const std::vector<uint8_t>& part : {length, body, sum}) out.write(part.data(), part.size());
}

// A row with a filter's number before it; `up` is the row above.
static void filter_row(uint8_t filter, const uint8_t* row, const uint8_t* up, size_t pixel, std::vector<uint8_t>& to) {
  to[0] = filter;
  for (size_t i = 0; i + 1 < to.size(); ++i) {
    const uint8_t guess = filter == 1 ? (i < pixel ? 0 : row[i - pixel]) : filter == 2 ? up[i] : 0;
    to[i + 1] = static_cast<uint8_t>(row[i] - guess);
  }
}

// Small differences pack well.
static uint64_t size_of_differences(const std::vector<uint8_t>& row) {
  uint64_t sum = 0;
  for (size_t i = 1; i < row.size(); ++i) sum += static_cast<uint64_t>(std::abs(static_cast<int8_t>(row[i])));
  return sum;
}

static void write_rows(Lines& lines, size_t pixel, Output& out) {
  constexpr size_t kChunk = 65536;
  std::vector<uint8_t> packed, above(lines.bytes()), best(lines.bytes() + 1), other(lines.bytes() + 1);
  Deflate deflate(packed);
  for (uint32_t i = lines.count(); i > 0; --i) {
    const uint8_t* row = lines.next();
    filter_row(0, row, above.data(), pixel, best);
    for (const uint8_t filter : {1, 2}) {
      filter_row(filter, row, above.data(), pixel, other);
      if (size_of_differences(other) < size_of_differences(best)) best.swap(other);
    }
    above.assign(row, row + lines.bytes());
    deflate.add(best.data(), best.size());
    if (packed.size() < kChunk) continue;
    write_chunk(out, "IDAT", packed);
    packed.clear();
  }
  deflate.finish();
  write_chunk(out, "IDAT", packed);
}

void write_png_own(Lines& lines, Output& out) {
  const bool deep = lines.pixels() == dapple::Pixels::l16_swapped;
  const bool grey = deep || lines.pixels() == dapple::Pixels::l8, alpha = lines.pixels() == dapple::Pixels::rgba8888;
  const uint8_t signature[8] = {137, 'P', 'N', 'G', 13, 10, 26, 10};
  out.write(signature, sizeof signature);
  std::vector<uint8_t> header;
  put_big_endian(header, lines.width());
  put_big_endian(header, lines.height());
  const uint8_t colour_type = grey ? 0 : alpha ? 6 : 2;
  const uint8_t depth = deep ? 16 : 8;
  for (const uint8_t byte : {depth, colour_type, uint8_t{0}, uint8_t{0}, uint8_t{0}}) header.push_back(byte);
  write_chunk(out, "IHDR", header);
  write_rows(lines, lines.bytes() / lines.width(), out);
  write_chunk(out, "IEND", {});
}

}  // namespace cli
