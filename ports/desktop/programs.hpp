// Cell programs a vector at a time, as polynomials over two elements: f = f0 ^ (x & f1) for one cell of the
// neighbourhood after the other [Reed-Muller]. What the cell itself makes of two coefficients is 0, 1, the cell or its
// inverse: these are kept for a block of vectors and looked up, so that thirty operations are left of sixty-two,
// whatever the program.
// SPDX-License-Identifier: MIT
#pragma once

namespace dapple::cells {

using stencil::Lanes;
using stencil::load_lanes;

constexpr uint8_t kLeaves = 16;
constexpr size_t kBlock = (base::kSmallCode ? 4 : 16) * sizeof(Lanes);  // bytes

// What does not depend on the cell.
struct Constant {
  alignas(DAPPLE_WIDE) uint8_t bytes[2][kBlock];
};
constexpr Constant make_constant() {
  Constant constant{};
  for (size_t i = 0; i < kBlock; ++i) constant.bytes[1][i] = 255;
  return constant;
}
static constexpr Constant kConstant = make_constant();

// The four functions of a cell for every vector of a block, and which of them every leaf takes: bit 0 of its number is
// the coefficient without the cell, bit 1 the one with it.
struct Leaves {
  alignas(DAPPLE_WIDE) uint8_t self[2][kBlock];
  const uint8_t* leaf[kLeaves];
};

// The coefficients of a program, bit 16 left + 8 right + 4 upper + 2 lower + self.
static void begin_leaves(uint32_t program, Leaves& leaves) {
  constexpr uint32_t with[5] = {0xaaaaaaaau, 0xccccccccu, 0xf0f0f0f0u, 0xff00ff00u, 0xffff0000u};
  for (uint8_t i = 0; i < 5; ++i) program ^= (program << (1u << i)) & with[i];
  const uint8_t* const of[4] = {kConstant.bytes[0], kConstant.bytes[1], leaves.self[0], leaves.self[1]};
  for (uint8_t i = 0; i < kLeaves; ++i) leaves.leaf[i] = of[(program >> (2 * i)) & 3];
}

// Two vectors that follow each other: looking up where a leaf's are takes as long for one.
struct Two {
  Lanes first, second;
  Two operator&(Two b) const { return {first & b.first, second & b.second}; }
  Two operator|(Two b) const { return {first | b.first, second | b.second}; }
  Two operator^(Two b) const { return {first ^ b.first, second ^ b.second}; }
  Two operator~() const { return {~first, ~second}; }
  Two operator<<(int by) const { return {first << by, second << by}; }
  Two operator>>(int by) const { return {first >> by, second >> by}; }
};
template <class W>
DAPPLE_INLINE W load(const uint8_t* from) {
  if constexpr (sizeof(W) == sizeof(Lanes)) return load_lanes(from);
  else return {load_lanes(from), load_lanes(from + sizeof(Lanes))};
}
inline void store(uint8_t* out, size_t at, uint16_t n, Lanes cells) {
  stencil::store_cells(out, at, n, stencil::Wide(cells));
}
inline void store(uint8_t* out, size_t at, uint16_t n, Two cells) {
  store(out, at, n, cells.first);
  store(out, at + sizeof(Lanes), n, cells.second);
}

template <class W>
DAPPLE_INLINE W by_lower(const Leaves& leaves, uint8_t i, size_t w, W lower) {
  return load<W>(leaves.leaf[2 * i] + w) ^ (lower & load<W>(leaves.leaf[2 * i + 1] + w));
}
template <class W>
DAPPLE_INLINE W by_upper(const Leaves& leaves, uint8_t i, size_t w, W lower, W upper) {
  const uint8_t without = static_cast<uint8_t>(2 * i), with = static_cast<uint8_t>(2 * i + 1);
  return by_lower(leaves, without, w, lower) ^ (upper & by_lower(leaves, with, w, lower));
}

// The cells w bytes into the block at `at`. Those beside them come from the bytes around a vector's own, whose other
// bits are those of the shifted vector.
template <class W>
DAPPLE_INLINE void evaluate(const grid::Rows& rows, const Leaves& leaves, size_t at, size_t w) {
  const uint8_t* const c = static_cast<const uint8_t*>(rows.in[1]) + at + w;
  const W upper = load<W>(static_cast<const uint8_t*>(rows.in[0]) + at + w);
  const W lower = load<W>(static_cast<const uint8_t*>(rows.in[2]) + at + w);
  const W self = load<W>(c), left = (self << 1) | (load<W>(c - 1) >> 7), right = (self >> 1) | (load<W>(c + 1) << 7);
  const W off = by_upper(leaves, 0, w, lower, upper) ^ (right & by_upper(leaves, 1, w, lower, upper));
  const W on = by_upper(leaves, 2, w, lower, upper) ^ (right & by_upper(leaves, 3, w, lower, upper));
  store(static_cast<uint8_t*>(rows.out[0]), at + w, rows.n, off ^ (left & on));
}

static void window_wide(const grid::Rows& rows) {
  Leaves leaves;
  begin_leaves(static_cast<uint32_t>(rows.p[0]), leaves);
  const uint8_t* const c = static_cast<const uint8_t*>(rows.in[1]);
  const size_t bytes = (rows.n + 7u) / 8;
  for (size_t at = 0; at < bytes; at += kBlock) {
    const size_t count = bytes - at < kBlock ? bytes - at : kBlock;
    for (size_t w = 0; w < count; w += sizeof(Lanes)) {
      const Lanes self = load_lanes(c + at + w);
      stencil::put_word(leaves.self[0] + w, stencil::Wide(self));
      stencil::put_word(leaves.self[1] + w, stencil::Wide(~self));
    }
    size_t w = 0;
    if constexpr (!base::kSmallCode)
      for (; w + sizeof(Lanes) < count; w += sizeof(Two)) evaluate<Two>(rows, leaves, at, w);
    for (; w < count; w += sizeof(Lanes)) evaluate<Lanes>(rows, leaves, at, w);
  }
}

}  // namespace dapple::cells
