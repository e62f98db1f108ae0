// The options of all commands: one table, from which help is made too.
// SPDX-License-Identifier: MIT
#include "options.hpp"

#include <algorithm>
#include <cctype>

#include "errors.hpp"
#include "rule_styles.hpp"
#include "recipe/word.hpp"
#include "recipe/ramps.hpp"

namespace cli {

using dapple::recipe::Word;

namespace {

struct Option {
  const char* name;
  const char* value;  // how help calls it; null: the option takes none
  unsigned commands;
  const char* help;
  void (*read)(Options& options, const std::string& value);
};

[[noreturn]] void refuse_value(const char* name, const std::string& value, const std::string& allowed) {
  refuse(std::string(name) + " " + shown(value) + ": give " + allowed);
}

// Decimal digits or, where `hexadecimal`, 0x and hexadecimal digits; false when that is not what the text is.
bool read_number(const std::string& text, bool hexadecimal, uint32_t& value) {
  const bool hex = hexadecimal && text.size() > 2 && text[0] == '0' && (text[1] == 'x' || text[1] == 'X');
  const std::string digits = hex ? text.substr(2) : text;
  uint64_t sum = 0;
  for (const char c : digits) {
    const int digit = dapple::recipe::hex_digit(c);
    if (digit < 0 || (!hex && digit > 9)) return false;
    sum = sum * (hex ? 16 : 10) + static_cast<uint64_t>(digit);
    if (sum > UINT32_MAX) return false;
  }
  value = static_cast<uint32_t>(sum);
  return !digits.empty();
}

uint32_t number(const char* name, const std::string& text, uint32_t low, uint32_t high, bool hexadecimal = false) {
  uint32_t value = 0;
  if (!read_number(text, hexadecimal, value) || value < low || value > high)
    refuse_value(name, text,
                 "a whole number from " + std::to_string(low) + " to " + std::to_string(high) +
                     (hexadecimal ? ", decimal or 0x and hexadecimal" : ""));
  return value;
}

// "4x3", both within the range; false when that is not what the text is.
bool read_pair(const std::string& text, uint32_t low, uint16_t& first, uint16_t& second) {
  const size_t x = text.find('x');
  uint32_t a = 0, b = 0;
  if (x == std::string::npos || !read_number(text.substr(0, x), false, a) || !read_number(text.substr(x + 1), false, b))
    return false;
  if (a < low || a > UINT16_MAX || b < low || b > UINT16_MAX) return false;
  first = static_cast<uint16_t>(a);
  second = static_cast<uint16_t>(b);
  return true;
}

// A whole number with a sign, within int32.
bool read_signed(const std::string& text, int32_t& value) {
  const bool negative = text[0] == '-';
  uint32_t size = 0;
  if (!read_number(text.substr(negative), false, size) || size > uint32_t{INT32_MAX} + negative) return false;
  value = static_cast<int32_t>(negative ? -int64_t{size} : int64_t{size});
  return true;
}

// Index of the value among words separated by '|'.
int choice(const char* name, const std::string& value, const char* words) {
  const Word word = {value.c_str(), static_cast<uint16_t>(std::min<size_t>(value.size(), UINT16_MAX))};
  const int index = dapple::recipe::index_of(word, words);
  if (index >= 0) return index;
  std::string allowed = words;
  for (size_t bar; (bar = allowed.find('|')) != std::string::npos;) allowed.replace(bar, 1, ", ");
  refuse_value(name, value, "one of " + allowed);
}

void read_size(Options& o, const std::string& value) {
  const std::string pair = value.find('x') == std::string::npos ? value + "x" + value : value;
  if (!read_pair(pair, dapple::kSmallestSide, o.width, o.height))
    refuse_value("--size", value, "N or WxH, each side from 8 to 65535");
}

void read_at(Options& o, const std::string& value) {
  const size_t comma = value.find(',');
  Place place{};
  if (comma == std::string::npos || !read_signed(value.substr(0, comma), place.x) ||
      !read_signed(value.substr(comma + 1), place.y))
    refuse_value("--at", value, "X,Y, two whole numbers from -2147483648 to 2147483647");
  o.at = place;
}

void read_repeat(Options& o, const std::string& value) {
  o.repeat = true;
  if (!read_pair(value, 1, o.across, o.down))
    refuse_value("--repeat", value, "CxR, columns and rows, each from 1 to 65535");
}

void read_ramp(Options& o, const std::string& value) {
  dapple::Ramp ramp{};
  if (value.size() < 1000 && dapple::recipe::read_ramp(dapple::recipe::word_of(value.c_str()), ramp)) {
    o.ramp = ramp;
    return;
  }
  std::vector<std::string> names;
  for (const dapple::recipe::NamedRamp& named : dapple::recipe::ramps) names.push_back(named.name);
  refuse_value("--ramp", value, "stops (000000,ff8000 or 0:000000,255:ffffff, at most 8) or one of " + listed(names));
}

void read_output(Options& o, const std::string& value) {
  if (value.empty()) refuse_value("-o", value, "a file name, or - for standard output");
  o.output = value;
}

constexpr const char* kViews = "colour|field|cells|height|normal|opacity|roughness";

void read_any_size(Options& o, const std::string& value) {
  const std::string pair = value.find('x') == std::string::npos ? value + "x" + value : value;
  if (!read_pair(pair, 1, o.width, o.height))
    refuse_value("--size", value, "N or WxH, each side from 8 (of complete 1) to 65535");
}

// A decimal number from low to high, all in 1/1000000.
int32_t decimal(const char* name, const std::string& text, int32_t low, int32_t high, const char* allowed) {
  int32_t value = 0;
  const bool read = text.size() < 40 && dapple::recipe::read_decimal(dapple::recipe::word_of(text.c_str()), value);
  if (!read || value < low || value > high) refuse_value(name, text, allowed);
  return value;
}

std::string file_name(const char* name, const std::string& value) {
  if (value.empty()) refuse_value(name, value, "a file name");
  return value;
}

void read_tile_size(Options& o, const std::string& value) {
  o.width = o.height = static_cast<uint16_t>(number("--size", value, dapple::kSmallestSide, kLargestSheetTile));
}

void read_start_file(Options& o, const std::string& value) {
  if (value.empty()) refuse_value("--start", value, "the name of a file of run-length text");
  o.start = value;
}

// Where a command has two options of a name, the first one counts.
const Option kOptions[] = {
    {"--size", "N|WxH", in_rule, "cells; sides from 8 (of complete 1) to 65535", read_any_size},
    {"--start", "FILE", in_rule, "begin with the pattern of an RLE file, in the middle of a torus, and not with noise",
     read_start_file},
    {"--rle", nullptr, in_rule, "write the state as RLE, as -o FILE.rle does",
     [](Options& o, const std::string&) { o.rle = true; }},
    {"--text", nullptr, in_rule, "write the state as text, to standard output if there is no -o",
     [](Options& o, const std::string&) { o.text = true; }},
    {"--map", nullptr, in_rule, "print the program as Golly's MAP, and grow nothing",
     [](Options& o, const std::string&) { o.map = true; }},
    {"--budget", "N", in_rule, "of complete: cells it chooses before it gives up (200000); else rows of work at once",
     [](Options& o, const std::string& v) { o.budget = number("--budget", v, 1, UINT32_MAX), o.tries = o.budget; }},
    {"--style", "STYLE", in_rule, "of random: uniform, inertia, mirror, outer-totalistic (inertia)",
     [](Options& o, const std::string& v) { o.style = static_cast<uint8_t>(choice("--style", v, kStyles)); }},
    {"--count", "N", in_rule, "of random: programs wanted, 1 to 1000 (24)",
     [](Options& o, const std::string& v) { o.count = number("--count", v, 1, 1000); }},
    {"--json", nullptr, in_rule, "of settle, score, complete and random: the answer as JSON",
     [](Options& o, const std::string&) { o.json = true; }},
    {"--size", "N|WxH", in_surface,
     "cells of a patch (torus 384x192, vase 256x256, sphere and atlas 96; else the file's)", read_size},
    {"--ratio", "R", in_surface,
     ".01 to .95: of a torus, the tube's radius in the ring's (.5); of a vase, its swell (.45)",
     [](Options& o, const std::string& v) {
       o.ratio = decimal("--ratio", v, 10000, 950000, "a number from .01 to .95");
     }},
    {"--tall", "T", in_surface,
     ".01 to 10: of a vase, its height in mean circumferences (.9); of --heights, white in\nwidths of the picture (.1)",
     [](Options& o, const std::string& v) {
       o.tall = decimal("--tall", v, 10000, 10000000, "a number from .01 to 10");
     }},
    {"--heights", "FILE", in_surface, "of flat: a PGM, PPM or PNG picture, a height for every cell",
     [](Options& o, const std::string& v) { o.heights = file_name("--heights", v); }},
    {"--metric", "FILE", in_surface,
     "of flat: text, 'WIDTH HEIGHT [PATCHES]' and xx xy yy of every cell's metric tensor",
     [](Options& o, const std::string& v) { o.metric = file_name("--metric", v); }},
    {"--atlas", "FILE", in_surface,
     "of flat: text, lines 'PATCH SIDE PATCH SIDE [reversed]', 'PATCH SIDE closed' or\n"
     "'PATCH SIDE fixed A B'; sides are left, right, top, bottom, those not named closed",
     [](Options& o, const std::string& v) { o.atlas = file_name("--atlas", v); }},
    {"--preview", "FILE", in_surface, "write a picture of the object too, without and with correction",
     [](Options& o, const std::string& v) { o.preview = file_name("--preview", v); }},
    {"--markdown", nullptr, in_bench, "as a page: also how long every preset takes",
     [](Options& o, const std::string&) { o.markdown = true; }},
    {"--json", nullptr, in_list | in_info | in_bench, "as JSON", [](Options& o, const std::string&) { o.json = true; }},
    {"--size", "N|WxH", in_grow | in_info | in_sheet, "cells, which are the tile's pixels; sides from 8 to 65535",
     read_size},
    {"--at", "X,Y", in_grow | in_info, "a window of the endless plane, its left upper pixel at X,Y, instead of a tile",
     read_at},
    {"--size", "WxH", in_stream, "pixels of the view, two a character (the terminal's; piped 80x46)", read_size},
    {"--at", "X,Y", in_stream, "where the flight begins (0,0)", read_at},
    {"--frames", "N", in_stream, "stop after N frames, 1 to 1000000 (piped 60; in the terminal none)",
     [](Options& o, const std::string& v) { o.frames = number("--frames", v, 1, 1000000); }},
    {"--size", "N", in_tiles, "pixels of a tile, either way, from 8 to 8191 (eight wavelengths or a little more)", read_tile_size},
    {"-o", "FOLDER", in_tiles, "where the files go, made if it is not there (NAME-tiles)",
     [](Options& o, const std::string& v) {
       if (v.empty()) refuse_value("-o", v, "the name of a folder");
       o.output = v;
     }},
    {"--seed", "N", in_grow | in_sheet | in_stream | in_tiles | in_surface,
     "0 to 4294967295, decimal or 0x...; another seed, another tile (1337)",
     [](Options& o, const std::string& v) { o.seed = number("--seed", v, 0, UINT32_MAX, true); }},
    {"--steps", "N", in_grow, "stop after N steps in all (the recipe's); 0 shows the start",
     [](Options& o, const std::string& v) { o.steps = number("--steps", v, 0, 1000000); }},
    {"--map-as", "HOW", in_grow | in_info,
     "how map=@FILE (PGM, PPM, PNG) is read: structure, stripes along what the picture shows;\n"
     "values, grey as 0 to 180 degrees, red and green as the doubled vector (structure)",
     [](Options& o, const std::string& v) { o.map_as = static_cast<MapAs>(choice("--map-as", v, kMapAs)); }},
    {"-o", "FILE", in_grow | in_sheet | in_surface,
     "file to write; its suffix picks the format; - is standard output", read_output},
    {"--format", "FORMAT", in_grow | in_sheet | in_tiles | in_surface,
     "png, png-own, pgm, ppm, pbm (bit 1: set, or light), qoi, raw, c (a C header)",
     [](Options& o, const std::string& v) { o.format = static_cast<Format>(choice("--format", v, kFormats)); }},
    {"--view", "VIEW", in_grow | in_sheet | in_tiles | in_surface, "colour, field, cells, height, normal, opacity, roughness (colour)",
     [](Options& o, const std::string& v) { o.view = static_cast<dapple::View>(choice("--view", v, kViews)); }},
    {"--pixels", "FORMAT", in_grow | in_sheet | in_tiles | in_surface,
     "for raw and c: l8, rgb888, rgba8888, rgb565, rgb565_swapped, l1_msb, l1_lsb,\n"
     "l1_pages, l16, l16_swapped (rgba8888); for png the first three and the last\n"
     "(rgb888, grey views l8), for qoi two of the first, for pgm l8 and the last",
     [](Options& o, const std::string& v) { o.pixels = static_cast<dapple::Pixels>(choice("--pixels", v, kPixels)); }},
    {"--ramp", "NAME|STOPS", in_grow | in_tiles | in_surface,
     "other colours: a ramp's name, or stops like 102030,ffd080", read_ramp},
    {"--dither", nullptr, in_grow | in_sheet | in_tiles | in_surface,
     "ordered dither, for pixels of less than eight bits a channel",
     [](Options& o, const std::string&) { o.dither = true; }},
    {"--flip-y", nullptr, in_grow | in_sheet | in_tiles | in_surface, "normal maps whose green points down",
     [](Options& o, const std::string&) { o.flip_y = true; }},
    {"--maps", "FOLDER", in_grow,
     "write a material: FOLDER/NAME_height.png (16 bit), _normal, _colour (unlit),\n"
     "_opacity, _roughness",
     [](Options& o, const std::string& v) {
       if (v.empty()) refuse_value("--maps", v, "the name of a folder");
       o.maps = v;
     }},
    {"--mips", nullptr, in_grow, "with --maps: every level down to one pixel too, NAME_colour.1.png and on",
     [](Options& o, const std::string&) { o.mips = true; }},
    {"--every", "N", in_grow,
     "with -o frames/%04d.png: the start, then a picture every N steps, numbered",
     [](Options& o, const std::string& v) { o.every = number("--every", v, 1, dapple::kMaxSteps); }},
    {"--repeat", "CxR", in_grow, "write the tile repeated, C columns and R rows", read_repeat},
    {"--budget", "ROWS", in_grow | in_tiles | in_surface, "rows of work at once; never changes the bytes",
     [](Options& o, const std::string& v) { o.budget = number("--budget", v, 1, UINT32_MAX); }},
    {"--threads", "N", in_grow | in_info | in_tiles | in_surface | in_stream,
     "1 to 64 threads, each with bands of rows (stream: chunks) of its own; never changes the bytes (1)",
     [](Options& o, const std::string& v) {
       o.bands = static_cast<uint8_t>(number("--threads", v, 1, dapple::kMaxBands));
     }},
    {"--kernels", "KERNELS", in_grow, "portable, best, or those of an instruction set; never changes the bytes (best)",
     [](Options& o, const std::string& v) { o.kernels = kernels_named(v); }},
    {"--hash", nullptr, in_grow | in_surface, "print the hash of the field, 16 hexadecimal digits, and write nothing",
     [](Options& o, const std::string&) { o.hash = true; }},
};

const Option& option_named(Command command, const std::string& name) {
  std::vector<std::string> names;
  for (const Option& option : kOptions) {
    if ((option.commands & command) == 0) continue;
    if (name == option.name) return option;
    if (std::find(names.begin(), names.end(), option.name) == names.end()) names.push_back(option.name);
  }
  refuse("unknown option " + shown(name) + "; there is " + listed(names) + ", --help");
}

// "key=value", perhaps more of them behind it.
bool is_change(const std::string& word) {
  const auto key = [](unsigned char c) { return std::isalnum(c) || c == '-' || c == '_'; };
  const auto mark = std::find_if_not(word.begin(), word.end(), key);
  return mark != word.end() && *mark == '=';
}

void read_plain_word(Command command, const std::string& word, Options& options) {
  const bool subject = (command & kTakesSubject) != 0;
  if ((command & in_rule) != 0 && (options.subject.empty() || (options.verb.empty() && !is_change(word)))) {
    if (word.empty()) refuse("'' is not a cell program; give a number, MAP..., or random");
    (options.subject.empty() ? options.subject : options.verb) = word;
  } else if ((command & in_surface) != 0 && options.shape.empty()) {
    options.shape = word;
  } else if (subject && options.subject.empty() && !is_change(word)) {
    if (word.empty()) refuse("'' is not the name of a preset or a recipe; 'dapple list' shows the presets");
    options.subject = word;
  } else if ((command & (in_sheet | in_bench)) != 0 && !word.empty()) {
    options.wanted.push_back(word);
  } else if (subject && is_change(word)) {
    options.changes.push_back(word);
  } else {
    refuse("unexpected argument " + shown(word) + (subject ? "; after the preset come options and key=value" : ""));
  }
}

}  // namespace

void read_options(Command command, const std::vector<std::string>& words, Options& options) {
  for (size_t i = 0; i < words.size(); ++i) {
    if (words[i].size() < 2 || words[i][0] != '-') {
      read_plain_word(command, words[i], options);
      continue;
    }
    const Option& option = option_named(command, words[i]);
    if (option.value != nullptr && ++i == words.size())
      refuse(std::string(option.name) + " needs a value: " + option.value);
    option.read(options, option.value != nullptr ? words[i] : "");
  }
  if ((command & in_rule) != 0 && options.subject.empty())
    refuse("the cell program is missing; give a number, MAP..., or random");
  if ((command & in_surface) != 0 && choice("the surface", options.shape, kShapes) < 3 &&
      !(options.heights + options.metric + options.atlas).empty())
    refuse("--heights, --metric and --atlas are for the surface flat");
  if ((command & kTakesSubject) != 0 && options.subject.empty())
    refuse("the name of a preset or a recipe is missing; 'dapple list' shows the presets");
  if (options.at && options.repeat)
    refuse("--repeat is for tiles, which repeat without a seam; a window of the plane (--at) does not");
  if (options.flip_y && options.view != dapple::View::normal && options.maps.empty())
    refuse("--flip-y is for --view normal only, and --maps");
}

std::string options_help(Command command) {
  constexpr size_t kColumn = 22;
  std::string text;
  for (const Option& option : kOptions) {
    if ((option.commands & command) == 0 || &option != &option_named(command, option.name)) continue;
    std::string left = std::string("  ") + option.name + (option.value != nullptr ? " " : "");
    left += option.value != nullptr ? option.value : "";
    left.resize(std::max(kColumn, left.size() + 2), ' ');
    for (const char* c = option.help; *c != 0; ++c)
      left += *c == '\n' ? "\n" + std::string(kColumn, ' ') : std::string(1, *c);
    text += left + "\n";
  }
  return text + "  --help              this text\n";
}

std::string size_text(uint32_t width, uint32_t height) { return std::to_string(width) + "x" + std::to_string(height); }

std::string place_text(Place place) { return std::to_string(place.x) + "," + std::to_string(place.y); }

dapple::Domain domain_of(const Options& options) {
  if (!options.at) return dapple::torus(options.width, options.height);
  return dapple::window(options.at->x, options.at->y, options.width, options.height);
}

static Format format_asked_for(const Options& options) {
  if (options.format) return *options.format;
  Format format = Format::png;
  if (options.output.empty() || options.output == "-" || format_of(options.output, format)) return format;
  refuse("-o " + shown(options.output) +
         ": its suffix names no format; give .png, .pgm, .ppm, .pbm, .qoi, .raw, .h or .c, " + "or --format");
}

// Grey views need no colours.
static dapple::Pixels usual_pixels(const Options& options, Format format) {
  const bool coloured = options.view == dapple::View::colour || options.view == dapple::View::normal;
  const bool png = format == Format::png || format == Format::png_own;
  return png && !coloured ? dapple::Pixels::l8 : pixels_of(format).front();
}

Target target_of(const Options& options, const std::string& name) {
  const Format format = format_asked_for(options);
  const dapple::Pixels pixels = options.pixels.value_or(usual_pixels(options, format));
  const std::vector<dapple::Pixels> allowed = pixels_of(format);
  if (std::find(allowed.begin(), allowed.end(), pixels) == allowed.end()) {
    std::vector<std::string> names;
    for (const dapple::Pixels p : allowed) names.push_back(name_of(p));
    refuse("--pixels " + name_of(pixels) + ": a " + name_of(format) + " file holds " + listed(names));
  }
  return {options.output.empty() ? name + suffix_of(format) : options.output, format, pixels};
}

}  // namespace cli
