// Grows textures on several threads and with passes fused in cache: what Options::driver may point to. Same bytes.
//
//   dapple::desktop::Driver driver(2);
//   options.bands = 2;
//   options.driver = &driver;
//
// Sweeps over single planes go by plane, those along a way of a map plane by plane too, all others by bands, of which a
// texture has Options::bands. One texture at a time.
// SPDX-License-Identifier: MIT
#pragma once
#include "../../lib/evolve/run.hpp"
#include "crew.hpp"
#include "fluxed.hpp"
#include "fused.hpp"
#include "masks.hpp"

namespace dapple::desktop {

class Driver : public evolve::Driver {
 public:
  explicit Driver(unsigned threads);

  // Steps of one-bit cells and of kinetics that were left out so far, since steps of the same numbers before them had
  // changed no cell.
  uint64_t left_out() const { return left_out_; }

 private:
  uint32_t whole_step(evolve::Run& run, uint32_t rows);
  uint32_t many_steps(evolve::Run& run, uint32_t rows);
  uint32_t many_at_once(evolve::Run& run);  // how many they are, if they change nothing
  // Threads there is scratch memory for.
  unsigned hands(const evolve::Run& run) const {
    return crew_.size() < run.field.bands ? crew_.size() : run.field.bands;
  }
  size_t passes_from(const evolve::Run& run, size_t at) const;
  void by_plane(const evolve::Run& run, size_t from, size_t to);
  size_t way_from(const evolve::Run& run, size_t from) const;
  void make_pulls(const evolve::Run& run, int32_t way, uint16_t halo);
  void by_way(const evolve::Run& run, const evolve::Sweep& sweep);
  void by_bands(const evolve::Run& run, const evolve::Sweep& sweep);

  Crew crew_;
  std::vector<Fused> fused_;           // of each thread
  Masks masks_;
  std::vector<evolve::Sweep> sweeps_;  // of the step
  std::vector<evolve::Sweep> passes_;  // plane after plane
  std::vector<std::pair<size_t, size_t>> planes_;
  stencil::Pulled pulled_{};
  std::vector<uint8_t> pulls_;
  std::vector<uint8_t> before_;  // planes, before many steps
  uint64_t left_out_ = 0;
};

}  // namespace dapple::desktop
