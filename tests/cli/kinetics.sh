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

# Spots as they are asked for; what cannot be is refused in words.
test_dials() {
  local small="--size 64 steps=60" on
  # shellcheck disable=SC2086
  {
    equal "aspect is stretch" "$(hash_of turing $small aspect=1.5)" "$(hash_of turing $small stretch=1.5)"
    equal "spot_size is a share" "$(hash_of turing $small wavelength=12 spot_size=6)" "$(hash_of turing $small wavelength=12 coverage=0.170043)"
    differ "coverage" "$(hash_of turing $small coverage=0.2)" "$(hash_of turing $small)"
    check "--view cells" run grow turing $small coverage=0.25 --view cells -o "$folder/cells.pgm"
    on=$(tail -c 4096 "$folder/cells.pgm" | tr -d '\0' | wc -c)
    check "coverage=0.25: $on of 4096 cells are on" test "$on" -le 1024 -a "$on" -ge 1000  # as many as are equal at the edge are left
    check "--every with coverage" run grow turing $small coverage=0.3 --every 30 -o "$folder/covered%01d.ppm"
    check "a frame with coverage" run grow turing --size 64 steps=30 coverage=0.3 range=1.5,8.5 -o "$folder/covered.ppm"
    check "a frame is what --steps gives" cmp "$folder/covered.ppm" "$folder/covered1.ppm"
  }
  check "all dials" run grow 'turing wavelength=14 aspect=2 angle=30 coverage=0.35' --size 32 --steps 5 -o "$folder/dials.png"
  refused 2 "'3' is out of range, 1 to 2.414" -- grow turing aspect=3
  refused 2 "'0.95' is out of range, 0 to 0.9" -- grow turing coverage=0.95
  refused 2 "'14' is out of range, 1.45" "to 13.8" -- grow turing wavelength=12 spot_size=14
  refused 2 "two of them" -- grow turing wavelength=12 spot_size=6 coverage=0.2
  refused 2 "'spot_size' is not a key of schnakenberg" -- grow schnakenberg spot_size=6
  refused 1 "whole tile" -- grow turing steps=6 coverage=0.2 --at 0,0
}

# A map of directions, made or from a picture; segments along it; what cannot be is refused in words.
test_map() {
  local small="--size 64 steps=30 aspect=2"
  printf 'P5\n8 1\n255\n\0\40\100\140\200\140\100\40' > "$folder/slope.pgm"
  # shellcheck disable=SC2086
  {
    differ "map=swirl" "$(hash_of turing $small map=swirl)" "$(hash_of turing $small)"
    differ "detail" "$(hash_of turing $small map=swirl detail=0.5)" "$(hash_of turing $small map=swirl)"
    equal "map=none" "$(hash_of turing $small map=none detail=0.7)" "$(hash_of turing $small)"
    differ "map=@FILE" "$(hash_of turing $small map=@"$folder/slope.pgm")" "$(hash_of turing $small)"
    equal "map: threads" "$(hash_of turing $small map=bends --threads 3)" "$(hash_of turing $small map=bends --budget 7)"
  }
  differ "segments along a map" "$(hash_of random-stripes --size 64 --steps 0 map=radial)" "$(hash_of random-stripes --size 64 --steps 0)"
  check "map: bytes" grep -qF -e '"planes_bytes": 49152' <<< "$(run info turing map=swirl --size 64 --json)"
  refused 2 "'swril' is not one of none|radial" -- grow turing map=swril
  refused 2 "'2' is out of range, 0.01 to 1" -- grow turing map=swirl detail=2
  refused 2 "map=@FILE" -- grow turing map=image
  refused 2 "'map' is not a key of gray-scott" -- grow gray-scott map=swirl
}

# Wavelengths from place to place, made or from a picture, with a map and with growth from a picture.
test_grade() {
  local small="--size 64 steps=30 scale=9"
  printf 'P5\n2 1\n255\n\377\0' > "$folder/halves.pgm"
  printf 'P5\n1 1\n255\n\377' > "$folder/white.pgm"
  # shellcheck disable=SC2086
  {
    differ "grade=centre" "$(hash_of turing $small grade=centre)" "$(hash_of turing $small)"
    differ "finest" "$(hash_of turing $small grade=centre finest=0.8)" "$(hash_of turing $small grade=centre)"
    equal "grade=none" "$(hash_of turing $small grade=none finest=0.7)" "$(hash_of turing $small)"
    equal "grade=@FILE: white" "$(hash_of turing $small grade=@"$folder/white.pgm")" "$(hash_of turing $small)"
    differ "grade=@FILE" "$(hash_of turing $small grade=@"$folder/halves.pgm")" "$(hash_of turing $small)"
    differ "grade=@FILE, growth=@FILE and map=" \
      "$(hash_of turing $small grade=@"$folder/halves.pgm" growth=@"$folder/white.pgm" map=swirl aspect=2)" \
      "$(hash_of turing $small grade=@"$folder/halves.pgm" growth=@"$folder/white.pgm" aspect=2)"
    equal "grade: threads" "$(hash_of turing $small grade=down --threads 3)" "$(hash_of turing $small grade=down --budget 7)"
  }
  check "grade: bytes" grep -qF -e '"planes_bytes": 49152' <<< "$(run info turing grade=down --size 64 --json)"
  refused 2 "'up' is not one of none|across" -- grow turing grade=up
  refused 2 "'0.1' is out of range, 0.25 to 1" -- grow turing grade=down finest=0.1
  refused 2 "grade=@FILE" -- grow turing grade=image
  refused 2 "scale" "6" -- grow turing grade=down scale=4
  refused 1 nothing.pgm -- grow turing grade=@nothing.pgm
}

# Half of the memory: what info says, and what it is not for.
test_compact() {
  check "compact: kind of cell" grep -qF -e "int16" <<< "$(run info turing cells=compact)"
  check "compact: bytes" grep -qF -e '"planes_bytes": 16384' <<< "$(run info turing cells=compact --size 64 --json)"
  check "compact: the recipe" grep -qF -e "meinhardt-spots cells=compact scale=" <<< "$(run info meinhardt-spots cells=compact)"
  check "wide: bytes" grep -qF -e '"planes_bytes": 32768' <<< "$(run info turing-spots cells=wide --size 64 --json)"
  local small="--size 48 steps=40 cells=compact"
  # shellcheck disable=SC2086
  {
    equal "compact: threads" "$(hash_of turing $small --threads 3)" "$(hash_of turing $small --budget 7)"
    differ "compact" "$(hash_of turing $small)" "$(hash_of turing --size 48 steps=40)"
  }
  refused 2 "wide|compact" -- grow turing cells=16
  refused 2 "'cells' is not a key of schnakenberg" -- grow schnakenberg cells=compact
}

# A freeze that holds none or all is told, with the count; the texture is grown all the same.
test_freeze() {
  local turing="turing scale=6 decay=12.25 steps=300" above count
  for above in 15 6 0; do
    hash_of "$turing then freeze above=$above steps=20" --size 64 > "$folder/hash" 2> "$folder/warned"
    check "then freeze above=$above" grep -qE '^[0-9a-f]{16}$' "$folder/hash"
    case $above in 15) count=0 ;; 6) count= ;; 0) count=4096 ;; esac
    equal "then freeze above=$above: warning" "$(grep -o 'holds [0-9]* of 4096 cells, by above=[0-9]*' "$folder/warned")" \
      "${count:+holds $count of 4096 cells, by above=$above}"
  done
}

for part in picture frames dials map grade compact freeze; do
  test_$part
done
echo "kinetics: $passed passed, $failed failed"
[ $failed -eq 0 ]
