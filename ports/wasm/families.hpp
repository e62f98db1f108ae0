// The families of the module: all of them, without the solvers that work on pictures and surfaces of a program's, and without
// the sentences about their numbers, which texts.cpp puts beside the presets.
// SPDX-License-Identifier: MIT
#pragma once
#include "recipe/text.hpp"

namespace dapple::offered {

using recipe::Family;

constexpr uint8_t kCount = recipe::kFamilies.count;

constexpr uint16_t numbers_before(uint8_t family) {
  uint16_t sum = 0;
  for (uint8_t i = 0; i < family; ++i) sum = static_cast<uint16_t>(sum + recipe::families[i].number_count);
  return sum;
}

struct Numbers {
  Number all[numbers_before(kCount)];
};
constexpr Numbers mute() {
  Numbers numbers{};
  for (uint8_t i = 0; i < kCount; ++i)
    for (uint8_t k = 0; k < recipe::families[i].number_count; ++k) {
      Number& number = numbers.all[numbers_before(i) + k];
      number = recipe::families[i].numbers[k];
      number.unit = nullptr;
    }
  return numbers;
}
inline constexpr Numbers kNumbers = mute();

constexpr Family with_two_solvers(Family family, const char* names) {
  family.solver_names = names;
  family.solvers[2] = family.solvers[3] = nullptr;
  return family;
}

struct All {
  Family family[kCount];
};
constexpr All offer() {
  All all{};
  for (uint8_t i = 0; i < kCount; ++i) {
    const Family& family = recipe::families[i];
    all.family[i] = family.model == &mapped_model   ? with_two_solvers(family, "flux|lean")
                    : family.model == &turing_model ? with_two_solvers(family, "plain|cascade")
                                                    : family;
    all.family[i].numbers = kNumbers.all + numbers_before(i);
  }
  return all;
}
inline constexpr All kAll = offer();
inline constexpr recipe::Families kFamilies = {kAll.family, kCount};

}  // namespace dapple::offered
