// A cache of square chunks of the endless plane: a camera looks at a rectangle, what is missing there grows in slices,
// what has been out of sight longest makes room. One texture is at work at a time; a slot holds finished pixels.
//
//   constexpr size_t kBytes = dapple::chunk_bytes(recipe, 64, 24, dapple::Pixels::rgb565);
//   alignas(4) static uint8_t memory[kBytes];
//   dapple::Chunks world;
//   if (world.begin(recipe, seed, 64, 24, brush, memory, sizeof memory) != dapple::ok) fault();
//   // every frame
//   world.look_at(x, y, 240, 160);
//   while (time_is_left() && world.step(16) == dapple::more) {}
//   const uint8_t* pixels = world.pixels(dapple::chunk_at(x, 64), dapple::chunk_at(y, 64));  // null: missing
//
// Chunk (cx, cy) holds the cells (cx side, cy side) .. (cx side + side - 1, cy side + side - 1): the bytes of a window
// grown there, whatever was looked at before, in whatever slices. Where windows are in blocks, the memory at work also keeps
// what is decided for as much of the plane as all slots together show: a bit and a third a cell.
// SPDX-License-Identifier: MIT
#pragma once
#include "dapple.hpp"

namespace dapple {

// chunk_at(cell, side) == floor(cell / side): the chunk a cell lies in, along either direction.
constexpr int32_t chunk_at(int32_t cell, uint16_t side) { return cell >= 0 ? cell / side : -1 - (-1 - cell) / side; }

// The most chunks a view of width x height cells can touch, wherever it is: slots that never refuse it.
constexpr uint32_t chunks_in_view(uint16_t side, uint16_t width, uint16_t height) {
  const uint32_t across = (static_cast<uint32_t>(width) + side - 2) / side + 1;
  const uint32_t down = (static_cast<uint32_t>(height) + side - 2) / side + 1;
  return across > UINT32_MAX / down ? UINT32_MAX : across * down;
}

// Chunks in sight, both ends included.
struct Sight {
  int32_t left, top, right, bottom;

  constexpr bool shows(int32_t cx, int32_t cy) const { return cx >= left && cx <= right && cy >= top && cy <= bottom; }
};

// What a cache needs, and what is wrong if it cannot be.
struct ChunkNeed {
  Status status;   // ok, or why begin would refuse
  size_t bytes;    // of memory in all, with slack for aligning it; 0 when status is not ok
  size_t working;  // of them, for the texture at work
  size_t slot;     // for every slot: header and pixels
  size_t pixels;   // of one chunk; rows of pixel_bytes(format, side), for l1_pages pages of eight rows
  uint32_t halo;   // cells grown around a chunk on every side
};

// Since begin. A chunk counts as a hit or a miss once every time it comes into sight.
struct ChunkCounters {
  uint32_t grown;      // chunks finished
  uint32_t hits;       // that were there
  uint32_t misses;     // that were not
  uint32_t evicted;    // that made room for others
  uint32_t abandoned;  // that went out of sight while they grew
  uint16_t held;       // chunks there now
  size_t bytes;        // of their pixels
};

namespace api {

// A slot and, as it happens to be as long as the list of slots, one bucket of the table that finds them.
struct ChunkSlot {
  int32_t x, y;    // the chunk
  uint32_t seen;   // the look_at that last saw it
  uint16_t next;   // in its bucket's list, kNoSlot at the end
  uint16_t first;  // of the bucket with this slot's number
  bool ready;      // listed, and its pixels are there
};

// Cells beside a chunk for which decided blocks are kept: as many as all slots in a square.
constexpr uint16_t kept_beside(uint16_t side, uint16_t slots) {
  const uint32_t across = base::square_root(slots), cells = across * side;
  return static_cast<uint16_t>(cells < 32768 ? cells : 32768);
}

constexpr uint16_t kNoSlot = UINT16_MAX;  // so there are at most 65535 slots

// Rows that share a line of pixels.
constexpr uint8_t rows_a_line(Pixels format) { return format == Pixels::l1_pages ? 8 : 1; }

// The most that the texture of any chunk needs: grids coarser than the picture are cut differently from place to place.
// ask(domain) is what it needs in one place.
template <class Ask>
constexpr Need need_of_any(uint16_t side, Ask ask) {
  Need most{};
  for (uint16_t i = 0; i == 0 || (most.status == ok && i < most.multiple); ++i) {
    const int32_t at = static_cast<int32_t>(i) * side;
    const Need need = ask(window(at, at, side, side));
    if (need.status != ok || need.bytes > most.bytes) most = need;
  }
  return most;
}

constexpr ChunkNeed need_of_slots(const Need& texture, uint16_t side, uint16_t slots, Pixels format) {
  ChunkNeed need{};
  need.halo = texture.halo;
  need.status = texture.status == ok && slots == 0 ? too_little_memory : texture.status;
  if (need.status != ok) return need;
  const size_t lines = (static_cast<size_t>(side) + rows_a_line(format) - 1) / rows_a_line(format);
  size_t total = kSlack;
  need.working = texture.bytes;
  need.slot = sizeof(ChunkSlot) + 3;  // the pixels of every slot are aligned to four bytes
  const bool fits = base::add_bytes(need.pixels, lines, pixel_bytes(format, side)) &&
                    base::add_bytes(need.slot, 1, need.pixels) &&
                    base::add_bytes(total, slots, need.slot & ~size_t{3}) && base::add_bytes(total, 1, need.working);
  need.slot &= ~size_t{3};
  if (fits) need.bytes = total;
  else need.status = too_large;
  return need;
}

}  // namespace api

// What `slots` chunks of side x side cells need: constexpr where the recipe is. No slots: too_little_memory.
constexpr ChunkNeed chunk_need(const Recipe& recipe, uint16_t side, uint16_t slots, Pixels format, uint8_t bands = 1) {
  const Need texture = api::need_of_any(side, [&](const Domain& d) { return need_for(recipe, d, bands, api::kept_beside(side, slots)); });
  return api::need_of_slots(texture, side, slots, format);
}
constexpr ChunkNeed chunk_need(const Preset& preset, uint16_t side, uint16_t slots, Pixels format, uint8_t bands = 1) {
  return chunk_need(preset.recipe, side, slots, format, bands);
}

// Bytes of memory begin asks for; 0 for what it refuses.
constexpr size_t chunk_bytes(const Recipe& recipe, uint16_t side, uint16_t slots, Pixels format, uint8_t bands = 1) {
  return chunk_need(recipe, side, slots, format, bands).bytes;
}
constexpr size_t chunk_bytes(const Preset& preset, uint16_t side, uint16_t slots, Pixels format, uint8_t bands = 1) {
  return chunk_need(preset, side, slots, format, bands).bytes;
}

// A chunk that somebody else grows.
struct TakenChunk {
  int32_t x, y;
  uint8_t* pixels;
};

// The struct and the memory are the whole state; no destructor needed.
class Chunks {
 public:
  // Checks everything, then readies an empty cache. The recipe and the memory must outlive it. On an error the object
  // is as it was; `need`, if given, says what was wanted.
  Status begin(const Preset& preset, uint32_t seed, uint16_t side, uint16_t slots, const Brush& brush, void* memory,
               size_t bytes, const Options& options = Options{}, ChunkNeed* need = nullptr);
  Status begin(const Recipe& recipe, uint32_t seed, uint16_t side, uint16_t slots, const Brush& brush, void* memory,
               size_t bytes, const Options& options = Options{}, ChunkNeed* need = nullptr);
  Status begin(Recipe&& recipe, uint32_t seed, uint16_t side, uint16_t slots, const Brush& brush, void* memory,
               size_t bytes, const Options& options = Options{}, ChunkNeed* need = nullptr) = delete;  // would dangle

  // What is in sight: the cells (x, y) .. (x + width - 1, y + height - 1). A chunk that is at work and no longer in
  // sight is abandoned; what it had done is lost. bad_side: nothing to see; too_far: beyond where windows can be;
  // too_little_memory: more chunks in sight than there are slots. On an error the sight stays as it was.
  Status look_at(int32_t x, int32_t y, uint16_t width, uint16_t height);

  // Up to `rows` rows of work, grown or painted, on what is in sight and missing: more, or done when all of it is
  // there. A chunk once begun is finished while it stays in sight; then comes the one nearest to the middle of the
  // view, of equals the upper, then the left one. It takes an empty slot, or that of the chunk longest out of sight, of
  // equals the first slot; a chunk in sight never makes room.
  Status step(uint32_t rows);

  // Everything in sight.
  void finish() {
    while (step(UINT32_MAX) == more) {
    }
  }

  // For growing several chunks at a time (ports/desktop): `take` hands out the chunk that step would begin, which
  // counts as there from now on; false: nothing is missing, or step is in the midst of a chunk. `fill` grows and paints
  // it by a texture and working_bytes() of memory of the caller's; again: Options::again, of that memory. Calls of fill
  // may run at once, and beside take; all must be back before pixels are read, and before the next look_at.
  bool take(TakenChunk& taken);
  void fill(const TakenChunk& taken, Texture& texture, void* memory, evolve::Driver* driver, bool again) const;
  size_t working_bytes() const { return memory_bytes_; }

  // A finished chunk, in sight or not, or null. Valid until the next step.
  const uint8_t* pixels(int32_t cx, int32_t cy) const;
  // Bytes from a line of pixels to the next.
  size_t line_bytes() const { return pixel_bytes(brush_.format, side_); }

  const Sight& sight() const { return sight_; }
  uint32_t missing() const { return missing_; }  // chunks in sight that are not there
  uint16_t side() const { return side_; }
  uint16_t slots() const { return slots_; }
  const ChunkCounters& counters() const { return counters_; }

 private:
  enum class Work : uint8_t { none, growing, painting };

  Status start(const Preset* preset, const Recipe* recipe, uint32_t seed, uint16_t side, uint16_t slots,
               const Brush& brush, void* memory, size_t bytes, const Options& options, ChunkNeed* need);
  Status find_sight(int32_t x, int32_t y, uint16_t width, uint16_t height, Sight& sight) const;
  uint16_t find(int32_t cx, int32_t cy) const;
  uint16_t& bucket_of(int32_t cx, int32_t cy) const;
  uint8_t* pixels_of(uint16_t slot) const { return pixels_ + slot * pixel_step_; }
  uint64_t distance_of(int32_t cx, int32_t cy) const;
  void find_missing(int32_t& x, int32_t& y) const;
  void begin_texture(Texture& texture, int32_t cx, int32_t cy, uint8_t* memory, const Options& options) const;
  void open_nearest();
  uint16_t make_room();
  uint32_t grow_rows(uint32_t rows);
  void paint_row(Texture& texture, uint16_t y, uint8_t* pixels) const;
  uint32_t paint_rows(uint32_t rows);
  void list(uint16_t at_slot, int32_t cx, int32_t cy);

  Texture texture_;                 // at work
  const Preset* preset_ = nullptr;  // one of the two
  const Recipe* recipe_ = nullptr;
  api::ChunkSlot* slot_ = nullptr;
  uint8_t* pixels_ = nullptr;                // of slot 0
  uint8_t* memory_ = nullptr;                // of the texture
  size_t pixel_bytes_ = 0, pixel_step_ = 0;  // of a chunk, and from one to the next
  size_t memory_bytes_ = 0;
  Options options_;
  Brush brush_;
  uint32_t seed_ = 0, halo_ = 0;
  uint32_t now_ = 0;  // look_ats so far
  uint32_t missing_ = 0;
  ChunkCounters counters_ = {};
  Sight sight_ = {0, 0, -1, -1};
  int32_t middle_x_ = 0, middle_y_ = 0;  // of the view, half cells
  int32_t cx_ = 0, cy_ = 0;              // at work
  uint16_t side_ = kSmallestSide, slots_ = 0;
  uint16_t at_slot_ = 0, at_row_ = 0;  // painting
  Work work_ = Work::none;
};

}  // namespace dapple
