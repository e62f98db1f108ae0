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

# --every: frames that are what growing that far gives, numbered, complete.
test_frames() {
  local turing="turing --size 48 scale=6 steps=100" frame
  mkdir "$folder/frames"
  # shellcheck disable=SC2086
  {
    check "--every" run grow $turing --every 40 -o "$folder/frames/%03d.ppm"
    equal "--every: files" "$(ls -A "$folder/frames" | tr '\n' ' ')" "000.ppm 001.ppm 002.ppm "
    for frame in 0 1 2; do
      check "frame $frame" run grow $turing --steps $((40 * frame)) -o "$folder/alone.ppm"
      check "frame $frame is what --steps gives" cmp "$folder/alone.ppm" "$folder/frames/00$frame.ppm"
    done
    check "--every with --steps" run grow $turing --steps 120 --every 120 -o "$folder/frames/long-%01d.png"
    equal "--every with --steps: files" "$(ls "$folder"/frames/long* | wc -l)" 2
    refused 2 frames/ "%04d" -- grow $turing --every 10
    refused 2 "%04d" -- grow $turing --every 10 -o plain.png
    refused 2 "%04d" -- grow $turing --every 10 -o %d.png
    refused 2 "%04d" -- grow $turing --every 10 -o %00d.png
    refused 2 "%04d" -- grow $turing --every 10 -o %02d-%02d.png
    refused 2 "%04d" -- grow $turing --every 10 -o %04s.png
    refused 2 "11 frames" "1 digit" -- grow $turing --every 10 -o %01d.png
    refused 2 "--every '0'" -- grow $turing --every 0 -o %02d.png
    refused 2 --hash -- grow $turing --every 10 -o %02d.png --hash
    refused 2 --maps -- grow $turing --every 10 --maps folder
    refused 1 missing/00.png -- grow $turing --every 10 -o missing/%02d.png
  }
}

for part in picture frames; do
  test_$part
done
echo "kinetics: $passed passed, $failed failed"
[ $failed -eq 0 ]
