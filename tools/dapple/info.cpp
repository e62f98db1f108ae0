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
  for (uint8_t i = 0; i < recipe.stages; ++i)
    longest = std::max(longest, recipe.stage[i].model->wavelength(recipe.stage[i].number));
  return longest;
}

const char* cell_name(dapple::grid::Cell cell) {
  return cell == dapple::grid::Cell::bit ? "bit" : cell == dapple::grid::Cell::int16 ? "int16" : "int32";
}

std::vector<Figure> figures(const dapple::Recipe& recipe, const dapple::Need& need, dapple::Domain domain) {
  const dapple::Model& model = *recipe.stage[0].model;
  const auto text = [](uint64_t value) { return std::to_string(value); };
  const auto multiple = [&](uint32_t side) { return text((side + need.multiple - 1) / need.multiple * need.multiple); };
  return {
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
      {"smallest_width", "smallest width", multiple(need.width), "cells"},
      {"smallest_height", "smallest height", multiple(need.height), "cells"},
      {"multiple", "multiple of", text(need.multiple), "cells"},
      {"radius", "radius", text(need.reach), "cells"},
      {"wavelength", "wavelength", decimal_text(wavelength_of(recipe)), "cells"},
      {"stages", "stages", text(recipe.stages), ""},
      {"steps", "steps", text(steps_of(recipe)), ""},
      {"sweeps", "sweeps", text(need.sweeps), ""},
      {"rows", "rows of work", text(need.rows), ""},
  };
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
  const dapple::Domain domain = dapple::torus(options.width, options.height);
  const dapple::Need need = need_of(subject, domain, options.bands);
  const std::vector<Figure> all = figures(subject.recipe, need, domain);
  if (options.json) print_json(subject, all);
  else print_plain(subject, all);
  finish_standard_output();
}

}  // namespace cli
