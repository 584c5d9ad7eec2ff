#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# occlude inspect: the page it writes, and what it refuses. Usage: inspect_test.sh PATH_OF_OCCLUDE
set -uo pipefail
. "$(dirname "$0")/common.sh"

walk_of_squares
printf '\0asm\1\0\0\0' >module.wasm # as good as the real one until a browser opens the page
inspect=("$occlude" inspect good.ply --module module.wasm)

"${inspect[@]}" >stdout || fail "inspect"
grep -q inspect.html stdout || fail "the page is not named: $(cat stdout)"
[ "$(head -c 15 inspect.html)" = "<!doctype html>" ] || fail "inspect.html is no page"
grep -q "64 polygons" inspect.html || fail "the page does not tell how many polygons there are"
for part in start module model; do
  grep -q "id=\"part-$part\">[A-Za-z0-9+/]" inspect.html || fail "the page has no $part"
done
! grep -q '{{' inspect.html || fail "the page has places that are not filled"
! grep -qE '(src|href)="(https?:|//)' inspect.html || fail "the page names an address"

"${inspect[@]}" --path path.json --out path.html --quiet >stdout || fail "inspect --path"
[ ! -s stdout ] || fail "--quiet prints $(cat stdout)"
! cmp -s inspect.html path.html || fail "the path changes nothing"
"${inspect[@]}" --path path.json --out again.html --quiet || fail "inspect again"
cmp -s path.html again.html || fail "two pages of one model differ"

cp "$occlude" alone
expect_error "render/live/build.sh" ./alone inspect good.ply --out new.html
expect_error "none.wasm" "$occlude" inspect good.ply --module none.wasm --out new.html
expect_error "good.ply: not a WebAssembly module" "$occlude" inspect good.ply --module good.ply --out new.html
expect_error "none.ply" "$occlude" inspect none.ply --module module.wasm --out new.html
expect_error "none.json" "${inspect[@]}" --path none.json --out new.html
expect_error "good.ply" "${inspect[@]}" --out good.ply
expect_error "nowhere" "${inspect[@]}" --out nowhere/new.html
finish
