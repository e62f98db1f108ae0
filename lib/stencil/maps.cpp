// Rows of direction maps. See maps.hpp for the formulas.
// SPDX-License-Identifier: MIT
#include "maps.hpp"

#include "../grid/corners.hpp"

namespace dapple::stencil {

static int32_t folded(int32_t i, int32_t size) {
  const int32_t rest = i % size;
  return rest < 0 ? rest + size : rest;
}

// (2 at + 1) * factor / size, at < size <= 65535, factor <= 32768: the product is below 2^32. A factor of 32768 makes
// the centre of a cell in 1/65536 of the period.
static uint32_t centre(uint16_t at, uint16_t size, uint16_t factor) {
  return (2u * static_cast<uint32_t>(at) + 1u) * factor / size;
}

// round(127 a / b), away from zero; 0 < b <= 2^24 / 3, |a| <= b: the products stay below 2^31.
static int8_t share(int32_t a, int32_t b) {
  const int32_t n = 127 * a + (a < 0 ? -(b / 2) : b / 2);
  return to_q7(n / b);
}

// Of a doubled angle in 1/65536 turns, 127 long.
static Doubled turned(uint16_t turn) {
  return {to_q7((127 * static_cast<int32_t>(base::cosine(turn)) + 16384) >> 15),
          to_q7((127 * static_cast<int32_t>(base::sine(turn)) + 16384) >> 15)};
}

// 2 theta from g: (gx^2 - gy^2, 2 gx gy) / (g^2 + core). g in Q10, squares in Q20.
static Doubled radial(const DirectionMap& m, uint16_t u, int32_t gy) {
  const int32_t gx = (base::sine(u) + 16) >> 5;
  const int32_t den = gx * gx + gy * gy + m.core;
  return {share(gx * gx - gy * gy, den), share(2 * gx * gy, den)};
}

// 2 theta = pi + 2 pi i / 3, i = 0..2, mixed. Weights Q15: three squarings of (1 + cos) / 2.
static Doubled haunch(uint16_t phase) {
  int32_t weight[3] = {};
  for (uint8_t i = 0; i < 3; ++i) {
    int32_t w = (32768 + static_cast<int32_t>(base::cosine(static_cast<uint16_t>(phase - 21845u * i)))) >> 1;
    for (uint8_t k = 0; k < 3; ++k) w = (w * w + 16384) >> 15;
    weight[i] = w;
  }
  // Q12; at least .1 long: where two of three meet.
  const int32_t a = ((weight[1] + weight[2]) / 2 - weight[0]) >> 3;
  const int32_t b = ((weight[2] - weight[1]) * 7094 >> 13) >> 3;  // sin 60 = .86597
  return unit_of(a, b);
}

// Doubled angles in 1/65536 turns: 2 theta / 2 pi.
static Doubled two_angle(uint8_t index, uint16_t u, uint16_t v) {
  const auto sine = [](uint32_t turn) { return static_cast<int32_t>(base::sine(static_cast<uint16_t>(turn))); };
  const uint32_t a = u, b = v;
  if (index == 0)  // sin sin + .4 / pi sin
    return turned(static_cast<uint16_t>(((sine(a) * sine(b)) >> 14) + ((sine(a + b) * 8344) >> 15)));
  const int32_t waves = sine(2 * a - b) + sine(a + 2 * b + 0x4000u);  // .9 / pi of them
  return turned(static_cast<uint16_t>(0x8000 + (((waves >> 1) * 18775) >> 14)));
}

// Smoothstep of t, Q12.
static int32_t smooth(int32_t t) { return (((t * t) >> 12) * (3 * 4096 - 2 * t)) >> 12; }

// Of colour 1 at the four corners, bilinear, Q12: 0 or 4096 at a corner.
static Doubled bent_by_corners(const DirectionMap& m, uint16_t u, uint16_t v) {
  const uint8_t i = static_cast<uint8_t>(u >> 14), j = static_cast<uint8_t>(v >> 14);
  const int32_t x = smooth((u & 16383) >> 2), y = smooth((v & 16383) >> 2);
  const auto colour = [&](uint8_t right, uint8_t below) {
    return static_cast<int32_t>(grid::corner_colour(static_cast<uint8_t>(i + right), static_cast<uint8_t>(j + below)));
  };
  const int32_t above = colour(0, 0) * (4096 - x) + colour(1, 0) * x, under = colour(0, 1) * (4096 - x) + colour(1, 1) * x;
  const int32_t weight = (above * (4096 - y) + under * y) >> 12;
  return unit_of(m.c2, (m.s2 * (2 * weight - 4096)) >> 12);
}

// The discs that may hold cells of a row, the lowest first. Lengths in Q12 of a disc's pitch.
struct Discs {
  int16_t dy[8];
  bool odd[8];
  uint8_t count;
};
constexpr int32_t kDisc = 2458;  // .6

static Discs discs_at(const DirectionMap& m, uint16_t at) {
  Discs discs{};
  const int32_t high = base::max(1, static_cast<int32_t>(static_cast<int64_t>(m.height) * m.across * 4096 / m.width));
  const int32_t y = static_cast<int32_t>((2 * static_cast<int64_t>(at) + 1) * m.across * 2048 / m.width);
  int32_t k = static_cast<int32_t>(static_cast<int64_t>(y + kDisc) * m.down / high) + 1;
  for (; discs.count < 8; --k) {
    const int32_t dy = y - static_cast<int32_t>(static_cast<int64_t>(k) * high / m.down);
    if (dy > kDisc) break;
    if (dy < -kDisc) continue;
    discs.dy[discs.count] = static_cast<int16_t>(dy);
    discs.odd[discs.count++] = (k & 1) != 0;
  }
  return discs;
}

static Doubled scallop(const DirectionMap& m, const Discs& discs, uint16_t at) {
  const int32_t x = static_cast<int32_t>(centre(at, m.width, static_cast<uint16_t>(m.across * 2048u)));
  for (uint8_t i = 0; i < discs.count; ++i) {
    const int32_t dx = ((x + (discs.odd[i] ? 0 : 2048)) & 4095) - 2048, dy = discs.dy[i];
    const int32_t square = dx * dx + dy * dy;
    if (square <= kDisc * kDisc && square > 0) return {share(dy * dy - dx * dx, square), share(-2 * dx * dy, square)};
  }
  return {127, 0};
}

// The four cells of an image around a place.
struct Corners {
  int32_t c[4], s[4], length[4];  // length in Q4, at most 127
};

static void load_corner(const DirectionImage& image, int32_t i, int32_t j, uint8_t k, Corners& q) {
  const int8_t* pair = image.pairs + 2 * (static_cast<size_t>(folded(j, image.height)) * image.width +
                                          static_cast<size_t>(folded(i, image.width)));
  q.c[k] = pair[0];
  q.s[k] = pair[1];
  const uint32_t square = static_cast<uint32_t>(q.c[k] * q.c[k] + q.s[k] * q.s[k]);
  q.length[k] = base::min(base::square_root(square << 8), 127 * 16);
}

// Weights Q8 a side, sums Q16. The vector's mean in Q8, at most 46341 long, gets the mean length.
static Doubled blended(const Corners& q, int32_t fx, int32_t fy) {
  const auto mean = [&](const int32_t* v) {
    return (v[0] * (256 - fx) + v[1] * fx) * (256 - fy) + (v[2] * (256 - fx) + v[3] * fx) * fy;
  };
  const int32_t c = mean(q.c) >> 8, s = mean(q.s) >> 8, length = mean(q.length) >> 16;
  const int32_t root = base::square_root(static_cast<uint32_t>(c * c) + static_cast<uint32_t>(s * s));
  if (root == 0) return {0, 0};
  return {to_q7((c * length / root + 8) >> 4), to_q7((s * length / root + 8) >> 4)};
}

// Image cell centres lie at (i + 1/2) / width of the period.
static void image_row(const DirectionMap& m, uint16_t row, uint16_t n, int16_t* out) {
  const DirectionImage& image = images_of(m).direction;
  const int32_t y = static_cast<int32_t>(centre(row, m.height, static_cast<uint16_t>(128u * image.height))) - 128;
  uint16_t at = static_cast<uint16_t>(folded(m.x, m.width));
  Corners q{};
  int32_t held = INT32_MIN;
  for (uint16_t x = 0; x < n; ++x) {
    const int32_t place = static_cast<int32_t>(centre(at, m.width, static_cast<uint16_t>(128u * image.width))) - 128;
    const int32_t i = place >> 8;
    for (uint8_t k = 0; k < 4 && i != held; ++k) load_corner(image, i + (k & 1), (y >> 8) + (k >> 1), k, q);
    held = i;
    out[x] = packed(blended(q, place & 255, y & 255));
    at = static_cast<uint16_t>(at + 1 == m.width ? 0 : at + 1);
  }
}

extern const ImageWork image_work = {image_row};

static void swirl_row(const DirectionField& field, int32_t y, uint16_t n, int16_t* out) {
  constexpr uint8_t kAtOnce = 32;
  int8_t c2[kAtOnce], s2[kAtOnce];
  for (uint16_t x = 0; x < n; x = static_cast<uint16_t>(x + kAtOnce)) {
    const uint8_t count = static_cast<uint8_t>(base::min(kAtOnce, n - x));
    directions(field, x, y, count, c2, s2);
    for (uint8_t k = 0; k < count; ++k) out[x + k] = packed({c2[k], s2[k]});
  }
}

void map_row(const DirectionMap& m, uint8_t index, int32_t y, uint16_t n, int16_t* out) {
  y = folded(y, m.rows);
  if (m.kind == DirectionMap::swirl) return swirl_row(m.field, y, n, out);
  const uint16_t row = static_cast<uint16_t>(folded(m.y + y, m.height));
  if (m.kind == DirectionMap::image) return images_of(m).direction.work->row(m, row, n, out);
  const uint16_t v = static_cast<uint16_t>(centre(row, m.height, 32768u));
  const int32_t gy = (base::sine(v) + 16) >> 5;
  const uint16_t bent = static_cast<uint16_t>((static_cast<int32_t>(base::sine(v)) * 6554) >> 15);  // .1 sin 2 pi v
  const Discs discs = m.kind == DirectionMap::scallop ? discs_at(m, row) : Discs{};
  uint16_t at = static_cast<uint16_t>(folded(m.x, m.width));
  for (uint16_t x = 0; x < n; ++x) {
    const uint16_t u = static_cast<uint16_t>(centre(at, m.width, 32768u));
    Doubled d = {127, 0};
    switch (m.kind) {
      case DirectionMap::radial:
        d = radial(m, u, gy);
        break;
      case DirectionMap::scallop:
        d = scallop(m, discs, at);
        break;
      case DirectionMap::haunch:
        d = haunch(static_cast<uint16_t>(u + bent));
        break;
      case DirectionMap::two_angle:
        d = two_angle(index, u, v);
        break;
      case DirectionMap::corners:
        d = bent_by_corners(m, u, v);
        break;
      default:
        break;
    }
    out[x] = packed(d);
    at = static_cast<uint16_t>(at + 1 == m.width ? 0 : at + 1);
  }
}

// The map as it is around a cell of a patch.
static DirectionMap placed(const DirectionMap& m, const Patches& all, uint8_t patch, int32_t x, int32_t y) {
  DirectionMap at = m;
  at.x = x;
  at.y = y;
  at.field.x = (all.patch[patch].x >> m.level) + x;
  at.field.y = (all.patch[patch].y >> m.level) + y;
  return at;
}

static void ghost_direction(const DirectionMap& m, const Patches& all, uint8_t index, const grid::Source& s,
                            int16_t* out) {
  map_row(placed(m, all, s.patch, s.x, s.y), index, 0, 1, out);
  const int8_t c = static_cast<int8_t>(*out & 255), n = static_cast<int8_t>(*out >> 8);
  *out = packed({to_q7(s.swapped ? -c : c), to_q7(s.mirrored ? -n : n)});
}

void patch_row(const DirectionMap& m, uint8_t index, int32_t y, uint16_t n, int16_t* out) {
  const Patches* const all = patches_of(m);
  const int32_t at = folded(y, m.rows) - m.pad;
  const bool inside = at >= 0 && at < m.height;
  if (inside) map_row(placed(m, *all, m.patch, 0, at), index, 0, m.width, out + m.pad);
  for (int32_t x = 0; x < n; ++x) {
    if (inside && x == m.pad) x += m.width;
    ghost_direction(m, *all, index, grid::source_of(*all, m.level, m.patch, x - m.pad, at), out + x);
  }
}

// On a torus the cell itself, rolled.
static grid::Source source_on(const DirectionMap& m, int32_t x, int32_t y) {
  const Patches* const all = patches_of(m);
  if (all != nullptr) return all->work->source_of(*all, m.level, m.patch, x - m.pad, y - m.pad);
  return {0, folded(m.x + x, m.width), folded(m.y + y, m.height), false, false, nullptr};
}

void inverse_row(const DirectionMap& m, int32_t y, uint16_t n, int16_t* const* out) {
  const Surface& surface = *images_of(m).surface;
  for (int32_t x = 0; x < n; ++x) {
    const grid::Source s = source_on(m, x, folded(y, m.rows));
    const uint8_t patch = static_cast<uint8_t>(surface.patches == 1 ? 0 : s.patch);
    const Inverse v = turned_inverse(inverse_at(surface, m.level, patch, s.x, s.y), s.swapped, s.mirrored);
    out[0][x] = v.p;
    out[1][x] = v.q;
    out[2][x] = v.r;
  }
}

// A channel between four cells: bytes to Q8. channels: of a cell; 1 of a grey picture.
struct Bytes {
  const uint8_t* cells;
  uint16_t width, height;
  uint8_t channels;
};
static int32_t between(const Bytes& image, int32_t px, int32_t py, uint8_t channel) {
  const auto cell = [&](int32_t i, int32_t j) {
    return static_cast<int32_t>(image.cells[image.channels * (static_cast<size_t>(folded(j, image.height)) * image.width +
                                                              static_cast<size_t>(folded(i, image.width))) +
                                            channel]);
  };
  const int32_t i = px >> 8, j = py >> 8, fx = px & 255, fy = py & 255;
  const int32_t above = cell(i, j) * (256 - fx) + cell(i + 1, j) * fx,
                below = cell(i, j + 1) * (256 - fx) + cell(i + 1, j + 1) * fx;
  return (above * (256 - fy) + below * fy) >> 8;
}

void style_row(const DirectionMap& m, int32_t y, uint16_t n, int16_t* lack, int16_t* rho_k) {
  const StyleImage& style = images_of(m).style;
  const Bytes image = {style.cells, style.width, style.height, 3};
  const uint16_t row = static_cast<uint16_t>(folded(m.y + folded(y, m.rows), m.height));
  const int32_t py = static_cast<int32_t>(centre(row, m.height, static_cast<uint16_t>(128u * image.height))) - 128;
  uint16_t at = static_cast<uint16_t>(folded(m.x, m.width));
  for (uint16_t x = 0; x < n; ++x) {
    const int32_t px = static_cast<int32_t>(centre(at, m.width, static_cast<uint16_t>(128u * image.width))) - 128;
    const int32_t share =
        base::max(between(image, px, py, 0), INT32_C(64) * 256) * 32767 / INT32_C(65280);  // Q15; 65280 is 255 in Q8
    lack[x] = static_cast<int16_t>(32766 - ((share * share) >> 15));
    const int32_t rho = ((between(image, px, py, 1) + 128) >> 8) - 128, k = (between(image, px, py, 2) + 128) >> 8;
    rho_k[x] = static_cast<int16_t>((static_cast<uint16_t>(rho) << 8) | static_cast<uint16_t>(k));
    at = static_cast<uint16_t>(at + 1 == m.width ? 0 : at + 1);
  }
}

// Grades are in Q15, 0..32767; a cosine of 32767 makes the wavelength the recipe's.
static int32_t grade_of(const DirectionMap& m, Grade::Kind kind, uint16_t at_x, uint16_t at_y) {
  const auto wave = [](uint16_t at, uint16_t size) {
    return (32768 + static_cast<int32_t>(base::cosine(static_cast<uint16_t>(centre(at, size, 32768u))))) >> 1;
  };
  if (kind == Grade::across) return wave(at_x, m.width);
  if (kind == Grade::down) return wave(at_y, m.height);
  if (kind == Grade::centre) return (wave(at_x, m.width) + wave(at_y, m.height)) >> 1;
  const GreyImage& image = images_of(m).lengths;
  return (image.work->at(image, m, at_x, at_y) * 257) >> 9;
}

void grade_row(const DirectionMap& m, Grade grade, int32_t y, uint16_t n, int16_t* out) {
  for (int32_t x = 0; x < n; ++x) {
    const grid::Source s = source_on(m, x, folded(y, m.rows));
    const int32_t part = grade_of(m, grade.kind, static_cast<uint16_t>(s.x), static_cast<uint16_t>(s.y));
    const int32_t share = grade.finest + (((4096 - grade.finest) * part + 16384) >> 15);  // Q12
    out[x] = static_cast<int16_t>((share * share + 16384) >> 15);
  }
}

static int32_t grey_at(const GreyImage& grey, const DirectionMap& m, uint16_t x, uint16_t y) {
  const auto place = [](uint16_t at, uint16_t size, uint16_t cells) {
    return static_cast<int32_t>(centre(at, size, static_cast<uint16_t>(128u * cells))) - 128;
  };
  const Bytes image = {grey.cells, grey.width, grey.height, 1};
  return between(image, place(x, m.width, grey.width), place(y, m.height, grey.height), 0);
}
extern const GreyWork grey_work = {grey_at};

void grey_row(const GreyImage& grey, int32_t x, int32_t y, uint16_t width, uint16_t height, uint16_t n, int32_t* out) {
  const Bytes image = {grey.cells, grey.width, grey.height, 1};
  const uint16_t row = static_cast<uint16_t>(folded(y, height));
  const int32_t py = static_cast<int32_t>(centre(row, height, static_cast<uint16_t>(128u * image.height))) - 128;
  uint16_t at = static_cast<uint16_t>(folded(x, width));
  for (uint16_t i = 0; i < n; ++i) {
    const int32_t px = static_cast<int32_t>(centre(at, width, static_cast<uint16_t>(128u * image.width))) - 128;
    out[i] = between(image, px, py, 0);
    at = static_cast<uint16_t>(at + 1 == width ? 0 : at + 1);
  }
}

}  // namespace dapple::stencil
