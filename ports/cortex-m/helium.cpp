// Row kernels for Helium, the vectors of Cortex-M55 and M85: eight cells at a time, the end of a row under a predicate.
// gcc 12 makes no vectors of the portable loops there. Weights and rates are even, as their tables say, so that
// vqdmulh(d, w / 2) == mulhi(d, w) and vqdmlah(c, d, w / 2) == c + mulhi(d, w); neither saturates, for the results fit.
// SPDX-License-Identifier: MIT
#include <arm_mve.h>
#include "kernels.hpp"
#include "packed.hpp"

namespace dapple::helium {

using i16 = int16_t;
using Cells = int16x8_t;

static i16 half(i16 even) { return static_cast<i16>(even / 2); }

struct Helium {
  using Cells = helium::Cells;
  using Part = mve_pred16_t;
  static constexpr uint16_t kCells = 8;

  static Part part(uint16_t count) { return vctp16q(count); }
  static Cells load(const i16* from) { return vldrhq_s16(from); }
  static Cells load(const i16* from, Part part) { return vldrhq_z_s16(from, part); }
  static void store(i16* to, Cells cells) { vstrhq_s16(to, cells); }
  static void store(i16* to, Cells cells, Part part) { vstrhq_p_s16(to, cells, part); }

  // (l + r + 2c + k) >> 2 == (((l + r + k) >> 1) + c) >> 1. k = 1 rounds the first half up; k = 2 adds one to it, which
  // rounds the second half up.
  struct Quarter1 {
    Cells operator()(Cells l, Cells c, Cells r) const { return vhaddq_s16(vrhaddq_s16(l, r), c); }
  };
  struct Quarter2 {
    Cells operator()(Cells l, Cells c, Cells r) const { return vrhaddq_s16(vhaddq_s16(l, r), c); }
  };

  // stencil::pass_row: c + mulhi(l + r - 2c + k, w). Every sum of these terms fits: -32000 .. 32512.
  struct Weighted {
    i16 weight, rounding;
    Weighted(i16 w, i16 k) : weight(half(w)), rounding(k) {}
    Cells operator()(Cells l, Cells c, Cells r) const {
      const Cells d = vaddq_n_s16(vaddq_s16(vmlaq_n_s16(l, c, -2), r), rounding);
      return vqdmlahq_n_s16(c, d, weight);
    }
  };

  // threshold::impulse_row: c - mulhi(c + 1, D) + amount. (c + 1) D is never a multiple of 2^16 for c in 0..16000,
  // because D = 2 * 12893; hence c - floor((c + 1) D / 2^16) == (c + 1) + floor(-(c + 1) D / 2^16).
  struct Impulse {
    i16 rho;
    Cells amount;
    Impulse(i16 level, i16 size) : rho(level), amount(vdupq_n_s16(size)) {}
    Cells where_above(Cells a, Cells b) const {
      return vpselq_s16(amount, vdupq_n_s16(0), vcmpgtq_n_s16(vsubq_s16(a, b), rho));
    }
    Cells decayed(Cells c, Cells more) const {
      const Cells next = vaddq_n_s16(c, 1);
      return vaddq_s16(vqdmlahq_n_s16(next, next, -threshold::kDecay / 2), more);
    }
  };

  // stencil::five_row: mulhi(l + r - 2c + k, w) + mulhi(u + d - 2c + k, w).
  struct Five {
    i16 weight, rounding;
    Five(i16 w, i16 k) : weight(half(w)), rounding(k) {}
    Cells operator()(Cells u, Cells l, Cells c, Cells r, Cells d) const {
      const Cells rest = vmlasq_n_s16(c, vdupq_n_s16(-2), rounding);
      const Cells across = vaddq_s16(vaddq_s16(rest, l), r), along = vaddq_s16(vaddq_s16(rest, u), d);
      return vqdmlahq_n_s16(vqdmulhq_n_s16(across, weight), along, weight);
    }
  };

  // gray_scott::react_row: q = mulhi(2v, 2v), eaten = mulhi(2q + 2, 2u), and the rates F and F + k.
  struct Kinetics {
    i16 feed, drain, drain_rounding;
    Cells one;
    Kinetics(i16 f, i16 f_rounding, i16 d, i16 d_rounding)
        : feed(half(f)),
          drain(half(d)),
          drain_rounding(d_rounding),
          one(vdupq_n_s16(static_cast<i16>(gray_scott::kOne + f_rounding))) {}
    Cells eaten(Cells u, Cells v) const {
      const Cells q = vqdmulhq_s16(vaddq_s16(v, v), v);
      return vqdmulhq_s16(vmlasq_n_s16(q, vdupq_n_s16(2), 2), u);
    }
    Cells fed(Cells u, Cells du, Cells eaten) const {
      return vqdmlahq_n_s16(vsubq_s16(vaddq_s16(u, du), eaten), vsubq_s16(one, u), feed);
    }
    Cells drained(Cells v, Cells dv, Cells eaten) const {
      const Cells lost = vqdmulhq_n_s16(vaddq_n_s16(v, drain_rounding), drain);
      return vsubq_s16(vaddq_s16(vaddq_s16(v, dv), eaten), lost);
    }
  };
};

const grid::KernelSwap kernels[] = {
    {stencil::pass_row, packed::pass_row<Helium>},           {stencil::chain_row, packed::chain_row<Helium>},
    {threshold::impulse_row, packed::impulse_row<Helium>},   {stencil::five_row, packed::five_row<Helium>},
    {gray_scott::react_row, packed::gray_scott_row<Helium>}, {nullptr, nullptr}};

}  // namespace dapple::helium
