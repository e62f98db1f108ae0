#!/usr/bin/env bash
# ports/avr/check tells a lost product and constants that lie too far, and nothing of what is right.
#   avr_check.sh [BUILD]      (BUILD is not looked at)
#   avr_check.sh --packages   what it takes, as tests/run installs it: command:package
# SPDX-License-Identifier: MIT
. "$(dirname "$0")/common.bash"
case ${1:-} in
  --packages) echo "avr-gcc:gcc-avr /usr/lib/avr/include/avr/version.h:avr-libc"; exit ;;
esac
need avr-gcc avr-objdump avr-nm

# A reach into a large frame, as clang writes it.
reach='in r0, 0x3f
adiw r28, 3
ldd r24, Y+62
sbiw r28, 3
out 0x3f, r0'

# program NAME CODE: main is the code; constants stand before it.
program() {
  printf '.global main\n.text\nmain:\n%s\nret\n%s\n' "$2" "${3:-}" > "$scratch/$1.s"
  avr-gcc -mmcu=atmega2560 "$scratch/$1.s" -o "$scratch/$1" || fail "$1: does not assemble"
}

is_told() {
  program "$@"
  "$root/ports/avr/check" "$scratch/$1" > "$scratch/said" && fail "$1: not told"
  grep -q "${4:-r0 was lost}" "$scratch/said" || fail "$1: told as: $(cat "$scratch/said")"
}
is_right() {
  program "$@"
  "$root/ports/avr/check" "$scratch/$1" > "$scratch/said" || fail "$1: told as: $(cat "$scratch/said")"
}

is_told lost $'mul r24, r22\neor r1, r1\n'"$reach"$'\nadd r30, r0'
is_told lost_behind_a_branch $'muls r24, r22\n'"$reach"$'\nbreq 1f\nmov r30, r0\n1:'
is_right taken_before $'mul r24, r22\nmov r30, r0\neor r1, r1\n'"$reach"
is_right another_product $'mul r24, r22\nmov r30, r0\n'"$reach"$'\nmul r24, r30\nadd r30, r0'
is_right on_another_way $'mul r24, r22\nbrne 1f\n'"$reach"$'\nret\n1: mov r30, r0'
is_right shifted $'in r0, 0x3f\nout 0x3f, r0\nmov r0, r24\n1: lsl r22\ndec r0\nbrpl 1b'
is_right near_constants nop $'.section .progmem.data,"a"\n.zero 60000'
is_told far_constants nop $'.section .progmem.data,"a"\n.zero 33000\n.section .progmem.more,"a"\n.zero 33000' 'constants reach to'
finish
