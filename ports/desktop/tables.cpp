// The tables, and which of them this processor can run. DAPPLE_X86 and DAPPLE_ARM say which sets are linked.
// SPDX-License-Identifier: MIT
#include "tables.hpp"

#include "exports.hpp"
#include "fluxed.hpp"
#include "strips.hpp"

#include "../../lib/evolve/kinetics.hpp"
#include "../../lib/evolve/solver.hpp"
#include "../../lib/model/brusselator.hpp"
#include "../../lib/model/cells.hpp"
#include "../../lib/model/fitzhugh_nagumo.hpp"
#include "../../lib/model/gray_scott.hpp"
#include "../../lib/model/meinhardt_spots.hpp"
#include "../../lib/model/meinhardt_stripes.hpp"
#include "../../lib/model/schnakenberg.hpp"
#include "../../lib/model/threshold.hpp"
#include "../../lib/model/turing.hpp"
#include "../../lib/paint/paint.hpp"
#include "../../lib/stencil/flux.hpp"
#include "../../lib/stencil/laplacian.hpp"
#include "../../lib/stencil/steer.hpp"

namespace dapple::desktop {

#define DECLARED(set, space, portable, own) extern "C" void dapple_##set##_##space##_##portable(const grid::Rows& rows);
#define SWAPPED(set, space, portable, own) {space::portable, dapple_##set##_##space##_##portable},

static bool always() { return true; }

#ifdef DAPPLE_X86
DAPPLE_ROWS(DECLARED, sse2)
DAPPLE_ROWS(DECLARED, avx2)
static const grid::KernelSwap sse2[] = {DAPPLE_ROWS(SWAPPED, sse2){nullptr, nullptr}};
static const grid::KernelSwap avx2[] = {DAPPLE_ROWS(SWAPPED, avx2){nullptr, nullptr}};
static bool has_avx2() {
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("fma");
}
#endif

#ifdef DAPPLE_ARM
DAPPLE_ROWS(DECLARED, neon)
static const grid::KernelSwap neon[] = {DAPPLE_ROWS(SWAPPED, neon){nullptr, nullptr}};
#endif

static const Table tables[] = {
    {"portable", nullptr, always},
#ifdef DAPPLE_X86
    {"sse2", sse2, always},
    {"avx2", avx2, has_avx2},
#endif
#ifdef DAPPLE_ARM
    {"neon", neon, always},
#endif
};

uint8_t table_count() { return sizeof tables / sizeof *tables; }
const Table& table_at(uint8_t i) { return tables[i]; }

const Table& best_table() {
  uint8_t i = static_cast<uint8_t>(table_count() - 1);
  while (!tables[i].runs()) --i;
  return tables[i];
}

static bool same(const char* a, const char* b) {
  while (*a != 0 && *a == *b) ++a, ++b;
  return *a == *b;
}

const Table* table_named(const char* name) {
  for (const Table& table : tables)
    if (same(table.name, name)) return &table;
  return nullptr;
}

}  // namespace dapple::desktop
