// Files as a whole.
// SPDX-License-Identifier: MIT
#include "input.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "errors.hpp"

namespace cli {

std::string read_file(const std::string& path) {
  std::FILE* const file = std::fopen(path.c_str(), "rb");
  if (file == nullptr) fail("cannot read " + shown(path) + ": " + std::strerror(errno));
  std::string text;
  char part[4096];
  for (size_t count; (count = std::fread(part, 1, sizeof part, file)) > 0;) text.append(part, count);
  const int error = std::ferror(file) != 0 ? errno : 0;
  std::fclose(file);
  if (error != 0) fail("cannot read " + shown(path) + ": " + std::strerror(error));
  return text;
}

}  // namespace cli
