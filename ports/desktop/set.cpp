// The row kernels of lib/ for one instruction set: most are the portable files, compiled once more with that set's
// options; those on one-bit cells take the widest vectors for their words. CMakeLists.txt compiles this file once a
// set, with
//   -DDAPPLE_SET=NAME -Ddapple=dapple_NAME -DDAPPLE_WIDE=BYTES
// so that nothing in it, inline functions and templates included, has a name that the rest of the program knows: a
// linker must never take a function with the wrong instructions. The kernels go out by C names (tables.cpp).
// SPDX-License-Identifier: MIT
#include "trees.hpp"

#include "../../lib/base/math.cpp"
#include "../../lib/grid/patch.cpp"
#include "../../lib/grid/rows.cpp"
#include "../../lib/model/brusselator.cpp"
#include "../../lib/model/cells.cpp"
#include "../../lib/model/fitzhugh_nagumo.cpp"
#include "../../lib/model/gray_scott.cpp"
#include "../../lib/model/meinhardt_spots.cpp"
#include "../../lib/model/meinhardt_stripes.cpp"
#include "../../lib/model/schnakenberg.cpp"
#include "../../lib/model/threshold.cpp"
#include "../../lib/model/turing.cpp"
#include "../../lib/paint/pack.cpp"
#include "../../lib/paint/shade.cpp"
#include "../../lib/stencil/convolve.cpp"
#include "../../lib/stencil/diffuse.cpp"
#include "../../lib/stencil/directions.cpp"
#include "../../lib/stencil/flux.cpp"
#include "../../lib/stencil/laplacian.cpp"
#include "../../lib/stencil/lattice.cpp"
#include "../../lib/stencil/maps.cpp"
#include "../../lib/stencil/sliced.cpp"
#include "../../lib/stencil/steer.cpp"
#include "../../lib/stencil/surface.cpp"
#include "../../lib/stencil/warp.cpp"

#include "../../lib/evolve/euler.cpp"
#include "../../lib/evolve/kinetic_rows.cpp"

#include "exports.hpp"

#define DECLARED(set, space, portable, own) \
  extern "C" void dapple_##set##_##space##_##portable(const dapple::grid::Rows& rows);
DAPPLE_ROWS(DECLARED, DAPPLE_SET)

// This set's kernel for a portable one: namespace and name.
#define DAPPLE_NAMED(set, kernel) dapple_##set##_##kernel
#define DAPPLE_OURS(set, kernel) DAPPLE_NAMED(set, kernel)

#include "bits.hpp"
#include "flux_rows.hpp"
#include "kinetics.hpp"
#include "reactions.hpp"
#include "roots.hpp"
#include "painted.hpp"
#include "programs.hpp"
#include "steered.hpp"

#define EXPORTED(set, space, portable, own) \
  extern "C" void dapple_##set##_##space##_##portable(const dapple::grid::Rows& rows) { dapple::space::own(rows); }
DAPPLE_ROWS(EXPORTED, DAPPLE_SET)
