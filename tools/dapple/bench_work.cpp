// The pieces of work of dapple bench. See bench_work.hpp.
// SPDX-License-Identifier: MIT
#include "bench_work.hpp"

#include "recipes.hpp"

#ifdef DAPPLE_HAS_DESKTOP
#include "fused.hpp"
#endif

namespace cli::measure {

using dapple::Domain;
using dapple::Recipe;

uint64_t hashed(uint64_t hash, const void* bytes, size_t count) {
  for (size_t i = 0; i < count; ++i) hash = (hash ^ static_cast<const uint8_t*>(bytes)[i]) * UINT64_C(0x100000001b3);
  return hash;
}
constexpr uint64_t kFnv = UINT64_C(0xcbf29ce484222325);

static Recipe recipe_of(const std::string& text, const std::string& changes) {
  Options options;
  options.subject = text;
  if (!changes.empty()) options.changes.push_back(changes);
  return subject_of(options).recipe;
}

// --- a pass of one plane of 256 x 256 through the sweep machinery
// --------------------------------------------------------

namespace {

struct Plane {
  static constexpr uint16_t kSide = 256;
  std::vector<int16_t> cells = std::vector<int16_t>(kSide * kSide);
  std::vector<uint8_t> scratch = std::vector<uint8_t>(64 * 1024);
  dapple::evolve::Band band{};
  dapple::evolve::Field field() {
    return {reinterpret_cast<uint8_t*>(cells.data()),
            kSide * kSide * 2,
            kSide * 2,
            scratch.data(),
            scratch.size(),
            kSide,
            kSide,
            dapple::grid::Cell::int16,
            1};
  }
};

dapple::evolve::Sweep pass_sweep(Kernels kernels, int32_t vx, uint16_t vy, uint16_t stride, int16_t weight) {
  dapple::evolve::Sweep s{};
  s.row = dapple::grid::choose(kernels, dapple::stencil::pass_row);
  s.count = s.radius = 1;
  s.stride = static_cast<uint16_t>(vy * stride);
  s.halo = static_cast<uint16_t>(stride * (vx < 0 ? -vx : vx));
  s.p[0] = vx * stride;
  s.p[1] = weight;
  s.p[2] = dapple::base::rounding_for(weight);
  return s;
}

// So many times the same pass, which is not what a step does, but all of it is of one direction.
using Passes = std::function<void(Plane& plane, const dapple::evolve::Sweep& sweep, int times)>;

void by_sweeps(Plane& plane, const dapple::evolve::Sweep& sweep, int times) {
  const dapple::evolve::Field field = plane.field();
  for (int i = 0; i < times; ++i) {
    dapple::evolve::begin_sweep(field, sweep, &plane.band);
    dapple::evolve::run_band(field, sweep, nullptr, 0, plane.band, UINT32_MAX);
  }
}

Work pass(const std::string& name, int32_t vx, uint16_t vy, uint16_t stride, int16_t weight,
          const Passes& passes = by_sweeps) {
  constexpr int kTimes = 40;
  const bool askew = vx != 0;
  return {name, "Gcell-pass/s", kTimes * 65536.0, 2, askew ? 1.0 : 3.0, askew ? 2.0 : 0.0, 0, [=](Kernels kernels) {
            const auto plane = std::make_shared<Plane>();
            const dapple::evolve::Sweep sweep = pass_sweep(kernels, vx, vy, stride, weight);
            return [plane, sweep, passes]() -> Done {
              for (size_t i = 0; i < plane->cells.size(); ++i)
                plane->cells[i] = static_cast<int16_t>(i * 40503 % 16000);
              const double start = thread_seconds();
              passes(*plane, sweep, kTimes);
              return {thread_seconds() - start, hashed(kFnv, plane->cells.data(), plane->cells.size() * 2)};
            };
          }};
}

#ifdef DAPPLE_HAS_DESKTOP
// As the driver of ports/desktop does them: passes of a plane one after the other in cache, copies to and fro included.
Work fused(const char* name, int32_t vx, uint16_t vy, uint16_t stride, int16_t weight) {
  const auto work = std::make_shared<dapple::desktop::Fused>();
  return pass(std::string(name) + ", driver", vx, vy, stride, weight,
              [work](Plane& plane, const dapple::evolve::Sweep& sweep, int times) {
                const std::vector<dapple::evolve::Sweep> sweeps(static_cast<size_t>(times), sweep);
                work->run(plane.field(), {sweeps.data(), sweeps.size(), true, true, nullptr, nullptr});
              });
}
#endif

// --- textures
// -----------------------------------------------------------------------------------------------------------

struct Grower {
  Recipe recipe;
  Domain domain;
  std::vector<uint8_t> memory;
  std::shared_ptr<dapple::evolve::Driver> driver;
  dapple::Options options;
  dapple::Texture texture;

  Grower(const Recipe& r, Domain d, Kernels kernels)
      : recipe(r), domain(d), memory(dapple::bytes_for(r, d)), driver(driver_of(1)) {
    options.kernels = kernels;
    options.driver = driver.get();
  }
  void begin() { texture.begin(recipe, domain, 1337, memory.data(), memory.size(), options); }
  uint64_t rows_of_start() const {
    const dapple::Stage& first = recipe.stage[0];
    const dapple::Need need = dapple::need_for(recipe, domain);
    return uint64_t{first.model->planes(first.number)} * (dapple::api::ground_of(domain, need).height >> first.level);
  }
  uint64_t hash() {
    std::vector<int16_t> row(domain.width);
    uint64_t hash = kFnv;
    for (uint16_t y = 0; y < domain.height; ++y) {
      texture.row(y, row.data());
      hash = hashed(hash, row.data(), row.size() * 2);
    }
    return hash;
  }
};

// Steps of a texture, its start left out; of mapped ones sweeps, each over all planes.
Work steps(const std::string& name, const std::string& recipe, const std::string& changes, uint16_t side, double bytes,
           double aligned = 0, double askew = 0, double operations = 0) {
  const Recipe r = recipe_of(recipe, changes);
  const dapple::Stage& s = r.stage[0];
  const bool mapped = s.model == &dapple::mapped_model;
  const double sweeps = mapped ? s.solver->reach(*s.model, s.number, s.level, s.stored).sweeps : 1;
  return {name, mapped ? "Gcell-sweep/s" : "Gcell/s", sweeps * steps_of(r) * side * side, bytes, aligned, askew, operations, [=](Kernels kernels) {
            const auto grower = std::make_shared<Grower>(r, dapple::torus(side, side), kernels);
            return [grower]() -> Done {
              grower->begin();
              grower->texture.step(static_cast<uint32_t>(grower->rows_of_start()));
              const double start = thread_seconds();
              grower->texture.finish();
              const double seconds = thread_seconds() - start;
              return {seconds, grower->hash()};
            };
          }};
}

// A window of the plane from nothing to its pixels, or to its field.
Work window(const std::string& name, const std::string& preset, const std::string& changes, uint16_t side,
            bool painted) {
  const Recipe r = recipe_of(preset, changes);
  const double amount = painted ? 1 : 1.0 * side * side;
  const auto ready = ready_of(r);  // of a plane masks are made once; the portable kernels are fastest as they are
  return {name, painted ? "chunks/s" : "Mpixel/s", amount, 0, 0, 0, 0, [=](Kernels kernels) {
            const Recipe& made = kernels == nullptr ? r : *ready;
            const auto grower = std::make_shared<Grower>(made, dapple::window(5000, -700, side, side), kernels);
            const auto pixels = std::make_shared<std::vector<uint8_t>>(4 * size_t{side} * side);
            return [grower, pixels, ready, side, painted]() -> Done {
              const double start = thread_seconds();
              grower->begin();
              grower->texture.finish();
              for (uint16_t y = 0; y < side; ++y) {
                uint8_t* const row = pixels->data() + size_t{2} * side * y;
                if (painted) grower->texture.paint(y, dapple::Pixels::rgb565, row);
                else grower->texture.row(y, reinterpret_cast<int16_t*>(row));
              }
              const double seconds = thread_seconds() - start;
              return {seconds, hashed(kFnv, pixels->data(), size_t{2} * side * side)};
            };
          }};
}

}  // namespace

std::vector<Work> all_work() {
  const std::string program = "cells rule=0xB5A3C96E";
  return {pass("pass (0,1)x2, a quarter", 0, 1, 2, 16384),
          pass("pass (1,1)x1, a quarter", 1, 1, 1, 16384),
          pass("pass (-1,2)x3, a weight", -1, 2, 3, 9000),
#ifdef DAPPLE_HAS_DESKTOP
          fused("pass (0,1)x2, a quarter", 0, 1, 2, 16384),
          fused("pass (1,1)x1, a quarter", 1, 1, 1, 16384),
          fused("pass (-1,2)x3, a weight", -1, 2, 3, 9000),
#endif
          steps("threshold zebra", "zebra", "steps=8", 256, 4),
          steps("threshold weave", "weave", "steps=4", 256, 8),
          steps("threshold zebra 2048", "zebra", "steps=2", 2048, 4),
          steps("mapped scalloped", "scalloped", "steps=2", 256, 6),
          steps("gray-scott", "mitosis", "steps=64", 256, 4, 6, 4),
          steps("gray-scott 1024", "mitosis", "steps=16", 1024, 4, 6, 4),
          steps("turing", "turing scale=11.3 decay=12.1", "steps=48", 256, 8, 12, 8),
          steps("turing varied", "turing scale=11.3 decay=12.1 vary=0.05", "steps=48", 256, 12, 14, 8),
          steps("meinhardt-spots", "meinhardt-spots scale=3.162278", "steps=32", 256, 8, 12, 8),
          steps("fitzhugh-nagumo", "fitzhugh-nagumo", "steps=48", 256, 4, 6, 4),
          steps("convolution zebra-bits", "zebra-bits", "level=0 steps=20", 256, .125),
          steps("convolution labyrinth-bits", "labyrinth-bits", "level=0 steps=20", 256, .125),
          steps("convolution weave-bits", "weave-bits", "level=0 steps=10", 256, .125),
          steps("convolution coral-bits", "coral-bits", "level=0 steps=10", 256, .125),
          steps("steered fingerprint", "fingerprint", "level=0 steps=4", 256, .125),
          steps("cell program 512", program, "steps=256", 512, .125, 0, 0, 72),
          steps("cell program 2048", program, "steps=32", 2048, .125, 0, 0, 72),
          window("plane 128 zebra-bits, field", "zebra-bits", "steps=8", 128, false),
          window("plane 128 zebra-bits, painted", "zebra-bits", "steps=8", 128, true),
          window("plane 256 zebra-bits, field", "zebra-bits", "steps=8", 256, false),
          window("plane 256 coral-bits, field", "coral-bits", "", 256, false)};
}

}  // namespace cli::measure
