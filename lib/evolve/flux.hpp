// The macro step of eq. (12) with a map of directions: one reaction, then the passes of stencil/flux.hpp over all
// planes at once. `flux` keeps the map in planes of its own, 2 bytes a cell; `lean_flux` makes its rows anew for every
// sweep. Same bytes. `styled` keeps two planes more: wavelength, rho and k from an image; `surface` three: what undoes
// the metric of a surface [4].
// SPDX-License-Identifier: MIT
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

// What is kept in planes behind the model's: nothing; the maps; and styles; or, instead of those, a surface's V.
enum class Keeps : uint8_t { nothing, maps, styles, surface };

constexpr uint8_t maps_of(const int32_t* number) {
  return number[mapped::map] == mapped::two_angle ? stencil::kMostMaps : 1;
}
constexpr uint8_t kept_planes(const int32_t* number, Keeps keeps) {
  return static_cast<uint8_t>((keeps == Keeps::nothing ? 0 : maps_of(number)) +
                              (keeps == Keeps::styles    ? stencil::kStyleRows
                               : keeps == Keeps::surface ? stencil::kInverseRows
                                                         : 0));
}

// A plane's tensor where the surface's cells are smallest: times 1 / least.
constexpr int64_t on_surface(int32_t variance, const Surface& surface) {
  return base::divide_round(static_cast<int64_t>(variance) * 65536, surface.least);
}
// And as far from round as it gets anywhere; `slope` is its own, Q16.
constexpr grid::Tensor widest_on(const Surface& surface, const grid::Tensor& axes, int64_t& slope) {
  const int64_t xx = on_surface(axes.xx, surface), yy = on_surface(axes.yy, surface);
  const int64_t mean = (xx + yy) / 2, difference = (xx - yy) / 2;
  slope = difference < 0 ? -difference : difference;
  const int64_t most = slope + mean * surface.lean / 16384;
  const int64_t turned = difference < 0 ? -most : most;
  return {static_cast<int32_t>(mean + turned), 0, static_cast<int32_t>(mean - turned)};
}

// The planes' tensors on the stage's grid, without streams; on a surface also their warps, if there is room for them.
// Returns how many streams there may be.
constexpr uint8_t make_spreads(const Model& model, const int32_t* number, uint8_t level, const Surface* surface,
                               stencil::Spread* spread, stencil::Warp* warp = nullptr) {
  const uint8_t planes = model.planes(number);
  uint8_t streams = 0;
  for (uint8_t i = 0; i < planes; ++i) {
    grid::Tensor axes = grid::at_level(model.tensor(number, i), level);
    int64_t slope = 0;
    if (surface != nullptr) axes = widest_on(*surface, axes, slope);
    spread[i] = stencil::spread_of(axes);
    if (surface != nullptr && warp != nullptr)
      warp[i] = stencil::warp_of(spread[i], static_cast<int32_t>((slope * spread[i].unit + 32768) >> 16));
    if (surface != nullptr || (i & 1) == 0 || spread[i].across != spread[i - 1].across) ++streams;
  }
  return streams;
}

constexpr const Surface* surface_in(Keeps keeps, const void* given) {
  return keeps == Keeps::surface ? static_cast<const PlaceMaps*>(given)->surface : nullptr;
}

constexpr Reach reach_of_flux(const Model& model, const int32_t* number, uint8_t level, const void* given,
                              Keeps keeps) {
  stencil::Spread spread[8] = {};
  const uint8_t planes = model.planes(number), maps = maps_of(number), kept = kept_planes(number, keeps);
  const uint8_t streams = make_spreads(model, number, level, surface_in(keeps, given), spread);
  Reach reach{static_cast<uint8_t>(planes + kept), 1, 0, model.work_rows, 0, 0, 2, 0, 0, 0};
  const uint8_t more = keeps == Keeps::surface ? stencil::warp_rows(planes)
                       : keeps == Keeps::styles ? static_cast<uint8_t>(1)
                       : keeps == Keeps::nothing ? maps
                                                 : static_cast<uint8_t>(0);
  reach.halo_rows = stencil::flux_rows(planes, streams, more);
  const size_t warps = keeps == Keeps::surface ? planes * sizeof(stencil::Warp) : 0;
  reach.table = static_cast<uint16_t>((sizeof(stencil::FluxSet) + warps + 3) / 4);
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
      if (way == 0) reach.span = static_cast<uint16_t>(reach.span + stride);
    }
    if (way > 0) reach.sweeps = static_cast<uint16_t>(reach.sweeps + stages);
  }
  reach.span = wider(reach.span, reach.stride);
  if (keeps == Keeps::nothing) return reach;
  reach.kept = kept;
  reach.once = 1;
  return reach;
}
constexpr Reach flux_reach(const Model& model, const int32_t* number, uint8_t level, const void* given) {
  return reach_of_flux(model, number, level, given, Keeps::maps);
}
constexpr Reach lean_flux_reach(const Model& model, const int32_t* number, uint8_t level, const void* given) {
  return reach_of_flux(model, number, level, given, Keeps::nothing);
}
constexpr Reach styled_reach(const Model& model, const int32_t* number, uint8_t level, const void* given) {
  return reach_of_flux(model, number, level, given, Keeps::styles);
}
constexpr Reach surface_reach(const Model& model, const int32_t* number, uint8_t level, const void* given) {
  return reach_of_flux(model, number, level, given, Keeps::surface);
}

// The map of a mapped::Kind on the stage's grid.
void make_map(const Context& context, int32_t map, int64_t detail, stencil::DirectionMap& m);

// Directions from an image: there is one, of 1 to kMostImage cells either way.
constexpr Status accepts_image(int32_t map, const void* given) {
  if (map != mapped::image) return ok;
  if (given == nullptr) return bad_map;
  const DirectionImage& image = static_cast<const PlaceMaps*>(given)->direction;
  if (image.pairs == nullptr) return bad_map;
  return within(image.width, 1, kMostImage) && within(image.height, 1, kMostImage) ? ok : bad_map;
}
constexpr Status accepts_map(const int32_t* number, const void* given, const Domain&) {
  return accepts_image(number[mapped::map], given);
}

constexpr bool has_room(const int32_t* number, Keeps keeps) {
  return 2 * number[mapped::pairs] + kept_planes(number, keeps) <= grid::kMaxPlanes;
}

// And styles, for at most three pairs, and for no patches.
constexpr Status accepts_styles(const int32_t* number, const void* given, const Domain& domain) {
  if (given == nullptr || !has_room(number, Keeps::styles)) return bad_map;
  if (domain.patches != nullptr) return bad_sides;
  const StyleImage& image = static_cast<const PlaceMaps*>(given)->style;
  if (image.cells == nullptr) return bad_map;
  if (!within(image.width, 1, kMostImage) || !within(image.height, 1, kMostImage)) return bad_map;
  return accepts_map(number, given, domain);
}

// Or a surface that has been measured, of the domain's size, one for every patch or one for all; where its cells are
// smallest the tensors are within what strides reach. For at most three pairs, with two-angle for two.
constexpr int64_t kMostVariance = INT64_C(2400) << 16;
constexpr Status accepts_surface(const int32_t* number, const void* given, const Domain& domain) {
  const Surface* const surface = given == nullptr ? nullptr : static_cast<const PlaceMaps*>(given)->surface;
  if (surface == nullptr || !is_measured(*surface) || !has_room(number, Keeps::surface)) return bad_surface;
  const bool window = domain.plane && domain.patches == nullptr;
  if (window || surface->width != domain.width || surface->height != domain.height) return bad_surface;
  const uint8_t patches = domain.patches == nullptr ? 1 : domain.patches->count;
  if (surface->patches != 1 && surface->patches != patches) return bad_surface;
  for (uint8_t i = 0; i < threshold::planes(number); ++i) {
    const grid::Tensor axes = mapped::tensor(number, i);
    const int64_t xx = on_surface(axes.xx, *surface), yy = on_surface(axes.yy, *surface);
    if (xx > kMostVariance || yy > kMostVariance) return bad_surface;
  }
  return accepts_map(number, given, domain);
}

bool flux_next(const Context& context, Cursor& cursor, Sweep& sweep);
bool styled_next(const Context& context, Cursor& cursor, Sweep& sweep);
void prepare_flux(const Context& context);
void prepare_lean_flux(const Context& context);
void prepare_styled(const Context& context);
void prepare_surface(const Context& context);

// Other maps say where in the tile a direction is, which differs from tile to tile.
constexpr bool follows_corners(const int32_t* number) {
  return number[mapped::map] == mapped::corners || number[mapped::map] == mapped::none;
}

inline constexpr Solver flux DAPPLE_ROM = {flux_reach,  flux_next,         prepare_flux, nullptr,
                                           accepts_map, Sharing::reaction, 1,            follows_corners};
inline constexpr Solver lean_flux DAPPLE_ROM = {lean_flux_reach, flux_next,         prepare_lean_flux, nullptr,
                                                accepts_map,     Sharing::reaction, 1,                 follows_corners};
inline constexpr Solver styled DAPPLE_ROM = {styled_reach, styled_next, prepare_styled, nullptr, accepts_styles};
inline constexpr Solver surface DAPPLE_ROM = {surface_reach, flux_next, prepare_surface, nullptr, accepts_surface};

}  // namespace dapple::evolve
