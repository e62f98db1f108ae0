// Passes fused in cache. See fused.hpp.
// SPDX-License-Identifier: MIT
#include "fused.hpp"

#include <algorithm>

namespace dapple::desktop {

constexpr size_t kCache = 192 * 1024;  // bytes that may be on the move at a time
constexpr size_t kLine = 64;
constexpr uint32_t kRowsAtOnce = 4;

void Fused::load(const evolve::Field& field, uint8_t plane, const evolve::Sweep* chain, uint8_t* scratch, uint32_t rows) {
  grid::Rows call{};
  call.scratch = scratch;
  call.n = field.width;
  call.planes = 1;
  for (; rows > 0; --rows, ++loaded_) {
    const uint16_t y = static_cast<uint16_t>(loaded_);
    call.out[0] = evolve::row_of(field, plane, y);
    call.y = y;
    if (chain != nullptr) {
      call.p = chain->p;
      chain->row(call);
    }
    grid::copy_row(grid::Cell::int16, row(0, y), call.out[0], field.width, stages_[0].sweep->halo);
  }
}

// Row after row of stage k, as many as the stage before allows.
void Fused::pass(const evolve::Field& field, uint8_t plane, size_t k) {
  Stage& stage = stages_[k];
  const uint32_t height = field.height, before = k == 0 ? loaded_ : stages_[k - 1].done;
  // Rows that the stage before has done from this one's first row on.
  const uint32_t ahead = stage.lag + stage.lag;
  const uint32_t end = before == height ? height : before > ahead ? std::min(before - ahead, height) : 0;
  const bool last = k + 1 == stages_.size();
  const uint16_t halo = last ? uint16_t{0} : stages_[k + 1].sweep->halo;
  const uint32_t stride = stage.sweep->stride % height;
  grid::Rows call{};
  call.p = stage.sweep->p;
  call.n = field.width;
  call.planes = 1;
  uint32_t y = (stage.first + stage.done) % height;
  for (; stage.done < end; ++stage.done) {
    call.in[0] = row(k, y >= stride ? y - stride : y + height - stride);
    call.in[1] = row(k, y);
    call.in[2] = row(k, y + stride < height ? y + stride : y + stride - height);
    call.out[0] = last ? evolve::row_of(field, plane, static_cast<uint16_t>(y)) : row(k + 1, y);
    stage.sweep->row(call);
    if (halo > 0) grid::wrap_row(grid::Cell::int16, call.out[0], field.width, halo);
    if (++y == height) y = 0;
  }
}

void Fused::flow(const evolve::Field& field, uint8_t plane, const evolve::Sweep* chain, uint8_t* scratch) {
  uint32_t first = 0, reach = 0;
  for (Stage& stage : stages_) {
    stage.lag = std::max<uint32_t>(reach, stage.sweep->stride);
    reach = stage.sweep->stride;
    first += stage.lag;
    stage.first = first % field.height;
    stage.done = 0;
  }
  loaded_ = 0;
  while (stages_.back().done < field.height) {
    load(field, plane, chain, scratch, std::min(kRowsAtOnce, field.height - loaded_));
    for (size_t k = 0; k < stages_.size(); ++k) pass(field, plane, k);
  }
}

void Fused::run(const evolve::Field& field, const evolve::Sweep* sweep, size_t count, bool chain, uint8_t* scratch) {
  const evolve::Sweep* const along = chain ? sweep : nullptr;
  halo_ = 0;
  for (size_t i = chain; i < count; ++i) halo_ = std::max(halo_, sweep[i].halo);
  const size_t before = (size_t{2} * halo_ + kLine - 1) / kLine * kLine;
  pitch_ = 2 * before + (field.row_bytes + kLine - 1) / kLine * kLine + kLine;
  const size_t wanted = 2 * pitch_ * field.height + 2 * kLine;
  if (bytes_ < wanted) {
    memory_.reset(new uint8_t[wanted]);
    bytes_ = wanted;
  }
  uint8_t* const start = memory_.get() + (-reinterpret_cast<uintptr_t>(memory_.get()) & (kLine - 1));
  buffer_[0] = start + before;
  buffer_[1] = buffer_[0] + pitch_ * field.height;
  const uint8_t plane = sweep[0].first;
  for (size_t i = chain; i < count;) {
    stages_.clear();
    size_t lines = 0;
    for (; i < count && (stages_.empty() || lines * 2 * pitch_ < kCache); ++i) {
      lines += sweep[i].stride + kRowsAtOnce;
      stages_.push_back({sweep + i, 0, 0, 0});
    }
    flow(field, plane, stages_[0].sweep == sweep + (along != nullptr) ? along : nullptr, scratch);
  }
}

}  // namespace dapple::desktop
