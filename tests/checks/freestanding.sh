#!/usr/bin/env bash
# lib/one.cpp compiles without a C++ library, a C library and an operating system, and asks for nothing but memory copies
# and integer helpers. On AVR, constant tables are in flash.
#   freestanding.sh --packages   what it takes, as tests/run installs it: command:package
# SPDX-License-Identifier: MIT
if [ "${1:-}" = --packages ]; then
  echo clang++-16:clang-16
  exit
fi
. "$(dirname "$0")/common.bash"
need clang++ clang++-16 llvm-nm llvm-objdump llvm-size

flags="-std=c++17 -ffreestanding -nostdinc++ -fno-exceptions -fno-rtti -Wall -Wextra -Werror -I$root/lib"
memory='mem(cpy|move|set)'
aeabi='__aeabi_(mem(cpy|move|set|clr)[48]?|u?idiv(mod)?|u?ldivmod|lmul|llsl|llsr|lasr|lcmp|ulcmp)'
helpers='__(u?(div|mod|divmod)|mul|ash[lr]|lshr|cmp|ucmp|clz|ctz)[qhsd]i[234]'
startup='__do_(copy_data|clear_bss)|__stack_pointer|__linear_memory|__indirect_function_table'
allowed="^($memory|$aeabi|$helpers|$startup)\$"

# compile NAME OPTIONS...: the object is $scratch/NAME.o, by $compiler
compile() {
  local name=$1
  shift
  # shellcheck disable=SC2086
  $compiler $flags "$@" -c "$root/lib/one.cpp" -o "$scratch/$name.o" 2> "$scratch/$name.err" && return 0
  fail "$name: does not compile: $(head -5 "$scratch/$name.err")"
  return 1
}

asks_for_little() {
  local name=$1 symbol symbols
  symbols=$(llvm-nm -u "$scratch/$name.o" | awk '{ print $2 }')
  for symbol in $symbols; do
    [[ $symbol =~ $allowed ]] || fail "$name: asks for $symbol"
  done
  printf '%-12s %6d bytes of code and constants; asks for: %s\n' "$name" \
    "$(llvm-size "$scratch/$name.o" | awk 'NR == 2 { print $1 + $2 }')" "$(echo $symbols)"
}

# Wasm has floating point instructions of its own, so the undefined symbols do not tell. The select of any type is f32.select there.
wasm_has_no_floats() {
  llvm-objdump -d "$scratch/wasm32.o" > "$scratch/wasm.s"
  grep -q 'i32\.add' "$scratch/wasm.s" || fail "wasm32: no instructions to look at"
  ! grep -E '\bf(32|64)\.' "$scratch/wasm.s" | grep -vm3 'f32\.select' || fail "wasm32: floating point instructions"
}

# What AVR keeps outside flash costs RAM: symbols of .rodata and .data, by size. What reads and writes recipes as text may
# (tools, not firmware), and what a function fills a small local from; a table may not.
avr_tables_are_in_flash() {
  local section size name flash=0 text=0 small=0
  while read -r section size name; do
    size=$((16#$size))
    case $section:$name in
      .text*) ;;
      .progmem.*) flash=$((flash + size)) ;;
      .rodata.str*) text=$((text + size)) ;;
      *:dapple::recipe::* | *:dapple::kPresets | *:dapple::*::numbers | *:dapple::*::ranges) text=$((text + size)) ;;
      .rodata* | .data* | .bss*)
        small=$((small + size))
        [ "$size" -le 32 ] || fail "avr: $name costs $size bytes of RAM in $section" ;;
    esac
  done < <(llvm-objdump -t -C "$scratch/avr.o" | sed -nE 's/^[0-9a-f]+ .{7} ([.][^[:space:]]+)[[:space:]]+([0-9a-f]+) (\.hidden )?(.*)$/\1 \2 \4/p' |
           awk '$2 !~ /^0+$/')
  echo "avr tables: $flash bytes in flash; in RAM $text bytes for recipes as text, $small bytes besides"
  [ "$flash" -gt 0 ] || fail "avr: no table is in flash"
}

compiler=clang++
compile x86-64 --target=x86_64-linux-gnu -mno-sse -mno-mmx -mno-80387 -Os && asks_for_little x86-64
compile cortex-m0 --target=thumbv6m-none-eabi -mcpu=cortex-m0 -mfloat-abi=soft -Os && asks_for_little cortex-m0
compile wasm32 --target=wasm32 -Os && asks_for_little wasm32 && wasm_has_no_floats
# As ports/avr/README.md says: clang 14 and other options break on functions of this size.
compiler=clang++-16
compile avr --target=avr -mmcu=atmega328p -Oz && asks_for_little avr && avr_tables_are_in_flash
finish
