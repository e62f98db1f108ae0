#!/usr/bin/env bash
# Every table of ports/desktop gives what tests/golden/small.txt says: the widest of this processor under the address and
# undefined behaviour sanitizers, the one of AArch64 under emulation.
#   kernels.sh --packages    the commands it takes, with their packages
# SPDX-License-Identifier: MIT
if [ "${1:-}" = --packages ]; then
  echo aarch64-linux-gnu-g++:g++-aarch64-linux-gnu qemu-aarch64-static:qemu-user-static
  exit
fi
. "$(dirname "$0")/common.bash"
need g++ aarch64-linux-gnu-g++ qemu-aarch64-static
desktop=$root/ports/desktop
# Without scopes: where a function that is not looked at (no_sanitize) takes in one that is, gcc leaves marks of scopes behind.
sanitize="-g -fsanitize=address,undefined -fno-sanitize-address-use-after-scope -fno-sanitize-recover=all"

# set_object COMPILER NAME BYTES OPTIONS...: $scratch/NAME.o
set_object() {
  local compiler=$1 name=$2 bytes=$3
  shift 3
  $compiler -std=c++17 -O1 -fno-exceptions -fno-rtti "$@" -DDAPPLE_SET="$name" -Ddapple="dapple_$name" -DDAPPLE_WIDE="$bytes" \
    -c "$desktop/set.cpp" -o "$scratch/$name.o" || fail "$name does not compile"
}

# program COMPILER FILE OPTIONS...: small_goldens with tables. The library itself is not instrumented: hostile.sh looks at it.
program() {
  local compiler=$1 out=$scratch/$2
  shift 2
  $compiler -std=c++17 -O1 -c "$root/lib/one.cpp" -o "$out-one.o" &&
    $compiler -std=c++17 -O1 "$@" -DDAPPLE_TABLES -I"$root/lib" -I"$desktop" "$root/tests/checks/small_goldens.cpp" \
      "$desktop"/{crew,driver,fluxed,fused,masks,strips,tables}.cpp "$out-one.o" -pthread -o "$out" && return
  fail "small_goldens does not build: $compiler $*"
  finish
}

# compare TABLE RUNNER...
compare() {
  local name=$1
  shift
  "$@" "$name" > "$scratch/$name.txt" 2> "$scratch/$name.err" || fail "$name: $(head -20 "$scratch/$name.err")"
  cmp -s "$scratch/$name.txt" "$root/tests/golden/small.txt" ||
    fail "$name: $(diff "$scratch/$name.txt" "$root/tests/golden/small.txt" | head -4)"
}

if [ "$(uname -m)" = x86_64 ]; then
  if grep -qw avx2 /proc/cpuinfo; then here=(sse2 avx2) sse2_too=; else here=(sse2) sse2_too=$sanitize; fi
  # shellcheck disable=SC2086
  set_object g++ sse2 16 $sse2_too
  # shellcheck disable=SC2086
  set_object g++ avx2 32 -mavx2 -mbmi -mbmi2 -mfma $sanitize
  # shellcheck disable=SC2086
  program g++ here $sanitize -DDAPPLE_X86 "$scratch/sse2.o" "$scratch/avx2.o"
  for table in "${here[@]}"; do compare "$table" "$scratch/here"; done
fi
set_object aarch64-linux-gnu-g++ neon 16
program aarch64-linux-gnu-g++ there -static -DDAPPLE_ARM "$scratch/neon.o"
compare neon qemu-aarch64-static "$scratch/there"
finish
