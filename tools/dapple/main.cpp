// The command line: picks the command, prints help, turns failures into one line and an exit code.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <new>

#include "commands.hpp"
#include "errors.hpp"
#include "recipes.hpp"

namespace cli {

namespace {

struct CommandEntry {
  const char* name;
  Command command;
  void (*run)(const Options& options);
  uint16_t side;  // default of --size; 0: the command's own
  const char* arguments;
  const char* summary;
};

const CommandEntry kCommands[] = {
    {"list", in_list, list, 256, "[--json]", "every preset: name, family, sentence"},
    {"grow", in_grow, grow, 256, "NAME|RECIPE [key=value ...] [options]", "grow one texture and write it"},
    {"info", in_info, info, 256, "NAME|RECIPE [key=value ...] [options]", "its recipe, its memory, its work"},
    {"sheet", in_sheet, sheet, 128, "[NAME|RECIPE ...] [options]", "one picture of all presets, or of these"},
    {"rule", static_cast<Command>(in_rule | in_grow), rule, 0, "N|random [settle|score|complete] [options]",
     "grow a cell program, ask about it, or find some"},
    {"surface", in_surface, surface, 0, "SHAPE NAME|RECIPE [key=value ...] [options]",
     "grow a texture for a torus, vase, sphere or your own surface"},
    {"stream", in_stream, stream, 0, "NAME|RECIPE [key=value ...] [options]", "fly over the endless plane; q ends it"},
    {"bench", in_bench, bench, 0, "[NAME ...] [options]", "cells a second by every kernel table, of what this machine can do"},
    {"tiles", in_tiles, tiles, 0, "NAME|RECIPE [key=value ...] [options]", "corner tiles, which lay an endless floor"},
};

std::string usage() {
  std::string text = "usage: dapple COMMAND [arguments]\n\n";
  for (const CommandEntry& entry : kCommands) {
    std::string line = std::string("  dapple ") + entry.name + " " + entry.arguments;
    line.resize(std::max<size_t>(line.size(), 54), ' ');
    text += line + " " + entry.summary + "\n";
  }
  return text + "\n  dapple COMMAND --help                                what a command takes\n" +
         "  dapple --help | --version\n\n" + "Exit codes: 0 done, 1 failed, 2 the command line is wrong.\n";
}

std::string keys_help() {
  std::string text =
      "\nNAME is a preset ('dapple list'). RECIPE is a line of text, in quotes: a family and key=value words, then "
      "perhaps\n"
      "'then carry', 'refine', 'freeze' or 'reset' and more of them. key=value arguments change numbers of a preset or recipe:\n\n";
  for (const dapple::recipe::Family& family : dapple::recipe::families)
    text += std::string("  ") + family.name + ": " + listed(keys_of(family)) + "\n";
  return text + "  all: " + listed(common_keys()) + "\n";
}

std::string command_help(const CommandEntry& entry) {
  std::string text = std::string("usage: dapple ") + entry.name + " " + entry.arguments + "\n\n" + entry.summary;
  const std::string size = std::to_string(entry.side);
  if (entry.command != in_list && entry.side != 0) text += "; --size is " + size + " if not given";
  text += "\n\n" + options_help(entry.command);
  if (entry.command & in_rule) return text + rule_help();
  if (entry.command & in_surface) text += surface_help();
  return entry.command & kTakesSubject ? text + keys_help() : text;
}

void print(const std::string& text) {
  std::fputs(text.c_str(), stdout);
  finish_standard_output();
}

bool asks_for_help(const std::string& word) { return word == "--help" || word == "-h"; }

void run(const std::string& name, const std::vector<std::string>& words) {
  if (asks_for_help(name)) return print(usage());
  if (name == "--version") return print("dapple " + version_text() + "\n");
  std::vector<std::string> names;
  for (const CommandEntry& entry : kCommands) {
    names.push_back(entry.name);
    if (name != entry.name) continue;
    if (std::any_of(words.begin(), words.end(), asks_for_help)) return print(command_help(entry));
    Options options;
    options.width = options.height = entry.side;
    read_options(entry.command, words, options);
    return entry.run(options);
  }
  refuse("unknown command " + shown(name) + "; there is " + listed(names) + ", --help, --version");
}

}  // namespace

std::string version_text() {
  return std::to_string(dapple::kVersion / 10000) + "." + std::to_string(dapple::kVersion / 100 % 100) + "." +
         std::to_string(dapple::kVersion % 100);
}

}  // namespace cli

int main(int count, char** words) {
  if (count < 2) {
    std::fputs(cli::usage().c_str(), stderr);
    return cli::kUsage;
  }
  cli::Failure failure{0, ""};
  try {
    cli::run(words[1], std::vector<std::string>(words + 2, words + count));
  } catch (const cli::Failure& stopped) {
    failure = stopped;
  } catch (const std::bad_alloc&) {
    failure = {cli::kFailed, "not enough memory"};
  }
  if (failure.code != 0) std::fprintf(stderr, "dapple: %s\n", failure.text.c_str());
  return failure.code;
}
