#!/usr/bin/env bash
# Tests the maps of a material: maps.sh DAPPLE. One line a failed check, a sum at the end.
# SPDX-License-Identifier: MIT
. "$(dirname "$0")/common.bash"
. "$here/pictures.bash"

# Five maps, or five chains of levels: sizes, depths, no seam.
test_maps() {
  local map
  makes material grow coral --size 97x64 --maps material
  equal "--maps: files" "$(ls "$folder/material" | tr '\n' ' ')" \
    "coral_colour.png coral_height.png coral_normal.png coral_opacity.png coral_roughness.png "
  cd "$folder" || exit 1
  for map in colour height normal opacity roughness; do
    pictures size material/coral_$map.png 97 64
    pictures tiles material/coral_$map.png
  done
  pictures depth material/coral_height.png 16
  pictures depth material/coral_opacity.png 8
  cd "$folder/work" || exit 1
  makes height.pgm grow coral --size 97x64 --view height --pixels l16_swapped -o height.pgm
  makes opacity.png grow coral --size 97x64 --view opacity -o opacity.png
  makes roughness.png grow coral --size 97x64 --view roughness -o roughness.png
  makes own.png grow coral --size 97x64 --view height --pixels l16_swapped --format png-own -o own.png --repeat 2x1
  makes normal.png grow coral --size 97x64 --view normal -o normal.png
  makes unlit.png grow coral --size 97x64 light=0 -o unlit.png
  cd "$folder" || exit 1
  pictures same height.pgm material/coral_height.png
  pictures same opacity.png material/coral_opacity.png
  pictures same roughness.png material/coral_roughness.png
  pictures same normal.png material/coral_normal.png
  pictures same unlit.png material/coral_colour.png
  pictures tiled own.png material/coral_height.png 2 1
  cd "$folder/work" || exit 1
}

test_mips() {
  local map level side=97
  makes levels grow weave --size 97x64 --maps levels --mips --flip-y
  equal "--mips: files" "$(ls "$folder/levels" | wc -l)" 35
  cd "$folder/levels" || exit 1
  for level in .1 .2 .3 .4 .5 .6; do
    side=$((side / 2))
    for map in colour height normal opacity roughness; do
      pictures size weave_$map$level.png $((side > 0 ? side : 1)) $((64 >> ${level#.} > 0 ? 64 >> ${level#.} : 1))
      [ $side -lt 12 ] || pictures tiles weave_$map$level.png
    done
  done
  cd "$folder/work" || exit 1
  makes part.png grow zebra-bits --at 5,7 --size 97x64 -o part.png
  [ $python = no ] || equal "a part of the plane does not tile" "$(python3 "$here/pictures.py" tiles "$folder/part.png"; echo $?)" 1
}

# What an error leaves: what was there, and nothing else.
test_map_errors() {
  local map
  makes rule grow "cells rule=0xB5A3C96E" --maps rule --size 32
  mkdir old && echo mine > old/note && run grow zebra --size 64 --maps old
  equal "--maps into a folder" "$(ls old | wc -l) $(cat old/note)" "6 mine"
  rm -rf old
  refused 2 "--size 8x8" -- grow zebra --size 8 --maps new
  refused 2 --mips --maps -- grow zebra --mips
  refused 2 "--maps ''" folder -- grow zebra --maps ''
  for map in "-o x.png" "--format png" "--view field" "--pixels l8" "--dither" "--repeat 2x2" "--hash"; do
    # shellcheck disable=SC2086
    refused 2 --maps "${map%% *}" -- grow zebra --maps new $map
  done
  refused 1 "'missing/new'" folder -- grow zebra --size 64 --maps missing/new
  refused 1 "'/dev/null'" folder -- grow zebra --size 64 --maps /dev/null
  limit=8000000  # what was opened and made goes again
  if run --version > /dev/null 2>&1; then refused 1 memory -- grow zebra-bits --size 32768 --maps new; fi
  limit=
  # One name taken by a folder: no file, whatever stood there, and none of the others.
  rm -rf -- * && mkdir -p old/zebra_opacity.png && echo kept > old/zebra_colour.png
  run grow zebra --size 64 --maps old 2> "$folder/err"
  equal "--maps: a name that is taken: exit code" $? 1
  equal "--maps: a name that is taken" "$(ls old) $(cat old/zebra_colour.png)" "$(printf 'zebra_colour.png\nzebra_opacity.png kept')"
  rm -rf -- *
}

for part in maps mips map_errors; do
  test_$part
done
echo "maps: $passed passed, $failed failed"
[ $failed -eq 0 ]
