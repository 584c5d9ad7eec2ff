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
"$occlude" walk city.ply "${frames[@]}" --no-render --out undrawn >/dev/null || fail "walk --no-render"

"$python" -B "$tests/page_test.py" "$occlude" || fail "page_test.py"
finish
