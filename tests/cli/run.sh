#!/usr/bin/env bash
# Tests the command line end to end: run.sh DAPPLE. One line a failed check, a sum at the end.
# SPDX-License-Identifier: MIT
. "$(dirname "$0")/common.bash"
. "$here/pictures.bash"
hash_of() { run grow "$@" --hash; }

least_of() { run info "$1" | awk '/^smallest/ { printf "%s%s", x, $3; x = "x" }'; }

presets=$(run list | awk '{print $1}')

test_words() {
  local command
  run > "$folder/out" 2> "$folder/err"
  equal "no arguments: exit code" $? 2
  equal "no arguments: stdout" "$(cat "$folder/out")" ""
  check "no arguments: usage on stderr" grep -q '^usage: dapple' "$folder/err"
  for command in "" list grow info sheet stream rule tiles surface bench; do
    # shellcheck disable=SC2086
    run $command --help > "$folder/help" 2> "$folder/err"
    equal "$command --help: exit code" $? 0
    equal "$command --help: stderr" "$(cat "$folder/err")" ""
    check "$command --help: usage" grep -q "^usage: dapple $command" "$folder/help"
  done
  check "--version" grep -qE '^dapple [0-9]+\.[0-9]+\.[0-9]+$' <(run --version)
}

test_list() {
  equal "list: no other lines" "$(run list | grep -cvE '^[a-z0-9-]+ +(threshold|mapped|gray-scott|turing|meinhardt-spots|meinhardt-stripes|fitzhugh-nagumo|schnakenberg|brusselator|bits|flow|cells) +[^ ].*[^ ]$')" 0
  check "list has zebra" grep -q '^zebra  *threshold  *[a-z]' <(run list)
  run list --json > "$folder/list.json"
  [ $python = no ] || equal "list --json" "$(python3 -c 'import json, sys
for entry in json.load(open(sys.argv[1])):
    assert sorted(entry) == ["family", "name", "recipe", "sentence"] and entry["recipe"].startswith(entry["family"])
    print(entry["name"])' "$folder/list.json")" "$presets"
}

# Every preset: the first line of info grows the same field, and a changed one another.
test_info() {
  local name line
  for name in $presets; do
    line=$(run info "$name" | head -n 1)
    equal "$name: its recipe" "$(hash_of "$line" --size 96 --steps 20)" "$(hash_of "$name" --size 96 --steps 20)"
  done
  run info weave --json --size 64x48 --threads 3 > "$folder/info.json"
  run info weave --size 64x48 --threads 3 > "$folder/info"
  [ $python = no ] || check "info --json" python3 -c 'import json, sys
i = json.load(open(sys.argv[1]))
assert (i["name"], i["family"], i["width"], i["height"], i["cells"]) == ("weave", "threshold", 64, 48, 64 * 48)
assert i["bytes"] == sum(i[part + "_bytes"] for part in ("planes", "scratch", "paint", "rest"))
assert i["planes_bytes"] == 64 * 48 * 2 * i["planes"] and i["steps"] == 32 and i["rows"] >= i["sweeps"] * 48
assert 0 < i["wavelength"] < 64 and i["smallest_width"] <= 64 and i["multiple"] == 1 and i["radius"] > 0
assert open(sys.argv[2]).readline() == i["recipe"] + "\n"' "$folder/info.json" "$folder/info"
  check "info: changes" grep -q 'steps=40 ' <(run info zebra steps=40)
  check "info: levels" grep -qE '^multiple of +4 ' <(run info zebra levels=3)
  run info zebra scale=4 solver=multigrid > "$folder/info.grids"
  check "info: the word of the stages" grep -q ' solver=multigrid levels=3 fine=6 steps=32 ' "$folder/info.grids"
  equal "info: cost by solver" "$(sed -n '/^cost by solver/,$s/^  \([a-z]*\) .* rows, [0-9]* cell updates$/\1/p' "$folder/info.grids" | tr '\n' ' ')" \
    "euler gaussian multigrid "
  equal "info: the rows of its own solver" "$(awk '/^  multigrid/ { print $2 }' "$folder/info.grids")" \
    "$(awk '/^rows of work/ { print $4 }' "$folder/info.grids")"
  equal "info: no multigrid where sides do not halve" "$(run info zebra --size 97 | grep -c '^  multigrid')" 0
  equal "info: one solver, no comparison" "$(run info mitosis | grep -c 'cost by')" 0
  check "info: no steps" run info zebra steps=0
  check "info: --threads" grep -qE '^memory ' "$folder/info"
}

test_bytes() {
  local whole
  whole=$(hash_of coral --size 64x48 --seed 7)
  check "--hash: 16 digits" grep -qE '^[0-9a-f]{16}$' <(echo "$whole")
  equal "--hash leaves no file" "$(rm -f -- *; hash_of zebra --size 64 -o x.png > /dev/null; ls -A)" ""
  equal "--budget 1" "$(hash_of coral --size 64x48 --seed 7 --budget 1)" "$whole"
  equal "--budget 77" "$(hash_of coral --size 64x48 --seed 7 --budget 77)" "$whole"
  equal "--threads 5" "$(hash_of coral --size 64x48 --seed 7 --threads 5)" "$whole"
  equal "--threads 64 --budget 3" "$(hash_of coral --size 64x48 --seed 0x7 --threads 64 --budget 3)" "$whole"
  equal "--kernels portable" "$(hash_of coral --size 64x48 --seed 7 --kernels portable)" "$whole"
  equal "--threads 2, whole steps" "$(hash_of coral --size 64x48 --seed 7 --threads 2 --budget 4000000)" "$whole"
  "$dapple" bench "cell program 512" --json > "$folder/bench"
  check "bench times the portable table" grep -q '"kernels": "portable"' "$folder/bench"
  equal "bench: all tables have the same hash" "$(grep -o '"hash": "[0-9a-f]*"' "$folder/bench" | sort -u | wc -l)" 1
  [ "$(uname -m)" != x86_64 ] || check "bench times the table of every x86-64" grep -q '"kernels": "sse2"' "$folder/bench"
  equal "the last word wins" "$(hash_of coral --seed 9 --size 64x48 --kernels best --seed 7)" "$whole"
  equal "key=value" "$(hash_of zebra scale=1.9 rho=0.02 --size 64)" "$(hash_of zebra 'rho=0.02 scale=1.9' --size 64)"
  equal "family alone" "$(hash_of threshold pairs=2 --size 64)" "$(hash_of 'threshold pairs=2' --size 64)"
  equal "_ is -" "$(hash_of twisty_maze --size 64)" "$(hash_of twisty-maze --size 64)"
  differ "another seed" "$(hash_of coral --size 64x48)" "$whole"
  equal "the seed is 1337" "$(hash_of coral --size 64x48)" "$(hash_of coral --size 64x48 --seed 1337)"
}

# --steps counts over all stages, and 0 is a start that no other number of steps changes.
test_steps() {
  local levels="threshold scale=2 steps=30 levels=3 fine=5" name start
  for name in zebra mitosis "$levels"; do
    start=$(hash_of "$name" --size 96 --steps 0)
    equal "$name: --steps 0 --threads 3" "$(hash_of "$name" --size 96 --steps 0 --threads 3)" "$start"
    differ "$name: --steps 1" "$(hash_of "$name" --size 96 --steps 1)" "$start"
  done
  equal "--steps 0 is steps=0" "$(hash_of zebra --size 64 --steps 0)" "$(hash_of zebra steps=0 --size 64)"
  equal "--steps of fewer" "$(hash_of gs-maze --size 64 --steps 50)" "$(hash_of gs-maze steps=50 --size 64)"
  equal "--steps of the recipe" "$(hash_of "$levels" --size 96 --steps 30)" "$(hash_of "$levels" --size 96)"
  differ "--steps of one less" "$(hash_of zebra --size 64 --steps 31)" "$(hash_of zebra --size 64)"
  equal "--steps of more" "$(hash_of zebra --size 64 --steps 40)" "$(hash_of zebra steps=40 --size 64)"
  differ "more steps" "$(hash_of zebra --size 64 --steps 40)" "$(hash_of zebra --size 64)"
}

test_pictures() {
  local size="--size 50x43"
  # shellcheck disable=SC2086
  {
    makes zebra.png grow zebra $size
    mv "$folder/zebra.png" "$folder/library.png"
    makes zebra.png grow zebra $size --format png-own
    makes a.ppm grow zebra $size -o a.ppm
    makes a.qoi grow zebra $size -o a.qoi
    makes b.qoi grow zebra $size -o b.qoi --pixels rgba8888
    makes b.png grow zebra $size -o b.png --pixels rgba8888
    makes c.png grow zebra $size -o c.png --pixels rgba8888 --format png-own
    makes a.pgm grow zebra $size -o a.pgm
    makes d.png grow zebra $size -o d.png --pixels l8
    makes e.png grow zebra $size -o e.png --pixels l8 --format png-own
    makes cells.pbm grow zebra $size -o cells.pbm --view cells
    makes cells.pgm grow zebra $size -o cells.pgm --view cells
    makes cells.png grow zebra $size -o cells.png --view cells
    makes field.pgm grow zebra $size -o field.pgm --view field
    makes field.png grow zebra $size -o field.png --view field
    makes normal.ppm grow coral $size -o normal.ppm --view normal
    makes flipped.ppm grow coral $size -o flipped.ppm --view normal --flip-y
    makes ramp.ppm grow zebra $size -o ramp.ppm --ramp ember
  }
  cd "$folder" || exit 1
  pictures size library.png 50 43
  pictures same library.png zebra.png
  pictures same a.ppm zebra.png
  pictures same a.ppm a.qoi
  pictures same b.png b.qoi
  pictures same b.png c.png
  pictures same a.pgm d.png
  pictures same a.pgm e.png
  pictures bits cells.pbm cells.pgm
  pictures same cells.pgm cells.png
  pictures same field.pgm field.png
  equal "PGM: bytes" "$(($(wc -c < a.pgm)))" $((13 + 50 * 43))
  equal "PBM: bytes" "$(($(wc -c < cells.pbm)))" $((9 + 7 * 43))
  if ! cmp -s normal.ppm flipped.ppm; then good; else bad "--flip-y changes nothing"; fi
  if ! cmp -s a.ppm ramp.ppm; then good; else bad "--ramp changes nothing"; fi
  cd "$folder/work" || exit 1
  equal "-o -" "$(run grow zebra --size 50x43 -o - --format ppm | cksum)" "$(cksum < "$folder/a.ppm")"
  equal "-o - is PNG" "$(run grow zebra --size 50x43 -o - | head -c 4 | tail -c 3)" "PNG"
  makes texture.png grow "threshold pairs=2" --size 32
}

test_raw() {
  local pixels bytes
  while read -r pixels bytes; do
    makes "$pixels.raw" grow weave --size 45x35 --pixels "$pixels" --dither -o "$pixels.raw"
    equal "raw $pixels: bytes" "$(($(wc -c < "$folder/$pixels.raw")))" $((bytes))
  done <<- end
	l8 45*35
	rgb888 45*35*3
	rgba8888 45*35*4
	rgb565 45*35*2
	rgb565_swapped 45*35*2
	l1_msb 6*35
	l1_lsb 6*35
	l1_pages 45*5
	end
  makes weave.raw grow weave --size 45x35 --format raw
  check "raw is rgba8888" cmp "$folder/weave.raw" "$folder/rgba8888.raw"
  cd "$folder" || exit 1
  pictures pages l1_pages.raw 45 35 l1_msb.raw
  pictures swapped rgb565.raw rgb565_swapped.raw
  cd "$folder/work" || exit 1
}

test_repeat() {
  local file
  makes one.ppm grow coral --size 37x41 -o one.ppm
  for file in two.png two.ppm two.qoi; do
    makes $file grow coral --size 37x41 -o $file --repeat 3x2
    pictures tiled "$folder/$file" "$folder/one.ppm" 3 2
  done
  makes one.pbm grow coral --size 37x41 -o one.pbm
  makes two.pbm grow coral --size 37x41 -o two.pbm --repeat 3x2
  pictures tiled "$folder/two.pbm" "$folder/one.pbm" 3 2
  makes two.msb.raw grow coral --size 37x41 -o two.msb.raw --repeat 3x2 --pixels l1_msb
  makes two.raw grow coral --size 37x41 -o two.raw --repeat 3x2 --pixels l1_pages
  pictures pages "$folder/two.raw" 111 82 "$folder/two.msb.raw"
}

test_header() {
  local compiler
  makes gs-spots.h grow gs-spots --size 64x36 --format c --pixels rgb565_swapped steps=60
  makes spots.raw grow gs-spots --size 64x36 --pixels rgb565_swapped steps=60 -o spots.raw
  makes spots.c grow gs-spots --size 64x36 steps=60 -o spots.c --pixels l1_pages --repeat 2x1
  pictures array "$folder/gs-spots.h" "$folder/spots.raw"
  printf '%s\n' '#include "gs-spots.h"' '#include "gs-spots.h"' \
    'int main(void) { return sizeof gs_spots_pixels == GS_SPOTS_WIDTH * GS_SPOTS_HEIGHT * 2 ? gs_spots_pixels[0] * 0 : 1; }' \
    > "$folder/main.c"
  cp "$folder/main.c" "$folder/main.cpp"
  for compiler in "cc -std=c99" "c++ -std=c++11"; do
    command -v "${compiler%% *}" > /dev/null || continue
    local source=main.c
    [ "${compiler%% *}" = cc ] || source=main.cpp
    # shellcheck disable=SC2086
    check "C header: $compiler" $compiler -Wall -Wextra -pedantic -Werror -o "$folder/main" "$folder/$source"
    check "C header: $compiler, run" "$folder/main"
    # shellcheck disable=SC2086
    check "C header alone: $compiler" $compiler -Wall -Wextra -pedantic -Werror -c -o "$folder/main.o" "$folder/spots.c"
  done
}

test_sheet() {
  makes sheet.png sheet --size 80
  makes three.png sheet --size 80 -o three.png zebra 'threshold pairs=2 scale=1.9 stretch=3 rho=0.02' radial
  pictures size "$folder/three.png" $((8 + 3 * 88)) 108
  makes small.ppm sheet --size 84x80 -o small.ppm --view field
  local rows=$((($(echo "$presets" | wc -l) + 5) / 6))
  pictures size "$folder/sheet.png" $((8 + 6 * 88)) $((8 + rows * 100))
  pictures size "$folder/small.ppm" $((8 + 6 * 92)) $((8 + rows * 100))
}

test_usage_errors() {
  refused 2 "'frobnicate'" list grow info sheet -- frobnicate
  refused 2 "'--frobnicate'" -- --frobnicate
  refused 2 preset missing -- grow
  refused 2 preset missing -- info --size 64
  refused 2 "'zebar'" "zebra" -- grow zebar
  refused 2 "'maz'" "maze" -- info maz
  refused 2 "''" -- grow ''
  refused 2 "'more'" -- grow zebra more
  refused 2 "'more'" -- list more
  refused 2 "'zebbra'" -- sheet zebra zebbra
  refused 2 "'zebra size=3'" -- sheet 'zebra size=3'
  refused 2 "'--at'" --size --seed -- sheet --at 1,2
  refused 2 "'--seed'" --json -- info zebra --seed 2
  refused 2 "'--size'" --json -- list --size 2
  local option
  for option in --size --seed --steps -o --format --view --pixels --ramp --repeat --budget --threads --kernels; do
    refused 2 "$option needs a value" -- grow zebra $option
  done
  for option in 7 0 65536 64x 64x4 x 64x64x64 1e2 -64 ''; do
    refused 2 "--size '$option'" 8 65535 -- grow zebra --size "$option"
  done
  for option in -1 4294967296 0x 0x100000000 12a 0xfg ''; do
    refused 2 "--seed '$option'" 4294967295 -- grow zebra --seed "$option"
  done
  for option in -1 1000001 1.5 0x10; do refused 2 "--steps '$option'" 1000000 -- grow zebra --steps $option; done
  for option in 0 65 x; do refused 2 "--threads '$option'" 64 -- grow zebra --threads $option; done
  for option in 0 -1 4294967296; do refused 2 "--budget '$option'" 4294967295 -- grow zebra --budget $option; done
  for option in 2 0x1 1x0 2x2x2 1x65536; do refused 2 "--repeat '$option'" CxR -- grow zebra --repeat $option; done
  refused 2 --repeat 65535 -- grow zebra --size 1000 --repeat 66x1
  refused 2 "--format 'bmp'" png-own qoi -- grow zebra --format bmp
  refused 2 "--view 'shiny'" colour roughness -- grow zebra --view shiny
  refused 2 "--pixels 'rgb'" rgb888 l16_swapped -- grow zebra --pixels rgb
  refused 2 "--pixels rgb565" png rgb888 -- grow zebra --pixels rgb565
  refused 2 "--pixels l8" ppm rgb888 -- grow zebra --pixels l8 -o x.ppm
  refused 2 "--ramp 'mauve'" ember stops -- grow zebra --ramp mauve
  refused 2 "--ramp 'ember rho=0.1'" -- grow zebra --ramp 'ember rho=0.1'
  refused 2 "--kernels 'sse'" portable best -- grow zebra --kernels sse
  refused 2 "'nothing-like-it'" -- bench nothing-like-it
  refused 2 --flip-y normal -- grow zebra --flip-y
  refused 2 "-o 'x.bmp'" .png .qoi -- grow zebra -o x.bmp
  refused 2 "-o 'x'" .png -- grow zebra -o x
  refused 2 -o -- grow zebra -o ''
}

test_recipe_errors() {
  refused 2 "'rho=9'" "column 5" "'9'" "-0.2 to 0.2" -- grow zebra rho=9
  refused 2 "'rho=9'" "column 5" -- grow zebra scale=2 rho=9 k=0.5
  refused 2 "'pears=2'" "column 1" "'pears'" pairs wavelength -- grow zebra pears=2
  refused 2 "'pairs=6'" "1 to 5" -- info zebra pairs=6
  refused 2 "'scale=x'" "column 7" "'x' is not a number" -- grow zebra scale=x
  refused 2 "'scale='" "column 7" missing -- grow zebra scale=
  refused 2 "'solver=binary'" "column 8" bits masks= -- grow zebra solver=binary
  refused 2 "'solver=fast'" "column 8" "gaussian|euler|multigrid" -- grow zebra solver=fast
  refused 2 "'roughness=2,1'" "0 to 1" -- grow zebra roughness=2,1
  refused 2 "'react=sum'" "column 7" "md|da" -- grow zebra react=sum
  refused 2 "column 19" "'garbage' is not key=value" -- grow 'threshold steps=5 garbage'
  refused 2 "column 28" "'x' is not key=value" -- grow 'threshold pairs=2 rho=0.02 x'
  refused 2 "column 17" "too many" -- grow 'threshold angle=1,2,3,4,5,6'
  refused 2 "column 16" "'fine'" "carry|refine" -- grow 'threshold then fine'
  refused 2 "column 16" "level" -- grow 'threshold then refine'
  refused 2 "column 12" "'mauve'" -- grow 'gray-scott mauve=2'
  refused 2 wavelength "out of range" -- grow zebra wavelength=300
  refused 2 fine levels -- grow zebra fine=3
  refused 2 "level 1" "level=0" -- grow zebra level=1
  refused 2 "'thershold pairs=2'" "threshold, mapped, gray-scott" -- grow 'thershold pairs=2'
  refused 2 "5013 characters" 4000 -- grow "threshold $(printf '%5003s' '')"
  refused 2 "'zebra?rho=9'" -- grow "$(printf 'zebra\nrho=9')"
  local name
  for name in zebra giraffe mitosis; do
    refused 2 "--size 16x16" $name "at least $(least_of $name)" -- grow $name --size 16
    refused 2 "--size 16x16" $name "at least $(least_of $name)" -- info $name --size 16
    check "$name: the size it names will do" run grow $name --size "$(least_of $name)" --steps 1 --hash
  done
  refused 2 "--size 16x16" reptile -- sheet --size 16
  refused 2 "--size 98x96" "multiples of 4" -- grow zebra levels=3 --size 98x96
}

test_failures() {
  refused 1 "'missing/x.png'" -- grow zebra --size 64 -o missing/x.png
  refused 1 "'.'" directory -- grow zebra --size 64 -o . --format png
  limit=8000000  # sanitizers do not live with a limit
  if run --version > /dev/null 2>&1; then refused 1 memory bytes coral -- grow coral --size 65535; fi
  limit=
  mkdir "$folder/closed" && chmod a-w "$folder/closed"
  [ -w "$folder/closed" ] || refused 1 closed -- grow zebra --size 64 -o "$folder/closed/x.png"
  [ ! -w /dev/full ] || refused 1 "'/dev/full'" -- grow zebra --size 64 --format ppm -o /dev/full
  if [ -w /dev/full ]; then
    local command
    for command in "list" "info zebra" "grow zebra --hash" "grow zebra --size 64 -o -" "--help"; do
      # shellcheck disable=SC2086
      run $command > /dev/full 2> "$folder/err"
      equal "$command on a full device: exit code" $? 1
      equal "$command on a full device: lines" "$(($(wc -l < "$folder/err")))" 1
    done
  fi
  # What stood under the name stays when growing fails, and goes when it does not; a link stays a link.
  echo kept > "$folder/old.png" && ln -s "$folder/old.png" link.png
  run grow zebra --size 8 -o link.png 2> /dev/null
  equal "a refused run keeps the file" "$(cat "$folder/old.png")" kept
  run grow zebra --size 64 -o link.png
  check "a link stays a link" test -L link.png
  pictures size "$folder/old.png" 64 64
}

# Directions from pictures: one of one grey is a constant map; what cannot be read is refused, and says why.
test_maps() {
  local maps=$folder/maps
  mkdir -p "$maps"
  { printf 'P5\n# one direction\n5 3\n255\n'; head -c 15 /dev/zero; } > "$maps/flat.pgm"
  { printf 'P5 16 16 255\n'; for _ in $(seq 32); do printf '\1\100\377\100\1\100\377\100'; done; } > "$maps/bars.pgm"
  { printf 'P6 2 1 255\n'; printf '\377\200\0\1\200\0'; } > "$maps/two.ppm"
  printf 'P5 16 16 255\nshort' > "$maps/short.pgm"
  printf 'P5 16 x 255\n' > "$maps/header.pgm"
  printf 'P5 16 16 65535\n' > "$maps/deep.pgm"
  printf 'P5 99999 16 255\n' > "$maps/wide.pgm"
  printf 'GIF89a' > "$maps/other.pgm"
  equal "map: one grey, one direction" "$(hash_of radial --size 64 map=@"$maps/flat.pgm" --map-as values)" "$(hash_of radial --size 64 map=none)"
  equal "map: bars run down" "$(hash_of radial --size 64 map=@"$maps/bars.pgm" steps=3)" "$(hash_of radial --size 64 map=none angle=90 steps=3)"
  differ "map: red and green" "$(hash_of radial --size 64 map=@"$maps/two.ppm" --map-as values)" "$(hash_of radial --size 64 map=none)"
  check "map: info takes one" run info radial map=@"$maps/flat.pgm"
  check "map: kept bytes" grep -qE '^  of them kept +131072 bytes$' <(run info radial)
  equal "map: solver=lean keeps none" "$(run info radial solver=lean | grep -c 'of them kept')" 0
  refused 1 "$maps/none.pgm" "No such file" -- grow radial map=@"$maps/none.pgm"
  refused 1 short.pgm "5 bytes of pixels, not 256" -- grow radial map=@"$maps/short.pgm"
  refused 1 header.pgm header damaged -- grow radial map=@"$maps/header.pgm"
  refused 1 deep.pgm 65535 255 -- grow radial map=@"$maps/deep.pgm"
  refused 1 wide.pgm 99999x16 8192 -- grow radial map=@"$maps/wide.pgm"
  refused 1 other.pgm "PGM or PPM" -- info radial map=@"$maps/other.pgm"
  run grow weave --size 64 -o "$maps/weave.png" &&
    run grow weave --size 64 -o "$maps/weave.ppm"
  head -c 900 "$maps/weave.png" > "$maps/short.png"
  if run info radial map=@"$maps/weave.png" > /dev/null 2>&1; then
    equal "map: a PNG is its pixels" "$(hash_of radial --size 64 map=@"$maps/weave.png")" "$(hash_of radial --size 64 map=@"$maps/weave.ppm")"
    refused 1 short.png "libpng says" -- grow radial map=@"$maps/short.png"
  else
    refused 1 weave.png "built with libpng" -- grow radial map=@"$maps/weave.png"
  fi
  { printf 'P6 1 1 255\n'; printf '\377\200\377'; } > "$maps/plain.ppm"
  { printf 'P5 2 1 255\n'; printf '\377\100'; } > "$maps/shorter.pgm"
  equal "style: the recipe's own" "$(hash_of radial --size 64 style=@"$maps/plain.ppm")" "$(hash_of radial --size 64)"
  differ "style: shorter waves" "$(hash_of radial --size 64 style=@"$maps/shorter.pgm")" "$(hash_of radial --size 64)"
  refused 1 short.pgm "5 bytes of pixels, not 256" -- grow radial style=@"$maps/short.pgm"
  refused 2 "map=@FILE" -- grow radial map=image
  refused 2 "style=@FILE" -- grow radial solver=styled
  refused 2 "'map'" threshold -- grow zebra map=@"$maps/flat.pgm"
  refused 2 "--map-as 'up'" structure values -- grow radial --map-as up
}

# A signal takes the unfinished files along, and the folder made for them.
test_signal() {
  local job tries to
  for to in "-o long.png" "--maps new --mips"; do
    rm -rf -- *
    # shellcheck disable=SC2086
    "$dapple" grow gs-worms steps=1000000 --size 512 $to &
    job=$! tries=0
    while [ -z "$(ls -A . new 2> /dev/null | grep part)" ] && [ $tries -lt 100 ]; do sleep 0.05; tries=$((tries + 1)); done
    check "$to: unfinished files have names of their own" test -n "$(ls -d .dapple-*.part new/.dapple-*.part 2> /dev/null)"
    kill -TERM $job
    wait $job 2> /dev/null
    equal "$to: ended by the signal" $? 143
    equal "$to: nothing is left" "$(ls -A)" ""
  done
}

for part in words list info bytes steps pictures raw repeat header sheet usage_errors recipe_errors failures maps signal; do
  test_$part
done
echo "cli: $passed passed, $failed failed"
[ $failed -eq 0 ]
