#!/usr/bin/env bash
# Tests textures for surfaces, sides and atlases: surface.sh DAPPLE. One line a failed check, a sum at the end.
# SPDX-License-Identifier: MIT
. "$(dirname "$0")/common.bash"
run() { timeout 120 "$dapple" "$@"; }
hash_of() { run surface "$@" --hash; }
grown() { "$dapple" grow "$@" --hash; }
golden=$here/../golden/surfaces.txt

python=no
if command -v python3 > /dev/null; then python=yes; else echo "python3 is missing: pictures are not decoded"; fi
pictures() { [ $python = no ] || check "$*" python3 "$here/pictures.py" "$@"; }

labyrinth="mapped map=isotropic scale=1.6 steps=8"
zebra="mapped map=none stretch=2 angle=70 steps=6"

# A line of the file: the hash, then what grows it.
test_goldens() {
  local hash words now
  while read -r hash words; do
    case $hash in '#'* | '') continue ;; esac
    eval "set -- $words"
    now=$(hash_of "$@")
    equal "golden, now: $now $words" "$now" "$hash"
  done < "$golden"
  equal "goldens" "$(grep -vc '^#' "$golden")" 9
}

# A flat surface, or one whose cells are all alike, is the plain operator; slices and bands change nothing.
test_flat() {
  local recipe
  for recipe in "$labyrinth" "$zebra" "mapped map=haunch pairs=2 steps=3"; do
    equal "flat: $recipe" "$(hash_of flat "$recipe" --size 96x80)" "$(grown "$recipe" --size 96x80)"
    equal "torus: $recipe" "$(hash_of torus "$recipe" --size 96x48 --budget 3 --threads 4)" \
      "$(hash_of torus "$recipe" --size 96x48)"
    differ "torus: $recipe" "$(hash_of torus "$recipe" --size 96x48)" "$(grown "$recipe" --size 96x48)"
  done
  equal "a preset of threshold" "$(hash_of flat zebra steps=4 --size 64)" \
    "$(grown "mapped map=none stretch=2 scale=2.2 angle=78.540844" steps=4 --size 64)"
  differ "--ratio" "$(hash_of torus "$zebra" --size 96x48 --ratio .3)" "$(hash_of torus "$zebra" --size 96x48)"
  differ "--tall" "$(hash_of vase "$zebra" --size 96 --tall 1.4)" "$(hash_of vase "$zebra" --size 96)"
  differ "--seed" "$(hash_of sphere "$labyrinth" --size 32 --seed 2)" "$(hash_of sphere "$labyrinth" --size 32)"
}

metric() {
  awk -v w="$1" -v h="$2" -v n="${3:-1}" -v cell="$4" -v bad="${5:--1}" -v with="${6:-}" \
    'BEGIN { print "# a metric"; print w, h, n; for (i = 0; i < w * h * n; ++i) print i == bad ? with : cell }'
}

test_files() {
  metric 64 48 1 "1 0 1" > "$folder/one.txt"
  metric 64 48 1 "4 0 4" > "$folder/four.txt"
  equal "a metric of ones" "$(hash_of flat "$labyrinth" --metric "$folder/one.txt")" "$(grown "$labyrinth" --size 64x48)"
  equal "a metric of fours" "$(hash_of flat "$labyrinth" scale=2 --metric "$folder/four.txt")" \
    "$(grown "$labyrinth" scale=1 --size 64x48)"
  { printf 'P5\n64 48\n255\n'; head -c $((64 * 48)) /dev/zero; } > "$folder/level.pgm"
  equal "level ground" "$(hash_of flat "$labyrinth" --heights "$folder/level.pgm")" "$(grown "$labyrinth" --size 64x48)"
  # Two patches side by side, closed around, are one closed patch.
  printf '0 right 1 left  # the only seam\n\n' > "$folder/two.txt"
  check "two patches" run surface flat "$zebra" --atlas "$folder/two.txt" --size 48 -o "$folder/two.ppm"
  check "one patch" run grow "$zebra" sides=closed --size 96x48 -o "$folder/one.ppm"
  check "two patches are one" cmp -s "$folder/two.ppm" "$folder/one.ppm"
  printf '0 left 0 right\n0 top 0 bottom\n' > "$folder/torus.txt"
  equal "an atlas that is a torus" "$(hash_of flat "$zebra" --atlas "$folder/torus.txt" --size 64)" "$(grown "$zebra" --size 64)"
  equal "sides=repeat" "$(grown "$zebra" --size 64 sides=repeat)" "$(grown "$zebra" --size 64)"
  differ "sides=closed" "$(grown "$zebra" --size 64 sides=closed)" "$(grown "$zebra" --size 64)"
  differ "fixed=" "$(grown "$zebra" --size 64 sides=fixed fixed=1,0)" "$(grown "$zebra" --size 64 sides=fixed fixed=0,1)"
  check "info with sides" run info "$zebra" sides=closed --size 64
  equal "a recipe's sides" "$(grown "$(run info "$zebra" sides=repeat,closed --size 64 | head -n 1)" --size 64)" \
    "$(grown "$zebra" --size 64 sides=repeat,closed)"
}

test_pictures() {
  local shape
  for shape in torus vase sphere; do
    rm -f -- *
    check "$shape" run surface $shape "$labyrinth" --size 32 scale=1 -o $shape.png --preview object.png
    equal "$shape: files" "$(ls -A | tr '\n' ' ')" "object.png $shape.png "
    pictures size object.png 960 540
  done
  pictures size sphere.png 192 32
  rm -f -- *
  check "height" run surface flat "$labyrinth" --heights "$folder/level.pgm" -o - --format ppm --preview object.qoi
  equal "height: files" "$(ls -A)" object.qoi
  rm -f -- *
  check "the file's name" run surface torus "$labyrinth" --size 32x16 scale=.5
  equal "the file's name" "$(ls -A)" texture.png
}

test_refusals() {
  refused 2 "the name of a preset" -- surface torus
  refused 2 "'cone'" "torus, vase, sphere, flat" -- surface cone zebra
  refused 2 "families threshold and mapped" "gray-scott" -- surface torus mitosis
  refused 2 "squares" -- surface sphere giraffe --size 64x32
  refused 2 "too small" -- surface sphere giraffe --size 8
  refused 2 "--ratio '1'" ".01 to .95" -- surface torus zebra --ratio 1
  refused 2 "surface flat" -- surface torus zebra --heights x.pgm
  refused 2 "sides= is not for bits, flow and cells" -- grow zebra-bits sides=closed
  refused 2 "sides= is not for a torus" -- surface torus zebra sides=closed
  refused 2 "sides repeat in pairs" -- grow zebra sides=closed,repeat,closed,closed
  refused 2 "no sides" -- grow zebra sides=closed --at 0,0
  refused 2 "dapple surface" -- grow "mapped solver=surface"
  refused 2 "--preview is for" -- surface flat zebra --preview x.png
  refused 1 "more than three pairs" -- surface torus coral
  refused 1 "cannot read" -- surface flat zebra --metric none.txt
  metric 64 48 1 "1 0 1" $((64 * 5 + 7)) "1 2 1" > "$folder/bad.txt"
  refused 1 "bad.txt" "cell 7,5 is xx 1, xy 2, yy 1" -- surface flat zebra --metric "$folder/bad.txt"
  metric 16 16 3 "1 0 1" $((256 * 2)) "1 1 1" > "$folder/bad.txt"
  printf '0 right 1 left\n1 right 2 left\n' > "$folder/three.txt"
  refused 1 "cell 0,0 of patch 2" -- surface flat zebra --metric "$folder/bad.txt" --atlas "$folder/three.txt"
  refused 2 "--size 64" "64x48 cells" -- surface flat zebra --metric "$folder/one.txt" --size 64
  refused 2 "has 3 patches" -- surface flat zebra --metric "$folder/bad.txt" --atlas "$folder/two.txt"
  metric 9 9 1 "1 0" > "$folder/bad.txt"
  refused 1 "162 numbers" "243" -- surface flat zebra --metric "$folder/bad.txt"
  printf '9 9\n1 x 1\n' > "$folder/bad.txt"
  refused 1 "line 2: 'x'" -- surface flat zebra --metric "$folder/bad.txt"
  printf '0 right 1 left\n2 right 1 left\n' > "$folder/bad.txt"
  refused 1 "the right side of patch 0 is joined to the left side of patch 1, which is joined to another" -- \
    surface flat zebra --atlas "$folder/bad.txt"
  printf '0 right 1 left\n1 rihgt 0 left\n' > "$folder/bad.txt"
  refused 1 "line 2: 'rihgt'" -- surface flat zebra --atlas "$folder/bad.txt"
  printf '0 right fixed 2 0\n' > "$folder/bad.txt"
  refused 1 "the right side of patch 0 is fixed" -- surface flat zebra --atlas "$folder/bad.txt"
  printf '0 right 1\n' > "$folder/bad.txt"
  refused 1 "line 1: give PATCH SIDE" -- surface flat zebra --atlas "$folder/bad.txt"
}

for part in goldens flat files pictures refusals; do test_$part; done
echo "surface: $passed passed, $failed failed"
[ $failed -eq 0 ]
