// What ends a command early: one line on stderr and an exit code.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace cli {

constexpr int kFailed = 1;  // the command line was right, the work did not succeed
constexpr int kUsage = 2;   // the command line was wrong

// Thrown; main prints it.
struct Failure {
  int code;
  std::string text;
};

[[noreturn]] void fail(const std::string& text);
[[noreturn]] void refuse(const std::string& text);

// The text in single quotes, fit for one line: control characters as '?', long texts cut.
std::string shown(std::string_view text);

// "a, b, c"
std::string listed(const std::vector<std::string>& words);

}  // namespace cli
