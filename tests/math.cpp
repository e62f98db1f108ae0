// Small integer maths against std:: and exact arithmetic, exhaustively where that is possible.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <random>

#include "base/hash.hpp"
#include "base/math.hpp"
#include "grid/plane.hpp"
#include "model/threshold.hpp"

namespace base = dapple::base;
namespace threshold = dapple::threshold;

namespace {

const double kPi = std::acos(-1.0);

// floor(a / b), b > 0, by remainders.
int64_t floor_div(int64_t a, int64_t b) {
  const int64_t rest = (a % b + b) % b;
  return (a - rest) / b;
}

}  // namespace

TEST_CASE("sine: every angle within 3 units, exact at the quadrants, odd and symmetric") {
  double worst = 0, bias = 0;
  int32_t unlike = 0;
  for (int32_t a = 0; a < 65536; ++a) {
    const uint16_t angle = static_cast<uint16_t>(a);
    const double error = base::sine(angle) - 32767 * std::sin(2 * kPi * a / 65536);
    worst = std::max(worst, std::fabs(error));
    bias += error / 65536;
    unlike += base::sine(static_cast<uint16_t>(-a)) != -base::sine(angle);
    unlike += base::sine(static_cast<uint16_t>(32768 - a)) != base::sine(angle);
    unlike += base::cosine(angle) != base::sine(static_cast<uint16_t>(a + 16384));
  }
  CHECK(worst <= 3);
  CHECK(std::fabs(bias) < 1e-6);
  CHECK(unlike == 0);
  CHECK(base::sine(0) == 0);
  CHECK(base::sine(16384) == 32767);
  CHECK(base::sine(32768) == 0);
  CHECK(base::sine(49152) == -32767);
  CHECK(base::cosine(0) == 32767);
}

TEST_CASE("angle_of: rounds half up, either sign, any number of turns") {
  int32_t wrong = 0;
  const auto check = [&](int64_t micro) {
    const int64_t want = floor_div(2 * micro * 65536 + 360000000, 720000000);
    wrong += base::angle_of(static_cast<int32_t>(micro)) != ((want % 65536) + 65536) % 65536;
  };
  for (int64_t micro = -720000000; micro <= 720000000; micro += 997) check(micro);
  for (int64_t units = -131072; units <= 131072; units += 7)  // next to every half unit, 360e6 / 65536 = 5493.1640625
    for (int64_t near = -2; near <= 2; ++near) check((2 * units + 1) * 360000000 / 131072 + near);
  CHECK(wrong == 0);
  CHECK(base::angle_of(90000000) == 16384);
  CHECK(base::angle_of(-90000000) == 49152);
  CHECK(base::angle_of(360000000) == 0);
}

TEST_CASE("square roots: floor, at both sides of every square") {
  int32_t wrong = 0;
  for (uint32_t root = 0; root < 65536; ++root) {
    wrong += base::square_root(root * root) != root;
    wrong += base::square_root(root * root + root) != root;
    wrong += base::square_root(root * root + 2 * root) != root;
    wrong += base::square_root64(uint64_t{root} * root + 2 * root) != root;
  }
  for (uint64_t root = UINT64_C(0xffffffff); root > 0; root -= std::min(root, UINT64_C(65521))) {
    wrong += base::square_root64(root * root) != root;
    wrong += base::square_root64(root * root - 1) != root - 1;
    wrong += base::square_root64(root * root + 2 * root) != root;
  }
  CHECK(wrong == 0);
  CHECK(base::square_root(UINT32_MAX) == 65535);
  CHECK(base::square_root64(UINT64_MAX) == UINT32_MAX);
}

TEST_CASE("inverse_root: every argument within one part in 500 and a unit") {
  int32_t wrong = 0, rises = 0;
  uint16_t before = 65535;
  for (uint32_t n = 1u << 16; n <= 1u << 26; n += n < 1u << 22 ? 1 : 13) {
    const double exact = 16777216 / std::sqrt(static_cast<double>(n));
    const uint16_t have = base::inverse_root(n);
    wrong += std::fabs(have - exact) > exact / 500 + 1;
    rises += have > before;
    before = have;
  }
  CHECK(wrong == 0);
  CHECK(rises == 0);
  for (const uint32_t n : {0u, 1u, 65535u}) CHECK(base::inverse_root(n) == 65535);
}

TEST_CASE("divide_round: half up for both signs") {
  int32_t wrong = 0;
  for (int64_t b = 1; b <= 130; ++b)
    for (int64_t a = -700; a <= 700; ++a) wrong += base::divide_round(a, b) != floor_div(2 * a + b, 2 * b);
  std::mt19937_64 random(1);
  for (int i = 0; i < 300000; ++i) {
    const int64_t a = static_cast<int64_t>(random()) >> (3 + i % 60),
                  b = 1 + static_cast<int64_t>(random() >> (4 + i % 59));
    wrong += base::divide_round(a, b) != floor_div(2 * a + b, 2 * b);
  }
  CHECK(wrong == 0);
  CHECK(base::divide_round(1, 2) == 1);
  CHECK(base::divide_round(-1, 2) == 0);
  CHECK(base::divide_round(-3, 2) == -1);
}

TEST_CASE("mulhi and the roundings: the floor of the exact product, for every argument and many factors") {
  int32_t wrong = 0;
  for (int32_t b = -32768; b <= 32767; b += b % 128 == 0 && b > -32700 && b < 32600 ? 128 : 1)
    for (int32_t a = -32768; a <= 32767; ++a) {
      const int64_t want = (int64_t{a} * b + (INT64_C(1) << 31)) / 65536 - 32768;  // positive before it is divided
      wrong += base::mulhi(static_cast<int16_t>(a), static_cast<int16_t>(b)) != want;
    }
  CHECK(wrong == 0);
  for (int32_t w = 64; w <= 32766; w += 2) {
    const int16_t r = base::rounding_for(static_cast<int16_t>(w));
    const double share = 32768.0 / w;
    CHECK((std::fabs(r - share) <= 0.5 && r * w < 65536 && base::mulhi(r, static_cast<int16_t>(w)) == 0));
  }
}

TEST_CASE("gcd, min, max, clamp, add_bytes, below") {
  int32_t wrong = 0;
  for (uint32_t a = 0; a < 300; ++a)
    for (uint32_t b = 0; b < 300; ++b)
      wrong += base::gcd(static_cast<uint16_t>(a), static_cast<uint16_t>(b)) != std::gcd(a, b);
  CHECK(base::gcd(65535, 43690) == 21845);
  for (int32_t x = -9; x <= 9; ++x)
    for (int32_t y = -9; y <= 9; ++y) {
      wrong += base::min(x, y) != std::min(x, y) || base::max(x, y) != std::max(x, y);
      wrong += base::clamp(x, -4, 5) != std::clamp(x, -4, 5);
    }
  for (const uint32_t count : {1u, 2u, 3u, 10u, 16001u, 65536u}) {
    uint32_t least = UINT32_MAX, most = 0;
    for (uint32_t high = 0; high < 65536; ++high) {
      const uint32_t have = base::below(high << 16 | (high * 40503 & 65535), count);
      wrong += have != uint64_t{high} * count / 65536;
      least = std::min(least, have);
      most = std::max(most, have);
    }
    wrong += least != 0 || most != count - 1;
  }
  CHECK(wrong == 0);
  size_t total = 5;
  CHECK((base::add_bytes(total, 3, 7) && total == 26));
  CHECK((!base::add_bytes(total, SIZE_MAX / 4, 5) && total == 26));
  CHECK((!base::add_bytes(total, 1, SIZE_MAX - 25) && total == 26));
  CHECK((base::add_bytes(total, 1, SIZE_MAX - 26) && total == SIZE_MAX));
  CHECK((base::add_bytes(total, 9, 0) && total == SIZE_MAX));
}

TEST_CASE("schedules: constant, step and ramp, one rounding, up to four stages of a million steps") {
  std::mt19937 random(5);
  const auto in = [&](int64_t low, int64_t high) { return std::uniform_int_distribution<int64_t>(low, high)(random); };
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    int64_t slot[4] = {in(0, 1000000), in(0, 1000000), in(0, 1000000), in(0, 1000000)};
    if (slot[2] > slot[3]) std::swap(slot[2], slot[3]);
    if (i % 5 == 0) slot[3] = slot[2];
    const int64_t steps = in(1, i % 3 == 0 ? 4000000 : 50), step = in(0, steps), at = 1000000 * step;
    const double share = static_cast<double>(at - slot[2] * steps) / static_cast<double>((slot[3] - slot[2]) * steps);
    double want = static_cast<double>(slot[0]) + static_cast<double>(slot[1] - slot[0]) * share;
    if (at < slot[2] * steps) want = static_cast<double>(slot[0]);
    if (at >= slot[3] * steps) want = static_cast<double>(slot[1]);
    int32_t narrow[4];
    std::copy(slot, slot + 4, narrow);
    const dapple::Clock clock = {static_cast<uint32_t>(step), static_cast<uint32_t>(steps)};
    worst = std::max(worst, std::fabs(dapple::scheduled(narrow, clock) - want));
  }
  CHECK(worst <= 0.5 + 1e-6);
  const int32_t jump[4] = {10, 20, 100000, 100000};
  CHECK(dapple::scheduled(jump, {9, 100}) == 10);
  CHECK(dapple::scheduled(jump, {10, 100}) == 20);
}

TEST_CASE("tensor: eq. (6) in double for the whole range, and on coarser grids") {
  std::mt19937 random(7);
  const auto in = [&](const int32_t(&range)[2]) {
    return std::uniform_int_distribution<int32_t>(range[0], range[1])(random);
  };
  double worst = 0, worst_level = 0;
  for (int i = 0; i < 20000; ++i) {
    int32_t n[dapple::kMaxNumbers] = {};
    n[threshold::diffusion] = i % 5 == 0 ? threshold::isotropic : threshold::oriented;
    n[threshold::scale] = in(threshold::kScale);
    n[threshold::stretch] = in(threshold::kStretch);
    n[threshold::ratio] = in(threshold::kRatio);
    n[threshold::angles] = in({-threshold::kTurn, threshold::kTurn});
    const uint8_t plane = static_cast<uint8_t>(i % 2);
    const double a2 = n[threshold::scale] / 1e6 * (plane == 1 ? n[threshold::ratio] / 1e6 : 1);
    const double a1 = i % 5 == 0 ? a2 : n[threshold::scale] / 1e6 * n[threshold::stretch] / 1e6;
    const double angle = n[threshold::angles] / 1e6 * kPi / 180, c = std::cos(angle), s = std::sin(angle);
    const dapple::grid::Tensor t = threshold::tensor(n, plane), half = dapple::grid::at_level(t, 1),
                               eighth = dapple::grid::at_level(t, 3);
    const double want[3] = {a1 * a1 * c * c + a2 * a2 * s * s, (a1 * a1 - a2 * a2) * c * s,
                            a1 * a1 * s * s + a2 * a2 * c * c};
    const int32_t have[3] = {t.xx, t.xy, t.yy}, at_1[3] = {half.xx, half.xy, half.yy},
                  at_3[3] = {eighth.xx, eighth.xy, eighth.yy};
    for (int k = 0; k < 3; ++k) {
      worst = std::max(worst, std::fabs(have[k] / 65536.0 - want[k]) / (a1 * a1 + a2 * a2));
      worst_level = std::max({worst_level, std::fabs(at_1[k] - have[k] / 4.0), std::fabs(at_3[k] - have[k] / 64.0)});
    }
  }
  CHECK(worst < 3e-4);  // sine is within 3 / 32767, and the angle within half of 1/65536 of a turn
  CHECK(worst_level <= 0.5);
}
