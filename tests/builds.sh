#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Checks that every build gives the same answers bit for bit: g++ and clang++, -O0 and -O3, without and with FMA, and batches
# on every instruction set of this machine. Prints one line per build. Exit code 1 if one differs. Usage: bash
# tests/builds.sh (x86-64, minutes).
set -euo pipefail
cd "$(dirname "$0")/.."

# build_and_test COMPILER FLAGS...: prints "passed" or "FAILED" and how many tests; the log stays beside the build.
build_and_test() {
  local compiler=$1 flags=${*:2}
  local folder=build/answers/$compiler${flags// /}
  mkdir -p "$folder"
  {
    cmake -S . -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE= -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS="$flags" \
      -DOCCLUDE_TOOLS=OFF
    cmake --build "$folder" --target kernel_tests
  } >"$folder/log.txt" 2>&1 || { echo "FAILED to build: $folder/log.txt"; return 1; }
  local result=passed
  ctest --test-dir "$folder" --parallel "$(nproc)" --tests-regex 'Answers|Batch' >>"$folder/log.txt" 2>&1 || result=FAILED
  echo "$result, $(grep -o '[0-9]* tests failed out of [0-9]*' "$folder/log.txt" || echo "see $folder/log.txt")"
  [[ $result == passed ]]
}

status=0
for compiler in g++ clang++; do
  for level in -O0 -O3; do
    for fma in '' ' -mfma'; do
      start=$SECONDS
      result=$(build_and_test "$compiler" "$level$fma") || status=1
      printf '%-8s %-10s %s, %d s\n' "$compiler" "$level$fma" "$result" $((SECONDS - start))
    done
  done
done
exit $status
