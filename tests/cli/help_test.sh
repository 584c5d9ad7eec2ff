#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# What all commands have in common: help, limits, and the refusal of words that are not commands.
# Usage: help_test.sh PATH_OF_OCCLUDE
set -uo pipefail
. "$(dirname "$0")/common.sh"
walk_of_squares

expect_error "frobnicate" "$occlude" frobnicate

commands=("" generate "generate city" preprocess walk render inspect compare why classify validate audit bake fuzz bench "bench kernel" "bench culler"
  "bench scene" "bench town" "bench held" "bench rivals" "bench all" help)
for command in "${commands[@]}"; do
  "$occlude" $command --help >stdout || fail "no help for '$command'"
  grep -q . stdout || fail "an empty help for '$command'"
  grep -q 'Example: ' stdout || fail "no example in the help for '$command'"
  "$occlude" help $command | cmp -s stdout - || fail "occlude help $command is not the help of '$command'"
done
for command in walk validate why; do
  "$occlude" $command --help >stdout
  for group in Options Tuning Debugging; do grep -q "^$group:" stdout || fail "no group $group in the help of $command"; done
done

# A typo is answered with the word that is nearest.
expect_error "unknown command 'wlak': did you mean 'walk'?" "$occlude" wlak good.ply --path path.json --out out
expect_error "unknown command 'ctiy': did you mean 'city'?" "$occlude" generate ctiy
expect_error "unknown command 'kernal': did you mean 'kernel'?" "$occlude" help bench kernal
expect_error "unknown option '--pth': did you mean '--path'? (see occlude walk --help)" "$occlude" walk good.ply --pth path.json
expect_error "unknown option '--frmaes': did you mean '--frames'?" "$occlude" walk good.ply --path path.json --out out --frmaes=0:2
expect_error "'more' is one argument too many" "$occlude" walk good.ply more --path path.json --out out
expect_error "unknown command 'frobnicate' (see occlude --help)" "$occlude" frobnicate
expect_error "unknown command 'wlak': did you mean 'walk'? (see occlude --help)" "$occlude" wlak --help
expect_error "unknown command 'kernal': did you mean 'kernel'? (see occlude bench --help)" "$occlude" bench kernal --help
expect_error "unknown command 'frobnicate'" "$occlude" frobnicate --version
expect_error "unknown option '--pth': did you mean '--path'?" "$occlude" walk --pth --help
expect_error "'$(printf 'y%.0s' $(seq 500))' (see" "$occlude" "$(printf 'y%.0s' $(seq 500))"

# --quiet: nothing but errors, warnings and JSON that is asked for.
three_cases
echo '{"cells":[{"min":[0,0,0],"max":[1,1,1]}]}' >cells.json
"$occlude" walk good.ply --path path.json --out walked --size 64x36 --witness witness.jsonl --log log.jsonl >/dev/null || fail "walk"
for command in "generate city --polygons 20000 --out city.ply --path city.json" "preprocess good.ply --out good.pre --region-count 64" \
  "walk good.ply --path path.json --out out --no-render" "compare walked out" "classify cases.jsonl" \
  "render good.ply --path path.json --size 64x36 --frame 0 --out picture.png" \
  "why good.ply --path path.json --size 64x36 --frame 0 --polygon 0" "fuzz --cases 1 --family lattice --findings =" \
  "validate good.ply --path path.json --witness witness.jsonl" "audit good.ply --log log.jsonl" "bake good.ply --cells cells.json --out good.pvs" "bench kernel --boxes 16 --repetitions 1" \
  "bench culler good.ply --path path.json --only sort --repetitions 1 --frames 0:2 --no-render" \
  "bench scene --objects 1000 --streamed 0 --moving 0 --moving-occluders 0 --frames 1 --settling 0" \
  "bench town --houses 10 --walls 5 --cars 2 --repetitions 1 --frames 2" \
  "bench rivals good.ply --path path.json --size 64x36 --repetitions 1 --frames 0:1" \
  "bench all good.ply --path path.json --size 64x36 --frames 0:1 --quick"; do
  read -ra words <<<"$command"
  "$occlude" "${words[@]/#=/}" --quiet >stdout 2>stderr || fail "$command --quiet: $(cat stderr)"
  [ ! -s stdout ] && [ ! -s stderr ] || fail "$command --quiet said: $(cat stdout stderr)"
  [[ $command != classify* ]] || continue
  "$occlude" "${words[@]/#=/}" --quiet --json >stdout || fail "$command --quiet --json"
  [ -s stdout ] || fail "$command --quiet --json said nothing"
done
expect_error "missing.ply" "$occlude" walk missing.ply --path path.json --out out --quiet

# The manual page and the completion have every command, and the options of one.
"$occlude" help --man >occlude.1 || fail "help --man"
for word in 'SH OCCLUDE BENCH KERNEL' 'SH OCCLUDE WALK' '\\fB\\-\\-cover\\-size\\fR' 'SH EXIT STATUS'; do
  grep -q "$word" occlude.1 || fail "the manual page lacks $word"
done
! command -v groff >/dev/null || [ -z "$(groff -man -Tutf8 -ww occlude.1 2>&1 >/dev/null)" ] || fail "groff warns of the manual page"
"$occlude" help --completion bash >completion || fail "help --completion bash"
completed() { # completed WORDS...: what completes the last word
  (
    . ./completion
    COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
    _occlude "$1" "${!#}" "${*: -2:1}"
    echo "${COMPREPLY[*]}"
  )
}
[ "$(completed occlude wa)" = walk ] || fail "completion of a command: $(completed occlude wa)"
[ "$(completed occlude bench k)" = kernel ] || fail "completion of a subcommand: $(completed occlude bench k)"
[ "$(completed occlude walk --cover-s)" = --cover-size ] || fail "completion of an option"
[ "$(completed occlude walk --method '')" = "automatic frusta cover" ] || fail "completion of a value: $(completed occlude walk --method '')"
[ "$(completed occlude walk --path '')" = "" ] || fail "files are completed by the shell"
expect_error "--completion" "$occlude" help --completion fish

# Colours are for terminals, unless NO_COLOR is set.
if ! command -v script >/dev/null; then
  echo "No script: colours are not tried"
elif ! script -qec true /dev/null </dev/null >/dev/null 2>&1; then
  echo "No pseudo-terminal can be made here: colours are not tried"
else
  on_terminal() { env -u NO_COLOR TERM=xterm "$1" script -qec "'$occlude' wlak" /dev/null </dev/null; }
  [[ $(on_terminal A=) == *$'\e[31mocclude:\e[0m unknown'* ]] || fail "no colour on a terminal"
  [[ $(on_terminal NO_COLOR=1) != *$'\e'* ]] || fail "colour with NO_COLOR"
  [[ $(on_terminal TERM=dumb) != *$'\e'* ]] || fail "colour on a terminal that has none"
fi

for command in "classify" "fuzz" "validate" "audit" "bake" "walk" "why" "preprocess" "bench culler" "bench rivals" "bench all"; do
  "$occlude" $command --help >stdout
  grep -q 'Limits: at most 16 MiB .* 4096 MiB' stdout || fail "$command --help does not tell limits"
done

# A line without end is not read to its end, and the message says how much is read.
for command in "classify" "fuzz" "validate good.ply --path path.json --witness" "audit good.ply --log"; do
  expect_error "/dev/zero:1: the line is longer than 16 MiB" timeout 60 "$occlude" $command /dev/zero
done
for command in "walk good.ply --out out --path" "walk good.ply --path path.json --out out --preprocess" \
  "walk --path path.json --out out"; do
  expect_error "/dev/zero: cannot read: it is not a regular file" timeout 60 "$occlude" $command /dev/zero
done

finish
