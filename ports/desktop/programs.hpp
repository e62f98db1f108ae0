// Cell programs a vector at a time, as polynomials over two elements: f = f0 ^ (x & f1) for one cell of the
// neighbourhood after the other [Reed-Muller], sixty-two operations whatever the program.
// SPDX-License-Identifier: MIT
#pragma once

namespace dapple::cells {

using stencil::Lanes;
using stencil::load_lanes;

// The coefficients of a program, bit 16 left + 8 right + 4 upper + 2 lower + self, each spread over a word.
static void coefficients_of(uint32_t program, Lanes* k) {
  constexpr uint32_t with[5] = {0xaaaaaaaau, 0xccccccccu, 0xf0f0f0f0u, 0xff00ff00u, 0xffff0000u};
  for (uint8_t i = 0; i < 5; ++i) program ^= (program << (1u << i)) & with[i];
  for (uint8_t i = 0; i < 32; ++i) k[i] = Lanes{} - ((program >> i) & UINT64_C(1));
}

static inline Lanes evaluated(const Lanes* k, Lanes self, Lanes lower, Lanes upper, Lanes right, Lanes left) {
  Lanes f[8];
  for (uint8_t i = 0; i < 8; ++i) {
    const Lanes without = k[4 * i] ^ (self & k[4 * i + 1]), with = k[4 * i + 2] ^ (self & k[4 * i + 3]);
    f[i] = without ^ (lower & with);
  }
  for (uint8_t i = 0; i < 4; ++i) f[i] = f[2 * i] ^ (upper & f[2 * i + 1]);
  for (uint8_t i = 0; i < 2; ++i) f[i] = f[2 * i] ^ (right & f[2 * i + 1]);
  return f[0] ^ (left & f[1]);
}

static void window_wide(const grid::Rows& rows) {
  Lanes k[32];
  coefficients_of(static_cast<uint32_t>(rows.p[0]), k);
  const uint8_t* u = static_cast<const uint8_t*>(rows.in[0]);
  const uint8_t* c = static_cast<const uint8_t*>(rows.in[1]);
  const uint8_t* d = static_cast<const uint8_t*>(rows.in[2]);
  uint8_t* out = static_cast<uint8_t*>(rows.out[0]);
  for (size_t at = 0; at < (rows.n + 7u) / 8; at += sizeof(Lanes)) {
    const Lanes self = load_lanes(c + at);
    const Lanes left = (self << 1) | (stencil::moved_up(self, static_cast<uint64_t>(*(c + at - 1)) << 56) >> 63);
    const Lanes right = (self >> 1) | (stencil::moved_down(self, c[at + sizeof self]) << 63);
    stencil::store_cells(out, at, rows.n,
                         stencil::Wide(evaluated(k, self, load_lanes(d + at), load_lanes(u + at), right, left)));
  }
}

}  // namespace dapple::cells
