# What the tests of the command line share: the program, a folder to work in, and how checks are told and counted.
#   . common.bash with the script's own arguments
# SPDX-License-Identifier: MIT
set -u
export LC_ALL=C
if [ $# -ne 1 ] || [ ! -x "$1" ]; then echo "usage: $(basename "$0") DAPPLE, the program to test" >&2; exit 2; fi
here=$(cd "$(dirname "$0")" && pwd)
dapple=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/work" && cd "$folder/work" || exit 1
passed=0 failed=0

good() { passed=$((passed + 1)); }
bad() { echo "FAILED: $*"; failed=$((failed + 1)); }

# check NAME COMMAND...: the command succeeds.
check() {
  local name=$1
  shift
  if "$@" > "$folder/said" 2>&1; then good; else bad "$name: $(tail -3 "$folder/said" | tr '\n' ' ')"; fi
}
equal() { if [ "$2" = "$3" ]; then good; else bad "$1: '$2' is not '$3'"; fi; }
differ() { if [ "$2" != "$3" ]; then good; else bad "$1: both are '$2'"; fi; }

# refused CODE TEXT... -- ARGUMENTS...: the script's `run` with these gives that exit code, one line on stderr with every
# TEXT, nothing on stdout, no file.
refused() {
  local code=$1 got texts=() text
  shift
  while [ "$1" != -- ]; do texts+=("$1"); shift; done
  shift
  rm -f -- *
  run "$@" > "$folder/out" 2> "$folder/err" < /dev/null
  got=$?
  equal "$*: exit code" "$got" "$code"
  equal "$*: lines on stderr" "$(($(wc -l < "$folder/err")))" 1
  equal "$*: stdout" "$(head -c 100 "$folder/out")" ""
  equal "$*: files" "$(ls -A)" ""
  for text in "dapple: " "${texts[@]}"; do
    if grep -qF -e "$text" "$folder/err"; then good; else bad "$*: no '$text' in: $(cat "$folder/err")"; fi
  done
}
