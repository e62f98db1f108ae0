// Files as a whole.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace cli {

// Fails where the file cannot be read.
std::string read_file(const std::string& path);

}  // namespace cli
