#!/usr/bin/env bash
# The browser page: its two modules built and compared in node, then used in headless Chromium; its bytes are the goldens' and the
# command line's. The portable module may take 48 KiB with five families, and 8 KiB more for each one that comes; the one with
# vectors 16 KiB more than that.
#   page.sh [BUILD]
#   page.sh --packages    what tests/run installs for it
# SPDX-License-Identifier: MIT
if [ "${1:-}" = --packages ]; then
  echo "clang++:clang wasm-ld:lld chromium:chromium node:nodejs npm:npm wasm-opt:binaryen"
  exit 0
fi
. "$(dirname "$0")/common.bash"
need clang++ wasm-ld wasm-opt chromium node npm timeout
build=$(cd "${1:-$root/build}" && pwd)
[ -x "$build/dapple" ] || { echo "$build/dapple is missing: configure with -DDAPPLE_TOOLS=ON and build"; exit 1; }

"$root/ports/wasm/build" "$build" || { echo "the modules do not build"; exit 1; }
families=$(grep -c '&[a-z_]*_model, [a-z_]*::numbers' "$root/lib/recipe/recipe.hpp")
[ "$families" -ge 12 ] || fail "only $families families are counted"

# fits NAME MOST
fits() {
  local bytes
  bytes=$(wc -c < "$build/wasm/$1.wasm")
  echo "$1.wasm: $bytes of at most $2 bytes for $families families"
  [ "$bytes" -le "$2" ] || fail "$1.wasm has $bytes bytes; $2 are the most for $families families"
}
fits dapple $(((48 + 8 * (families - 5)) * 1024))
fits dapple-simd $(((64 + 8 * (families - 5)) * 1024))

# The portable one has no instruction on vectors, which the other has.
plain() { wasm-opt --enable-bulk-memory --enable-sign-ext "$build/wasm/$1.wasm" -o "$scratch/plain.wasm" > "$scratch/plain" 2>&1; }
plain dapple || fail "dapple.wasm needs vectors: $(head -3 "$scratch/plain")"
! plain dapple-simd || fail "dapple-simd.wasm has no vectors"
timeout 500 node "$root/tests/page/modules.mjs" "$build/wasm" "$root/tests/golden" || fail "the modules in node"

if [ ! -d "$build/playwright/node_modules/playwright-core" ]; then
  npm install --prefer-offline --silent --no-audit --no-fund --prefix "$build/playwright" playwright-core@1.65.1 > "$scratch/npm" 2>&1 ||
    { echo "npm cannot install playwright-core: $(tail -3 "$scratch/npm")"; exit 1; }
fi
mkdir "$scratch/native"
{ "$build/dapple" grow zebra-bits --at 128,-256 --size 128x128 --seed 1337 --format raw --pixels rgba8888 -o "$scratch/native/chunk" &&
  "$build/dapple" grow zebra-bits --size 96x64 --seed 1337 --format raw --pixels rgb565 -o "$scratch/native/tile" &&
  "$build/dapple" list > "$scratch/native/list"; } || { echo "nothing native to compare with"; exit 1; }
NODE_PATH=$build/playwright/node_modules CHROMIUM=$(command -v chromium) \
  timeout 400 node "$root/tests/page/page.mjs" "$build/page/index.html" "$root/tests/golden/presets.txt" "$scratch/native" \
  "$build/page" || fail "the page in Chromium"
finish
