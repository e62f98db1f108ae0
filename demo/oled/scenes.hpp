// The show on a small panel: three scenes of 128 x 64 pixels in 16 greys, frame by frame. No hardware here: board and
// desktop run the same file, and a frame depends on nothing but its number.
//
//   0  the endless plane passes under a camera, grown in chunks, a slice a frame
//   1  a tile of int16 concentrations grows before the eyes, then drifts, repeated without a seam
//   2  the same with a tile of one bit a cell
// SPDX-License-Identifier: MIT
#pragma once
#include "chunks.hpp"

namespace oled {

constexpr uint16_t kWidth = 128, kHeight = 64;
constexpr uint16_t kLineBytes = kWidth / 2;  // two pixels a byte, the left one in the high nibble
constexpr uint8_t kScenes = 3;

// A preset in the panel's colours. The ramp ends short of white: the rest is for the light.
constexpr dapple::Recipe in_greys(const dapple::Preset& preset) {
  dapple::Recipe recipe = preset.recipe;
  recipe.paint.ramp = dapple::Ramp{2, {{0, 0, 0, 0}, {255, 208, 208, 208}}};
  return recipe;
}

// The plane. What is looked at reaches further than the panel, right and down, so that what comes into view is there.
inline constexpr dapple::Recipe kPlane = in_greys(dapple::presets::labyrinth_bits);
constexpr uint16_t kSide = 32, kAhead = 32;
constexpr uint32_t kSlots = dapple::chunks_in_view(kSide, kWidth + kAhead, kHeight + kAhead);
constexpr size_t kPlaneBytes = dapple::chunk_bytes(kPlane, kSide, kSlots, dapple::Pixels::l8);

// The tiles, each with the memory of the texture behind its pixels.
inline constexpr dapple::Recipe kScales = in_greys(dapple::presets::reptile);
inline constexpr dapple::Recipe kBasket = in_greys(dapple::presets::weave_bits);
constexpr dapple::Domain kTile = dapple::torus(64, 64);
constexpr size_t kTilePixels = size_t{kTile.width} * kTile.height;
constexpr size_t kScalesBytes = dapple::bytes_for(kScales, kTile), kBasketBytes = dapple::bytes_for(kBasket, kTile);
static_assert(kPlaneBytes > 0 && kScalesBytes > 0 && kBasketBytes > 0, "a scene is refused");

// What begin asks for: the scenes use the same memory, one after another.
constexpr size_t larger(size_t a, size_t b) { return a > b ? a : b; }
constexpr size_t kBytes = larger(kPlaneBytes, kTilePixels + larger(kScalesBytes, kBasketBytes));

class Show {
 public:
  // Readies a scene, 0 .. kScenes - 1. memory: kBytes of any alignment, to outlive the scene.
  dapple::Status begin(uint8_t scene, uint8_t* memory);
  uint16_t frames() const { return scene_ == 0 ? 500 : 325; }
  uint16_t still() const { return scene_ == 0 ? 200 : 150; }  // frames until the one that stands for the scene

  // Works for one frame.
  void advance();

  // Row y of the frame: kLineBytes bytes. What is not there yet is black.
  void line(uint16_t y, uint8_t* out) const;

 private:
  void fly();
  void grow();
  bool all_there(int32_t x, int32_t y) const;
  void line_of_plane(int32_t y, uint8_t* grey) const;

  dapple::Chunks world_;
  dapple::Texture tile_;
  uint8_t* pixels_ = nullptr;  // of the tile, a byte each
  uint16_t moves_ = 0;         // of the camera over the plane or the tile
  uint8_t scene_ = 0;
  bool grown_ = false;  // the tile is
};

}  // namespace oled
