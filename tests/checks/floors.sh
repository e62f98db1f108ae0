#!/usr/bin/env bash
# The house keeps its order: floors only look down, lib/ is integers without heap, files stay short.
# SPDX-License-Identifier: MIT
. "$(dirname "$0")/common.bash"

floor_of() {
  case $1 in
    base/*) echo 0 ;;
    grid/*) echo 1 ;;
    start/* | stencil/* | model/* | paint/*) echo 2 ;;
    evolve/*) echo 3 ;;
    recipe/*) echo 4 ;;
    */*) echo none ;;
    *) echo 5 ;;
  esac
}

# One include of a file of lib/: "file:line" and what stands between the quotes.
check_include() {
  local file=${1%%:*} from to
  if [ ! -f "$root/lib/$(dirname "$file")/$2" ]; then fail "lib/$1: \"$2\" is not relative to the file, or missing"; return; fi
  local target
  target=$(realpath -m --relative-to="$root/lib" "$root/lib/$(dirname "$file")/$2")
  from=$(floor_of "$file") to=$(floor_of "$target")
  [ "$to" != none ] || { fail "lib/$1: $target is on no floor"; return; }
  [ "$(dirname "$file")" = "$(dirname "$target")" ] && return
  [ "$to" -lt "$from" ] || fail "lib/$1: floor $from includes $target of floor $to"
}

includes_look_down() {
  local where name file
  for file in $(files_of_tree lib); do
    [ "$(floor_of "${file#lib/}")" != none ] || fail "$file: on no floor"
  done
  while IFS=$'\t' read -r where name; do
    case $name in
      \"*\") check_include "$where" "${name:1:-1}" ;;
      '<stdint.h>' | '<stddef.h>') ;;
      *) fail "lib/$where: includes $name; lib/ has only <stdint.h> and <stddef.h>" ;;
    esac
  done < <(cd "$root/lib" && grep -rnE '^[[:space:]]*#[[:space:]]*include' . |
           sed -E 's|^\./([^:]*:[0-9]+):[[:space:]]*#[[:space:]]*include[[:space:]]*([^[:space:]]*).*|\1\t\2|')
}

# Code without comments, strings and characters, as file:line:text.
bare_code() {
  (cd "$root" && files_of_tree lib | xargs awk '{
     gsub(/\\./, ""); gsub(/"[^"]*"/, "\"\""); gsub(/\047[^\047]*\047/, "0"); sub(/\/\/.*/, ""); print FILENAME ":" FNR ":" $0 }')
}

integers_without_heap() {
  local line
  while IFS= read -r line; do fail "not in lib/: $line"
  done < <(bare_code | grep -wE 'float|double|new|malloc|calloc|realloc|free|throw|try|catch|virtual|typeid|dynamic_cast|std|__int128')
  while IFS= read -r line; do fail "only base/port.hpp looks at the compiler: $line"
  done < <(bare_code | grep -E '^[^:]*:[0-9]+:[[:space:]]*#[[:space:]]*(if|ifdef|ifndef|elif)' | grep -v '^lib/base/port\.hpp:')
}

files_are_short() {
  local file lines
  for file in $(files_of_tree lib ports tools tests demo | grep -v '^tests/golden/'); do
    lines=$(wc -l < "$root/$file")
    [ "$lines" -lt 400 ] || fail "$file has $lines lines; under 400 is the rule"
    case $file in
      *.cpp | *.hpp) head -20 "$root/$file" | grep -qx '// SPDX-License-Identifier: MIT' || fail "$file: no SPDX line" ;;
    esac
  done
}

one_file_is_whole() {
  local have want
  want=$(cd "$root/lib" && find . -name '*.cpp' ! -name one.cpp | sed 's|^\./||' | sort)
  have=$(sed -nE 's/^#include "(.*\.cpp)"$/\1/p' "$root/lib/one.cpp" | sort)
  [ "$have" = "$want" ] || fail "lib/one.cpp and the .cpp files of lib/ differ: $(diff <(echo "$have") <(echo "$want") | grep '^[<>]' | tr '\n' ' ')"
}

includes_look_down
integers_without_heap
files_are_short
one_file_is_whole
finish
