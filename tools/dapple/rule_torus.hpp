// A torus of one-bit cells that a cell program steps, any size from one cell on; the rows are the library's.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace cli {

// Called while work goes on; empty for nobody.
using Report = std::function<void(uint64_t done, uint64_t all)>;

class Torus {
 public:
  Torus(uint16_t width, uint16_t height);

  uint16_t width() const { return width_; }
  uint16_t height() const { return height_; }
  uint64_t cells() const { return uint64_t{width_} * height_; }
  bool get(uint16_t x, uint16_t y) const;
  void set(uint16_t x, uint16_t y, bool on);
  const uint8_t* row(uint16_t y) const;  // cell x is bit x mod 8 of byte x / 8

  // The start that recipes with start=noise have.
  void noise(uint32_t seed);
  void step(uint32_t program);
  // A program whose next state is the state itself leaves it as it is.
  bool stable(uint32_t program) const;

  uint64_t hash() const;
  uint64_t count() const;                              // cells that are on
  uint64_t count_different(const Torus& other) const;  // of the same size
  bool operator==(const Torus& other) const { return count_different(other) == 0; }

 private:
  uint8_t* at(uint16_t y);
  uint64_t word(uint16_t y, size_t i) const;  // 64 cells; 0 where the row has ended

  uint16_t width_, height_;
  size_t stride_;
  std::vector<uint8_t> now_, next_;
};

// A line a row, '.' for off and 'o' for on.
std::string text_of(const Torus& torus);

}  // namespace cli
