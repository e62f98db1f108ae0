// The passes: the maximum principle for every weight and difference, Selling's reduction, lists of passes, drift.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <random>
#include <string>
#include <utility>

#include "grow.hpp"
#include "reference/passes.hpp"

namespace stencil = dapple::stencil;
namespace threshold = dapple::threshold;
using dapple::grid::Tensor;
using reference::floor_q16;
using reference::naive_pass;
using reference::passes_of;
using reference::Row;
using reference::Step;
using stencil::Direction;
using stencil::Lattice;
using stencil::Pass;

namespace {

constexpr int32_t kMost = threshold::kLargest;  // concentrations are 0..16000

void call_pass(const int16_t* l, const int16_t* c, const int16_t* r, Row& out, int32_t shift, int32_t weight,
               int32_t rounding) {
  const int32_t p[3] = {shift, weight, rounding};
  dapple::grid::Rows rows{};
  rows.in[0] = l;
  rows.in[1] = c;
  rows.in[2] = r;
  rows.out[0] = out.data();
  rows.p = p;
  rows.n = static_cast<uint16_t>(out.size());
  rows.planes = 1;
  stencil::pass_row(rows);
}

// Cells with every d = l + r - 2c from -32000 to 32000, the neighbours as near to the centre as this d allows: any
// other three cells with the same d have the same increment and wider bounds.
struct EveryDifference {
  Row l, c, r, out;
  EveryDifference() {
    for (int32_t d = -2 * kMost; d <= 2 * kMost; ++d) {
      const int32_t centre = d < 0 ? kMost : 0, half = d / 2;
      l.push_back(static_cast<int16_t>(centre + half));
      c.push_back(static_cast<int16_t>(centre));
      r.push_back(static_cast<int16_t>(centre + d - half));
    }
    out.resize(c.size());
  }
};

struct Wrong {
  int32_t bounds = 0, formula = 0;
};

// Cells that leave the range of their three old cells, or differ from floor((d + rounding) weight / 65536).
Wrong count_wrong(EveryDifference& e, int32_t weight, int32_t rounding) {
  call_pass(e.l.data(), e.c.data(), e.r.data(), e.out, 0, weight, rounding);
  Wrong wrong;
  for (size_t i = 0; i < e.c.size(); ++i) {
    const int32_t l = e.l[i], c = e.c[i], r = e.r[i], out = e.out[i];
    wrong.bounds += static_cast<int32_t>(out < std::min(std::min(l, r), c)) +
                    static_cast<int32_t>(out > std::max(std::max(l, r), c));
    wrong.formula += static_cast<int32_t>(out != c + floor_q16((l + r - 2 * c + rounding) * weight));
  }
  return wrong;
}

// Random numbers from the whole range of recipes.
struct Numbers {
  int32_t number[dapple::kMaxNumbers] = {};
  explicit Numbers(std::mt19937& random) {
    const auto in = [&](int32_t low, int32_t high) {
      return std::uniform_int_distribution<int32_t>(low, high)(random);
    };
    number[threshold::pairs] = 5;
    number[threshold::diffusion] = in(0, 9) == 0;
    number[threshold::scale] = in(threshold::kScale[0], threshold::kScale[1]);
    number[threshold::stretch] = in(threshold::kStretch[0], threshold::kStretch[1]);
    number[threshold::ratio] = in(threshold::kRatio[0], threshold::kRatio[1]);
    if (in(0, 9) == 0) number[threshold::scale] = threshold::kScale[1];
    if (in(0, 9) == 0) number[threshold::stretch] = threshold::kStretch[1];
    if (in(0, 9) == 0) number[threshold::ratio] = threshold::kRatio[1];
    for (int j = 0; j < 5; ++j)
      number[threshold::angles + j] = in(0, 3) == 0 ? 45000000 * in(-8, 8) : in(-360000000, 360000000);
  }
};

// --- A model that only diffuses, to run the passes through the whole machinery; its field is one of its planes. ---
void keep_row(const dapple::grid::Rows&) {}
template <int plane>
void show_row(const dapple::grid::Rows& r) {
  std::copy_n(dapple::grid::in16(r, plane), r.n, dapple::grid::out16(r, 0));
}

dapple::Model diffusing(int plane) {
  dapple::Model model = dapple::threshold_model;
  model.impulse = keep_row;
  model.field = plane == 0 ? show_row<0> : show_row<1>;
  model.wavelength = [](const int32_t*) { return int32_t{4000000}; };  // any torus will do
  return model;
}

// Plane 0 or 1 of the recipe after `steps` macro steps of diffusion alone.
Row diffused(dapple::Recipe recipe, int plane, uint32_t steps, uint16_t width, uint16_t height, uint32_t seed) {
  const dapple::Model model = diffusing(plane);
  recipe.stage[0].model = &model;
  recipe.stage[0].steps = steps;
  tests::Grown tile(recipe, dapple::torus(width, height), seed);
  REQUIRE(tile.status == dapple::ok);
  return tile.field();
}

double mean(const Row& row) { return std::accumulate(row.begin(), row.end(), 0.0) / static_cast<double>(row.size()); }

}  // namespace

TEST_CASE("pass: every weight and every difference stays between its three cells") {
  EveryDifference every;
  int32_t bounds = 0, formula = 0;
  for (int32_t w = stencil::kSmallestWeight; w <= stencil::kQuarter; w += 2) {
    const int32_t r = (32768 + w / 2) / w;
    CHECK((r == dapple::base::rounding_for(static_cast<int16_t>(w)) && 2 * kMost + r <= 32767 && r * w < 65536));
    const Wrong wrong = count_wrong(every, w, r);
    bounds += wrong.bounds;
    formula += wrong.formula;
  }
  for (const int32_t r : {1, 2}) {
    const Wrong wrong = count_wrong(every, stencil::kQuarter, r);
    bounds += wrong.bounds;
    formula += wrong.formula;
  }
  CHECK(bounds == 0);
  CHECK(formula == 0);
}

TEST_CASE("pass: the check above sees a rounding that is too large and a weight that sharpens") {
  EveryDifference every;
  CHECK(count_wrong(every, 16384, 5).bounds > 0);
  CHECK(count_wrong(every, 16382, 5).bounds > 0);
  CHECK(count_wrong(every, 64, 1024).bounds > 0);
  CHECK(count_wrong(every, -64, 0).bounds > 0);
}

TEST_CASE("pass: the quarter kernel is the weighted formula for every sum of neighbours") {
  Row l, r;
  for (int32_t sum = 0; sum <= 2 * kMost; ++sum) {
    l.push_back(static_cast<int16_t>(sum / 2));
    r.push_back(static_cast<int16_t>(sum - sum / 2));
  }
  Row c(l.size()), out(l.size());
  int32_t wrong = 0;
  for (int32_t centre = 0; centre <= kMost; centre += centre % 16 == 0 && centre > 15 && centre < kMost - 16 ? 16 : 1)
    for (const int32_t rounding : {1, 2}) {
      std::fill(c.begin(), c.end(), static_cast<int16_t>(centre));
      call_pass(l.data(), c.data(), r.data(), out, 0, stencil::kQuarter, rounding);
      for (size_t i = 0; i < out.size(); ++i)
        wrong += static_cast<int32_t>(out[i] !=
                                      centre + floor_q16((static_cast<int32_t>(i) - 2 * centre + rounding) * 16384));
    }
  CHECK(wrong == 0);
}

TEST_CASE("pass: a shift reads cells to the left above and to the right below") {
  Row above(50, 0), here(50, 0), below(50, 0), out(30);
  above[10 + 7 - 3] = 4000;   // meets cell 7 at shift 3 (rows start ten cells into the arrays)
  below[10 + 20 - 2] = 8000;  // meets cell 20 at shift -2
  call_pass(above.data() + 10, here.data() + 10, below.data() + 10, out, 3, stencil::kQuarter, 2);
  CHECK(out[7] == 1000);
  CHECK(out[15] == 2000);  // 18 - 3
  call_pass(above.data() + 10, here.data() + 10, below.data() + 10, out, -2, stencil::kQuarter, 2);
  CHECK(out[2] == 1000);  // 4 - 2
  CHECK(out[20] == 2000);
  CHECK(std::accumulate(out.begin(), out.end(), 0) == 3000);
}

TEST_CASE("passes: constant fields are kept bit for bit by every list") {
  std::mt19937 random(11);
  Row every(kMost + 1), out(kMost + 1);
  std::iota(every.begin(), every.end(), static_cast<int16_t>(0));
  int32_t lists = 0;
  for (int i = 0; i < 100; ++i) {
    const Numbers n(random);
    for (uint8_t plane = 0; plane < 2; ++plane)
      for (const Step& step : passes_of(threshold::tensor(n.number, plane))) {
        call_pass(every.data(), every.data(), every.data(), out, 0, step.pass.weight, step.pass.rounding);
        lists += out != every;
      }
  }
  CHECK(lists == 0);
  dapple::Recipe zebra = dapple::load(dapple::presets::zebra);
  dapple::Model model = diffusing(1);
  zebra.stage[0].model = &model;
  zebra.stage[0].steps = 3;
  for (const int32_t level : {0, 1, 7777, 16000}) {
    static int32_t value;
    value = level;
    model.levels = [](const int32_t*, uint8_t) { return dapple::grid::Levels{0, 0, value, value}; };
    tests::Grown tile(zebra, dapple::torus(40, 37), 1);
    CHECK(tile.field() == Row(40 * 37, static_cast<int16_t>(level)));
  }
}

// The residue of one direction that was dropped, of which a and b are the other two: it is a + b or a - b.
static bool dropped_one(const int64_t (&rest)[3], const Direction& a, const Direction& b) {
  for (const int32_t sign : {1, -1}) {
    const int64_t x = a.vx + sign * b.vx, y = a.vy + sign * b.vy;
    const int64_t share = x != 0 ? rest[0] / (x * x) : rest[2] / (y * y);
    if (share >= 0 && share < stencil::kSmallestShare && share * x * x == rest[0] && share * x * y == rest[1] &&
        share * y * y == rest[2])
      return true;
  }
  return false;
}

static bool in_order(const Lattice& lattice) {
  for (int i = 0; i < lattice.count; ++i) {
    const Direction& d = lattice.direction[i];
    if (d.share < stencil::kSmallestShare || d.vy < 0 || (d.vy == 0 && d.vx != 1) ||
        std::gcd(int{d.vx}, int{d.vy}) != 1)
      return false;
    for (int j = 0; j < i; ++j) {
      const Direction& e = lattice.direction[j];
      if (std::abs(d.vx * e.vy - d.vy * e.vx) != 1 || std::pair(e.vy, e.vx) >= std::pair(d.vy, d.vx)) return false;
    }
  }
  return true;
}

TEST_CASE("Selling: shares and directions make the matrix again, for tensors of the whole range") {
  std::mt19937 random(3);
  int32_t counts[4] = {}, unordered = 0, wrong = 0, largest = 0, reach = 0;
  for (int i = 0; i < 100000; ++i) {
    const Numbers n(random);
    const uint8_t plane = static_cast<uint8_t>(i % 10), level = static_cast<uint8_t>(i / 10 % 4);
    const Tensor t = dapple::grid::at_level(threshold::tensor(n.number, plane), level);
    const Lattice lattice = stencil::lattice_of(t);
    REQUIRE(lattice.count <= 3);
    int64_t rest[3] = {t.xx, t.xy, t.yy};
    for (int k = 0; k < lattice.count; ++k) {
      const Direction& d = lattice.direction[k];
      rest[0] -= int64_t{d.share} * d.vx * d.vx;
      rest[1] -= int64_t{d.share} * d.vx * d.vy;
      rest[2] -= int64_t{d.share} * d.vy * d.vy;
      largest = std::max(largest, d.share);
      reach = std::max(reach, int32_t{stencil::reach_of(d.share)});
    }
    const bool nothing = rest[0] == 0 && rest[1] == 0 && rest[2] == 0;
    if (lattice.count == 2) wrong += !nothing && !dropped_one(rest, lattice.direction[0], lattice.direction[1]);
    else if (lattice.count == 3) wrong += !nothing;
    else
      wrong += rest[0] < 0 || rest[2] < 0 || rest[0] * rest[2] < rest[1] * rest[1] ||
               rest[0] + rest[2] > 20 * stencil::kSmallestShare;
    unordered += !in_order(lattice);
    ++counts[lattice.count];
  }
  CHECK(wrong == 0);
  CHECK(unordered == 0);
  CHECK(counts[2] > 1000);
  CHECK(counts[3] > 1000);
  CHECK(largest <= stencil::kLargestShare);
  CHECK(reach <= stencil::kLargestStride);
  CHECK(reach == 45);  // V = 1600 along one axis, from scale 8 and stretch 5
}

TEST_CASE("passes: strides 1, 1, 2, 3 ... or by the root of 2, all full but the last, and the variance is the share") {
  const int32_t near_strides[] = {1, 1, 2, 3, 4, 5, 6}, wide_strides[] = {1, 1, 2, 3, 4, 6, 8, 11, 16, 23, 32, 45, 64, 91};
  std::vector<int32_t> shares = {stencil::kSmallestShare, stencil::kLargestShare};
  for (int32_t share = stencil::kSmallestShare; share <= stencil::kLargestShare; share += 9973) shares.push_back(share);
  int32_t sum = 0;
  const auto add_around = [&](int32_t stride) {
    sum += stride * stride * 32768;
    for (int32_t near = -300; near <= 300; ++near)
      if (sum + near >= stencil::kSmallestShare && sum + near <= stencil::kLargestShare) shares.push_back(sum + near);
  };
  for (const int32_t stride : near_strides) add_around(stride);
  CHECK(std::exchange(sum, 0) == stencil::kWideShare);
  for (const int32_t stride : wide_strides) add_around(stride);
  CHECK(sum == stencil::kLargestShare);
  int32_t strides = 0, weights = 0, roundings = 0, variances = 0, largest = 0;
  for (const int32_t share : shares) {
    stencil::PassSeries series = stencil::series_of(share, static_cast<uint8_t>(share & 1));
    int64_t variance = 0, last = 0;
    int32_t made = 0, turn = share & 1, before = stencil::kQuarter;
    const bool wide = share > stencil::kWideShare;
    for (Pass pass{}; stencil::next_pass(series, pass); ++made, before = pass.weight) {
      REQUIRE(made < (wide ? 14 : 7));
      strides += pass.stride != (wide ? wide_strides : near_strides)[made];
      weights += before != stencil::kQuarter || pass.weight < 64 || pass.weight > 16384 || pass.weight % 2 != 0;
      roundings += pass.rounding != (pass.weight == 16384 ? 2 - (turn++ & 1) : (32768 + pass.weight / 2) / pass.weight);
      variance += INT64_C(2) * pass.weight * pass.stride * pass.stride;
      largest = std::max(largest, int32_t{pass.stride});
      last = int64_t{pass.stride} * pass.stride;
    }
    // The last weight is even: at most 1 off, 2 s^2 of variance; or the pass after it had a weight below 64.
    const int64_t step = made >= (wide ? 14 : 7) ? 0 : (wide ? wide_strides : near_strides)[made];
    const int64_t next = step * step, missing = share - variance;
    variances += !(missing >= -2 * last && missing <= std::max(2 * last, 126 * next));
    roundings += series.turn != (turn & 1);
  }
  CHECK((strides == 0 && weights == 0 && roundings == 0 && variances == 0));
  CHECK((largest == 91 && stencil::reach_of(stencil::kLargestShare) == 91));
  CHECK(stencil::reach_of(stencil::kLargestShare - 91 * 91 * 32768) == 64);
}

TEST_CASE("chain: all passes along a row at once are the passes one at a time") {
  std::mt19937 random(19);
  for (int i = 0; i < 400; ++i) {
    const int32_t width = std::uniform_int_distribution<int32_t>(1, 90)(random);
    const int32_t share = i < 10 ? stencil::kSmallestShare + i
                                 : static_cast<int32_t>(std::exp2(std::uniform_real_distribution<>(11, 29)(random)));
    Row row(static_cast<size_t>(width)), want;
    for (int16_t& c : row) c = static_cast<int16_t>(std::uniform_int_distribution<int32_t>(0, kMost)(random));
    want = row;
    const int32_t narrow = i % 3 == 0 ? stencil::wide_share(dapple::evolve::kShadeLength[0]) : stencil::kWideShare;
    stencil::PassSeries series = stencil::series_of(share, 0, narrow);
    for (Pass pass{}; stencil::next_pass(series, pass);) want = naive_pass(want, width, 1, {{1, 0, share}, pass});

    const uint16_t halo = stencil::reach_of(share, narrow), n = static_cast<uint16_t>(width);
    const int32_t p[3] = {share, halo, narrow};
    std::vector<int32_t> scratch(dapple::grid::scratch_bytes(dapple::grid::Cell::int16, n, halo) / 2);  // two rows
    dapple::grid::Rows rows{};
    rows.p = p;
    rows.scratch = reinterpret_cast<uint8_t*>(scratch.data());
    rows.n = n;
    rows.planes = 1;
    row.resize(dapple::grid::row_bytes(dapple::grid::Cell::int16, n) / 2);  // rows of planes end at four bytes
    rows.out[0] = row.data();
    stencil::chain_row(rows);
    row.resize(n);
    CAPTURE(width);
    CAPTURE(share);
    CHECK(row == want);
  }
}

TEST_CASE("passes: the diffusion of whole planes is the passes, cell by cell, in their order") {
  std::mt19937 random(23);
  const tests::Size sizes[] = {{8, 8}, {31, 9}, {9, 40}, {64, 24}, {37, 53}};
  for (int i = 0; i < 60; ++i) {
    dapple::Recipe recipe = dapple::load(dapple::presets::zebra);
    const Numbers n(random);
    std::copy(n.number, n.number + dapple::kMaxNumbers, recipe.stage[0].number);
    recipe.stage[0].number[threshold::rho + 3] = recipe.stage[0].number[threshold::k + 3] = 0;
    const tests::Size size = sizes[i % 5];
    const uint8_t plane = static_cast<uint8_t>(i / 5 % 2);
    Row want = diffused(recipe, plane, 0, size.width, size.height, 77);
    for (int step = 0; step < 2; ++step)
      for (const Step& s : passes_of(threshold::tensor(n.number, plane)))
        want = naive_pass(want, size.width, size.height, s);
    CAPTURE(i);
    CHECK(diffused(recipe, plane, 2, size.width, size.height, 77) == want);
  }
}

// How far a macro step moves the mean of a plane in which every remainder is as likely as any other: a pass adds
// r w / 65536 before it floors, the floor takes (1 - 2^z / 65536) / 2 on average, 2^z being the power of two in w.
static double expected_drift(const Tensor& t, bool alternate) {
  double sum = 0;
  for (const Step& step : passes_of(t)) {
    const int32_t w = step.pass.weight, rounding = alternate || w < 16384 ? step.pass.rounding : 2;
    sum += rounding * w / 65536.0 - (1 - (w & -w) / 65536.0) / 2;
  }
  return sum;
}

// What is left is the last pass of each direction (its rounding is a whole number, so .125 at most) and an odd full
// pass (.125): .5 at the very most, .2 for the presets. Sampling noise of a mean is about .005 with these sizes.
TEST_CASE("drift: the mean of a plane of noise moves by less than .25 units a macro step, and as predicted") {
  double least_fixed = 10;
  for (uint16_t i = 0; i < dapple::preset_count(); ++i) {
    char name[dapple::kMaxName];
    dapple::Recipe recipe = dapple::load(*dapple::preset_at(i, name).preset);
    if (recipe.stage[0].model != &dapple::threshold_model) continue;
    recipe.start.kind = dapple::Start::noise, recipe.start.row = dapple::row_start(recipe.start.kind);
    recipe.stages = 1, recipe.stage[0].level = 0;
    INFO(std::string(name));
    for (int plane = 0; plane < 2; ++plane) {
      const Tensor t = threshold::tensor(recipe.stage[0].number, static_cast<uint8_t>(plane));
      const double before = mean(diffused(recipe, plane, 0, 256, 256, 5));
      const double once = mean(diffused(recipe, plane, 1, 256, 256, 5)) - before;
      const double long_run = (mean(diffused(recipe, plane, 16, 256, 256, 5)) - before) / 16;
      CHECK(std::fabs(once) < 0.25);
      CHECK(std::fabs(long_run) < 0.25);
      CHECK(std::fabs(once - expected_drift(t, true)) < 0.03);
      least_fixed = std::min(least_fixed, expected_drift(t, false));
    }
  }
  CHECK(least_fixed > 0.5);  // 2 in every full pass would drift by about 1
}
