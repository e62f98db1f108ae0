#!/usr/bin/env bash
# What the library takes on microcontrollers is what the table of ports/README.md says: no figure is more than 2 % above, and
# the limits that firmware is promised hold.
#   footprint.sh [BUILD]      (BUILD is not looked at)
#   footprint.sh --packages   what it takes, as tests/run installs it: command:package
# SPDX-License-Identifier: MIT
. "$(dirname "$0")/common.bash"
measure=$root/ports/footprint/measure
golden=$root/tests/golden/footprint.txt
case ${1:-} in
  --packages) exec "$measure" --packages ;;
esac

# compare FIGURES GOLDEN: what has grown, has gone or is new; what is smaller by as much is only told.
compare() {
  awk '
    /^#/ { next }
    FNR == NR { was[$1, $2] = $3; next }
    { name = $1 " " $2; now[$1, $2] = 1
      if (!(($1, $2) in was)) { print name ": is not in the table"; bad = 1; next }
      if ($3 * 100 > was[$1, $2] * 102) { printf "%s: %d, was %d: %.1f %% more\n", name, $3, was[$1, $2], 100 * $3 / was[$1, $2] - 100; bad = 1 }
      if ($3 * 102 < was[$1, $2] * 100) printf "%s: %d, was %d: the table may be made anew\n", name, $3, was[$1, $2] }
    END { for (n in was) if (!(n in now)) { split(n, part, SUBSEP); print part[1] " " part[2] ": is gone"; bad = 1 }
      exit bad }' "$2" "$1"
}

# limit TARGET WHAT MOST FIGURE...: the sum of figures
limit() {
  local target=$1 what=$2 most=$3 sum
  shift 3
  sum=$(awk -v target="$target" -v names=" $* " '$1 == target && index(names, " " $2 " ") { sum += $3; ++n } END { print n == 0 ? "none" : sum }' "$scratch/figures")
  [ "$sum" != none ] && [ "$sum" -le "$most" ] || fail "$target: $what: $sum, at most $most is promised"
}

"$measure" --figures > "$scratch/figures" 2> "$scratch/log" || { fail "$(cat "$scratch/log")"; finish; }
compare "$scratch/figures" "$golden" > "$scratch/said" ||
  fail "$(cat "$scratch/said")"$'\n'"if that is wanted: ports/footprint/measure --write"
cat "$scratch/said"
"$measure" --table "$golden" > "$scratch/table"
sed -n '/made by `ports\/footprint\/measure/,/footprint ends/p' "$root/ports/README.md" | sed '1d;$d' | cmp -s - "$scratch/table" ||
  fail "the table of ports/README.md is not that of tests/golden/footprint.txt"

limit cortex-m0 "flash" 6144 flash
limit atmega328p "flash" 8192 flash
limit atmega328p "RAM of a 64 x 64 tile with its stack" 1536 ram stack
limit atmega328p "RAM of a 128 x 64 display at full resolution with its stack" 2048 displays/ram displays/stack
limit atmega328p "cycles of a 128 x 64 display at half resolution, .4 s" 6400000 display/step
limit atmega328p "cycles of a 128 x 64 display at full resolution, 1.2 s" 19200000 sharp-display/step
limit rv32ec "flash" 16384 flash
limit rv32ec "RAM with its stack" 2048 ram stack

# The comparison sees a figure that has grown.
awk '$2 == "flash" && !done { $3 = int($3 * .95); done = 1 } { print }' "$golden" > "$scratch/lower"
! compare "$scratch/figures" "$scratch/lower" > /dev/null || fail "the comparison does not see 5 % more"
finish
