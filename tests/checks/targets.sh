#!/usr/bin/env bash
# The self-test of ports/ on every machine that can be emulated: what it prints equals tests/golden/targets.txt.
#   targets.sh [BUILD]       builds and runs every target; a line for each (BUILD is not looked at)
#   targets.sh --only NAME   one of them
#   targets.sh --bless       writes the golden from a native build first
#   targets.sh --packages    what it takes, as tests/run installs it: command:package
# SPDX-License-Identifier: MIT
. "$(dirname "$0")/common.bash"
. "$root/demo/packages.bash"
. "$root/ports/machines.bash"

golden=$root/tests/golden/targets.txt
patience=120  # seconds for one run
watch=()
options=

# NAME LINES OPTIONS...: LINES is how many lines the memory there makes room for; small: the self-test for 2 KB of RAM.
targets() {
  cat <<'LIST'
native          34 -DPOOL=524288
aarch64         34 -DPOOL=524288
armhf           34 -DPOOL=524288
riscv64         34 -DPOOL=524288
i686            34 -DPOOL=524288
s390x           34 -DPOOL=524288
ppc64           34 -DPOOL=524288
m68k            34 -DPOOL=524288
cortex-m0       23 -DPOOL=10400 -DSELFTEST_FIXED
cortex-m3       34 -DPOOL=524288
cortex-m4       34 -DPOOL=524288
cortex-m4-dsp   34 -DPOOL=524288
cortex-m7       34 -DPOOL=524288
cortex-m33      34 -DPOOL=524288
cortex-m55      34 -DPOOL=393216
cortex-m55-helium 34 -DPOOL=393216
rv32imc         34 -DPOOL=524288
rv64imac        34 -DPOOL=524288
rv32ec           4 small
atmega328p       4 small
atmega1284p     16 -DPOOL=10400 -DSELFTEST_FIXED -DSELFTEST_SHORT
atmega2560       7 -DPOOL=2600 -DSELFTEST_FIXED
lx106           33 -DPOOL=131072
LIST
}

# grow NAME OPTIONS...: the self-test there; what it says is in $out/said. NAME-KERNELS: with that list of ports/cortex-m.
grow() {
  local name=$1 main=ports/selftest/main.cpp kernels files=(ports/selftest/selftest.cpp lib/one.cpp)
  shift
  options=$*
  case $name in *-helium | *-dsp)
    kernels=${name##*-} name=${name%-*}
    options+=" -DSELFTEST_KERNELS=dapple::$kernels::kernels"
    files+=("ports/cortex-m/$kernels.cpp" ports/selftest/rows.cpp) ;;
  esac
  [ ! -f "$root/ports/$(port_of "$name")/main.cpp" ] || main=ports/$(port_of "$name")/main.cpp
  files+=("$main")
  [ "$options" != small ] || options="" files=(ports/selftest/small.cpp)
  build_for "$name" && run_on "$name"
}

# compare SAID LINES GOLDEN: says what differs, if anything does. Lines that begin with # are remarks.
compare() {
  local wrong lines
  lines=$(grep -c '^[^#]' "$1")
  wrong=$(grep '^[^#]' "$1" | grep -vxFf "$3" | head -3)
  [ -z "$wrong" ] || { echo "differs: ${wrong//$'\n'/; }"; return 1; }
  [ "$lines" -eq "$2" ] || { echo "$lines textures, not $2"; return 1; }
  [ "$(sort -u "$1" | grep -c '^[^#]')" -eq "$lines" ] || { echo "a line comes twice"; return 1; }
}

# What firmware puts into flash; a static program of Linux is mostly the C library.
flash_of() {
  [ "$(port_of "${1%-helium}")" = linux ] || llvm-size "$2" | awk 'NR == 2 { printf ", %d bytes of flash", $1 + $2 }'
}

# run_target NAME LINES OPTIONS...: leaves its verdict in $scratch/NAME/verdict
run_target() {
  local name=$1 lines=$2 out=$scratch/$1 start=$SECONDS verdict
  shift 2
  if ! grow "$name" "$@" > "$out/log" 2>&1 < /dev/null; then
    verdict="does not build or run: $(cat "$out/log" "$out/said" 2> /dev/null | tail -4)"
  elif verdict=$(compare "$out/said" "$lines" "$golden"); then
    verdict="$((SECONDS - start)) s$(flash_of "$name" "$out/program")$(sed -n 's/^# /, /p' "$out/said" | tr -d '\n')"
    echo "$name: $lines textures equal ($verdict)" > "$out/good"
    return
  fi
  echo "$name: $verdict" > "$out/bad"
}

# One altered digit has to be seen.
test_the_comparison() {
  sed '1s/0$/1/; t; 1s/.$/0/' "$golden" > "$scratch/altered.txt"
  ! compare "$golden" 34 "$scratch/altered.txt" > /dev/null || fail "the comparison does not see an altered digit"
  compare "$golden" 34 "$golden" > /dev/null || fail "the comparison refuses what is right"
}

# Where a line is that of a preset as tests/golden/presets.txt has it, both hold the same hash.
test_the_golden() {
  local line found=0
  while read -r line; do
    grep -qF "$line " "$root/tests/golden/presets.txt" || fail "not in tests/golden/presets.txt: $line"
    found=$((found + 1))
  done < <(grep ' 128x128 1337 ' "$golden")
  [ "$found" -ge 3 ] || fail "tests/golden/targets.txt shares $found lines with presets.txt"
}

bless() {
  local out=$scratch/bless
  mkdir "$out"
  grow native -DPOOL=524288 || { fail "the native build fails"; finish; }
  ! grep 'is [fr]' "$out/said" || { fail "not blessed"; finish; }
  cp "$out/said" "$golden"
  echo "wrote tests/golden/targets.txt: $(wc -l < "$golden") lines"
}

only=
case ${1:-} in
  --packages) echo $machine_packages; exit 0 ;;
  --only) only=${2:?a target} ;;
esac
# shellcheck disable=SC2086
missing=$(missing_of $machine_packages)
[ -z "$missing" ] || { echo "missing packages:" $missing; exit 1; }
[ "${1:-}" != --bless ] || bless

while read -r name rest; do
  [ -z "$only" ] || [ "$only" = "$name" ] || continue
  mkdir "$scratch/$name"
  while [ "$(jobs -rp | wc -l)" -ge 2 ]; do wait -n; done
  # shellcheck disable=SC2086
  run_target "$name" $rest &
done < <(targets)
wait
while read -r name rest; do
  if [ -f "$scratch/$name/bad" ]; then fail "$(cat "$scratch/$name/bad")"
  elif [ -f "$scratch/$name/good" ]; then cat "$scratch/$name/good"
  elif [ -z "$only" ]; then fail "$name: no verdict"
  fi
done < <(targets)
test_the_golden
[ -n "$only" ] || test_the_comparison
finish
