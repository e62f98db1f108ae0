// A torus of one-bit cells that a cell program steps.
// SPDX-License-Identifier: MIT
#include "rule_torus.hpp"

#include "grid/rows.hpp"
#include "model/cells.hpp"
#include "start/start.hpp"

namespace cli {

constexpr size_t kBefore = 8, kBehind = 16;  // bytes around a row that the kernel may read

static uint64_t count_bits(uint64_t word) {
  uint64_t count = 0;
  for (; word != 0; word &= word - 1) ++count;
  return count;
}

Torus::Torus(uint16_t width, uint16_t height)
    : width_(width),
      height_(height),
      stride_(kBefore + (width + 63u) / 64 * 8 + kBehind),
      now_(stride_ * height),
      next_(stride_ * height) {}

uint8_t* Torus::at(uint16_t y) { return now_.data() + stride_ * y + kBefore; }
const uint8_t* Torus::row(uint16_t y) const { return now_.data() + stride_ * y + kBefore; }
bool Torus::get(uint16_t x, uint16_t y) const { return dapple::grid::get_bit(row(y), x); }
void Torus::set(uint16_t x, uint16_t y, bool on) { dapple::grid::put_bit(at(y), x, on); }

void Torus::noise(uint32_t seed) {
  const dapple::start::Place place = {dapple::grid::Cell::bit, width_, height_, 0, 0, 0, false, seed};
  for (uint16_t y = 0; y < height_; ++y) dapple::start::noise_row(place, {}, {0, 1, 0, 1}, 0, y, at(y));
}

void Torus::step(uint32_t program) {
  const int32_t number = static_cast<int32_t>(program);
  int32_t values[dapple::kMaxValues] = {};
  dapple::cells::values(&number, {0, 1}, values);
  for (uint16_t y = 0; y < height_; ++y) dapple::grid::wrap_row(dapple::grid::Cell::bit, at(y), width_, 1);
  dapple::grid::Rows rows{};
  rows.p = values;
  rows.n = width_;
  rows.planes = 1;
  for (uint16_t y = 0; y < height_; ++y) {
    rows.in[0] = row(static_cast<uint16_t>(y == 0 ? height_ - 1 : y - 1));
    rows.in[1] = row(y);
    rows.in[2] = row(static_cast<uint16_t>(y + 1 == height_ ? 0 : y + 1));
    rows.out[0] = next_.data() + stride_ * y + kBefore;
    dapple::cells::window_row(rows);
  }
  now_.swap(next_);
}

bool Torus::stable(uint32_t program) const {
  Torus next = *this;
  next.step(program);
  return next == *this;
}

uint64_t Torus::word(uint16_t y, size_t i) const {
  const uint64_t word = dapple::base::load_word<uint64_t>(row(y) + 8 * i);
  const size_t left = width_ - 64 * i;
  return left < 64 ? word & ((UINT64_C(1) << left) - 1) : word;
}

// A multiply and a shift a word: every cell changes about half of the bits.
uint64_t Torus::hash() const {
  uint64_t hash = UINT64_C(0xcbf29ce484222325);
  for (uint16_t y = 0; y < height_; ++y)
    for (size_t i = 0; 64 * i < width_; ++i) {
      hash = (hash ^ word(y, i)) * UINT64_C(0x9e3779b97f4a7c15);
      hash ^= hash >> 32;
    }
  return hash;
}

uint64_t Torus::count() const {
  uint64_t count = 0;
  for (uint16_t y = 0; y < height_; ++y)
    for (size_t i = 0; 64 * i < width_; ++i) count += count_bits(word(y, i));
  return count;
}

uint64_t Torus::count_different(const Torus& other) const {
  uint64_t count = 0;
  for (uint16_t y = 0; y < height_; ++y)
    for (size_t i = 0; 64 * i < width_; ++i) count += count_bits(word(y, i) ^ other.word(y, i));
  return count;
}

std::string text_of(const Torus& torus) {
  std::string text;
  for (uint16_t y = 0; y < torus.height(); ++y) {
    for (uint16_t x = 0; x < torus.width(); ++x) text += torus.get(x, y) ? 'o' : '.';
    text += '\n';
  }
  return text;
}

}  // namespace cli
