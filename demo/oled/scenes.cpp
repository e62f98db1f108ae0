// The scenes of the show. See scenes.hpp.
// SPDX-License-Identifier: MIT
#include "scenes.hpp"

namespace oled {

using dapple::chunk_at;

constexpr uint32_t kSeed = 1337;
constexpr uint32_t kSlice = 240;             // rows of work on the plane in a frame
constexpr uint16_t kGrowing = 75;            // frames a tile grows
constexpr int32_t kLeft = -100, kTop = -40;  // where the camera begins; its way leads over the origin

// Two columns to the right for every row down.
static int32_t across(uint16_t moves) { return moves; }
static int32_t down(uint16_t moves) { return moves / 2; }

dapple::Status Show::begin(uint8_t scene, uint8_t* memory) {
  scene_ = scene;
  moves_ = 0;
  grown_ = false;
  pixels_ = memory;
  const dapple::Recipe& tile = scene == 1 ? kScales : kBasket;
  if (scene > 0) return tile_.begin(tile, kTile, kSeed, memory + kTilePixels, kBytes - kTilePixels);
  dapple::Brush brush;
  brush.format = dapple::Pixels::l8;
  return world_.begin(kPlane, kSeed, kSide, kSlots, brush, memory, kBytes);
}

void Show::advance() {
  if (scene_ == 0) fly();
  else if (grown_) ++moves_;
  else grow();
}

// The camera waits where the plane is not there yet. Its way is short, so look_at refuses nothing.
void Show::fly() {
  const uint16_t next = static_cast<uint16_t>(moves_ + 1);
  if (all_there(kLeft + across(next), kTop + down(next))) moves_ = next;
  world_.look_at(kLeft + across(moves_), kTop + down(moves_), kWidth + kAhead, kHeight + kAhead);
  world_.step(kSlice);
}

void Show::grow() {
  grown_ = tile_.step(static_cast<uint32_t>(tile_.rows_in_all() / kGrowing) + 1) == dapple::done;
  for (uint16_t y = 0; y < kTile.height; ++y) tile_.paint(y, dapple::Pixels::l8, pixels_ + y * kTile.width);
}

// The chunks that the panel shows of a camera at (x, y).
bool Show::all_there(int32_t x, int32_t y) const {
  for (int32_t cy = chunk_at(y, kSide); cy <= chunk_at(y + kHeight - 1, kSide); ++cy)
    for (int32_t cx = chunk_at(x, kSide); cx <= chunk_at(x + kWidth - 1, kSide); ++cx)
      if (world_.pixels(cx, cy) == nullptr) return false;
  return true;
}

void Show::line_of_plane(int32_t y, uint8_t* grey) const {
  const int32_t cy = chunk_at(y, kSide);
  int32_t x = kLeft + across(moves_);
  for (uint16_t i = 0; i < kWidth;) {
    const int32_t cx = chunk_at(x, kSide), end = (cx + 1) * kSide;
    const uint8_t* const chunk = world_.pixels(cx, cy);
    for (; i < kWidth && x < end; ++i, ++x)
      grey[i] = chunk == nullptr ? 0 : chunk[(y - cy * kSide) * kSide + x - cx * kSide];
  }
}

// Eight bits to four, rounded: grey n of the panel is 17 n. Dither would be seen as grain.
static void pack(const uint8_t* grey, uint8_t* out) {
  for (uint16_t i = 0; i < kLineBytes; ++i, grey += 2)
    out[i] = static_cast<uint8_t>((grey[0] + 8) / 17 * 16 + (grey[1] + 8) / 17);
}

void Show::line(uint16_t y, uint8_t* out) const {
  uint8_t grey[kWidth];
  const uint8_t* const row = pixels_ + (y + down(moves_)) % kTile.height * kTile.width;
  if (scene_ == 0) line_of_plane(kTop + down(moves_) + y, grey);
  else
    for (uint16_t i = 0; i < kWidth; ++i) grey[i] = row[(i + across(moves_)) % kTile.width];
  pack(grey, out);
}

}  // namespace oled
