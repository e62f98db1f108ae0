// Kernels by name. DAPPLE_HAS_DESKTOP: ports/desktop is there; without it there are the portable ones.
// SPDX-License-Identifier: MIT
#include "kernels.hpp"

#include "errors.hpp"

#ifdef DAPPLE_HAS_DESKTOP
#include "driver.hpp"
#include "growers.hpp"
#include "ready.hpp"
#include "tables.hpp"
#endif

namespace cli {

#ifdef DAPPLE_HAS_DESKTOP
using namespace dapple::desktop;

std::vector<std::string> kernel_names() {
  std::vector<std::string> names;
  for (uint8_t i = 0; i < table_count(); ++i)
    if (table_at(i).runs()) names.push_back(table_at(i).name);
  return names;
}

Kernels best_kernels() { return best_table().kernels; }

Kernels kernels_named(const std::string& name) {
  if (name == "best") return best_kernels();
  const Table* const table = table_named(name.c_str());
  if (table != nullptr && table->runs()) return table->kernels;
  std::vector<std::string> names = kernel_names();
  names.insert(names.begin(), "best");
  refuse("--kernels " + shown(name) + ": give one of " + listed(names) +
         (table != nullptr ? "; this processor does not have the others" : ""));
}
std::shared_ptr<dapple::evolve::Driver> driver_of(uint8_t threads) { return std::make_shared<Driver>(threads); }

std::shared_ptr<const dapple::Recipe> ready_of(const dapple::Recipe& recipe) {
  const auto ready = std::make_shared<Ready>(recipe);
  return {ready, &ready->recipe()};
}

std::function<uint32_t(uint32_t)> growers_of(dapple::Chunks& chunks, uint8_t threads) {
  const auto growers = std::make_shared<Growers>(threads);
  growers->begin(chunks);
  return [growers](uint32_t most) { return growers->grow(most); };
}
#else
std::vector<std::string> kernel_names() { return {"portable"}; }

Kernels best_kernels() { return nullptr; }

Kernels kernels_named(const std::string& name) {
  if (name == "best" || name == "portable") return nullptr;
  refuse("--kernels " + shown(name) + ": give one of " + listed({"best", "portable"}));
}

std::shared_ptr<dapple::evolve::Driver> driver_of(uint8_t) { return nullptr; }

std::shared_ptr<const dapple::Recipe> ready_of(const dapple::Recipe& recipe) {
  return std::make_shared<dapple::Recipe>(recipe);
}

std::function<uint32_t(uint32_t)> growers_of(dapple::Chunks& chunks, uint8_t) {
  return [&chunks](uint32_t most) {
    const uint32_t before = chunks.counters().grown;
    while (chunks.counters().grown - before < most && chunks.step(1024) == dapple::more) {
    }
    return chunks.counters().grown - before;
  };
}
#endif

}  // namespace cli
