// Masks made once. See ready.hpp.
// SPDX-License-Identifier: MIT
#include "ready.hpp"

namespace dapple::desktop {

// As evolve::stored_masks, for any number of them; false where one cannot be made.
static bool make(const int32_t* number, stencil::StoredMasks<stencil::kMaxMasks>& masks) {
  stencil::MaskShape shapes[stencil::kMaxMasks];
  const uint8_t count = evolve::shapes_of(number, shapes);
  const bool summed = evolve::summed(number);
  masks.set = {summed ? uint8_t{1} : count, shapes[0].radius, 0};
  for (uint8_t i = 0; i < masks.set.count; ++i) {
    stencil::Mask mask{};
    if (!stencil::make_mask(shapes + i, summed ? count : uint8_t{1}, mask)) return false;
    if (i == 0) masks.set.sum = mask.sum;
    const uint8_t side = static_cast<uint8_t>(2 * mask.radius + 1);
    if (!stencil::make_taps(mask.weight, side, side, masks.taps[i])) return false;
  }
  return true;
}

Ready::Ready(const Recipe& recipe) : recipe_(recipe) {
  Stage& stage = recipe_.stage[0];
  if (recipe.stages != 1 || stage.model != &bits_model || !stage.model->in_range(stage.number)) return;
  if (!make(stage.number, masks_)) return;
  stage.solver = &evolve::stored;
  stage.stored = &masks_;
}

}  // namespace dapple::desktop
