// Binary convolution along a field of directions, one sweep a step.
// SPDX-License-Identifier: MIT
#pragma once
#include "../model/flow.hpp"
#include "../stencil/steer.hpp"
#include "convolution.hpp"

namespace dapple::evolve {

constexpr Reach steered_reach(const Model&, const int32_t* number, uint8_t, const void*) {
  const uint8_t r = static_cast<uint8_t>(number[flow::radius]);
  const uint16_t table = static_cast<uint16_t>((stencil::steer_set_bytes(true) + 3) / 4);
  return {1, r, r, 0, 0, 0, 1, r, table, r, r, stencil::kept_bytes(r, stencil::kSteerable), stencil::copies_space(r)};
}
bool steered_next(const Context& context, Cursor& cursor, Sweep& sweep);
void prepare_steered(const Context& context);

// A field of directions on the stage's grid, its nodes `distance` cells apart; kind and bend are left to the caller.
void place_field(const Context& context, int32_t distance, stencil::DirectionField& field);

// The wavelength these numbers grow where directions hardly bend, within about 10 %: the mixture of five
// masks is not the mask it stands for.
int32_t steered_wavelength(const int32_t* number);

inline constexpr Solver steered DAPPLE_ROM = {steered_reach, steered_next, prepare_steered, stencil::steer_field};

}  // namespace dapple::evolve
