#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the harnesses and runs each on its corpus. Usage: bash fuzz/harness/run.sh [SECONDS] [HARNESS...]
# Prints a line for each: what it ran, how fast, how much it covers, what it found. The exit code is 1 when one found
# something. The inputs that caused it and the whole log are in build/fuzzers/fuzz/found/HARNESS.
set -euo pipefail
cd "$(dirname "$0")/../.."
seconds=${1:-60}
[ $# -eq 0 ] || shift
[ $# -gt 0 ] || set -- overlap construction traversal model_reader path_reader case_reader preprocess_reader witness_reader

cmake --preset fuzzers >/dev/null
cmake --build --preset fuzzers --target harnesses >/dev/null

status=0
for name in "$@"; do
  found=build/fuzzers/fuzz/found/$name
  # New inputs go to the first folder. The corpus itself is only read.
  mkdir -p "$found" "build/fuzzers/fuzz/corpus/$name"
  # The process of the import library may take a minute before it is ended.
  timeout=10
  [ "$name" != model_reader ] || timeout=90
  rc=0
  nice -n 10 "build/fuzzers/fuzz/$name" -max_total_time="$seconds" -max_len=4096 -timeout=$timeout -rss_limit_mb=2048 \
    -malloc_limit_mb=2048 -print_final_stats=1 -artifact_prefix="$found/" \
    "build/fuzzers/fuzz/corpus/$name" "fuzz/corpus/$name" >"$found/log" 2>&1 || rc=$?
  number() { sed -n "s/^stat::$1: *//p" "$found/log" | tail -1; }
  coverage=$(sed -n 's/.* cov: \([0-9]*\) .*/\1/p' "$found/log" | tail -1)
  verdict="nothing found"
  if [ $rc -ne 0 ]; then
    status=1
    verdict=$(grep -m1 -E '^finding: |ERROR: |runtime error: ' "$found/log" || echo "exit code $rc, see $found/log")
  fi
  printf '%-16s %9s runs %7s/s  coverage %6s  %s\n' "$name" "$(number number_of_executed_units)" \
    "$(number average_exec_per_sec)" "${coverage:-?}" "$verdict"
done
exit $status
