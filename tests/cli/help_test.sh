#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# What all commands have in common: help, limits, and the refusal of words that are not commands.
# Usage: help_test.sh PATH_OF_OCCLUDE
set -uo pipefail
. "$(dirname "$0")/common.sh"
walk_of_squares

expect_error "frobnicate" "$occlude" frobnicate

for command in "" generate "generate city" preprocess walk why classify validate fuzz bench "bench kernel" "bench culler"; do
  "$occlude" $command --help >stdout || fail "no help for '$command'"
  grep -q . stdout || fail "an empty help for '$command'"
done

for command in "classify" "fuzz" "validate" "walk" "why" "preprocess" "bench culler"; do
  "$occlude" $command --help >stdout
  grep -q 'Limits: at most 16 MiB .* 4096 MiB' stdout || fail "$command --help does not tell limits"
done

# A line without end is not read to its end, and the message says how much is read.
for command in "classify" "fuzz" "validate good.ply --path path.json --witness"; do
  expect_error "/dev/zero:1: the line is longer than 16 MiB" timeout 60 "$occlude" $command /dev/zero
done
for command in "fuzz --merge" "walk good.ply --out out --path" "walk good.ply --path path.json --out out --preprocess" \
  "walk --path path.json --out out"; do
  expect_error "/dev/zero: cannot read: it is not a regular file" timeout 60 "$occlude" $command /dev/zero
done

finish
