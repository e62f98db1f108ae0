// The table of solvers: work and time against resolution with the picture held.
// SPDX-License-Identifier: MIT
#pragma once

void print_solvers();

// Turing's spots over three grids and on the finest alone, until as many cells are on.
void print_grids();
