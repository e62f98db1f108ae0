#!/usr/bin/env bash
# The AVR demo prints, from the 2 KB of a simulated ATmega328P, the text that the desktop grows.
#   avr_demo.sh [BUILD]      (BUILD is not looked at)
#   avr_demo.sh --packages   what it takes, as tests/run installs it: command:package
# SPDX-License-Identifier: MIT
. "$(dirname "$0")/common.bash"
case ${1:-} in
  --packages) exec "$root/demo/avr/run" --packages ;;
esac
need g++ clang++-16 avr-gcc simavr

g++ -std=c++17 -O1 -I"$root/lib" "$root/demo/avr/desktop.cpp" -o "$scratch/desktop" && "$scratch/desktop" > "$scratch/want" ||
  { fail "the desktop's program does not build or run"; finish; }
"$root/demo/avr/run" > "$scratch/got" || fail "demo/avr/run fails"
cmp "$scratch/want" "$scratch/got" || fail "the board prints another text"
[ "$(wc -l < "$scratch/got")" -eq 99 ] || fail "not three tiles of 32 lines"
[ "$(tr -d '\n' < "$scratch/got" | fold -w 1 | sort -u | wc -l)" -eq 10 ] || fail "not ten shades"

"$root/demo/avr/run" --fast > "$scratch/said" 2>&1
[ $? -eq 2 ] && grep -q "cannot use '--fast'" "$scratch/said" || fail "an unknown option: not a clear error with status 2"
finish
