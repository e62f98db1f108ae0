// Deflate (RFC 1951) with the fixed code, in a zlib stream (RFC 1950): small, and good enough for pictures.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cli {

class Deflate {
 public:
  // Compressed bytes are appended to `out`; the caller may empty it between calls.
  explicit Deflate(std::vector<uint8_t>& out);
  void add(const uint8_t* bytes, size_t count);
  void finish();

 private:
  void bits(uint32_t value, int count);
  void code(uint32_t value, int count);
  void literal(uint32_t symbol);
  void match(uint32_t length, uint32_t distance);
  void encode(uint64_t keep);
  uint32_t longest(uint64_t candidate, uint32_t& distance) const;
  uint32_t length_at(uint64_t candidate, uint32_t most) const;
  uint32_t hash() const;
  void remember();

  static constexpr uint64_t kWindow = 32768, kRing = 2 * kWindow;
  std::vector<uint8_t>& out_;
  std::vector<uint8_t> ring_;              // byte i of the stream at i mod kRing
  std::vector<uint64_t> head_, previous_;  // last place + 1 of a hash; the one before a place, by place mod kWindow
  uint64_t at_ = 0, end_ = 0;              // bytes encoded, bytes added
  uint32_t held_ = 0;                      // bits not yet written
  int held_count_ = 0;
  uint32_t low_ = 1, high_ = 0;  // the two sums of Adler-32
};

}  // namespace cli
