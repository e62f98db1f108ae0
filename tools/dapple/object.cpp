// A mesh with a quadrilateral for every cell, seen from afar, three samples a pixel either way. See object.hpp.
// SPDX-License-Identifier: MIT
#include "object.hpp"

#include <algorithm>
#include <cmath>

namespace cli {

namespace {

constexpr uint32_t kSamples = 3;
const double kPi = std::acos(-1.0);

struct Point {
  double x, y, z;
};
// A corner as it is seen, and its colour.
struct Corner {
  Point at;
  double rgb[3];
};
Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Point operator*(double s, Point a) { return {s * a.x, s * a.y, s * a.z}; }
double dot(Point a, Point b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Point cross(Point a, Point b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
Point unit(Point a) { return 1 / std::max(1e-12, std::sqrt(dot(a, a))) * a; }

// The corner (x, y) of a patch's cells in space, z upwards: the shapes whose metrics are in lib/stencil/surface.cpp.
Point place(const dapple::Surface& s, uint8_t patch, uint32_t x, uint32_t y) {
  const double u = double(x) / s.width, v = double(y) / s.height, ratio = s.ratio / 1e6;
  const double turn = 2 * kPi * u;
  if (s.shape == dapple::Surface::torus) {
    const double around = 1 + ratio * std::cos(2 * kPi * v);
    return {around * std::cos(turn), around * std::sin(turn), -ratio * std::sin(2 * kPi * v)};
  }
  if (s.shape == dapple::Surface::vase) {
    const double radius = 1 - ratio * std::sin(2 * kPi * v);
    return {radius * std::cos(turn), radius * std::sin(turn), 2 * kPi * s.tall / 1e6 * (0.5 - v)};
  }
  if (s.shape == dapple::Surface::sphere) {
    const dapple::Face& f = dapple::kFaces[patch];
    const double a = std::tan((u - 0.5) * kPi / 2), b = std::tan((v - 0.5) * kPi / 2);
    return unit({f.n[0] + a * f.u[0] + b * f.v[0], f.n[1] + a * f.u[1] + b * f.v[1], f.n[2] + a * f.u[2] + b * f.v[2]});
  }
  double sum = 0;  // heights: the mean of the cells around the corner
  for (int k = 0; k < 4; ++k) {
    const uint32_t i = std::min<uint32_t>(s.width - 1u, std::max<uint32_t>(x, 1) - 1 + (k & 1));
    const uint32_t j = std::min<uint32_t>(s.height - 1u, std::max<uint32_t>(y, 1) - 1 + static_cast<uint32_t>(k >> 1));
    sum += s.height_of[size_t{j} * s.width + i] / 1024.0;
  }
  return {u - 0.5, (0.5 - v) * s.height / s.width, sum / s.width};
}

// From y = infinity and above, turned: x to the right, y downwards, z towards the eye.
Point seen(Point p, double turn, double tilt) {
  const double x = p.x * std::cos(turn) - p.y * std::sin(turn), y = p.x * std::sin(turn) + p.y * std::cos(turn);
  return {-x, y * std::sin(tilt) - p.z * std::cos(tilt), y * std::cos(tilt) + p.z * std::sin(tilt)};
}

class Canvas {
 public:
  Canvas(uint32_t width, uint32_t height)
      : width_(width), height_(height), rgb_(size_t{3} * width * height), depth_(size_t{width} * height, -1e9) {}

  // Colours between the corners'; the nearest to the eye stays.
  void triangle(const Corner& first, const Corner& second, const Corner& third, double shade, double shine) {
    const Point &a = first.at, &b = second.at, &c = third.at;
    const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    if (std::fabs(area) < 1e-9) return;
    const auto clamped = [](double v, uint32_t most) {
      return static_cast<uint32_t>(std::clamp(v, 0.0, double(most)));
    };
    const uint32_t left = clamped(std::floor(std::min({a.x, b.x, c.x})), width_ - 1),
                   right = clamped(std::ceil(std::max({a.x, b.x, c.x})), width_ - 1),
                   top = clamped(std::floor(std::min({a.y, b.y, c.y})), height_ - 1),
                   bottom = clamped(std::ceil(std::max({a.y, b.y, c.y})), height_ - 1);
    for (uint32_t y = top; y <= bottom; ++y)
      for (uint32_t x = left; x <= right; ++x) {
        const double px = x + 0.5, py = y + 0.5;
        const double w1 = ((px - a.x) * (c.y - a.y) - (c.x - a.x) * (py - a.y)) / area,
                     w2 = ((b.x - a.x) * (py - a.y) - (px - a.x) * (b.y - a.y)) / area;
        if (w1 < -1e-6 || w2 < -1e-6 || w1 + w2 > 1 + 1e-6) continue;
        double colour[3];
        for (size_t i = 0; i < 3; ++i)
          colour[i] = shine + shade * ((1 - w1 - w2) * first.rgb[i] + w1 * second.rgb[i] + w2 * third.rgb[i]);
        put(x, y, a.z + w1 * (b.z - a.z) + w2 * (c.z - a.z), colour);
      }
  }
  void put(uint32_t x, uint32_t y, double depth, const double* colour) {
    const size_t at = size_t{width_} * y + x;
    if (depth <= depth_[at]) return;
    depth_[at] = depth;
    for (size_t i = 0; i < 3; ++i) rgb_[3 * at + i] = colour[i];
  }
  Raster smaller() const {
    Raster to{width_ / kSamples, height_ / kSamples, {}};
    for (uint32_t y = 0; y < to.height; ++y)
      for (uint32_t x = 0; x < to.width; ++x)
        for (uint32_t channel = 0; channel < 3; ++channel) {
          double sum = 0;
          for (uint32_t k = 0; k < kSamples * kSamples; ++k)
            sum += rgb_[3 * (size_t{width_} * (kSamples * y + k / kSamples) + kSamples * x + k % kSamples) + channel];
          to.rgb.push_back(static_cast<uint8_t>(std::lround(std::clamp(sum / (kSamples * kSamples), 0.0, 255.0))));
        }
    return to;
  }

 private:
  uint32_t width_, height_;
  std::vector<double> rgb_, depth_;
};

// The wall, and the strip of textures on it: as wide and high as `wide` and `high` allow.
void paint_wall(Canvas& canvas, const Raster& strip, uint32_t width, uint32_t height, double wide, double high) {
  const double scale = std::min(wide / strip.width, high / strip.height), margin = (width - wide) / 2;
  for (uint32_t y = 0; y < height; ++y)
    for (uint32_t x = 0; x < width; ++x) {
      const double shade = 232 - 40.0 * y / height, u = (x + 0.5 - margin) / scale, v = (y + 0.5 - margin) / scale;
      double colour[3] = {shade, shade, shade};
      if (u >= 0 && v >= 0 && u < strip.width && v < strip.height)
        for (size_t i = 0; i < 3; ++i)
          colour[i] = strip.rgb[3 * (size_t{static_cast<uint32_t>(v)} * strip.width + static_cast<uint32_t>(u)) + i];
      canvas.put(x, y, -1e8, colour);
    }
}

// How an object is looked at.
struct View {
  double turn, tilt, scale, x, y;
};

void paint_quad(Canvas& canvas, const Corner* corner) {
  const Point light = unit({-0.45, -0.45, 0.8});
  Point normal = unit(cross(corner[1].at - corner[0].at, corner[2].at - corner[0].at));
  if (normal.z < 0) normal = -1 * normal;
  const double lambert = std::max(0.0, dot(normal, light)),
               half = std::max(0.0, dot(normal, unit({-0.45, -0.45, 1.8})));
  const double shade = 0.3 + 0.75 * lambert, shine = 40 * std::pow(half, 40);
  canvas.triangle(corner[0], corner[1], corner[2], shade, shine);
  canvas.triangle(corner[1], corner[3], corner[2], shade, shine);
}

// The mean of the cells around a corner; at a patch's end of its own.
void colour_of(const Skin& skin, uint8_t patch, uint32_t x, uint32_t y, double* rgb) {
  const dapple::Surface& s = skin.surface;
  const bool round = skin.round_x, tube = skin.round_y;
  for (uint32_t k = 0; k < 4; ++k) {
    const auto cell = [](uint32_t at, uint32_t back, uint32_t size, bool repeats) {
      return repeats ? (at + size - back) % size : std::min(size - 1, std::max(at, back) - back);
    };
    const uint32_t i = cell(x, k & 1, s.width, round), j = cell(y, k >> 1, s.height, tube);
    const uint8_t* const from =
        skin.strip.rgb.data() + 3 * (size_t{j} * skin.strip.width + patch * size_t{s.width} + i);
    for (size_t c = 0; c < 3; ++c) rgb[c] += from[c] / 4.0;
  }
}

void paint_patch(Canvas& canvas, const Skin& skin, uint8_t patch, const View& view) {
  const dapple::Surface& s = skin.surface;
  std::vector<Corner> row[2];
  for (uint32_t y = 0; y <= s.height; ++y) {
    row[0].swap(row[1]);
    row[1].clear();
    for (uint32_t x = 0; x <= s.width; ++x) {
      const Point p = seen(place(s, patch, x, y), view.turn, view.tilt);
      Corner corner = {{view.x + view.scale * p.x, view.y + view.scale * p.y, view.scale * p.z}, {0, 0, 0}};
      colour_of(skin, patch, x, y, corner.rgb);
      row[1].push_back(corner);
    }
    for (uint32_t x = 0; x < s.width && y > 0; ++x) {
      const Corner corners[4] = {row[0][x], row[0][x + 1], row[1][x], row[1][x + 1]};
      paint_quad(canvas, corners);
    }
  }
}

// The object's shadow-free box on the picture's lower part.
View view_of(const Skin& skin, double width, double height) {
  const dapple::Surface& s = skin.surface;
  View view{0.6, s.shape == dapple::Surface::torus ? 0.85 : s.shape == dapple::Surface::heights ? 0.75 : 0.4, 1, 0, 0};
  double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
  for (uint8_t patch = 0; patch < s.patches; ++patch)
    for (uint32_t y = 0; y <= s.height; y += 2)
      for (uint32_t x = 0; x <= s.width; x += 2) {
        const Point p = seen(place(s, patch, x, y), view.turn, view.tilt);
        left = std::min(left, p.x), right = std::max(right, p.x);
        top = std::min(top, p.y), bottom = std::max(bottom, p.y);
      }
  view.scale = std::min(0.86 * width / (right - left), 0.72 * height / (bottom - top));
  view.x = width / 2 - view.scale * (left + right) / 2;
  view.y = height * 0.96 - view.scale * bottom;
  return view;
}

}  // namespace

Raster object_picture(const Skin& skin, uint32_t width, uint32_t height) {
  const uint32_t wide = width * kSamples, high = height * kSamples;
  Canvas canvas(wide, high);
  paint_wall(canvas, skin.strip, wide, high, 0.92 * wide, 0.42 * high);
  const View view = view_of(skin, wide, high);
  for (uint8_t patch = 0; patch < skin.surface.patches; ++patch) paint_patch(canvas, skin, patch, view);
  return canvas.smaller();
}

}  // namespace cli
