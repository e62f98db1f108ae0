// Row kernels for the DSP instructions of Cortex-M4, M7 and M33: two cells in a register (SIMD32). Words are loaded
// from addresses of any alignment, which these cores allow.
// SPDX-License-Identifier: MIT
#include <arm_acle.h>
#include "kernels.hpp"
#include "packed.hpp"

namespace dapple::dsp {

using i16 = int16_t;
using Cells = int16x2_t;  // the first cell in the low half

static Cells both(i16 value) { return static_cast<Cells>(static_cast<uint16_t>(value) * UINT32_C(0x10001)); }

// The upper halves of two products as a pair.
static Cells upper_halves(int32_t first, int32_t second) {
  Cells cells;
  __asm__("pkhtb %0, %1, %2, asr #16" : "=r"(cells) : "r"(second), "r"(first));
  return cells;
}

static int32_t first_of(Cells cells) { return static_cast<i16>(cells); }
static int32_t second_of(Cells cells) { return cells >> 16; }

// mulhi(a, b), and mulhi(a + k, w) where the sum may take more than 16 bits; kw = k w.
static Cells mulhi(Cells a, Cells b) { return upper_halves(first_of(a) * first_of(b), second_of(a) * second_of(b)); }
static Cells mulhi_of_sum(Cells a, int32_t w, int32_t kw) {
  return upper_halves(__smlabb(a, w, kw), __smlatb(a, w, kw));
}

// amount where a >= b, else 0. The flags of the difference must reach `sel` untouched.
static Cells where_at_least(Cells a, Cells b, Cells amount) {
  Cells cells;
  __asm__("ssub16 %0, %1, %2\n\tsel %0, %3, %4" : "=&r"(cells) : "r"(a), "r"(b), "r"(amount), "r"(0));
  return cells;
}

struct Dsp {
  using Cells = dsp::Cells;
  struct Part {};  // one cell
  static constexpr uint16_t kCells = 2;

  static Part part(uint16_t) { return {}; }
  static Cells load(const i16* from) {
    Cells cells;
    base::copy_bytes(&cells, from, sizeof cells);
    return cells;
  }
  static Cells load(const i16* from, Part) { return *from; }
  static void store(i16* to, Cells cells) { base::copy_bytes(to, &cells, sizeof cells); }
  static void store(i16* to, Cells cells, Part) { *to = static_cast<i16>(cells); }

  // (l + r + 2c + k) >> 2 == (((l + r + k) >> 1) + c) >> 1; l + r and c + 1 fit.
  struct Quarter1 {
    Cells operator()(Cells l, Cells c, Cells r) const { return __shadd16(__shadd16(l, __sadd16(r, both(1))), c); }
  };
  struct Quarter2 {
    Cells operator()(Cells l, Cells c, Cells r) const { return __shadd16(__shadd16(l, r), __sadd16(c, both(1))); }
  };

  // stencil::pass_row: c + mulhi(l + r - 2c + k, w). d = l + r - 2c fits, -32000..32000; d w + k w < 2^31.
  struct Weighted {
    int32_t weight, product;
    Weighted(i16 w, i16 k) : weight(w), product(static_cast<int32_t>(w) * k) {}
    Cells operator()(Cells l, Cells c, Cells r) const {
      const Cells d = __ssub16(__sadd16(__ssub16(l, c), r), c);
      return __sadd16(c, mulhi_of_sum(d, weight, product));
    }
  };

  // threshold::impulse_row: c - mulhi(c + 1, D) + amount, amount where a - b > rho.
  struct Impulse {
    Cells least, amount;
    Impulse(i16 rho, i16 size) : least(both(static_cast<i16>(rho + 1))), amount(both(size)) {}
    Cells where_above(Cells a, Cells b) const { return where_at_least(__ssub16(a, b), least, amount); }
    Cells decayed(Cells c, Cells more) const {
      return __sadd16(__ssub16(c, mulhi_of_sum(c, threshold::kDecay, threshold::kDecay)), more);
    }
  };

  // stencil::five_row: mulhi(l + r - 2c + k, w) + mulhi(u + d - 2c + k, w). The arguments wrap where those of the
  // portable kernel do, hence k by an addition of its own.
  struct Five {
    int32_t weight;
    Cells rounding;
    Five(i16 w, i16 k) : weight(w), rounding(both(k)) {}
    Cells operator()(Cells u, Cells l, Cells c, Cells r, Cells d) const {
      const Cells rest = __ssub16(__ssub16(rounding, c), c);
      const Cells across = __sadd16(__sadd16(rest, l), r), along = __sadd16(__sadd16(rest, u), d);
      return __sadd16(mulhi_of_sum(across, weight, 0), mulhi_of_sum(along, weight, 0));
    }
  };

  // gray_scott::react_row: q = mulhi(2v, 2v), eaten = mulhi(2q + 2, 2u), and the rates F and F + k.
  struct Kinetics {
    int32_t feed, drain, drain_product;
    Cells one;
    Kinetics(i16 f, i16 f_rounding, i16 d, i16 d_rounding)
        : feed(f),
          drain(d),
          drain_product(static_cast<int32_t>(d) * d_rounding),
          one(both(static_cast<i16>(gray_scott::kOne + f_rounding))) {}
    Cells eaten(Cells u, Cells v) const {
      const Cells twice = __sadd16(v, v), more = __sadd16(mulhi(twice, twice), both(1));
      return mulhi(__sadd16(more, more), __sadd16(u, u));
    }
    Cells fed(Cells u, Cells du, Cells eaten) const {
      return __sadd16(__ssub16(__sadd16(u, du), eaten), mulhi_of_sum(__ssub16(one, u), feed, 0));
    }
    Cells drained(Cells v, Cells dv, Cells eaten) const {
      return __ssub16(__sadd16(__sadd16(v, dv), eaten), mulhi_of_sum(v, drain, drain_product));
    }
  };
};

const grid::KernelSwap kernels[] = {
    {stencil::pass_row, packed::pass_row<Dsp>},           {stencil::chain_row, packed::chain_row<Dsp>},
    {threshold::impulse_row, packed::impulse_row<Dsp>},   {stencil::five_row, packed::five_row<Dsp>},
    {gray_scott::react_row, packed::gray_scott_row<Dsp>}, {nullptr, nullptr}};

}  // namespace dapple::dsp
