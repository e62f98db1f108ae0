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

// Every kind of kinetics, with a scale for two grids and a dt for the finer one.
struct Kind {
  std::string family, scale, dt;
};
inline std::vector<Kind> kinds() {
  return {{"turing", " scale=12", " dt=0.9"},
          {"meinhardt-spots", " scale=4", " dt=0.9"},
          {"meinhardt-stripes", " scale=1.4", " dt=0.9"},
          {"fitzhugh-nagumo", " scale=1.4", " dt=0.05"},
          {"schnakenberg", " scale=12", " dt=0.9"},
          {"brusselator", " scale=1.4", " dt=0.05"},
          {"turing cells=compact", " scale=12", " dt=0.9"},
          {"meinhardt-spots cells=compact", " scale=4", " dt=0.9"}};
}

// The same bits however the run of any kind is sliced and in however many bands, over two grids, with held cells; and
// others with another beginning. first, other: words of the coarse stage; finer, last: of the next and of the last one.
inline void check_slices(const std::string& first, const std::string& other, const std::string& finer,
                         const std::string& last) {
  const dapple::Domain domain = dapple::torus(74, 50);
  for (const Kind& kind : kinds()) {
    const auto text = [&](const std::string& words) {
      return kind.family + kind.scale + " vary=0.05 stretch=1.5 angle=20 level=1 steps=9 " + words +
             " then refine steps=5 " + finer + kind.dt +
             " then freeze reset=off above=0.4 held=apart steps=7 then carry steps=3 " + last;
    };
    INFO(text(first));
    const std::vector<int16_t> whole = field_of(text(first), domain);
    for (const uint32_t budget : {1u, 7u, 1000u}) CHECK(field_of(text(first), domain, budget) == whole);
    for (const uint8_t bands : {uint8_t{2}, uint8_t{3}, uint8_t{9}})
      CHECK(field_of(text(first), domain, 13, bands) == whole);
    CHECK(field_of(text(other), domain) != whole);
  }
}

}  // namespace tests
