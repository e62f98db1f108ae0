// Directions from pictures. Integers throughout, so that a picture grows the same texture everywhere.
// SPDX-License-Identifier: MIT
#include "map_image.hpp"

#include <algorithm>

#include "base/math.hpp"
#include "pixmap.hpp"

namespace cli {

namespace {

constexpr uint32_t kBlocks = 64;  // a side: of the grid on which structure is measured

// The vector (c, s) with a length of 127 share / 256.
void put(std::vector<int8_t>& pairs, int64_t c, int64_t s, int64_t share) {
  while (c > (INT64_C(1) << 24) || c < -(INT64_C(1) << 24) || s > (INT64_C(1) << 24) || s < -(INT64_C(1) << 24))
    c /= 2, s /= 2;
  const int64_t root = dapple::base::square_root64(static_cast<uint64_t>(c * c + s * s) << 12);  // Q6
  const auto part = [&](int64_t v) {
    return dapple::stencil::to_q7(root == 0 ? 0 : static_cast<int32_t>(v * 127 * share / 4 / root));
  };
  pairs.push_back(part(c));
  pairs.push_back(part(s));
}

// Sums of a block: gx^2 - gy^2, 2 gx gy, gx^2 + gy^2 of the grey's central differences.
struct Tensor {
  int64_t c, s, all;
};
Tensor block_tensor(const Pixmap& p, uint32_t x0, uint32_t x1, uint32_t y0, uint32_t y1) {
  Tensor t{};
  for (int64_t y = y0; y < y1; ++y)
    for (int64_t x = x0; x < x1; ++x) {
      const int64_t gx = p.grey(x + 1, y) - p.grey(x - 1, y), gy = p.grey(x, y + 1) - p.grey(x, y - 1);
      t.c += gx * gx - gy * gy;
      t.s += 2 * gx * gy;
      t.all += gx * gx + gy * gy;
    }
  return t;
}

// Every cell from the 3 x 3 blocks around it; stripes lie across the gradient. Where less than half of the gradient
// agrees the vector is shorter; where there is none it is 0.
void from_structure(const Pixmap& p, uint32_t wide, uint32_t high, std::vector<int8_t>& pairs) {
  std::vector<Tensor> blocks;
  for (uint32_t j = 0; j < high; ++j)
    for (uint32_t i = 0; i < wide; ++i)
      blocks.push_back(block_tensor(p, i * p.width / wide, (i + 1) * p.width / wide, j * p.height / high,
                                    (j + 1) * p.height / high));
  for (uint32_t j = 0; j < high; ++j)
    for (uint32_t i = 0; i < wide; ++i) {
      Tensor sum{};
      for (uint32_t k = 0; k < 9; ++k) {
        const Tensor& t = blocks[(j + high - 1 + k / 3) % high * wide + (i + wide - 1 + k % 3) % wide];
        const int64_t weight = (k % 3 == 1 ? 2 : 1) * (k / 3 == 1 ? 2 : 1);
        sum.c += weight * t.c;
        sum.s += weight * t.s;
        sum.all += weight * t.all;
      }
      const int64_t agreed = std::max(std::max(sum.c, -sum.c), std::max(sum.s, -sum.s));
      put(pairs, -sum.c, -sum.s, sum.all == 0 ? 0 : std::min<int64_t>(256, 512 * agreed / sum.all));
    }
}

// The mean vector of every cell's pixels.
void from_values(const Pixmap& p, uint32_t wide, uint32_t high, std::vector<int8_t>& pairs) {
  for (uint32_t j = 0; j < high; ++j)
    for (uint32_t i = 0; i < wide; ++i) {
      int64_t c = 0, s = 0, count = 0;
      for (int64_t y = j * p.height / high; y < (j + 1) * p.height / high; ++y)
        for (int64_t x = i * p.width / wide; x < (i + 1) * p.width / wide; ++x, ++count) {
          const uint16_t turn = static_cast<uint16_t>(p.at(x, y, 0) << 8);
          c += p.channels == 1 ? dapple::base::cosine(turn) : (p.at(x, y, 0) - 128) * 258;
          s += p.channels == 1 ? dapple::base::sine(turn) : (p.at(x, y, 1) - 128) * 258;
        }
      pairs.push_back(dapple::stencil::to_q7(static_cast<int32_t>(c * 127 / (count * 32767))));
      pairs.push_back(dapple::stencil::to_q7(static_cast<int32_t>(s * 127 / (count * 32767))));
    }
}

}  // namespace

void read_map(const std::string& path, MapAs as, PictureMaps& to) {
  const Pixmap picture = read_pixmap(path);
  const uint32_t most = as == MapAs::structure ? kBlocks : static_cast<uint32_t>(dapple::kMostImage);
  const uint32_t wide = std::min(picture.width, most), high = std::min(picture.height, most);
  to.pairs.clear();
  if (as == MapAs::structure) from_structure(picture, wide, high, to.pairs);
  else from_values(picture, wide, high, to.pairs);
  to.maps.direction = {to.pairs.data(), static_cast<uint16_t>(wide), static_cast<uint16_t>(high)};
}

// At most kMostImage cells a side; cell(x0, x1, y0, y1) is called for the pixels of each.
template <class Cell>
static std::pair<uint16_t, uint16_t> each_cell(const Pixmap& p, Cell cell) {
  const uint32_t most = static_cast<uint32_t>(dapple::kMostImage);
  const uint32_t wide = std::min(p.width, most), high = std::min(p.height, most);
  for (uint32_t j = 0; j < high; ++j)
    for (uint32_t i = 0; i < wide; ++i)
      cell(i * p.width / wide, (i + 1) * p.width / wide, j * p.height / high, (j + 1) * p.height / high);
  return {static_cast<uint16_t>(wide), static_cast<uint16_t>(high)};
}

// The mean of value(x, y) over those pixels.
template <class Value>
static uint8_t mean_of(uint32_t x0, uint32_t x1, uint32_t y0, uint32_t y1, Value value) {
  uint64_t sum = 0;
  const uint64_t count = uint64_t{x1 - x0} * (y1 - y0);
  for (uint32_t y = y0; y < y1; ++y)
    for (uint32_t x = x0; x < x1; ++x) sum += value(x, y);
  return static_cast<uint8_t>((sum + count / 2) / count);
}

void read_styles(const std::string& path, PictureMaps& to) {
  const Pixmap picture = read_pixmap(path);
  to.styles.clear();
  const auto size = each_cell(picture, [&](uint32_t x0, uint32_t x1, uint32_t y0, uint32_t y1) {
    for (uint32_t channel = 0; channel < 3; ++channel)
      to.styles.push_back(mean_of(x0, x1, y0, y1, [&](uint32_t x, uint32_t y) {
        return picture.channels == 3 || channel == 0 ? picture.at(x, y, channel) : channel == 1 ? 128u : 255u;
      }));
  });
  to.maps.style = {to.styles.data(), size.first, size.second};
}

static dapple::GreyImage read_grey(const std::string& path, std::vector<uint8_t>& greys) {
  const Pixmap picture = read_pixmap(path);
  greys.clear();
  const auto size = each_cell(picture, [&](uint32_t x0, uint32_t x1, uint32_t y0, uint32_t y1) {
    greys.push_back(mean_of(x0, x1, y0, y1, [&](uint32_t x, uint32_t y) { return static_cast<uint32_t>(picture.grey(x, y)); }));
  });
  return {greys.data(), size.first, size.second};
}
void read_growth(const std::string& path, PictureMaps& to) { to.maps.grey = read_grey(path, to.greys); }
void read_grade(const std::string& path, PictureMaps& to) { to.maps.lengths = read_grey(path, to.lengths); }

}  // namespace cli
