// Rows of colours by every table of ports/desktop against the portable kernel: any range, ramp, light, gloss and grain,
// every format, rows of any width; and every value of the field in ranges of every width.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <vector>

#include "../../lib/base/hash.hpp"
#include "../../lib/paint/paint.hpp"
#include "each_table.hpp"

namespace desktop = dapple::desktop;
namespace grid = dapple::grid;
namespace paint = dapple::paint;

namespace {

constexpr uint16_t kMost = 300;
constexpr int16_t kUnit = 8000;

struct Random {
  uint32_t state;
  int32_t between(int32_t low, int32_t high) {
    const uint32_t h = dapple::base::mix(++state);
    return low + static_cast<int32_t>(h % (static_cast<uint32_t>(high - low) + 1));
  }
};

// Ramps rise, but for one of four made by hand.
dapple::Paint any_paint(Random& random) {
  dapple::Paint p{};
  p.ramp.count = static_cast<uint8_t>(random.between(1, dapple::kMaxStops));
  const bool rises = random.between(0, 3) > 0;
  for (uint8_t i = 0, at = 0; i < p.ramp.count; ++i) {
    at = static_cast<uint8_t>(rises ? random.between(at, at + (255 - at) / 2) : random.between(0, 255));
    p.ramp.stop[i] = {at, static_cast<uint8_t>(random.between(0, 255)), static_cast<uint8_t>(random.between(0, 255)),
                      static_cast<uint8_t>(random.between(0, 255))};
  }
  const int32_t most = random.between(0, 1) == 0 ? 1000000 : 6000000;
  p.low = random.between(-most, most);
  p.high = p.low + random.between(1, random.between(0, 2) == 0 ? 500000 : 2 * most);
  const int32_t strong = random.between(0, 3) == 0 ? 2000000000 : 4000000;
  p.light = random.between(0, 1) * random.between(0, strong);
  p.gloss = random.between(0, 1) * random.between(random.between(0, 3) == 0 ? -1000000 : 0, strong);
  p.grain = random.between(0, 1) * random.between(0, strong);
  return p;
}

struct Rows {
  int16_t above[kMost + 2], here[kMost + 2], below[kMost + 2];
};

int16_t any_value(Random& random, const paint::Shader& s) {
  const int32_t kind = random.between(0, 5), edge = random.between(0, 1) * s.span;
  const int32_t value = kind == 0   ? random.between(-32768, 32767)
                        : kind == 1 ? s.low + edge + random.between(-1, 1)
                                    : s.low + static_cast<int32_t>(random.between(0, 1000) * int64_t{s.span} / 1000);
  return static_cast<int16_t>(dapple::base::clamp(value, -32768, 32767));
}

std::vector<uint8_t> painted(grid::RowKernel row, const paint::Shader& shader, const dapple::Brush& brush,
                             const paint::Source& source) {
  std::vector<uint8_t> pixels(dapple::pixel_bytes(brush.format, source.width) + 8, uint8_t{0xa5});
  const paint::Job job = {&shader, &brush, &source, pixels.data()};
  grid::Rows call{};
  call.in[0] = &job;
  row(call);
  return pixels;
}

}  // namespace

TEST_CASE("desktop: painted rows are those of the portable kernel, whatever the paint") {
  Random random{1};
  for (int i = 0; i < 3000; ++i) {
    dapple::Brush brush;
    brush.format = static_cast<dapple::Pixels>(random.between(0, static_cast<int32_t>(dapple::Pixels::l16_swapped)));
    brush.dither = random.between(0, 3) == 0;
    const paint::Shader shader =
        paint::shader_of(any_paint(random), brush, kUnit, 0, static_cast<uint32_t>(random.between(0, 9)));
    Rows rows;
    for (int16_t* row : {rows.above, rows.here, rows.below})
      for (uint16_t x = 0; x < kMost + 2; ++x) row[x] = any_value(random, shader);
    const uint16_t width = static_cast<uint16_t>(random.between(1, kMost));
    const paint::Source source = {
        rows.above + 1,           rows.here + 1, rows.below + 1, width, 3, random.between(-5000, 5000),
        random.between(-500, 500)};
    const std::vector<uint8_t> want = painted(paint::job_row, shader, brush, source);
    CAPTURE(i);
    CAPTURE(width);
    tests::each_table(
        [&](const desktop::Table& table) {
          CHECK(painted(grid::choose(table.kernels, paint::job_row), shader, brush, source) == want);
        },
        1);
  }
}

TEST_CASE("desktop: every value of the field has its colour, in ranges of every width") {
  dapple::Brush brush;
  brush.format = dapple::Pixels::rgb888;
  dapple::Paint p{};
  p.ramp = {3, {{0, 0, 255, 0}, {128, 128, 0, 255}, {255, 255, 129, 0}}};
  p.low = 0, p.high = 1;
  for (const int32_t span : {1, 255, 4079, 4080, 4081, 4096, 5000, 15200, 16000, 32767, 32768, 32769, 65535, 70000})
    for (const int32_t low : {-32768, -7600, -1, 0, 32767 - span, 40000}) {
      paint::Shader shader = paint::shader_of(p, brush, kUnit, 0, 0);
      shader.low = low, shader.span = span;
      CAPTURE(span);
      CAPTURE(low);
      std::vector<int16_t> values(65536 + 2);
      for (int32_t i = 0; i < 65536; ++i) values[static_cast<size_t>(i + 1)] = static_cast<int16_t>(i - 32768);
      const int16_t* const here = values.data() + 1;
      const paint::Source source = {here, here, here, 65535, 0, 0, 0};
      const std::vector<uint8_t> want = painted(paint::job_row, shader, brush, source);
      tests::each_table(
          [&](const desktop::Table& table) {
            CHECK(painted(grid::choose(table.kernels, paint::job_row), shader, brush, source) == want);
          },
          1);
    }
}
