#!/usr/bin/env bash
# The tables in README.md are what build/tables makes, times aside.
#   tables.sh [BUILD]
# SPDX-License-Identifier: MIT
set -eu
cd "$(dirname "$0")/../.."
"${1:-build}/tables" --check README.md
