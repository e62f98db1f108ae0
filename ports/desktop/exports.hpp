// The row kernels of lib/, and of fluxed.hpp and strips.hpp, that every set has a faster one for:
// ROW(set, namespace, portable kernel, the set's own). They are looked up from the top: what is asked for at every row
// is there.
// SPDX-License-Identifier: MIT
#pragma once

#define DAPPLE_ROWS(ROW, set)                                 \
  ROW(set, paint, job_row, painted_row)                       \
  ROW(set, stencil, field_row, field_wide)                    \
  ROW(set, stencil, field_stored, field_stored_wide)          \
  ROW(set, stencil, pass_row, pass_row)                       \
  ROW(set, stencil, chain_row, chain_row)                     \
  ROW(set, stencil, five_row, five_row)                       \
  ROW(set, stencil, nine_row, nine_row)                       \
  ROW(set, evolve, narrow_row, kinetic_row)                   \
  ROW(set, stencil, five_narrow_row, five_narrow_row)         \
  ROW(set, stencil, five_wide_row, five_wide_row)             \
  ROW(set, stencil, eight_narrow_row, eight_narrow_row)       \
  ROW(set, stencil, eight_wide_row, eight_wide_row)           \
  ROW(set, evolve, kinetics_row, kinetics_wide)               \
  ROW(set, evolve, cascade_row, cascade_wide)                 \
  ROW(set, stencil, flux_row, flux_row)                       \
  ROW(set, stencil, flux_chain_row, flux_chain_row)           \
  ROW(set, stencil, keep_map_row, keep_map_row)               \
  ROW(set, stencil, pulled_row, pulled_row)                   \
  ROW(set, stencil, fluxed_row, fluxed_row)                   \
  ROW(set, stencil, convolve_row, convolve_wide)              \
  ROW(set, stencil, strip_row, strip_wide)                    \
  ROW(set, stencil, turn_row, turn_wide)                      \
  ROW(set, stencil, steer_strip_row, steer_strip_wide)        \
  ROW(set, stencil, convolve_lean, lean_wide)                 \
  ROW(set, stencil, convolve_stored, stored_wide)             \
  ROW(set, stencil, steer_row, steer_wide)                    \
  ROW(set, stencil, steer_field, steer_field_wide)            \
  ROW(set, threshold, impulse_row, impulse_row)               \
  ROW(set, threshold, decided_row, decided_row)               \
  ROW(set, threshold, given_row, given_row)                   \
  ROW(set, threshold, add_row, add_row)                       \
  ROW(set, threshold, impulse_styled_row, impulse_styled_row) \
  ROW(set, threshold, react_row, react_row)                   \
  ROW(set, gray_scott, react_row, react_row)                  \
  ROW(set, turing, react_row, react_row)                      \
  ROW(set, meinhardt_spots, react_row, react_row)             \
  ROW(set, meinhardt_stripes, react_row, react_row)           \
  ROW(set, fitzhugh_nagumo, react_row, react_row)             \
  ROW(set, schnakenberg, react_row, react_row)                \
  ROW(set, brusselator, react_row, react_row)                 \
  ROW(set, cells, window_row, window_wide)                    \
  ROW(set, cells, field_row, field_row)
