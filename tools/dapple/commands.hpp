// The commands. Each prints or writes what it is for, or throws Failure.
// SPDX-License-Identifier: MIT
#pragma once
#include "options.hpp"

namespace cli {

void list(const Options& options);
void grow(const Options& options);
void info(const Options& options);
void sheet(const Options& options);
void rule(const Options& options);
void stream(const Options& options);
void surface(const Options& options);
void tiles(const Options& options);
void bench(const Options& options);

// Text as a JSON string.
std::string json_text(const std::string& text);

// What help says of rule, beside its options.
std::string rule_help();
// And of surface.
std::string surface_help();

std::string version_text();

}  // namespace cli
