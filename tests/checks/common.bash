# What the checks share: the tree, a scratch folder, tools that have to be there, and how failures are told.
# SPDX-License-Identifier: MIT
set -u
export LC_ALL=C
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failures=0

fail() {
  printf '%s\n' "$*"
  failures=$((failures + 1))
}

# A check that lacks a tool has failed; tests/run installs them all.
need() {
  local tool
  for tool; do
    command -v "$tool" >/dev/null || { echo "$tool is missing: ./tests/run says how to install it"; exit 1; }
  done
}

# Tracked files, and new ones that are not ignored; outside a checkout, all there are.
files_of_tree() {
  (cd "$root" && if git rev-parse --git-dir >/dev/null 2>&1; then
     git ls-files --cached --others --exclude-standard -- "$@" | while IFS= read -r f; do [ -f "$f" ] && printf '%s\n' "$f"; done
   else
     find "${@:-.}" -path ./build -prune -o -type f -print | sed 's|^\./||'
   fi) | sort -u
}

finish() {
  [ "$failures" -eq 0 ] || { echo "$failures found"; exit 1; }
  exit 0
}
