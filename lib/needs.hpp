// What a recipe needs on a domain: memory by part, sides, work; and every check that begin makes of them. Part of dapple.hpp.
// SPDX-License-Identifier: MIT
#pragma once
#include "evolve/corners.hpp"
#include "evolve/field.hpp"
#include "evolve/ghosts.hpp"
#include "recipe/presets.hpp"
#include "recipe/sides.hpp"

namespace dapple {

// What a recipe needs on a domain, and what is wrong if it does not fit.
struct Need {
  Status status;           // ok, or why begin would refuse
  size_t bytes;            // of memory in all, with slack for aligning it; 0 when status is not ok
  size_t planes, scratch, paint, rest;  // the parts of it
  uint16_t width, height;  // the smallest sides the pattern fits
  uint16_t multiple;       // sides must be multiples of this
  uint16_t reach;          // largest distance, in cells, of two cells that meet in one sweep
  uint32_t halo;           // cells grown around a window of the plane on every side; at most kWidestHalo
  uint16_t block;          // side of the blocks that a window is decided in before it is grown, cells; 0: there are none
  uint64_t sweeps;         // over the grid, in all
  uint64_t rows;           // of work in all: what step counts
  uint8_t stage;           // unstable: the stage that would diverge, and the range of the number it is about
  Bound bound;
};

constexpr uint16_t kWidestHalo = 1024;
constexpr uint16_t kBlockHalo = 256;  // recipes that have a way in blocks take it beyond this

namespace api {

// A window is grown with one more cell on every side, so that light falls across its edges as if there were none.
constexpr Domain with_edge(const Domain& d) {
  return !d.plane ? d : Domain{static_cast<uint16_t>(d.width + 2), static_cast<uint16_t>(d.height + 2), d.x - 1, d.y - 1, true, nullptr, d.patches, d.patch};
}

constexpr uint16_t side(int64_t micro) {
  const int64_t cells = (micro + base::kMicro - 1) / base::kMicro;
  return static_cast<uint16_t>(cells < kSmallestSide ? kSmallestSide : cells > 65535 ? 65535 : cells);
}

// Two wavelengths of the coarsest-grained stage, three of a corner tile; one and a half pitches of seeds (two columns, two rows
// of discs).
constexpr void smallest(const Recipe& recipe, uint8_t lengths, Need& need) {
  int64_t wide = 0;
  for (uint8_t i = 0; i < recipe.stages; ++i) {
    const Stage& s = recipe.stage[i];
    const int64_t length = (lengths * static_cast<int64_t>(s.model->wavelength(s.number))) << (s.model->coarse ? s.level : 0);
    wide = length > wide ? length : wide;
  }
  int64_t high = wide;
  if (recipe.start.kind == Start::seeds) {
    const int64_t across = static_cast<int64_t>(recipe.start.pitch) * 3 / 2;
    const int64_t down = across * recipe.start.aspect / base::kMicro;
    wide = across > wide ? across : wide;
    high = down > high ? down : high;
  }
  need.width = side(wide);
  need.height = side(high);
}

constexpr bool good_stages(const Recipe& recipe) {
  if (recipe.stages < 1 || recipe.stages > kMaxStages || recipe.start.row == nullptr || !in_range(recipe.start) || !in_range(recipe.paint)) return false;
  for (uint8_t i = 0; i < recipe.stages; ++i) {
    const Stage& s = recipe.stage[i];
    if (s.model == nullptr || s.solver == nullptr || s.level > kMaxLevel || s.steps > kMaxSteps || !s.model->in_range(s.number)) return false;
    const uint8_t planes = s.model->planes(s.number);
    if (planes < 1 || planes > grid::kMaxPlanes) return false;
    if ((i == 0) != (s.entry == Entry::start)) return false;
    if (i == 0) continue;
    const Stage& before = recipe.stage[i - 1];
    if (before.model->planes(before.number) != planes || before.model->cell != s.model->cell) return false;
    if (same_grid(s.entry) && (s.level != before.level || (s.entry != Entry::carry && !s.solver->freezes))) return false;
    const bool held = s.solver->freezes && s.entry == Entry::carry;  // what is held must have been settled
    if (held && (!before.solver->freezes || before.steps == 0)) return false;
    if (s.entry == Entry::refine && (s.refine == nullptr || s.level + 1 != before.level || s.model->cell == grid::Cell::bit)) return false;
  }
  const Stage& last = recipe.stage[recipe.stages - 1];
  return last.level == 0 || (last.model->coarse && last.level <= kMaxCoarse);
}

// How far a window's surroundings reach into it over the whole recipe, in cells of the finest grid.
constexpr uint32_t halo_of(const Recipe& recipe) {
  uint64_t halo = 0;
  for (uint8_t i = 0; i < recipe.stages; ++i) {
    const Stage& s = recipe.stage[i];
    const evolve::Reach reach = s.solver->reach(*s.model, s.number, s.level, s.stored);
    halo += (static_cast<uint64_t>(s.steps) * reach.spread) << s.level;
    if (s.entry == Entry::refine) halo += 2u << s.level;
    if (i + 1 == recipe.stages) halo += static_cast<uint32_t>(reach.field_radius + s.level + 1u) << s.level;
  }
  return halo > UINT32_MAX ? UINT32_MAX : static_cast<uint32_t>(halo);
}

// A window, before and with its halo.
constexpr Status check_window(const Domain& d, Need& need) {
  if (need.halo > kWidestHalo) return halo_too_wide;
  const int32_t room = kFarthest - 2 * kWidestHalo;
  if (d.x < -room || d.y < -room || d.x > room - d.width || d.y > room - d.height) return too_far;
  return d.width + 2u * need.halo > 65000u || d.height + 2u * need.halo > 65000u ? too_large : ok;
}

// Of corner tiles, which are a square torus: need speaks of all of them, four either way.
constexpr Status check_corners(const Recipe& recipe, const Domain& domain, Need& need) {
  for (uint8_t i = 0; i < recipe.stages; ++i) {
    const Stage& s = recipe.stage[i];
    if (s.steps == 0 || !evolve::treats_alike(s) || s.model->cell != grid::Cell::int16) return no_corners;
  }
  smallest(recipe, 3, need);
  const uint16_t side = need.width > need.height ? need.width : need.height;
  need.width = need.height = static_cast<uint16_t>(side > 65535 / grid::kTilesAcross ? 65535 : grid::kTilesAcross * side);
  need.multiple = static_cast<uint16_t>(grid::kTilesAcross * need.multiple);
  return domain.plane || domain.width != domain.height || domain.x != 0 || domain.y != 0 ? bad_side : ok;
}

constexpr evolve::Growth growth_of(const Recipe& recipe) { return {&recipe.start, recipe.stage, recipe.stages}; }

// A window in blocks is grown in the reach of its shading.
constexpr void check_blocks(const Recipe& recipe, Need& need) {
  if (recipe.blocks == nullptr || need.halo <= kBlockHalo) return;
  const evolve::BlockShape shape = recipe.blocks->shape(growth_of(recipe));
  need.block = shape.side;
  need.halo = shape.halo;
}

constexpr Status check(const Recipe& recipe, const Domain& domain, uint8_t bands, Need& need) {
  if (!good_stages(recipe)) return bad_recipe;
  if (bands < 1 || bands > kMaxBands) return bad_bands;
  need.multiple = static_cast<uint16_t>(1u << recipe.stage[0].level);
  smallest(recipe, 2, need);
  for (uint8_t i = 0; i < recipe.stages; ++i) {
    const Stage& s = recipe.stage[i];
    if (s.solver->accepts != nullptr) {
      const Status accepted = s.solver->accepts(s.number, s.stored, domain);
      if (accepted != ok) return accepted;
    }
    need.stage = i;
    need.bound = s.model->bound(s.number, s.level);
    if (!within(s.number[need.bound.slot], need.bound.low, need.bound.high)) return unstable;
  }
  if (domain.width < kSmallestSide || domain.height < kSmallestSide) return bad_side;
  if (domain.patches != nullptr) {
    need.halo = pad_of(recipe, need.multiple);
    need.width = need.height = least_side(need.halo);
    return check_patch(recipe, domain, need.multiple, need.halo);
  }
  if (has_sides(recipe)) return bad_sides;
  if (domain.corners != nullptr) {
    const Status status = check_corners(recipe, domain, need);
    if (status != ok) return status;
  }
  if (domain.plane) {
    need.halo = halo_of(recipe);
    check_blocks(recipe, need);
    return check_window(domain, need);
  }
  const bool whole = domain.width % need.multiple == 0 && domain.height % need.multiple == 0 && domain.x % need.multiple == 0 &&
                     domain.y % need.multiple == 0;
  if (!whole) return not_a_multiple;
  if (domain.width < need.width || domain.height < need.height) return tile_too_small;
  return ok;
}

constexpr grid::Ground ground_of(const Domain& domain, const Need& need) {
  return grid::ground_of(with_edge(domain), static_cast<uint16_t>(need.halo), need.block != 0 ? 1 : need.multiple);
}

// What corner tiles take of a stage beside its solver's own. A sweep over the rows of a tile stands for one over all of them.
constexpr void add_corners(const Recipe& recipe, const Stage& stage, const grid::Ground& ground, uint32_t before, Need& need) {
  uint32_t all = 0;
  for (uint8_t i = 0; i < recipe.stages; ++i) all += recipe.stage[i].steps;
  const uint32_t sweeps = evolve::corner_sweeps(*stage.solver, stage.steps, before, all, recipe.start.kind);
  const uint32_t replaced = stage.solver->sharing == evolve::Sharing::reaction ? stage.steps : 0;
  const uint16_t side = evolve::tile_side(ground, stage.level);
  need.sweeps += sweeps - replaced;
  need.rows += static_cast<uint64_t>(sweeps) * side - static_cast<uint64_t>(replaced) * side * grid::kTilesAcross;
}

constexpr evolve::Parts parts_of(const Recipe& recipe, const grid::Ground& ground, const Domain& domain, uint8_t bands, Need& need) {
  uint32_t spent = 0, steps = 0;
  evolve::Parts parts{0, 0, 0, sizeof(evolve::Band) * bands, true};
  for (uint8_t i = 0; i < recipe.stages; ++i) {
    const Stage& s = recipe.stage[i];
    evolve::add_stage(parts, s, *s.model, *s.solver, ground, recipe.stage[recipe.stages - 1].level, bands,
                      domain.corners != nullptr ? evolve::corner_rows(*s.solver) : uint8_t{0});
    const evolve::Reach reach = s.solver->reach(*s.model, s.number, s.level, s.stored);
    const uint16_t cells = static_cast<uint16_t>(reach.stride << s.level);
    need.reach = cells > need.reach ? cells : need.reach;
    need.rows += evolve::work_rows(s, *s.model, reach, ground, domain.plane, spent);
    need.sweeps += static_cast<uint64_t>(s.steps) * reach.sweeps + (s.steps > 0 ? reach.once : 0u);
    if (domain.corners != nullptr) add_corners(recipe, s, ground, steps, need);
    steps += s.steps;
  }
  if (ground.patches == nullptr) return parts;
  parts.bands = grid::align4(parts.bands);
  parts.fits = parts.fits && base::add_bytes(parts.ghosts, evolve::ghost_cells(ground), sizeof(uint32_t)) && static_cast<uint64_t>(parts.planes) <= evolve::kMostGhostBytes;
  return parts;
}

// The same of a window in blocks.
constexpr evolve::Parts block_parts_of(const Recipe& recipe, const grid::Ground& ground, uint8_t bands, uint16_t kept, Need& need) {
  const evolve::BlockNeed blocks = recipe.blocks->need(growth_of(recipe), ground, bands, kept);
  need.reach = blocks.stride;
  need.sweeps = blocks.sweeps;
  need.rows = blocks.rows;
  return blocks.parts;
}

// Three rows of the field with a halo of one, and what it takes to make one: the most of any stage.
constexpr size_t paint_bytes(const Recipe& recipe, const Domain& domain, const grid::Ground& ground) {
  size_t most = 0;
  for (uint8_t i = 0; i < recipe.stages; ++i) {
    const Stage& s = recipe.stage[i];
    const size_t bytes = evolve::field_bytes(*s.model, s.solver->reach(*s.model, s.number, s.level, s.stored), ground, domain.plane, domain.width, s.level);
    most = bytes > most ? bytes : most;
  }
  return 3 * grid::scratch_bytes(grid::Cell::int16, domain.width, 1) + most;
}

// To align the memory to four bytes, and because kernels on one-bit cells read, and ignore, up to two words beyond a row.
constexpr size_t kSlack = 3 + base::kWidestWord / 4;

constexpr Need need_of(const Recipe& recipe, const Domain& domain, uint8_t bands, uint16_t kept, evolve::Parts& parts) {
  Need need{};
  need.status = check(recipe, domain, bands, need);
  if (need.status != ok) return need;
  const grid::Ground ground = ground_of(domain, need);
  parts = need.block != 0 ? block_parts_of(recipe, ground, bands, kept, need) : parts_of(recipe, ground, domain, bands, need);
  need.planes = parts.planes;
  need.scratch = parts.scratch;
  need.paint = paint_bytes(recipe, with_edge(domain), ground);
  need.rest = parts.table + parts.bands + parts.ghosts + parts.blocks + kSlack;
  size_t total = 0;
  const bool fits = parts.fits && base::add_bytes(total, 1, need.planes) && base::add_bytes(total, 1, need.scratch) &&
                    base::add_bytes(total, 1, need.paint) && base::add_bytes(total, 1, need.rest);
  if (fits) need.bytes = total;
  else need.status = too_large;
  return need;
}

}  // namespace api

// What `recipe` needs on `domain`: constexpr where the recipe is. kept: Options::kept.
constexpr Need need_for(const Recipe& recipe, const Domain& domain, uint8_t bands = 1, uint16_t kept = 0) {
  evolve::Parts parts{};
  return api::need_of(recipe, domain, bands, kept, parts);
}
constexpr Need need_for(const Preset& preset, const Domain& domain, uint8_t bands = 1, uint16_t kept = 0) {
  return need_for(preset.recipe, domain, bands, kept);
}

// Bytes of memory begin asks for; 0 for what it refuses.
constexpr size_t bytes_for(const Recipe& recipe, const Domain& domain, uint8_t bands = 1) {
  return need_for(recipe, domain, bands).bytes;
}
constexpr size_t bytes_for(const Preset& preset, const Domain& domain, uint8_t bands = 1) {
  return need_for(preset.recipe, domain, bands).bytes;
}

}  // namespace dapple
