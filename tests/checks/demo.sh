#!/usr/bin/env bash
# The terminal stream draws, piped, the frames tests/golden/demo.txt has the hash of, and ends a terminal as it found it.
#   demo.sh [--bless] [BUILD]
# SPDX-License-Identifier: MIT
. "$(dirname "$0")/common.bash"

bless=no
[ "${1:-}" != --bless ] || { bless=yes; shift; }
stream=$(cd "${1:-$root/build}" && pwd)/demo/dapple_stream
golden=$root/tests/golden/demo.txt
[ -x "$stream" ] || { echo "$stream is missing: configure with -DDAPPLE_DEMO=ON and build"; exit 1; }

hash=$("$stream" --hash)
if [ $bless = yes ]; then
  echo "$hash" > "$golden"
  echo "wrote tests/golden/demo.txt"
fi
[ "$hash" = "$(cat "$golden")" ] || fail "the frames have the hash $hash, tests/golden/demo.txt has $(cat "$golden")"

"$stream" > "$scratch/frames"
[ "$(wc -l < "$scratch/frames")" -eq $((60 * 24)) ] || fail "piped: not 60 frames of 24 lines"
[ "$("$stream" --frames 5 --size 40x10 | wc -l)" -eq 50 ] || fail "--frames 5 --size 40x10: not 5 frames of 10 lines"
"$stream" --size 0x0 > "$scratch/frames" 2>&1
[ $? -eq 2 ] || fail "--size 0x0: the exit status is not 2"

# In a terminal, interrupted: the alternate screen and the hidden cursor are given back.
need script timeout
script -qec "timeout --foreground -s INT 0.5 '$stream'" "$scratch/screen" < <(sleep 1) > "$scratch/frames" 2>&1
grep -qF $'\e[?1049h' "$scratch/screen" || fail "in a terminal: no alternate screen"
grep -qF $'\e[?25h\e[?1049l' "$scratch/screen" || fail "interrupted: cursor and screen are not given back"
finish
