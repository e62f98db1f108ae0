# What demo/run and tests/run share: installing what is missing, or saying how.
# SPDX-License-Identifier: MIT

# is_there WANTED: a command on the path, a header (NAME.h) that the compiler finds, clang's sanitizers, or QEMU's window.
is_there() {
  case $1 in
    sanitizers) echo "int main() {}" | clang++ -fsanitize=address,undefined -x c++ - -o /dev/null > /dev/null 2>&1 ;;
    qemu-window) qemu-system-arm -display help 2> /dev/null | grep -qxE 'gtk|sdl' ;;
    *.h) echo "#include <$1>" | c++ -std=c++17 -E -x c++ - > /dev/null 2>&1 ;;
    *) command -v "$1" > /dev/null ;;
  esac
}

# missing_of WANTED:PACKAGE...: the Debian packages of what is not there.
missing_of() {
  local pair
  for pair; do is_there "${pair%%:*}" || echo "${pair##*:}"; done | sort -u
}

# shellcheck disable=SC2086
# install_missing WANTED:PACKAGE...: installs with apt-get as root; otherwise says what to do, and ends the script.
install_missing() {
  local packages log
  packages=$(missing_of "$@")
  [ -n "$packages" ] || return 0
  if [ "$(id -u)" -eq 0 ] && command -v apt-get > /dev/null; then
    echo "installing:" $packages
    export DEBIAN_FRONTEND=noninteractive
    log=$(mktemp)
    { apt-get update && apt-get install -y --no-install-recommends $packages; } > "$log" 2>&1 || tail -5 "$log"
    rm -f "$log"
    packages=$(missing_of "$@")
    [ -n "$packages" ] || return 0
    echo "still missing:" $packages
    exit 1
  fi
  echo "missing; on Debian and Ubuntu:"
  echo "  sudo apt-get install -y --no-install-recommends" $packages
  exit 1
}
