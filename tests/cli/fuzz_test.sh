#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# `occlude fuzz`: nothing is wrong, and stored findings are found again.
# Usage: fuzz_test.sh PATH_OF_OCCLUDE
set -uo pipefail
. "$(dirname "$0")/common.sh"
walk_of_squares

three_cases

# Nothing is wrong, and the number of jobs does not change the result.
"$occlude" fuzz --cases 20000 --seed 7 >table || fail "fuzz: $(tail -3 table)"
grep -q '^all .*| *0 |' table || fail "fuzz: no total"
grep -q '^0 wrong in [0-9]* cases' table || fail "fuzz: no verdict"
without_time() { grep -v core_seconds "$1"; }
"$occlude" fuzz --cases 20000 --seed 7 --jobs 1 --json >one.json || fail "fuzz --jobs 1"
"$occlude" fuzz --cases 20000 --seed 7 --jobs 3 --json >three.json || fail "fuzz --jobs 3"
diff <(without_time one.json) <(without_time three.json) >/dev/null || fail "fuzz: the number of jobs changes the result"
"$occlude" fuzz --family lattice --family spoiled --cases 1 | grep -c '^spoiled\|^lattice' | grep -qx 2 || fail "fuzz --family"
"$occlude" fuzz cases.jsonl | grep -q '^cases.jsonl' || fail "fuzz FILE"
"$occlude" fuzz --seconds 0.2 | grep -q '^0 wrong in ' || fail "fuzz --seconds"
sed 's/"expect":"[a-z]*"/"expect":"outside"/' cases.jsonl >untrue.jsonl
"$occlude" fuzz untrue.jsonl --findings untrue_findings.jsonl --out untrue.json >table 2>stderr && fail "fuzz: a wrong expect is no finding"
grep -q '^WRONG .*: expect: outside, the oracle: inside' table || fail "fuzz: does not say what is wrong: $(cat table)"
"$occlude" fuzz untrue_findings.jsonl >again 2>stderr && fail "fuzz: a stored finding is none any more"
[ "$(grep -c '^WRONG' again)" -eq "$(grep -c '^WRONG' table)" ] || fail "fuzz: $(grep -c '^WRONG' again) of the stored findings again"
"$occlude" walk good.ply --path path.json --out recorded --no-render --cases recorded.jsonl >/dev/null || fail "walk --cases"
"$occlude" classify recorded.jsonl >stdout || fail "classify of what walk recorded"
[ -s stdout ] && [ "$(wc -l <stdout)" -eq "$(wc -l <recorded.jsonl)" ] || fail "walk --cases recorded nothing"
expect_error "nonsense: no such family" "$occlude" fuzz --family nonsense
expect_error "--cases" "$occlude" fuzz --cases 0
expect_error "--seconds" "$occlude" fuzz --seconds nan
expect_error "none/f" "$occlude" fuzz --cases 1 --findings none/f
expect_error "'many' is not a whole number" "$occlude" fuzz --cases many
expect_error "--family" "$occlude" fuzz cases.jsonl --family lattice
expect_error "--jobs" "$occlude" fuzz cases.jsonl --jobs 2
"$occlude" fuzz --cases 1 --family lattice --json --out late.json 2>stderr | true
ls -A | grep -q 'tmp-' && fail "left behind: $(ls -A | grep tmp-)"
cp untrue.jsonl $'odd\xff.jsonl'
"$occlude" fuzz $'odd\xff.jsonl' --json --findings odd_findings.jsonl >/dev/null 2>stderr
[ $? -eq 1 ] && [ -s odd_findings.jsonl ] || fail "fuzz: a file name that is not UTF-8: $(cat stderr)"
: >empty.jsonl
expect_error "empty.jsonl: no cases" "$occlude" fuzz empty.jsonl
expect_error "missing.jsonl" "$occlude" fuzz missing.jsonl
echo '{"id":"x"}' >bad.jsonl
expect_error "bad.jsonl:1: " "$occlude" fuzz bad.jsonl

# With too little memory it says so, also where the libraries of exact numbers would end it, and takes that for no finding.
with_memory() { (ulimit -v "$1" && exec timeout 60 "$occlude" "${@:2}"); }
if with_memory 200000 --version >/dev/null 2>&1; then # a sanitizer needs more to begin with
  least=28000
  until with_memory $least --version >/dev/null 2>&1; do least=$((least + 500)); done
  refused=0
  for kib in $(seq $least 500 $((least + 12000))); do
    with_memory $kib fuzz --cases 1 --jobs 2 --findings '' >stdout 2>stderr
    code=$?
    [ $code -ne 2 ] || refused=$((refused + 1))
    [ $code -eq 0 ] || { [ $code -eq 2 ] && [ "$(wc -l <stderr)" -eq 1 ] && grep -q 'out of memory' stderr; } ||
      fail "$kib KiB: exit $code: $(tail -n 2 stdout) $(cat stderr)"
  done
  [ $refused -gt 0 ] || fail "memory is not out with $least KiB"
fi

# It can be stopped while it waits for input.
interrupt_reader "$occlude" fuzz pipe

finish
