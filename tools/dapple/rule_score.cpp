// How nice the state of a cell program looks, in integers.
// SPDX-License-Identifier: MIT
#include "rule_score.hpp"

#include <algorithm>

#include "grid/rows.hpp"

namespace cli {

using dapple::grid::get_bit;

// The fraction bit by bit: a mantissa in [1, 2), squared, has passed 2 where the next bit of its logarithm is set.
// Q31, so a square fits 64 bits.
uint32_t log2_q16(uint64_t n) {
  uint32_t log = 0;
  while (n >> log > 1) ++log;
  uint64_t mantissa = log > 31 ? n >> (log - 31) : n << (31 - log);
  for (int bit = 0; bit < 16; ++bit) {
    mantissa = mantissa * mantissa >> 31;
    const bool passed = mantissa >> 32 != 0;
    log = 2 * log + passed;
    if (passed) mantissa >>= 1;
  }
  return log;
}

// How often a cell is off and on, for each state of the six cells before it.
struct Counts {
  uint64_t of[64][2];
};

static Counts counts_of(const Torus& torus) {
  Counts counts{};
  const uint16_t width = torus.width(), height = torus.height();
  for (uint16_t y = 0; y < height; ++y) {
    const uint8_t* const here = torus.row(y);
    const uint8_t* const up = torus.row(static_cast<uint16_t>((y + height - 1u) % height));
    const uint8_t* const up2 = torus.row(static_cast<uint16_t>((y + height - 2u + height) % height));
    unsigned west = 2u * get_bit(here, (2 * width - 2) % width) + get_bit(here, width - 1);  // WW W
    unsigned north = 2u * get_bit(up, width - 1) + get_bit(up, 0);                           // NW N, then NE
    for (uint16_t x = 0; x < width; ++x) {
      north = (north << 1 | get_bit(up, x + 1 == width ? 0 : x + 1)) & 7;
      const unsigned self = get_bit(here, x);
      ++counts.of[north << 3 | west << 1 | static_cast<unsigned>(get_bit(up2, x))][self];
      west = (west << 1 | self) & 3;
    }
  }
  return counts;
}

// Bits to tell n cells from m others, Q16: (n + m) log2 (n + m) - n log2 n - m log2 m; at most 2^32 32 65536 < 2^54.
static uint64_t bits_of(uint64_t n, uint64_t m) {
  const auto part = [](uint64_t k) { return k == 0 ? 0 : k * log2_q16(k); };
  const uint64_t both = part(n + m), apart = part(n) + part(m);
  return both - std::min(both, apart);
}

static void measure_entropy(const Torus& torus, Score& s) {
  const Counts counts = counts_of(torus);
  uint64_t given = 0;
  for (const auto& n : counts.of) given += bits_of(n[0], n[1]);
  const uint64_t alone = bits_of(torus.count(), torus.cells() - torus.count());
  s.entropy = static_cast<int32_t>(given / torus.cells());
  s.disorder = alone < kOne ? 0 : static_cast<int32_t>(std::min<uint64_t>(given / (alone / kOne), kOne));
}

// (P(both on) - p p) / (p (1 - p)) over pairs across and down; products of counts fit 64 bits after a common shift.
static int32_t correlation_of(const Torus& torus) {
  uint64_t on = torus.count(), all = torus.cells(), pairs = 0;
  for (uint16_t y = 0; y < torus.height(); ++y) {
    const uint8_t* const here = torus.row(y);
    const uint8_t* const below = torus.row(static_cast<uint16_t>((y + 1u) % torus.height()));
    bool west = get_bit(here, torus.width() - 1);
    for (uint16_t x = 0; x < torus.width(); ++x) {
      const bool self = get_bit(here, x);
      pairs += static_cast<uint64_t>(self && west) + static_cast<uint64_t>(self && get_bit(below, x));
      west = self;
    }
  }
  for (; all >= UINT64_C(1) << 22; all >>= 1, on >>= 1, pairs >>= 1) {
  }
  const int64_t spread = static_cast<int64_t>(on * (all - on));
  const int64_t together = static_cast<int64_t>(pairs * all) - static_cast<int64_t>(2 * on * on);
  return spread == 0 ? 0 : static_cast<int32_t>(std::clamp<int64_t>(together * (kOne / 2) / spread, -kOne, kOne));
}

static int32_t ratio(uint64_t part, uint64_t all) { return static_cast<int32_t>(part * kOne / all); }

Score score_of(const Torus& torus, uint32_t program, const Settled& settled) {
  Torus next = torus;
  next.step(program);
  Score s{};
  s.density = ratio(torus.count(), torus.cells());
  measure_entropy(torus, s);
  s.correlation = correlation_of(torus);
  s.activity = ratio(next.count_different(torus), torus.cells());
  s.settled = settled;
  const int32_t best = kOne * 35 / 100, off = s.entropy > best ? s.entropy - best : best - s.entropy;
  s.total = kOne - static_cast<int32_t>(int64_t{off} * kOne / best) + std::max(s.correlation, 0) * 4 / 5;
  if (settled.kind != Settled::no) s.total += kOne * 2 / 5;
  if (s.activity < kOne / 10) s.total += kOne * 3 / 10;
  s.nice = s.density >= kOne / 20 && s.density <= kOne - kOne / 20 && s.entropy > kOne * 8 / 100 &&
           s.entropy < kOne * 60 / 100 && s.disorder <= kOne * 58 / 100;
  return s;
}

std::string decimal(int32_t q16) {
  const int64_t value = q16 < 0 ? -int64_t{q16} : q16, thousandths = (value * 1000 + kOne / 2) / kOne;
  return (q16 < 0 && thousandths > 0 ? "-" : "") + std::to_string(thousandths / 1000) + "." +
         std::to_string(1000 + thousandths % 1000).substr(1);
}

}  // namespace cli
