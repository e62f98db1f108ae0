// dapple info: the recipe, and what it needs.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>

#include "commands.hpp"
#include "recipes.hpp"

namespace cli {

namespace {

// A figure with its name in JSON and in plain text.
struct Figure {
  std::string key, label;
  std::string value;  // JSON
  std::string unit;   // of plain text
};

// Wavelength of the stage with the longest one, 1/kMicro cells.
int32_t wavelength_of(const dapple::Recipe& recipe) {
  int32_t longest = 0;
  for (uint8_t i = 0; i < recipe.stages; ++i) {
    const dapple::Stage& stage = recipe.stage[i];
    const bool coarse = stage.model->coarse;
    const int32_t length = coarse ? family_of(recipe).grown(stage.number) << stage.level : stage.model->wavelength(stage.number);
    longest = std::max(longest, length);
  }
  return longest;
}

// Bytes of the planes that solvers keep beside the model's own, at the finest grid that has them.
uint64_t kept_bytes(const dapple::Recipe& recipe, const dapple::Need& need, dapple::Domain domain) {
  const dapple::grid::Ground ground = dapple::api::ground_of(domain, need);
  uint64_t most = 0;
  for (uint8_t i = 0; i < recipe.stages; ++i) {
    const dapple::Stage& stage = recipe.stage[i];
    const dapple::evolve::Reach reach = stage.solver->reach(*stage.model, stage.number, stage.level, stage.stored);
    const uint16_t width = dapple::evolve::at_level(ground.width, stage.level);
    most = std::max(most, uint64_t{reach.kept} * dapple::grid::row_bytes(stage.model->cell, width) * dapple::evolve::at_level(ground.height, stage.level));
  }
  return most;
}

const char* cell_name(dapple::grid::Cell cell) {
  return cell == dapple::grid::Cell::bit ? "bit" : cell == dapple::grid::Cell::int16 ? "int16" : "int32";
}

// The tiles the pattern fits.
std::vector<Figure> tile_figures(const dapple::Need& need) {
  const uint32_t step = need.multiple;
  const auto multiple = [step](uint32_t side) { return std::to_string((side + step - 1) / step * step); };
  return {
      {"smallest_width", "smallest width", multiple(need.width), "cells"},
      {"smallest_height", "smallest height", multiple(need.height), "cells"},
      {"multiple", "multiple of", std::to_string(step), "cells"},
  };
}

// Where a window is, and what is grown for it.
std::vector<Figure> window_figures(const dapple::Need& need, dapple::Domain domain) {
  const dapple::grid::Ground ground = dapple::api::ground_of(domain, need);
  std::vector<Figure> all = {
      {"x", "at x", std::to_string(domain.x), "cells"},
      {"y", "at y", std::to_string(domain.y), "cells"},
      {"halo", "halo", std::to_string(need.halo), "cells"},
      {"grown_width", "grown width", std::to_string(ground.width), "cells"},
      {"grown_height", "grown height", std::to_string(ground.height), "cells"},
  };
  if (need.block != 0) all.push_back({"block", "block", std::to_string(need.block), "cells"});
  return all;
}

std::vector<Figure> figures(const dapple::Recipe& recipe, const dapple::Need& need, dapple::Domain domain) {
  const dapple::Model& model = *recipe.stage[0].model;
  const auto text = [](uint64_t value) { return std::to_string(value); };
  std::vector<Figure> all = {
      {"width", "width", text(domain.width), "cells"},
      {"height", "height", text(domain.height), "cells"},
      {"cells", "cells", text(uint64_t{domain.width} * domain.height), ""},
      {"cell", "kind of cell", json_text(cell_name(model.cell)), ""},
      {"planes", "planes", text(model.planes(recipe.stage[0].number)), ""},
      {"bytes", "memory", text(need.bytes), "bytes"},
      {"planes_bytes", "  planes", text(need.planes), "bytes"},
      {"scratch_bytes", "  scratch rows", text(need.scratch), "bytes"},
      {"paint_bytes", "  paint", text(need.paint), "bytes"},
      {"rest_bytes", "  rest", text(need.rest), "bytes"},
      {"radius", "radius", text(need.reach), "cells"},
      {"wavelength", "wavelength", decimal_text(wavelength_of(recipe)), "cells"},
      {"stages", "stages", text(recipe.stages), ""},
      {"steps", "steps", text(steps_of(recipe)), ""},
      {"sweeps", "sweeps", text(need.sweeps), ""},
      {"rows", "rows of work", text(need.rows), ""},
  };
  if (const uint64_t kept = kept_bytes(recipe, need, domain); kept > 0) {
    const auto scratch = std::find_if(all.begin(), all.end(), [](const Figure& f) { return f.key == std::string("scratch_bytes"); });
    all.insert(scratch, {"kept_bytes", "  of them kept", text(kept), "bytes"});
  }
  const std::vector<Figure> shape = domain.plane ? window_figures(need, domain) : tile_figures(need);
  const auto radius = std::find_if(all.begin(), all.end(), [](const Figure& f) { return f.key == "radius"; });
  all.insert(radius, shape.begin(), shape.end());
  return all;
}

uint64_t updates_of(const dapple::Recipe& recipe, dapple::Domain domain) {
  uint64_t sum = 0;
  for (uint8_t i = 0; i < recipe.stages; ++i)
    sum += dapple::evolve::updates_of(recipe.stage[i], domain.width, domain.height);
  return sum;
}

// What the recipe would cost with each solver of its family: on one grid, and over as many as resolve its pattern and
// the tile's sides allow.
std::vector<Figure> solver_figures(const Subject& subject, dapple::Domain domain) {
  std::vector<Figure> all;
  if (domain.plane || subject.recipe.stage[0].model != &dapple::threshold_model) return all;
  const auto add = [&](const std::string& name, int levels) {
    dapple::Recipe recipe = subject.recipe;
    dapple::Trouble trouble{};
    const std::string text = "solver=" + name + " levels=" + std::to_string(levels);
    if (dapple::parse(text.c_str(), recipe, trouble) != dapple::ok) return false;
    const dapple::Need need = dapple::need_for(recipe, domain);
    if (need.status != dapple::ok) return false;
    const std::string updates = std::to_string(updates_of(recipe, domain));
    all.push_back({"rows_" + name, "  " + name, std::to_string(need.rows), "rows, " + updates + " cell updates"});
    all.push_back({"updates_" + name, "", updates, ""});
    return true;
  };
  add("euler", 1);
  add("gaussian", 1);
  const dapple::Stage& last = subject.recipe.stage[subject.recipe.stages - 1];
  int levels = dapple::recipe::levels_for(last, steps_of(subject.recipe), dapple::recipe::kFineSteps);
  while (levels > 1 && !add("multigrid", levels)) --levels;
  return all;
}

void print_json(const Subject& subject, const std::vector<Figure>& all) {
  std::printf("{\n  \"name\": %s,\n  \"family\": %s,\n", json_text(subject.name).c_str(),
              json_text(family_of(subject.recipe).name).c_str());
  if (!subject.sentence.empty()) std::printf("  \"sentence\": %s,\n", json_text(subject.sentence).c_str());
  std::printf("  \"recipe\": %s", json_text(line_of(subject.recipe)).c_str());
  for (const Figure& figure : all) std::printf(",\n  \"%s\": %s", figure.key.c_str(), figure.value.c_str());
  std::printf("\n}\n");
}

// The recipe is the first line, so that scripts find it.
void print_plain(const Subject& subject, const std::vector<Figure>& all) {
  std::printf("%s\n\n", line_of(subject.recipe).c_str());
  for (const Figure& figure : all) {
    if (figure.label.empty()) continue;
    if (figure.key == "rows_euler") std::printf("cost by solver\n");
    std::string value = figure.value;
    value.erase(std::remove(value.begin(), value.end(), '"'), value.end());
    std::printf("%-16s %10s%s%s\n", figure.label.c_str(), value.c_str(), figure.unit.empty() ? "" : " ", figure.unit.c_str());
  }
}

}  // namespace

void info(const Options& options) {
  const Subject subject = subject_of(options);
  const dapple::Domain domain = domain_of(options);
  const dapple::Need need = need_of(subject, domain, options.bands);
  std::vector<Figure> all = figures(subject.recipe, need, domain);
  const std::vector<Figure> solvers = solver_figures(subject, domain);
  all.insert(all.end(), solvers.begin(), solvers.end());
  if (options.json) print_json(subject, all);
  else print_plain(subject, all);
  finish_standard_output();
}

}  // namespace cli
