// Patches: rectangles of cells with sides that are joined to each other, closed, or held at fixed values [Witkin & Kass
// 1991, 4.1 and 6.5]. A patch is grown with a ring of ghost cells around it; where a ghost cell's value comes from is
// said here.
// SPDX-License-Identifier: MIT
#pragma once
#include "../base/fixed.hpp"

namespace dapple::grid {
struct PatchWork;
extern const PatchWork patch_work;
}  // namespace dapple::grid

namespace dapple {

constexpr uint8_t kSides = 4;

// What lies beyond a side. Places along left and right go down, along top and bottom to the right.
struct Side {
  enum Name : uint8_t { left, right, top, bottom };
  enum Kind : uint8_t {
    joined,  // side `side` of patch `patch`; place t meets place t of it, or, reversed, the one as far from its other
             // end
    closed,  // nothing, and nothing goes there: the patch is mirrored (zero flux)
    fixed,   // value[0] in even planes (activators), value[1] in odd ones (inhibitors), in 1/kMicro of the model's 1.0
  } kind;
  uint8_t patch, side;
  bool reversed;
  int32_t value[2];
};

// A patch. (x, y): the cell of the plane whose noise, seeds and grain it has at its cell (0, 0).
struct Patch {
  int32_t x, y;
  Side side[kSides];
};

// All patches have the same size. List and patches must outlive the textures grown on them.
struct Patches {
  const Patch* patch;
  uint8_t count;  // 1..kMostPatches
  uint16_t width, height;
  const grid::PatchWork* work = &grid::patch_work;  // what copies ghost cells: programs without patches link none of it
};
constexpr uint8_t kMostPatches = 64;

constexpr Side closed_side() { return {Side::closed, 0, 0, false, {0, 0}}; }
constexpr Side fixed_side(int32_t activator, int32_t inhibitor) {
  return {Side::fixed, 0, 0, false, {activator, inhibitor}};
}
constexpr Side joined_side(uint8_t patch, uint8_t side, bool reversed = false) {
  return {Side::joined, patch, side, reversed, {0, 0}};
}

// Of a patch alone: joined to the opposite one.
constexpr Side repeating_side(uint8_t side) { return joined_side(0, static_cast<uint8_t>(side ^ 1)); }

// A side that is not what the side it names says, or names none, or one of another length; or fixed values that are not
// 0..1.
struct Unpaired {
  bool found;
  uint8_t patch, side;
};

constexpr bool is_paired(const Patches& all, uint8_t patch, uint8_t side) {
  const Side& s = all.patch[patch].side[side];
  if (s.kind == Side::fixed)
    return s.value[0] >= 0 && s.value[0] <= base::kMicro && s.value[1] >= 0 && s.value[1] <= base::kMicro;
  if (s.kind != Side::joined) return s.kind == Side::closed;
  if (s.patch >= all.count || s.side >= kSides) return false;
  const Side& other = all.patch[s.patch].side[s.side];
  if ((side < Side::top) != (s.side < Side::top) && all.width != all.height) return false;
  return other.kind == Side::joined && other.patch == patch && other.side == side && other.reversed == s.reversed;
}

// The first one, patch by patch.
constexpr Unpaired first_unpaired(const Patches& all) {
  for (uint8_t i = 0; i < all.count; ++i)
    for (uint8_t k = 0; k < kSides; ++k)
      if (!is_paired(all, i, k)) return {true, i, k};
  return {false, 0, 0};
}

}  // namespace dapple

namespace dapple::evolve {
struct Run;
}
namespace dapple::stencil {
struct DirectionMap;
}

namespace dapple::grid {

// Where a cell of a patch or of its ring lies. Axes may be exchanged or mirrored there: a tensor's xx and yy change
// places where `swapped`, xy its sign where `mirrored`.
struct Source {
  uint8_t patch;
  int32_t x, y;
  bool swapped, mirrored;
  const Side* fixed;  // a value instead of a cell; null: a cell
};

// (x, y) against cell (0, 0) of the patch, at most a patch's size beyond its sides; sizes of this grid. Corners of the
// ring go across left and right first.
Source source_of(const Patches& all, uint8_t level, uint8_t patch, int32_t x, int32_t y);

// What sweeps do on patches and nowhere else.
struct PatchWork {
  void (*seal_row)(evolve::Run& run);                                                                     // ghosts.hpp
  void (*map_row)(const stencil::DirectionMap& map, uint8_t index, int32_t y, uint16_t n, int16_t* out);  // maps.hpp
  Source (*source_of)(const Patches& all, uint8_t level, uint8_t patch, int32_t x, int32_t y);
};

}  // namespace dapple::grid
