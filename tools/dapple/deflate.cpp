// Deflate with the fixed code. Matches are looked for along chains of places with the same three bytes.
// SPDX-License-Identifier: MIT
#include "deflate.hpp"

#include <algorithm>

namespace cli {

constexpr uint32_t kShortest = 3, kLongest = 258;
constexpr uint64_t kFar = 4096;  // beyond it three bytes cost more as a match
constexpr int kTries = 48;
constexpr int kHashBits = 15;

Deflate::Deflate(std::vector<uint8_t>& out)
    : out_(out), ring_(kRing), head_(size_t{1} << kHashBits), previous_(kWindow) {
  out_.push_back(0x78);  // zlib: deflate, window of 32 KB
  out_.push_back(0x01);
  bits(1, 1);  // the last block, and the only one
  bits(1, 2);  // with the fixed code
}

// Lowest bit first.
void Deflate::bits(uint32_t value, int count) {
  held_ |= value << held_count_;
  for (held_count_ += count; held_count_ >= 8; held_count_ -= 8) {
    out_.push_back(static_cast<uint8_t>(held_));
    held_ >>= 8;
  }
}

// A Huffman code: highest bit first.
void Deflate::code(uint32_t value, int count) {
  while (count > 0) bits(value >> --count & 1, 1);
}

// RFC 1951, 3.2.6: the fixed code of literals and lengths.
void Deflate::literal(uint32_t symbol) {
  if (symbol < 144) return code(0x30 + symbol, 8);
  if (symbol < 256) return code(0x190 + symbol - 144, 9);
  if (symbol < 280) return code(symbol - 256, 7);
  code(0xc0 + symbol - 280, 8);
}

static int highest_bit(uint32_t value) {
  int bit = 0;
  while (value >>= 1) ++bit;
  return bit;
}

// RFC 1951, 3.2.5: after the first few, codes come in fours (lengths) or twos (distances) of one more extra bit.
void Deflate::match(uint32_t length, uint32_t distance) {
  const uint32_t l = length - kShortest, d = distance - 1;
  if (length == kLongest) {
    literal(285);
  } else {
    const int extra = l < 8 ? 0 : highest_bit(l) - 2;
    literal(l < 8 ? 257 + l : 261 + 4 * static_cast<uint32_t>(extra) + (l >> extra & 3));
    bits(l & ((1u << extra) - 1), extra);
  }
  const int extra = d < 4 ? 0 : highest_bit(d) - 1;
  code(d < 4 ? d : 2 + 2 * static_cast<uint32_t>(extra) + (d >> extra & 1), 5);
  bits(d & ((1u << extra) - 1), extra);
}

uint32_t Deflate::hash() const {
  const uint32_t three = ring_[at_ % kRing] | ring_[(at_ + 1) % kRing] << 8 | ring_[(at_ + 2) % kRing] << 16;
  return three * 2654435761u >> (32 - kHashBits);
}

// Enters the place at_ into its chain.
void Deflate::remember() {
  if (end_ - at_ < kShortest) return;
  uint64_t& head = head_[hash()];
  previous_[at_ % kWindow] = head;
  head = at_ + 1;
}

uint32_t Deflate::length_at(uint64_t candidate, uint32_t most) const {
  uint32_t length = 0;
  while (length < most && ring_[(candidate + length) % kRing] == ring_[(at_ + length) % kRing]) ++length;
  return length;
}

// The longest match at at_ along the chain that begins with `candidate` (a place + 1, 0 for none); 0 when there is
// none.
uint32_t Deflate::longest(uint64_t candidate, uint32_t& distance) const {
  const uint32_t most = static_cast<uint32_t>(std::min<uint64_t>(kLongest, end_ - at_));
  uint32_t best = 0;
  for (int i = 0; i < kTries && candidate != 0 && at_ - (candidate - 1) < kWindow && best < most; ++i) {
    const uint64_t place = candidate - 1;
    const uint32_t length = length_at(place, most);
    const bool pays = length > kShortest || (length == kShortest && at_ - place <= kFar);
    if (length > best && pays) {
      best = length;
      distance = static_cast<uint32_t>(at_ - place);
    }
    candidate = previous_[place % kWindow];
  }
  return best;
}

// Encodes until only `keep` bytes are left to look ahead.
void Deflate::encode(uint64_t keep) {
  while (end_ - at_ > keep) {
    uint32_t distance = 0, length = 0;
    if (end_ - at_ >= kShortest) length = longest(head_[hash()], distance);
    if (length == 0) literal(ring_[at_ % kRing]);
    else match(length, distance);
    for (uint32_t i = std::max(length, 1u); i > 0; --i) {
      remember();
      ++at_;
    }
  }
}

void Deflate::add(const uint8_t* bytes, size_t count) {
  for (size_t i = 0; i < count; ++i) {
    low_ = (low_ + bytes[i]) % 65521;
    high_ = (high_ + low_) % 65521;
    if (end_ - at_ == kWindow) encode(kLongest);
    ring_[end_++ % kRing] = bytes[i];
  }
}

void Deflate::finish() {
  encode(0);
  literal(256);  // end of the block
  if (held_count_ > 0) bits(0, 8 - held_count_);
  for (const uint32_t sum : {high_, low_}) {
    out_.push_back(static_cast<uint8_t>(sum >> 8));
    out_.push_back(static_cast<uint8_t>(sum));
  }
}

}  // namespace cli
