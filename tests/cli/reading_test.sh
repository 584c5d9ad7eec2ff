#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# How commands read models: units and axes, and what they say of what they leave out.
# Usage: reading_test.sh PATH_OF_OCCLUDE
set -uo pipefail
. "$(dirname "$0")/common.sh"

# A wall of 4 x 2 at x = 2, y up, and one behind it.
wall='v 2 -1 -2\nv 2 -1 2\nv 2 1 2\nv 2 1 -2\nv 5 -1 -2\nv 5 -1 2\nv 5 1 2\nv 5 1 -2\n'
printf "${wall}f 1 2 3 4\nf 5 6 7 8\n" >wall.obj
echo '{"frames":2,"keyframes":[{"eye":[0,0,0],"target":[1,0,0]},{"eye":[0,0,0],"target":[1,0,0]}]}' >path.json

# box_with WORDS OPTION...: expects that the second line about the polygon has its box.
box_with() {
  local words=$1
  shift
  "$occlude" why wall.obj --path path.json --frame 0 --polygon 0 "$@" >stdout 2>stderr || fail "why $*: $(cat stderr)"
  grep -qF "in the box $words" stdout || fail "not in the box $words, with $*: $(cat stdout)"
  [ ! -s stderr ] || fail "why $* warns: $(cat stderr)"
}
box_with "(2, -1, -2) - (2, 1, 2)"
box_with "(2, -2, -1) - (2, 2, 1)" --up y
box_with "(2, -1, -2) - (2, 1, 2)" --up -z
box_with "(1, -0.5, -1) - (1, 0.5, 1)" --unit 0.5
box_with "(2000, -1000, -2000) - (2000, 1000, 2000)" --unit km
box_with "(4, -4, -2) - (4, 4, 2)" --unit 2 --up y

# The same in the other commands. The wall hides what is behind it however it is turned and scaled.
"$occlude" walk wall.obj --path path.json --up y --no-render --out report >/dev/null || fail "walk --up"
"$occlude" validate wall.obj --path path.json --up y --unit 0.5 >/dev/null || fail "validate --up --unit"
"$occlude" preprocess wall.obj --up y --out wall.store >/dev/null || fail "preprocess --up"
"$occlude" why wall.store --path path.json --frame 0 --polygon 0 >stdout || fail "why of a store"
grep -qF "(2, -2, -1) - (2, 2, 1)" stdout || fail "the store is not turned: $(cat stdout)"

expect_error "--up: expected x, y, z, -x, -y, -z, or file" "$occlude" walk wall.obj --path path.json --up north --out new
expect_error "--unit: expected m, km, cm, mm, in, ft, metres, or file" "$occlude" walk wall.obj --path path.json --unit miles --out new
expect_error "wall.obj: does not say which axis is up" "$occlude" walk wall.obj --path path.json --up file --out new
expect_error "wall.obj: does not say what its unit is" "$occlude" walk wall.obj --path path.json --unit file --out new

# What is settled in a store, every command refuses, in the same words.
settled="wall.store is a store, in which this is settled: give it to the \`occlude preprocess\` that makes it"
path=(wall.store --path path.json)
touch log.jsonl && echo '<!-- The model of `occlude inspect` -->' >page.html
for option in "--up y" "--unit m" "--opaque-all"; do
  refused() { expect_error "occlude: ${option% *}: $settled" "$occlude" "$@" $option; }
  refused walk "${path[@]}" --out new
  refused why "${path[@]}" --frame 0 --polygon 0
  refused render "${path[@]}" --out new.png
  refused validate "${path[@]}"
  refused audit wall.store --log log.jsonl
  refused preprocess wall.store --out new.store
  refused bake wall.store --cells grid --out new.pvs
  refused inspect wall.store --page page.html --out new.html
  refused bench culler "${path[@]}" --out new
  refused bench rivals "${path[@]}" --out new
  refused bench held "${path[@]}"
  refused bench all "${path[@]}" --out new
done

# What is left out is said in one line, and nothing else is.
printf "${wall}v nan 0 0\nf 1 2\np 3\nf 1 2 3 4\nf 5 6 7 8\n" >odd.obj
"$occlude" why odd.obj --path path.json --frame 0 --polygon 0 >/dev/null 2>stderr || fail "odd.obj is refused"
[ "$(cat stderr)" = "occlude: warning: odd.obj: 1 face with fewer than three corners is left out; 1 vertex that no face \
uses is left out: its numbers are not legal" ] || fail "odd.obj: $(cat stderr)"
printf "${wall}mtllib none.mtl\nf 1 2 3 4\nf 5 6 7 8\n" >bare.obj
for i in $(seq 100); do echo "mtllib none$i.mtl"; done >>bare.obj
"$occlude" why bare.obj --path path.json --frame 0 --polygon 0 >/dev/null 2>stderr || fail "bare.obj is refused"
grep -q '^occlude: warning: bare.obj: materials are taken for opaque: ' stderr || fail "bare.obj: $(cat stderr)"
[ "$(wc -l <stderr)" -eq 1 ] && [ "$(wc -c <stderr)" -lt 3000 ] || fail "bare.obj says too much: $(cat stderr)"

finish
