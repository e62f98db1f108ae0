// Sums of masks on vectors by the trees of strip_rows.hpp, in place of those of lib/stencil/slices.hpp: faster and more code.
// Same bits.
// SPDX-License-Identifier: MIT
#pragma once
#include "wide.hpp"

namespace dapple::stencil {

// Takes numbers from the sum by borrows instead of adding to its complement. As strip_column, not for sanitizers.
template <bool rom>
__attribute__((no_sanitize("address", "undefined"))) inline void add_taps(const Taps& taps, const Wide* copies,
                                                                          Wide* sum) {
  static_assert(!rom, "desktops have no memory of another kind");
  for (uint8_t i = 0; i < kSumBits; ++i) sum[i] = ~sum[i];
  take_all(taps.count, taps.index, copies, sum);
}

}  // namespace dapple::stencil
