// What the two files of the command rule share.
// SPDX-License-Identifier: MIT
#pragma once
#include "recipes.hpp"

namespace cli {

// The cell program as a recipe, with the changes of the command line; its name is that of its files.
Subject rule_subject(const Options& options, uint32_t program);

// dapple rule random.
void random_rules(const Options& options);

}  // namespace cli
