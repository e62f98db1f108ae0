// dapple bench: every piece of work by every kernel table, as rate, ratio to the portable table and share of what the
// processor could do at most; then the time from recipe to painted tile of every preset.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cinttypes>
#include <cstdio>

#include "bench_work.hpp"
#include "chunks.hpp"
#include "commands.hpp"
#include "errors.hpp"
#include "output.hpp"
#include "tile.hpp"

namespace cli {

using namespace measure;

namespace {

constexpr int kRounds = 15;

struct Row {
  std::string work, table, unit;
  double best, median, ratio;  // amount a second; of the portable table
  double bytes;                // a cell
  double share;                // of the limit; 0: not known
  double floats;               // of the float loop; 0: not comparable
  uint64_t hash;
};

// The most of this work that a processor of these limits could do in a second; 0: not known.
double bound_of(const Work& work, const Limits& limits) {
  if (limits.loads == 0) return 0;
  if (work.operations > 0) return limits.bytes * 8 * limits.operations / work.operations;
  if (work.loads_aligned == 0) return 0;
  return limits.bytes / 2 / (work.loads_aligned / limits.loads + work.loads_askew / limits.loads_askew);
}

double scale_of(const std::string& unit) { return unit[0] == 'G' ? 1e9 : unit[0] == 'M' ? 1e6 : 1; }

std::vector<Limits> limits_of_all(const std::vector<std::string>& tables) {
  std::vector<Limits> limits;
  for (const std::string& table : tables) limits.push_back(limits_of(table));
  return limits;
}

std::vector<Row> rows_of(const Work& work, const std::vector<std::string>& tables) {
  std::vector<uint64_t> hash(tables.size());
  std::vector<std::function<double()>> runs;
  for (size_t i = 0; i < tables.size(); ++i)
    runs.push_back([&hash, i, run = work.with(kernels_named(tables[i]))] {
      const Done done = run();
      hash[i] = done.hash;
      return done.seconds;
    });
  const std::vector<Limits> limits = limits_of_all(tables);  // of these minutes: other work comes and goes
  const std::vector<Seconds> seconds = take_turns(runs, kRounds);
  std::vector<Row> rows;
  for (size_t i = 0; i < tables.size(); ++i) {
    if (hash[i] != hash[0]) fail("bench: " + work.name + " by " + tables[i] + " has other bytes than by portable");
    const double best = work.amount / seconds[i].least, bound = bound_of(work, limits[i]);
    const bool floats = work.name.rfind("gray-scott", 0) == 0 && limits[i].float_gray_scott > 0;
    rows.push_back({work.name, tables[i], work.unit, best, work.amount / seconds[i].median,
                    seconds[0].least / seconds[i].least, work.bytes, bound > 0 ? best / bound : 0,
                    floats ? best / limits[i].float_gray_scott : 0, hash[i]});
  }
  return rows;
}

// "12.3", or nothing for what is not known.
std::string figure(double value, int digits) {
  if (value == 0) return "";
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

struct Column {
  const char* name;
  int width;  // negative: from the left
};
constexpr Column kColumns[] = {{"work", -30},  {"kernels", -9},    {"best", 9},        {"median", 9},
                               {"", -13},      {"x portable", 10}, {"bytes/cell", 10}, {"% of limit", 10},
                               {"x float", 8}, {"hash", 16}};

std::vector<std::string> cells_of(const Row& r) {
  const double scale = scale_of(r.unit);
  char hash[20];
  std::snprintf(hash, sizeof hash, "%016" PRIx64, r.hash);
  return {r.work,
          r.table,
          figure(r.best / scale, 2),
          figure(r.median / scale, 2),
          r.unit,
          figure(r.ratio, 2),
          figure(r.bytes, 3),
          figure(100 * r.share, 0),
          figure(r.floats, 2),
          hash};
}

void print_line(const std::vector<std::string>& cells, bool markdown) {
  for (size_t i = 0; i < cells.size(); ++i)
    if (markdown) std::printf("%s%s%s", i == 0 ? "| " : " ", cells[i].c_str(), i + 1 < cells.size() ? " |" : " |\n");
    else std::printf("%*s%s", kColumns[i].width, cells[i].c_str(), i + 1 < cells.size() ? " " : "\n");
  std::fflush(stdout);
}

void print_head(bool markdown) {
  std::vector<std::string> names, rules;
  for (const Column& column : kColumns) names.push_back(column.name), rules.push_back("---");
  print_line(names, markdown);
  if (markdown) print_line(rules, markdown);
}

void print_json(const std::vector<Row>& rows) {
  std::printf("[\n");
  for (size_t i = 0; i < rows.size(); ++i) {
    const Row& r = rows[i];
    std::printf(
        "  {\"work\": %s, \"kernels\": %s, \"unit\": %s, \"best\": %.4g, \"median\": %.4g, \"ratio\": %.3f, \"bytes\": "
        "%g, "
        "\"share\": %.3f, \"float\": %.3f, \"hash\": \"%016" PRIx64 "\"}%s\n",
        json_text(r.work).c_str(), json_text(r.table).c_str(), json_text(r.unit).c_str(), r.best, r.median, r.ratio,
        r.bytes, r.share, r.floats, r.hash, i + 1 < rows.size() ? "," : "");
  }
  std::printf("]\n");
}

void print_limits(const std::vector<std::string>& tables, const std::vector<Limits>& limits, bool markdown) {
  std::printf(
      "Limits measured here: copies of 16 KB, 256 KB and 64 MB move %.0f, %.0f and %.0f GB/s (read and written).%s\n",
      copied(16 << 10) / 1e9, copied(256 << 10) / 1e9, copied(64 << 20) / 1e9, markdown ? "\n" : "");
  for (size_t i = 0; i < tables.size(); ++i)
    if (limits[i].loads > 0)
      std::printf(
          "%s, vectors of %d bytes: %.2f G aligned loads, %.2f G loads that are not, %.2f G operations a second; a "
          "float32 "
          "Gray-Scott step %.2f Gcell/s.%s\n",
          tables[i].c_str(), limits[i].bytes, limits[i].loads / 1e9, limits[i].loads_askew / 1e9,
          limits[i].operations / 1e9, limits[i].float_gray_scott / 1e9, markdown ? "\n" : "");
  std::printf("\n");
}

// Milliseconds from a recipe to a tile painted as rgba8888.
std::function<double()> painting(const Subject& subject, uint8_t threads, Kernels kernels) {
  return [=] {
    const double start = wall_seconds();
    Progress progress;
    Tile tile(subject, dapple::torus(256, 256), 1337, threads, kernels);
    tile.grow(UINT32_MAX, progress);
    std::vector<uint8_t> row(4 * 256);
    for (uint16_t y = 0; y < 256; ++y) tile.texture().paint(y, dapple::Pixels::rgba8888, row.data());
    return wall_seconds() - start;
  };
}

void print_presets(const Options& options, bool wanted_all) {
  std::printf("\n| preset, 256 x 256 painted, ms | portable | best, 1 thread | best, 2 threads |\n|---|---|---|---|\n");
  for (uint16_t i = 0; i < dapple::preset_count(); ++i) {
    char name[dapple::kMaxName];
    const dapple::PresetEntry entry = dapple::preset_at(i, name);
    const bool named = std::find(options.wanted.begin(), options.wanted.end(), entry.name) != options.wanted.end();
    if (!wanted_all && !named) continue;
    const Subject subject = {entry.name, "", dapple::load(*entry.preset)};
    const std::vector<Seconds> s = take_turns(
        {painting(subject, 1, nullptr), painting(subject, 1, best_kernels()), painting(subject, 2, best_kernels())},
        steps_of(subject.recipe) > 200 ? 2 : 7);
    std::printf("| %s | %.2f | %.2f | %.2f |\n", entry.name, 1e3 * s[0].least, 1e3 * s[1].least, 1e3 * s[2].least);
    std::fflush(stdout);
  }
}

// Seconds on the wall for 8 x 8 chunks of the plane, painted as rgb565.
std::function<double()> planting(const dapple::Recipe& recipe, uint8_t threads, std::shared_ptr<uint64_t> hash) {
  constexpr uint16_t kSide = 128, kAcross = 8, kSlots = kAcross * kAcross;
  struct Cache {
    std::shared_ptr<const dapple::Recipe> recipe;
    dapple::Chunks chunks;
    std::vector<uint8_t> memory;
    std::function<uint32_t(uint32_t)> grow;
  };
  dapple::Brush brush;
  brush.format = dapple::Pixels::rgb565;
  const auto cache = std::make_shared<Cache>();
  cache->recipe = ready_of(recipe);
  cache->memory.resize(dapple::chunk_bytes(*cache->recipe, kSide, kSlots, brush.format));
  dapple::Options options;
  options.kernels = best_kernels();
  cache->chunks.begin(*cache->recipe, 1337, kSide, kSlots, brush, cache->memory.data(), cache->memory.size(), options);
  cache->grow = growers_of(cache->chunks, threads);
  return [cache, hash, at = int32_t{0}]() mutable {
    at = (at + 1) % 50;
    cache->chunks.look_at(at * kSide * kAcross, 0, kSide * kAcross, kSide * kAcross);
    const double start = wall_seconds();
    while (cache->grow(UINT32_MAX) > 0) {
    }
    const double seconds = wall_seconds() - start;
    for (int32_t cy = 0; cy < kAcross; ++cy)
      for (int32_t cx = at * kAcross; cx < (at + 1) * kAcross; ++cx)
        *hash = hashed(*hash, cache->chunks.pixels(cx, cy), size_t{2} * kSide * kSide);
    return seconds;
  };
}

void print_chunks() {
  const dapple::Recipe recipe = dapple::load(*dapple::find_preset("zebra-bits"));
  const auto one = std::make_shared<uint64_t>(0), two = std::make_shared<uint64_t>(0);
  const std::vector<Seconds> s = take_turns({planting(recipe, 1, one), planting(recipe, 2, two)}, kRounds);
  if (*one != *two) fail("bench: chunks have other bytes on two threads than on one");
  std::printf("\nChunks of 128 x 128, zebra-bits painted as rgb565, by the best kernels: %.0f a second on one thread, "
              "%.0f on two, %.2f times as many.\n",
              64 / s[0].least, 64 / s[1].least, s[0].least / s[1].least);
}

// The work that has one of the words in its name; all of it if there are none.
std::vector<Work> wanted_work(const std::vector<std::string>& words) {
  std::vector<Work> wanted;
  for (const Work& work : all_work()) {
    const auto named = [&](const std::string& word) { return work.name.find(word) != std::string::npos; };
    if (words.empty() || std::any_of(words.begin(), words.end(), named)) wanted.push_back(work);
  }
  return wanted;
}

}  // namespace

void bench(const Options& options) {
  const std::vector<std::string> tables = kernel_names();
  const std::vector<Work> wanted = wanted_work(options.wanted);
  const bool all = options.wanted.empty();
  const auto is_preset = [](const std::string& word) { return dapple::find_preset(word.c_str()) != nullptr; };
  const bool presets = all ? options.markdown : std::any_of(options.wanted.begin(), options.wanted.end(), is_preset);
  const bool chunks = all || std::count(options.wanted.begin(), options.wanted.end(), "chunks") > 0;
  if (wanted.empty() && !presets && !chunks)
    refuse("nothing to measure has " + shown(options.wanted[0]) + " in its name");
  if (!options.json) print_limits(tables, limits_of_all(tables), options.markdown);
  if (!wanted.empty() && !options.json) print_head(options.markdown);
  std::vector<Row> rows;
  for (const Work& work : wanted)
    for (const Row& row : rows_of(work, tables)) {
      if (!options.json) print_line(cells_of(row), options.markdown);
      rows.push_back(row);
    }
  if (options.json) print_json(rows);
  else if (chunks) print_chunks();
  if (!options.json && presets) print_presets(options, all);
  finish_standard_output();
}

}  // namespace cli
