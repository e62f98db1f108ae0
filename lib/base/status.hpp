// What calls answer: errors are negative, and only begin and parse return them.
// SPDX-License-Identifier: MIT
#pragma once
#include <stdint.h>

namespace dapple {

enum Status : int8_t {
  ok = 0,
  more = 1,   // step: call again
  done = 2,   // step: the texture is complete

  // parse: Trouble says where
  unknown_word = -1,    // no such model, key, word or ramp
  out_of_range = -2,    // a number outside its range
  broken_text = -3,     // not a number, a missing '=', something after the end
  not_possible = -4,    // words that exclude each other

  // begin: Need says what it wanted
  bad_recipe = -10,     // stages that do not fit each other, or numbers outside their ranges
  bad_side = -11,       // a side below 8
  not_a_multiple = -12, // a side, or a roll of a torus, that the recipe's coarsest grid does not divide
  tile_too_small = -13, // a side below what the pattern needs
  too_large = -14,      // the texture does not fit the address space
  too_little_memory = -15,
  bad_bands = -16,      // 0, or more than 64
  too_far = -17,        // a window beyond 2^30 cells from the origin
  halo_too_wide = -18,  // a window whose recipe runs too long for the plane: use a torus
  bad_map = -19,        // map=image, solver=styled, solver=pictured or grade=image without an image, or with one of a wrong size
  no_corners = -20,     // corner tiles of a recipe that cannot be shared: one-bit cells (use the plane), a map, no steps
  bad_sides = -21,      // sides of patches that do not pair up, or for cells or a solver that know none
  bad_surface = -22,    // solver=surface without a surface, or with one that is not measured, too fine, or of another size
  no_coverage = -24,    // coverage= of a window of the plane or of joined patches: it is a share of a whole tile

  // parse and begin: Trouble or Need says which number
  unstable = -23,       // numbers with which a stage's steps would diverge, or too small for its grid

  // stamp, change, go_on
  not_now = -30,        // within a step, a start or a refinement; or of a texture that cannot be disturbed so
};

}  // namespace dapple
