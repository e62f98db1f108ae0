# Writes files with their includes in their place: headers once, files without `#pragma once` (lists such as
# presets.def) every time, headers of the system once. Variables: root (with a slash); header and source, to be written.
# SPDX-License-Identifier: MIT

# "evolve/../grid/rows.hpp" to "grid/rows.hpp"
function tidy(path) {
  while (path ~ /[^\/]+\/\.\.\//) sub(/[^\/]+\/\.\.\//, "", path)
  return path
}

function folder_of(path) {
  return path ~ /\// ? substr(path, 1, match(path, /[^\/]*$/) - 1) : ""
}

function stop(why) {
  print why > "/dev/stderr"
  failed = 1
  exit 1
}

# A line of a file, after a mark where it is not the file of the line before.
function put(path, line, out) {
  if (line == "" && (at[out] != path || last[out] == "")) return
  if (at[out] != path) print "\n// ---- lib/" path " ----" > out
  at[out] = path
  last[out] = line
  print line > out
}

function include_of_system(line, out) {
  if (line in seen) return
  seen[line] = 1
  at[out] = ""
  print line > out
}

# depth: of the includes; awk has one kind of locals, further parameters.
function paste(path, out, depth,    line, target, lines, text, i, once, got) {
  if (path in seen) return
  if (depth > 40) stop(path ": includes itself")
  lines = 0
  while ((got = (getline line < (root path))) > 0) text[++lines] = line
  if (got < 0) stop("lib/" path ": cannot be read")
  close(root path)
  for (i = 1; i <= lines; ++i) if (text[i] ~ /^#pragma once$/) once = 1
  if (once || path ~ /\.cpp$/) seen[path] = 1
  for (i = 1; i <= lines; ++i) {
    line = text[i]
    if (line ~ /^#pragma once$/ || line ~ /^\/\/ SPDX-License-Identifier: /) continue
    if (line ~ /^[ \t]*#[ \t]*include[ \t]*</) include_of_system(line, out)
    else if (line ~ /^[ \t]*#[ \t]*include[ \t]*"/) {
      target = line
      sub(/^[^"]*"/, "", target)
      sub(/".*$/, "", target)
      paste(tidy(folder_of(path) target), out, depth + 1)
    } else if (path != "one.cpp") put(path, line, out)
  }
}

BEGIN {
  paste("dapple.hpp", header, 0)
  paste("atlas.hpp", header, 0)
  paste("chunks.hpp", header, 0)
  paste("corners.hpp", header, 0)
  paste("tile.hpp", header, 0)
  paste("recipe/list.hpp", header, 0)
  paste("one.cpp", source, 0)
  exit failed
}
