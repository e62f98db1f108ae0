// What tests of explicit kinetics share.
// SPDX-License-Identifier: MIT
#pragma once
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "grow.hpp"

namespace tests {

inline std::vector<int16_t> field_of(const std::string& text, dapple::Domain domain, uint32_t budget = UINT32_MAX,
                                     uint8_t bands = 1) {
  dapple::Options options;
  options.bands = bands;
  Grown grown(recipe_of(text.c_str()), domain, 5, budget, options);
  REQUIRE_MESSAGE(grown.status == dapple::ok, text);
  return grown.field();
}

}  // namespace tests
