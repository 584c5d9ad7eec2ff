#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Prints how much of the kernel the tests and the fuzzer's corpus run: a table of lines and branches, and every line that is
# not reached. Exit code 1 if a test fails. Needs clang and llvm (llvm-profdata, llvm-cov). Usage: bash tests/coverage.sh
set -euo pipefail
cd "$(dirname "$0")/.."
tool() { command -v "$1" || ls /usr/lib/llvm-*/bin/"$1" | tail -n 1; }
profdata=$(tool llvm-profdata) cov=$(tool llvm-cov)
folder=build/coverage
tests=(kernel_tests oracle_tests differential_tests culler_tests)
harnesses=(overlap construction traversal)

cmake --preset coverage >/dev/null
cmake --build --preset coverage --target "${tests[@]}" "${harnesses[@]}"
rm -f "$folder"/*.profraw
export LLVM_PROFILE_FILE="$PWD/$folder/%p.profraw"
status=0
run() { "$@" >"$folder/log.txt" 2>&1 || { status=1; cat "$folder/log.txt"; }; }
binaries=()
for name in "${tests[@]}"; do
  run "$folder/tests/$name" --gtest_brief=1
  binaries+=("$folder/tests/$name")
done
for name in "${harnesses[@]}"; do
  run "$folder/fuzz/$name" "fuzz/corpus/$name"
  binaries+=("$folder/fuzz/$name")
done
"$profdata" merge -sparse "$folder"/*.profraw -o "$folder/kernel.profdata"
others=("${binaries[@]:1}")
what=(-instr-profile "$folder/kernel.profdata" "${binaries[0]}" "${others[@]/#/-object=}"
  '-ignore-filename-regex=(tests|fuzz|oracle|culler|render)/[^/]*(/|\.)')
"$cov" report "${what[@]}" -show-functions=false -show-branch-summary |
  awk 'NR == 1 || NF > 10 { print $1, $8, $9, $10, $11, $12, $13 }' | column -t
echo
echo "Lines that nothing reached:"
"$cov" show "${what[@]}" -show-instantiations=false |
  awk '/^[^ ].*:$/ { file = $1; sub(".*/kernel/", "kernel/", file) } /^ +[0-9]+\| +0\|/ { print file, $0 }'
exit $status
