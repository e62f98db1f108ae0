#!/usr/bin/env bash
# Textures of every family on several threads (tests/desktop/races.cpp) under the thread sanitizer: no race, the same bytes.
# SPDX-License-Identifier: MIT
. "$(dirname "$0")/common.bash"
need g++
case $(uname -m) in x86_64 | amd64) sets="sse2:16: avx2:32:-mavx2,-mbmi,-mbmi2,-mfma" options=-DDAPPLE_X86 ;;
  aarch64 | arm64) sets="neon:16:" options=-DDAPPLE_ARM ;;
  *) sets="" options= ;;
esac
flags="-std=c++17 -O1 -g -fsanitize=thread -I$root/lib -I$root/ports/desktop"
desktop=$root/ports/desktop

compile() {
  # shellcheck disable=SC2086
  g++ $flags "$@" || fail "does not compile: $*"
}

cd "$scratch" || exit 1
for set in $sets; do
  IFS=: read -r name bytes more <<< "$set"
  compile ${more//,/ } -DDAPPLE_SET="$name" -Ddapple="dapple_$name" -DDAPPLE_WIDE="$bytes" -c "$desktop/set.cpp" -o "$name.o"
done
compile $options -c "$desktop/tables.cpp"
compile "$root/tests/desktop/races.cpp" "$root/lib/one.cpp" "$desktop"/{crew,driver,fluxed,fused,growers,masks,strips}.cpp ./*.o -pthread -o races
[ "$failures" -eq 0 ] && { TSAN_OPTIONS=halt_on_error=1 ./races > said 2>&1 || fail "$(head -40 said)"; }

# The sanitizer would see a race: without the wait for the others there is one.
sed 's/left_ > 0; ++i) breathe();/false; ++i) breathe();/; s/  if (left_ == 0) return;/  return;/' "$desktop/crew.cpp" > careless.cpp
cmp -s careless.cpp "$desktop/crew.cpp" && fail "crew.cpp has changed: this check no longer takes the wait out of it"
compile -I"$desktop" "$root/tests/desktop/races.cpp" "$root/lib/one.cpp" careless.cpp "$desktop"/{driver,fluxed,fused,growers,masks,strips}.cpp ./*.o -pthread -o careless
TSAN_OPTIONS=halt_on_error=1 ./careless > said 2>&1 && fail "a crew that does not wait passes"
finish
