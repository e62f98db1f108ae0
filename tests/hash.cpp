// Statistics of the counter hash, and bad generators that each of them rejects.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <vector>

#include "base/hash.hpp"

namespace {

using Generator = uint32_t (*)(uint32_t seed, uint32_t stream, int32_t x, int32_t y);

uint32_t library(uint32_t seed, uint32_t stream, int32_t x, int32_t y) {
  return dapple::base::hash(seed, stream, x, y);
}

// A linear congruence of x + y * prime: even buckets, but neighbours follow each other.
uint32_t linear(uint32_t seed, uint32_t stream, int32_t x, int32_t y) {
  const uint32_t at = static_cast<uint32_t>(x) + 7919 * static_cast<uint32_t>(y) + seed + 104729 * stream;
  return at * 1664525u + 1013904223u;
}
// A good mixer of a sum: streams and seeds, x and y are the same thing, so tiles repeat each other shifted.
uint32_t sums(uint32_t seed, uint32_t stream, int32_t x, int32_t y) {
  return dapple::base::mix(seed + stream + static_cast<uint32_t>(x) + static_cast<uint32_t>(y));
}
// One multiplication and one shift too few.
uint32_t one_round(uint32_t seed, uint32_t stream, int32_t x, int32_t y) {
  uint32_t h =
      static_cast<uint32_t>(x) * 0x9e3779b1u ^ static_cast<uint32_t>(y) * 0x85ebca6bu ^ (seed + stream) * 0xc2b2ae35u;
  h ^= h >> 16;
  return h * 0x7feb352du;
}
// One bit in 64 set a little too often.
uint32_t loaded(uint32_t seed, uint32_t stream, int32_t x, int32_t y) {
  const uint32_t h = dapple::base::hash(seed, stream, x, y);
  return h | (h << 26 == 0 ? 0x81000001u : 0);
}
// Sticks to its neighbour on the left one time in 64.
uint32_t sticky(uint32_t seed, uint32_t stream, int32_t x, int32_t y) {
  const uint32_t h = dapple::base::hash(seed, stream, x, y);
  return h << 26 == 0 ? dapple::base::hash(seed, stream, x - 1, y) : h;
}

// Every statistic is a largest absolute z-score (standard deviations) over all it looks at. The hash is deterministic,
// so a test passes for good or not at all; what matters is that the bound separates. The largest of n independent
// normal z-scores is about sqrt(2 ln n): 3.7 for 1000, 4.8 for 100000, and above 6 with a probability of n * 2e-9.
constexpr double kBound = 6;

constexpr int32_t kSide = 1024;
constexpr double kCount = double{kSide} * kSide;

template <class Do>
void each_cell(Do act) {
  for (int32_t y = 0; y < kSide; ++y)
    for (int32_t x = 0; x < kSide; ++x) act(x, y);
}

double larger(double a, double b) { return std::fabs(b) > a ? std::fabs(b) : a; }

// z of chi-square with many degrees of freedom: (chi^2 - n) / sqrt(2 n). Too even counts are as wrong as uneven ones.
double chi_square(const std::vector<double>& count, const std::vector<double>& expected) {
  double sum = 0;
  for (size_t i = 0; i < count.size(); ++i) sum += (count[i] - expected[i]) * (count[i] - expected[i]) / expected[i];
  const double freedom = static_cast<double>(count.size()) - 1;
  return (sum - freedom) / std::sqrt(2 * freedom);
}

// 256 buckets: of the high, the low and the middle bits, of below(16001) and of a value with its right neighbour's.
double buckets(Generator g) {
  std::vector<double> count[5];
  for (auto& c : count) c.assign(256, 0);
  each_cell([&](int32_t x, int32_t y) {
    const uint32_t h = g(7, 1, x, y), right = g(7, 1, x + 1, y);
    ++count[0][h >> 24];
    ++count[1][h & 255];
    ++count[2][(h >> 12) & 255];
    ++count[3][dapple::base::below(h, 16001) * 256 / 16001];
    ++count[4][(h >> 28) * 16 + (right >> 28)];
  });
  double worst = 0;
  std::vector<double> even(256, kCount / 256), of_below(256, 0);
  for (int32_t i = 0; i < 65536; ++i)
    of_below[static_cast<size_t>((i * INT64_C(16001) >> 16) * 256 / 16001)] += kCount / 65536;
  for (int i = 0; i < 5; ++i) worst = larger(worst, chi_square(count[i], i == 3 ? of_below : even));
  return worst;
}

// Runs of equal values of one bit (31, 16, 0) along rows and columns: a run has length n with probability 2^-n, all
// lengths from 12 on counted together (about 128 of them).
double runs(Generator g) {
  double worst = 0;
  for (const int bit : {31, 16, 0})
    for (const bool along_x : {true, false}) {
      std::vector<double> count(12, 0), expected(12, 0);
      double all = 0;
      uint32_t before = 2, length = 0;
      each_cell([&](int32_t slow, int32_t fast) {
        const uint32_t on = g(3, 0, along_x ? slow : fast, along_x ? fast : slow) >> bit & 1;
        if (on == before) {
          ++length;
          return;
        }
        if (length > 0) ++count[length < 12 ? length - 1 : 11], ++all;
        before = on;
        length = 1;
      });
      for (size_t n = 0; n < 12; ++n) expected[n] = all * std::exp2(-static_cast<double>(n < 11 ? n + 1 : 11));
      worst = larger(worst, chi_square(count, expected));
      worst = larger(worst, (all - kCount / 2) / std::sqrt(kCount / 4));  // changes are a coin per cell
    }
  return worst;
}

// Correlation of a cell with another one: z = r sqrt(n). Values centred, variance 2^64 / 12.
template <class Other>
double correlation(Generator g, Other other) {
  double sum = 0;
  each_cell([&](int32_t x, int32_t y) { sum += (g(5, 2, x, y) * 0x1p-32 - 0.5) * (other(x, y) * 0x1p-32 - 0.5); });
  return sum / kCount * 12 * std::sqrt(kCount);
}

// Neighbours in x and y, up to four cells away.
double neighbours(Generator g) {
  double worst = 0;
  for (int32_t dy = 0; dy <= 4; ++dy)
    for (int32_t dx = dy == 0 ? 1 : -4; dx <= 4; ++dx)
      worst = larger(worst, correlation(g, [=](int32_t x, int32_t y) { return g(5, 2, x + dx, y + dy); }));
  return worst;
}

// Streams and seeds of one place, also those that go up and down together, and a few cells away.
double streams(Generator g) {
  double worst = 0;
  for (int32_t seed = -1; seed <= 1; ++seed)
    for (int32_t stream = -1; stream <= 1; ++stream)
      for (int32_t dx = -1; dx <= 1; ++dx) {
        if (seed == 0 && stream == 0) continue;
        const auto there = [=](int32_t x, int32_t y) {
          return g(static_cast<uint32_t>(5 + seed), static_cast<uint32_t>(2 + stream), x + dx, y);
        };
        worst = larger(worst, correlation(g, there));
      }
  for (const uint32_t stream : {64u, 65u, 128u})
    worst = larger(worst, correlation(g, [=](int32_t x, int32_t y) { return g(5, stream, x, y); }));
  worst =
      larger(worst, correlation(g, [=](int32_t x, int32_t y) { return g(5, 2, y, x + 2048); }));  // across the diagonal
  return worst;
}

// Flipping any bit of an argument flips every bit of the result in half of the cases: 16 bits of x and y, 32 of the
// seed, 8 of the stream.
double avalanche(Generator g) {
  constexpr int32_t kSamples = 4096;
  double worst = 0;
  for (int flip = 0; flip < 72; ++flip) {
    int32_t count[32] = {};
    for (int32_t i = 0; i < kSamples; ++i) {
      const uint32_t seed = static_cast<uint32_t>(i) * 77, stream = static_cast<uint32_t>(i % 10);
      const int32_t x = i % 61, y = i / 61;
      const uint32_t bit = 1u << (flip < 32 ? flip % 16 : flip < 64 ? flip - 32 : flip - 64);
      const int32_t mask = static_cast<int32_t>(bit);
      const uint32_t change = g(seed, stream, x, y) ^ (flip < 16   ? g(seed, stream, x ^ mask, y)
                                                       : flip < 32 ? g(seed, stream, x, y ^ mask)
                                                       : flip < 64 ? g(seed ^ bit, stream, x, y)
                                                                   : g(seed, stream ^ bit, x, y));
      for (int k = 0; k < 32; ++k) count[k] += static_cast<int32_t>(change >> k & 1);
    }
    for (const int32_t n : count) worst = larger(worst, (n - kSamples / 2) / (std::sqrt(kSamples) / 2));
  }
  return worst;
}

constexpr int32_t kTile = 32;

// Power of a tile at every wave number, by rows and then by columns; flat white noise has 1 everywhere.
void add_power(Generator g, uint32_t seed, std::vector<double>& power) {
  using Complex = std::complex<double>;
  static const std::vector<Complex> turn = [] {
    std::vector<Complex> t;
    for (int32_t i = 0; i < kTile; ++i) t.push_back(std::polar(1.0, 2 * std::acos(-1.0) * i / kTile));
    return t;
  }();
  std::vector<Complex> rows(kTile * kTile);
  for (int32_t y = 0; y < kTile; ++y)
    for (int32_t x = 0; x < kTile; ++x) {
      const double value = (g(seed, 0, x, y) * 0x1p-32 - 0.5) * std::sqrt(12.0) / kTile;
      for (int32_t k = 0; k < kTile; ++k)
        rows[static_cast<size_t>(y * kTile + k)] += value * turn[static_cast<size_t>(k * x % kTile)];
    }
  for (int32_t k = 0; k < kTile; ++k)
    for (int32_t j = 0; j < kTile; ++j) {
      Complex sum = 0;
      for (int32_t y = 0; y < kTile; ++y)
        sum += rows[static_cast<size_t>(y * kTile + k)] * turn[static_cast<size_t>(j * y % kTile)];
      power[static_cast<size_t>(j * kTile + k)] += std::norm(sum);
    }
}

// The mean of 256 exponential variables has the deviation 1/16 and is nearly normal (skewness 1/8); at the four wave
// numbers that are their own opposites it is sqrt(2) / 16.
double spectrum(Generator g) {
  std::vector<double> power(kTile * kTile);
  for (uint32_t seed = 0; seed < 256; ++seed) add_power(g, seed, power);
  double worst = 0;
  for (const double p : power) worst = larger(worst, (p / 256 - 1) * 16);
  return worst;
}

struct Statistic {
  const char* name;
  double (*z)(Generator);
  Generator bad;  // one that it has to reject
};
constexpr Statistic kStatistics[] = {
    {"buckets", buckets, loaded},        {"runs", runs, sticky},
    {"neighbours", neighbours, sticky},  {"streams", streams, sums},
    {"avalanche", avalanche, one_round}, {"spectrum", spectrum, linear},
};

}  // namespace

TEST_CASE("hash: the library's generator passes every statistic") {
  for (const Statistic& s : kStatistics) {
    INFO(s.name);
    CHECK(s.z(library) < kBound);
  }
}

TEST_CASE("hash: every statistic rejects the linear generator and one nearer to its own bound") {
  for (const Statistic& s : kStatistics) {
    INFO(s.name);
    CHECK(s.z(s.bad) > kBound);
    CHECK(s.z(linear) > kBound);
  }
}

// The values are part of what a seed means. These come from another program, after the definition in base/hash.hpp.
TEST_CASE("hash: known values") {
  CHECK(library(0, 0, 0, 0) == 0x24753dec);
  CHECK(library(1, 0, 0, 0) == 0x6af8cff0);
  CHECK(library(0, 1, 0, 0) == 0xa88c7e2f);
  CHECK(library(0, 0, 1, 0) == 0xbf698a95);
  CHECK(library(0, 0, 0, 1) == 0x5eb9f586);
  CHECK(library(1337, 9, 255, 255) == 0x58377941);
  CHECK(library(UINT32_MAX, 128, 65535, 65535) == 0x61a84a31);
}
