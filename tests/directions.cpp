// Fields of directions: against double, at the seams of a torus, far out on the plane.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "stencil/steer.hpp"

namespace stencil = dapple::stencil;
using stencil::DirectionField;

namespace {

const double kPi = std::acos(-1.0);

// The doubled direction of a cell, Q7.
struct Doubled {
  int c, s;
  bool operator==(const Doubled& o) const { return c == o.c && s == o.s; }
};
double change(Doubled a, Doubled b) { return std::hypot(a.c - b.c, a.s - b.s); }

Doubled direction(const DirectionField& f, int32_t x, int32_t y) {
  int8_t c = 0, s = 0;
  stencil::directions(f, x, y, 1, &c, &s);
  return {c, s};
}

DirectionField field_of(stencil::Directions kind, uint16_t width, uint16_t height, uint16_t across, uint16_t down) {
  return {
      9, 0, 0, width, height, across, down, kind, kind == stencil::scalars ? int16_t{5325} : int16_t{0}};  // bend 1.3
}

// Quadratic B-splines over 3 x 3 hashed nodes, in double but for the place within a node's cell, which has 8 bits, and
// the weights, which have 7. size 0: the plane, where `nodes` is their distance. `steady`: the length of a blended
// vector.
struct Exact {
  double c, s, steady;
};
struct Place {
  int64_t node;
  double weight[3];
};
Place place_of(int64_t at, int size, int nodes) {
  if (size != 0) at = (at % size + size) % size;
  const int64_t scaled = (256 * at + 128) * (size == 0 ? 1 : nodes), by = size == 0 ? nodes : size;
  const int64_t q8 = scaled / by - (scaled % by < 0), f = (q8 % 256 + 256) % 256;
  const double before = static_cast<double>((256 - f) * (256 - f) / 1024), after = static_cast<double>(f * f / 1024);
  return {(q8 - f) / 256, {before / 128, (128 - before - after) / 128, after / 128}};
}
Exact exact(const DirectionField& f, int64_t x, int64_t y) {
  const auto folded = [](int64_t i, int size, int nodes) {
    return static_cast<int32_t>(size == 0 ? i : (i % nodes + nodes) % nodes);
  };
  const Place px = place_of(x + f.x, f.width, f.across), py = place_of(y + f.y, f.height, f.down);
  double a = 0, b = 0;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) {
      const int32_t column = folded(px.node + i - 1, f.width, f.across),
                    row = folded(py.node + j - 1, f.height, f.down);
      const uint32_t h = dapple::base::hash(f.seed, 96, column, row) >> 16;
      const double w = px.weight[i] * py.weight[j], turn = 2 * kPi * h / 65536;
      a += w * (f.kind == stencil::scalars ? h / 32768.0 - 1 : std::cos(turn));
      b += w * (f.kind == stencil::scalars ? 0 : std::sin(turn));
    }
  const double turn = 2 * kPi * a * f.bend / 4096;
  if (f.kind == stencil::scalars) return {std::cos(turn), std::sin(turn), 1};
  const double inverse = std::min(1 / std::hypot(a, b), 16.0);
  return {a * inverse, b * inverse, std::hypot(a, b)};
}

// How much a direction may change from cell to cell: neighbouring nodes differ by 2 at most, in turns of `bend` or in
// vectors of the blended length; a step of the weights adds less than 16.
double steepest(const DirectionField& f, double steady) {
  const double across = f.width == 0 ? 1.0 * f.across : 1.0 * f.width / f.across;
  const double apart = std::min(across, f.height == 0 ? 1.0 * f.down : 1.0 * f.height / f.down);
  return 127 * 2 / apart * (f.kind == stencil::scalars ? 2 * kPi * f.bend / 4096 : 1 / steady) + 16;
}

// Directions of neighbours that change more, but for defects of vectors.
int tears(const DirectionField& f, int x, int y) {
  const double steady = exact(f, x, y).steady;
  if (steady < 0.2) return 0;
  const Doubled here = direction(f, x, y);
  return (change(here, direction(f, x + 1, y)) > steepest(f, steady)) +
         (change(here, direction(f, x, y + 1)) > steepest(f, steady));
}

const DirectionField kFields[] = {
    field_of(stencil::vectors, 200, 150, 3, 2), field_of(stencil::scalars, 200, 150, 3, 2),
    field_of(stencil::vectors, 131, 97, 1, 4),  field_of(stencil::scalars, 131, 97, 1, 4),
    field_of(stencil::vectors, 0, 0, 48, 48),   field_of(stencil::scalars, 0, 0, 64, 64),
    field_of(stencil::scalars, 0, 0, 16, 16),
};

}  // namespace

TEST_CASE("directions: are quadratic B-splines of hashed nodes") {
  for (const DirectionField& f : kFields) {
    double worst = 0, rough = 0;  // near defects vectors are amplified by up to 16
    for (int y = -160; y < 250; y += 3)
      for (int x = -170; x < 300; ++x) {
        const Doubled have = direction(f, x, y);
        const Exact want = exact(f, x, y);
        double& to = want.steady > 0.2 ? worst : rough;
        to = std::max(to, std::hypot(have.c / 128.0 - want.c, have.s / 128.0 - want.s));
      }
    CHECK(worst < 0.011);
    CHECK(rough < 0.017);
  }
}

TEST_CASE("directions: close on the torus, roll with it, and change little from cell to cell") {
  for (const DirectionField& f : kFields) {
    int wrong = 0, torn = 0;
    const bool torus = f.width != 0;
    for (int y = torus ? -1 : -200; y < (torus ? f.height : 200); ++y)
      for (int x = torus ? -1 : -200; x < (torus ? f.width : 200); ++x) {
        const Doubled here = direction(f, x, y);
        wrong += torus && !(here == direction(f, x + f.width, y - 2 * f.height));
        DirectionField moved = f;
        moved.x = 1234;
        moved.y = -77;
        wrong += !(here == direction(moved, x - 1234, y + 77));
        torn += tears(f, x, y);
      }
    CHECK(wrong == 0);
    CHECK(torn == 0);
  }
}

TEST_CASE("directions: of a row are those of its cells") {
  for (const DirectionField& f : kFields)
    for (const int x : {-70, 0, 33}) {
      int8_t c[100], s[100];
      stencil::directions(f, x, 21, 100, c, s);
      for (int k = 0; k < 100; ++k) CHECK(direction(f, x + k, 21) == Doubled{c[k], s[k]});
    }
}

// Node 2^23 and on: coordinates in 1/256 of a node no longer fit 32 bits.
TEST_CASE("directions: go on to the plane's end") {
  for (const stencil::Directions kind : {stencil::vectors, stencil::scalars})
    for (const int distance : {16, 48, 64, 200}) {
      DirectionField f = field_of(kind, 0, 0, static_cast<uint16_t>(distance), static_cast<uint16_t>(distance));
      for (const int32_t at :
           {-(1 << 30) + 100, -(1 << 29), -(1 << 27), 1 << 27, 1 << 29, (1 << 30) - 100, (1 << 23) * 48}) {
        f.x = at - 50;
        f.y = -at;
        int torn = 0;
        for (int x = 0; x < 100; ++x) torn += tears(f, x, x);
        CAPTURE(int(kind));
        CAPTURE(distance);
        CAPTURE(at);
        CHECK(torn == 0);
      }
    }
}
