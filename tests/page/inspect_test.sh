#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The page of `occlude inspect` in Chromium (inspect_test.py). Skipped, with exit code 77, where there is no Chromium with its driver,
# no Python with selenium, or the page was not built (culler/js/page/build.sh). Usage: inspect_test.sh PATH_OF_OCCLUDE
set -uo pipefail
tests=$(realpath "$(dirname "$0")")
. "$tests/../cli/common.sh"
. "$tests/need_browser.sh"
. "$tests/need_page.sh"
inspect() { "$occlude" inspect --page "$page" "$@" >/dev/null || fail "inspect $*"; }

"$occlude" generate city --polygons 20000 --seed 1 --out city.ply --path city.json >/dev/null || fail "generate"
inspect city.ply --path city.json --out path.html
inspect city.ply --out free.html

# A quadrilateral, a concave face, which is drawn as triangles, and a see-through triangle, far from 0.
cat >far.obj <<'END'
mtllib far.mtl
v 3000000.25 500000.5 10.1
v 3000004.25 500000.5 10.1
v 3000004.25 500003.5 10.1
v 3000000.25 500003.5 10.1
v 3000002.25 500001.5 10.1
v 3000001.25 500001.25 14.3
f 1 2 3 4
f 1 2 5 4
usemtl glass
f 1 2 6
END
printf 'newmtl glass\nd 0.5\n' >far.mtl
inspect far.obj --out far.html

# A quadrilateral without material, and beside it a concave face and a see-through triangle.
cat >coloured.obj <<'END'
mtllib coloured.mtl
v 0 0 0
v 4 0 0
v 4 4 0
v 0 4 0
v 10 0 0
v 14 0 0
v 12 1 0
v 10 4 0
v 20 0 0
v 24 0 0
v 20 4 0
f 1 2 3 4
usemtl red
f 5 6 7 8
usemtl glass
f 9 10 11
END
printf 'newmtl glass\nd 0.5\nKd 0 0 1\nnewmtl red\nKd 1 0.2 0\n' >coloured.mtl
inspect coloured.obj --out coloured.html

"$python" -B "$tests/inspect_test.py" || fail "inspect_test.py"
"$occlude" walk far.obj --path saved/path.json --no-render --out walked >/dev/null || fail "the path that was recorded"
finish
