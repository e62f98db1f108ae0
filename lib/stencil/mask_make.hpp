// How masks are made, in integers; constexpr, so that firmware can have them made by the compiler. See mask.hpp.
// SPDX-License-Identifier: MIT
#pragma once
#include "mask.hpp"

namespace dapple::stencil {

// exp(-t), t Q16 >= 0, Q30: 2^-whole times a polynomial for 2^-part (worst error 2e-5).
constexpr int32_t decay(int64_t t) {
  const int64_t power = (t * 94548) >> 16;  // log2(e) Q16
  if (power >= (INT64_C(30) << 16)) return 0;
  const int64_t f = power & 65535;  // Q16
  int64_t sum = 10327;              // .0096181 Q20
  sum = 58200 - ((sum * f) >> 16);  // .0555041
  sum = 251896 - ((sum * f) >> 16);
  sum = 726817 - ((sum * f) >> 16);
  sum = 1048576 - ((sum * f) >> 16);
  return static_cast<int32_t>((sum << 10) >> (power >> 16));
}

// u^2 and v^2 of cell (x, y), Q16.
constexpr int64_t square_q16(int64_t q15) { return (q15 * q15) >> 14; }

constexpr bool inside(const MaskShape& s, int16_t x, int16_t y) {
  const int16_t edge = static_cast<int16_t>(2 * s.radius + 1);
  return !s.isotropic || 4 * (x * x + y * y) <= edge * edge;
}

// K is the same at (x, y) and at (-x, -y): cells up to the centre are made, the others are those mirrored.
constexpr void add_kernels(const MaskShape& s, const int16_t* factor, uint8_t count, int32_t* kernel, uint16_t apart) {
  const int64_t milli = s.wavelength / 1000;
  const int64_t across = milli * milli * 657316 / 10000000;  // 2 s^2, 1e-6 cells^2
  const int64_t stretch = s.isotropic ? 1000 : s.stretch / 1000;
  const int64_t along = across * stretch * stretch / 1000000;
  const int64_t wide = across * 9 / 4, far = s.isotropic ? wide : along;
  const int64_t c = base::cosine(s.angle), n = base::sine(s.angle);
  const int16_t side = static_cast<int16_t>(2 * s.radius + 1), centre = static_cast<int16_t>(side * side / 2);
  for (uint8_t inhibitor = 0; inhibitor < 2; ++inhibitor) {
    const int64_t du = inhibitor ? far : along, dv = inhibitor ? wide : across;
    const auto value = [&](int16_t i) {
      const int16_t x = static_cast<int16_t>(i % side - s.radius), y = static_cast<int16_t>(i / side - s.radius);
      const int64_t u = x * c + y * n, v = y * c - x * n;
      return inside(s, x, y) ? decay(square_q16(u) * base::kMicro / du + square_q16(v) * base::kMicro / dv) : 0;
    };
    int64_t total = value(centre);
    for (int16_t i = 0; i < centre; ++i) total += INT64_C(2) * value(i);
    for (int16_t i = 0; i <= centre; ++i) {
      const int32_t share = static_cast<int32_t>((static_cast<int64_t>(value(i)) << 30) / total);
      for (uint8_t m = 0; m < count; ++m) {
        const int32_t part = static_cast<int32_t>((static_cast<int64_t>(share) * factor[m]) >> 15) * (inhibitor ? -1 : 1);
        kernel[m * apart + i] += part;
        if (i < centre) kernel[m * apart + 2 * centre - i] += part;
      }
    }
  }
}
constexpr void add_kernel(const MaskShape& s, int16_t factor, int32_t* kernel) { add_kernels(s, &factor, 1, kernel, 0); }

// Weights being rounded: scaled is the exact weight in Q8.
struct Rounding {
  Mask* mask;
  const int16_t* scaled;
  uint16_t cells, side;
  int16_t excess;
  bool used[kCells];
};

// How gladly cell i moves by `step`: its rounding error in that direction, Q8.
constexpr int16_t gain(const Rounding& r, uint16_t i, int16_t step) {
  return static_cast<int16_t>((r.scaled[i] - 256 * r.mask->weight[i]) * step);
}

constexpr void move(Rounding& r, uint16_t i, int16_t step) {
  r.mask->weight[i] = static_cast<int8_t>(r.mask->weight[i] + step);
  r.used[i] = true;
  r.excess = static_cast<int16_t>(r.excess + step);
}

constexpr void mend_pairs(Rounding& r) {
  const int16_t step = static_cast<int16_t>(r.excess > 0 ? -1 : 1);
  while (r.excess * step <= -2) {
    uint16_t best = r.cells;
    for (uint16_t i = 0; i < r.cells / 2; ++i)
      if (!r.used[i] && r.scaled[i] != 0 && (best == r.cells || gain(r, i, step) > gain(r, best, step))) best = i;
    if (best == r.cells) return;
    move(r, best, step);
    move(r, static_cast<uint16_t>(r.cells - 1 - best), step);
  }
}

// All cells that (x, y) from the centre, 0 <= y <= x, goes to under the symmetries of the square.
constexpr uint8_t orbit(const Rounding& r, uint8_t x, uint8_t y, uint16_t* cell) {
  uint8_t count = 0;
  const int16_t centre = static_cast<int16_t>(r.side / 2);
  for (uint8_t k = 0; k < 8; ++k) {
    const int16_t a = static_cast<int16_t>(k & 1 ? -(k & 4 ? y : x) : (k & 4 ? y : x));
    const int16_t b = static_cast<int16_t>(k & 2 ? -(k & 4 ? x : y) : (k & 4 ? x : y));
    const uint16_t at = static_cast<uint16_t>((centre + b) * r.side + centre + a);
    bool there = false;
    for (uint8_t i = 0; i < count; ++i) there = there || cell[i] == at;
    if (!there) cell[count++] = at;
  }
  return count;
}

constexpr void mend_orbits(Rounding& r) {
  const int16_t step = static_cast<int16_t>(r.excess > 0 ? -1 : 1);
  const uint8_t radius = static_cast<uint8_t>(r.side / 2);
  for (;;) {
    uint16_t best[8] = {}, cell[8] = {};
    uint8_t size = 0;
    for (uint8_t x = 1; x <= radius; ++x)
      for (uint8_t y = 0; y <= x; ++y) {
        const uint8_t count = orbit(r, x, y, cell);
        const bool fits = count <= -r.excess * step && !r.used[cell[0]] && r.scaled[cell[0]] != 0;
        if (!fits || (size > 0 && gain(r, cell[0], step) <= gain(r, best[0], step))) continue;
        size = count;
        for (uint8_t i = 0; i < count; ++i) best[i] = cell[i];
      }
    if (size == 0) return;
    for (uint8_t i = 0; i < size; ++i) move(r, best[i], step);
  }
}

// Rounds the scaled kernel to weights that sum to zero; false when a limit is broken.
constexpr bool round_mask(const int16_t* scaled, bool isotropic, uint8_t limit, Mask& mask) {
  Rounding r{};
  r.mask = &mask;
  r.scaled = scaled;
  r.side = static_cast<uint16_t>(2 * mask.radius + 1);
  r.cells = static_cast<uint16_t>(r.side * r.side);
  for (uint16_t i = 0; i < r.cells; ++i) {
    mask.weight[i] = static_cast<int8_t>(scaled[i] >= 0 ? (scaled[i] + 128) >> 8 : -((-scaled[i] + 128) >> 8));
    r.excess = static_cast<int16_t>(r.excess + mask.weight[i]);
  }
  if (isotropic) mend_orbits(r);
  else mend_pairs(r);
  mask.weight[r.cells / 2] = static_cast<int8_t>(mask.weight[r.cells / 2] - r.excess);
  mask.sum = 0;
  for (uint16_t i = 0; i < r.cells; ++i) {
    const int8_t w = mask.weight[i];
    if (w > limit || w < -limit) return false;
    if (w > 0) mask.sum = static_cast<int16_t>(mask.sum + w);
  }
  return mask.sum <= static_cast<int16_t>(kLargestSum);
}

constexpr bool make_mask(const MaskShape* shapes, uint8_t count, Mask& mask) {
  int32_t kernel[kCells] = {};
  int16_t scaled[kCells] = {};
  mask.radius = shapes[0].radius;
  for (uint8_t i = 0; i < count; ++i) add_kernel(shapes[i], 16384, kernel);
  const uint16_t cells = static_cast<uint16_t>((2 * mask.radius + 1) * (2 * mask.radius + 1));
  int32_t peak = 1;
  for (uint16_t i = 0; i < cells; ++i) peak = base::max(peak, kernel[i] < 0 ? -kernel[i] : kernel[i]);
  const uint8_t limit = count > 1 ? kLargestSummed : kLargestWeight;
  for (int32_t tenths = 10 * limit + 4; tenths >= 15; --tenths) {
    for (uint16_t i = 0; i < cells; ++i)
      scaled[i] = static_cast<int16_t>(static_cast<int64_t>(kernel[i]) * tenths * 256 / (INT64_C(10) * peak));
    if (round_mask(scaled, shapes[0].isotropic, limit, mask)) return mask.sum > 0;
  }
  return false;
}

constexpr bool make_taps(const int8_t* weight, uint8_t rows, uint8_t side, Taps& taps) {
  uint16_t made = 0;
  const uint16_t cells = static_cast<uint16_t>(rows * side);
  for (uint8_t negative = 0; negative < 2; ++negative)
    for (uint8_t place = 0; place < kPlaces; ++place) {
      const uint16_t before = made;
      for (uint16_t i = 0; i < cells; ++i) {
        const int16_t w = static_cast<int16_t>(negative ? -weight[i] : weight[i]);
        if (w >= (1 << kPlaces)) return false;
        if (w <= 0 || ((w >> place) & 1) == 0) continue;
        if (made == kMaxTaps) return false;
        taps.index[made++] = i;
      }
      taps.count[negative][place] = static_cast<uint8_t>(made - before);
    }
  return true;
}

constexpr uint16_t count_of(const Taps& taps) {
  uint16_t sum = 0;
  for (const auto& sign : taps.count)
    for (const uint8_t count : sign) sum = static_cast<uint16_t>(sum + count);
  return sum;
}

// The mask of the next row less this one's: 2 radius + 2 rows. Weights differ by at most 2 * 15.
constexpr bool make_change(const Mask& mask, Taps& taps) {
  int8_t weight[(kLargestSide + 1) * kLargestSide] = {};
  const uint16_t side = static_cast<uint16_t>(2 * mask.radius + 1);
  const uint16_t cells = static_cast<uint16_t>(side * side);
  for (uint16_t i = 0; i < cells + side; ++i)
    weight[i] = static_cast<int8_t>((i >= side ? mask.weight[i - side] : 0) - (i < cells ? mask.weight[i] : 0));
  return make_taps(weight, static_cast<uint8_t>(side + 1), static_cast<uint8_t>(side), taps);
}

constexpr bool make_set(const Mask* masks, uint8_t count, bool running, MaskSet& set) {
  set.count = count;
  set.radius = masks[0].radius;
  set.sum = masks[0].sum;
  set.running = running;
  const uint8_t side = static_cast<uint8_t>(2 * set.radius + 1);
  uint16_t whole = 0, change = 0;
  for (uint8_t i = 0; i < count; ++i) {
    if (!make_taps(masks[i].weight, side, side, set.whole[i])) return false;
    whole = static_cast<uint16_t>(whole + count_of(set.whole[i]));
    if (!set.running) continue;
    set.running = make_change(masks[i], set.whole[count + i]);
    if (set.running) change = static_cast<uint16_t>(change + count_of(set.whole[count + i]));
  }
  set.running = set.running && change + 10 * count < whole;
  return true;
}

constexpr bool make_masks(const MaskShape* shapes, uint8_t count, bool summed, bool running, MaskSet& set) {
  Mask masks[kMaxMasks] = {};
  if (summed) return make_mask(shapes, count, masks[0]) && make_set(masks, 1, running, set);
  for (uint8_t i = 0; i < count; ++i)
    if (!make_mask(shapes + i, 1, masks[i])) return false;
  return make_set(masks, count, running, set);
}

constexpr void weights_of(const Taps& taps, uint8_t radius, int8_t* weight) {
  const uint16_t side = static_cast<uint16_t>(2 * radius + 1);
  for (uint16_t k = 0; k < side * side; ++k) weight[k] = 0;
  uint16_t at = 0;
  for (uint8_t negative = 0; negative < 2; ++negative)
    for (uint8_t place = 0; place < kPlaces; ++place)
      for (uint8_t k = 0; k < taps.count[negative][place]; ++k, ++at)
        weight[taps.index[at]] = static_cast<int8_t>(weight[taps.index[at]] + (negative ? -(1 << place) : 1 << place));
}

}  // namespace dapple::stencil
