// Limits of this processor, measured where the bench runs. See bench_work.hpp.
// SPDX-License-Identifier: MIT
#include <cstring>
#include <memory>

#include "bench_work.hpp"

#ifdef DAPPLE_HAS_DESKTOP
#include "yardsticks.hpp"
#endif

namespace cli::measure {

// The least seconds of 25 runs.
static double least(const std::function<void()>& work) {
  return take_turns({[&] {
                      const double start = thread_seconds();
                      work();
                      return thread_seconds() - start;
                    }},
                    25)[0]
      .least;
}

double copied(size_t bytes) {
  const std::unique_ptr<uint8_t[]> a(new uint8_t[bytes]()), b(new uint8_t[bytes]());
  const size_t times = 1 + (size_t{8} << 20) / bytes;
  const double seconds = least([&] {
    for (size_t i = 0; i < times; ++i) {
      std::memcpy(a.get(), b.get(), bytes);
      b[i % bytes] = a[bytes - 1 - i % bytes];
    }
  });
  return 2.0 * static_cast<double>(bytes * times) / seconds;
}

#ifdef DAPPLE_HAS_DESKTOP
// Steps of a torus of 256 x 256 floats with halos, as a double buffer.
static double float_steps(const dapple::desktop::Yardsticks& y) {
  constexpr size_t kSide = 256, kRow = kSide + 16, kPlane = kRow * kSide;
  constexpr int kSteps = 20;
  std::vector<float> memory(4 * kPlane + 32, 0.3f);
  float* plane[4];
  for (size_t i = 0; i < 4; ++i) plane[i] = memory.data() + 16 + i * kPlane;
  const double seconds = least([&] {
    for (int step = 0; step < kSteps; ++step)
      for (size_t at = 0; at < kSide; ++at) {
        const size_t rows[3] = {(at + kSide - 1) % kSide * kRow, at * kRow, (at + 1) % kSide * kRow};
        const size_t from = step % 2 * 2u, to = 2 - from;
        const float *u[3], *v[3];
        for (size_t k = 0; k < 3; ++k) u[k] = plane[from] + rows[k], v[k] = plane[from + 1] + rows[k];
        y.float_gray_scott(u, v, plane[to] + rows[1], plane[to + 1] + rows[1], kSide);
        for (size_t i = to; i < to + 2; ++i) {
          float* const row = plane[i] + rows[1];
          row[-1] = row[kSide - 1];
          row[kSide] = row[0];
        }
      }
  });
  return kSteps * static_cast<double>(kSide * kSide) / seconds;
}

Limits limits_of(const std::string& table) {
  const dapple::desktop::Yardsticks* const y = dapple::desktop::yardsticks_of(table.c_str());
  if (y == nullptr) return {};
  constexpr size_t kCount = 1 << 16;
  std::vector<uint8_t> block(16 * 1024);
  uint8_t* const start = block.data() + (-reinterpret_cast<uintptr_t>(block.data()) & 63);
  volatile uint64_t sink = 0;
  const double aligned = least([&] { sink = sink + y->loads(start, kCount, 0); });
  const double askew = least([&] { sink = sink + y->loads(start, kCount, 2); });
  const double operations = least([&] { sink = sink + y->operations(kCount); });
  return {kCount / aligned, kCount / askew, kCount / operations, float_steps(*y), y->bytes};
}
#else
Limits limits_of(const std::string&) { return {}; }
#endif

}  // namespace cli::measure
