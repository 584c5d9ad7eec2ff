#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The page of a walk in Chromium (page_test.py). Skipped, with exit code 77, where there is no Chromium with its driver, or no
# Python with selenium. Usage: page_test.sh PATH_OF_OCCLUDE
set -uo pipefail
tests=$(realpath "$(dirname "$0")")
. "$tests/../cli/common.sh"
. "$tests/need_browser.sh"

"$occlude" generate city --polygons 20000 --seed 1 --out city.ply --path city.json >/dev/null || fail "generate"
frames=(--path city.json --frames 0:400:20 --size 320x180)
"$occlude" walk city.ply "${frames[@]}" --unions --out frusta >/dev/null || fail "walk"
"$occlude" walk city.ply "${frames[@]}" --method cover --out cover >/dev/null || fail "walk by cover"
echo '{"frames":2,"keyframes":[{"eye":[0,0,90],"target":[9,9,80],"up":[0,0,1]},{"eye":[0,0,90],"target":[9,9,80],"up":[0,1,0]}]}' >tilted.json
"$occlude" walk city.ply --path tilted.json --method cover --size 320x180 --out tilted >/dev/null || fail "walk, tilted"
{ # a pane, and a wall of two polygons, one of them behind the pane
  echo 'mtllib glass.mtl'
  printf 'v %s\n' '2 -1 -1' '2 1 -1' '2 1 1' '2 -1 1' '4 -1 -1' '4 1 -1' '4 1 1' '4 -1 1' '4 -9 -1' '4 -9 1'
  printf '%s\n' 'usemtl glass' 'f 1 2 3 4' 'usemtl other' 'f 5 6 7 8' 'f 9 5 8 10'
} >glass.obj
printf 'newmtl glass\nd 0.5\n' >glass.mtl
echo '{"frames":2,"keyframes":[{"eye":[0,0,0],"target":[4,0,0]},{"eye":[0,0,0],"target":[4,0,0]}]}' >towards.json
"$occlude" walk glass.obj --path towards.json --size 320x180 --out glass >/dev/null || fail "walk to glass"
"$occlude" walk city.ply "${frames[@]}" --method cover --hold 40 --out held >/dev/null || fail "walk that holds"
"$occlude" walk city.ply "${frames[@]}" --out methods >/dev/null || fail "walk by all methods"
room
"$occlude" walk room.ply --frames 0:300:100 --method cover --size 320x180 --out room >/dev/null || fail "walk in a room"
"$occlude" walk city.ply "${frames[@]}" --no-render --out undrawn >/dev/null || fail "walk --no-render"

"$python" -B "$tests/page_test.py" "$occlude" || fail "page_test.py"
finish
