// The chunk cache. See chunks.hpp.
// SPDX-License-Identifier: MIT
#include "chunks.hpp"

#include "base/hash.hpp"

namespace dapple {

using api::kNoSlot;

Status Chunks::begin(const Preset& preset, uint32_t seed, uint16_t side, uint16_t slots, const Brush& brush,
                     void* memory, size_t bytes, const Options& options, ChunkNeed* need) {
  return start(&preset, nullptr, seed, side, slots, brush, memory, bytes, options, need);
}

Status Chunks::begin(const Recipe& recipe, uint32_t seed, uint16_t side, uint16_t slots, const Brush& brush,
                     void* memory, size_t bytes, const Options& options, ChunkNeed* need) {
  return start(nullptr, &recipe, seed, side, slots, brush, memory, bytes, options, need);
}

Status Chunks::start(const Preset* preset, const Recipe* recipe, uint32_t seed, uint16_t side, uint16_t slots,
                     const Brush& brush, void* memory, size_t bytes, const Options& options, ChunkNeed* need) {
  Options wide = options;
  wide.kept = api::kept_beside(side, slots);
  wide.again = false;
  const Need texture = api::need_of_any(side, [&](const Domain& place) {
    Need one{};  // begin without memory checks all the rest, and leaves the texture as it was
    if (preset != nullptr) texture_.begin(*preset, place, seed, nullptr, 0, wide, &one);
    else texture_.begin(*recipe, place, seed, nullptr, 0, wide, &one);
    if (one.status == too_little_memory) one.status = ok;
    return one;
  });
  ChunkNeed wanted = api::need_of_slots(texture, side, slots, brush.format);
  if (wanted.status == ok && (memory == nullptr || bytes < wanted.bytes)) wanted.status = too_little_memory;
  if (need != nullptr) *need = wanted;
  if (wanted.status != ok) return wanted.status;

  uint8_t* const aligned = base::aligned4(memory);
  preset_ = preset;
  recipe_ = recipe;
  slot_ = reinterpret_cast<api::ChunkSlot*>(aligned);
  pixels_ = aligned + slots * sizeof(api::ChunkSlot);
  pixel_bytes_ = wanted.pixels;
  pixel_step_ = wanted.slot - sizeof(api::ChunkSlot);
  memory_ = pixels_ + slots * pixel_step_;
  memory_bytes_ = wanted.working;
  options_ = wide;
  brush_ = brush;
  seed_ = seed;
  halo_ = wanted.halo;
  side_ = side;
  slots_ = slots;
  now_ = missing_ = 0;
  counters_ = {};
  sight_ = {0, 0, -1, -1};
  work_ = Work::none;
  for (uint16_t i = 0; i < slots; ++i) slot_[i] = {0, 0, 0, kNoSlot, kNoSlot, false};
  return ok;
}

// The bucket's first slot, for reading and writing.
uint16_t& Chunks::bucket_of(int32_t cx, int32_t cy) const {
  const uint32_t mixed =
      base::mix(static_cast<uint32_t>(cx) * UINT32_C(0x9e3779b1) + base::mix(static_cast<uint32_t>(cy)));
  return slot_[mixed % slots_].first;
}

uint16_t Chunks::find(int32_t cx, int32_t cy) const {
  if (slots_ == 0) return kNoSlot;
  uint16_t i = bucket_of(cx, cy);
  while (i != kNoSlot && (slot_[i].x != cx || slot_[i].y != cy)) i = slot_[i].next;
  return i;
}

const uint8_t* Chunks::pixels(int32_t cx, int32_t cy) const {
  const uint16_t i = find(cx, cy);
  return i == kNoSlot ? nullptr : pixels_of(i);
}

// Chunks that lie partly beyond where windows can be are too far as a whole.
Status Chunks::find_sight(int32_t x, int32_t y, uint16_t width, uint16_t height, Sight& sight) const {
  if (width == 0 || height == 0) return bad_side;
  if (x < -kFarthest || y < -kFarthest || x > kFarthest - width || y > kFarthest - height) return too_far;
  sight = {chunk_at(x, side_), chunk_at(y, side_), chunk_at(x + (width - 1), side_), chunk_at(y + (height - 1), side_)};
  Need need{};
  need.halo = halo_;
  const Domain first = window(sight.left * side_, sight.top * side_, side_, side_);
  const Domain last = window(sight.right * side_, sight.bottom * side_, side_, side_);
  if (api::check_window(first, need) != ok || api::check_window(last, need) != ok) return too_far;
  const uint32_t across = static_cast<uint32_t>(sight.right - sight.left) + 1;
  const uint32_t down = static_cast<uint32_t>(sight.bottom - sight.top) + 1;
  return across > slots_ / down ? too_little_memory : ok;
}

Status Chunks::look_at(int32_t x, int32_t y, uint16_t width, uint16_t height) {
  Sight sight{};
  const Status status = find_sight(x, y, width, height, sight);
  if (status != ok) return status;
  ++now_;
  missing_ = 0;
  for (int32_t cy = sight.top; cy <= sight.bottom; ++cy)
    for (int32_t cx = sight.left; cx <= sight.right; ++cx) {
      const uint16_t i = find(cx, cy);
      if (i == kNoSlot) ++missing_;
      else slot_[i].seen = now_;
      if (!sight_.shows(cx, cy)) ++(i == kNoSlot ? counters_.misses : counters_.hits);
    }
  sight_ = sight;
  middle_x_ = 2 * x + width;
  middle_y_ = 2 * y + height;
  if (work_ != Work::none && !sight.shows(cx_, cy_)) {
    work_ = Work::none;  // a slot it has is not ready, hence empty
    ++counters_.abandoned;
  }
  return ok;
}

Status Chunks::step(uint32_t rows) {
  while (missing_ > 0) {
    if (rows == 0) return more;
    if (work_ == Work::none) open_nearest();
    rows -= work_ == Work::growing ? grow_rows(rows) : paint_rows(rows);
  }
  return done;
}

// Square of the distance of a chunk in sight from the middle of the view, half cells: at most 2 (65535 + 2 * 65000)^2.
uint64_t Chunks::distance_of(int32_t cx, int32_t cy) const {
  const int64_t dx = (2 * static_cast<int64_t>(cx) + 1) * side_ - middle_x_;
  const int64_t dy = (2 * static_cast<int64_t>(cy) + 1) * side_ - middle_y_;
  return static_cast<uint64_t>(dx * dx + dy * dy);
}

// The chunk in sight nearest to the middle of the view, of those that are missing, of which there are some.
void Chunks::find_missing(int32_t& x, int32_t& y) const {
  uint64_t nearest = UINT64_MAX;
  for (int32_t cy = sight_.top; cy <= sight_.bottom; ++cy)
    for (int32_t cx = sight_.left; cx <= sight_.right; ++cx) {
      const uint64_t distance = distance_of(cx, cy);
      if (distance >= nearest || find(cx, cy) != kNoSlot) continue;
      nearest = distance;
      x = cx;
      y = cy;
    }
}

// begin has checked all there is to check.
void Chunks::begin_texture(Texture& texture, int32_t cx, int32_t cy, uint8_t* memory, const Options& options) const {
  const Domain place = window(cx * side_, cy * side_, side_, side_);
  if (preset_ != nullptr) texture.begin(*preset_, place, seed_, memory, memory_bytes_, options);
  else texture.begin(*recipe_, place, seed_, memory, memory_bytes_, options);
}

void Chunks::open_nearest() {
  find_missing(cx_, cy_);
  begin_texture(texture_, cx_, cy_, memory_, options_);
  options_.again = true;
  work_ = Work::growing;
}

uint32_t Chunks::grow_rows(uint32_t rows) {
  const uint64_t before = texture_.rows_done();
  if (texture_.step(rows) == done) {
    at_slot_ = make_room();
    at_row_ = 0;
    work_ = Work::painting;
  }
  return static_cast<uint32_t>(texture_.rows_done() - before);
}

// An empty slot. There is one, or a chunk out of sight: the sight fits the slots, and one chunk of it is missing.
uint16_t Chunks::make_room() {
  uint16_t found = kNoSlot;
  uint32_t longest = 0;
  for (uint16_t i = 0; i < slots_; ++i) {
    const api::ChunkSlot& slot = slot_[i];
    if (!slot.ready) return i;
    const uint32_t age = now_ - slot.seen;
    if (sight_.shows(slot.x, slot.y) || (found != kNoSlot && age <= longest)) continue;
    found = i;
    longest = age;
  }
  api::ChunkSlot& leaving = slot_[found];
  uint16_t* link = &bucket_of(leaving.x, leaving.y);
  while (*link != found) link = &slot_[*link].next;
  *link = leaving.next;
  leaving.ready = false;
  --counters_.held;
  counters_.bytes -= pixel_bytes_;
  ++counters_.evicted;
  return found;
}

void Chunks::paint_row(Texture& texture, uint16_t y, uint8_t* pixels) const {
  const uint8_t shared = api::rows_a_line(brush_.format);
  const size_t bytes = line_bytes();
  uint8_t* const line = pixels + y / shared * bytes;
  if (y % shared == 0)
    for (size_t i = 0; i < bytes; ++i) line[i] = 0;
  texture.paint(y, brush_, line);
}

uint32_t Chunks::paint_rows(uint32_t rows) {
  uint32_t painted = 0;
  for (; painted < rows && at_row_ < side_; ++painted, ++at_row_) paint_row(texture_, at_row_, pixels_of(at_slot_));
  if (at_row_ == side_) {
    list(at_slot_, cx_, cy_);
    work_ = Work::none;
  }
  return painted;
}

// The chunk is there.
void Chunks::list(uint16_t at_slot, int32_t cx, int32_t cy) {
  uint16_t& first = bucket_of(cx, cy);
  api::ChunkSlot& slot = slot_[at_slot];
  slot.x = cx;
  slot.y = cy;
  slot.seen = now_;
  slot.next = first;
  slot.ready = true;
  first = at_slot;
  --missing_;
  ++counters_.grown;
  ++counters_.held;
  counters_.bytes += pixel_bytes_;
}

bool Chunks::take(TakenChunk& taken) {
  if (work_ != Work::none || missing_ == 0) return false;
  find_missing(taken.x, taken.y);
  const uint16_t slot = make_room();
  list(slot, taken.x, taken.y);
  taken.pixels = pixels_of(slot);
  return true;
}

void Chunks::fill(const TakenChunk& taken, Texture& texture, void* memory, evolve::Driver* driver, bool again) const {
  Options options = options_;
  options.driver = driver;
  options.again = again;
  begin_texture(texture, taken.x, taken.y, static_cast<uint8_t*>(memory), options);
  texture.finish();
  for (uint16_t y = 0; y < side_; ++y) paint_row(texture, y, taken.pixels);
}

}  // namespace dapple
