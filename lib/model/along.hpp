// The numbers of kinetics that differ from place to place, in direction and wavelength: beside a model's own, in the last
// slots, of every such family the same. Their solver looks at them (evolve/along.hpp), so that models need not know them.
// SPDX-License-Identifier: MIT
#pragma once
#include "kinetics.hpp"
#include "mapped.hpp"

namespace dapple::along {

enum Slot : uint8_t { map = kMaxNumbers - 4, detail, grade, finest };

constexpr uint8_t kNumbers = 4;
constexpr int32_t kFinest[2] = {250000, 1000000}, kFinestStandard = 500000;
enum Grade : uint8_t { none, across, down, centre, image, grades };
inline constexpr Number numbers[kNumbers] = {
    {Number::word, "map", 0, mapped::kinds - 1, mapped::none, mapped::kMaps, nullptr},
    {Number::decimal, "detail", mapped::kDetail[0], mapped::kDetail[1], mapped::kDetailStandard, nullptr, nullptr},
    {Number::word, "grade", 0, grades - 1, none, "none|across|down|centre|image", nullptr},
    {Number::decimal, "finest", kFinest[0], kFinest[1], kFinestStandard, nullptr, nullptr},
};
// What they mean, apart: a program without it links none of it.
constexpr const char* units[kNumbers] = {
    "direction of every place of the tile, along which spots are stretched, angle= beside it; none: one for all",
    mapped::kDetailUnit,
    "where the wavelength is shortest: in the middle, across or down the tile, at its centre, or where a picture is black; "
    "none: one for all",
    "of the wavelength, what it is there"};

constexpr bool in_range(const int32_t* number) {
  return within(number[map], 0, mapped::kinds - 1) && within(number[detail], mapped::kDetail[0], mapped::kDetail[1]) &&
         within(number[grade], 0, grades - 1) && within(number[finest], kFinest[0], kFinest[1]);
}

}  // namespace dapple::along
