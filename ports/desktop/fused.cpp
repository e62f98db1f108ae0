// Sweeps fused in cache. See fused.hpp.
// SPDX-License-Identifier: MIT
#include "fused.hpp"

#include <algorithm>
#include <cstring>

namespace dapple::desktop {

constexpr size_t kCache = 320 * 1024;  // bytes that may be on the move at a time
constexpr size_t kVector = 32, kGroup = 16;
constexpr size_t kBeyond = 64;                                                 // kernels read beyond a row
constexpr uint32_t kRowsAtOnce = 8, kBitRowsAtOnce = 32, kBytesAtOnce = 8192;  // at most, and about

static size_t rounded_up(size_t bytes) { return (bytes + kVector - 1) / kVector * kVector; }

// At least so many bytes, a share of 4096 beyond a multiple of it: rows of planes and copies that are as far apart as
// multiples drive each other out of the first cache.
static size_t staggered(size_t bytes, size_t share) { return (bytes + 4095) / 4096 * 4096 + share * 1088; }

static size_t group_bytes(grid::Cell cell, uint16_t halo) {
  return (grid::halo_bytes(cell, halo) + kGroup - 1) / kGroup * kGroup;
}

// Aligned are the first cells of rows or, where they are made too, of their halos.
Fused::Layout Fused::layout_of(const evolve::Field& field, uint16_t halo, bool wide) {
  const size_t halo_bytes = group_bytes(field.cell, halo);
  const size_t row =
      field.row_bytes + 2 * (field.cell == grid::Cell::int16 ? halo_bytes : grid::halo_bytes(field.cell, halo));
  // Short rows: rather no gaps than aligned.
  return {rounded_up(halo_bytes + 1) + (wide ? halo_bytes : 0),
          row < 8 * kVector ? (row + 7) / 8 * 8 : rounded_up(row)};
}

size_t Fused::Layout::bytes(size_t rows) const { return rounded_up(before + pitch * rows + kBeyond) + kVector; }
uint8_t* Fused::Layout::first(uint8_t* memory) const {
  return memory + (-reinterpret_cast<uintptr_t>(memory) & (kVector - 1)) + before;
}

// Of one sweep at least; of all of them where rows do not become longer by more than an eighth, or by a sixteenth where
// sweeps want but one cell.
uint16_t Fused::widest_halo(const evolve::Field& field, const Work& work) const {
  uint32_t most = work.halo, all = 0;
  for (size_t i = 0; i < work.count; ++i) {
    most = std::max(most, uint32_t{work.sweep[i].halo});
    all += work.sweep[i].halo;
  }
  const uint32_t share = most == 1 ? 32 : 16;
  return static_cast<uint16_t>(work.wide ? std::max(most, std::min(all, field.width / share)) : most);
}

// Whether more than a third of several rows as one would be what lies between them.
static bool mostly_gaps(const evolve::Field& field, size_t pitch) {
  return field.cell == grid::Cell::int16 && 2 * pitch > 3 * field.row_bytes;
}

void Fused::lay_out(const evolve::Field& field, const Work& work) {
  halo_ = widest_halo(field, work);
  const Layout layout = layout_of(field, halo_, work.wide);
  pitch_ = layout.pitch;
  wide_ = work.wide && !mostly_gaps(field, pitch_);
  plane_ = staggered(pitch_ * field.height, 1);
  const size_t most = field.cell == grid::Cell::bit ? kBitRowsAtOnce : kRowsAtOnce;
  at_once_ = static_cast<uint32_t>(std::max(size_t{1}, std::min(most, kBytesAtOnce / (pitch_ * work.sweep[0].count))));
  const size_t buffer = staggered(layout.bytes(0) + plane_ * work.sweep[0].count, 2), wanted = 2 * buffer;
  if (bytes_ < wanted) {
    memory_.reset(new uint8_t[wanted]);
    std::memset(memory_.get(), 0, wanted);
    bytes_ = wanted;
  }
  buffer_[0] = layout.first(memory_.get());
  buffer_[1] = buffer_[0] + buffer;
}

// A row's number below the height, from one below twice the height.
static uint32_t round(const evolve::Field& field, uint32_t y) { return y < field.height ? y : y - field.height; }

// Rows from y on that a kernel may be given at once: they, and those around them, do not go round the torus.
static uint32_t in_one_go(const evolve::Field& field, size_t pitch, uint32_t y, uint32_t reach) {
  if (mostly_gaps(field, pitch)) return 1;
  const uint32_t height = field.height, before = round(field, y + height - reach), behind = round(field, y + reach);
  const uint32_t cells = static_cast<uint32_t>(field.cell == grid::Cell::bit ? pitch * 8 : pitch / 2);
  return std::min(height - std::max(y, std::max(before, behind)), UINT32_C(65535) / cells);
}

// The halos of a row of int16, in groups of eight cells, for which there is room; and of one of whole bytes.
static void wrap(const evolve::Field& field, uint8_t* row, uint16_t halo) {
  if (field.cell == grid::Cell::bit && field.width % 8 == 0 && halo <= 8) {
    const size_t bytes = field.width / 8;
    row[-1] = row[bytes - 1];
    row[bytes] = row[0];
    return;
  }
  if (field.cell != grid::Cell::int16 || field.width < halo + 8u)
    return grid::wrap_row(field.cell, row, field.width, halo);
  uint8_t* const end = row + size_t{2} * field.width;
  for (size_t at = 0; at < size_t{2} * halo; at += kGroup) {
    std::memcpy(end + at, row + at, kGroup);
    std::memcpy(row - kGroup - at, end - kGroup - at, kGroup);
  }
}

void Fused::load(const evolve::Field& field, const Work& work, uint32_t rows) {
  for (; rows > 0; --rows, ++loaded_) {
    for (uint8_t i = 0; i < work.sweep[0].count; ++i) {
      const uint8_t plane = static_cast<uint8_t>(work.sweep[0].first + i);
      std::memcpy(row(0, i, loaded_), evolve::row_of(field, plane, static_cast<uint16_t>(loaded_)), field.row_bytes);
      wrap(field, row(0, i, loaded_), wide_ ? halo_ : stages_[0].sweep->halo);
    }
  }
}

// Row after row of stage k, as many as the stage before allows.
void Fused::do_stage(const evolve::Field& field, const Work& work, size_t k) {
  Stage& stage = stages_[k];
  const evolve::Sweep& sweep = *stage.sweep;
  const uint32_t height = field.height, before = k == 0 ? loaded_ : stages_[k - 1].done, ahead = 2 * stage.lag;
  const uint32_t end = before == height ? height : before > ahead ? before - ahead : 0;
  const bool last = k + 1 == stages_.size();
  const size_t cells = field.cell == grid::Cell::bit ? pitch_ * 8 : pitch_ / 2;
  const size_t lead = wide_ && !last ? group_bytes(field.cell, halo_) : 0;
  const uint32_t ring = 2u * sweep.radius + 1, reach = uint32_t{sweep.stride} * sweep.radius;
  grid::Rows call;  // not zeroed: that would take as long as a row
  call.p = sweep.p;
  call.part = sweep.part;
  call.table = work.table;
  call.scratch = work.scratch;
  call.planes = sweep.count;
  call.x = call.run = 0;
  for (uint32_t count; stage.done < end; stage.done += count) {
    const uint32_t y = round(field, stage.first + stage.done);
    const uint32_t most = work.rows && !last ? in_one_go(field, pitch_, y, reach) : 1;
    count = std::max(UINT32_C(1), std::min(end - stage.done, most));
    call.n = static_cast<uint16_t>(lead > 0 ? count * cells : (count - 1) * cells + field.width);
    for (uint8_t i = 0; i < sweep.count; ++i) {
      for (uint32_t j = 0, from = round(field, y + height - reach); j < ring;
           ++j, from = round(field, from + sweep.stride))
        call.in[i * ring + j] = row(k, i, from) - lead;
      call.out[i] = last ? evolve::row_of(field, static_cast<uint8_t>(sweep.first + i), static_cast<uint16_t>(y))
                         : row(k + 1, i, y) - lead;
    }
    call.y = static_cast<uint16_t>(y);
    sweep.row(call);
    for (uint8_t i = 0; i < sweep.count && stage.halo > 0; ++i)
      for (uint32_t j = 0; j < count; ++j) wrap(field, row(k + 1, i, y + j), stage.halo);
  }
}

void Fused::begin_stages(const evolve::Field& field) {
  uint32_t first = 0, before = 0;
  uint16_t beside = wide_ ? halo_ : uint16_t{0};  // good cells
  for (size_t k = 0; k < stages_.size(); ++k) {
    Stage& stage = stages_[k];
    const uint32_t reach = uint32_t{stage.sweep->stride} * stage.sweep->radius;
    stage.lag = std::max(before, reach);
    before = reach;
    first += stage.lag;
    stage.first = first % field.height;
    stage.done = 0;
    const uint16_t wanted = k + 1 < stages_.size() ? stages_[k + 1].sweep->halo : uint16_t{0};
    beside = static_cast<uint16_t>(wide_ ? beside - stage.sweep->halo : 0);
    stage.halo = wanted <= beside ? uint16_t{0} : wide_ ? halo_ : wanted;
    beside = std::max(beside, stage.halo);
  }
}

void Fused::flow(const evolve::Field& field, const Work& work) {
  begin_stages(field);
  loaded_ = 0;
  while (stages_.back().done < field.height) {
    load(field, work, std::min(at_once_, field.height - loaded_));
    for (size_t k = 0; k < stages_.size(); ++k) do_stage(field, work, k);
  }
}

void Fused::run(const evolve::Field& field, const Work& work) {
  lay_out(field, work);
  for (size_t i = 0; i < work.count;) {
    stages_.clear();
    for (size_t lines = 0; i < work.count && (stages_.empty() || lines * 2 * pitch_ * work.sweep[0].count < kCache);
         ++i) {
      lines += size_t{work.sweep[i].stride} * work.sweep[i].radius + at_once_;
      stages_.push_back({work.sweep + i, 0, 0, 0, 0});
    }
    flow(field, work);
  }
}

}  // namespace dapple::desktop
