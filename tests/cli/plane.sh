#!/usr/bin/env bash
# Tests windows of the endless plane and its stream: plane.sh DAPPLE. One line a failed check, a sum at the end.
# SPDX-License-Identifier: MIT
. "$(dirname "$0")/common.bash"
run() { "$dapple" "$@"; }
hash_of() { "$dapple" grow "$@" --hash; }

python=no
if command -v python3 > /dev/null; then python=yes; else echo "python3 is missing: pixels, terminal are not tested"; fi
ask() { [ $python = no ] || check "$*" python3 "$here/plane.py" "$@"; }

zebra="bits scale=9 stretch=3 angle=78.5 steps=8 ramp=zebra range=-0.95,0.95 light=1"
most=1073739775  # the last pixel of the plane; the first is -1073739776
recipes=("$zebra" "bits masks=5 react=da scale=9 stretch=3 steps=6 level=2 ramp=jade light=1"
  "bits diffusion=isotropic scale=9 steps=5 level=0 start=seeds pitch=24 radius=4 ramp=reptile"
  "cells rule=0xfee8e880 steps=20")

# Windows show the same pixels wherever they begin, and however they are grown.
test_windows() {
  local recipe place x y
  for recipe in "${recipes[@]}"; do
    for place in 0,0 -37,-61 1000000007,-1000000009; do
      x=${place%,*} y=${place#*,}
      check "$recipe: $place" "$dapple" grow "$recipe" --at $place --size 150x97 -o "$folder/whole.ppm"
      check "$recipe: $place" "$dapple" grow "$recipe" --at $((x + 41)),$((y + 23)) --size 60x43 --budget 7 \
        -o "$folder/part.ppm"
      ask part "$folder/whole.ppm" "$folder/part.ppm" 41 23
      equal "$recipe at $place" "$(hash_of "$recipe" --at $place --size 60 --threads 3 --budget 1)" \
        "$(hash_of "$recipe" --at $place --size 60)"
    done
    place=$(hash_of "$recipe" --at 0,0 --size 60)
    differ "$recipe: another place" "$(hash_of "$recipe" --at 1,0 --size 60)" "$place"
    differ "$recipe: another seed" "$(hash_of "$recipe" --at 0,0 --size 60 --seed 2)" "$place"
  done
}

test_options() {
  local view
  for view in field cells height normal; do
    "$dapple" grow "$zebra" --at -9,-4 --size 64 --view $view -o "$folder/whole.ppm"
    "$dapple" grow "$zebra" --at 3,5 --size 33x21 --view $view -o "$folder/part.ppm"
    ask part "$folder/whole.ppm" "$folder/part.ppm" 12 9
  done
  at() { hash_of "$zebra" --at 5,6 --size 64 "$@"; }
  equal "--steps of the recipe" "$(at --steps 8)" "$(at)"
  equal "--steps 0 --threads 3" "$(at --steps 0 --threads 3)" "$(at --steps 0)"
  equal "--steps 0 is steps=0" "$(at --steps 0)" "$(at steps=0)"
  equal "--steps of more" "$(at --steps 11)" "$(at steps=11)"
  equal "--steps of fewer" "$(at --steps 3)" "$(at steps=3)"
  check "the last pixels" "$dapple" grow "$zebra" --at $((most - 63)),-1073739776 --size 64 --hash
  equal "the last --at" "$(hash_of "$zebra" --at 1,1 --size 64 --at 2,2)" "$(hash_of "$zebra" --at 2,2 --size 64)"
  equal "--hash writes nothing" "$(rm -f -- *; hash_of "$zebra" --at 2,2 -o x.png > /dev/null; ls -A)" ""
  "$dapple" grow "$zebra" --at 1,2 --size 64
  equal "the file's name" "$(ls -A)" texture.png
  "$dapple" grow "$zebra" --at -1,2 --size 64 -o "$folder/texture.h"
  check "a header says where it is" grep -q "at -1,2 of the plane" "$folder/texture.h"
}

test_info() {
  "$dapple" info "$zebra" --at -5,7 --size 100x64 --json > "$folder/info.json"
  [ $python = no ] || check "info --json" python3 -c 'import json, sys
i = json.load(open(sys.argv[1]))
assert (i["x"], i["y"], i["width"], i["height"], i["halo"]) == (-5, 7, 100, 64, 112)
assert i["grown_width"] >= 100 + 2 * 112 and i["grown_height"] >= 64 + 2 * 112 and "smallest_width" not in i
assert i["bytes"] == sum(i[part + "_bytes"] for part in ("planes", "scratch", "paint", "rest"))' "$folder/info.json"
  check "info: halo" grep -qE '^halo +112 cells$' <("$dapple" info "$zebra" --at -5,7)
  equal "info without --at: no halo" "$("$dapple" info "$zebra" | grep -c halo)" 0
}

test_refusals() {
  local command place
  for command in grow info stream; do
    refused 1 mitosis "5001 cells" 1024 "without --at" -- $command mitosis --at 0,0
    refused 1 "--at 1073739776,0" "from -1073739776 to $most" -- $command "$zebra" --at 1073739776,0
    refused 1 "--at 0,-2147483648" "from -1073739776" -- $command "$zebra" --at 0,-2147483648
    for place in 1 1,2,3 a,b 1, ,1 '' 1.5,2 2147483648,0 --1,2 0x1,2; do
      refused 2 "--at '$place'" X,Y -- $command "$zebra" --at "$place"
    done
  done
  refused 1 "--at $((most - 62)),0" 64x64 -- grow "$zebra" --size 64 --at $((most - 62)),0
  refused 1 "--size 65000x64" "112 cells" 64776 -- grow "$zebra" --size 65000x64 --at 0,0
  refused 1 "--size 65000x64" "112 cells" 64776 -- info "$zebra" --size 65000x64 --at 0,0
  refused 2 --repeat --at -- grow "$zebra" --at 0,0 --repeat 2x2
  refused 2 --repeat --at -- grow "$zebra" --repeat 1x1 --at 0,0
  refused 2 "--at needs a value" -- grow "$zebra" --at
  refused 2 "'--repeat'" --frames -- stream "$zebra" --repeat 2x2
  refused 2 preset missing -- stream
  refused 2 "'zebar'" zebra -- stream zebar
  refused 2 "--frames '0'" 1000000 -- stream "$zebra" --frames 0
  refused 2 "--size 3000x20" 2048 -- stream "$zebra" --size 3000x20
  refused 2 "steps=x" -- stream "$zebra" steps=x
}

# Piped: the same frames every time, and each shows the window it says it shows.
test_frames() {
  local recipe whole place
  "$dapple" stream "$zebra" > "$folder/frames"
  equal "60 frames of 24 lines" "$(($(wc -l < "$folder/frames")))" $((60 * 24))
  whole=$(cksum < "$folder/frames")
  equal "the same frames again" "$("$dapple" stream "$zebra" | cksum)" "$whole"
  equal "the seed is 1337" "$("$dapple" stream "$zebra" --seed 1337 --frames 60 --size 80x46 | cksum)" "$whole"
  differ "another seed" "$("$dapple" stream "$zebra" --seed 7 | cksum)" "$whole"
  whole=$(head -n $((7 * 24)) "$folder/frames" | cksum)
  equal "fewer frames" "$("$dapple" stream "$zebra" --frames 7 | cksum)" "$whole"
  equal "an odd height" "$("$dapple" stream "$zebra" --size 30x9 --frames 3 | wc -l)" $((3 * 6))
  for recipe in "${recipes[@]}"; do
    for place in 0,0 -500,-300 $((most - 130)),-1073739776; do
      "$dapple" stream "$recipe" --at $place --size 70x40 --frames 90 > "$folder/frames"
      place=$(sed -n "$((90 * 21))s/.* at \([-0-9,]*\) .*/\1/p" "$folder/frames")
      check "$recipe at $place" "$dapple" grow "$recipe" --at "$place" --size 70x40 -o "$folder/frame.ppm"
      ask frame "$folder/frames" 21 90 "$folder/frame.ppm"
    done
  done
  if [ -w /dev/full ]; then
    "$dapple" stream "$zebra" > /dev/full 2> "$folder/err"
    equal "a full device: exit code" $? 1
    equal "a full device: lines" "$(($(wc -l < "$folder/err")))" 1
  fi
}

test_terminal() { ask terminal "$dapple" stream "$zebra"; }

for part in windows options info refusals frames terminal; do test_$part; done
echo "plane: $passed passed, $failed failed"
[ $failed -eq 0 ]
