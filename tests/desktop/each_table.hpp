// What tests of ports/desktop do by every table.
// SPDX-License-Identifier: MIT
#pragma once
#include <doctest/doctest.h>

#include <string>

#include "tables.hpp"

namespace tests {

// Calls back for every table that this processor can run, from table `first` on; the portable one is 0.
template <class Work>
void each_table(const Work& work, uint8_t first = 0) {
  for (uint8_t i = first; i < dapple::desktop::table_count(); ++i) {
    const dapple::desktop::Table& table = dapple::desktop::table_at(i);
    INFO("table " << std::string(table.name));
    if (table.runs()) work(table);
    else MESSAGE("this processor cannot run " << std::string(table.name));
  }
}

}  // namespace tests
