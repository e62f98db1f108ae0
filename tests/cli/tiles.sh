#!/usr/bin/env bash
# Tests the command tiles end to end: tiles.sh DAPPLE. One line a failed check, a sum at the end.
# SPDX-License-Identifier: MIT
. "$(dirname "$0")/common.bash"
run() { "$dapple" tiles "$@"; }

python=no
if command -v python3 > /dev/null; then python=yes; else echo "python3 is missing: pictures are not compared"; fi
ask() { [ $python = no ] || check "$*" python3 "$here/tiles.py" "$@"; }

short="threshold scale=1 steps=6 ramp=zebra"
files=$(printf 'preview.%s sheet.%s ' ppm ppm; printf 'tile-%02d.ppm ' $(seq 0 15); echo tiles.txt)

# The files of a set, what they show, and the program that tiles.txt holds, which lays the preview.
test_set() {
  local how
  for how in "--size 40 --seed 5" "--size 32 --seed 0xffffffff --view cells" "--size 36 --threads 3 --budget 7"; do
    rm -rf -- *
    # shellcheck disable=SC2086
    equal "$how says nothing" "$(run "$short" $how --format ppm -o set 2>&1)" ""
    equal "$how writes" "$(ls -A)/$(ls -A set | tr '\n' ' ')" "set/${files} "
    sed -n '/^#include/,$p' set/tiles.txt > "$folder/tile_at.c"
    cat "$here/tile_at.c" >> "$folder/tile_at.c"
    if command -v cc > /dev/null; then
      check "tiles.txt is C" cc -std=c99 -Wall -Wextra -Werror "$folder/tile_at.c" -o "$folder/tile_at"
      set -- $how
      "$folder/tile_at" "$(sed -nE 's/^Corner tiles, seed ([0-9]+),.*/\1/p' set/tiles.txt)" > "$folder/floor"
      ask laid set "$2" "$folder/floor"
    else
      echo "cc is missing: the floor is not compared"
    fi
  done
  run "$short" --size 36 -o again --format ppm
  check "--threads and --budget change nothing" diff -r set again
  run "$short" --size 36 -o again --format ppm --seed 2
  differ "another seed" "$(cat set/sheet.ppm | cksum)" "$(cat again/sheet.ppm | cksum)"
  equal "files that are there are replaced" "$(ls -A again | wc -l)" 19
}

test_names() {
  rm -rf -- *
  run zebra steps=2
  equal "the folder's name" "$(ls -A)" zebra-tiles
  check "png" ls zebra-tiles/tile-15.png zebra-tiles/sheet.png zebra-tiles/preview.png
  check "eight wavelengths" grep -q "Sixteen tiles of 144 x 144 pixels" zebra-tiles/tiles.txt
  rm -rf -- *
  run mitosis steps=1 --size 60 --format c -o set
  check "headers" grep -q 'tile_03' set/tile-03.h
}

test_refusals() {
  rm -rf -- *
  refused 2 "zebra-bits" "endless plane" -- zebra-bits -o set
  refused 2 "fingerprint" "endless plane" -- fingerprint -o set
  refused 2 "cells" "texture" "endless plane" -- "cells rule=3" -o set
  refused 2 "texture" "threshold family and Gray-Scott" -- turing -o set
  refused 2 "leopard" "threshold family and Gray-Scott" -- leopard -o set
  refused 2 "map" "differs from tile to tile" -- "mapped map=swirl" -o set
  refused 2 "steps" -- zebra steps=0 -o set
  refused 2 "--size 50 is too small" zebra "at least 51" -- zebra --size 50 -o set
  refused 2 "--size '7'" "8 to 8191" -- zebra --size 7 -o set
  refused 2 "--size '64x64'" "8 to 8191" -- zebra --size 64x64 -o set
  refused 2 "--size '8192'" "8 to 8191" -- zebra --size 8192 -o set
  refused 2 "--size 105" "multiple of 2" -- zebra levels=2 --size 105 -o set
  refused 2 "-o '-'" folder -- zebra -o -
  refused 2 "-o ''" folder -- zebra -o ""
  refused 2 "--at" -- zebra --at 0,0 -o set
  refused 2 "pgm file holds l8" -- zebra --format pgm --pixels rgb888 -o set
  refused 2 "is missing" -- -o set
  refused 1 "cannot make the folder" "No such file" -- zebra -o none/set
  refused 1 "cannot make the folder '/dev/null'" -- zebra -o /dev/null
  refused 1 "cannot make the folder '/proc/set'" -- zebra -o /proc/set
}

# A folder that was there keeps what it had, and gets nothing but whole sets.
test_failures() {
  local job tries=0
  rm -rf -- * && mkdir set && echo mine > set/mine.txt && mkdir set/tile-07.png
  run zebra steps=2 -o set 2> "$folder/err"
  equal "a folder in the way: exit code" $? 1
  check "a folder in the way: says so" grep -q "tile-07.png.*directory" "$folder/err"
  equal "nothing but what was there" "$(ls -A set | tr '\n' ' ')" "mine.txt tile-07.png "
  rmdir set/tile-07.png && (cd set && ln -s /dev/full preview.png)
  run zebra steps=2 -o set 2> "$folder/err"
  equal "a full disk: exit code" $? 1
  equal "a full disk: no half set" "$(ls -A set | tr '\n' ' ')" "mine.txt preview.png "
  rm -rf -- *
  "$dapple" tiles gs-worms steps=1000000 --size 128 -o long &
  job=$!
  while [ -z "$(ls -A long 2> /dev/null)" ] && [ $tries -lt 100 ]; do sleep 0.05; tries=$((tries + 1)); done
  check "unfinished files have names of their own" ls long/.dapple-*.part
  kill -TERM $job
  wait $job 2> /dev/null
  equal "ended by the signal" $? 143
  equal "nothing is left" "$(ls -A)" ""
}

for part in set names refusals failures; do test_$part; done
echo "tiles: $passed passed, $failed failed"
[ $failed -eq 0 ]
