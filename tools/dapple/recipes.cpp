// Recipes as the command line names them, and why they are refused.
// SPDX-License-Identifier: MIT
#include "recipes.hpp"

#include <algorithm>

#include "errors.hpp"

namespace cli {

using dapple::Recipe;
using dapple::Trouble;
using dapple::recipe::Family;

constexpr size_t kLongestRecipe = 4000;
constexpr std::string_view kMapFile = "map=@", kStyleFile = "style=@", kGrowthFile = "growth=@", kGradeFile = "grade=@";

// Changes that turn one name into the other: letters put in, left out or replaced.
static size_t distance_of(const std::string& a, const std::string& b) {
  std::vector<size_t> row(b.size() + 1);
  for (size_t k = 0; k <= b.size(); ++k) row[k] = k;
  for (size_t i = 1; i <= a.size(); ++i) {
    size_t corner = row[0]++;
    for (size_t k = 1; k <= b.size(); ++k) {
      const size_t replaced = corner + (a[i - 1] != b[k - 1]);
      corner = row[k];
      row[k] = std::min({row[k] + 1, row[k - 1] + 1, replaced});
    }
  }
  return row[b.size()];
}

// The three presets whose names are most like this one.
static std::string nearest(const std::string& name) {
  std::vector<std::pair<size_t, std::string>> all;
  for (uint16_t i = 0; i < dapple::preset_count(); ++i) {
    char buffer[dapple::kMaxName];
    const std::string preset = dapple::preset_at(i, buffer).name;
    all.emplace_back(distance_of(name.substr(0, 64), preset), preset);
  }
  std::sort(all.begin(), all.end());
  std::vector<std::string> names;
  for (size_t i = 0; i < all.size() && i < 3; ++i) names.push_back(all[i].second);
  return listed(names);
}

static bool names_a_family(const std::string& word) {
  const auto named = [&](const Family& family) { return word == family.name; };
  return std::any_of(std::begin(dapple::recipe::families), std::end(dapple::recipe::families), named);
}

[[noreturn]] static void refuse_name(const std::string& given) {
  std::vector<std::string> families;
  for (const Family& family : dapple::recipe::families) families.push_back(family.name);
  refuse("no preset is called " + shown(given) + "; the nearest are " + nearest(given) +
         " ('dapple list' shows all); a recipe begins with " + listed(families));
}

static std::string broken(const std::string& text, const Trouble& trouble, const std::string& word) {
  const bool at_start = trouble.column == 1 || text[trouble.column - 2u] == ' ';
  if (at_start) return shown(word) + " is not key=value";
  if (word.empty()) return "a value is missing";
  if (word.find(',') != std::string::npos) return shown(word) + " has too many numbers";
  return shown(word) + " is not a number; numbers are decimal, with at most six digits after the point";
}

static std::string unknown(const Trouble& trouble, const std::string& word) {
  const std::string allowed = trouble.allowed != nullptr ? trouble.allowed : dapple::recipe::kEntries;
  for (const Family& family : dapple::recipe::families)
    if (allowed == family.name)
      return shown(word) + " is not a key of " + family.name + "; there is " + listed(keys_of(family)) + ", " +
             listed(common_keys());
  return shown(word) + " is not one of " + allowed;
}

static std::string outside(const std::string& text, const Trouble& trouble, const std::string& word) {
  const auto number = [&](int32_t value) { return trouble.whole ? std::to_string(value) : decimal_text(value); };
  return (word == text ? "the wavelength" : shown(word)) + " is out of range, " + number(trouble.low) + " to " +
         number(trouble.high);
}

// Which words exclude each other follows from the word that was met.
static std::string impossible(const Trouble& trouble, const std::string& word) {
  if (trouble.allowed != nullptr)
    return "wavelength=, spot_size= and coverage= follow from each other: two of them are enough";
  if (word.find("repeat") != std::string::npos)
    return "sides repeat in pairs, left with right and top with bottom";
  if (word == "carry") return "a recipe has at most " + std::to_string(dapple::kMaxStages) + " stages";
  if (word == "freeze" || word == "reset")
    return "'then " + word + "' is for families of kinetics, and a recipe has at most " + std::to_string(dapple::kMaxStages) + " stages";
  if (word == "refine")
    return "'then refine' needs a stage of level 1 to 3 before it, and there are at most " +
           std::to_string(dapple::kMaxStages) + " stages";
  if (word == "binary")
    return "solver=binary is a family of its own, of one bit a cell: begin the recipe with bits; masks=, react=, diffusion=, "
           "stretch=, angle= and wavelength= are pairs= and so on, rho= is a share of the mask";
  return "fine=F needs levels=L or solver=multigrid, and the steps must be more than F (L - 1)";
}

// A number that makes steps diverge, or a grid too coarse for the pattern.
static std::string unsteady(const std::string& name, int32_t value, int32_t low, int32_t high) {
  const bool least = value < low;
  return name + "=" + decimal_text(value) + (least ? " is too small for the stage's grid" : " makes the steps diverge") +
         "; with the other numbers as they are " + name + "=" + decimal_text(least ? low : high) + " would do, and nothing " +
         (least ? "below" : "above") + " it";
}

static std::string reason(const std::string& text, const Trouble& trouble) {
  const std::string word(trouble.word.text, trouble.word.length);
  switch (trouble.status) {
    case dapple::broken_text:
      return broken(text, trouble, word);
    case dapple::unknown_word:
      return unknown(trouble, word);
    case dapple::out_of_range:
      return outside(text, trouble, word);
    case dapple::unstable:
      return unsteady(trouble.allowed, trouble.value, trouble.low, trouble.high);
    default:
      return impossible(trouble, word);
  }
}

void change(Recipe& recipe, const std::string& text, const std::string& where) {
  if (text.size() > kLongestRecipe)
    refuse(where + " has " + std::to_string(text.size()) + " characters; at most " + std::to_string(kLongestRecipe) +
           " are read");
  Trouble trouble{};
  if (dapple::parse(text.c_str(), recipe, trouble) == dapple::ok) return;
  refuse(where + " " + shown(text) + ", column " + std::to_string(trouble.column) + ": " + reason(text, trouble));
}

// All changes are read together, so that their order does not matter; a refusal names the one it is about.
static void change_all(Recipe& recipe, const std::vector<std::string>& changes) {
  std::string text;
  for (const std::string& one : changes) text += (text.empty() ? "" : " ") + one;
  if (changes.size() < 2 || text.size() > kLongestRecipe) return change(recipe, text, "change");
  Recipe copy = recipe;
  Trouble trouble{};
  if (dapple::parse(text.c_str(), copy, trouble) == dapple::ok) {
    recipe = copy;
    return;
  }
  size_t begin = 0, index = 0;
  while (index + 1 < changes.size() && trouble.column > begin + changes[index].size() + 1)
    begin += changes[index++].size() + 1;
  const bool whole = trouble.word.length == text.size();
  const size_t column = trouble.column - (whole ? 0 : begin);
  refuse("change " + shown(whole ? text : changes[index]) + ", column " + std::to_string(column) + ": " +
         reason(text, trouble));
}

static Subject subject_named(const std::string& name) {
  Subject subject{};
  for (uint16_t i = 0; i < dapple::preset_count(); ++i) {
    char buffer[dapple::kMaxName];
    const dapple::PresetEntry entry = dapple::preset_at(i, buffer);
    if (entry.preset == dapple::find_preset(name.c_str()))
      subject = {entry.name, entry.sentence, dapple::load(*entry.preset)};
  }
  if (!subject.name.empty()) return subject;
  const size_t first = std::min(name.find_first_not_of(' '), name.size());
  if (!names_a_family(name.substr(first, name.find(' ', first) - first))) refuse_name(name);
  subject.name = "texture";
  change(subject.recipe, name, "recipe");
  return subject;
}

// map=@FILE, style=@FILE, growth=@FILE and grade=@FILE: reads the picture, and puts what the recipe calls it in the word's place.
static void read_picture(std::string& word, MapAs as, PictureMaps& maps) {
  if (word.compare(0, kMapFile.size(), kMapFile) == 0) {
    read_map(word.substr(kMapFile.size()), as, maps);
    word = "map=image";
  } else if (word.compare(0, kStyleFile.size(), kStyleFile) == 0) {
    read_styles(word.substr(kStyleFile.size()), maps);
    word = "solver=styled";
  } else if (word.compare(0, kGrowthFile.size(), kGrowthFile) == 0) {
    read_growth(word.substr(kGrowthFile.size()), maps);
    word = "solver=pictured";
  } else if (word.compare(0, kGradeFile.size(), kGradeFile) == 0) {
    read_grade(word.substr(kGradeFile.size()), maps);
    word = "grade=image";
  }
}

Subject subject_of(const Options& options) {
  Subject subject = subject_named(options.subject);
  std::vector<std::string> changes = options.changes;
  const auto maps = std::make_shared<PictureMaps>();
  for (std::string& word : changes) read_picture(word, options.map_as, *maps);
  if (!changes.empty()) change_all(subject.recipe, changes);
  const dapple::PlaceMaps& read = maps->maps;
  if (read.direction.pairs != nullptr || read.style.cells != nullptr || read.grey.cells != nullptr ||
      read.lengths.cells != nullptr) {
    dapple::set_maps(subject.recipe, maps->maps);
    subject.maps = maps;
  }
  if (options.ramp) subject.recipe.paint.ramp = *options.ramp;
  return subject;
}

std::string line_of(const Recipe& recipe) {
  std::string text(kLongestRecipe, ' ');
  text.resize(std::min(dapple::write(recipe, text.data(), text.size()), text.size() - 1));
  return text;
}

const Family& family_of(const Recipe& recipe) { return *dapple::recipe::family_of(recipe); }

uint32_t steps_of(const Recipe& recipe) { return dapple::recipe::total_steps(recipe); }

static uint32_t rounded_up(uint32_t side, uint32_t multiple) { return (side + multiple - 1) / multiple * multiple; }

void fail_for_halo(const Subject& subject, uint32_t halo) {
  fail("the endless plane is not for " + subject.name + ": it would have to grow " + std::to_string(halo) +
       " cells more on every side, and " + std::to_string(dapple::kWidestHalo) +
       " are the most; a tile needs none (dapple grow without --at)");
}

[[noreturn]] static void fail_for_place(dapple::Domain domain) {
  const int32_t most = dapple::kFarthest - 2 * dapple::kWidestHalo;
  fail("--at " + place_text({domain.x, domain.y}) + " --size " + size_text(domain.width, domain.height) +
       ": the plane's pixels go from " + std::to_string(-most) + " to " + std::to_string(most - 1) + " either way");
}

[[noreturn]] static void fail_for_size(const Subject& subject, dapple::Domain domain, const dapple::Need& need) {
  constexpr uint32_t kMost = 65000;
  const std::string size = "--size " + size_text(domain.width, domain.height);
  const uint32_t halo = 2 * need.halo;
  if (domain.width + halo > kMost || domain.height + halo > kMost)
    fail(size + ": a window of " + subject.name + " is grown with " + std::to_string(need.halo) +
         " cells more on every side, so its sides are at most " + std::to_string(kMost - halo));
  fail(size + ": " + subject.name + " needs more memory than this machine can address");
}

dapple::Need need_of(const Subject& subject, dapple::Domain domain, uint8_t bands) {
  dapple::Options options;
  options.bands = bands;
  dapple::Need need{};
  const dapple::Patch patch = patch_of(subject.recipe);
  const dapple::Patches patches = {&patch, 1, domain.width, domain.height};
  if (has_sides(subject.recipe) && domain.plane) refuse("a window of the plane (--at) has no sides; sides= is for tiles");
  if (has_sides(subject.recipe)) domain = on_patch(patches, 0);
  dapple::Texture().begin(subject.recipe, domain, 0, nullptr, 0, options,
                          &need);  // checks all, and stops for want of memory
  const std::string size = "--size " + size_text(domain.width, domain.height);
  switch (need.status) {
    case dapple::too_little_memory:
      return need;
    case dapple::not_a_multiple:
      refuse(size + ": the sides of " + subject.name + " must be multiples of " + std::to_string(need.multiple));
    case dapple::tile_too_small:
      refuse(size + " is too small: " + subject.name + " needs at least " +
             size_text(rounded_up(need.width, need.multiple), rounded_up(need.height, need.multiple)));
    case dapple::too_large:
      fail_for_size(subject, domain, need);
    case dapple::too_far:
      fail_for_place(domain);
    case dapple::bad_sides:
      refuse("sides= is not for bits, flow and cells, nor for solver=styled");
    case dapple::bad_surface:
      refuse("solver=surface takes a surface: dapple surface SHAPE " + subject.name);
    case dapple::bad_map:
      refuse("map=image, solver=styled (of at most three pairs), solver=pictured and grade=image take pictures: give "
             "map=@FILE, style=@FILE, growth=@FILE or grade=@FILE, PGM, PPM or PNG files");
    case dapple::unstable:
      refuse(unsteady(dapple::recipe::name_at(family_of(subject.recipe), need.bound.slot),
                      subject.recipe.stage[need.stage].number[need.bound.slot], need.bound.low, need.bound.high));
    case dapple::no_coverage:
      fail("coverage= and spot_size= are shares of a whole tile, of which the endless plane has none (dapple grow without --at)");
    case dapple::halo_too_wide:
      fail_for_halo(subject, need.halo);
    default:
      break;
  }
  if (subject.recipe.stage[subject.recipe.stages - 1].level > 0)
    refuse("the recipe ends on level " + std::to_string(subject.recipe.stage[subject.recipe.stages - 1].level) +
           "; the last stage must have level=0, after 'then refine'");
  refuse("the stages of the recipe do not fit each other, or a number is out of its range");
}

std::vector<std::string> keys_of(const Family& family) {
  std::vector<std::string> keys;
  for (uint8_t i = 0; i < family.number_count; ++i) {
    keys.push_back(family.numbers[i].name);
    if (family.numbers[i].kind == dapple::Number::angles) keys.push_back("angles");
  }
  for (uint8_t i = 0; i < map_numbers(family); ++i) keys.push_back(dapple::along::numbers[i].name);
  if (family.dials.settled > 0) keys.push_back("spot_size");
  if (family.compact != family.model) keys.push_back("cells");
  return keys;
}

std::vector<std::string> common_keys() {
  return {"wavelength", "steps",  "level", "levels", "fine",  "solver", "start", "pitch", "aspect", "jitter",  "radius", "amplitude",
          "length",     "lean",   "fan",   "sides",  "fixed", "ramp",   "range", "light", "gloss",  "grain",   "opacity", "roughness"};
}

std::string decimal_text(int32_t micro) {
  const int64_t value = micro < 0 ? -int64_t{micro} : micro;
  std::string fraction = std::to_string(dapple::base::kMicro + value % dapple::base::kMicro).substr(1);
  fraction.erase(fraction.find_last_not_of('0') + 1);
  return (micro < 0 ? "-" : "") + std::to_string(value / dapple::base::kMicro) +
         (fraction.empty() ? "" : "." + fraction);
}

}  // namespace cli
