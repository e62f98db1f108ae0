# The machines of ports/: how a program is built for each and run under emulation. Sourced by tests/checks/targets.sh and
# ports/footprint/measure, which set
#   root            the tree                       options   for the C++ compiler, beside those here
#   out             an existing folder             files     C++ sources, from the root
#   patience        seconds for one run            watch     for the emulator: an array
# build_for NAME makes $out/program, run_on NAME what it says in $out/said; port_of NAME is its folder in ports/.
# What lib/one.cpp is for a machine is kept in build/machines for all that is built of the same library.
# SPDX-License-Identifier: MIT
machine_packages="g++:g++ clang++:clang ld.lld:lld llvm-size:llvm
  qemu-aarch64-static:qemu-user-static qemu-system-arm:qemu-system-arm
  qemu-system-riscv32:qemu-system-misc arm-none-eabi-g++:gcc-arm-none-eabi clang++-16:clang-16 avr-gcc:gcc-avr simavr:simavr
  /usr/lib/avr/include/avr/version.h:avr-libc xtensa-lx106-elf-g++:gcc-xtensa-lx106
  riscv64-unknown-elf-g++:gcc-riscv64-unknown-elf
  aarch64-linux-gnu-g++:g++-aarch64-linux-gnu arm-linux-gnueabihf-g++:g++-arm-linux-gnueabihf
  riscv64-linux-gnu-g++:g++-riscv64-linux-gnu i686-linux-gnu-g++:g++-i686-linux-gnu
  s390x-linux-gnu-g++:g++-s390x-linux-gnu powerpc64-linux-gnu-g++:g++-powerpc64-linux-gnu
  m68k-linux-gnu-g++:g++-m68k-linux-gnu"

sections="-ffunction-sections -fdata-sections"
plain="-std=c++17 -Os $sections -fno-exceptions -fno-rtti -fno-threadsafe-statics -Wall -Wextra -Werror"
plain+=" -I$root/lib -I$root/ports/selftest"
bare="-ffreestanding -fno-unwind-tables -fno-asynchronous-unwind-tables"
bare_c="-Os $bare $sections -fno-builtin"

# NAME KIND ARGUMENTS...
machines() {
  cat <<'LIST'
native          linux g++ -
aarch64         linux aarch64-linux-gnu-g++ qemu-aarch64-static
armhf           linux arm-linux-gnueabihf-g++ qemu-arm-static
riscv64         linux riscv64-linux-gnu-g++ qemu-riscv64-static
i686            linux i686-linux-gnu-g++ qemu-i386-static
s390x           linux s390x-linux-gnu-g++ qemu-s390x-static
ppc64           linux powerpc64-linux-gnu-g++ qemu-ppc64-static
m68k            linux m68k-linux-gnu-g++ qemu-m68k-static
cortex-m0       cortex-m microbit 0 256K 0x20000000 16K -mcpu=cortex-m0
cortex-m3       cortex-m mps2-an385 0 4M 0x20000000 4M -mcpu=cortex-m3
cortex-m4       cortex-m mps2-an386 0 4M 0x20000000 4M -mcpu=cortex-m4 -mfloat-abi=soft
cortex-m7       cortex-m mps2-an500 0 4M 0x20000000 4M -mcpu=cortex-m7 -mfloat-abi=soft
cortex-m33      cortex-m mps2-an505 0x10000000 4M 0x38000000 2M -mcpu=cortex-m33 -mfloat-abi=soft
cortex-m55      cortex-m mps3-an547 0 512K 0x20000000 512K -mcpu=cortex-m55 -mfloat-abi=hard
rv32imc         riscv 32 -march=rv32imc -mabi=ilp32
rv64imac        riscv 64 -march=rv64imac -mabi=lp64
rv32ec          riscv-e 16K 2K
rv32ec-large    riscv-e 1M 1M
atmega328p      avr -O1
atmega1284p     avr -Oz
atmega2560      avr -Oz
lx106           xtensa
LIST
}

# machine KIND|ARGUMENTS of NAME
machine() { machines | awk -v name="$1" '$1 == name { sub(/^[^ ]+ +/, ""); print }'; }
port_of() {
  case $(machine "$1") in
    riscv*) echo riscv ;;
    *) machine "$1" | cut -d' ' -f1 ;;
  esac
}
build_for() {
  local name=$1 words
  read -ra words <<< "$(machine "$name")"
  [ ${#words[@]} -gt 0 ] || { echo "no such machine: $name"; return 1; }
  "build_${words[0]//-/_}" "$name" "${words[@]:1}"
}
run_on() {
  local name=$1 words
  read -ra words <<< "$(machine "$name")"
  "run_${words[0]//-/_}" "$name" "${words[@]:1}"
}

# compile COMPILER OPTIONS... -- FILES...: an object of each file
compile() {
  local command=() file
  while [ "$1" != -- ]; do command+=("$1"); shift; done
  shift
  for file; do
    if [ "$file" = lib/one.cpp ]; then compile_library "${command[@]}"
    else "${command[@]}" -c "$root/$file" -o "$out/${file//\//-}.o"; fi || return 1
  done
}

# compile_library COMPILER OPTIONS...: without definitions, which the library does not look at.
compile_library() {
  local command=() word object
  for word; do [[ $word = -D* ]] || command+=("$word"); done
  object=$root/build/machines/$({ echo "${command[@]}"; find "$root/lib" -type f -exec cat {} +; } | cksum | tr ' ' -).o
  mkdir -p "$root/build/machines"
  if [ ! -f "$object" ]; then
    "${command[@]}" -c "$root/lib/one.cpp" -o "$out/library" && mv "$out/library" "$object" || return 1
  fi
  cp "$object" "$out/lib-one.cpp.o"
}

# shellcheck disable=SC2086
build_linux() {
  compile $2 $plain $options -- ports/linux/host.cpp "${files[@]}" && $2 -static -Wl,--gc-sections "$out"/*.o -o "$out/program"
}

run_linux() {
  local emulator=$3
  [ "$emulator" = - ] && emulator=
  timeout "$patience" $emulator "$out/program" > "$out/said"
}

build_cortex_m() {
  local places="rom=$3,--defsym=rom_size=$4,--defsym=ram=$5,--defsym=ram_size=$6" cpu
  shift 6
  cpu="-mthumb $*"
  # shellcheck disable=SC2086
  compile arm-none-eabi-gcc $cpu $bare_c -fno-tree-loop-distribute-patterns -- \
      ports/cortex-m/start.c ports/bare/memory.c &&
    compile arm-none-eabi-g++ $cpu $plain $bare $options -- "${files[@]}" &&
    arm-none-eabi-gcc $cpu -nostdlib -nostartfiles -Wl,--gc-sections "-Wl,--defsym=$places" \
      -T "$root/ports/cortex-m/board.ld" "$out"/*.o -lgcc -o "$out/program"
}

run_cortex_m() {
  timeout "$patience" qemu-system-arm -M "$2" -display none -monitor none -serial none "${watch[@]}" \
    -semihosting-config enable=on,target=native -kernel "$out/program" > "$out/said" 2>&1
}

build_riscv() {
  local target="--target=riscv$2-unknown-elf $3 $4 -mcmodel=medany -mno-relax"
  # shellcheck disable=SC2086
  compile clang++ $target $plain $bare $options -- ports/riscv/host.cpp "${files[@]}" &&
    compile clang $target $bare_c -- ports/riscv/start.S ports/bare/wide.c ports/bare/memory.c &&
    ld.lld --gc-sections -T "$root/ports/riscv/virt.ld" "$out"/*.o -o "$out/program"
}

run_riscv() {
  timeout "$patience" "qemu-system-riscv$2" -M virt ${5:+-cpu "$5"} -bios none -display none -monitor none -serial none \
    "${watch[@]}" -semihosting-config enable=on,target=native -kernel "$out/program" > "$out/said" 2>&1
}

# Sixteen registers, flash and RAM of the given sizes. By gcc: clang 14 does not know RV32E.
build_riscv_e() {
  local target="-misa-spec=2.2 -march=rv32ec -mabi=ilp32e -mcmodel=medany -fno-tree-loop-distribute-patterns"
  # shellcheck disable=SC2086
  compile riscv64-unknown-elf-g++ $target $plain $bare $options -- ports/riscv/host.cpp "${files[@]}" &&
    compile riscv64-unknown-elf-gcc $target $bare_c -- ports/riscv/start.S ports/bare/memory.c &&
    riscv64-unknown-elf-gcc $target -nostdlib -nostartfiles -Wl,--gc-sections "-Wl,--defsym=rom_size=$2,--defsym=ram_size=$3" \
      -T "$root/ports/riscv/small.ld" "$out"/*.o -lgcc -o "$out/program"
}

run_riscv_e() { run_riscv "$1" 32 - - rv32,e=on,i=off,h=off,m=off,a=off,f=off,d=off,s=off,u=off,g=off; }

# ports/avr/README.md says why it is clang 16 and these options.
# shellcheck disable=SC2086
build_avr() {
  compile clang++-16 --target=avr "-mmcu=$1" $plain "$2" $options -- ports/avr/host.cpp "${files[@]}" &&
    clang++-16 --target=avr "-mmcu=$1" -Wl,--gc-sections "$out"/*.o -o "$out/program" && "$root/ports/avr/check" "$out/program"
}

# simavr ends a line with a dot and the end of a colour.
run_avr() {
  timeout "$patience" simavr -m "$1" -f 16000000 "$out/program" > "$out/raw" 2>&1 || return 1
  sed -E 's/\x1b\[[0-9;]*m//g; s/\.*\r?$//; /^$/d; /^Loaded /d' "$out/raw" > "$out/said"
}

build_xtensa() {
  local cpu="-mlongcalls -mtext-section-literals"
  # shellcheck disable=SC2086
  compile xtensa-lx106-elf-gcc $cpu $bare_c -fno-tree-loop-distribute-patterns -- \
      ports/xtensa/start.S ports/xtensa/product.c ports/bare/wide.c ports/bare/memory.c &&
    compile xtensa-lx106-elf-g++ $cpu $plain $bare $options -- "${files[@]}" &&
    xtensa-lx106-elf-gcc -nostdlib -nostartfiles -Wl,--gc-sections -T "$root/ports/xtensa/sim.ld" \
      "$out"/*.o -lgcc -o "$out/program"
}

run_xtensa() {
  timeout "$patience" qemu-system-xtensa -M sim -cpu lx106 -semihosting -display none -monitor none -serial none \
    "${watch[@]}" -kernel "$out/program" > "$out/said" 2>&1
}
