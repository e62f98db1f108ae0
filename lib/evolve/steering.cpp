// Steps along a field of directions. See steering.hpp.
// SPDX-License-Identifier: MIT
#include "steering.hpp"

namespace dapple::evolve {

// Nodes on a torus: as many as come nearest to the distance asked for, at least one.
static uint16_t nodes_on(uint16_t size, int32_t distance) {
  return static_cast<uint16_t>(base::max(1, static_cast<int32_t>((size + distance / 2) / distance)));
}

void place_field(const Context& context, int32_t distance, stencil::DirectionField& f) {
  const uint8_t level = context.level;
  f.seed = context.seed;
  f.x = context.ground->x >> level;
  f.y = context.ground->y >> level;
  f.width = context.plane ? static_cast<uint16_t>(0) : static_cast<uint16_t>(context.ground->width >> level);
  f.height = context.plane ? static_cast<uint16_t>(0) : static_cast<uint16_t>(context.ground->height >> level);
  f.across = context.plane ? static_cast<uint16_t>(distance) : nodes_on(f.width, distance);
  f.down = context.plane ? static_cast<uint16_t>(distance) : nodes_on(f.height, distance);
}

void prepare_steered(const Context& context) {
  const int32_t* number = context.number;
  stencil::SteerSet& set = *reinterpret_cast<stencil::SteerSet*>(context.table);
  place_field(context, number[flow::nodes], set.field);
  set.field.kind = static_cast<uint8_t>(number[flow::field]);
  set.field.bend = static_cast<int16_t>(static_cast<int64_t>(number[flow::bend]) * 4096 / base::kMicro);
  set.threads = static_cast<uint8_t>(number[flow::threads]);
  for (uint8_t t = 0; t < set.threads; ++t) {
    const uint16_t doubled = static_cast<uint16_t>(2 * base::angle_of(number[flow::angles + t]));
    const stencil::Doubled thread = stencil::doubled_of(doubled);
    set.c2[t] = thread.c2;
    set.s2[t] = thread.s2;
  }
  stencil::Mask masks[stencil::kSteerable];
  int16_t sum = 0;
  stencil::make_steerable({static_cast<uint8_t>(number[flow::radius]), false, number[flow::scale], number[flow::stretch], 0}, masks, sum);
  stencil::make_set(masks, stencil::kSteerable, true, set.masks);
  set.masks.sum = sum;
}

int32_t steered_wavelength(const int32_t* number) {
  return grown_of({static_cast<uint8_t>(number[flow::radius]), false, number[flow::scale], number[flow::stretch], 0});
}

bool steered_next(const Context& context, Cursor& cursor, Sweep& sweep) {
  if (cursor.sweep++ != 0) return false;
  window_sweep(context, static_cast<uint8_t>(context.number[flow::radius]), stencil::steer_row, sweep);
  return true;
}

}  // namespace dapple::evolve
