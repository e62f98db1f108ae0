#!/usr/bin/env bash
# A program that names one preset links that preset, its model and its solver, and nothing of the others or of recipes
# as text. Prints what it takes.
#   onepreset.sh --packages   what it takes, as tests/run installs it: command:package
# SPDX-License-Identifier: MIT
if [ "${1:-}" = --packages ]; then
  echo clang++-16:clang-16
  exit
fi
. "$(dirname "$0")/common.bash"
need g++ clang++ clang++-16 ld.lld llvm-nm llvm-size

flags="-std=c++17 -ffunction-sections -fdata-sections -fno-exceptions -fno-rtti -fno-threadsafe-statics -I$root/lib"
bare="-ffreestanding -nostdinc++ -fno-asynchronous-unwind-tables"

# build TARGET PRESET: the program is $scratch/TARGET-PRESET; the library is compiled once a target.
build() {
  local out=$scratch/$1-$2 library=$scratch/$1.o compiler size=-Os link
  link="ld.lld --gc-sections -e main --unresolved-symbols=ignore-all -o $out"
  case $1 in
    x86-64) compiler="g++ -fno-asynchronous-unwind-tables" link="g++ -Wl,--gc-sections -o $out" ;;
    cortex-m0) compiler="clang++ --target=thumbv6m-none-eabi -mcpu=cortex-m0 -mfloat-abi=soft $bare" ;;
    avr) compiler="clang++-16 --target=avr -mmcu=atmega328p $bare" size=-Oz ;;  # as ports/avr/README.md says
  esac
  [ -f "$library" ] || $compiler $flags $size -c "$root/lib/one.cpp" -o "$library" || return 1
  $compiler $flags $size "-DONE_PRESET=$2" -c "$root/tests/checks/onepreset.cpp" -o "$out.o" || return 1
  $link "$library" "$out.o" 2> "$out.err" || { cat "$out.err"; return 1; }
}

# check TARGET PRESET PATTERN: no symbol of the program matches
check() {
  local out=$scratch/$1-$2 found
  build "$1" "$2" || { fail "$1, $2: does not build"; return; }
  found=$(llvm-nm -C --defined-only "$out" | cut -d' ' -f3- | grep -E "$3|dapple::recipe::|dapple::parse|dapple::write|kPresets|preset_(at|count)|find_preset")
  found+=$(llvm-nm -C --defined-only "$out" | cut -d' ' -f3- | grep 'dapple::presets::' | grep -v "dapple::presets::$2\$")
  [ -z "$found" ] || fail "$1, $2: also links $(echo $found)"
  llvm-nm -C --defined-only "$out" | grep -q "dapple::presets::$2\$" || fail "$1, $2: the preset itself is not there"
  llvm-size -A "$out" | awk -v name="$1, $2" '
    /^\.(text|rodata|ARM|progmem|data\.rel\.ro)/ { flash += $2 } /^\.text/ { text += $2 } /^\.(data|bss) / { ram += $2 }
    END { printf "%-20s .text %6d, with constants %6d bytes; .data and .bss %6d bytes\n", name, text, flash, ram }'
}

others='turing|meinhardt|fitzhugh|schnakenberg|brusselator|kinetics_|cascade|euler|nine_row|dapple::(bits|cells)|convol|mask|sliced'
for target in x86-64 cortex-m0 avr; do
  check $target zebra "gray_scott|kinetic|laplacian|five_row|$others"
  check $target mitosis "threshold|lattice|gaussian|pass_|series|$others"
done
rest='gray_scott|threshold|lattice|gaussian|five_row|nine_row|meinhardt|fitzhugh|schnakenberg|brusselator|cascade|dapple::(bits|cells)|convol|mask'
for target in x86-64 cortex-m0; do
  check $target turing_spots "$rest|phases|point_row|segment"
done
echo "(64 x 64 cells in .bss; without start-up code and the compiler's integer helpers; x86-64 with the C start-up code)"
finish
