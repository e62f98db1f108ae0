// The wavelength a mask grows: where its transfer function peaks.
// SPDX-License-Identifier: MIT
#include "mask.hpp"

namespace dapple::stencil {

// Sum of weight * cos(k . x) for a wave of `phase` 1/65536 turns a cell along (nx, ny), Q15.
static int32_t transfer(const Mask& mask, int32_t phase, int32_t nx, int32_t ny) {
  const int16_t r = mask.radius;
  const int32_t across = (phase * nx) >> 7, down = (phase * ny) >> 7;  // Q8; phase < 2^15
  const int8_t* weight = mask.weight;
  int32_t sum = 0;
  for (int16_t y = static_cast<int16_t>(-r); y <= r; ++y)
    for (int16_t x = static_cast<int16_t>(-r); x <= r; ++x, ++weight)
      if (*weight != 0) sum += INT32_C(1) * *weight * base::cosine(static_cast<uint16_t>((across * x + down * y) >> 8));
  return sum;
}

// The same for the mask's own direction across the stripes, or the mean of four where it has none.
static int32_t response(const Mask& mask, const MaskShape& shape, int32_t phase) {
  if (!shape.isotropic) return transfer(mask, phase, -base::sine(shape.angle), base::cosine(shape.angle));
  int32_t sum = 0;
  for (uint16_t k = 0; k < 4; ++k) {
    const uint16_t angle = static_cast<uint16_t>(1024 + 2048 * k);  // 5.6 to 39 degrees; the rest is symmetric
    sum += transfer(mask, phase, base::cosine(angle), base::sine(angle)) / 4;
  }
  return sum;
}

int32_t peak_wavelength(const Mask& mask, const MaskShape& shape) {
  const int32_t middle = static_cast<int32_t>(base::divide_round(INT64_C(65536) * base::kMicro, shape.wavelength));
  const int32_t step = middle / 48;
  int32_t best = 0, at = middle, before = 0, after = 0, last = 0;
  for (int32_t phase = middle - 12 * step; phase <= middle + 30 * step && phase < 32768; phase += step) {
    const int32_t now = response(mask, shape, phase);
    if (at == phase - step) after = now;
    if (now > best) {
      best = now;
      at = phase;
      before = last;
      after = now;
    }
    last = now;
  }
  // The parabola through the three points around the peak.
  const int32_t curve = 2 * best - before - after;
  const int32_t shift = curve > 0 ? static_cast<int32_t>(static_cast<int64_t>(step) * (after - before) / (2 * static_cast<int64_t>(curve))) : 0;
  return static_cast<int32_t>(INT64_C(65536) * base::kMicro / (at + shift));
}

}  // namespace dapple::stencil
