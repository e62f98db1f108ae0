// The portable kernels of fluxed.hpp.
// SPDX-License-Identifier: MIT
#include "flux_rows.hpp"
