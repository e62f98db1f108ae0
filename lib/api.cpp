// The face of the library: checks arguments, then calls down. The only place that distrusts its input.
// SPDX-License-Identifier: MIT
#include "dapple.hpp"

namespace dapple {

constexpr uint32_t kNone = UINT32_MAX;

Status Texture::begin(const Preset& preset, const Domain& domain, uint32_t seed, void* memory, size_t bytes,
                      const Options& options, Need* need) {
  return start(base::rom_load(&preset.recipe), &preset.recipe, true, domain, seed, memory, bytes, options, need);
}

Status Texture::begin(const Recipe& recipe, const Domain& domain, uint32_t seed, void* memory, size_t bytes,
                      const Options& options, Need* need) {
  return start(recipe, &recipe, false, domain, seed, memory, bytes, options, need);
}

Status Texture::start(const Recipe& checked, const Recipe* stored, bool rom, const Domain& domain, uint32_t seed, void* memory,
                      size_t bytes, const Options& options, Need* need) {
  evolve::Parts parts{};
  Need wanted = api::need_of(checked, domain, options.bands, parts);
  if (wanted.status == ok && (memory == nullptr || bytes < wanted.bytes)) wanted.status = too_little_memory;
  if (need != nullptr) *need = wanted;
  if (wanted.status != ok) return wanted.status;

  uint8_t* const aligned = static_cast<uint8_t*>(memory) + (-reinterpret_cast<uintptr_t>(memory) & 3u);
  recipe_ = stored;
  rom_ = rom;
  paint_ = nullptr;
  field_ = aligned + parts.planes + parts.scratch + parts.table + parts.bands;
  work_ = field_ + 3 * grid::scratch_bytes(grid::Cell::int16, domain.width, 1);
  rows_seen_ = 0;
  for (uint32_t& held : held_rows_) held = kNone;
  const evolve::Plan plan = {&stored->start, stored->stage, checked.stages, rom};
  rows_in_all_ = evolve::work_rows(plan, domain);
  Domain rolled = domain;
  rolled.x = static_cast<uint16_t>(domain.x % domain.width);
  rolled.y = static_cast<uint16_t>(domain.y % domain.height);
  evolve::begin(run_, plan, rolled, seed, options.kernels, options.bands, parts, aligned);
  return ok;
}

Status Texture::step(uint32_t rows) { return evolve::advance(run_, rows) ? more : done; }

void Texture::row(uint16_t y, int16_t* out) { evolve::field_row(run_, y, out, work_); }

// Field row y with its halo. Rows are kept while nothing has moved, so that painting down a tile makes each row once; the
// slot given up holds none of the rows around `centre`.
int16_t* Texture::field_row(uint16_t y, uint16_t centre) {
  if (rows_seen_ != run_.rows)
    for (uint32_t& held : held_rows_) held = kNone;
  rows_seen_ = run_.rows;
  uint8_t slot = 0;
  while (slot < 3 && held_rows_[slot] != y) ++slot;
  const bool held = slot < 3;
  const uint16_t height = run_.domain.height;
  const auto around = [&](uint32_t row) {
    return row == centre || row == (centre + 1u) % height || row == (centre + height - 1u) % height;
  };
  for (uint8_t i = 0; i < 3 && slot == 3; ++i)
    if (held_rows_[i] == kNone || !around(held_rows_[i])) slot = i;
  int16_t* const row = reinterpret_cast<int16_t*>(field_ + slot * grid::scratch_bytes(grid::Cell::int16, run_.domain.width, 1) +
                                                  grid::halo_bytes(grid::Cell::int16, 1));
  if (held) return row;
  evolve::field_row(run_, y, row, work_);
  grid::wrap_row(grid::Cell::int16, row, run_.domain.width, 1);
  held_rows_[slot] = y;
  return row;
}

void Texture::paint(uint16_t y, Pixels format, void* out) {
  Brush brush;
  brush.format = format;
  paint(y, brush, out);
}

void Texture::paint(uint16_t y, const Brush& brush, void* out) {
  const Paint paint = paint_ != nullptr ? *paint_ : rom_ ? base::rom_load(&recipe_->paint) : recipe_->paint;
  const paint::Shader shader = paint::shader_of(paint, brush, run_.model.unit, cell_level(), run_.seed);
  const uint16_t height = run_.domain.height;
  paint::Source source;
  source.width = run_.domain.width;
  source.y = y;
  source.above = field_row(static_cast<uint16_t>(y == 0 ? height - 1 : y - 1), y);
  source.here = field_row(y, y);
  source.below = field_row(static_cast<uint16_t>(y + 1 == height ? 0 : y + 1), y);
  paint::paint_row(shader, brush, source, static_cast<uint8_t*>(out));
}

}  // namespace dapple
