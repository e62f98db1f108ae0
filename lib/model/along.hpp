// The numbers of kinetics that follow a map of directions: beside a model's own, in the last slots, of every such
// family the same. Their solver looks at them (evolve/along.hpp), so that models need not know them.
// SPDX-License-Identifier: MIT
#pragma once
#include "kinetics.hpp"
#include "mapped.hpp"

namespace dapple::along {

enum Slot : uint8_t { map = kMaxNumbers - 2, detail };

constexpr uint8_t kNumbers = 2;
inline constexpr Number numbers[kNumbers] = {
    {Number::word, "map", 0, mapped::kinds - 1, mapped::none, mapped::kMaps, nullptr},
    {Number::decimal, "detail", mapped::kDetail[0], mapped::kDetail[1], mapped::kDetailStandard, nullptr, nullptr},
};
// What they mean, apart: a program without it links none of it.
constexpr const char* units[kNumbers] = {
    "direction of every place of the tile, along which spots are stretched, angle= beside it; none: one for all",
    mapped::kDetailUnit};

constexpr bool in_range(const int32_t* number) {
  return within(number[map], 0, mapped::kinds - 1) && within(number[detail], mapped::kDetail[0], mapped::kDetail[1]);
}

}  // namespace dapple::along
