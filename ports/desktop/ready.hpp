// A recipe whose masks are made once, for many textures: what firmware has the compiler do (stored_masks), at run time.
// Windows of the plane, which are small, take a good part of their time to make masks. Same bytes.
//
//   const dapple::desktop::Ready ready(recipe);
//   chunks.begin(ready.recipe(), ...);
// SPDX-License-Identifier: MIT
#pragma once
#include "../../lib/dapple.hpp"

namespace dapple::desktop {

class Ready {
 public:
  // Recipes of other families than bits, and such as would be refused, stay as they are.
  explicit Ready(const Recipe& recipe);
  Ready(const Ready&) = delete;
  Ready& operator=(const Ready&) = delete;

  // As long as this is there.
  const Recipe& recipe() const { return recipe_; }

 private:
  Recipe recipe_;
  stencil::StoredMasks<stencil::kMaxMasks> masks_{};
};

}  // namespace dapple::desktop
