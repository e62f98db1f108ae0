// What the files of the command rule share.
// SPDX-License-Identifier: MIT
#pragma once
#include "recipes.hpp"

namespace cli {

// The cell program as a recipe, with the changes of the command line; its name is that of its files.
Subject rule_subject(const Options& options, uint32_t program);

// What can be asked for. rule_grow: the command without a verb.
void rule_grow(const Subject& subject, Options options);
void rule_settle(const Subject& subject, const Options& options);
void rule_score(const Subject& subject, const Options& options);
void rule_complete(const Subject& subject, const Options& options);
void rule_random(const Options& options);

}  // namespace cli
