// Patches grown together [Witkin & Kass 1991, 4.1]: textures whose sides are joined, so that nothing shows where they
// meet. A cube of six patches is a sphere; patches side by side are one large patch, bit for bit; any other atlas is a
// list of sides.
//
//   dapple::Patch six[6];
//   dapple::make_sphere(six, 96);
//   const dapple::Patches sphere = {six, 6, 96, 96};
//   dapple::Surface metric = dapple::sphere_surface(96);
//   while (measure(metric, 8) == dapple::more) {}
//   dapple::PlaceMaps maps = {}; maps.surface = &metric;
//   set_maps(recipe, maps);                                              // of a recipe with solver=surface
//   dapple::Texture face[6];
//   dapple::Atlas atlas;
//   const dapple::AtlasNeed need = dapple::atlas_need(recipe, sphere);   // memory: need.bytes
//   if (atlas.begin(recipe, sphere, seed, face, memory, need.bytes) != dapple::ok) fault();
//   while (atlas.step(64) == dapple::more) {}
//   face[2].paint(y, dapple::Pixels::rgb888, line);
//
// SPDX-License-Identifier: MIT
#pragma once
#include "dapple.hpp"

namespace dapple {

// What an atlas needs, and what is wrong if it cannot be.
struct AtlasNeed {
  Status status;      // ok, or why begin would refuse
  size_t bytes;       // of memory in all; 0 when status is not ok
  size_t block;       // of them for each patch
  Unpaired unpaired;  // bad_sides: the first side that does not pair up, if that is why
  Need patch;         // of one
};

constexpr AtlasNeed atlas_need(const Recipe& recipe, const Patches& patches, uint8_t bands = 1) {
  AtlasNeed need{};
  if (patches.patch != nullptr && patches.count <= kMostPatches) need.unpaired = first_unpaired(patches);
  for (uint8_t i = 0; i == 0 || (i < patches.count && need.patch.status == ok); ++i)
    need.patch = need_for(recipe, on_patch(patches, i), bands);
  need.status = need.patch.status;
  if (need.status != ok) return need;
  need.block = (need.patch.bytes + 3) & ~static_cast<size_t>(3);
  const bool fits = need.block <= evolve::kMostGhostBytes / patches.count &&
                    base::add_bytes(need.bytes, patches.count, need.block) && base::add_bytes(need.bytes, 1, 3);
  if (fits) return need;
  need.status = too_large;
  need.bytes = 0;
  return need;
}

// The struct, the textures and the memory are the whole state.
class Atlas {
 public:
  // Checks everything, then readies a texture for every patch. All that is handed over must outlive them. On an error
  // nothing has been touched.
  Status begin(const Recipe& recipe, const Patches& patches, uint32_t seed, Texture* textures, void* memory,
               size_t bytes, const Options& options = Options{}, AtlasNeed* need = nullptr);
  Status begin(const Recipe& recipe, Patches&& patches, uint32_t seed, Texture* textures, void* memory, size_t bytes,
               const Options& options = Options{}, AtlasNeed* need = nullptr) = delete;  // would dangle

  // Up to `rows` rows of work: more, or done. Between calls textures may be looked at, but not stepped.
  Status step(uint32_t rows);
  void finish() {
    while (step(UINT32_MAX) == more) {
    }
  }

  uint64_t rows_done() const;
  uint64_t rows_in_all() const;

 private:
  Texture* texture_;
  uint8_t count_, at_;  // the patch whose turn it is
  uint16_t part_;       // of all patches before it in this round
};

// --- A sphere: the faces of a cube. Four around the equator, each to the right of the one before, then the north and
// the south, above and below the first. A cell at (X, Y) = (tan a, tan b) of a face lies in the direction n + X u + Y
// v.
struct Face {
  int8_t n[3], u[3], v[3];
};
inline constexpr Face kFaces[6] = {
    {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}},  {{0, 1, 0}, {-1, 0, 0}, {0, 0, -1}}, {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
    {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}}, {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}},   {{0, 0, -1}, {0, 1, 0}, {-1, 0, 0}},
};

namespace api {

constexpr int32_t dot(const int8_t* a, const int8_t* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
constexpr int32_t outwards(uint8_t side) { return (side & 1) != 0 ? 1 : -1; }
constexpr const int8_t* across(const Face& f, uint8_t side) { return side < Side::top ? f.u : f.v; }
constexpr const int8_t* along(const Face& f, uint8_t side) { return side < Side::top ? f.v : f.u; }

// The face that lies beyond a side, and the side of it that has this face beyond it.
constexpr Side beyond(uint8_t face, uint8_t side) {
  const Face& f = kFaces[face];
  for (uint8_t i = 0; i < 6; ++i)
    for (uint8_t k = 0; k < kSides; ++k)
      if (dot(kFaces[i].n, across(f, side)) == outwards(side) && dot(f.n, across(kFaces[i], k)) == outwards(k))
        return joined_side(i, k, dot(along(f, side), along(kFaces[i], k)) < 0);
  return closed_side();
}

}  // namespace api

constexpr void make_sphere(Patch* six, uint16_t side) {
  for (uint8_t i = 0; i < 6; ++i) {
    six[i].x = static_cast<int32_t>(side) * i;
    six[i].y = 0;
    for (uint8_t k = 0; k < kSides; ++k) six[i].side[k] = api::beyond(i, k);
  }
}

}  // namespace dapple
