#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds with each planted fault in turn and sees whether the fuzzer, the tests and a validation catch it. Prints a Markdown
# list, an item as soon as it is known; exit 1 when a fault is missed.
#
# Usage: bash fuzz/mutants/run.sh [--only suite|fuzz|validate] [--seconds N] [NAME...]
#        bash fuzz/mutants/run.sh --check
#
#   NAME...          these faults only, by default all: fuzz/mutants/NAME.patch
#   --only CATCHER   builds and runs the tests, the fuzzer or the validation alone; by default the first two. A validation
#                    is `occlude validate` round each of the small scenes and on 400 frames through a generated city, in
#                    which some occluders are polytopes
#   --seconds N      what the fuzzer is given for a fault, default 60
#   --check          builds nothing: sees that every patch applies to the sources as they are
#
# The fuzzer first runs on a build without a fault, where it must find nothing. All are built in one folder, build/mutants, so
# that a fault costs what depends on the files that it changes. The log of the last one stays there: log.txt.
set -euo pipefail
cd "$(dirname "$0")/../.."

folder=build/mutants
log=$folder/log.txt
# Round the small scenes.
orbit='{"frames":60,"near":0.01,"interpolation":"smooth","keyframes":[
  {"eye":[0,0,0],"target":[9,0,0]},{"eye":[0.5,-6,1],"target":[9,0,0]},{"eye":[9,-11,2],"target":[9,0,0]},
  {"eye":[19,-2,3],"target":[9,0,0]},{"eye":[9,12,1],"target":[9,0,0]},{"eye":[0,1,0],"target":[9,0,0]}]}'
limit=900  # seconds for a run of tests: a fault may make them endless, and nothing else should come near
export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1

fail() {
  echo "$1" >&2
  exit 2
}

all_names() { basename --suffix=.patch fuzz/mutants/*.patch; }
patch_of() { echo "fuzz/mutants/$1.patch"; }

check() {
  local status=0 name
  for name in $(all_names); do
    patch --dry-run --strip=1 --fuzz=0 --force --silent --input="$(patch_of "$name")" && continue
    echo "$name does not apply" >&2
    status=1
  done
  return $status
}

build() { cmake --build "$folder" --target "$1" >>"$log" 2>&1; }

# first_failure TARGET FILTER: the first test that fails, or where the run broke off; nothing when all pass.
first_failure() {
  local output test status=0
  output=$(timeout "$limit" "$folder/tests/$1" --gtest_fail_fast --gtest_filter="$2" 2>&1) || status=$?
  tail -n 50 <<<"$output" >>"$log"
  [ $status -eq 0 ] && return
  test=$(grep --max-count=1 --only-matching '^\[  FAILED  \] [^ ,]*' <<<"$output" | cut -c 14-) || true
  [ -n "$test" ] || test=$(grep '^\[ RUN      \]' <<<"$output" | tail -n 1 | cut -c 14-) || true
  [ $status -eq 124 ] && test+=', endless'
  echo "${test:-before the first test}"
}

# The fuzzer and the validation read no models of other programs.
is_of_readers() { grep --quiet '^--- a/render/models/' "$(patch_of "$1")"; }

# The suites that can see a fault, those that fail first before the others. The hash of a million answers comes last: that it
# moved says little.
suites_for() {
  if is_of_readers "$1"; then
    echo 'render_tests *ModelIo*:*Gltf*:*Formats*:*Convention*:*Reported*'
  elif grep --quiet '^--- a/culler/cli/' "$(patch_of "$1")"; then
    echo 'cli_tests *'
  elif grep --quiet '^--- a/culler/' "$(patch_of "$1")"; then
    echo 'culler_tests *'
  else
    printf '%s\n' 'kernel_tests -*Answers*' 'oracle_tests *' 'culler_tests *' 'kernel_tests *Answers*'
  fi
}

# caught_by_suite NAME: what caught it, or **missed**.
caught_by_suite() {
  local target filter test start seconds=0
  while read -r target filter; do
    build "$target" || { echo '**does not build**'; return; }
    start=$SECONDS
    test=$(first_failure "$target" "$filter")
    seconds=$((seconds + SECONDS - start))
    [ -n "$test" ] && { echo "\`$test\`, $seconds s"; return; }
  done < <(suites_for "$1")
  echo "**missed**, $seconds s"
}

# caught_by_fuzzer: what caught it, or **missed**.
caught_by_fuzzer() {
  build occlude || { echo '**does not build**'; return; }
  local output status=0 start=$SECONDS family seconds
  output=$(timeout $((fuzz_seconds + limit)) "$folder/occlude" fuzz --seconds "$fuzz_seconds" --stop-at-first --json \
    --findings "$folder/findings.jsonl" \
    2>>"$log") || status=$?
  seconds=$((SECONDS - start))
  tail -n 50 <<<"$output" >>"$log"
  family=$(grep --only-matching '"family" *: *"[^"]*"' <<<"$output" | head -n 1 | cut -d '"' -f 4) || true
  case $status in
    0) echo "**missed**, $seconds s" ;;
    1) echo "\`${family:-?}\`, $seconds s" ;;
    124) echo "endless, $seconds s" ;;
    134 | 136 | 139) echo "broken off by signal $((status - 128)), $seconds s" ;;
    *) echo "**did not run**: exit code $status" ;;
  esac
}

# caught_by_validation: what caught it, or **missed**.
caught_by_validation() {
  build occlude || { echo '**does not build**'; return; }
  [ -f "$folder/city.json" ] || "$folder/occlude" generate city --out "$folder/city.ply" --path "$folder/city.json" >>"$log" 2>&1
  echo "$orbit" >"$folder/orbit.json"
  local start=$SECONDS status=0 error scene
  for scene in tests/data/scenes/*.ply; do  # without a margin, which would make up for some faults
    error=$("$folder/occlude" validate "$scene" --path "$folder/orbit.json" --pixel-margin 0 2>&1 >>"$log") || status=$?
    [ $status -eq 0 ] || break
  done
  [ $status -ne 0 ] ||
    error=$("$folder/occlude" validate "$folder/city.ply" --path "$folder/city.json" --frames 600:1000 2>&1 >>"$log") || status=$?
  echo "$error" >>"$log"
  case $status in
    0) echo "**missed**, $((SECONDS - start)) s" ;;
    1) echo "$(sed -n '1s/[^:]*: //p' <<<"$error" | cut -c 1-90), $((SECONDS - start)) s" ;;
    *) echo "**did not run**: exit code $status" ;;
  esac
}

only=
fuzz_seconds=60
names=()
while [ $# -gt 0 ]; do
  case $1 in
    --check) check; exit ;;
    --only | --seconds) [ $# -ge 2 ] || fail "$1 takes a value" ;;&
    --only) only=$2; shift ;;
    --seconds) fuzz_seconds=$2; shift ;;
    --*) fail "unknown option $1" ;;
    *) [ -f "$(patch_of "$1")" ] || fail "there is no fault $1"; names+=("$1") ;;
  esac
  shift
done
[[ $fuzz_seconds =~ ^[1-9][0-9]*$ ]] || fail "--seconds takes a whole number, not $fuzz_seconds"
[[ $only =~ ^(suite|fuzz|validate)?$ ]] || fail "--only takes suite, fuzz or validate, not $only"
[ ${#names[@]} -gt 0 ] || mapfile -t names < <(all_names)

# configure [NAME]: with this fault, by default with none.
configure() {
  cmake -S . -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release -DOCCLUDE_MUTANT="${1:-}" >"$log" 2>&1 ||
    fail "${1:-no fault}: see $log"
}

mkdir -p "$folder"
# Who cries wolf catches everything.
[ "$only" = suite ] || configure
if [[ $only =~ ^(|fuzz)$ ]]; then
  [[ $(caught_by_fuzzer) == *missed* ]] || fail "without a fault the fuzzer does not end well: see $log"
elif [ "$only" = validate ]; then
  [[ $(caught_by_validation) == *missed* ]] || fail "without a fault the validation does not end well: see $log"
fi
missed=0
for name in "${names[@]}"; do
  configure "$name"
  fuzzer=- suite=- validation=-
  [[ $only =~ ^(|fuzz)$ ]] && ! is_of_readers "$name" && fuzzer=$(caught_by_fuzzer)
  [[ $only =~ ^(|suite)$ ]] && suite=$(caught_by_suite "$name")
  [ "$only" = validate ] && ! is_of_readers "$name" && validation=$(caught_by_validation)
  echo "- \`$name\`: $(head -n 1 "$(patch_of "$name")")"
  echo "  Fuzzer: $fuzzer. Tests: $suite. Validation: $validation."
  [[ $fuzzer$suite$validation == *'**'* ]] && missed=1
done
exit $missed
