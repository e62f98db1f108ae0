// Fields of directions a row of cells at a time: what lib/stencil/directions.cpp does for one cell after the other, as
// loops over arrays. Same numbers; bounds and formats are told there.
// SPDX-License-Identifier: MIT
#pragma once

namespace dapple::stencil {

constexpr uint16_t kCellsAtOnce = 8 * DAPPLE_WIDE;
constexpr uint8_t kGroup = 8;                               // cells, or nodes, that are done together
constexpr uint16_t kMostNodes = kCellsAtOnce / 8 + kGroup;  // nodes lie at least eight cells apart
typedef int32_t Group __attribute__((vector_size(4 * kGroup), aligned(4), may_alias));

inline Group& group_at(int32_t* first) { return *reinterpret_cast<Group*>(first); }
inline const Group& group_at(const int32_t* first) { return *reinterpret_cast<const Group*>(first); }

// Of so many cells; loops over whole groups have nothing left over.
static uint16_t groups_of(uint16_t count) { return static_cast<uint16_t>((count + kGroup - 1) / kGroup); }

// Where cells of a row lie between nodes, whatever the row. Run i of them lies from node first + i on.
struct Between {
  int32_t first;
  uint16_t groups, runs;
  uint16_t begin[kMostNodes + 1];                                        // of every run, and the last group's end
  int32_t before[kCellsAtOnce + kGroup], behind[kCellsAtOnce + kGroup];  // weights of Blend
};

// Weights of the cells, a group beyond `count` of them too; returns the last one's node against the first one's. Nodes
// behind the seam of a torus go on being counted.
static int32_t weigh(NodePlace p, uint16_t count, Between& b) {
  const int32_t step = kGroup * p.step + kGroup * p.step_rest / p.divisor, step_rest = kGroup * p.step_rest % p.divisor;
  const int32_t first = p.node;
  int32_t places[kGroup], rests[kGroup];
  for (uint8_t k = 0; k < kGroup; ++k, next_cell(p)) places[k] = 256 * (p.node - first) + p.part, rests[k] = p.rest;
  Group place = group_at(places), rest = group_at(rests), last = place;
  for (uint16_t at = 0; at < count + kGroup; at = static_cast<uint16_t>(at + kGroup)) {
    const Group part = place & 255, left = 256 - part;
    group_at(b.before + at) = (left * left) >> 10;
    group_at(b.behind + at) = (part * part) >> 10;
    if (at < count) last = place;
    rest += step_rest;
    const Group over = rest >= p.divisor;  // -1 or 0
    rest -= over & p.divisor;
    place += step - over;
  }
  return last[(count - 1) % kGroup] >> 8;
}

static void between_of(const DirectionField& f, int32_t x, uint16_t count, Between& b) {
  const NodePlace p = node_place(folded(f.x + x, f.width, f.width), f.width, f.across);
  b.first = p.node;
  b.groups = groups_of(count);
  b.runs = static_cast<uint16_t>(weigh(p, count, b) + 1);
  // Cell k is at place (part divisor + rest + k 256 factor) / divisor.
  const int32_t before = p.part * p.divisor + p.rest, each = p.step * p.divisor + p.step_rest;
  b.begin[0] = 0;
  for (uint16_t i = 1; i < b.runs; ++i)
    b.begin[i] = static_cast<uint16_t>((256 * i * p.divisor - before + each - 1) / each);
  b.begin[b.runs] = static_cast<uint16_t>(kGroup * b.groups);
}

// The nodes before the first run and on, of the three rows around node row `row`. They are those of many rows of cells.
struct Nodes {
  bool there = false;
  int32_t row;
  int32_t a[3][kMostNodes], b[3][kMostNodes];
};

static void make_vectors(base::RowKey key, const int32_t* DAPPLE_RESTRICT column, uint16_t groups,
                         int32_t* DAPPLE_RESTRICT a, int32_t* DAPPLE_RESTRICT b) {
  for (uint32_t i = 0; i < kGroup * uint32_t{groups}; ++i) {
    const uint16_t angle = static_cast<uint16_t>(base::hash(key, column[i]) >> 16);
    a[i] = base::cosine(angle) >> 3;
    b[i] = base::sine(angle) >> 3;
  }
}

static void make_scalars(base::RowKey key, const int32_t* DAPPLE_RESTRICT column, uint16_t groups,
                         int32_t* DAPPLE_RESTRICT a) {
  for (uint32_t i = 0; i < kGroup * uint32_t{groups}; ++i)
    a[i] = static_cast<int32_t>(base::hash(key, column[i]) >> 16) - 32768;
}

static void make_nodes(const DirectionField& f, const Between& b, int32_t row, Nodes& nodes) {
  if (nodes.there && nodes.row == row) return;
  const uint16_t groups = groups_of(static_cast<uint16_t>(b.runs + 2));
  int32_t column[kMostNodes], node = folded(b.first - 1, f.width, f.across);
  for (uint16_t i = 0; i < kGroup * groups; ++i) {
    column[i] = node;
    if (++node == f.across && f.width != 0) node = 0;
  }
  for (uint8_t k = 0; k < 3; ++k) {
    const base::RowKey key = base::row_key(f.seed, kDirectionStream, folded(row + k - 1, f.height, f.down));
    if (f.kind == scalars) make_scalars(key, column, groups, nodes.a[k]);
    else make_vectors(key, column, groups, nodes.a[k], nodes.b[k]);
  }
  nodes.there = true;
  nodes.row = row;
}

// The same, blended along y.
static void blend_down(const int32_t (*rows)[kMostNodes], const Blend& down, uint16_t groups, int32_t* sum) {
  for (uint16_t at = 0; at < kGroup * groups; at = static_cast<uint16_t>(at + kGroup))
    group_at(sum + at) = group_at(rows[0] + at) * down.weight[0] + group_at(rows[1] + at) * down.weight[1] +
                         group_at(rows[2] + at) * down.weight[2];
}

// The blend of a run's three nodes: before w0 + at w1 + behind w2 with w1 = 128 - w0 - w2. Writes beyond the run, where
// the next one does.
static void blend_runs(const Between& b, const int32_t* node, int32_t* sum) {
  for (uint16_t r = 0; r < b.runs; ++r, ++node) {
    const int32_t at = 128 * node[1], before = node[0] - node[1], behind = node[2] - node[1];
    for (uint16_t i = b.begin[r]; i < b.begin[r + 1]; i = static_cast<uint16_t>(i + kGroup))
      group_at(sum + i) = (at + before * group_at(b.before + i) + behind * group_at(b.behind + i)) >> 14;
  }
}

// Unit vectors along (a, b), Q12, as to_q7 of unit_of.
static void units_of(const int32_t* DAPPLE_RESTRICT a, const int32_t* DAPPLE_RESTRICT b, int8_t* DAPPLE_RESTRICT c2,
                     int8_t* DAPPLE_RESTRICT s2, uint16_t groups) {
  int32_t square[kCellsAtOnce], inverse[kCellsAtOnce];
  const uint32_t n = kGroup * uint32_t{groups};
  for (uint32_t i = 0; i < n; ++i) square[i] = a[i] * a[i] + b[i] * b[i];
  base::inverse_roots(square, inverse, groups);
  for (uint32_t i = 0; i < n; ++i) {
    c2[i] = static_cast<int8_t>(base::clamp((a[i] * inverse[i] + 65536) >> 17, -127, 127));
    s2[i] = static_cast<int8_t>(base::clamp((b[i] * inverse[i] + 65536) >> 17, -127, 127));
  }
}

static void turns_of(const int32_t* DAPPLE_RESTRICT a, int8_t* DAPPLE_RESTRICT c2, int8_t* DAPPLE_RESTRICT s2,
                     uint16_t groups, int16_t bend) {
  for (uint32_t i = 0; i < kGroup * uint32_t{groups}; ++i) {
    const uint16_t turn = static_cast<uint16_t>((a[i] * bend) >> 11);
    c2[i] = static_cast<int8_t>(base::clamp((base::cosine(turn) + 128) >> 8, -127, 127));
    s2[i] = static_cast<int8_t>(base::clamp((base::sine(turn) + 128) >> 8, -127, 127));
  }
}

// Directions of those cells of row y. nodes: of the row before, or not there.
static void directions_between(const DirectionField& f, const Between& b, int32_t y, Nodes& nodes, int8_t* c2,
                               int8_t* s2) {
  int32_t blended[kMostNodes], along[kCellsAtOnce + kGroup], across[kCellsAtOnce + kGroup];
  const NodePlace row = node_place(folded(f.y + y, f.height, f.height), f.height, f.down);
  const Blend down = blend_of(row.part);
  const uint16_t columns = groups_of(static_cast<uint16_t>(b.runs + 2));
  make_nodes(f, b, row.node, nodes);
  blend_down(nodes.a, down, columns, blended);
  blend_runs(b, blended, along);
  if (f.kind == scalars) return turns_of(along, c2, s2, b.groups, f.bend);
  blend_down(nodes.b, down, columns, blended);
  blend_runs(b, blended, across);
  units_of(along, across, c2, s2, b.groups);
}

// Directions of a word's cells in the order of turned bits, after which they are mixed (mixture.hpp).
static void turned_directions(const DirectionField& f, const Between& b, int32_t y, Nodes& nodes, Wide* direction) {
  int8_t cells[2][kCellsAtOnce] = {};
  directions_between(f, b, y, nodes, cells[0], cells[1]);
  for (uint8_t i = 0; i < 2; ++i) {
    Lanes w[8];
    for (uint8_t k = 0; k < 8; ++k)
      for (uint8_t lane = 0; lane < kLanes; ++lane)
        w[k][lane] = base::load_word<uint64_t>(reinterpret_cast<const uint8_t*>(cells[i]) + 64 * lane + 8 * k);
    turn_bytes(w);
    for (uint8_t k = 0; k < 8; ++k) put_word(reinterpret_cast<uint8_t*>(direction + 8 * i + k), w[k]);
  }
}

}  // namespace dapple::stencil
