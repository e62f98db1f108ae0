// What recipes ask of patches and surfaces.
// SPDX-License-Identifier: MIT
#pragma once
#include "recipe.hpp"

namespace dapple {

constexpr bool takes_maps(const Stage& stage) {
  return stage.model == &mapped_model || stage.solver->maps == evolve::Maps::on || stage.solver->pictured;
}

// Hands the directions of map=image, the styles of solver=styled, the measured surface of solver=surface and the pictures
// of solver=pictured and grade=image to every stage of a recipe. begin looks at them, and answers bad_map or bad_surface
// where they are wanted and missing, or of a wrong size.
constexpr void set_maps(Recipe& recipe, const PlaceMaps& maps) {
  for (uint8_t i = 0; i < recipe.stages; ++i)
    if (takes_maps(recipe.stage[i])) recipe.stage[i].stored = &maps;
}

// The same of a surface, for recipes of the threshold family too: threshold's tensors become those of map=none or
// map=isotropic. False, and nothing changed, where a stage is of another family.
constexpr bool set_surface(Recipe& recipe, const PlaceMaps& maps) {
  for (uint8_t i = 0; i < recipe.stages; ++i)
    if (recipe.stage[i].model != &threshold_model && recipe.stage[i].model != &mapped_model) return false;
  for (uint8_t i = 0; i < recipe.stages; ++i) {
    Stage& s = recipe.stage[i];
    if (s.model == &threshold_model) {
      const bool round = s.number[threshold::diffusion] == threshold::isotropic;
      s.number[mapped::map] = round ? mapped::isotropic_pairs : mapped::none;
      s.number[mapped::detail] = mapped::kDetail[0];
    }
    s.model = &mapped_model;
    s.solver = &evolve::surface;
    s.stored = &maps;
  }
  recipe.blocks = nullptr;
  return true;
}

}  // namespace dapple

namespace dapple::api {

// Ghost cells of a patch: what one sweep needs, and one for light and refinement.
constexpr uint32_t pad_of(const Recipe& recipe, uint16_t multiple) {
  uint32_t pad = 1;
  for (uint8_t i = 0; i < recipe.stages; ++i) {
    const Stage& s = recipe.stage[i];
    const evolve::Reach reach = s.solver->reach(*s.model, s.number, s.level, s.stored);
    const uint32_t cells = static_cast<uint32_t>(reach.span > 0 ? reach.span : reach.stride) << s.level;
    pad = cells > pad ? cells : pad;
  }
  return (pad + multiple - 1) / multiple * multiple;
}

// Sides are at least that long: ghost cells have their sources within the patch.
constexpr uint16_t least_side(uint32_t pad) {
  return static_cast<uint16_t>(pad < kSmallestSide ? kSmallestSide : pad > 65535 ? 65535 : pad);
}

// `multiple`: of the finest grid's cells, what sides and places must be. pad: pad_of.
constexpr Status check_patch(const Recipe& recipe, const Domain& d, uint16_t multiple, uint32_t pad) {
  const Patches& all = *d.patches;
  const bool listed = all.patch != nullptr && all.count >= 1 && all.count <= kMostPatches && d.patch < all.count;
  if (!listed || !d.plane || d.corners != nullptr || d.x != all.patch[d.patch].x || d.y != all.patch[d.patch].y)
    return bad_sides;
  if (d.width != all.width || d.height != all.height || recipe.stage[0].model->cell == grid::Cell::bit)
    return bad_sides;
  if (first_unpaired(all).found) return bad_sides;
  const Patch& p = all.patch[d.patch];
  const auto whole = [&](int32_t cells) { return cells % multiple == 0; };
  if (!whole(d.width) || !whole(d.height) || !whole(p.x) || !whole(p.y)) return not_a_multiple;
  if (!within(p.x, -kFarthest / 2, kFarthest / 2) || !within(p.y, -kFarthest / 2, kFarthest / 2)) return too_far;
  if (d.width + 2 * pad > 65000u || d.height + 2 * pad > 65000u) return too_large;
  return d.width < least_side(pad) || d.height < least_side(pad) ? tile_too_small : ok;
}

}  // namespace dapple::api
