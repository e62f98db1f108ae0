#!/usr/bin/env bash
# The C face: its header is strict C99 and C++, a C linker suffices, a C program grows the goldens and is refused what
# it should be, with gcc and clang and under the sanitizers; the example of its README compiles, and all for a Cortex-M0.
# SPDX-License-Identifier: MIT
. "$(dirname "$0")/common.bash"
need gcc g++ clang clang++ llvm-nm llvm-size ld.lld

port=$root/ports/c
c_flags="-std=c99 -Wall -Wextra -pedantic -Werror -I$port"
cpp_flags="-std=c++17 -Wall -Wextra -Werror -fno-exceptions -fno-rtti -I$root/lib -I$port"
helpers='mem(cpy|set)|__aeabi_(mem(cpy|move|set|clr)[48]?|u?idiv(mod)?|u?ldivmod|lmul|llsl|llsr|lasr)'
bare="--target=thumbv6m-none-eabi -mcpu=cortex-m0 -mfloat-abi=soft -ffreestanding -Os"
sanitize="-g -fsanitize=address,undefined -fno-sanitize=function,vptr -fno-sanitize-recover=all"  # those two: C++ only

# What runs beside the rest notes its failures here.
note() { echo "$*" >> "$scratch/failed"; }

# quietly NAME COMMAND...: the output is shown only on failure
quietly() {
  local name=$1
  shift
  "$@" > "$scratch/$name.log" 2>&1 && return 0
  note "$name: ${*:1:2} ... failed: $(head -15 "$scratch/$name.log")"
  return 1
}

# shellcheck disable=SC2086
headers_compile() {
  local compiler
  echo '#include "dapple.h"' > "$scratch/header.c"
  sed -n '/^```c$/,/^```$/{/^```/d;p}' "$port/README.md" > "$scratch/example.c"
  for compiler in gcc clang; do
    quietly "$compiler-header" $compiler $c_flags -Wconversion -Wshadow -Wc++-compat -fsyntax-only "$scratch/header.c"
    quietly "$compiler-header++" $compiler $cpp_flags -Wconversion -pedantic -x c++ -fsyntax-only "$scratch/header.c"
    quietly "$compiler-example" $compiler $c_flags -fsyntax-only "$scratch/example.c"
  done
  quietly clang-c11 clang $c_flags -std=c11 -Weverything -Wno-padded -fsyntax-only "$scratch/header.c"
}

# build NAME C++COMPILER CCOMPILER LEVEL OPTIONS...: the program is $scratch/NAME; linked as C. The options are not for the
# library itself, of which hostile.sh has many builds.
# shellcheck disable=SC2086
build() {
  local out=$scratch/$1 name=$1 cxx=$2 cc=$3
  shift 3
  quietly "$name-lib" $cxx $cpp_flags "$1" -c "$root/lib/one.cpp" -o "$out-one.o" &&
    quietly "$name-port" $cxx $cpp_flags -Wconversion -Wshadow "$@" -c "$port/dapple_c.cpp" -o "$out-port.o" &&
    quietly "$name-test" $cc $c_flags "$@" "$port/test.c" "$out-port.o" "$out-one.o" -o "$out"
}

grows() {
  build "$@" && quietly "$1-run" "$scratch/$1" "$root/tests/golden/presets.txt" &&
    echo "$1: $(cat "$scratch/$1-run.log")"
}
refuses() { build "$@" && quietly "$1-run" "$scratch/$1" --errors; }

# Nothing but memory copies and integer helpers, and no byte of RAM.
# shellcheck disable=SC2086
fits_bare_metal() {
  local object=$scratch/bare
  quietly bare-port clang++ $cpp_flags -nostdinc++ $bare -c "$port/dapple_c.cpp" -o "$object-port.o" || return
  quietly bare-lib clang++ $cpp_flags -nostdinc++ $bare -c "$root/lib/one.cpp" -o "$object-lib.o" || return
  quietly bare-header clang $c_flags $bare -fsyntax-only "$scratch/header.c"
  llvm-nm --defined-only "$object-lib.o" | awk '{ print $3 }' | sort > "$scratch/defined"
  llvm-nm -u "$object-port.o" | awk '{ print $2 }' | sort | comm -23 - "$scratch/defined" |
    grep -vxE "$helpers" > "$scratch/asks"
  [ ! -s "$scratch/asks" ] || note "cortex-m0: asks for $(tr '\n' ' ' < "$scratch/asks")"
  ! llvm-nm "$object-port.o" | grep -E ' [bBdD] ' || note "cortex-m0: variables"
  ld.lld -r "$object-port.o" "$object-lib.o" -o "$object" || note "cortex-m0: the port and the library do not link"
  echo "cortex-m0: $(llvm-size "$object" | awk 'NR == 2 { print $1 + $2 }') bytes with all of the library"
}

headers_compile
grows gcc g++ gcc -O3 &
clang_and_bare() { grows clang clang++ clang -O3; fits_bare_metal; }
clang_and_bare &
wait
# shellcheck disable=SC2086
refuses sanitized clang++ clang -O1 $sanitize
[ ! -f "$scratch/failed" ] || fail "$(cat "$scratch/failed")"
finish
