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
  const char *key, *label;
  std::string value;  // JSON
  const char* unit;   // of plain text
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
  const auto radius = std::find_if(all.begin(), all.end(), [](const Figure& f) { return f.key == std::string("radius"); });
  all.insert(radius, shape.begin(), shape.end());
  return all;
}

void print_json(const Subject& subject, const std::vector<Figure>& all) {
  std::printf("{\n  \"name\": %s,\n  \"family\": %s,\n", json_text(subject.name).c_str(),
              json_text(family_of(subject.recipe).name).c_str());
  if (!subject.sentence.empty()) std::printf("  \"sentence\": %s,\n", json_text(subject.sentence).c_str());
  std::printf("  \"recipe\": %s", json_text(line_of(subject.recipe)).c_str());
  for (const Figure& figure : all) std::printf(",\n  \"%s\": %s", figure.key, figure.value.c_str());
  std::printf("\n}\n");
}

// The recipe is the first line, so that scripts find it.
void print_plain(const Subject& subject, const std::vector<Figure>& all) {
  std::printf("%s\n\n", line_of(subject.recipe).c_str());
  for (const Figure& figure : all) {
    std::string value = figure.value;
    value.erase(std::remove(value.begin(), value.end(), '"'), value.end());
    std::printf("%-16s %10s%s%s\n", figure.label, value.c_str(), figure.unit[0] != 0 ? " " : "", figure.unit);
  }
}

}  // namespace

void info(const Options& options) {
  const Subject subject = subject_of(options);
  const dapple::Domain domain = domain_of(options);
  const dapple::Need need = need_of(subject, domain, options.bands);
  const std::vector<Figure> all = figures(subject.recipe, need, domain);
  if (options.json) print_json(subject, all);
  else print_plain(subject, all);
  finish_standard_output();
}

}  // namespace cli
