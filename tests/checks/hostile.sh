#!/usr/bin/env bash
# The same bytes from two compilers, at every optimisation, as one file or many, with signed and unsigned char, in 32 and
# 64 bits, and clean under the sanitizers: what small_goldens.cpp prints equals tests/golden/small.txt.
#   hostile.sh [--bless]     --bless writes that file from a plain build first
# SPDX-License-Identifier: MIT
. "$(dirname "$0")/common.bash"
need g++ clang++

golden=$root/tests/golden/small.txt
program=tests/checks/small_goldens.cpp
sanitize="-g -fsanitize=address,undefined,implicit-unsigned-integer-truncation -fno-sanitize-recover=all"
strict="-std=c++17 -Wall -Wextra -Werror -I$root/lib"

# One build a line: one|many compiler options
builds() {
  local compiler
  for compiler in g++ clang++; do
    echo "one $compiler -O3 -march=native -ftree-vectorize"
    can_build $compiler -m32 && echo "one $compiler -O2 -m32"
  done
  echo "one g++ -O0 -funsigned-char"
  echo "many clang++ -O2 $sanitize"
}

can_build() { echo '#include <vector>
int main() { return std::vector<int>(1)[0]; }' | "$1" "$2" -x c++ - -o "$scratch/can" 2> /dev/null && "$scratch/can" 2> /dev/null; }

# A change every build agrees on is told once.
same_change_everywhere() {
  [ "$(find "$scratch" -name '*.bad' | wc -l)" -eq "$(wc -l < "$scratch/builds")" ] &&
    [ "$(cat "$scratch"/*.txt | sort -u | wc -l)" -eq "$(wc -l < "$scratch/1.txt")" ]
}

# run_build NUMBER one|many COMPILER OPTIONS...: says what differs, if anything does
run_build() {
  local out=$scratch/$1 how=$2 sources="$root/lib/one.cpp"
  shift 2
  [ "$how" = one ] || sources=$(find "$root/lib" -name '*.cpp' ! -name one.cpp)
  # shellcheck disable=SC2086
  if ! "$@" $strict "$root/$program" $sources -o "$out" > "$out.log" 2>&1; then
    printf '%s\n' "$how, $*: does not build" "$(head -5 "$out.log")" > "$out.bad"
  elif ! "$out" > "$out.txt" 2> "$out.log" || ! cmp -s "$golden" "$out.txt"; then
    printf '%s\n' "$how, $*: not the bytes of tests/golden/small.txt" "$(grep -m1 -hE 'ERROR|runtime error' "$out.log")" \
      "$(diff "$golden" "$out.txt" | grep '^[<>]' | head -4)" > "$out.bad"
  fi
  rm -f "$out"
}

bless() {
  # shellcheck disable=SC2086
  g++ $strict -O2 "$root/$program" "$root/lib/one.cpp" -o "$scratch/plain" && "$scratch/plain" > "$scratch/plain.txt" ||
    { fail "the plain build fails: $(tail -3 "$scratch/plain.txt")"; finish; }
  cp "$scratch/plain.txt" "$golden"
  echo "wrote tests/golden/small.txt"
}

if [ "${1:-}" = --bless ]; then bless; fi
export -f run_build
export scratch root golden program strict
builds > "$scratch/builds"
grep -n '' "$scratch/builds" | sed 's/:/ /' | xargs -P "$(nproc)" -I{} bash -c 'run_build {}'
if same_change_everywhere; then
  fail "all builds agree on other bytes (meant? then --bless): $(diff "$golden" "$scratch/1.txt" | grep '^[<>]')"
else
  for bad in "$scratch"/*.bad; do [ -f "$bad" ] && fail "$(cat "$bad")"; done
fi
echo "$(wc -l < "$scratch/builds") builds, $(wc -l < "$golden") textures"
finish
