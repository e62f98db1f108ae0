// Direction maps [Witkin & Kass 1991, 3.1]: the doubled direction (cos 2 theta, sin 2 theta) of every cell in Q7, a
// vector of length 127; a shorter one is a place that is more isotropic. All but the swirls have the tile as their
// period; on the endless plane that is a square of kPlanePeriod cells.
// SPDX-License-Identifier: MIT
#pragma once
#include "steer.hpp"
#include "surface.hpp"

namespace dapple {

namespace stencil {
struct ImageWork;
struct StyleWork;
struct GreyWork;
extern const ImageWork image_work;
extern const StyleWork style_work;
extern const GreyWork grey_work;
}  // namespace stencil

// Directions from the caller, stretched over the tile: row by row pairs (127 cos 2 theta, 127 sin 2 theta), theta from
// x towards y (down) along the stripes. Shorter vectors are more isotropic, longer ones count as 127. Cells between the
// image's are interpolated, direction and length apart. Image and struct must outlive the texture.
struct DirectionImage {
  const int8_t* pairs;
  uint16_t width, height;  // 1..kMostImage
  const stencil::ImageWork* work = &stencil::image_work;  // below: programs without pictures link none of it
};
constexpr int32_t kMostImage = 256;

// Styles from the caller, stretched over the tile and interpolated: row by row three bytes, as shares of the recipe's
// numbers.
//   wavelength  255: the recipe's; 64 and less: a quarter
//   rho         128: the recipe's; .001 k/b for every unit more or less
//   k           255: the recipe's; 0: none
struct StyleImage {
  const uint8_t* cells;
  uint16_t width, height;  // 1..kMostImage
  const stencil::StyleWork* work = &stencil::style_work;
};

// A grey picture from the caller, stretched over the tile and interpolated: a byte a cell, row by row.
struct GreyImage {
  const uint8_t* cells;
  uint16_t width, height;  // 1..kMostImage
  const stencil::GreyWork* work = &stencil::grey_work;
};

// What a stage finds in Stage::stored. Of the mapped family: directions for map=image, styles for solver=styled, a measured
// surface for solver=surface. Of kinetics: directions, the picture of solver=pictured, and that of grade=image.
struct PlaceMaps {
  DirectionImage direction;
  StyleImage style;
  const Surface* surface = nullptr;
  GreyImage grey = {nullptr, 0, 0};
  GreyImage lengths = {nullptr, 0, 0};
};

}  // namespace dapple

namespace dapple::stencil {

constexpr uint16_t kPlanePeriod = 256;  // cells of the finest grid
constexpr uint8_t kMostMaps = 2;

// The numbers of a map, from which a row is made.
struct DirectionMap {
  enum Kind : uint8_t { none, radial, scallop, haunch, two_angle, swirl, corners, image } kind;
  uint16_t width, height;                    // cells of the period
  uint16_t rows;                             // of the grid
  int32_t x, y;                              // the world's cell at (0, 0) of the grid
  int32_t core;                              // radial: (r0 / 2)^2, Q20
  uint16_t across, down;                     // scallop: discs, rows of them (even)
  int16_t c2, s2;                            // corners: the doubled direction of colour 1, that of colour 0 is (c2, -s2); Q12
  DirectionField field;                      // swirl
  uint8_t images[sizeof(const PlaceMaps*)];  // where the caller's are; tables are aligned to four bytes only
  uint8_t patches[sizeof(const Patches*)];   // where the patches are; null: a torus or window
  uint8_t patch, level;                      // of them
  uint16_t pad;                              // ghost cells around a patch
};

inline void set_images(DirectionMap& map, const void* images) { base::copy_bytes(map.images, &images, sizeof images); }
inline void set_patches(DirectionMap& map, const Patches* patches) {
  base::copy_bytes(map.patches, &patches, sizeof patches);
}
inline const Patches* patches_of(const DirectionMap& map) {
  const Patches* patches = nullptr;
  base::copy_bytes(&patches, map.patches, sizeof patches);
  return patches;
}
inline const PlaceMaps& images_of(const DirectionMap& map) {
  const void* images = nullptr;
  base::copy_bytes(&images, map.images, sizeof images);
  return *static_cast<const PlaceMaps*>(images);
}

// A cell of a map in one int16: cos in the low byte, sin in the high one.
constexpr int16_t packed(Doubled d) {
  return static_cast<int16_t>((static_cast<uint16_t>(d.s2) << 8) | static_cast<uint8_t>(d.c2));
}

// Row y (any, taken modulo the grid) of map `index`: n cells.
//   radial     g = (sin 2 pi (u - 1/2), sin 2 pi (v - 1/2)), along g, length g^2 / (g^2 + (r0/2)^2): sources at centre and
//              corner
//   scallop    discs of .6 widths, the lower ones on top, along their circles
//   haunch     three directions 60 degrees apart, weights ((1 + cos) / 2)^8 of u + .1 sin 2 pi v less their third: chevrons
//   two_angle  theta1 = pi sin 2 pi u sin 2 pi v + .4 sin 2 pi (u + v),
//              theta2 = pi/2 + .9 sin 2 pi (2 u - v) + .9 cos 2 pi (u + 2 v)
//   corners    from the four colours around a place of a tile of corner tiles, four of which are the period: directions +-
//              theta, doubled vectors blended with weights 3 t^2 - 2 t^3, whose slope at an edge is 0
// u, v are the cell's centre in periods.
void map_row(const DirectionMap& map, uint8_t index, int32_t y, uint16_t n, int16_t* out);

// The same of a patch: ghost cells have what their sources have, turned.
void patch_row(const DirectionMap& map, uint8_t index, int32_t y, uint16_t n, int16_t* out);

// The one or the other.
inline void place_row(const DirectionMap& map, uint8_t index, int32_t y, uint16_t n, int16_t* out) {
  const Patches* const all = patches_of(map);
  (all == nullptr ? map_row : all->work->map_row)(map, index, y, n, out);
}

// V of the surface (surface.hpp): a row each of p, q, r.
constexpr uint8_t kInverseRows = 3;
void inverse_row(const DirectionMap& map, int32_t y, uint16_t n, int16_t* const* out);

// The same of the styles: what the square of the wavelength's share lacks of 1, Q15 (0 for a share of 255, 30720 for
// 64); rho's steps from -128 in the high byte, k's share in the low one.
constexpr uint8_t kStyleRows = 2;
void style_row(const DirectionMap& map, int32_t y, uint16_t n, int16_t* lack, int16_t* rho_k);

// What wavelengths are from place to place: `finest` of the recipe's (Q12, 1024..4096) where the grade is 0, the recipe's
// where it is 1, and between them in proportion.
//   across  (1 + cos 2 pi u) / 2      down  (1 + cos 2 pi v) / 2      centre  the mean of both
//   image   the picture `lengths`, black 0, white 1
struct Grade {
  enum Kind : uint8_t { across, down, centre, image } kind;
  int32_t finest;
};
// Row y of n squares of shares, Q9: 32..512.
void grade_row(const DirectionMap& map, Grade grade, int32_t y, uint16_t n, int16_t* out);

// What maps do with a picture of directions and nowhere else: a row of it, its world row folded.
struct ImageWork {
  void (*row)(const DirectionMap& map, uint16_t row, uint16_t n, int16_t* out);
};

// The same for grey pictures: the grey of a place of the map's period, Q8, 0..65280.
struct GreyWork {
  int32_t (*at)(const GreyImage& image, const DirectionMap& map, uint16_t x, uint16_t y);
};

// A row of n cells of a grey picture, Q8: 0..65280. (x, y): the world's first cell, any; width, height: of the period.
void grey_row(const GreyImage& image, int32_t x, int32_t y, uint16_t width, uint16_t height, uint16_t n, int32_t* out);

}  // namespace dapple::stencil
