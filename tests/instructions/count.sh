#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Counts the instructions of fixed work by callgrind, and holds them against those in expected.txt: at most 2 % more. Time
# depends on the machine and on what else it does; instructions do not.
# Usage: count.sh PROGRAM [--record]   --record writes the numbers into expected.txt instead: after a change that is worth it.
# Exit codes: 0 done, 1 more instructions, 77 no valgrind or one that does not know this processor, or not the compiler and the
# instruction set of the numbers.
set -euo pipefail
program=$1 action=${2:-check} expected=$(dirname "$0")/expected.txt

command -v valgrind >/dev/null || { echo "no valgrind"; exit 77; }
compiler=$(strings -a "$program" 2>/dev/null | grep -m1 '^GCC: ' || true)
if [ "$action" = check ] && [ "$compiler" != "$(sed -n 's/^# //p' "$expected" | tail -n 1)" ]; then
  echo "the numbers are of another compiler, not of $compiler"
  exit 77
fi

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
code=0
valgrind --quiet --tool=callgrind --collect-atstart=no --callgrind-out-file="$folder/out" "$program" || code=$?
if [ $code -eq 132 ] && "$program" >/dev/null; then
  echo "valgrind does not know an instruction of this processor"
  exit 77
fi
[ $code -eq 0 ] || exit $code

# Each dump has the name that the program gave it, and the total.
counted=$(awk '/^desc: Trigger: Client Request: / { name = $NF } /^totals: / { if (name != "") print name, $2 }' \
  "$folder"/out.* | sort -u)
if [ "$action" = --record ]; then
  { sed '/^[^#]/d; /^# GCC/d' "$expected"; echo "# $compiler"; echo "$counted"; } >"$folder/expected"
  cat "$folder/expected" >"$expected"
  exit 0
fi
echo "$counted" | awk -v expected="$expected" '
  BEGIN { while ((getline line < expected) > 0) { split(line, word, " "); if (word[1] != "#") known[word[1]] = word[2] } }
  {
    if (!($1 in known)) { print $1 " is not in expected.txt"; bad = 1; next }
    ratio = $2 / known[$1]
    verdict = ratio > 1.02 ? "MORE than 2 %" : ratio < 0.98 ? "less: worth recording" : ""
    printf "%-26s %12.0f  %6.3f  %s\n", $1, $2, ratio, verdict
    if (ratio > 1.02) bad = 1
    delete known[$1]
  }
  END { for (name in known) { print name " was not counted"; bad = 1 } exit bad }'
