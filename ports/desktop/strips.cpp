// The portable kernels of strips.hpp.
// SPDX-License-Identifier: MIT
#include "strip_rows.hpp"

namespace dapple::stencil {

void strip_row(const grid::Rows& rows) { strip_words<uint64_t>(*static_cast<const Strip*>(rows.in[0])); }
void turn_row(const grid::Rows& rows) { turn_words<uint64_t>(*static_cast<const Turning*>(rows.in[0])); }

}  // namespace dapple::stencil
