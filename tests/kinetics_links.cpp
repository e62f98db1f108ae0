// The links of kinetics along a map: what they keep, and stretched diffusion where the map is one direction.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <vector>

#include "model/kinetics.hpp"
#include "stencil/diffuse.hpp"
#include "stencil/maps.hpp"

namespace stencil = dapple::stencil;

namespace {

// A torus of cells and its map, whose vectors point anywhere and are as long as may be.
template <class T>
struct Torus {
  static constexpr int kWidth = 37, kHeight = 24;
  std::vector<std::vector<T>> cells, map;  // rows with a halo of one
  std::vector<uint8_t> scratch = std::vector<uint8_t>(stencil::link_bytes(kWidth));
  std::vector<int32_t> sums;

  Torus(uint32_t seed, int32_t largest, bool random_map) : cells(kHeight), map(kHeight) {
    std::mt19937 random(seed);
    const auto wrapped = [&](auto make) {
      std::vector<T> row(kWidth + 2);
      for (int x = 1; x <= kWidth; ++x) row[x] = static_cast<T>(make());
      row[0] = row[kWidth], row[kWidth + 1] = row[1];
      return row;
    };
    for (int y = 0; y < kHeight; ++y) {
      cells[y] = wrapped([&] { return static_cast<int64_t>(random() % 3) * largest / 2; });
      map[y] = wrapped([&] {
        const uint16_t turn = static_cast<uint16_t>(random_map ? random() : 9000);
        return stencil::packed(random() % 9 == 0 && random_map ? stencil::Doubled{0, 0} : stencil::doubled_of(turn));
      });
    }
  }
  // One after the other, as a band does, or each as the first.
  void diffuse(stencil::LinkWeights w, bool first) {
    sums.assign(static_cast<size_t>(kWidth * kHeight), 0);
    dapple::grid::Rows rows{};
    rows.n = kWidth;
    for (int y = 0; y < kHeight; ++y) {
      const void* maps[3];
      for (int k = 0; k < 3; ++k) {
        rows.in[k] = cells[(y + k + kHeight - 1) % kHeight].data() + 1;
        maps[k] = map[(y + k + kHeight - 1) % kHeight].data() + 1;
      }
      rows.run = static_cast<uint16_t>(first ? 0 : y);
      rows.scratch = scratch.data();
      stencil::link_row(rows, maps, sizeof(T) == 4, w);
      rows.scratch += scratch.size();
      rows.out[0] = &sums[static_cast<size_t>(y * kWidth)];
      (sizeof(T) == 4 ? stencil::linked_wide_row : stencil::linked_narrow_row)(rows);
    }
  }
};

template <class T>
void check_diffusion(int32_t largest) {
  for (const int32_t stretch : {1000000, 1700000, dapple::kinetics::kStretch[1]})
    for (const bool random_map : {false, true})
      for (uint32_t seed = 0; seed < 20; ++seed) {
        Torus<T> torus(seed, largest, random_map);
        torus.diffuse(stencil::link_weights(stretch), false);
        const std::vector<int32_t> sums = torus.sums;
        torus.diffuse(stencil::link_weights(stretch), true);
        REQUIRE(torus.sums == sums);
        int64_t all = 0, size = 0;
        for (const int32_t sum : sums) all += sum, size += std::abs(sum);
        INFO(stretch << " " << random_map << " sum " << all << " of " << size);
        // What is taken here is given there, but for the last rounding.
        REQUIRE(std::llabs(all) <= static_cast<int64_t>(sums.size()));
        REQUIRE(size > 100000);
        // With dt D = 1/4 - and the bound leaves no more - a cell stays between the least and the greatest.
        for (int y = 0; y < torus.kHeight; ++y)
          for (int x = 0; x < torus.kWidth; ++x) {
            const int64_t cell = torus.cells[y][x + 1],
                          next = 4 * cell + sums[static_cast<size_t>(y * torus.kWidth + x)];
            REQUIRE(next >= -largest / 50);
            REQUIRE(next <= 4 * static_cast<int64_t>(largest) + largest / 50);
          }
      }
}

}  // namespace

TEST_CASE("along a map: diffusion gives what it takes, whatever the map, and cells stay within") {
  check_diffusion<int32_t>(20 << 20);
  check_diffusion<int16_t>(32767);
}

// One direction everywhere: what the eight neighbours of stretched diffusion give.
TEST_CASE("along a map: of one direction it is stretched diffusion, within a hundredth") {
  for (const int32_t stretch : {1000000, 1500000, 2000000, dapple::kinetics::kStretch[1]})
    for (int degrees = 0; degrees < 180; degrees += 5) {
      const int32_t angle = degrees * 1000000;
      Torus<int32_t> torus(3, 20 << 20, false);
      const uint16_t turn = static_cast<uint16_t>(2 * dapple::base::angle_of(angle));
      for (auto& row : torus.map) std::fill(row.begin(), row.end(), stencil::packed(stencil::doubled_of(turn)));
      torus.diffuse(stencil::link_weights(stretch), false);
      const stencil::EightWeights w = stencil::eight_weights(stretch, angle);
      const int32_t table[] = {w.x, w.y, w.fall, w.rise};
      int32_t sums[Torus<int32_t>::kWidth];
      double off = 0, size = 0;
      for (int y = 0; y < torus.kHeight; ++y) {
        dapple::grid::Rows rows{};
        for (int k = 0; k < 3; ++k) rows.in[k] = torus.cells[(y + k + torus.kHeight - 1) % torus.kHeight].data() + 1;
        rows.n = torus.kWidth;
        rows.table = table;
        rows.out[0] = sums;
        stencil::eight_wide_row(rows);
        for (int x = 0; x < torus.kWidth; ++x) {
          off = std::max(off, std::fabs(double(sums[x]) - torus.sums[static_cast<size_t>(y * torus.kWidth + x)]));
          size = std::max(size, std::fabs(double(sums[x])));
        }
      }
      INFO(stretch << " " << degrees << ": " << off << " of " << size);
      REQUIRE(off < 0.01 * size);
    }
}
