// What ends a command early.
// SPDX-License-Identifier: MIT
#include "errors.hpp"

namespace cli {

void fail(const std::string& text) { throw Failure{kFailed, text}; }
void refuse(const std::string& text) { throw Failure{kUsage, text}; }

std::string shown(std::string_view text) {
  constexpr size_t kLongest = 80;
  std::string result = "'";
  for (const char c : text.substr(0, kLongest)) result += static_cast<unsigned char>(c) < 32 || c == 127 ? '?' : c;
  return result + (text.size() > kLongest ? "...'" : "'");
}

std::string listed(const std::vector<std::string>& words) {
  std::string result;
  for (const std::string& word : words) result += (result.empty() ? "" : ", ") + word;
  return result;
}

}  // namespace cli
