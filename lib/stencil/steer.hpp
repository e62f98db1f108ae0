// Binary convolution along a field of directions: five steerable masks, whose sums every cell mixes for its own direction.
//   K_theta ~ B0 + c2 Bc2 + s2 Bs2 + c4 Bc4 + s4 Bs4,   c2 = cos 2 theta, s2 = sin 2 theta, c4 = c2^2 - s2^2, s4 = 2 c2 s2
// with B0 = mean over theta of K_theta, Bc2 = 2 mean(K_theta cos 2 theta) and so on [after Freeman & Adelson 1991].
// SPDX-License-Identifier: MIT
#pragma once
#include "../base/hash.hpp"
#include "convolve.hpp"

namespace dapple::stencil {

constexpr uint8_t kSteerable = 5;
constexpr uint8_t kMaxThreads = 5;

// The five masks of a shape whatever its angle, one scale for all: weights within +-7, every P within 127, every sum zero.
// `sum` is the positive sum of the mask along x: the unit of rho and of the field.
bool make_steerable(const MaskShape& shape, Mask* masks, int16_t& sum);

// Doubled directions, hashed at nodes and blended by quadratic B-splines over 3 x 3 of them.
// vectors: unit vectors at random angles (loops and deltas, as in fingerprints); scalars: angles 2 pi bend n with n in
// [-1, 1) (no defects).
enum Directions : uint8_t { vectors, scalars };
struct DirectionField {
  uint32_t seed;
  int32_t x, y;              // the world's cell at (0, 0) of the grid
  uint16_t width, height;    // of the torus; 0 on the plane
  uint16_t across, down;     // nodes on the torus; the distance of nodes, in cells, on the plane
  uint8_t kind;
  int16_t bend;              // of scalars, Q12
};

// cos and sin of a doubled angle, Q7, -127..127.
struct Doubled {
  int8_t c2, s2;
};
// Held within +-127.
inline int8_t to_q7(int32_t value) { return static_cast<int8_t>(base::clamp(value, -127, 127)); }
Doubled doubled_of(uint16_t turn);       // of a doubled angle in 1/65536 turns
Doubled unit_of(int32_t a, int32_t b);   // along (a, b) in Q12, |(a, b)| 1/16..2; shorter below 1/16

// The doubled direction of `count` cells of row y from x on: cos and sin in Q7, shorter near the defects of vectors.
void directions(const DirectionField& field, int32_t x, int32_t y, uint8_t count, int8_t* c2, int8_t* s2);

// What the kernels find in rows.table.
struct SteerSet {
  DirectionField field;
  uint8_t threads;
  int8_t c2[kMaxThreads], s2[kMaxThreads];  // Q7: doubled angle of each thread against the direction
  MaskSet masks;                            // five of them
};
constexpr size_t steer_set_bytes(bool running) { return sizeof(SteerSet) - sizeof(MaskSet) + mask_set_bytes(kSteerable, running); }

// D of a cell and thread is (128 d0 + c2 dc2 + s2 ds2 + c4 dc4 + s4 ds4) / 128; the new cell is max over threads D > rho P,
// the field 8000 D / P. Arguments as in convolve.hpp; p: {-, rho}.
void steer_row(const grid::Rows& rows);
void steer_field(const grid::Rows& rows);
void steer_by_table(const grid::Rows& rows);
void steer_field_by_table(const grid::Rows& rows);

}  // namespace dapple::stencil
