// Initial states: noise in every cell, seed discs on a jittered diamond grid, initiator cells in a uniform state, smooth phases.
// SPDX-License-Identifier: MIT
#pragma once
#include "../grid/domain.hpp"
#include "../grid/plane.hpp"

namespace dapple {

struct Start;

namespace start {

// Where a grid of cells lies. On a torus (x, y) rolls it: its cell (0, 0) is the unrolled torus' cell (x, y), modulo the
// size; on the plane (x, y) is the world's cell at (0, 0). All in cells of this level.
struct Place {
  grid::Cell cell;
  uint16_t width, height;
  uint8_t level;
  int32_t x, y;
  bool plane;
  uint32_t seed;
  const int32_t* table = nullptr;  // of the stage's solver, for starts that know it
};

// Fills one row of one plane; y in cells of the place.
using RowStart = void (*)(const Place& place, const Start& start, const grid::Levels& levels, uint8_t plane, uint16_t y, void* row);

// Noise is hash(seed, plane, x, y); of one-bit cells, bit x mod 32 of hash(seed, plane, x div 32, y).
void noise_row(const Place& place, const Start& start, const grid::Levels& levels, uint8_t plane, uint16_t y, void* row);
// Discs have the centre
//   ((i + 1/4 + 1/2 (j odd)) + jitter U) * spacing,  ((j + 1/2) + jitter U') * spacing,   U in [-1, 1),
// and cover the cells whose centre is at most the radius away; both planes of a pair get the same discs.
void seeds_row(const Place& place, const Start& start, const grid::Levels& levels, uint8_t plane, uint16_t y, void* row);
// Of corner tiles, the place being all sixteen: every tile has columns x rows discs as disc_grid says of one of its size, at
//   ((i + 1/2 (j odd)) + jitter U) * spacing,  (j + jitter U') * spacing,
// and discs that may touch the `band` cells at an edge move alike in all the tiles that share it.
void corner_seeds_row(const Place& place, const Start& start, const grid::Levels& levels, uint16_t band, uint16_t y, void* row);

// Initiators, in the background: a disc in the middle of the tile (the plane's origin); a line through it, along x or y, whichever is
// nearer to `lean`, 2 radius + 1 wide; segments, one to every pitch x pitch, of a length from 1/2 to 1 `length`, within `fan` of `lean`.
void point_row(const Place& place, const Start& start, const grid::Levels& levels, uint8_t plane, uint16_t y, void* row);
void line_row(const Place& place, const Start& start, const grid::Levels& levels, uint8_t plane, uint16_t y, void* row);
void segments_row(const Place& place, const Start& start, const grid::Levels& levels, uint8_t plane, uint16_t y, void* row);
// The same, `lean` being against the direction of a segment's middle: (cos, sin) in Q15 at a cell, x and y of the world.
struct Way {
  int32_t c, s;
};
using WayAt = Way (*)(const Place& place, int32_t x, int32_t y);
void lay_segments(const Place& place, const Start& start, const grid::Levels& levels, uint16_t y, void* row, WayAt way);
// Independent smooth noise in every plane, of blobs a pitch wide, about the background: two planes make every phase of a circle.
void phases_row(const Place& place, const Start& start, const grid::Levels& levels, uint8_t plane, uint16_t y, void* row);

}  // namespace start

// How a recipe starts. Lengths are in cells of the finest grid, numbers in 1/1000000.
struct Start {
  enum Kind : uint8_t { noise, seeds, point, line, segments, phases } kind;
  int32_t pitch;      // seeds: distance of the discs along a row; segments: distance; phases: width of the blobs
  int32_t aspect;     // seeds: distance of the rows of discs, as a share of pitch
  int32_t jitter;     // seeds: each disc is moved by up to this share of the spacing, uniformly, in either direction
  int32_t radius;     // of discs and lines; half the width of segments
  int32_t amplitude;  // of the seeds, as a share of the model's own
  start::RowStart row;  // what does it: firmware links no other
  int32_t length = 30 * base::kMicro;  // segments: of the longest
  int32_t lean = 90 * base::kMicro;    // line, segments: degrees from x towards y (down)
  int32_t fan = 5729578;               // segments: degrees either way; .1 radians
};

constexpr const char* kStarts = "noise|seeds|point|line|segments|phases";
constexpr start::RowStart row_start(Start::Kind kind) {
  switch (kind) {
    case Start::noise: return start::noise_row;
    case Start::seeds: return start::seeds_row;
    case Start::point: return start::point_row;
    case Start::line: return start::line_row;
    case Start::segments: return start::segments_row;
    case Start::phases: return start::phases_row;
  }
  return nullptr;
}

// Ranges, 1/kMicro; jitter and amplitude are 0..1.
constexpr int32_t kPitch[2] = {4 * base::kMicro, 1000 * base::kMicro}, kRadius[2] = {500000, 200 * base::kMicro};
constexpr int32_t kAspect[2] = {200000, 5 * base::kMicro}, kLength[2] = {2 * base::kMicro, 1000 * base::kMicro};
constexpr int32_t kLean[2] = {-360 * base::kMicro, 360 * base::kMicro}, kFan[2] = {0, 90 * base::kMicro};

constexpr bool in_range(const Start& s) {
  if (s.kind == Start::noise) return true;
  const auto within = [](int32_t value, int32_t low, int32_t high) { return value >= low && value <= high; };
  return s.kind <= Start::phases && within(s.length, kLength[0], kLength[1]) && within(s.lean, kLean[0], kLean[1]) &&
         within(s.fan, kFan[0], kFan[1]) && within(s.pitch, kPitch[0], kPitch[1]) && within(s.aspect, kAspect[0], kAspect[1]) &&
         within(s.jitter, 0, base::kMicro) && within(s.radius, kRadius[0], kRadius[1]) && within(s.amplitude, 0, base::kMicro);
}

}  // namespace dapple

namespace dapple::start {

using grid::Levels;

// A torus cell's coordinate in the unrolled torus, a plane's in the world.
constexpr int32_t world(int32_t at, uint16_t size, bool plane) {
  if (plane) return at;
  const int32_t rest = at % size;
  return rest < 0 ? rest + size : rest;
}

// A length in 1/kMicro cells of the finest grid as 1/256 cells of the place's.
DAPPLE_APART constexpr int64_t cells(const Place& place, int32_t micro) {
  return (static_cast<int64_t>(micro) * 256 / base::kMicro) >> place.level;
}

// One cell of a row.
inline void set_cell(const Place& place, void* row, uint16_t x, int32_t value) {
  switch (place.cell) {
    case grid::Cell::bit: grid::put_bit(static_cast<uint8_t*>(row), x, value != 0); break;
    case grid::Cell::int16: static_cast<int16_t*>(row)[x] = static_cast<int16_t>(value); break;
    case grid::Cell::int32: static_cast<int32_t*>(row)[x] = value; break;
  }
}

// What discs, lines and segments hold.
inline int32_t disc_level(const Start& start, const Levels& levels) {
  return levels.background + static_cast<int32_t>(base::divide_round(static_cast<int64_t>(levels.disc - levels.background) * start.amplitude, base::kMicro));
}

// The lattice of seed discs: spacing is numerator / denominator in 1/256 cells. On a torus columns = round(width / pitch)
// and rows = the even number nearest to height / (aspect * pitch), at least one and two, fill it exactly; on the plane
// (columns and rows 0) the spacing is the pitch itself, in whole 1/256 of a cell.
struct DiscGrid {
  uint16_t columns, rows;
  int64_t wide, high;  // numerators of the spacing; the denominators are columns and rows, 1 on the plane
};
constexpr DiscGrid disc_grid(const Start& s, const Place& p) {
  const int64_t pitch = s.pitch >> p.level;
  const int64_t row_pitch = pitch * s.aspect / base::kMicro;
  if (p.plane) return {0, 0, base::divide_round(pitch * 256, base::kMicro), base::divide_round(row_pitch * 256, base::kMicro)};
  const int64_t columns = base::divide_round(static_cast<int64_t>(p.width) * base::kMicro, pitch > 0 ? pitch : 1);
  const int64_t pairs = base::divide_round(static_cast<int64_t>(p.height) * base::kMicro, 2 * (row_pitch > 0 ? row_pitch : 1));
  return {static_cast<uint16_t>(columns < 1 ? 1 : columns > 65535 ? 65535 : columns),
          static_cast<uint16_t>(pairs < 1 ? 2 : pairs > 32767 ? 65534 : 2 * pairs),
          static_cast<int64_t>(p.width) << 8, static_cast<int64_t>(p.height) << 8};
}

}  // namespace dapple::start
