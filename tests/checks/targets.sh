#!/usr/bin/env bash
# The self-test of ports/ on every machine that can be emulated: what it prints equals tests/golden/targets.txt.
#   targets.sh [BUILD]       builds and runs every target; a line for each (BUILD is not looked at)
#   targets.sh --only NAME   one of them
#   targets.sh --bless       writes the golden from a native build first
#   targets.sh --packages    what it takes, as tests/run installs it: command:package
# SPDX-License-Identifier: MIT
. "$(dirname "$0")/common.bash"
. "$root/demo/packages.bash"

packages="g++:g++ clang++:clang ld.lld:lld llvm-size:llvm
  qemu-aarch64-static:qemu-user-static qemu-system-arm:qemu-system-arm
  qemu-system-riscv32:qemu-system-misc arm-none-eabi-g++:gcc-arm-none-eabi avr-gcc:gcc-avr simavr:simavr
  /usr/lib/avr/include/avr/version.h:avr-libc xtensa-lx106-elf-g++:gcc-xtensa-lx106
  aarch64-linux-gnu-g++:g++-aarch64-linux-gnu arm-linux-gnueabihf-g++:g++-arm-linux-gnueabihf
  riscv64-linux-gnu-g++:g++-riscv64-linux-gnu i686-linux-gnu-g++:g++-i686-linux-gnu
  s390x-linux-gnu-g++:g++-s390x-linux-gnu powerpc64-linux-gnu-g++:g++-powerpc64-linux-gnu
  m68k-linux-gnu-g++:g++-m68k-linux-gnu"

golden=$root/tests/golden/targets.txt
patience=120  # seconds for one run
sections="-ffunction-sections -fdata-sections"
plain="-std=c++17 -Os $sections -fno-exceptions -fno-rtti -fno-threadsafe-statics -Wall -Wextra -Werror"
plain+=" -I$root/lib -I$root/ports/selftest"
bare="-ffreestanding -fno-unwind-tables -fno-asynchronous-unwind-tables"
bare_c="-Os $bare $sections -fno-builtin"
shared="ports/selftest/selftest.cpp lib/one.cpp"

# NAME LINES HOW ARGUMENTS...: LINES is how many lines the memory there makes room for.
targets() {
  cat <<'LIST'
native          27 on_linux g++ -
aarch64         27 on_linux aarch64-linux-gnu-g++ qemu-aarch64-static
armhf           27 on_linux arm-linux-gnueabihf-g++ qemu-arm-static
riscv64         27 on_linux riscv64-linux-gnu-g++ qemu-riscv64-static
i686            27 on_linux i686-linux-gnu-g++ qemu-i386-static
s390x           27 on_linux s390x-linux-gnu-g++ qemu-s390x-static
ppc64           27 on_linux powerpc64-linux-gnu-g++ qemu-ppc64-static
m68k            27 on_linux m68k-linux-gnu-g++ qemu-m68k-static
cortex-m0       16 on_cortex_m microbit 0 256K 0x20000000 16K 10400 -DSELFTEST_FIXED -mcpu=cortex-m0
cortex-m3       27 on_cortex_m mps2-an385 0 4M 0x20000000 4M 524288 -mcpu=cortex-m3
cortex-m4       27 on_cortex_m mps2-an386 0 4M 0x20000000 4M 524288 -mcpu=cortex-m4 -mfloat-abi=soft
cortex-m4-dsp   27 with dsp on_cortex_m mps2-an386 0 4M 0x20000000 4M 524288 -mcpu=cortex-m4 -mfloat-abi=soft
cortex-m7       27 on_cortex_m mps2-an500 0 4M 0x20000000 4M 524288 -mcpu=cortex-m7 -mfloat-abi=soft
cortex-m33      27 on_cortex_m mps2-an505 0x10000000 4M 0x38000000 2M 524288 -mcpu=cortex-m33 -mfloat-abi=soft
cortex-m55      27 on_cortex_m mps3-an547 0 512K 0x20000000 512K 393216 -mcpu=cortex-m55 -mfloat-abi=hard
cortex-m55-helium 27 with helium on_cortex_m mps3-an547 0 512K 0x20000000 512K 393216 -mcpu=cortex-m55 -mfloat-abi=hard
rv32imc         27 on_riscv 32 -march=rv32imc -mabi=ilp32
rv64imac        27 on_riscv 64 -march=rv64imac -mabi=lp64
atmega1284p     16 on_avr 10400
lx106           26 on_xtensa 131072
LIST
}

# Each of these builds in the folder $out and leaves what the program says in $out/said.
on_linux() {
  local compiler=$1 emulator=$2
  [ "$emulator" = - ] && emulator=
  # shellcheck disable=SC2086
  (cd "$root" && $compiler $plain -static -Wl,--gc-sections ports/linux/main.cpp $shared -o "$out/program") || return 1
  # shellcheck disable=SC2086
  timeout $patience $emulator "$out/program" > "$out/said"
}

# compile COMPILER OPTIONS... -- FILES...: an object of each file
compile() {
  local command=() file
  while [ "$1" != -- ]; do command+=("$1"); shift; done
  shift
  for file; do "${command[@]}" -c "$root/$file" -o "$out/$(basename "$file").o" || return 1; done
}

# with NAME HOW ARGUMENTS...: the textures grow by the row kernels of ports/cortex-m/NAME.cpp, which are first
# compared with the portable ones.
with() {
  local kernels="ports/cortex-m/$1.cpp ports/selftest/rows.cpp" list="-DSELFTEST_KERNELS=dapple::$1::kernels"
  shift
  "$@" "$list"
}

on_cortex_m() {
  local board=$1 places="rom=$2,--defsym=rom_size=$3,--defsym=ram=$4,--defsym=ram_size=$5" pool=$6
  shift 6
  local cpu="-mthumb $*"
  # shellcheck disable=SC2086
  compile arm-none-eabi-gcc $cpu $bare_c -fno-tree-loop-distribute-patterns -- \
      ports/cortex-m/start.c ports/bare/memory.c &&
    compile arm-none-eabi-g++ $cpu $plain $bare -DPOOL="$pool" -- ports/cortex-m/main.cpp ${kernels:-} $shared &&
    arm-none-eabi-gcc $cpu -nostdlib -nostartfiles -Wl,--gc-sections "-Wl,--defsym=$places" \
      -T "$root/ports/cortex-m/board.ld" "$out"/*.o -lgcc -o "$out/program" || return 1
  timeout $patience qemu-system-arm -M "$board" -display none -monitor none -serial none \
    -semihosting-config enable=on,target=native -kernel "$out/program" > "$out/said" 2>&1
}

on_riscv() {
  local bits=$1
  shift
  local target="--target=riscv$bits-unknown-elf $* -mcmodel=medany -mno-relax"
  # shellcheck disable=SC2086
  compile clang++ $target $plain $bare -DPOOL=524288 -- ports/riscv/main.cpp $shared &&
    compile clang $target $bare_c -- ports/riscv/start.S ports/bare/wide.c ports/bare/memory.c &&
    ld.lld --gc-sections -T "$root/ports/riscv/virt.ld" "$out"/*.o -o "$out/program" || return 1
  timeout $patience "qemu-system-riscv$bits" -M virt -bios none -display none -monitor none -serial none \
    -semihosting-config enable=on,target=native -kernel "$out/program" > "$out/said" 2>&1
}

# simavr ends a line with a dot and the end of a colour. -Oz: ports/avr/README.md says why.
on_avr() {
  # shellcheck disable=SC2086
  (cd "$root" && clang++ --target=avr -mmcu=atmega1284p $plain -Oz -DSELFTEST_FIXED -DPOOL="$1" -Wl,--gc-sections \
    ports/avr/main.cpp $shared -o "$out/program") || return 1
  timeout $patience simavr -m atmega1284p -f 16000000 "$out/program" > "$out/raw" 2>&1 || return 1
  sed -E 's/\x1b\[[0-9;]*m//g; s/\.*\r?$//; /^$/d; /^Loaded /d' "$out/raw" > "$out/said"
}

on_xtensa() {
  local cpu="-mlongcalls -mtext-section-literals"
  # shellcheck disable=SC2086
  compile xtensa-lx106-elf-gcc $cpu $bare_c -fno-tree-loop-distribute-patterns -- \
      ports/xtensa/start.S ports/xtensa/product.c ports/bare/wide.c ports/bare/memory.c &&
    compile xtensa-lx106-elf-g++ $cpu $plain $bare -DPOOL="$1" -- ports/xtensa/main.cpp $shared &&
    xtensa-lx106-elf-gcc -nostdlib -nostartfiles -Wl,--gc-sections -T "$root/ports/xtensa/sim.ld" \
      "$out"/*.o -lgcc -o "$out/program" || return 1
  timeout $patience qemu-system-xtensa -M sim -cpu lx106 -semihosting -display none -monitor none -serial none \
    -kernel "$out/program" > "$out/said" 2>&1
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
  [ "$1" = on_linux ] || llvm-size "$2" | awk 'NR == 2 { printf ", %d bytes of flash", $1 + $2 }'
}

# run_target NAME LINES HOW ARGUMENTS...: leaves its verdict in $scratch/NAME/verdict
run_target() {
  local name=$1 lines=$2 out=$scratch/$1 start=$SECONDS verdict
  shift 2
  if ! "$@" > "$out/log" 2>&1 < /dev/null; then
    verdict="does not build or run: $(cat "$out/log" "$out/said" 2> /dev/null | tail -4)"
  elif verdict=$(compare "$out/said" "$lines" "$golden"); then
    verdict="$((SECONDS - start)) s$(flash_of "$1" "$out/program")$(sed -n 's/^# /, /p' "$out/said" | tr -d '\n')"
    echo "$name: $lines textures equal ($verdict)" > "$out/good"
    return
  fi
  echo "$name: $verdict" > "$out/bad"
}

# One altered digit has to be seen.
test_the_comparison() {
  sed '1s/0$/1/; t; 1s/.$/0/' "$golden" > "$scratch/altered.txt"
  ! compare "$golden" 27 "$scratch/altered.txt" > /dev/null || fail "the comparison does not see an altered digit"
  compare "$golden" 27 "$golden" > /dev/null || fail "the comparison refuses what is right"
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
  on_linux g++ - || { fail "the native build fails"; finish; }
  ! grep 'is [fr]' "$out/said" || { fail "not blessed"; finish; }
  cp "$out/said" "$golden"
  echo "wrote tests/golden/targets.txt: $(wc -l < "$golden") lines"
}

only=
case ${1:-} in
  --packages) echo $packages; exit 0 ;;
  --only) only=${2:?a target} ;;
esac
# shellcheck disable=SC2086
missing=$(missing_of $packages)
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
