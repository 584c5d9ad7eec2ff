#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Commands whose work is in parts: the same results under mpirun, and --resume after a killed process, with and without mpirun.
# Usage: mpirun_test.sh PATH_OF_OCCLUDE
set -uo pipefail
. "$(dirname "$0")/common.sh"
walk_of_squares

without_times() { sed '/core_seconds/d' "$1"; }
has_parts() { [ "$(ls "$1" 2>/dev/null | grep -c '^part-')" -ge 2 ]; } # two parts are finished

# One process: killed while it works, it goes on with what it has kept, and refuses what is not its own.
long=(fuzz --family lattice --cases 500000 --jobs 1 --findings '')
"$occlude" "${long[@]}" --parts kept --out killed.json >/dev/null 2>stderr &
await has_parts kept
{ kill -KILL $! && wait $!; } 2>/dev/null
has_parts kept || fail "no parts are kept"
expect_error "kept: has finished parts of an earlier run; go on with --resume" "$occlude" "${long[@]}" --parts kept
expect_error "kept: has parts of another run" "$occlude" "${long[@]}" --seed 2 --parts kept --resume
expect_error "none: has no parts of an earlier run" "$occlude" "${long[@]}" --parts none --resume
expect_error "occlude_fuzz_parts: has no parts" "$occlude" "${long[@]}" --resume
first=$(ls kept/part-* | head -1)
cp "$first" first
echo damage >>"$first"
expect_error "$first: not as a run of yours has kept it" "$occlude" "${long[@]}" --parts kept --resume
mv first "$first"
XDG_STATE_HOME=$here.another expect_error "kept: has parts of another run: another user" "$occlude" "${long[@]}" --parts kept --resume
rm -r "$here.another"
"$occlude" "${long[@]}" --parts kept --resume --out resumed.json >/dev/null || fail "fuzz --resume"
[ ! -e kept ] || fail "parts are left behind: $(ls kept)"
"$occlude" "${long[@]}" --out one.json >/dev/null || fail "fuzz"
cmp -s <(without_times one.json) <(without_times resumed.json) || fail "fuzz --resume: another result"
expect_error "--parts" "$occlude" fuzz --seconds 1 --parts kept
expect_error "--parts" "$occlude" fuzz --stop-at-first --parts kept
three_cases
expect_error "--parts" "$occlude" fuzz cases.jsonl --parts kept

# Interrupted, it says what is kept.
"$occlude" "${long[@]}" --parts kept >/dev/null 2>stderr &
await has_parts kept
kill -INT $!
wait $!
[ $? -eq 130 ] && grep -q '^occlude: [0-9]* finished parts are in kept: --resume goes on$' stderr || fail "SIGINT: $(cat stderr)"
rm -r kept

if ! command -v mpirun >/dev/null; then
  echo "No mpirun: several processes are not tried"
  finish
fi
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
ranks() { # ranks N COMMAND...: under mpirun
  local n=$1
  shift
  mpirun --oversubscribe -n "$n" "$@"
}
if ranks 2 "$occlude" fuzz --cases 1 --family lattice --findings '' 2>&1 | grep -q 'built without MPI'; then
  echo "Built without MPI: several processes are not tried"
  finish
fi

# same NAME FILE COMMAND...: the command, which writes FILE if that is not empty, gives what one process gives. It is run by
# as many processes as `numbers` says.
numbers="2 4"
same() {
  local name=$1 file=$2 status n
  shift 2
  "$occlude" "$@" >one.out 2>one.err
  status=$?
  [ -z "$file" ] || mv "$file" one.file
  for n in $numbers; do
    ranks $n "$occlude" "$@" >many.out 2>many.err
    [ $? -eq $status ] || fail "$name: -n $n: exit code instead of $status: $(cat many.err)"
    cmp -s <(without_times one.out) <(without_times many.out) || fail "$name: -n $n: another output"
    [ -z "$file" ] || cmp -s one.file "$file" || fail "$name: -n $n: another $file"
    cmp -s one.err <(grep '^occlude\|^frame\|^[a-z]*.jsonl' many.err) || fail "$name: -n $n: says $(cat many.err)"
    [ $status -eq 0 ] || rm -rf occlude_*_parts # what was finished before the bad input
    ! compgen -G 'occlude_*_parts' >/dev/null || fail "$name: -n $n: leaves parts behind"
  done
}
"$occlude" generate city --polygons 20000 --seed 5 --out city.ply --path city.json >/dev/null || fail "generate"
"$occlude" walk city.ply --path city.json --frames 0:200:20 --no-render --method cover --out walked --witness witness.jsonl >/dev/null || fail "walk"
city=(city.ply --path city.json)
same "fuzz" "" fuzz --cases 10000 --seed 3 --findings '' --json
ranks 1 "$occlude" fuzz --cases 10000 --seed 3 --findings '' --json >many.out || fail "fuzz: -n 1"
cmp -s <(without_times one.out) <(without_times many.out) || fail "fuzz: -n 1: another output"
same "validate a file" "" validate "${city[@]}" --witness witness.jsonl --json
same "validate anew" "" validate "${city[@]}" --frames 0:100:10 --size 160x90
same "validate anew, exactly" "" validate good.ply --path path.json --json
same "preprocess" city.pre preprocess city.ply --out city.pre --region-count 64 --samples 2 --quiet
same "preprocess without samples" city.pre preprocess city.ply --out city.pre --region-count 64 --quiet
sed '30s/"triangles":\[[0-9]*,/"triangles":[0,/; 40s/"box"/"bix"/' witness.jsonl >lie.jsonl
same "an unproved witness, then a line that is none" "" validate "${city[@]}" --witness lie.jsonl
numbers=2
sed '40s/"box"/"bix"/' witness.jsonl >nonsense.jsonl
same "a line that is no witness" "" validate "${city[@]}" --witness nonsense.jsonl
sed '30s/"triangles":\[[0-9]*,/"triangles":[0,/' witness.jsonl >lie.jsonl
same "an unproved witness" "" validate "${city[@]}" --witness lie.jsonl
same "help" "" validate --help
same "a missing model" "" validate missing.ply --path city.json
same "an option that is none" "" fuzz --nonsense
ranks 2 "$occlude" walk "${city[@]}" --frames 0:40:20 --no-render --out many >/dev/null 2>stderr || fail "walk: $(cat stderr)"
[ -s many/summary.json ] || fail "walk writes nothing under mpirun"
ranks 2 "$occlude" classify - <<<'{"id":"wall","eye":[0,0,0],"occluder":{"polygon":[[2,-1,-1],[2,1,-1],[2,1,1]]},"box":{"min":[4,0,0],"max":[5,0,0]}}' >stdout || fail "classify"
[ "$(wc -l <stdout)" -eq 1 ] || fail "every rank classifies: $(cat stdout)"

# All ranks must have the same input.
ranks 1 "$occlude" "${long[@]}" --seed 5 : -n 1 "$occlude" "${long[@]}" --seed 6 >stdout 2>stderr
[ $? -eq 2 ] && grep -q '^occlude: rank 1: it has other input' stderr || fail "ranks with other options: $(cat stderr)"

rank_of() { tr '\0' '\n' <"/proc/$1/environ" 2>/dev/null | sed -n 's/^OMPI_COMM_WORLD_RANK=//p'; }
# finds MPIRUN RANK: sets `process` to the process of the rank. It is found before it is waited for, because the work may be
# done soon after.
finds() {
  for process in $(pgrep -P "$1"); do
    [ "$(rank_of "$process")" != "$2" ] || return 0
  done
  return 1
}

# A rank that has nothing left to do while another one still works disturbs nothing: rank 2 stands still with its part until
# all the others are done.
regions=$("$occlude" preprocess city.ply --out city.pre --region-count 64 --json | sed -n 's/.*"regions": \([0-9]*\).*/\1/p')
all_but_one() { [ "$(ls occlude_preprocess_parts | grep -c '^part-')" -ge $((regions - 1)) ]; }
mpirun --oversubscribe -n 3 "$occlude" preprocess city.ply --out city.pre --region-count 64 --samples 8 --quiet >stdout 2>stderr &
await finds $! 2
await has_parts occlude_preprocess_parts
kill -STOP "$process"
await all_but_one
sleep 0.5 # rank 1 is told that nothing is left, and goes on
kill -CONT "$process"
wait $! || fail "a rank that is done first: $(cat stderr)"

# A rank is killed: mpirun fails, what is finished stays, and --resume goes on, with another number of ranks.
for victim in 0 1; do
  mpirun --oversubscribe -n 2 "$occlude" "${long[@]}" --out killed.json >/dev/null 2>stderr &
  await finds $! $victim
  await has_parts occlude_fuzz_parts
  kill -KILL "$process"
  wait $! && fail "rank $victim was killed, and mpirun succeeds"
  [ $victim -eq 0 ] || grep -q 'finished parts are in occlude_fuzz_parts: --resume goes on' stderr || fail "rank $victim: $(cat stderr)"
  [ ! -e killed.json ] || fail "rank $victim was killed, and there is a result"
  has_parts occlude_fuzz_parts || fail "rank $victim was killed, and no parts are kept"
  ranks 3 "$occlude" "${long[@]}" --resume --out resumed.json >/dev/null 2>stderr || fail "--resume: $(cat stderr)"
  cmp -s <(without_times one.json) <(without_times resumed.json) || fail "rank $victim was killed, and --resume gives another result"
  rm resumed.json
done

finish
