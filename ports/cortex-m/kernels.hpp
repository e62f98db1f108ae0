// Lists of row kernels for Options::kernels, each with the bytes of the portable ones: helium.cpp and dsp.cpp.
// SPDX-License-Identifier: MIT
#pragma once
#include "grid/rows.hpp"

namespace dapple::helium {
extern const grid::KernelSwap kernels[];  // Cortex-M55 and M85: M-profile vectors (MVE)
}
namespace dapple::dsp {
extern const grid::KernelSwap kernels[];  // Cortex-M4, M7, M33: two cells in a register (SIMD32)
}
