#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The tests of the kernel and the culler under the address and undefined behaviour sanitizers. They run in one process per
# processor, not in one per test as ctest has it: of three thousand short tests the starts would take most of the time.
# Usage: bash tests/sanitizers.sh
set -euo pipefail
cd "$(dirname "$0")/.."
bash .ci/packages.sh
cmake --preset sanitizers >/dev/null
cmake --build --preset sanitizers

shards=$(nproc)
# run_shard INDEX: the tests whose number leaves this remainder.
run_shard() {
  local test
  for test in kernel_tests culler_tests; do
    GTEST_TOTAL_SHARDS=$shards GTEST_SHARD_INDEX=$1 "build/sanitizers/tests/$test" --gtest_brief=1
  done
}

pids=()
for ((shard = 0; shard < shards; ++shard)); do
  run_shard "$shard" &
  pids+=($!)
done
for pid in "${pids[@]}"; do wait "$pid"; done
for example in model scene; do "build/sanitizers/tests/${example}_example" >/dev/null; done
