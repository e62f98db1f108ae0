// Row kernels for engines with vectors of 128 bits: those of ports/desktop in place of the portable ones that
// compilers make no good vectors of. ports/wasm/build links this instead of the files of lib/ that it includes, which
// give it their inner functions; rows that nobody calls any more are left out by the linker. What is not a loop over
// cells stays small.
// SPDX-License-Identifier: MIT
#pragma clang attribute push(__attribute__((minsize)), apply_to = function)
#define DAPPLE_WIDE 16
#include "../desktop/wide.hpp"

#include "../../lib/base/math.hpp"
#include "../../lib/evolve/solver.hpp"
#include "../../lib/model/cells.hpp"
#include "../../lib/paint/paint.hpp"
#include "../../lib/stencil/convolve.hpp"
#include "../../lib/stencil/steer.hpp"

// The portable rows under other names.
#define convolve_row portable_convolve_row
#define convolve_lean portable_convolve_lean
#define field_row portable_field_row
#include "../../lib/stencil/sliced.cpp"
#undef field_row
#undef convolve_lean
#undef convolve_row

#define window_row portable_window_row
#include "../../lib/model/cells.cpp"
#undef window_row

#define steer_row portable_steer_row
#define steer_field portable_steer_field
#include "../../lib/base/math.cpp"
#include "../../lib/stencil/directions.cpp"
#include "../../lib/stencil/steer.cpp"
#undef steer_field
#undef steer_row

#define job_row portable_job_row
#define paint_row portable_paint_row
#include "../../lib/paint/pack.cpp"
#include "../../lib/paint/shade.cpp"
#undef paint_row
#undef job_row

#include "../desktop/bits.hpp"
#include "../desktop/programs.hpp"
#pragma clang attribute pop

#include "../desktop/roots.hpp"
#define job_row portable_job_row  // for what is no colour
#include "../desktop/painted.hpp"
#undef job_row
#include "../desktop/steered.hpp"

namespace dapple::stencil {
void convolve_row(const grid::Rows& rows) { convolve_wide(rows); }
void convolve_lean(const grid::Rows& rows) { lean_wide(rows); }
void field_row(const grid::Rows& rows) { field_wide(rows); }
void steer_row(const grid::Rows& rows) { steer_wide(rows); }
void steer_field(const grid::Rows& rows) { steer_field_wide(rows); }
}  // namespace dapple::stencil

namespace dapple::cells {
void window_row(const grid::Rows& rows) { window_wide(rows); }
}  // namespace dapple::cells

namespace dapple::paint {
void job_row(const grid::Rows& rows) { painted_row(rows); }
void paint_row(const Shader& shader, const Brush& brush, const Source& source, uint8_t* row) {
  const Job job = {&shader, &brush, &source, row};
  grid::Rows rows;
  rows.in[0] = &job;
  painted_row(rows);
}
}  // namespace dapple::paint
