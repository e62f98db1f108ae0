// Macro steps along a map of directions. See flux.hpp.
// SPDX-License-Identifier: MIT
#include "flux.hpp"

#include "steering.hpp"

namespace dapple::evolve {

static uint16_t period(const Context& context, uint16_t size) {
  const bool window = context.plane && context.ground->patches == nullptr;
  return static_cast<uint16_t>((window ? stencil::kPlanePeriod : size) >> context.level);
}

static stencil::DirectionMap::Kind kind_of(int32_t map) {
  using stencil::DirectionMap;
  switch (map) {
    case mapped::radial:
      return DirectionMap::radial;
    case mapped::scallop:
      return DirectionMap::scallop;
    case mapped::haunch:
      return DirectionMap::haunch;
    case mapped::two_angle:
      return DirectionMap::two_angle;
    case mapped::swirl:
    case mapped::bends:
      return DirectionMap::swirl;
    case mapped::corners:
      return DirectionMap::corners;
    case mapped::image:
      return DirectionMap::image;
    default:
      return DirectionMap::none;
  }
}

constexpr int32_t kMostBend = 900000;  // corners: between two colours, of 90 degrees; beyond, halfway vectors vanish

void make_map(const Context& context, int32_t map, int64_t detail, stencil::DirectionMap& m) {
  m = stencil::DirectionMap{};
  m.kind = kind_of(map);
  const Patches* const patches = context.ground->patches;
  m.width = period(context, patches != nullptr ? patches->width : context.ground->width);
  m.height = period(context, patches != nullptr ? patches->height : context.ground->height);
  m.rows = static_cast<uint16_t>(context.ground->height >> context.level);
  m.x = context.ground->x >> context.level;
  m.y = context.ground->y >> context.level;
  m.core = static_cast<int32_t>(detail * detail / 4 * 1024 / base::kMicro * 1024 / base::kMicro);
  m.across = static_cast<uint16_t>(base::clamp(static_cast<int32_t>(base::divide_round(base::kMicro, detail)), 1, 16));
  m.down = static_cast<uint16_t>(
      2 * base::max(1, static_cast<int32_t>(base::divide_round(static_cast<int64_t>(m.across) * m.height, m.width))));
  const int32_t distance = static_cast<int32_t>(base::divide_round(detail * m.width, base::kMicro));
  place_field(context, base::max(distance, 2), m.field);
  m.field.kind = map == mapped::swirl ? stencil::vectors : stencil::scalars;
  m.field.bend = 5325;  // 1.3 turns
  const uint16_t turn =
      static_cast<uint16_t>(base::divide_round(base::min(static_cast<int32_t>(detail), kMostBend) * INT64_C(16384), base::kMicro));
  m.c2 = static_cast<int16_t>(base::cosine(turn) >> 3);
  m.s2 = static_cast<int16_t>(base::sine(turn) >> 3);
  stencil::set_images(m, context.stored);
  stencil::set_patches(m, patches);
  m.patch = context.ground->patch;
  m.level = context.level;
  m.pad = static_cast<uint16_t>(context.ground->pad >> context.level);
}

// The stream of this direction, a new one if there is none yet.
static uint8_t stream_of(stencil::FluxSet& set, const stencil::FluxSet::Stream& wanted) {
  for (uint8_t i = 0; i < set.streams; ++i)
    if (set.stream[i].map == wanted.map && set.stream[i].c == wanted.c && set.stream[i].s == wanted.s) return i;
  set.stream[set.streams] = wanted;
  return set.streams++;
}

static void fill_set(const Context& context, Keeps keeps) {
  const int32_t* number = context.number;
  const Model& model = *context.model;
  stencil::FluxSet& set = *reinterpret_cast<stencil::FluxSet*>(context.table);
  make_map(context, number[mapped::map], number[mapped::detail], set.map);
  set.planes = model.planes(number);
  set.maps = maps_of(number);
  set.kept = keeps != Keeps::nothing;
  set.styled = keeps == Keeps::styles;
  set.warped = keeps == Keeps::surface;
  set.halo = reach_of_flux(model, number, context.level, context.stored, keeps).halo;
  set.streams = 0;
  make_spreads(model, number, context.level, surface_in(keeps, context.stored), set.spread,
               reinterpret_cast<stencil::Warp*>(&set + 1));
  for (uint8_t i = 0; i < set.planes; ++i) {
    const uint8_t pair = i / 2;
    const uint16_t turn = static_cast<uint16_t>(2 * base::angle_of(number[mapped::angles + pair]) +
                                                (set.spread[i].across ? 0x8000u : 0u));
    const stencil::FluxSet::Stream stream = {static_cast<uint8_t>(pair % set.maps), base::cosine(turn),
                                             base::sine(turn)};
    if (set.warped) set.stream[set.streams] = stream;
    set.spread[i].stream = set.warped ? set.streams++ : stream_of(set, stream);
  }
}

void prepare_flux(const Context& context) { fill_set(context, Keeps::maps); }
void prepare_lean_flux(const Context& context) { fill_set(context, Keeps::nothing); }
void prepare_styled(const Context& context) { fill_set(context, Keeps::styles); }
void prepare_surface(const Context& context) { fill_set(context, Keeps::surface); }

static const stencil::FluxSet& set_of(const Context& context) {
  return *reinterpret_cast<const stencil::FluxSet*>(context.table);
}

// Planes of maps and styles, or of a surface.
static uint8_t kept_planes(const stencil::FluxSet& set) {
  return static_cast<uint8_t>((set.kept ? set.maps : 0) + (set.styled ? stencil::kStyleRows : 0) +
                              (set.warped ? stencil::kInverseRows : 0));
}

// The way at a place in the order, which turns round from step to step: what the order does cancels.
static uint8_t way_at(const Context& context, uint8_t place) {
  return static_cast<uint8_t>((context.clock.step & 1) != 0 ? stencil::kWays - 1 - place : place);
}

// The passes of one way and stage, or all of (1, 0).
static void pass_sweep(const Context& context, uint8_t way, uint8_t stage, Sweep& sweep) {
  const stencil::FluxSet& set = set_of(context);
  const stencil::Way w = stencil::way_of(way);
  const uint16_t stride = stencil::stride_of(stage);
  sweep.first = 0;
  sweep.count = static_cast<uint8_t>(set.planes + kept_planes(set));
  sweep.row = grid::choose(context.kernels, way == 0 ? stencil::flux_chain_row : stencil::flux_row);
  sweep.radius = static_cast<uint8_t>(way == 0 ? 0 : 1);
  sweep.stride = static_cast<uint16_t>(stride * w.vy);
  sweep.halo = static_cast<uint16_t>(stride * (w.vx < 0 ? -w.vx : w.vx));
  sweep.p[0] = way;
  sweep.p[1] = stage;
}

// cursor.plane: 0 the map, 1 the reaction, 2 the passes; cursor.direction and series.made: place and stage of the next
// one.
bool flux_next(const Context& context, Cursor& cursor, Sweep& sweep) {
  const stencil::FluxSet& set = set_of(context);
  if (cursor.sweep++ == 0) cursor.plane = set.kept && context.first ? 0 : 1;
  if (cursor.plane == 0) {
    cursor.plane = 1;
    sweep.row = grid::choose(context.kernels, stencil::keep_map_row);
    sweep.first = set.planes;
    sweep.count = kept_planes(set);
    sweep.radius = 0;
    return true;
  }
  if (cursor.plane == 1) {
    cursor.plane = 2;
    cursor.direction = 0;
    cursor.series.made = 0;
    sweep.row = grid::choose(context.kernels, context.model->impulse);
    sweep.first = 0;
    sweep.count = set.planes;
    sweep.radius = 0;
    context.model->values(context.number, context.clock, sweep.p);
    return true;
  }
  for (; cursor.direction < stencil::kWays; ++cursor.direction) {
    const uint8_t way = way_at(context, cursor.direction), stage = static_cast<uint8_t>(cursor.series.made);
    if (stage < (way == 0 ? 1 : way_stages(set.spread, set.planes, way))) {
      ++cursor.series.made;
      pass_sweep(context, way, stage, sweep);
      return true;
    }
    cursor.series.made = 0;
  }
  return false;
}

// The reaction reads the styles too.
bool styled_next(const Context& context, Cursor& cursor, Sweep& sweep) {
  if (!flux_next(context, cursor, sweep)) return false;
  if (sweep.row != grid::choose(context.kernels, context.model->impulse)) return true;
  sweep.row = grid::choose(context.kernels, threshold::impulse_styled_row);
  sweep.count = static_cast<uint8_t>(sweep.count + kept_planes(set_of(context)));
  return true;
}

}  // namespace dapple::evolve
