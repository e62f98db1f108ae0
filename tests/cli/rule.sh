#!/usr/bin/env bash
# Tests the command rule end to end: rule.sh DAPPLE. One line a failed check, a sum at the end.
# SPDX-License-Identifier: MIT
. "$(dirname "$0")/common.bash"
rule() { "$dapple" rule "$@"; }
run() { rule "$@"; }

# makes FILE ARGUMENTS...: that file is the only one there afterwards; moved out of the way. Its words are in out.
makes() {
  local file=$1
  shift
  rm -f -- *
  rule "$@" > "$folder/out" 2> "$folder/err" || bad "rule $*: $(cat "$folder/err")"
  equal "rule $*: stderr" "$(cat "$folder/err")" ""
  equal "rule $* writes" "$(ls -A)" "$file"
  mv -f -- "$file" "$folder/" 2> /dev/null
}

python=no
if command -v python3 > /dev/null; then python=yes; else echo "python3 is missing: pictures are not decoded"; fi
pictures() { [ $python = no ] || check "$*" python3 "$here/pictures.py" "$@"; }
json() { [ $python = no ] || check "json: $1" python3 -c "import json, sys
a = json.load(open(sys.argv[1]))
assert $1, a" "$folder/out"; }

test_grow() {
  makes rule-0x00003039.png 12345 --size 64x48
  pictures size "$folder/rule-0x00003039.png" 64 48
  "$dapple" grow "cells rule=12345" --size 64x48 -o "$folder/grown.png"
  check "the same bytes as grow" cmp "$folder/grown.png" "$folder/rule-0x00003039.png"
  makes rule-0x00003039.ppm 12345 --size 64x48 --format ppm
  equal "0x and MAP" "$(rule 0x3039 --hash --size 40)" "$(rule "$(rule 12345 --map)" --hash --size 40)"
  equal "--steps" "$(rule 7 --hash --steps 90)" "$("$dapple" grow "cells rule=7" steps=90 --hash)"
  equal "key=value" "$(rule 7 --hash steps=9 --seed 3)" "$("$dapple" grow "cells rule=7 steps=9" --seed 0x3 --hash)"
  equal "rule=" "$(rule 7 rule=9 --map)" "$(rule 9 --map)"
  equal "--at" "$(rule 7 --hash --at -5,9 --size 40)" "$("$dapple" grow "cells rule=7" --at -5,9 --size 40 --hash)"
  equal "--map" "$(rule 0xffff0000 --map)" MAPAP8A/w
  equal "--map leaves no file" "$(rm -f -- *; rule 1 --map > /dev/null; ls -A)" ""
  check "--help" grep -q '^usage: dapple rule' <(rule --help)
}

test_states() {
  local hash
  makes rule-0xcbc0abaa.rle 0xcbc0abaa --rle --size 60x31 --steps 5
  mv "$folder/rule-0xcbc0abaa.rle" "$folder/five.rle"
  check "the header" grep -qx 'x = 60, y = 31, rule = MAPLyMPVQ:T60,31' "$folder/five.rle"
  hash=$(rule 0xcbc0abaa --size 60x31 --steps 12 --hash)
  equal "from the fifth state on" "$(rule 0xcbc0abaa --start "$folder/five.rle" --steps 7 --size 60x31 --hash)" "$hash"
  makes x.rle 0xcbc0abaa --start "$folder/five.rle" --steps 0 --size 60x31 -o x.rle
  equal "no step" "$(grep -v '^#' "$folder/x.rle")" "$(grep -v '^#' "$folder/five.rle")"
  makes x.png 0xcbc0abaa --start "$folder/five.rle" --steps 7 --size 60x31 -o x.png --repeat 2x3
  rule 0xcbc0abaa --size 60x31 --steps 12 --repeat 2x3 -o "$folder/y.png"
  pictures same "$folder/x.png" "$folder/y.png"
  equal "--at" "$(rule 7 --at 3,4 --size 16 --rle -o - | grep '^x')" "x = 16, y = 16, rule = $(rule 7 --map)"
  printf 'x = 1, y = 1\no!\n' > "$folder/dot.rle"
  equal "--text" "$(rule 0xffff0000 --start "$folder/dot.rle" --size 8 --steps 3 --text | tr -d '\n')" \
    "$(printf '.%.0s' $(seq 30))o$(printf '.%.0s' $(seq 33))"
  makes x.txt 0xffff0000 --start "$folder/dot.rle" --size 8 --steps 3 --text -o x.txt
}

test_answers() {
  rm -f -- *
  printf 'x = 1, y = 1\no!\n' > "$folder/dot.rle"
  check "strong" grep -q '^settles at step 0: .*(strong)$' <(rule 0xaaaaaaaa settle)
  check "weak" grep -q '^settles at step 0: .*every 16 steps (weak)$' \
    <(rule 0xffff0000 settle --size 16 --start "$folder/dot.rle")
  check "no" grep -qx 'does not settle in 30 steps' \
    <(rule 0xffff0000 settle --size 90 --start "$folder/dot.rle" --steps 30)
  rule 0xffff0000 settle --size 16 --start "$folder/dot.rle" --json > "$folder/out"
  json '(a["settles"], a["period"], a["step"], a["rule"]) == ("weak", 16, 0, "0xffff0000")'
  rule 0xcbc0abaa score --size 64 --steps 100 --json > "$folder/out"
  json 'a["nice"] is True and 0.08 < a["entropy"] < 0.6 and a["steps"] == 100 and a["settles"] == "weak"'
  rule 0xcbc0abaa score > "$folder/out"
  check "score" grep -qE '^density +0\.[0-9]{3}$' "$folder/out"
  equal "no file" "$(ls -A)" ""
}

test_complete() {
  makes rule-0xcbc0abaa-stable.png 0xcbc0abaa complete --size 32x24
  check "stable" grep -q '^stable: ' "$folder/out"
  pictures size "$folder/rule-0xcbc0abaa-stable.png" 32 24
  makes s.rle 0xcbc0abaa complete --size 20 -o s.rle --seed 5
  check "it is" grep -q '^settles at step 0: .*(strong)$' <(rule 0xcbc0abaa settle --start "$folder/s.rle" --size 20)
  rule 0xcbc0abaa complete --size 7 --text > "$folder/out"
  equal "text" "$(grep -cE '^[.o]{7}$' "$folder/out")" 7
  equal "only text" "$(($(wc -l < "$folder/out")))" 7
  check "none" grep -q '^none: ' <(rule 0x55555555 complete --size 9)
  equal "none: exit code" "$(rule 0x55555555 complete --size 9 > /dev/null; echo $?)" 0
  check "unknown" grep -q '^unknown: ' <(rule 0x2c0cbf25 complete --size 64 --budget 1000)
  equal "unknown: exit code" "$(rule 0x2c0cbf25 complete --size 64 --budget 1000 > /dev/null; echo $?)" 0
  makes s.rle 12345 complete --size 64 --budget 1000 -o s.rle --json
  json 'a["answer"] == "stable" and 64 % a["tile_width"] == 0 and a["tile_width"] < 64 and a["choices"] > 0'
  check "the tiles are" grep -q '(strong)$' <(rule 12345 settle --start "$folder/s.rle" --size 64)
  rm -f -- *
  rule 0x55555555 complete --size 9 > /dev/null
  equal "none leaves no file" "$(ls -A)" ""
}

test_random() {
  local style one
  makes rules.png random --size 32 --steps 40 --count 7
  equal "a line for each" "$(grep -cE '^0x[0-9a-f]{8}  MAP.{6}  score [0-9.-]+ ' "$folder/out")" 7
  pictures size "$folder/rules.png" 248 112
  one=$(head -n 1 "$folder/out" | cut -d ' ' -f 1)
  for style in uniform inertia mirror outer-totalistic; do
    makes s.png random --size 32 --steps 40 --count 3 --style $style -o s.png --json
    json 'len(a) == 3 and all(x["entropy"] < 0.6 and x["map"].startswith("MAP") for x in a)'
  done
  makes s.png random --size 32 --steps 40 --count 3 --style inertia --seed 1 -o s.png
  differ "another seed" "$(head -n 1 "$folder/out" | cut -d ' ' -f 1)" "$one"
}

test_refusals() {
  rm -f -- *
  refused 2 "missing" "MAP" --
  refused 2 "'x'" "column 1" 4294967295 MAP -- x
  refused 2 "'4294967296'" -- 4294967296
  refused 2 "'0x123456789'" -- 0x123456789
  refused 2 "'12a'" "column 3" -- 12a
  refused 2 "'MAPab!def'" "column 6" -- MAPab!def
  refused 2 "'MAPabcd'" "column 8" six -- MAPabcd settle
  refused 2 "unexpected argument 'sing'" settle complete -- 7 sing
  refused 2 "unexpected argument 'more'" -- 7 settle more
  refused 2 "'steps=x'" -- 7 steps=x
  refused 2 "'mauve=2'" -- 7 mauve=2
  refused 2 "--size 4x4" 8 -- 7 --size 4
  refused 2 "--size '0'" -- 7 complete --size 0
  refused 2 "--size 5000x4000" 4096x4096 -- 7 complete --size 5000x4000
  refused 2 "--style 'plain'" mirror -- random --style plain
  refused 2 "--count '0'" 1000 -- random --count 0
  refused 2 "--count" random -- 7 --count 3
  refused 2 "--hash" settle growing -- 7 settle --hash
  refused 2 "--start" complete -- 7 complete --start x.rle
  refused 2 "--at" -- 7 --at 3,3 --start x.rle
  refused 2 "--json" growing settle -- 7 --json
  refused 2 "--text" -- 7 --text --rle
  refused 2 "--repeat" -- 7 --rle --repeat 2x2
  refused 2 "unknown option '--frames'" -- 7 --frames 3
  refused 2 "'x.bmp'" -- 7 -o x.bmp
  refused 1 "'missing/x.rle'" -- 7 -o missing/x.rle
  refused 1 "'nothing.rle'" -- 7 --start nothing.rle
  refused 1 "'/'" -- 7 --start /
  # shellcheck disable=SC2016
  printf 'x = 3, y = 3\nbo$2oB!\n' > "$folder/broken.rle"
  refused 1 broken.rle "line 2, column 6" states -- 7 --start "$folder/broken.rle" -o x.png
  refused 1 broken.rle "line 2, column 6" -- 7 settle --start "$folder/broken.rle"
  printf 'x = 30, y = 3\n30o!\n' > "$folder/wide.rle"
  refused 2 "--size 16x16" wide.rle 30x3 -- 7 --start "$folder/wide.rle" --size 16
}

for part in grow states answers complete random refusals; do test_$part; done
echo "rule: $passed passed, $failed failed"
[ $failed -eq 0 ]
