#!/usr/bin/env bash
# The OLED firmware on the emulated board: every scene's picture is the golden one, and the one the desktop paints.
#   oled.sh [--bless] [BUILD]
#   oled.sh --packages    what tests/run installs for it
# SPDX-License-Identifier: MIT
. "$(dirname "$0")/common.bash"
if [ "${1:-}" = --packages ]; then
  echo "$("$root/demo/oled/run" --packages) python3:python3"
  exit 0
fi
need arm-none-eabi-g++ qemu-system-arm python3

bless=no
[ "${1:-}" != --bless ] || { bless=yes; shift; }
desktop=$(cd "${1:-$root/build}" && pwd)/demo/dapple_oled
golden=$root/tests/golden/oled
[ -x "$desktop" ] || { echo "$desktop is missing: configure with -DDAPPLE_DEMO=ON and build"; exit 1; }

same() { python3 "$root/tests/cli/pictures.py" same "$1" "$2" 2> "$scratch/log"; }

# altered PICTURE: a copy of a PPM with one pixel of the panel, which is 4 x 4 of the window, one grey lighter or darker
altered() {
  python3 - "$1" "$scratch/altered.ppm" <<'CODE'
import sys
data = bytearray(open(sys.argv[1], 'rb').read())
pixels = len(data) - 512 * 256 * 3
first = pixels + (4 * 37 * 512 + 4 * 101) * 3
for row in range(4):
    for place in range(first + row * 512 * 3, first + row * 512 * 3 + 12):
        data[place] += 17 if data[place] < 255 else -17
open(sys.argv[2], 'wb').write(data)
CODE
}

"$root/demo/oled/run" --stills "$scratch/board" || { echo "the board shows no pictures"; exit 1; }
mkdir "$scratch/desktop"
"$desktop" "$scratch/desktop" > "$scratch/greys" || { echo "the desktop paints no pictures"; exit 1; }

scenes=0
for ours in "$scratch"/desktop/*.ppm; do
  scenes=$((scenes + 1))
  name=$(basename "$ours" .ppm)
  shown=$scratch/board/$name.png
  if ! same "$shown" "$ours"; then
    fail "$name: the board does not show what the desktop paints $(tail -1 "$scratch/log")"
  elif [ $bless = yes ]; then
    mkdir -p "$golden" && cp "$shown" "$golden/" && echo "wrote tests/golden/oled/$name.png"
  fi
  same "$ours" "$golden/$name.png" || fail "$name: not tests/golden/oled/$name.png $(tail -1 "$scratch/log")"
done
altered "$ours" || fail "no altered copy"
! same "$shown" "$scratch/altered.ppm" || fail "the comparison does not see an altered pixel"
[ "$scenes" -eq 3 ] || fail "$scenes scenes, not 3"
[ "$(grep -c ': 16 greys$' "$scratch/greys")" -eq 3 ] || fail "not all 16 greys: $(tr '\n' ' ' < "$scratch/greys")"
finish
