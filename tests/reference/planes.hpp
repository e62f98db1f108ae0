// Planes held plainly, every cell an int32, and whole-plane versions of what the machinery does row by row in place.
// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstdlib>
#include <vector>

#include "base/hash.hpp"
#include "grid/rows.hpp"

namespace reference {

namespace grid = dapple::grid;
using grid::Cell;

struct Planes {
  Cell cell;
  int32_t width, height, count;
  std::vector<int32_t> value;

  Planes(Cell c, int32_t w, int32_t h, int32_t n)
      : cell(c), width(w), height(h), count(n), value(static_cast<size_t>(w * h * n)) {}
  int32_t& at(int32_t plane, int32_t x, int32_t y) {
    const int32_t wrapped_x = (x % width + width) % width, wrapped_y = (y % height + height) % height;
    return value[static_cast<size_t>((plane * height + wrapped_y) * width + wrapped_x)];
  }
};

inline int32_t narrowed(Cell cell, uint32_t v) {
  return cell == Cell::bit     ? static_cast<int32_t>(v & 1)
         : cell == Cell::int16 ? static_cast<int16_t>(v)
                               : static_cast<int32_t>(v);
}

template <Cell cell>
int32_t load(const void* row, int32_t x) {
  if (cell == Cell::bit) return grid::get_bit(static_cast<const uint8_t*>(row), x);
  return cell == Cell::int16 ? static_cast<const int16_t*>(row)[x] : static_cast<const int32_t*>(row)[x];
}
template <Cell cell>
void store(void* row, int32_t x, int32_t v) {
  if (cell == Cell::bit) grid::put_bit(static_cast<uint8_t*>(row), x, v != 0);
  else if (cell == Cell::int16) static_cast<int16_t*>(row)[x] = static_cast<int16_t>(v);
  else static_cast<int32_t*>(row)[x] = v;
}
inline int32_t load(Cell cell, const void* row, int32_t x) {
  return cell == Cell::bit     ? load<Cell::bit>(row, x)
         : cell == Cell::int16 ? load<Cell::int16>(row, x)
                               : load<Cell::int32>(row, x);
}
inline void store(Cell cell, void* row, int32_t x, int32_t v) {
  cell == Cell::bit     ? store<Cell::bit>(row, x, v)
  : cell == Cell::int16 ? store<Cell::int16>(row, x, v)
                        : store<Cell::int32>(row, x, v);
}

inline uint32_t mix(uint32_t sum, int32_t v) { return dapple::base::mix(sum ^ static_cast<uint32_t>(v)) + 0x9e3779b9u; }

// A kernel in which every cell of the window matters, in order: every plane becomes a hash of the windows of all of
// them. p: {radius, halo, salt}.
template <Cell cell>
void mix_row(const grid::Rows& r) {
  const int32_t radius = r.p[0], halo = r.p[1], ring = 2 * radius + 1;
  for (int32_t x = 0; x < r.n; ++x) {
    uint32_t sum = static_cast<uint32_t>(r.p[2]);
    for (int32_t i = 0; i < r.planes && radius == 0; ++i) sum = mix(sum, load<cell>(r.out[i], x));
    for (int32_t row = 0; row < r.planes * ring && radius > 0; ++row)
      for (int32_t dx = -halo; dx <= halo; ++dx) sum = mix(sum, load<cell>(r.in[row], x + dx));
    for (int32_t i = 0; i < r.planes; ++i) store<cell>(r.out[i], x, narrowed(cell, mix(sum, i)));
  }
}
inline grid::RowKernel mix_kernel(Cell cell) {
  return cell == Cell::bit ? mix_row<Cell::bit> : cell == Cell::int16 ? mix_row<Cell::int16> : mix_row<Cell::int32>;
}

// The same over whole planes, first..first + count of them, double-buffered.
inline void naive_mix(Planes& planes, int32_t first, int32_t count, int32_t radius, int32_t stride, int32_t halo,
                      int32_t salt) {
  Planes old = planes;
  for (int32_t y = 0; y < old.height; ++y)
    for (int32_t x = 0; x < old.width; ++x) {
      uint32_t sum = static_cast<uint32_t>(salt);
      for (int32_t i = first; i < first + count; ++i)
        for (int32_t k = -radius; k <= radius; ++k)
          for (int32_t dx = radius == 0 ? 0 : -halo; dx <= (radius == 0 ? 0 : halo); ++dx)
            sum = mix(sum, old.at(i, x + dx, y + k * stride));
      for (int32_t i = 0; i < count; ++i) planes.at(first + i, x, y) = narrowed(old.cell, mix(sum, i));
    }
}

// Bilinear at cell centres: in quarters of a coarse cell the centres are 4 c + 2 and 2 f + 1; tent weights, sum 16.
inline Planes naive_refined(Planes& coarse) {
  Planes fine(coarse.cell, 2 * coarse.width, 2 * coarse.height, coarse.count);
  const auto weight = [](int32_t c, int32_t f) { return std::max(0, 4 - std::abs(4 * c + 2 - (2 * f + 1))); };
  for (int32_t i = 0; i < fine.count; ++i)
    for (int32_t y = 0; y < fine.height; ++y)
      for (int32_t x = 0; x < fine.width; ++x) {
        int64_t sum = 8;
        for (int32_t cy = y / 2 - 1; cy <= y / 2 + 1; ++cy)
          for (int32_t cx = x / 2 - 1; cx <= x / 2 + 1; ++cx)
            sum += int64_t{weight(cx, x)} * weight(cy, y) * coarse.at(i, cx, cy);
        fine.at(i, x, y) = static_cast<int32_t>((sum - ((sum % 16) + 16) % 16) / 16);  // floor
      }
  return fine;
}

}  // namespace reference
