// The face of the library: checks arguments, then calls down. The only place that distrusts its input.
// SPDX-License-Identifier: MIT
#include "dapple.hpp"

namespace dapple {

constexpr int32_t kNone = INT32_MAX;

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
  Need wanted = api::need_of(checked, domain, options.bands, options.kept, parts);
  if (wanted.status == ok && domain.patches != nullptr && domain.patches->count > 1) wanted.status = bad_sides;
  if (wanted.status == ok && (memory == nullptr || bytes < wanted.bytes)) wanted.status = too_little_memory;
  if (need != nullptr) *need = wanted;
  if (wanted.status != ok) return wanted.status;

  rom_ = rom;
  frugal_ = false;
  rows_in_all_ = wanted.rows;
  const evolve::Plan plan = {&stored->start, stored->stage, checked.stages, rom};
  const Domain grown = api::with_edge(domain);
  evolve::Ghosts ghosts{};
  if (domain.patches != nullptr) ghosts.seal = domain.patches->work->seal_row;
  const evolve::Setup setup = {plan,           grown, api::ground_of(domain, wanted), parts, base::aligned4(memory),
                               options.kernels, seed,  options.bands, ghosts, options.driver};
  lay_out(setup, stored, domain);
  if (wanted.block == 0) {
    evolve::begin(run_, setup);
    return ok;
  }
  blocks_ = evolve::blocks_in(setup.memory, parts);
  rows_in_all_ = checked.blocks->begin(api::growth_of(checked), setup, options.kept, options.again, run_);
  return ok;
}

Status Texture::begin(const Fixed& fixed, uint32_t seed, void* memory, size_t bytes) {
  const Need need = base::rom_load(&fixed.need);
  if (need.status != ok) return need.status;
  if (memory == nullptr || bytes < need.bytes) return too_little_memory;
  rom_ = true;
  frugal_ = base::rom_load(&fixed.frugal);
  rows_in_all_ = need.rows;
  const evolve::Plan plan = {&fixed.recipe.start, fixed.recipe.stage, base::rom_load(&fixed.recipe.stages), true};
  const Domain domain = base::rom_load(&fixed.domain);
  evolve::Setup setup = {plan, api::with_edge(domain), base::rom_load(&fixed.ground), base::rom_load(&fixed.parts), base::aligned4(memory), nullptr, seed, 1, {}};
  setup.parts.frugal = frugal_;
  lay_out(setup, &fixed.recipe, domain);
  evolve::begin(run_, setup);
  return ok;
}

// A patch of an atlas, which has checked everything.
void Texture::begin_patch(const Recipe& recipe, const Domain& domain, uint32_t seed, uint8_t* memory, const Options& options,
                          const evolve::Ghosts& ghosts) {
  evolve::Parts parts{};
  const Need need = api::need_of(recipe, domain, options.bands, 0, parts);
  rom_ = frugal_ = false;
  rows_in_all_ = need.rows;
  const evolve::Plan plan = {&recipe.start, recipe.stage, recipe.stages, false};
  const evolve::Setup setup = {plan, api::with_edge(domain), api::ground_of(domain, need), parts, memory, options.kernels,
                               seed, options.bands, ghosts};
  lay_out(setup, &recipe, domain);
  evolve::begin(run_, setup);
}

// Lays out the memory: planes, scratch, table, bands, ghosts or blocks, painting (frugal: where scratch is). All has been
// checked.
void Texture::lay_out(const evolve::Setup& setup, const Recipe* recipe, const Domain& domain) {
  const evolve::Parts& parts = setup.parts;
  recipe_ = recipe;
  paint_ = nullptr;
  domain_ = domain;
  blocks_ = nullptr;
  rows_seen_ = UINT64_MAX;
  field_ = setup.memory + parts.planes + parts.table + parts.bands + parts.ghosts + parts.blocks + (frugal_ ? 0 : parts.scratch);
  work_ = field_ + (frugal_ ? 1 : 3) * grid::scratch_bytes(grid::Cell::int16, setup.domain.width, 1);
}

Status Texture::step(uint32_t rows) {
  return (blocks_ == nullptr ? evolve::advance(run_, rows) : blocks_->advance(*blocks_, run_, rows)) ? more : done;
}

Status Texture::stamp(int32_t x, int32_t y, uint16_t radius, bool on) {
  rows_seen_ = UINT64_MAX;
  return between_steps() ? evolve::stamp(run_, x, y, radius, on) : not_now;
}

Status Texture::change(uint8_t slot, int32_t value) {
  rows_seen_ = UINT64_MAX;
  return between_steps() ? evolve::change(run_, slot, value) : not_now;
}

Status Texture::go_on(uint32_t steps) {
  rows_seen_ = UINT64_MAX;
  uint64_t rows = 0;
  const Status status = between_steps() ? evolve::go_on(run_, steps, rows) : not_now;
  rows_in_all_ += rows;
  return status;
}

// Forgets the rows at hand if anything has moved since they were made.
void Texture::look_again() {
  if (rows_seen_ == run_.rows) return;
  rows_seen_ = run_.rows;
  for (int32_t& held : held_rows_) held = kNone;
  if (decided()) evolve::forget_rows(run_, reinterpret_cast<int16_t*>(field_), work_);
}

void Texture::row(uint16_t y, int16_t* out) {
  if (frugal_ && run_.phase != evolve::Phase::done) return;
  look_again();
  if (!domain_.plane) return evolve::field_row(run_, y, out, work_);
  grid::copy_bytes(out, field_row(y, y), sizeof(int16_t) * domain_.width);
}

// Field row y with its halo, y from -1 to height. Rows are kept while nothing has moved, so that painting down a tile
// makes each row once; the slot given up holds none of the rows around `centre`.
int16_t* Texture::field_row(int32_t y, int32_t centre) {
  look_again();
  const int32_t height = domain_.height;
  const auto folded = [&](int32_t row) { return domain_.plane ? row : (row + height) % height; };
  const int32_t wanted = folded(y);
  uint8_t slot = 0;
  const uint8_t slots = frugal_ ? 1 : 3;
  while (slot < slots && held_rows_[slot] != wanted) ++slot;
  const bool held = slot < slots;
  const auto around = [&](int32_t row) { return row == centre || row == folded(centre + 1) || row == folded(centre - 1); };
  for (uint8_t i = 0; i < slots && slot == slots; ++i)
    if (frugal_ || held_rows_[i] == kNone || !around(held_rows_[i])) slot = i;
  const uint16_t width = api::with_edge(domain_).width;
  int16_t* const row = reinterpret_cast<int16_t*>(field_ + slot * grid::scratch_bytes(grid::Cell::int16, width, 1) +
                                                  grid::halo_bytes(grid::Cell::int16, 1));
  if (held) return row;
  if (!decided()) {
    for (uint16_t x = 0; x < width; ++x) row[x - 1] = 0;
  } else if (domain_.plane) {
    evolve::field_row(run_, static_cast<uint16_t>(wanted + 1), row - 1, work_);
  } else {
    evolve::field_row(run_, static_cast<uint16_t>(wanted), row, work_);
    grid::wrap_row(grid::Cell::int16, row, width, 1);
  }
  held_rows_[slot] = wanted;
  return row;
}

void Texture::paint(uint16_t y, Pixels format, void* out) {
  Brush brush;
  brush.format = format;
  paint(y, brush, out);
}

// By a port's kernel, apart: a call of a row kernel is large.
DAPPLE_APART static void paint_by(const grid::KernelSwap* kernels, const paint::Job& job) {
  grid::Rows rows;
  rows.in[0] = &job;
  grid::choose(kernels, paint::job_row)(rows);
}

// The colours of a row whose field is at hand.
DAPPLE_APART void Texture::colour(const Brush& brush, const paint::Source& source, uint8_t* out) {
  const Paint paint = paint_ != nullptr ? *paint_ : rom_ ? base::rom_load(&recipe_->paint) : recipe_->paint;
  paint::Shader shader = paint::shader_of(paint, brush, run_.model.unit, cell_level(), run_.seed);
  if (frugal_) shader.slope = 0;
  if (run_.kernels == nullptr) paint::paint_row(shader, brush, source, out);
  else paint_by(run_.kernels, {&shader, &brush, &source, out});
}

// The field's rows around y; false where a frugal texture is not done.
bool Texture::look_at(uint16_t y, paint::Source& source) {
  if (frugal_ && run_.phase != evolve::Phase::done) return false;
  source.width = domain_.width;
  source.y = y;
  source.world_x = domain_.plane ? domain_.x : 0;
  source.world_y = domain_.plane ? domain_.y + y : y;
  source.here = source.above = source.below = field_row(y, y);
  if (!frugal_) {
    source.above = field_row(y - 1, y);
    source.below = field_row(y + 1, y);
  }
  return true;
}

void Texture::paint(uint16_t y, const Brush& brush, void* out) {
  paint::Source source;
  if (look_at(y, source)) colour(brush, source, static_cast<uint8_t*>(out));
}

void Texture::paint(uint16_t y, const Layer* layers, uint8_t count) {
  paint::Source source;
  if (!look_at(y, source)) return;
  for (uint8_t i = 0; i < count; ++i) colour(layers[i].brush, source, static_cast<uint8_t*>(layers[i].row));
}

}  // namespace dapple
