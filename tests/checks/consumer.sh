#!/usr/bin/env bash
# A project outside the tree builds with dapple, installed and as a subfolder, and grows the same bytes both ways.
# SPDX-License-Identifier: MIT
. "$(dirname "$0")/common.bash"
need cmake

# quietly NAME COMMAND...: the output is shown only on failure
quietly() {
  local name=$1
  shift
  "$@" > "$scratch/log" 2>&1 && return 0
  fail "$name: $* failed: $(tail -15 "$scratch/log")"
  finish
}

# grown_by NAME OPTIONS...: configures and builds the consumer, not optimised, and with it the library where that is a
# subfolder; prints what it prints
grown_by() {
  local name=$1
  shift
  quietly "$name" cmake -S "$scratch/outside" -B "$scratch/$name" -DCMAKE_BUILD_TYPE=Debug "$@"
  quietly "$name" cmake --build "$scratch/$name" --parallel "$(nproc)"
  quietly "$name" "$scratch/$name/consumer"
  cp "$scratch/log" "$scratch/$name.txt"
}

cp -r "$root/tests/consumer" "$scratch/outside"
quietly library cmake -S "$root" -B "$scratch/library" --preset library -DCMAKE_INSTALL_PREFIX="$scratch/prefix"
quietly library cmake --build "$scratch/library" --parallel "$(nproc)"
quietly install cmake --install "$scratch/library"
[ ! -e "$scratch/library/dapple" ] || fail "the library preset builds the command line"

grown_by installed -DCMAKE_PREFIX_PATH="$scratch/prefix"
grown_by subfolder -DDAPPLE_SOURCE="$root"
[ ! -e "$scratch/subfolder/dapple/dapple" ] || fail "as a subfolder, dapple builds its tools"
cat "$scratch/installed.txt"
cmp -s "$scratch/installed.txt" "$scratch/subfolder.txt" || fail "as a subfolder: $(cat "$scratch/subfolder.txt")"
finish
