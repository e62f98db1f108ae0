// Spots as they are asked for: how long they are for their width, how large, which share of the tile they cover. What
// follows from them: stretch, coverage, and as many steps as spots need to settle. Families with Dials have them.
//
//   aspect      length over width: the stretch; where the start is noise (other starts have an aspect of their own)
//   spot_size   cells: diameter of a disc as large as a spot. A spot has 2 / sqrt(3) wavelength^2 for itself, so that
//               coverage = pi sqrt(3) / 8 (spot_size / wavelength)^2; with coverage= it sets the wavelength
//   coverage    a number of all explicit kinetics: the share of cells that are on
// SPDX-License-Identifier: MIT
#pragma once
#include "levels.hpp"

namespace dapple::recipe {

constexpr int32_t kPacking = 680175;  // pi sqrt(3) / 8
constexpr int32_t kCoverage[2] = {10000, kinetics::coverage_number.high};  // that spot_size may ask for
constexpr int32_t kSpot[2] = {base::kMicro, 200 * base::kMicro};

// root(a / b), of numbers in 1/kMicro.
constexpr int32_t root_of(int32_t a, int32_t b) {
  const int64_t square = static_cast<int64_t>(a) * base::kMicro / b;
  return static_cast<int32_t>(base::square_root64(static_cast<uint64_t>(square) * base::kMicro));
}

constexpr bool dial_key(Reader& r, Word key, Word value, bool& found) {
  const bool aspect = equal(key, "aspect") && r.recipe->start.kind == Start::noise;
  found = r.family->dials.settled > 0 && (aspect || equal(key, "spot_size"));
  if (!found) return true;
  r.spot = aspect ? r.spot : value;
  if (!aspect) return decimal_in(r, value, kSpot[0], kSpot[1], r.spot_size);
  int32_t ratio = 0;
  if (!decimal_in(r, value, kinetics::kStretch[0], kinetics::kStretch[1], ratio)) return false;
  for (uint8_t s = r.stage; s < r.recipe->stages; ++s) r.recipe->stage[s].number[kinetics::stretch] = ratio;
  r.aspect_given = true;
  return true;
}

// Spots of a size that cover a share: the wavelength is theirs. All three exclude each other.
constexpr bool length_of_spots(Reader& r, Word all) {
  const int32_t share = r.recipe->stage[0].number[kinetics::coverage];
  if (r.spot_size == 0 || !r.coverage_given || share == 0) return true;
  if (r.wavelength != 0) return fail(r, not_possible, r.spot, 0, 0, false, "spot_size");
  const int64_t length = static_cast<int64_t>(r.spot_size) * root_of(kPacking, share) / base::kMicro;
  if (length > 500 * static_cast<int64_t>(base::kMicro)) return fail(r, out_of_range, all, base::kMicro, 500 * base::kMicro);
  r.wavelength = static_cast<int32_t>(length);
  return true;
}

// Where the wavelength is known: the share that spots of this size cover.
constexpr bool cover_spots(Reader& r, Stage& stage) {
  if (r.spot_size == 0) return true;
  const int64_t length = stage.model->wavelength(stage.number), size = r.spot_size;
  const int64_t share = size * size / length * kPacking / length;
  const auto size_of = [&](int32_t most) { return static_cast<int32_t>(length * root_of(most, kPacking) / base::kMicro); };
  if (share < kCoverage[0] || share > kCoverage[1])
    return fail(r, out_of_range, r.spot, size_of(kCoverage[0]), size_of(kCoverage[1]));
  if (!r.coverage_given) stage.number[kinetics::coverage] = static_cast<int32_t>(share);
  return true;
}

// Steps until spots stay, where none are asked for; and a range whose middle is the edge of what is on.
constexpr void settle_spots(Reader& r) {
  Recipe& recipe = *r.recipe;
  if (r.family->dials.settled == 0) return;
  Stage& stage = recipe.stage[0];
  const bool covers = (r.coverage_given || r.spot_size != 0) && stage.number[kinetics::coverage] > 0;
  const int64_t scale = stage.number[kinetics::scale];
  if ((covers || r.aspect_given) && !r.steps_given && recipe.stages == 1)
    stage.steps = static_cast<uint32_t>(scale * scale / base::kMicro * r.family->dials.settled / base::kMicro);
  if (!covers || r.range_given) return;
  const int32_t half = (recipe.paint.high - recipe.paint.low) / 2, middle = recipe.stage[recipe.stages - 1].number[kinetics::above];
  recipe.paint.low = middle - half;
  recipe.paint.high = middle + half;
}

}  // namespace dapple::recipe
