// Fields of directions. See steer.hpp.
// SPDX-License-Identifier: MIT
#include "steer.hpp"

namespace dapple::stencil {

constexpr uint32_t kDirectionStream = 96;  // of the hash

static int64_t floor_divide(int64_t a, int32_t b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

// A world coordinate in units of nodes, Q8: floor((256 at + 128) nodes / size), on the plane floor((256 at + 128) / nodes).
// Kept as node, part (of 256) and remainder, so that the next cell takes no division and the plane's ends fit.
struct NodePlace {
  int32_t node, part, rest, step, step_rest, divisor;
};

static NodePlace node_place(int32_t at, uint16_t size, uint16_t nodes) {
  const int32_t factor = size != 0 ? nodes : 1, divisor = size != 0 ? size : nodes;
  const int64_t value = (static_cast<int64_t>(at) * 256 + 128) * factor;
  const int64_t place = floor_divide(value, divisor);
  return {static_cast<int32_t>(place >> 8), static_cast<int32_t>(place & 255), static_cast<int32_t>(value - place * divisor),
          256 * factor / divisor, 256 * factor % divisor, divisor};
}

static void next_cell(NodePlace& p) {
  p.part += p.step;
  p.rest += p.step_rest;
  if (p.rest >= p.divisor) {
    p.rest -= p.divisor;
    ++p.part;
  }
  if (p.part >= 256) {
    p.part -= 256;
    ++p.node;
  }
}

static int32_t folded(int32_t i, uint16_t size, uint16_t nodes) {
  if (size == 0) return i;
  const int32_t rest = i % nodes;
  return rest < 0 ? rest + nodes : rest;
}

// Weights of the nodes before, at and behind, Q7; they sum to 128.
struct Blend {
  int16_t weight[3];
};
static Blend blend_of(int32_t f) {
  Blend b{};
  b.weight[0] = static_cast<int16_t>(((256 - f) * (256 - f)) >> 10);
  b.weight[2] = static_cast<int16_t>((f * f) >> 10);
  b.weight[1] = static_cast<int16_t>(128 - b.weight[0] - b.weight[2]);
  return b;
}

// Two numbers that are blended: a vector's parts (Q12), or a scalar (Q15) and nothing.
struct Pair {
  int32_t a, b;
};

static Pair node(const DirectionField& f, int32_t i, int32_t j) {
  const uint32_t h = base::hash(f.seed, kDirectionStream, folded(i, f.width, f.across), folded(j, f.height, f.down));
  if (f.kind == scalars) return {static_cast<int32_t>(h >> 16) - 32768, 0};
  const uint16_t angle = static_cast<uint16_t>(h >> 16);
  return {base::cosine(angle) >> 3, base::sine(angle) >> 3};
}

// Column i of nodes, blended along y: Q7 more than the nodes.
static Pair column(const DirectionField& f, int32_t i, int32_t j, const Blend& down) {
  Pair sum = {0, 0};
  for (uint8_t k = 0; k < 3; ++k) {
    const Pair n = node(f, i, j + k - 1);
    sum.a += n.a * down.weight[k];
    sum.b += n.b * down.weight[k];
  }
  return sum;
}

Doubled doubled_of(uint16_t turn) {
  return {to_q7((base::cosine(turn) + 128) >> 8), to_q7((base::sine(turn) + 128) >> 8)};
}

Doubled unit_of(int32_t a, int32_t b) {
  const int32_t inverse = base::inverse_root(static_cast<uint32_t>(a * a + b * b));
  return {to_q7((a * inverse + 65536) >> 17), to_q7((b * inverse + 65536) >> 17)};
}

// sum: Q7 * Q7 times the nodes' format. Scalars: |n| < 2^15, n bend is 2^27 at most, in turns Q27 -> Q16.
static Doubled to_direction(const DirectionField& f, const Pair& sum) {
  if (f.kind == scalars) return doubled_of(static_cast<uint16_t>(((sum.a >> 14) * f.bend) >> 11));
  return unit_of(sum.a >> 14, sum.b >> 14);  // Q12
}

void directions(const DirectionField& f, int32_t x, int32_t y, uint8_t count, int8_t* c2, int8_t* s2) {
  const NodePlace row = node_place(folded(f.y + y, f.height, f.height), f.height, f.down);
  const Blend down = blend_of(row.part);
  Pair nodes[3] = {};
  int32_t world = folded(f.x + x, f.width, f.width);
  NodePlace p = node_place(world, f.width, f.across);
  int32_t at = p.node - 3;
  for (uint8_t k = 0; k < count; ++k) {
    for (; at < p.node; ++at) {  // of the next node's three two are there
      nodes[0] = nodes[1];
      nodes[1] = nodes[2];
      nodes[2] = column(f, at + 2, row.node, down);
    }
    const Blend across = blend_of(p.part);
    next_cell(p);
    if (++world == f.width && f.width != 0) {
      world = 0;
      p = node_place(0, f.width, f.across);
      at = -3;
    }
    Pair sum = {0, 0};
    for (uint8_t n = 0; n < 3; ++n) {
      sum.a += nodes[n].a * across.weight[n];
      sum.b += nodes[n].b * across.weight[n];
    }
    const Doubled direction = to_direction(f, sum);
    c2[k] = direction.c2;
    s2[k] = direction.s2;
  }
}

}  // namespace dapple::stencil
