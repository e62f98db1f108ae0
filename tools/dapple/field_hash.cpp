// See field_hash.hpp.
// SPDX-License-Identifier: MIT
#include "field_hash.hpp"

#include <cinttypes>
#include <cstdio>
#include <vector>

#include "errors.hpp"
#include "output.hpp"

namespace cli {

void FieldHash::add(dapple::Texture& texture) {
  const dapple::Domain domain = texture.domain();
  std::vector<int16_t> row(domain.width);
  for (uint16_t y = 0; y < domain.height; ++y) {
    texture.row(y, row.data());
    for (const int32_t value : row)
      for (int shift = 0; shift < 32; shift += 8)
        value_ = (value_ ^ (static_cast<uint32_t>(value) >> shift & 255)) * UINT64_C(0x100000001b3);
  }
}

void FieldHash::print() const {
  std::printf("%016" PRIx64 "\n", value_);
  finish_standard_output();
}

}  // namespace cli
