# What tests of the command line share that write pictures: running it, one file at a time, and decoding that.
# SPDX-License-Identifier: MIT
limit=  # of memory, KB
run() { (if [ -n "$limit" ]; then ulimit -v $limit; fi; exec "$dapple" "$@"); }

# makes FILE ARGUMENTS...: dapple writes that file, says nothing, and leaves nothing else behind.
makes() {
  local file=$1 said
  shift
  rm -rf -- *
  said=$(run "$@" 2>&1) || bad "$*: $said"
  equal "$* says nothing" "$said" ""
  equal "$* writes" "$(ls -A)" "$file"
  mv -f -- "$file" "$folder/" 2> /dev/null
}

python=no
if command -v python3 > /dev/null; then python=yes; else echo "python3 is missing: pictures are not decoded"; fi
pictures() { [ $python = no ] || check "$*" python3 "$here/pictures.py" "$@"; }
