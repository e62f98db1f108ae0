// Diffusion with a tensor that changes from place to place, in divergence form: div (A grad C) [Witkin & Kass
// 1991, 3.1]. Over one macro step A is a sum of one-dimensional diffusions along eight lattice directions with shares q
// >= 0 that change from cell to cell; each is done by passes of growing strides, as in lattice.hpp. What a link carries
// it takes from one cell and gives to the other, so mass is kept exactly. docs/numbers.md has the definition and the
// proof.
// SPDX-License-Identifier: MIT
#pragma once
#include "lattice.hpp"
#include "maps.hpp"

namespace dapple::stencil {

constexpr uint8_t kWays = 8;          // lattice directions
constexpr uint8_t kMostStreams = 8;   // directions that differ between planes: by pair, by the sign of the anisotropy
constexpr int32_t kOne = 16256;       // 127 * 256 * 32767 / 65536: a whole vector in the kernels
constexpr int16_t kMostSlope = 8127;  // so that slope * 65536 / kOne fits int16
constexpr int32_t kMostShare = 16000;

struct Way {
  int8_t vx, vy;
};
constexpr Way way_of(uint8_t i) {
  return i == 0   ? Way{1, 0}
         : i == 1 ? Way{0, 1}
                  : Way{static_cast<int8_t>((i & 1 ? -1 : 1) * (i == 4 || i == 5 ? 2 : 1)),
                        static_cast<int8_t>(i >= 6 ? 2 : 1)};
}

// A plane's tensor m I + s [[cos 2 theta, sin 2 theta], [sin 2 theta, -cos 2 theta]] in 1/unit cells^2 of variance, s
// >= 0.
struct Spread {
  int16_t mean, slope;
  uint16_t unit;   // a power of two, 2..8192
  uint8_t stream;  // of directions
  bool across;     // the greater variance lies across the map's direction
};

constexpr Spread spread_of(const Tensor& axes) {
  const int64_t sum = (static_cast<int64_t>(axes.xx) + axes.yy) / 2,
                difference = (static_cast<int64_t>(axes.xx) - axes.yy) / 2;
  const int64_t slope = difference < 0 ? -difference : difference;
  uint16_t unit = 8192;
  while (unit > 2 && (slope * unit > static_cast<int64_t>(kMostSlope) << 16 ||
                      (sum + slope) * unit > static_cast<int64_t>(kMostShare) << 16))
    unit = static_cast<uint16_t>(unit / 2);
  return {static_cast<int16_t>((sum * unit + 32768) >> 16), static_cast<int16_t>((slope * unit + 32768) >> 16), unit, 0,
          difference < 0};
}

// The share's coefficient of a way: s for the axes, s for the diagonals, 2/5 s for the knight's moves.
constexpr int32_t slope_of(const Spread& p, uint8_t way) { return way < 4 ? p.slope : p.slope * INT32_C(2) / 5; }
// The largest share, 1/unit.
constexpr int32_t largest_share(const Spread& p, uint8_t way) {
  return slope_of(p, way) + (way < 2 ? p.mean : INT32_C(0));
}

constexpr uint16_t stride_of(uint8_t stage) { return stage == 0 ? 1 : stage; }
// Strides 1, 1, 2 ... s - 1 come to (1 + s (s - 1) (2 s - 1) / 6) / 2 before stride s >= 1 of stage s; stage 0 comes
// first.
constexpr int32_t share_before(const Spread& p, uint8_t stage) {
  const int32_t s = stage;
  return stage == 0 ? 0 : (p.unit / 2) * (1 + s * (s - 1) * (2 * s - 1) / 6);
}
// Whether a plane has a pass at this stage of a way: not when what is left would be a weight below kSmallestWeight.
constexpr bool takes(const Spread& p, uint8_t way, uint8_t stage) {
  const int32_t square = static_cast<int32_t>(stride_of(stage)) * stride_of(stage);
  return stage <= kLargestStride && (largest_share(p, way) - share_before(p, stage)) * 512 >= square * p.unit;
}
constexpr uint8_t stages_of(const Spread& p, uint8_t way) {
  uint8_t stage = 0;
  while (takes(p, way, stage)) ++stage;
  return stage;
}

// What the kernels find in rows.table.
struct Warp;
struct FluxSet {
  DirectionMap map;
  uint8_t planes, maps, streams;
  bool kept;      // the maps are planes after the model's own
  bool styled;    // and behind them the two of the styles
  bool warped;    // or the three of a surface; then every plane is a stream, and the numbers of all follow the set
  uint16_t halo;  // cells, of the scratch rows
  Spread spread[8];
  struct Stream {
    uint8_t map;
    int16_t c, s;  // cos, sin of the doubled angle against the map, Q15
  } stream[kMostStreams];
};

// The numbers of a plane on a surface. Its tensor in a cell is m V V^T + s V R V^T, V as in surface.hpp, R = [[c, s],
// [s, -c]] of the doubled direction; spread.mean is m, spread.slope what the vector of that tensor is at most.
struct Warp {
  int32_t round;    // m kOne / (2 slope): of twice the vector of V V^T in Q14, sum in kOne, Q14
  int16_t leaning;  // s / slope, Q14: of the vector of V R V^T
  int16_t mean;     // s / kOne, Q14: of its mean
};
constexpr Warp warp_of(const Spread& p, int32_t s) {
  if (p.slope == 0) return {0, 0, 0};
  return {static_cast<int32_t>(base::divide_round(static_cast<int64_t>(p.mean) * kOne, INT64_C(2) * p.slope)),
          static_cast<int16_t>(base::divide_round(static_cast<int64_t>(s) * 16384, p.slope)),
          static_cast<int16_t>(base::divide_round(static_cast<int64_t>(s) * 16384, kOne))};
}

// A row of directions and of V, the turn of a stream, and how a way mirrors it.
struct WarpRow {
  const int16_t *map, *p, *q, *r;
  int16_t c, s;
  int8_t flip_x, flip_y;
};
// The tensors' vectors in units of the plane's slope, kOne, mirrored; their means, 1/unit.
void warp_row(const WarpRow& row, const Warp& plane, int16_t mean, int16_t* x, int16_t* y, int16_t* means, uint16_t n);

// int16 scratch rows with halo of the kernels: two a stream, two a plane, the links, and `maps` more: the maps' where
// none are kept; one, what the links lack, with styles; on a surface warp_rows: the links' means, a vector's
// x and y, and two rows of means a stream.
constexpr uint8_t warp_rows(uint8_t planes) { return static_cast<uint8_t>(3 + 2 * planes); }
constexpr uint8_t flux_rows(uint8_t planes, uint8_t streams, uint8_t maps) {
  return static_cast<uint8_t>(2 * (planes + streams) + 1 + maps);
}

// The kernels' scratch rows.
struct FluxWork {
  uint8_t* base;
  size_t row;
  uint16_t n, halo;
};

// A stage of a plane: with q = mean + slope * lean the share of a link, 1/unit,
//   t = clamp(q - before, 0, cap);  weight = 2 mulhi(t * scale, factor) <= 16384, Q16.
// scale is a power of two, cap * scale 16384..32767, so that the weight keeps 13 bits.
struct FluxStage {
  int16_t slope, offset, cap, factor;
  int16_t mean, before;  // offset is mean - before
  int16_t scale;
};

// What flux rows do with styles and nowhere else: rows of them; what links carry that are less by what they lack.
struct StyleWork {
  void (*row)(const DirectionMap& map, int32_t y, uint16_t n, int16_t* lack, int16_t* rho_k);
  void (*carry)(const int16_t* link, const int16_t* lack, const int16_t* from, const int16_t* to, int16_t* flux,
                uint16_t n, FluxStage s);
};

// What flux rows do on a surface and nowhere else: rows of V; a stream's pulls and means, from the rows of its map and
// of V; what links carry with means of their own.
struct SurfaceWork {
  void (*inverse_row)(const DirectionMap& map, int32_t y, uint16_t n, int16_t* const* out);
  void (*stream)(const FluxSet& set, const FluxWork& w, uint8_t way, uint8_t stream, uint8_t turn, uint16_t halo,
                 const int16_t* const* cells);
  void (*carry)(const int16_t* link, const int16_t* mean, const int16_t* from, const int16_t* to, int16_t* flux,
                uint16_t n, FluxStage s);
};

// One pass of every plane along way p[0], stage p[1], vy > 0. in[3 i + k]: rows y - S, y, y + S of plane i with halo, S
// = stride * vy; kept maps follow the model's planes. out[i]: row y. scratch: flux_rows; uses rows.run.
void flux_row(const grid::Rows& rows);

// All passes of every plane along (1, 0). in place: out[i]; kept maps behind the model's planes are only read.
void flux_chain_row(const grid::Rows& rows);

// Fills rows of the kept maps: out[i].
void keep_map_row(const grid::Rows& rows);

}  // namespace dapple::stencil
