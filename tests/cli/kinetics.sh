#!/usr/bin/env bash
# Tests kinetics on the command line: kinetics.sh DAPPLE. One line a failed check, a sum at the end.
# SPDX-License-Identifier: MIT
. "$(dirname "$0")/common.bash"

run() { "$dapple" "$@"; }
hash_of() { run grow "$@" --hash; }

# growth=@FILE: grey and colour pictures, of any size; what is no picture is refused.
test_picture() {
  local in=$folder/pictures
  mkdir "$in"
  printf 'P5\n2 2\n255\n\0\0\0\0' > "$in/black.pgm"
  printf 'P5\n2 2\n255\n\0\377\377\0' > "$in/checks.pgm"
  printf 'P6\n2 2\n255\n\0\0\0\377\377\377\377\377\377\0\0\0' > "$in/checks.ppm"
  printf 'P5\n9 9\n255\n123' > "$in/short.pgm"
  local small="--size 64 steps=60 growth=14.4"
  # shellcheck disable=SC2086
  {
    equal "black is dark" "$(hash_of turing $small growth=@"$in/black.pgm")" "$(hash_of turing $small)"
    differ "a picture" "$(hash_of turing $small growth=@"$in/checks.pgm")" "$(hash_of turing $small)"
    equal "a colour picture" "$(hash_of turing $small growth=@"$in/checks.ppm")" "$(hash_of turing $small growth=@"$in/checks.pgm")"
  }
  refused 1 short.pgm "3 bytes of pixels, not 81" -- grow turing growth=@"$in/short.pgm"
  refused 1 nothing.pgm -- grow turing growth=@nothing.pgm
  refused 2 "growth=@FILE" -- grow turing solver=pictured
  refused 2 "plain|cascade" -- grow schnakenberg growth=@"$in/black.pgm"
}

for part in picture; do
  test_$part
done
echo "kinetics: $passed passed, $failed failed"
[ $failed -eq 0 ]
