#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The shared library exports the functions of occlude.h and nothing else, and the tests in C use each of them.
# Usage: exports_test.sh LIBRARY HEADER
set -euo pipefail
library=$1 header=$2 tests=$(dirname "$0")

declared=$(tr '\n' ' ' <"$header" | grep -oE 'OCCLUDE_API [^;(]*\(' | grep -oE 'occlude_[a-z_]*\($' | tr -d '(' | sort)
exported=$(nm --dynamic --defined-only "$library" | awk '{print $3}' | sort)
diff <(echo "$declared") <(echo "$exported") || { echo "FAILED: declared (<), exported (>)"; exit 1; }
status=0
for name in $declared; do
  grep -qw "$name" "$tests"/*.c || { echo "FAILED: no test calls $name"; status=1; }
done
[ $status -eq 0 ] && echo "$(wc -w <<<"$declared") functions are exported, and all are tested"
exit $status
