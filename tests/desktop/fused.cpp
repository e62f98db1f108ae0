// Passes fused in cache against the definition, cell by cell: any directions and strides, one or many, sizes at which
// halos are wider than rows, and rows too short for several of them to be taken as one.
// SPDX-License-Identifier: MIT
#include "fused.hpp"

#include <doctest/doctest.h>

#include "../../lib/base/hash.hpp"
#include "../../lib/stencil/lattice.hpp"
#include "each_table.hpp"

namespace desktop = dapple::desktop;
namespace evolve = dapple::evolve;
namespace grid = dapple::grid;
namespace stencil = dapple::stencil;

namespace {

struct Plane {
  uint16_t width, height;
  std::vector<int16_t> cells;  // rows of whole words

  size_t pitch() const { return grid::row_bytes(grid::Cell::int16, width) / 2; }
  int32_t at(int32_t x, int32_t y) const {
    const int32_t w = width, h = height;
    return cells[static_cast<size_t>((y % h + h) % h) * pitch() + static_cast<size_t>((x % w + w) % w)];
  }
  evolve::Field field() {
    return {reinterpret_cast<uint8_t*>(cells.data()),
            cells.size() * 2,
            pitch() * 2,
            nullptr,
            0,
            width,
            height,
            grid::Cell::int16,
            1};
  }
};

Plane noise(uint16_t width, uint16_t height) {
  Plane plane{width, height, {}};
  plane.cells.resize(plane.pitch() * height);
  for (size_t i = 0; i < plane.cells.size(); ++i)
    plane.cells[i] = static_cast<int16_t>(dapple::base::below(dapple::base::mix(static_cast<uint32_t>(i) + 1), 16001));
  return plane;
}

struct Random {
  uint32_t state;
  int32_t between(int32_t low, int32_t high) {
    return low +
           static_cast<int32_t>(dapple::base::below(dapple::base::mix(++state), static_cast<uint32_t>(high - low) + 1));
  }
};

// A pass along any direction, rows included, that goes into the height.
evolve::Sweep any_pass(Random& random, uint16_t height, grid::RowKernel row) {
  const int32_t vx = random.between(-3, 3), vy = vx == 0 ? random.between(1, 3) : random.between(0, 3);
  const int32_t most = vy == 0 ? 60 : height / 4 / vy, stride = random.between(1, most < 9 || vy == 0 ? most : 9);
  const bool full = random.between(0, 1) == 0;
  evolve::Sweep s{};
  s.row = row;
  s.count = s.radius = 1;
  s.stride = static_cast<uint16_t>(stride * vy);
  s.halo = static_cast<uint16_t>(stride * (vx < 0 ? -vx : vx));
  s.p[0] = stride * vx;
  s.p[1] = full ? stencil::kQuarter : 2 * random.between(stencil::kSmallestWeight / 2, stencil::kQuarter / 2 - 1);
  s.p[2] = full ? random.between(1, 2) : dapple::base::rounding_for(static_cast<int16_t>(s.p[1]));
  return s;
}

Plane passed(const Plane& old, const evolve::Sweep& s) {
  Plane plane = old;
  for (int32_t y = 0; y < plane.height; ++y)
    for (int32_t x = 0; x < plane.width; ++x) {
      const int32_t c = old.at(x, y), sum = old.at(x - s.p[0], y - s.stride) + old.at(x + s.p[0], y + s.stride);
      plane.cells[static_cast<size_t>(y) * plane.pitch() + static_cast<size_t>(x)] =
          static_cast<int16_t>(c + (((sum - 2 * c + s.p[2]) * s.p[1]) >> 16));
    }
  return plane;
}

uint32_t different(const Plane& a, const Plane& b) {
  uint32_t count = 0;
  for (int32_t y = 0; y < a.height; ++y)
    for (int32_t x = 0; x < a.width; ++x) count += a.at(x, y) != b.at(x, y) ? 1 : 0;
  return count;
}

}  // namespace

TEST_CASE("fused: passes along any directions are those of the definition, by every table") {
  Random random{7};
  desktop::Fused fused;
  for (const uint16_t width : {uint16_t{1}, uint16_t{7}, uint16_t{34}, uint16_t{64}, uint16_t{131}, uint16_t{256},
                               uint16_t{515}, uint16_t{2100}})
    for (const uint16_t height : {uint16_t{12}, uint16_t{37}, uint16_t{90}})
      for (const size_t count : {size_t{1}, size_t{2}, size_t{9}, size_t{40}})
        tests::each_table([&](const desktop::Table& table) {
          const grid::RowKernel row = grid::choose(table.kernels, stencil::pass_row);
          std::vector<evolve::Sweep> sweeps;
          Plane plane = noise(width, height), want = plane;
          for (size_t i = 0; i < count; ++i) {
            sweeps.push_back(any_pass(random, height, row));
            want = passed(want, sweeps.back());
          }
          fused.run(plane.field(), {sweeps.data(), sweeps.size(), true, true, nullptr, nullptr});
          CAPTURE(width);
          CAPTURE(height);
          CAPTURE(count);
          CHECK(different(plane, want) == 0);
        });
}
