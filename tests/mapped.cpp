// The mapped family: mass and bounds to the last bit, the same bytes with and without kept directions, on torus and
// plane.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <string>

#include "grow.hpp"
#include "stencil/flux.hpp"

namespace stencil = dapple::stencil;
using dapple::grid::Cell;
using tests::Grown;

namespace {

const char* const kMaps[] = {"none", "radial", "scallop", "haunch", "two-angle", "swirl", "bends", "corners"};

std::string recipe_with(const char* map, const char* numbers) {
  return std::string("mapped map=") + map + " " + numbers;
}

// One macro step of pure diffusion and its sweeps, over planes of random extremes: no impulse is asked for.
struct Diffusion {
  static constexpr uint16_t kWidth = 40, kHeight = 37;
  std::vector<int16_t> planes;
  dapple::evolve::Field field;
  std::vector<uint8_t> scratch;
  std::vector<int32_t> table;

  Diffusion(const dapple::Recipe& recipe, uint32_t seed) {
    const dapple::Stage& stage = recipe.stage[0];
    const dapple::Model& model = *stage.model;
    const dapple::evolve::Reach reach = stage.solver->reach(model, stage.number, 0, nullptr);
    const uint8_t count = model.planes(stage.number);
    const size_t cells = size_t{kWidth} * kHeight;
    std::mt19937 random(seed);
    planes.resize((count + 1u * reach.kept) * cells);
    for (size_t i = 0; i < count * cells; ++i) planes[i] = static_cast<int16_t>(random() % 3 * 8000);
    size_t bytes = 0;
    REQUIRE(dapple::evolve::band_bytes(reach, Cell::int16, kWidth, 1, bytes));
    scratch.resize(bytes);
    table.resize(reach.table);
    field = {reinterpret_cast<uint8_t*>(planes.data()),
             2 * cells,
             2 * kWidth,
             scratch.data(),
             bytes,
             kWidth,
             kHeight,
             Cell::int16,
             1};
    const dapple::grid::Ground ground = {kWidth, kHeight, 0, 0};
    const dapple::evolve::Context context = {&model,  stage.number, nullptr, table.data(), {0, 1}, 0,
                                             &ground, false,        seed,    nullptr,      true};
    stage.solver->prepare(context);
    dapple::evolve::Cursor cursor{};
    dapple::evolve::Sweep sweep{};
    dapple::evolve::Band band{};
    while (stage.solver->next(context, cursor, sweep)) {
      if (sweep.row == model.impulse) continue;
      dapple::evolve::begin_sweep(field, sweep, &band);
      while (band.next < band.end) dapple::evolve::run_band(field, sweep, table.data(), 0, band, 5);
    }
  }
  std::vector<int16_t> plane(uint8_t i) const {
    const auto from = planes.begin() + static_cast<ptrdiff_t>(i * size_t{kWidth} * kHeight);
    return {from, from + kWidth * kHeight};
  }
};

}  // namespace

TEST_CASE("mapped: a step of diffusion keeps mass exactly and stays between the least and the greatest") {
  for (const char* map : kMaps)
    for (const char* numbers : {"scale=1.5 stretch=3 pairs=2", "scale=2.5 stretch=5 ratio=3 angle=13",
                                "scale=0.4 stretch=1 ratio=1.1 pairs=4"}) {
      const dapple::Recipe recipe = tests::recipe_of(recipe_with(map, numbers).c_str());
      REQUIRE(recipe.stages == 1);
      std::mt19937 random(3);
      const Diffusion after(recipe, 3);
      size_t moved = 0;
      for (uint8_t i = 0; i < recipe.stage[0].model->planes(recipe.stage[0].number); ++i) {
        std::vector<int16_t> before;
        for (int k = 0; k < Diffusion::kWidth * Diffusion::kHeight; ++k)
          before.push_back(static_cast<int16_t>(random() % 3 * 8000));
        const std::vector<int16_t> now = after.plane(i);
        INFO(map << " " << numbers << " plane " << int(i));
        CHECK(std::accumulate(now.begin(), now.end(), int64_t{0}) ==
              std::accumulate(before.begin(), before.end(), int64_t{0}));
        CHECK(*std::min_element(now.begin(), now.end()) >= 0);
        CHECK(*std::max_element(now.begin(), now.end()) <= 16000);
        moved += now != before;
      }
      CHECK(moved > 0);
    }
}

TEST_CASE("mapped: the stages of a direction share out its variance, with weights of at most a quarter") {
  for (int32_t across = 1; across < 1700; across = across * 3 / 2 + 1)
    for (int32_t along = across; along < 1700; along = along * 3 / 2 + 1)
      for (const bool turned : {false, true}) {
        const stencil::Tensor axes = {(turned ? across : along) * 65536 / 10, 0,
                                      (turned ? along : across) * 65536 / 10};
        const stencil::Spread p = stencil::spread_of(axes);
        CHECK(p.slope <= stencil::kMostSlope);
        CHECK(p.mean + p.slope <= stencil::kMostShare + 1);
        for (uint8_t way = 0; way < stencil::kWays; ++way) {
          const uint8_t stages = stencil::stages_of(p, way);
          CHECK(stages <= stencil::kLargestStride);
          for (uint8_t stage = 0; stage < stages; ++stage) {
            const int32_t stride = stencil::stride_of(stage);
            CHECK(stencil::share_before(p, stage + 1) - stencil::share_before(p, stage) ==
                  stride * stride * (p.unit / 2));
            CHECK(stride * stride * (p.unit / 2) <= 32767);
          }
        }
      }
}

TEST_CASE("mapped: the same bytes without kept directions, whatever the slices and bands") {
  for (const char* map : kMaps)
    for (const char* numbers :
         {"scale=1.3 stretch=3 pairs=2 rho=0.02 angles=10,-31 steps=3",
          "scale=2 stretch=1 ratio=1.4 steps=2 detail=0.4", "scale=1.5 stretch=2.4 steps=5 levels=2 fine=2"}) {
      const dapple::Recipe kept = tests::recipe_of(recipe_with(map, numbers).c_str());
      const dapple::Recipe lean = tests::recipe_of((recipe_with(map, numbers) + " solver=lean").c_str());
      const dapple::Domain domain = dapple::torus(58, 42, -18, 6);
      Grown plain(kept, domain, 11);
      REQUIRE(plain.status == dapple::ok);
      CHECK(plain.texture.rows_done() == plain.texture.rows_in_all());
      dapple::Options options;
      INFO(map << " " << numbers);
      for (const uint8_t bands : {1, 2, 5}) {
        options.bands = bands;
        CHECK(Grown(kept, domain, 11, 3, options).field() == plain.field());
        CHECK(Grown(lean, domain, 11, 7, options).field() == plain.field());
      }
      CHECK(dapple::need_for(kept, domain).planes - dapple::need_for(lean, domain).planes ==
            58u * 42u * 2u * (std::string(map) == "two-angle" ? 2 : 1));
    }
}

TEST_CASE("mapped: windows of the plane are parts of each other") {
  for (const char* map : kMaps) {
    const dapple::Recipe recipe = tests::recipe_of(recipe_with(map, "scale=1 stretch=2 steps=3").c_str());
    Grown whole(recipe, dapple::window(200, -90, 120, 100), 5), part(recipe, dapple::window(247, -33, 30, 41), 5);
    REQUIRE(whole.status == dapple::ok);
    REQUIRE(part.status == dapple::ok);
    const std::vector<int16_t> all = whole.field(), some = part.field();
    size_t wrong = 0;
    for (size_t y = 0; y < 41; ++y)
      for (size_t x = 0; x < 30; ++x) wrong += some[30 * y + x] != all[120 * (y + 57) + x + 47];
    INFO(map);
    CHECK(wrong == 0);
  }
}

TEST_CASE(
    "mapped: an image of one direction is a constant map, byte for byte; of a coarse one the cells between are "
    "interpolated") {
  const dapple::Domain domain = dapple::torus(52, 44, 8, -12);
  const char* numbers = " scale=1.5 stretch=3 pairs=2 rho=0.02 steps=4 ";
  for (const char* solver : {"solver=flux", "solver=lean", "levels=2 fine=1"}) {
    std::vector<int8_t> pairs;
    for (int i = 0; i < 5 * 3; ++i) pairs.insert(pairs.end(), {127, 0});
    const dapple::PlaceMaps maps = {{pairs.data(), 5, 3}, {}};
    dapple::Recipe mapped = tests::recipe_of((recipe_with("image", numbers) + solver).c_str());
    set_maps(mapped, maps);
    Grown have(mapped, domain, 4), want(tests::recipe_of((recipe_with("none", numbers) + solver).c_str()), domain, 4);
    REQUIRE(have.status == dapple::ok);
    CHECK(have.field() == want.field());
  }
  const int8_t two[] = {127, 0, 0, 127};  // 0 and 45 degrees: halfway lies 22.5 degrees, as long as either
  stencil::DirectionMap map{};
  map.kind = stencil::DirectionMap::image;
  map.width = map.height = map.rows = 128;
  const dapple::PlaceMaps maps = {{two, 2, 1}, {}};
  stencil::set_images(map, &maps);
  int16_t row[128];
  stencil::map_row(map, 0, 77, 128, row);
  CHECK((row[32] & 255) >= 126);
  CHECK((row[96] >> 8) >= 126);
  CHECK(std::abs((row[64] & 255) - 90) <= 2);
  CHECK(std::abs((row[64] >> 8) - 90) <= 2);
}

namespace {

// 2 x 1 styles: the left half and the right one.
std::vector<int16_t> styled(const char* text, const std::vector<uint8_t>& cells, uint32_t budget = UINT32_MAX,
                            uint8_t bands = 1) {
  dapple::Recipe recipe = tests::recipe_of((std::string(text) + " solver=styled").c_str());
  const dapple::PlaceMaps maps = {{}, {cells.data(), 2, 1}};
  set_maps(recipe, maps);
  dapple::Options options;
  options.bands = bands;
  Grown tile(recipe, dapple::torus(128, 96), 6, budget, options);
  CHECK(tile.status == dapple::ok);
  return tile.field();
}

// Changes of sign down the columns of a quarter of the tile around column x.
int changes(const std::vector<int16_t>& field, size_t x) {
  int count = 0;
  for (size_t column = x - 16; column < x + 16; ++column)
    for (size_t y = 1; y < 96; ++y) count += (field[128 * y + column] > 0) != (field[128 * (y - 1) + column] > 0);
  return count;
}
int above(const std::vector<int16_t>& field, size_t x) {
  int count = 0;
  for (size_t i = 0; i < field.size(); ++i) count += i % 128 >= x - 16 && i % 128 < x + 16 && field[i] > 0;
  return count;
}

}  // namespace

TEST_CASE("mapped: styles change wavelength, rho and k over the tile; the recipe's own change nothing") {
  const char* stripes = "mapped map=none scale=2.5 stretch=2 steps=20";
  const std::vector<int16_t> plain = Grown(tests::recipe_of(stripes), dapple::torus(128, 96), 6).field();
  CHECK(styled(stripes, {255, 128, 255, 255, 128, 255}) == plain);
  CHECK(
      styled("mapped map=radial pairs=3 scale=1.5 steps=3 levels=2 fine=1", {255, 128, 255, 255, 128, 255}) ==
      Grown(tests::recipe_of("mapped map=radial pairs=3 scale=1.5 steps=3 levels=2 fine=1"), dapple::torus(128, 96), 6)
          .field());
  const std::vector<uint8_t> shorter = {255, 128, 255, 128, 128, 255}, sparser = {255, 128, 255, 255, 168, 255},
                             weaker = {255, 128, 255, 255, 128, 0};
  const std::vector<int16_t> waves = styled(stripes, shorter);
  CHECK(changes(waves, 96) > 14 * changes(waves, 32) / 10);
  CHECK(changes(waves, 96) < 26 * changes(waves, 32) / 10);
  CHECK(styled(stripes, shorter, 3, 4) == waves);
  const std::vector<int16_t> threads = styled(stripes, sparser);
  CHECK(above(threads, 96) < above(threads, 32) * 9 / 10);
  const std::vector<int16_t> faded = styled(stripes, weaker);
  const auto strongest = [&](size_t x) {
    int16_t most = 0;
    for (size_t y = 0; y < 96; ++y) most = std::max(most, faded[128 * y + x]);
    return most;
  };
  CHECK(strongest(96) < strongest(32) / 4);
}

TEST_CASE("mapped: begin refuses styles that are missing, of a wrong size, or for four pairs") {
  const uint8_t cell[3] = {255, 128, 255};
  const auto status = [&](const char* text, const dapple::StyleImage& image) {
    dapple::Recipe recipe = tests::recipe_of(text);
    const dapple::PlaceMaps maps = {{}, image};
    set_maps(recipe, maps);
    return dapple::need_for(recipe, dapple::torus(64, 64)).status;
  };
  CHECK(dapple::need_for(tests::recipe_of("mapped solver=styled"), dapple::torus(64, 64)).status == dapple::bad_map);
  CHECK(status("mapped solver=styled", {nullptr, 1, 1}) == dapple::bad_map);
  CHECK(status("mapped solver=styled", {cell, 257, 1}) == dapple::bad_map);
  CHECK(status("mapped solver=styled map=image", {cell, 1, 1}) == dapple::bad_map);
  CHECK(status("mapped solver=styled pairs=4", {cell, 1, 1}) == dapple::bad_map);
  CHECK(status("mapped solver=styled pairs=3", {cell, 1, 1}) == dapple::ok);
}

TEST_CASE("mapped: begin refuses an image that is missing or of a wrong size") {
  dapple::Recipe recipe = tests::recipe_of("mapped map=image");
  const int8_t pair[2] = {127, 0};
  const auto status = [&](const dapple::DirectionImage& image) {
    const dapple::PlaceMaps maps = {image, {}};
    set_maps(recipe, maps);
    return dapple::need_for(recipe, dapple::torus(64, 64)).status;
  };
  CHECK(dapple::need_for(recipe, dapple::torus(64, 64)).status == dapple::bad_map);
  CHECK(status({nullptr, 4, 4}) == dapple::bad_map);
  CHECK(status({pair, 0, 4}) == dapple::bad_map);
  CHECK(status({pair, 4, 257}) == dapple::bad_map);
  CHECK(status({pair, 1, 1}) == dapple::ok);
}

TEST_CASE("mapped: maps differ, and are what their formulas say at a few places") {
  std::vector<std::vector<int16_t>> fields;
  for (const char* map : kMaps) {
    Grown tile(tests::recipe_of(recipe_with(map, "scale=1.5 stretch=2.5 steps=4").c_str()), dapple::torus(64, 64), 1);
    REQUIRE(tile.status == dapple::ok);
    for (const std::vector<int16_t>& other : fields) CHECK(tile.field() != other);
    fields.push_back(tile.field());
  }
  stencil::DirectionMap radial{};
  radial.kind = stencil::DirectionMap::radial;
  radial.width = radial.height = radial.rows = 256;
  int16_t row[256];
  const auto c2 = [&](int x) { return static_cast<int8_t>(row[x] & 255); };
  const auto s2 = [&](int x) { return row[x] >> 8; };
  stencil::map_row(radial, 0, 128, 256, row);  // half a cell below the centre
  CHECK(c2(192) == 127);
  CHECK(s2(128) == 127);
  stencil::map_row(radial, 0, 192, 256, row);
  CHECK(c2(128) == -127);
  CHECK(std::abs(c2(192)) <= 1);
  CHECK(s2(192) == 127);
}
