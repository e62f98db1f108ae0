// Masks made once. See ready.hpp.
// SPDX-License-Identifier: MIT
#include "ready.hpp"

namespace dapple::desktop {

Ready::Ready(const Recipe& recipe) : recipe_(recipe) {
  Stage& stage = recipe_.stage[0];
  if (recipe.stages != 1 || stage.model != &bits_model || !stage.model->in_range(stage.number)) return;
  if (!evolve::make_stored(stage.number, masks_.set, masks_.taps)) return;
  stage.solver = &evolve::stored;
  stage.stored = &masks_;
}

}  // namespace dapple::desktop
