// The hash that --hash prints: FNV-1a, 64 bit, over fields as little-endian int32, row by row.
// SPDX-License-Identifier: MIT
#pragma once
#include "dapple.hpp"

namespace cli {

class FieldHash {
 public:
  void add(dapple::Texture& texture);
  void print() const;

 private:
  uint64_t value_ = UINT64_C(0xcbf29ce484222325);
};

}  // namespace cli
