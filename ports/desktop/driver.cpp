// Whole steps on several threads. See driver.hpp.
// SPDX-License-Identifier: MIT
#include "driver.hpp"

#include <algorithm>
#include <cstring>

#include "../../lib/evolve/kinetics.hpp"
#include "../../lib/model/cells.hpp"
#include "../../lib/model/gray_scott.hpp"
#include "../../lib/stencil/flux.hpp"
#include "../../lib/stencil/lattice.hpp"

namespace dapple::desktop {

constexpr uint32_t kSmallSweep = 4096;  // bytes; below, bands are done one after the other
constexpr uint32_t kStepsAtOnce = 32;
constexpr size_t kSmallPlanes = 512 * 1024;  // bytes

Driver::Driver(unsigned threads)
    : evolve::Driver{[](evolve::Driver& driver, evolve::Run& run, uint32_t rows) {
        return static_cast<Driver&>(driver).whole_step(run, rows);
      }},
      crew_(threads),
      fused_(threads) {}

// The first sweep after those from `at` on that are passes over single planes of int16.
size_t Driver::passes_from(const evolve::Run& run, size_t at) const {
  const grid::RowKernel pass = grid::choose(run.kernels, stencil::pass_row),
                        chain = grid::choose(run.kernels, stencil::chain_row);
  for (; at < sweeps_.size(); ++at) {
    const evolve::Sweep& s = sweeps_[at];
    if (s.margin != 0 || (s.row != chain && !(s.row == pass && Fused::fits(run.field, s)))) break;
  }
  return at;
}

// A chain along x as the passes that it is made of: all three rows of their windows are one.
static void add_chain(const evolve::Run& run, const evolve::Sweep& chain, std::vector<evolve::Sweep>& passes) {
  stencil::PassSeries series = stencil::series_of(chain.p[0], 0, chain.p[2]);
  stencil::Pass pass{};
  while (stencil::next_pass(series, pass)) {
    evolve::Sweep s{};
    s.row = grid::choose(run.kernels, stencil::pass_row);
    s.first = chain.first;
    s.count = s.radius = 1;
    s.halo = pass.stride;
    s.p[0] = pass.stride, s.p[1] = pass.weight, s.p[2] = pass.rounding;
    passes.push_back(s);
  }
}

void Driver::by_plane(const evolve::Run& run, size_t from, size_t to) {
  const grid::RowKernel chain = grid::choose(run.kernels, stencil::chain_row);
  passes_.clear();
  planes_.clear();
  for (size_t i = from; i < to; ++i) {
    const bool opens = planes_.empty() || sweeps_[i].first != sweeps_[i - 1].first;
    if (opens) planes_.push_back({passes_.size(), 0});
    if (sweeps_[i].row == chain) add_chain(run, sweeps_[i], passes_);
    else passes_.push_back(sweeps_[i]);
    planes_.back().second = passes_.size();
  }
  std::atomic<size_t> next{0};
  crew_.all([&](unsigned hand) {
    if (hand >= hands(run)) return;
    for (size_t i = next++; i < planes_.size(); i = next++) {
      const size_t count = planes_[i].second - planes_[i].first;
      if (count > 0) fused_[hand].run(run.field, {&passes_[planes_[i].first], count, true, true, nullptr, nullptr});
    }
  });
}

static const stencil::FluxSet& flux_set(const evolve::Run& run) {
  return *reinterpret_cast<const stencil::FluxSet*>(run.table);
}

// The first sweep after those from `from` on that are the passes along one way of a map; `from` if they go by bands.
size_t Driver::way_from(const evolve::Run& run, size_t from) const {
  const grid::RowKernel pass = grid::choose(run.kernels, stencil::flux_row),
                        chain = grid::choose(run.kernels, stencil::flux_chain_row);
  size_t to = from;
  for (; to < sweeps_.size(); ++to) {
    const evolve::Sweep& s = sweeps_[to];
    if ((s.row != pass && s.row != chain) || s.p[0] != sweeps_[from].p[0]) break;
    const stencil::FluxSet& set = flux_set(run);
    if (!set.kept || set.styled || set.warped || hands(run) > 2u * set.planes) return from;
    if (s.margin != 0 || !Fused::fits(run.field, s)) return from;
  }
  return to;
}

void Driver::make_pulls(const evolve::Run& run, int32_t way, uint16_t halo) {
  const stencil::FluxSet& set = flux_set(run);
  const evolve::Field& field = run.field;
  const Fused::Layout layout = Fused::layout_of(field, halo, false);
  const size_t bytes = layout.bytes(size_t{field.height} * set.streams);
  if (pulls_.size() < bytes) pulls_.resize(bytes);
  pulled_ = {&set, layout.first(pulls_.data()), layout.pitch, layout.pitch * field.height, field.height};
  const grid::RowKernel row = grid::choose(run.kernels, stencil::pulled_row);
  const unsigned parts = hands(run);
  crew_.all([&](unsigned hand) {
    grid::Rows call{};
    call.p = &way;
    call.table = run.table;
    call.n = field.width;
    for (uint32_t y = field.height * hand / parts; hand < parts && y < field.height * (hand + 1) / parts; ++y) {
      for (uint8_t i = 0; i < set.maps; ++i)
        call.in[i] = evolve::row_of(field, static_cast<uint8_t>(set.planes + i), static_cast<uint16_t>(y));
      for (uint8_t i = 0; i < set.streams; ++i) call.out[i] = pulled_.cells + i * pulled_.plane + y * pulled_.pitch;
      row(call);
      for (uint8_t i = 0; i < set.streams; ++i) grid::wrap_row(field.cell, call.out[i], field.width, halo);
    }
  });
}

// A plane's passes along a way: the stages that it takes.
static void passes_of(const evolve::Run& run, uint8_t plane, uint8_t way, std::vector<evolve::Sweep>& passes) {
  const stencil::Way w = stencil::way_of(way);
  passes.clear();
  for (uint8_t stage = 0; stencil::takes(flux_set(run).spread[plane], way, stage); ++stage) {
    const uint16_t stride = stencil::stride_of(stage);
    evolve::Sweep s{};
    s.row = grid::choose(run.kernels, stencil::fluxed_row);
    s.first = plane;
    s.count = s.radius = 1;
    s.stride = static_cast<uint16_t>(stride * w.vy);
    s.halo = static_cast<uint16_t>(stride * (w.vx < 0 ? -w.vx : w.vx));
    s.p[0] = way, s.p[1] = stage, s.p[2] = plane;
    passes.push_back(s);
  }
}

// All passes along a map's way, plane by plane: planes meet in nothing but the pulls.
void Driver::by_way(const evolve::Run& run, const evolve::Sweep& sweep) {
  const stencil::FluxSet& set = flux_set(run);
  make_pulls(run, sweep.p[0], set.halo);
  std::atomic<unsigned> next{0};
  crew_.all([&](unsigned hand) {
    if (hand >= hands(run)) return;
    std::vector<evolve::Sweep> passes;
    for (unsigned plane = next++; plane < set.planes; plane = next++) {
      passes_of(run, static_cast<uint8_t>(plane), static_cast<uint8_t>(sweep.p[0]), passes);
      if (passes.empty()) continue;
      const auto table = reinterpret_cast<const int32_t*>(&pulled_);
      fused_[hand].run(run.field, {passes.data(), passes.size(), true, false, table, nullptr, set.halo});
    }
  });
}

void Driver::by_bands(const evolve::Run& run, const evolve::Sweep& sweep) {
  evolve::begin_sweep(run.field, sweep, run.band);
  const auto do_band = [&](uint8_t i) { evolve::run_band(run.field, sweep, run.table, i, run.band[i], UINT32_MAX); };
  const size_t bytes = run.field.row_bytes * run.field.height * sweep.count;
  if (crew_.size() == 1 || run.field.bands == 1 || bytes < kSmallSweep) {
    for (uint8_t i = 0; i < run.field.bands; ++i) do_band(i);
    return;
  }
  std::atomic<unsigned> next{0};
  crew_.all([&](unsigned) {
    for (unsigned i = next++; i < run.field.bands; i = next++) do_band(static_cast<uint8_t>(i));
  });
}

// Whether the solver's steps are by a kernel that takes the old row from its window; the portable ones of kinetics want
// it in place.
static bool takes_window(const evolve::Run& run) {
  const auto swapped = [&](grid::RowKernel row) { return grid::choose(run.kernels, row) != row; };
  const auto next = run.solver.next;
  if (next == &evolve::kinetic_next) return swapped(evolve::narrow_row);
  if (next == &evolve::cascade_next) return swapped(evolve::cascade_row);
  if (next == &evolve::kinetics_next || next == &evolve::pictured_next) return swapped(evolve::kinetics_row);
  return next == &evolve::direct_next && run.model.window == &cells::window_row;
}

// Gray-Scott's kernel of such a step knows nothing but rows and numbers.
static bool is_gray_scott(const evolve::Run& run) {
  return run.solver.next == &evolve::kinetic_next && run.model.react == &gray_scott::react_row;
}

// Steps of one sweep over all planes whose kernel knows nothing of the row before: as many as the stage has left and
// the rows allow.
static bool can_flow(const evolve::Run& run, const evolve::Reach& reach) {
  const bool once = reach.once != 0 && run.step == 0;
  return reach.sweeps == 1 && !once && !run.domain.plane && run.stage.steps - run.step >= 2 && takes_window(run);
}

// Steps of the same numbers make the same of a state.
static bool same_steps(const std::vector<evolve::Sweep>& sweeps, const evolve::Sweep& as) {
  return std::all_of(sweeps.begin(), sweeps.end(), [&](const evolve::Sweep& s) {
    return s.row == as.row && std::memcmp(s.p, as.p, sizeof s.p) == 0;
  });
}

uint32_t Driver::many_at_once(evolve::Run& run) {
  const evolve::Field& field = run.field;
  const size_t bytes = field.row_bytes * field.height;
  const uint8_t first = sweeps_.front().first, planes = sweeps_.front().count;
  const auto plane = [&](uint8_t i) { return evolve::row_of(field, static_cast<uint8_t>(first + i), 0); };
  before_.resize(bytes * planes);
  for (uint8_t i = 0; i < planes; ++i) std::memcpy(&before_[i * bytes], plane(i), bytes);
  const bool many_rows = field.cell == grid::Cell::bit || is_gray_scott(run);
  fused_[0].run(field, {sweeps_.data(), sweeps_.size(), many_rows, is_gray_scott(run), run.table, field.scratch});
  for (uint8_t i = 0; i < planes; ++i)
    if (std::memcmp(&before_[i * bytes], plane(i), bytes) != 0) return 0;
  return same_steps(sweeps_, sweeps_.front()) ? static_cast<uint32_t>(sweeps_.size()) : 0;
}

// Once so many steps have left every cell as it was, as many more of the same numbers do so too.
uint32_t Driver::many_steps(evolve::Run& run, uint32_t rows) {
  uint32_t done = 0, still = 0;
  evolve::Sweep before{};
  do {
    const uint32_t steps = std::min({run.stage.steps - run.step, rows / run.field.height - done, kStepsAtOnce});
    sweeps_.clear();
    while (sweeps_.size() < steps && evolve::take_sweep(run)) {
      sweeps_.push_back(run.sweep);
      evolve::take_sweep(run);  // the step is complete
    }
    if (still == steps && same_steps(sweeps_, before)) left_out_ += steps;
    else still = many_at_once(run);
    before = sweeps_.front();
    done += steps;
  } while (still > 0 && run.step < run.stage.steps && done < rows / run.field.height);
  return done * run.field.height;
}

uint32_t Driver::whole_step(evolve::Run& run, uint32_t rows) {
  const evolve::Reach reach = run.solver.reach(run.model, run.stage.number, run.stage.level, run.stage.stored);
  if (rows / run.field.height < static_cast<uint32_t>(reach.sweeps) + reach.once) return 0;
  if (Masks::fits(run)) return masks_.steps(run, crew_, rows, left_out_);
  // Small planes: steps fused on one thread take less time than waiting for each other after every step.
  const bool small = run.field.row_bytes * run.field.height * run.model.planes(run.stage.number) <= kSmallPlanes;
  if ((crew_.size() == 1 || small) && run.field.height >= 8 && can_flow(run, reach)) return many_steps(run, rows);
  sweeps_.clear();
  uint32_t done = 0;
  while (evolve::take_sweep(run)) {
    sweeps_.push_back(run.sweep);
    done += run.field.height - 2u * run.sweep.margin;
  }
  for (size_t i = 0; i < sweeps_.size();) {
    const size_t passes = passes_from(run, i), way = way_from(run, i);
    if (passes > i) by_plane(run, i, passes);
    else if (way > i) by_way(run, sweeps_[i]);
    else by_bands(run, sweeps_[i]);
    i = std::max({passes, way, i + 1});
  }
  return done;
}

}  // namespace dapple::desktop
