// Metrics of ready surfaces, and their inverses. See surface.hpp.
// SPDX-License-Identifier: MIT
#include "surface.hpp"

namespace dapple {

using base::divide_round;

// a b, Q16.
static int64_t times(int64_t a, int64_t b) { return (a * b + 32768) >> 16; }

// In 1/65536 turns: the middle of cell `at` of `size`.
static uint16_t turn_at(int32_t at, uint16_t size) {
  return static_cast<uint16_t>((2 * static_cast<uint32_t>(at) + 1) * UINT32_C(32768) / size);
}
// A sine in Q16.
static int64_t wide_sine(uint16_t turn) { return (static_cast<int64_t>(base::sine(turn)) * 65536 + 16384) / 32767; }
static int64_t to_q16(int32_t micro) { return divide_round(static_cast<int64_t>(micro) * 65536, base::kMicro); }
static Metric metric(int64_t xx, int64_t xy, int64_t yy) {
  const auto held = [](int64_t v) {
    return static_cast<int32_t>(v > kMostMetric ? kMostMetric : v < -kMostMetric ? -kMostMetric : v);
  };
  return {held(xx), held(xy), held(yy)};
}

// x_u = (1 + ratio cos 2 pi v), x_v = ratio width / height: lengths in cells.
static Metric torus_metric(const Surface& s, int32_t y) {
  const int64_t ratio = to_q16(s.ratio);
  const int64_t round = 65536 + times(ratio, wide_sine(static_cast<uint16_t>(turn_at(y, s.height) + 0x4000u)));
  const int64_t tube = ratio * s.width / s.height;
  return metric(times(round, round), 0, times(tube, tube));
}

// Radius a = 1 - ratio sin 2 pi v, v downwards: x_u = a, x_v = width / height (-ratio cos 2 pi v, tall) of the axis'
// two directions.
static Metric vase_metric(const Surface& s, int32_t y) {
  const int64_t ratio = to_q16(s.ratio);
  const uint16_t turn = turn_at(y, s.height);
  const int64_t radius = 65536 - times(ratio, wide_sine(turn));
  const int64_t out = times(ratio, wide_sine(static_cast<uint16_t>(turn + 0x4000u))) * s.width / s.height;
  const int64_t down = to_q16(s.tall) * s.width / s.height;
  return metric(times(radius, radius), 0, times(out, out) + times(down, down));
}

// Equal angles: X = tan a, Y = tan b, from -pi/4 to pi/4. With d = 1 + X^2 + Y^2 the metric is (1 + X^2)(1 + Y^2) / d^2
// [[1 + X^2, -X Y], [-X Y, 1 + Y^2]] of an angle; a cell in the middle of the face is the unit.
static Metric sphere_metric(const Surface& s, int32_t x, int32_t y) {
  const auto tangent = [&](int32_t at) {
    const uint16_t angle = static_cast<uint16_t>((2 * static_cast<int64_t>(at) + 1 - s.width) * 8192 / s.width);
    return wide_sine(angle) * 65536 / wide_sine(static_cast<uint16_t>(angle + 0x4000u));
  };
  const int64_t tx = tangent(x), ty = tangent(y), a = 65536 + times(tx, tx), b = 65536 + times(ty, ty);
  const int64_t d = a + b - 65536, factor = (times(a, b) << 16) / times(d, d);
  return metric(times(factor, a), -times(factor, times(tx, ty)), times(factor, b));
}

// 1 + grad h grad h^T; differences of neighbours, at a side that ends of one.
static Metric height_metric(const Surface& s, const int16_t* of, int32_t x, int32_t y) {
  const auto slope = [&](int32_t at, int32_t size, size_t step, size_t other) {
    const int32_t before = at > 0 ? at - 1 : s.open ? 0 : size - 1, after = at + 1 < size ? at + 1 : s.open ? at : 0;
    const int32_t cells = s.open && (at == 0 || at + 1 == size) ? 1 : 2;
    return (static_cast<int64_t>(of[static_cast<size_t>(after) * step + other]) -
            of[static_cast<size_t>(before) * step + other]) *
           256 / cells;  // Q16
  };
  const int64_t dx = slope(x, s.width, 1, static_cast<size_t>(y) * s.width),
                dy = slope(y, s.height, s.width, static_cast<size_t>(x));
  return metric(65536 + times(dx, dx), times(dx, dy), 65536 + times(dy, dy));
}

Metric metric_at(const Surface& s, uint8_t patch, int32_t x, int32_t y) {
  const size_t first = static_cast<size_t>(patch) * s.width * s.height;
  switch (s.shape) {
    case Surface::torus:
      return torus_metric(s, y);
    case Surface::vase:
      return vase_metric(s, y);
    case Surface::sphere:
      return sphere_metric(s, x, y);
    case Surface::heights:
      return height_metric(s, s.height_of + first, x, y);
    case Surface::tensors:
      return s.metric_of[first + static_cast<size_t>(y) * s.width + static_cast<size_t>(x)];
    case Surface::flat:
      break;
  }
  return {65536, 0, 65536};
}

// Principal values: (xx + yy -+ root) / 2 with root^2 = (xx - yy)^2 + 4 xy^2 < 2^63.
struct Principal {
  int64_t less, more;
};
static Principal principal(const Metric& m) {
  const int64_t difference = static_cast<int64_t>(m.xx) - m.yy, twice = 2 * static_cast<int64_t>(m.xy);
  const int64_t root =
      base::square_root64(static_cast<uint64_t>(difference * difference) + static_cast<uint64_t>(twice * twice));
  const int64_t sum = static_cast<int64_t>(m.xx) + m.yy;
  return {(sum - root) / 2, (sum + root) / 2};
}

static bool is_usable(const Metric& m) {
  if (m.xx < kLeastMetric || m.xx >= kMostMetric || m.yy < kLeastMetric || m.yy >= kMostMetric) return false;
  return m.xy < kMostMetric && m.xy > -kMostMetric && principal(m).less >= kLeastMetric;
}

static bool is_whole(const Surface& s) {
  if (s.width < kSmallestSide || s.height < kSmallestSide || s.patches < 1 || s.patches > kMostPatches) return false;
  const bool turned = s.shape == Surface::torus || s.shape == Surface::vase;
  if (turned && (s.ratio < (s.shape == Surface::torus ? 10000 : 0) || s.ratio > 950000)) return false;
  if (s.shape == Surface::vase && (s.tall < 10000 || s.tall > 10 * base::kMicro)) return false;
  if (s.shape == Surface::sphere && s.width != s.height) return false;
  return (s.shape != Surface::heights || s.height_of != nullptr) &&
         (s.shape != Surface::tensors || s.metric_of != nullptr);
}

// A cell: the least principal value, and half the difference of the inverse ones, Q24.
static bool measure_cell(Surface& s) {
  const Metric m = metric_at(s, s.patch, s.x, s.y);
  if (!is_usable(m)) return false;
  const Principal value = principal(m);
  s.least = value.less < s.least ? static_cast<int32_t>(value.less) : s.least;
  const int64_t one = INT64_C(1) << 40, apart = (one / value.less - one / value.more) / 2;
  s.spread = apart > s.spread ? apart : s.spread;
  return true;
}

// spread * least is at most a half in Q40; what is not 0 is at least 1/256.
static void finish(Surface& s) {
  s.lean = static_cast<int32_t>(
      (static_cast<uint64_t>(s.spread) * static_cast<uint64_t>(s.least) + (INT64_C(1) << 26) - 1) >> 26);
  if (s.lean > 0) s.lean = base::clamp(s.lean, 64, 8192);
}

Status measure(Surface& s, uint32_t rows) {
  if (!is_whole(s)) return bad_surface;
  for (; s.patch < s.patches; ++s.patch, s.y = 0)
    for (; s.y < s.height; ++s.y, s.x = 0) {
      if (rows-- == 0) return more;
      for (; s.x < s.width; ++s.x)
        if (!measure_cell(s)) return bad_surface;
      if (s.patch + 1 == s.patches && s.y + 1 == s.height) finish(s);
    }
  return done;
}

namespace stencil {

// The root of least / m, Q14, at most 1.
static int16_t root_of(int32_t least, int64_t m) {
  const uint32_t root = base::square_root64((static_cast<uint64_t>(least) << 28) / static_cast<uint64_t>(m));
  return static_cast<int16_t>(root > 16384 ? 16384 : root);
}

// Of the tensor [[1 / (p^2 + q^2) ...]] in the form that eq. (8) inverts: p = 1 / root xx, r = 1 / root (yy - xy^2 /
// xx), q = -r xy / xx.
static Inverse inverse_of(const Metric& m, int32_t least) {
  const int64_t rest = m.yy - divide_round(static_cast<int64_t>(m.xy) * m.xy, m.xx);
  const int16_t p = root_of(least, m.xx), r = root_of(least, rest > kLeastMetric ? rest : kLeastMetric);
  const int64_t q = -divide_round(static_cast<int64_t>(r) * m.xy, m.xx);
  return {p, static_cast<int16_t>(q < -16384 ? -16384 : q > 16384 ? 16384 : q), r};
}

Inverse inverse_at(const Surface& s, uint8_t level, uint8_t patch, int32_t x, int32_t y) {
  int64_t xx = 0, xy = 0, yy = 0;
  const int32_t side = INT32_C(1) << level, first_x = x << level, first_y = y << level;
  for (int32_t j = 0; j < side; ++j)
    for (int32_t i = 0; i < side; ++i) {
      const Metric m = metric_at(s, patch, first_x + i, first_y + j);
      xx += m.xx;
      xy += m.xy;
      yy += m.yy;
    }
  const int64_t cells = static_cast<int64_t>(side) * side;
  return inverse_of({static_cast<int32_t>(divide_round(xx, cells)), static_cast<int32_t>(divide_round(xy, cells)),
                     static_cast<int32_t>(divide_round(yy, cells))},
                    s.least);
}

// V V^T = [[p^2 + q^2, q r], [q r, r^2]] turned, and taken apart again.
Inverse turned_inverse(Inverse v, bool swapped, bool mirrored) {
  if (mirrored) v.q = static_cast<int16_t>(-v.q);
  if (!swapped) return v;
  const int32_t xx = static_cast<int32_t>(v.p) * v.p + static_cast<int32_t>(v.q) * v.q,
                xy = static_cast<int32_t>(v.q) * v.r, yy = static_cast<int32_t>(v.r) * v.r;
  const int32_t r = base::max(base::square_root(static_cast<uint32_t>(xx)), 1);
  const int32_t q = base::clamp(xy / r, -16384, 16384);
  return {static_cast<int16_t>(base::square_root(static_cast<uint32_t>(base::max(yy - q * q, 1)))),
          static_cast<int16_t>(q), static_cast<int16_t>(base::min(r, 16384))};
}

}  // namespace stencil

}  // namespace dapple
