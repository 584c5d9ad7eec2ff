#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# render/demo.sh validates its walk in pictures of the same size. It runs here with programs in place of cmake and occlude
# that record their arguments. Usage: demo_test.sh SOURCES.
set -u
source=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failures=0
fail() {
  echo "FAILED: $1"
  failures=$((failures + 1))
}

mkdir -p "$folder"/{render,.ci,bin,build/release}
cp "$source/render/demo.sh" "$folder/render/"
: >"$folder/.ci/packages.sh"
printf '#!/bin/sh\n' >"$folder/bin/cmake"
printf '#!/bin/sh\necho "$@" >>calls\n' >"$folder/build/release/occlude"
chmod +x "$folder/bin/cmake" "$folder/build/release/occlude"

# expect SIZE_OPTIONS ARGUMENTS...: expects these options of size for walk and validate.
expect() {
  local size=$1
  shift
  rm -f "$folder/calls"
  PATH="$folder/bin:$PATH" bash "$folder/render/demo.sh" "$@" >"$folder/log" 2>&1 || fail "demo $*: $(cat "$folder/log")"
  for command in walk validate; do
    [ "$(grep "^$command " "$folder/calls" | grep -o -- '--size[= ][^ ]*')" = "$size" ] ||
      fail "demo $*: $command is told $(grep "^$command " "$folder/calls")"
  done
}

expect ""
expect "" --frames 0:20:10
expect "--size 64x36" --size 64x36
expect "--size 64x36" --frames 0:20:10 --size 64x36 --occluders 2
expect "--size=64x36" --size=64x36

[ $failures -eq 0 ] && echo "All demo tests passed"
exit $failures
