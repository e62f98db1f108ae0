// The table of solvers: work and time against resolution with the picture held.
// SPDX-License-Identifier: MIT
#pragma once

void print_solvers();
