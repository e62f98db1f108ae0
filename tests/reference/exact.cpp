// The formulas of docs/numbers.md, written down once more in wide integers and floor divisions and applied cell by cell
// over whole planes: every preset has to have these bytes. (Fidelity of the formulas themselves: the other files here.)
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "grow.hpp"
#include "reference/passes.hpp"

namespace threshold = dapple::threshold;
namespace slot = dapple::gray_scott;
using reference::naive_pass;
using reference::Row;

namespace {

constexpr int32_t kWidth = 96, kHeight = 90;

int64_t floor_div(int64_t a, int64_t b) { return (a - ((a % b) + b) % b) / b; }
int64_t half_up(int64_t a, int64_t b) { return floor_div(2 * a + b, 2 * b); }

// Values that the library's types would not hold; none may be.
int64_t too_wide = 0;
int64_t mulhi(int64_t a, int64_t b) {
  too_wide += a < -32768 || a > 32767 || b < -32768 || b > 32767;
  return floor_div(a * b, 65536);
}

// Reads a plane on the torus.
struct View {
  const Row& plane;
  int64_t operator()(int32_t x, int32_t y) const {
    return plane[static_cast<size_t>((y + kHeight) % kHeight * kWidth + (x + kWidth) % kWidth)];
  }
};

template <class Do>
void each_cell(Do act) {
  for (int32_t y = 0; y < kHeight; ++y)
    for (int32_t x = 0; x < kWidth; ++x) act(x, y, static_cast<size_t>(y * kWidth + x));
}

std::vector<Row> start_of(const dapple::Recipe& recipe, uint32_t seed) {
  const dapple::Stage& stage = recipe.stage[0];
  const dapple::start::Place place = {dapple::grid::Cell::int16, kWidth, kHeight, 0, 0, 0, false, seed};
  std::vector<Row> planes(stage.model->planes(stage.number), Row(kWidth * kHeight));
  for (uint8_t i = 0; i < planes.size(); ++i)
    for (uint16_t y = 0; y < kHeight; ++y) {
      int16_t* row = planes[i].data() + y * kWidth;
      const dapple::grid::Levels levels = stage.model->levels(stage.number, i);
      recipe.start.row(place, recipe.start, levels, i, y, row);
    }
  return planes;
}

// A schedule in 1/1000000.
int64_t scheduled(const int32_t* s, int64_t step, int64_t steps) {
  if (step * 1000000 < s[2] * steps) return s[0];
  if (step * 1000000 >= s[3] * steps) return s[1];
  return s[0] + half_up((s[1] - s[0]) * (step * 1000000 - s[2] * steps), (int64_t{s[3]} - s[2]) * steps);
}

Row shading(const std::vector<Row>& planes, const int32_t* n) {
  Row field(planes[0].size());
  for (size_t i = 0; i < field.size(); ++i) {
    int32_t most = -99999, least = 99999;
    for (size_t j = 0; j < planes.size(); j += 2) {
      most = std::max(most, planes[j][i] - planes[j + 1][i]);
      least = std::min(least, planes[j][i] - planes[j + 1][i]);
    }
    field[i] = static_cast<int16_t>(
        n[threshold::react] == threshold::difference_abs && n[threshold::pairs] > 1 ? most + least : most);
  }
  return field;
}

void macro_step(std::vector<Row>& planes, const int32_t* n, int64_t step, int64_t steps) {
  const Row field = shading(planes, n);
  const int64_t rho = half_up(scheduled(n + threshold::rho, step, steps) * 8000, 1000000);
  const int64_t impulse = half_up(scheduled(n + threshold::k, step, steps) * 3147, 1000000);
  for (size_t p = 0; p < planes.size(); ++p) {
    for (size_t i = 0; i < field.size(); ++i)
      planes[p][i] =
          static_cast<int16_t>(planes[p][i] - mulhi(planes[p][i] + 1, 25786) + (field[i] > rho ? impulse : 0));
    for (const reference::Step& pass : reference::passes_of(threshold::tensor(n, static_cast<uint8_t>(p))))
      planes[p] = naive_pass(planes[p], kWidth, kHeight, pass);
  }
}

// One of the m sub-steps. The weights are the Q16 tensor (A itself) over 2 m, its mixed part over 4 m, towards zero.
void euler_step(std::vector<Row>& planes, const int32_t* n, int64_t m, int64_t step, int64_t steps) {
  const Row field = shading(planes, n);
  const int64_t rho = half_up(scheduled(n + threshold::rho, step, steps) * 8000, 1000000);
  const int64_t k = half_up(scheduled(n + threshold::k, step, steps) * 8000, 1000000);
  for (size_t p = 0; p < planes.size(); ++p) {
    const Row old = planes[p];
    const View c{old};
    const dapple::grid::Tensor t = threshold::tensor(n, static_cast<uint8_t>(p));
    each_cell([&](int32_t x, int32_t y, size_t at) {
      const int64_t sum = t.xx / (2 * m) * (c(x - 1, y) + c(x + 1, y) - 2 * c(x, y)) +
                          t.yy / (2 * m) * (c(x, y - 1) + c(x, y + 1) - 2 * c(x, y)) +
                          t.xy / (4 * m) * (c(x - 1, y - 1) + c(x + 1, y + 1) - c(x + 1, y - 1) - c(x - 1, y + 1)) +
                          32768 / m * ((field[at] > rho ? k : 0) - c(x, y)) + 32768;
      too_wide += sum > INT32_MAX || sum < INT32_MIN;
      planes[p][at] = static_cast<int16_t>(std::clamp<int64_t>(c(x, y) + floor_div(sum, 65536), 0, 16000));
    });
  }
}

void gray_scott_step(std::vector<Row>& planes, const int32_t* n) {
  const auto even = [](int64_t a, int64_t b) { return 2 * half_up(a * 32768, b); };  // even Q16
  const auto r = [](int64_t w) { return (32768 + w / 2) / w; };
  const int64_t square = int64_t{n[slot::scale]} * n[slot::scale] / 1000000;
  const int64_t feed = even(n[slot::feed], 1000000), drain = even(int64_t{n[slot::feed]} + n[slot::kill], 1000000);
  const std::vector<Row> old = planes;
  each_cell([&](int32_t x, int32_t y, size_t at) {
    const int64_t u = old[0][at], v = old[1][at], z = mulhi(2 * mulhi(2 * v, 2 * v) + 2, 2 * u);
    const auto spread = [&](const Row& plane, int64_t w) {
      const View c{plane};
      return mulhi(c(x - 1, y) + c(x + 1, y) - 2 * c(x, y) + r(w), w) +
             mulhi(c(x, y - 1) + c(x, y + 1) - 2 * c(x, y) + r(w), w);
    };
    const int64_t du = spread(old[0], even(square * 16, 100000000)), dv = spread(old[1], even(square * 8, 100000000));
    planes[0][at] = static_cast<int16_t>(u + du - z + mulhi(16383 - u + r(feed), feed));
    planes[1][at] = static_cast<int16_t>(v + dv + z - mulhi(v + r(drain), drain));
  });
}

void each_preset(const dapple::Model* model, uint32_t steps, void (*check)(const dapple::Recipe& recipe)) {
  for (uint16_t i = 0; i < dapple::preset_count(); ++i) {
    char name[dapple::kMaxName];
    dapple::Recipe recipe = dapple::load(*dapple::preset_at(i, name).preset);
    if (recipe.stage[0].model != model) continue;
    recipe.stages = 1;
    recipe.stage[0].level = 0;
    recipe.stage[0].steps = std::min(recipe.stage[0].steps, steps);
    INFO(std::string(name));
    too_wide = 0;
    check(recipe);
    CHECK(too_wide == 0);
  }
}

}  // namespace

TEST_CASE("exact: macro steps of every threshold preset") {
  each_preset(&dapple::threshold_model, 10, [](const dapple::Recipe& recipe) {
    std::vector<Row> planes = start_of(recipe, 8);
    const int32_t* n = recipe.stage[0].number;
    for (uint32_t step = 0; step < recipe.stage[0].steps; ++step) macro_step(planes, n, step, recipe.stage[0].steps);
    tests::Grown tile(recipe, dapple::torus(kWidth, kHeight), 8);
    CHECK(tile.field() == shading(planes, n));
    CHECK(tile.texture.cell_level() == half_up(int64_t{n[threshold::rho + 1]} * 8000, 1000000));
  });
}

TEST_CASE("exact: explicit steps of every threshold preset") {
  each_preset(&dapple::threshold_model, 2, [](const dapple::Recipe& preset) {
    dapple::Recipe recipe = preset;
    dapple::Trouble trouble{};
    REQUIRE(dapple::parse("solver=euler", recipe, trouble) == dapple::ok);
    const int32_t* n = recipe.stage[0].number;
    int64_t trace = 0, m = 1;
    for (uint8_t p = 0; p < 2 * n[threshold::pairs]; ++p)
      trace = std::max(trace, int64_t{threshold::tensor(n, p).xx} + threshold::tensor(n, p).yy);
    while (10 * (4 * trace + 65536) > 2 * 17 * 65536 * m) ++m;  // (4 tr A + 1) / (2 m) <= 1.7
    std::vector<Row> planes = start_of(recipe, 8);
    for (uint32_t step = 0; step < recipe.stage[0].steps; ++step)
      for (int64_t sub = 0; sub < m; ++sub) euler_step(planes, n, m, step, recipe.stage[0].steps);
    tests::Grown tile(recipe, dapple::torus(kWidth, kHeight), 8);
    CHECK(tile.field() == shading(planes, n));
    CHECK(tile.texture.rows_done() == tile.texture.rows_in_all());
  });
}

TEST_CASE("exact: steps of every Gray-Scott preset") {
  each_preset(&dapple::gray_scott_model, 200, [](const dapple::Recipe& recipe) {
    std::vector<Row> planes = start_of(recipe, 8);
    for (uint32_t step = 0; step < recipe.stage[0].steps; ++step) gray_scott_step(planes, recipe.stage[0].number);
    tests::Grown tile(recipe, dapple::torus(kWidth, kHeight), 8);
    CHECK(tile.field() == planes[1]);
  });
}
