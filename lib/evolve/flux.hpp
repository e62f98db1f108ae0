// The macro step of eq. (12) with a map of directions: one reaction, then the passes of stencil/flux.hpp over all
// planes at once. `flux` keeps the map in planes of its own, 2 bytes a cell; `lean_flux` makes its rows anew for every
// sweep. Same bytes. `styled` keeps two planes more: wavelength, rho and k from an image. SPDX-License-Identifier: MIT
#pragma once
#include "../model/mapped.hpp"
#include "../stencil/flux.hpp"
#include "solver.hpp"

namespace dapple::evolve {

// The stages of a way: the most of any plane.
constexpr uint8_t way_stages(const stencil::Spread* spread, uint8_t planes, uint8_t way) {
  uint8_t most = 0;
  for (uint8_t i = 0; i < planes; ++i) {
    const uint8_t stages = stencil::stages_of(spread[i], way);
    most = stages > most ? stages : most;
  }
  return most;
}

// The planes' tensors on the stage's grid, without streams. Returns how many streams there may be.
constexpr uint8_t make_spreads(const Model& model, const int32_t* number, uint8_t level, stencil::Spread* spread) {
  const uint8_t planes = model.planes(number);
  uint8_t streams = 0;
  for (uint8_t i = 0; i < planes; ++i) {
    spread[i] = stencil::spread_of(grid::at_level(model.tensor(number, i), level));
    if ((i & 1) == 0 || spread[i].across != spread[i - 1].across) ++streams;
  }
  return streams;
}

constexpr uint8_t maps_of(const int32_t* number) {
  return number[mapped::map] == mapped::two_angle ? stencil::kMostMaps : 1;
}

constexpr Reach reach_of_flux(const Model& model, const int32_t* number, uint8_t level, bool kept,
                              bool has_styles = false) {
  stencil::Spread spread[8] = {};
  const uint8_t planes = model.planes(number), maps = maps_of(number);
  const uint8_t streams = make_spreads(model, number, level, spread);
  Reach reach{static_cast<uint8_t>(planes + (kept ? maps + (has_styles ? stencil::kStyleRows : 0) : 0)),
              1,
              0,
              model.work_rows,
              0,
              0,
              2,
              0,
              0,
              0};
  reach.halo_rows = stencil::flux_rows(planes, streams, has_styles ? 1 : kept ? 0 : maps);
  reach.table = static_cast<uint16_t>((sizeof(stencil::FluxSet) + 3) / 4);
  for (uint8_t way = 0; way < stencil::kWays; ++way) {
    const stencil::Way w = stencil::way_of(way);
    const uint16_t across = static_cast<uint16_t>(w.vx < 0 ? -w.vx : w.vx);
    const uint16_t far = wider(across, static_cast<uint16_t>(w.vy));
    const uint8_t stages = way_stages(spread, planes, way);
    for (uint8_t stage = 0; stage < stages; ++stage) {
      const uint16_t stride = stencil::stride_of(stage);
      reach.halo = wider(reach.halo, static_cast<uint16_t>(stride * across));
      reach.stride = wider(reach.stride, static_cast<uint16_t>(stride * far));
      reach.spread = static_cast<uint16_t>(reach.spread + stride * far);
    }
    if (way > 0) reach.sweeps = static_cast<uint16_t>(reach.sweeps + stages);
  }
  if (!kept) return reach;
  reach.kept = static_cast<uint8_t>(maps + (has_styles ? stencil::kStyleRows : 0));
  reach.once = 1;
  return reach;
}
constexpr Reach flux_reach(const Model& model, const int32_t* number, uint8_t level) {
  return reach_of_flux(model, number, level, true);
}
constexpr Reach lean_flux_reach(const Model& model, const int32_t* number, uint8_t level) {
  return reach_of_flux(model, number, level, false);
}

// Directions from an image: there is one, of 1 to kMostImage cells either way.
constexpr bool accepts_map(const int32_t* number, const void* given) {
  if (number[mapped::map] != mapped::image) return true;
  if (given == nullptr) return false;
  const DirectionImage& image = static_cast<const PlaceMaps*>(given)->direction;
  return image.pairs != nullptr && within(image.width, 1, kMostImage) && within(image.height, 1, kMostImage);
}

// And styles, for at most three pairs: their planes and the maps' make ten.
constexpr bool accepts_styles(const int32_t* number, const void* given) {
  if (given == nullptr || number[mapped::pairs] > 3 || !accepts_map(number, given)) return false;
  const StyleImage& image = static_cast<const PlaceMaps*>(given)->style;
  return image.cells != nullptr && within(image.width, 1, kMostImage) && within(image.height, 1, kMostImage);
}

bool flux_next(const Context& context, Cursor& cursor, Sweep& sweep);
void prepare_flux(const Context& context);
void prepare_lean_flux(const Context& context);
void prepare_styled(const Context& context);
constexpr Reach styled_reach(const Model& model, const int32_t* number, uint8_t level) {
  return reach_of_flux(model, number, level, true, true);
}

// Other maps say where in the tile a direction is, which differs from tile to tile.
constexpr bool follows_corners(const int32_t* number) {
  return number[mapped::map] == mapped::corners || number[mapped::map] == mapped::none;
}

inline constexpr Solver flux DAPPLE_ROM = {flux_reach,  flux_next,         prepare_flux, nullptr,
                                           accepts_map, Sharing::reaction, 1,            follows_corners};
inline constexpr Solver lean_flux DAPPLE_ROM = {lean_flux_reach, flux_next,         prepare_lean_flux, nullptr,
                                                accepts_map,     Sharing::reaction, 1,                 follows_corners};
inline constexpr Solver styled DAPPLE_ROM = {styled_reach, flux_next, prepare_styled, nullptr, accepts_styles};

}  // namespace dapple::evolve
