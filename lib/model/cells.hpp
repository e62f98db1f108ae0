// Cell programs: the next state of a cell is looked up in a 32-bit program by its own state and its four neighbours'.
// Borovsky, evolutionary textures; bit index = 16 left + 8 right + 4 upper + 2 lower + self.
//
//                 upper 4
//       left 16   self 1    right 8        program bit 22 = 16 + 4 + 2: left, upper and lower are on
//                 lower 2
// SPDX-License-Identifier: MIT
#pragma once
#include "model.hpp"

namespace dapple::cells {

constexpr int16_t kUnit = 8000;  // the field of a cell that is on

enum Slot : uint8_t { program, slots };

inline constexpr Number numbers[] = {
    {Number::program, "rule", 0, 0, static_cast<int32_t>(0xe8808000u), nullptr, "the 32-bit program"},
};

constexpr bool in_range(const int32_t*) { return true; }
constexpr uint8_t planes(const int32_t*) { return 1; }
constexpr grid::Tensor tensor(const int32_t*, uint8_t) { return {0, 0, 0}; }
constexpr grid::Levels levels(const int32_t*, uint8_t) { return {0, 1, 0, 1}; }
constexpr int32_t wavelength(const int32_t*) { return 4 * base::kMicro; }  // no program has one; a tile of 8 cells will do
constexpr int16_t cell_level(const int32_t*) { return kUnit / 2; }
constexpr void values(const int32_t* number, Clock, int32_t* p) { p[0] = number[program]; }

// in: rows y - 1, y, y + 1 with halo; out[0]: row y. p: {program}. Reads and ignores up to a word beyond either halo.
void window_row(const grid::Rows& rows);
// The same on words of 8, 32 and 64 bits, whatever the machine's own is.
void window_row8(const grid::Rows& rows);
void window_row32(const grid::Rows& rows);
void window_row64(const grid::Rows& rows);
// The definition: one look-up a cell.
void window_by_cell(const grid::Rows& rows);
void field_row(const grid::Rows& rows);

}  // namespace dapple::cells

namespace dapple {
inline constexpr Model cells_model DAPPLE_ROM = {
    grid::Cell::bit,    1,                 cells::kUnit, 0,       cells::in_range,    cells::planes, cells::tensor, cells::levels, cells::wavelength,
    cells::cell_level,  cells::values,     nullptr,      nullptr, cells::window_row,  cells::field_row};
}  // namespace dapple
