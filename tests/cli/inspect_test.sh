#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# occlude inspect: the page it writes, and what it refuses. Usage: inspect_test.sh PATH_OF_OCCLUDE
set -uo pipefail
. "$(dirname "$0")/common.sh"

walk_of_squares
# As good as the real one until a browser opens it.
printf '%s\n' '<!doctype html>' '<!-- The model of `occlude inspect` -->' '<p>the rest</p>' >page.html
inspect=("$occlude" inspect good.ply --page page.html)

"${inspect[@]}" >stdout || fail "inspect"
grep -q inspect.html stdout || fail "the page is not named: $(cat stdout)"
[ "$(head -c 15 inspect.html)" = "<!doctype html>" ] || fail "inspect.html is no page"
grep -q "<p>the rest</p>" inspect.html || fail "the page does not go on"
for part in start model; do
  grep -q "id=\"part-$part\">[A-Za-z0-9+/]" inspect.html || fail "the page has no $part"
done
! grep -q 'The model of' inspect.html || fail "the page has a place that is not filled"

"${inspect[@]}" --path path.json --out path.html --quiet >stdout || fail "inspect --path"
[ ! -s stdout ] || fail "--quiet prints $(cat stdout)"
! cmp -s inspect.html path.html || fail "the path changes nothing"
"${inspect[@]}" --path path.json --out again.html --quiet || fail "inspect again"
cmp -s path.html again.html || fail "two pages of one model differ"

cp "$occlude" alone
expect_error "culler/js/page/build.sh" ./alone inspect good.ply --out new.html
expect_error "none.html" "$occlude" inspect good.ply --page none.html --out new.html
expect_error "good.ply: not a page that" "$occlude" inspect good.ply --page good.ply --out new.html
expect_error "none.ply" "$occlude" inspect none.ply --page page.html --out new.html
expect_error "none.json" "${inspect[@]}" --path none.json --out new.html
expect_error "good.ply" "${inspect[@]}" --out good.ply
expect_error "nowhere" "${inspect[@]}" --out nowhere/new.html
finish
