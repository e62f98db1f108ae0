#!/usr/bin/env bash
# The tree speaks of the project only: no paths of one machine, no folders beside it, no numbers of issues.
# SPDX-License-Identifier: MIT
. "$(dirname "$0")/common.bash"

look_for() {
  local what=$1 pattern=$2 line
  while IFS= read -r line; do fail "$what: ${line:0:160}"
  done < <(cd "$root" && files_of_tree | xargs -d '\n' grep -InE -e "$pattern" --)
}

look_for "a path of one machine" '/w[o]rk/|/t[m]p/[a-z]|/h[o]me/[a-z]|/r[o]ot/'
look_for "a folder beside the tree" '\.\./s[h]ared'
look_for "a number of an issue" '(^|[[:space:](])#[0-9]+([^0-9a-fA-F"]|$)'
finish
