// The explicit kinetics in integers against float64, written from the equations (docs/numbers.md, "Kinetics"): from the
// library's start, wavelength within 2 %, spots within 3 % or two, fill within .01.
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "reference.hpp"

using reference::Grid;
using reference::Plane;
namespace kinetics = dapple::kinetics;

namespace {

constexpr Grid kGrid = {128, 128};

// A recipe's numbers by slot, as they are meant.
struct Numbers {
  double value[dapple::kMaxNumbers];
  explicit Numbers(const dapple::Recipe& recipe) {
    for (uint8_t i = 0; i < dapple::kMaxNumbers; ++i) value[i] = recipe.stage[0].number[i] / 1e6;
  }
  double operator[](int slot) const { return value[slot]; }
};

// What a model is in float64: D of every plane and dc/dt of the reaction at a time.
struct Kinetics {
  std::vector<double> diffusion, most;  // cells stay in 0..most, or -most..most
  bool signs;
  void (*react)(const Numbers& n, double time, const double* c, double* rate);
};

double speed(const Numbers& n) { return 1 / (n[kinetics::scale] * n[kinetics::scale]); }

void turing(const Numbers& n, double, const double* c, double* rate) {
  namespace slot = dapple::turing;
  rate[0] = speed(n) * (n[slot::growth] - c[0] * c[1]);
  rate[1] = speed(n) * (c[0] * c[1] - c[1] - n[slot::decay]);
}
void spots(const Numbers& n, double, const double* c, double* rate) {
  namespace slot = dapple::meinhardt_spots;
  const double made = 0.01 * c[0] * c[0];
  rate[0] = speed(n) * (made / std::max(c[1], 1.0 / 1024) - n[slot::decay] * c[0] + n[slot::base_rate]);
  rate[1] = speed(n) * (made - n[slot::drain] * c[1] + n[slot::base_rate]);
}
void stripes(const Numbers& n, double, const double* c, double* rate) {
  namespace slot = dapple::meinhardt_stripes;
  const double by_a = 0.01 * c[0] * c[0] * c[4], by_b = 0.01 * c[1] * c[1] * c[3], third = std::max(c[2], 1.0 / 32);
  rate[0] = speed(n) * (by_a / third - n[slot::decay] * c[0]);
  rate[1] = speed(n) * (by_b / third - n[slot::decay] * c[1]);
  rate[2] = speed(n) * (by_a + by_b - n[slot::drain] * c[2]);
  rate[3] = speed(n) * n[slot::relax] * (c[0] - c[3]);
  rate[4] = speed(n) * n[slot::relax] * (c[1] - c[4]);
}
void fitzhugh(const Numbers& n, double, const double* c, double* rate) {
  namespace slot = dapple::fitzhugh_nagumo;
  rate[0] = c[0] - c[0] * c[0] * c[0] - c[1];
  rate[1] = n[slot::slow] * (c[0] - n[slot::couple] * c[1] - n[slot::bias]);
}
void schnakenberg(const Numbers& n, double, const double* c, double* rate) {
  namespace slot = dapple::schnakenberg;
  rate[0] = speed(n) * (n[slot::feed] - c[0] + c[0] * c[0] * c[1]);
  rate[1] = speed(n) * (n[slot::supply] - c[0] * c[0] * c[1]);
}
void brusselator(const Numbers& n, double time, const double* c, double* rate) {
  namespace slot = dapple::brusselator;
  const double square = c[0] * c[0] * c[1];
  rate[0] =
      n[slot::feed] - (n[slot::decay] + 1) * c[0] + (1 + n[slot::force] * std::cos(n[slot::pace] * time)) * square;
  rate[1] = n[slot::decay] * c[0] - square;
}

Kinetics kinetics_of(const dapple::Model* model, const Numbers& n) {
  const double square = n[kinetics::scale] * n[kinetics::scale];
  if (model == &dapple::turing_model)
    return {{n[dapple::turing::spread], n[dapple::turing::spread] / n[dapple::turing::ratio]}, {20, 14}, false, turing};
  if (model == &dapple::meinhardt_spots_model)
    return {{n[dapple::meinhardt_spots::spread], n[dapple::meinhardt_spots::reach]}, {8, 8}, false, spots};
  if (model == &dapple::meinhardt_stripes_model)
    return {{n[dapple::meinhardt_stripes::spread], n[dapple::meinhardt_stripes::spread], 0,
             n[dapple::meinhardt_stripes::reach], n[dapple::meinhardt_stripes::reach]},
            {2, 2, 2, 2, 2},
            false,
            stripes};
  if (model == &dapple::fitzhugh_nagumo_model)
    return {{n[dapple::fitzhugh_nagumo::spread] * square, n[dapple::fitzhugh_nagumo::reach] * square},
            {2, 2},
            true,
            fitzhugh};
  if (model == &dapple::schnakenberg_model)
    return {{n[dapple::schnakenberg::spread], n[dapple::schnakenberg::reach]}, {6, 4}, false, schnakenberg};
  return {{square, square * n[dapple::brusselator::delta]}, {6, 8}, false, brusselator};
}

// The library's start, its cells as concentrations.
template <class T>
std::vector<Plane> start_in(const dapple::Recipe& recipe, dapple::grid::Cell cell, double unit) {
  const dapple::Model& model = *recipe.stage[0].model;
  const uint16_t width = static_cast<uint16_t>(kGrid.width), height = static_cast<uint16_t>(kGrid.height);
  const dapple::start::Place place = {cell, width, height, 0, 0, 0, false, 1};
  std::vector<Plane> planes(model.planes(recipe.stage[0].number));
  std::vector<T> row(width);
  for (uint8_t i = 0; i < planes.size(); ++i)
    for (uint16_t y = 0; y < height; ++y) {
      recipe.start.row(place, recipe.start, model.levels(recipe.stage[0].number, i), i, y, row.data());
      for (const T v : row) planes[i].push_back(v / unit);
    }
  return planes;
}

double laplacian(const Plane& c, size_t x, size_t y) {
  const size_t w = static_cast<size_t>(kGrid.width), h = static_cast<size_t>(kGrid.height), row = y * w;
  return c[row + (x + 1) % w] + c[row + (x + w - 1) % w] + c[(y + 1) % h * w + x] + c[(y + h - 1) % h * w + x] -
         4 * c[row + x];
}

// Along a map: what the links of a cell to eight neighbours weigh, the means of the weights of both.
struct Links {
  double weight[8];
};
constexpr int kTo[8][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}};
size_t neighbour(size_t at, int k) {
  const size_t w = static_cast<size_t>(kGrid.width), h = static_cast<size_t>(kGrid.height);
  return (at / w + h + static_cast<size_t>(kTo[k][1])) % h * w + (at % w + w + static_cast<size_t>(kTo[k][0])) % w;
}
// D = R diag(1, 1 / stretch^2) R^T by Dxx - |Dxy|, Dyy - |Dxy| and |Dxy|; the map's vector may be shorter than 1.
std::vector<Links> links_of(const dapple::Recipe& recipe) {
  const int32_t* const number = recipe.stage[0].number;
  std::vector<Links> own, links;
  if (number[dapple::along::map] == dapple::mapped::none) return links;
  const double q = std::pow(number[kinetics::stretch] / 1e6, -2), turn = number[kinetics::angle] / 1e6 * M_PI / 90;
  for (int y = 0; y < kGrid.height; ++y)
    for (int x = 0; x < kGrid.width; ++x) {
      const double u = (x + 0.5) / kGrid.width, v = (y + 0.5) / kGrid.height;
      const reference::Vector p =
          reference::map_at(number[dapple::along::map], number[dapple::along::detail] / 1e6, u, v, 0);
      const double xx = (1 + q) / 2 + (1 - q) / 2 * (p.c * std::cos(turn) - p.s * std::sin(turn)), yy = 1 + q - xx,
                   xy = (1 - q) / 2 * (p.s * std::cos(turn) + p.c * std::sin(turn)), beside = std::fabs(xy);
      const double fall = std::max(xy, 0.0), rise = std::max(-xy, 0.0);
      own.push_back({{xx - beside, xx - beside, yy - beside, yy - beside, fall, fall, rise, rise}});
    }
  links = own;
  for (size_t at = 0; at < own.size(); ++at)
    for (int k = 0; k < 8; ++k) links[at].weight[k] = (own[at].weight[k] + own[neighbour(at, k)].weight[k]) / 2;
  return links;
}

// Where the wavelength differs from place to place: the square of its share; diffusion goes with it.
std::vector<double> shares_of(const dapple::Recipe& recipe) {
  namespace along = dapple::along;
  const int32_t grade = recipe.stage[0].number[along::grade];
  const double finest = recipe.stage[0].number[along::finest] / 1e6;
  std::vector<double> shares(static_cast<size_t>(kGrid.width * kGrid.height), 1);
  for (size_t at = 0; at < shares.size() && grade != along::none; ++at) {
    const size_t w = static_cast<size_t>(kGrid.width);
    const double u = (double(at % w) + 0.5) / kGrid.width, v = (double(at / w) + 0.5) / kGrid.height;
    const double across = (1 + std::cos(2 * M_PI * u)) / 2, down = (1 + std::cos(2 * M_PI * v)) / 2;
    const double part = grade == along::across ? across : grade == along::down ? down : (across + down) / 2;
    shares[at] = std::pow(finest + (1 - finest) * part, 2);
  }
  return shares;
}

double divergence(const Plane& c, const Links& links, size_t at) {
  double sum = 0;
  for (int k = 0; k < 8; ++k) sum += links.weight[k] * (c[neighbour(at, k)] - c[at]);
  return sum;
}

void step(const Kinetics& k, const Numbers& n, const std::vector<Links>& links, const std::vector<double>& shares,
          double time, std::vector<Plane>& planes) {
  const std::vector<Plane> old = planes;
  const size_t w = static_cast<size_t>(kGrid.width);
  double cell[5], rate[5];
  for (size_t at = 0; at < old[0].size(); ++at) {
    for (size_t i = 0; i < old.size(); ++i) cell[i] = old[i][at];
    k.react(n, time, cell, rate);
    for (size_t i = 0; i < old.size(); ++i) {
      const double lap = k.diffusion[i] == 0 ? 0
                         : links.empty()     ? laplacian(old[i], at % w, at / w)
                                             : divergence(old[i], links[at], at);
      planes[i][at] =
          std::clamp(cell[i] + n[kinetics::dt] * (rate[i] + shares[at] * k.diffusion[i] * lap), k.signs ? -k.most[i] : 0, k.most[i]);
    }
  }
}

// Connected places above half of the range, four neighbours, on the torus.
int spots_in(const Plane& field) {
  const auto [low, high] = std::minmax_element(field.begin(), field.end());
  const double level = (*low + *high) / 2;
  std::vector<bool> seen(field.size());
  std::vector<size_t> open;
  const size_t w = static_cast<size_t>(kGrid.width), h = static_cast<size_t>(kGrid.height);
  int count = 0;
  for (size_t first = 0; first < field.size(); ++first) {
    if (seen[first] || field[first] <= level) continue;
    ++count;
    seen[first] = true;
    open.push_back(first);
    while (!open.empty()) {
      const size_t x = open.back() % w, row = open.back() / w * w;
      open.pop_back();
      for (const size_t next :
           {row + (x + 1) % w, row + (x + w - 1) % w, (row + w) % (w * h) + x, (row + w * h - w) % (w * h) + x})
        if (!seen[next] && field[next] > level) {
          seen[next] = true;
          open.push_back(next);
        }
    }
  }
  return count;
}

struct Case {
  const char* text;
  bool counts;  // its spots are worth counting
};
constexpr Case kCases[] = {
    {"turing scale=11.3137 decay=12.25 steps=2400", true},
    {"turing scale=18.257 decay=12.25 steps=6000", true},
    {"turing scale=11.3137 decay=19.8 growth=24.5 show=b above=6 steps=2000", false},
    {"meinhardt-spots scale=2.236 steps=3400", true},
    {"meinhardt-spots scale=1.58 base=0.004 steps=2000", true},
    {"meinhardt-stripes spread=0.009 reach=0.2 steps=3000", false},
    {"meinhardt-stripes spread=0.04 reach=0.24 steps=2000", false},
    {"fitzhugh-nagumo steps=2000", false},
    {"fitzhugh-nagumo bias=-0.15 above=0 steps=2000", true},
    {"schnakenberg above=1.1 steps=6000", false},
    {"brusselator start=phases pitch=32 delta=0 force=0.1 above=0.5 steps=2000", false},
    {"brusselator start=phases pitch=32 delta=5 dt=0.04 force=0.15 above=0.285 steps=1000", false},
    {"turing map=radial detail=0.2 stretch=2 scale=11.3137 decay=12.25 steps=2400", true},
    {"turing map=haunch angle=20 stretch=2.414 scale=11.3137 decay=12.25 steps=2400", true},
    {"meinhardt-spots map=scallop detail=0.5 stretch=1.7 scale=2.236 steps=3400", true},
    {"fitzhugh-nagumo map=two-angle stretch=2 steps=2000", false},
    {"turing grade=centre finest=0.5 scale=16 decay=12.25 steps=5000", true},
    {"fitzhugh-nagumo grade=across finest=0.4 scale=1.4 dt=0.06 stretch=2 map=haunch steps=2500", false},
};

}  // namespace

TEST_CASE("reference: kinetics in float64") {
  for (const Case& c : kCases) {
    const dapple::Recipe recipe = tests::recipe_of(c.text);
    REQUIRE_MESSAGE(recipe.stages == 1, c.text);
    const Numbers n(recipe);
    const Kinetics k = kinetics_of(recipe.stage[0].model, n);
    const bool wide = recipe.stage[0].model->cell == dapple::grid::Cell::int32;
    std::vector<Plane> planes = wide ? start_in<int32_t>(recipe, dapple::grid::Cell::int32, 1 << 20)
                                     : start_in<int16_t>(recipe, dapple::grid::Cell::int16, 1 << 14);
    const std::vector<Links> links = links_of(recipe);
    const std::vector<double> shares = shares_of(recipe);
    for (uint32_t i = 0; i < recipe.stage[0].steps; ++i) step(k, n, links, shares, i * n[kinetics::dt], planes);
    const Plane& want = planes[static_cast<size_t>(recipe.stage[0].number[kinetics::show])];
    Plane have = library_field(recipe, kGrid, 1);
    for (double& v : have) v /= recipe.stage[0].model->unit;
    const double level = n[kinetics::above];
    const reference::Figures f = measure(want, kGrid, level);
    const reference::Distance d = distance(have, want, kGrid, level, level);
    const int spots = spots_in(want), found = spots_in(have);
    const auto [low, high] = std::minmax_element(want.begin(), want.end());
    std::printf("%-75s %.2f..%.2f wavelength %5.2f %+5.2f %%  fill %.3f %+.4f  spots %3d %+3d  agreement %.4f\n",
                c.text, *low, *high, f.wavelength, 100 * d.wavelength, f.fill, d.fill, spots, found - spots,
                d.agreement);
    INFO(c.text);
    REQUIRE((*low < level && level < *high));
    CHECK(d.agreement >= 0.98);
    CHECK(std::fabs(d.wavelength) <= 0.02);
    CHECK(std::fabs(d.fill) <= 0.01);
    if (c.counts) CHECK(std::abs(found - spots) <= std::max(2.0, 0.03 * spots));
  }
}

// Half of the memory, and the pattern of the same kind: often the same spots.
TEST_CASE("reference: compact cells against wide ones") {
  for (const char* text : {"turing decay=12.25 steps=2400", "turing scale=18.257 decay=12.25 steps=6000",
                           "turing decay=19.8 growth=24.5 show=b above=6 steps=2000", "meinhardt-spots steps=3400",
                           "meinhardt-spots scale=1.58 base=0.004 steps=2000"}) {
    const dapple::Recipe wide = tests::recipe_of(text), compact = tests::recipe_of((text + std::string(" cells=compact")).c_str());
    REQUIRE_MESSAGE(compact.stages == 1, text);
    Plane want = library_field(wide, kGrid, 1), have = library_field(compact, kGrid, 1);
    for (double& v : want) v /= wide.stage[0].model->unit;
    for (double& v : have) v /= compact.stage[0].model->unit;
    const double level = wide.stage[0].number[kinetics::above] / 1e6;
    const reference::Distance d = distance(have, want, kGrid, level, level);
    const int spots = spots_in(want), found = spots_in(have);
    std::printf("compact %-60s wavelength %+5.2f %%  fill %+.4f  spots %3d %+3d  agreement %.4f\n", text, 100 * d.wavelength,
                d.fill, spots, found - spots, d.agreement);
    INFO(text);
    CHECK(std::fabs(d.wavelength) <= 0.02);
    CHECK(std::fabs(d.fill) <= 0.01);
    CHECK(std::abs(found - spots) <= std::max(2.0, 0.03 * spots));
  }
}
