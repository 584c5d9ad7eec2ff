#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# `occlude preprocess`: files that walks can use, and files that are refused.
# Usage: preprocess_test.sh PATH_OF_OCCLUDE
set -uo pipefail
. "$(dirname "$0")/common.sh"
walk_of_squares

slanting_wall

# A file name that is not UTF-8, in everything that names the file.
cp slanting.ply $'odd\377.ply'
"$occlude" preprocess $'odd\377.ply' --out $'odd\377.pre' >/dev/null || fail "preprocess: a name that is not UTF-8"
"$occlude" walk $'odd\377.ply' --path path.json --out odd --size 64x36 --preprocess $'odd\377.pre' --witness $'odd\377.jsonl' \
  >stdout 2>stderr || fail "walk: a name that is not UTF-8: $(cat stderr)"
grep -qF '"model": "odd\\xff.ply"' odd/summary.json || fail "walk: a name that is not UTF-8: $(cat odd/summary.json)"
grep -qF '"preprocess": "odd\\xff.pre"' odd/summary.json || fail "walk: a name that is not UTF-8: $(cat odd/summary.json)"
grep -qF '<h1>A walk through odd\xff.ply</h1>' odd/report.html || fail "walk: a name that is not UTF-8, in the page"
"$occlude" validate $'odd\377.ply' --path path.json --witness $'odd\377.jsonl' >stdout 2>&1 || fail "odd: $(cat stdout)"

# A preprocess is used, and is refused where it does not fit.
"$occlude" preprocess slanting.ply --out slanting.pre --bounds obb --region-count 64 --threshold 0.01 --samples 2 >stdout ||
  fail "preprocess: $(cat stdout)"
"$occlude" preprocess slanting.ply --out again.pre --bounds obb --region-count 64 --threshold 0.01 --samples 2 --json >/dev/null
for kind in grid tree; do
  for run in one two; do
    "$occlude" preprocess slanting.ply --out $run.pre --leaf 1 --regions $kind --region-count 8 --samples 1 >stdout || fail "--regions $kind"
  done
  cmp -s one.pre two.pre || fail "preprocess --regions $kind: two runs differ"
  "$occlude" walk slanting.ply --path path.json --out $kind --no-render --preprocess one.pre --witness $kind.jsonl >/dev/null ||
    fail "walk --preprocess: $kind"
  grep -q '"regions": "'$kind'"' $kind/summary.json || fail "walk --preprocess: the regions are not those of the file"
  "$occlude" validate slanting.ply --path path.json --witness $kind.jsonl >stdout 2>&1 || fail "$kind: $(cat stdout)"
done
expect_error "--regions" "$occlude" preprocess good.ply --out good.pre --regions octree
expect_error "--region-count" "$occlude" preprocess good.ply --out good.pre --region-count 0
"$occlude" preprocess good.ply --out good.pre --region-count 64 --json >stdout || fail "preprocess --json"
grep -q '"found_to_hide": null' stdout || fail "preprocess samples unasked: $(cat stdout)"
"$occlude" preprocess good.ply --out good.pre --region-count 64 --samples 1 --json >stdout || fail "preprocess --samples --json"
grep -q '"found_to_hide": [1-9]' stdout || fail "preprocess sampled nothing: $(cat stdout)"
cmp -s slanting.pre again.pre || fail "preprocess: two runs differ"
"$occlude" walk slanting.ply --path path.json --out prepared --no-render --preprocess slanting.pre --witness prepared.jsonl \
  >/dev/null || fail "walk --preprocess"
grep -q '"bounds": "obb"' prepared/summary.json || fail "walk --preprocess: the bounds are not those of the file"
grep -q '"preprocess": "slanting.pre"' prepared/summary.json || fail "walk --preprocess: not in the summary"
"$occlude" validate slanting.ply --path path.json --witness prepared.jsonl >stdout 2>&1 || fail "prepared: $(cat stdout)"
"$occlude" validate slanting.ply --path path.json --preprocess slanting.pre >stdout 2>&1 || fail "prepared: $(cat stdout)"
expect_error "slanting.pre: made from another model" "$occlude" walk good.ply --path path.json --out out --preprocess slanting.pre
head -c 300 slanting.pre >short.pre
expect_error "short.pre: the file ends" "$occlude" walk slanting.ply --path path.json --out out --preprocess short.pre
printf '\001' | dd of=one.pre bs=1 seek=19 conv=notrunc status=none
expect_error "one.pre: format version 1, but this program reads version 7: preprocess the model again" \
  "$occlude" walk slanting.ply --path path.json --out out --preprocess one.pre
printf '\001' | dd of=again.pre bs=1 seek=5000 conv=notrunc status=none
expect_error "is damaged: preprocess the model again" "$occlude" walk slanting.ply --path path.json --out out --preprocess again.pre
expect_error "good.ply: not a file of occlude preprocess" "$occlude" walk slanting.ply --path path.json --out out --preprocess good.ply
expect_error "missing.pre" "$occlude" walk slanting.ply --path path.json --out out --preprocess missing.pre
expect_error "--preprocess" "$occlude" walk slanting.ply --path path.json --out out --preprocess slanting.pre --bounds aabb
expect_error "--preprocess" "$occlude" walk slanting.ply --path path.json --out out --preprocess slanting.pre --regions grid
expect_error "named twice" "$occlude" preprocess good.ply --out good.ply

# A store stands for its model, whatever it is called, and settles how it is prepared.
mkdir alone && cp slanting.pre alone/slanting.ply && cp path.json alone || fail "copy"
"$occlude" walk alone/slanting.ply --path path.json --out stored --no-render --witness stored.jsonl >/dev/null || fail "walk STORE"
cmp -s stored.jsonl prepared.jsonl || fail "walk STORE: other witnesses than beside the model"
grep -q '"preprocess": null' stored/summary.json || fail "walk STORE: $(cat stored/summary.json)"
"$occlude" walk slanting.pre --path path.json --out stored --method cover --no-render >/dev/null || fail "walk STORE --method cover"
"$occlude" validate slanting.pre --path path.json --witness stored.jsonl >stdout 2>&1 || fail "validate STORE: $(cat stdout)"
"$occlude" validate slanting.pre --path path.json >stdout 2>&1 || fail "validate STORE: $(cat stdout)"
"$occlude" why slanting.pre --path path.json --frame 0 --polygon 0 >stdout 2>&1 || fail "why STORE: $(cat stdout)"
"$occlude" preprocess slanting.pre --out again.pre --bounds obb --region-count 64 --threshold 0.01 --samples 2 >/dev/null ||
  fail "preprocess STORE"
cmp -s slanting.pre again.pre || fail "preprocess STORE: another store than of the model"
for option in "--leaf 4" "--bounds obb" "--shapes polygon" "--regions tree" "--preprocess slanting.pre"; do
  expect_error "${option%% *}: slanting.pre is a store" "$occlude" walk slanting.pre --path path.json --out out $option
done
"$occlude" preprocess slanting.ply --out other.pre --leaf 1 >/dev/null || fail "--leaf 1"
expect_error "other.pre: its leaves have 1 polygons, those of stored.jsonl have 4: give the model itself" \
  "$occlude" validate other.pre --path path.json --witness stored.jsonl

# Inner boxes: two solids and a wall; the boxes are a model themselves, closed.
ply solids.ply 14 9 '0 0 0\n2 0 0\n0 3 0\n2 3 0\n0 0 4\n2 0 4\n0 3 4\n2 3 4\n9 0 0\n9 1 0\n9 0 1\n8 0 0\n20 0 0\n20 1 0\n4 0 4 6 2\n4 1 3 7 5\n4 0 1 5 4\n4 2 6 7 3\n4 0 2 3 1\n4 4 5 7 6\n3 8 9 10\n3 8 9 11\n3 11 12 13\n'
"$occlude" preprocess solids.ply --inner-boxes boxes.ply >stdout || fail "preprocess --inner-boxes: $(cat stdout)"
grep -q '^boxes.ply: parts 2, closed 1, with inner boxes 1; boxes 1, of which the first of each part fill 100 % of .* s$' stdout ||
  fail "preprocess --inner-boxes says: $(cat stdout)"
[ "$(wc -l <stdout)" -eq 1 ] || fail "preprocess --inner-boxes prepares what was not asked for: $(cat stdout)"
"$occlude" preprocess boxes.ply --inner-boxes again.ply --json >stdout || fail "boxes are no model: $(cat stdout)"
cmp -s boxes.ply again.ply || fail "the inner box of a box is not the box"
grep -q '"polygons": 6,' stdout && grep -q '"closed_parts": 1,' stdout && grep -q '"boxes": 1,' stdout || fail "--json: $(cat stdout)"
grep -q '"nodes"' stdout && fail "--json tells of a file that was not asked for: $(cat stdout)"
"$occlude" preprocess solids.ply --out solids.pre --inner-boxes both.ply --json >stdout || fail "both outputs"
cmp -s boxes.ply both.ply || fail "inner boxes differ beside --out"
grep -q '"nodes"' stdout && grep -q '"bytes"' stdout && grep -q '"inner_boxes"' stdout || fail "--json of both: $(cat stdout)"
"$occlude" preprocess good.ply --inner-boxes none.ply >stdout || fail "a model without closed parts"
grep -q '^none.ply: parts 64, closed 0, with inner boxes 0; boxes 0, ' stdout || fail "no closed parts: $(cat stdout)"
grep -qa '^element face 0$' none.ply || fail "no boxes: $(cat none.ply)"
expect_error "--inner-boxes" "$occlude" preprocess solids.ply
expect_error "--boxes" "$occlude" preprocess solids.ply --inner-boxes out.ply --boxes 0
expect_error "--cells" "$occlude" preprocess solids.ply --inner-boxes out.ply --cells 65
expect_error "--inner-boxes" "$occlude" preprocess solids.ply --out out.pre --cells 8
expect_error "named twice" "$occlude" preprocess solids.ply --inner-boxes solids.ply
expect_error "out.ply" "$occlude" preprocess solids.ply --out out.ply --inner-boxes ./out.ply
expect_error "missing" "$occlude" preprocess solids.ply --inner-boxes missing/out.ply

# Occluders: a floor of 64 squares is two triangles, and a model itself; with boxes, faces of them are among the largest.
ply floor.ply 81 64 ''
awk 'BEGIN { for (y = 0; y < 9; ++y) for (x = 0; x < 9; ++x) print x / 10, y / 10, 0
  for (y = 0; y < 8; ++y) for (x = 0; x < 8; ++x) { a = 9 * y + x; print 4, a, a + 1, a + 10, a + 9 } }' >>floor.ply
"$occlude" preprocess floor.ply --occluders few.ply >stdout || fail "preprocess --occluders: $(cat stdout)"
grep -q '^few.ply: of 128 triangles that are drawn 2 do for all; 2 chosen, with faces of 0 boxes; .* s$' stdout ||
  fail "preprocess --occluders says: $(cat stdout)"
"$occlude" preprocess few.ply --occluders again.ply --json >stdout || fail "occluders are no model: $(cat stdout)"
cmp -s few.ply again.ply || fail "the occluders of occluders are others"
grep -q '"drawn_triangles": 2,' stdout && grep -q '"triangles": 2,' stdout || fail "--json of occluders: $(cat stdout)"
"$occlude" walk few.ply --path fly --out walked --frames 0:2 --no-render >/dev/null 2>stderr || fail "walk OCCLUDERS: $(cat stderr)"
"$occlude" preprocess solids.ply --occluders few.ply --triangles 6 --with-boxes --json >stdout || fail "--with-boxes: $(cat stdout)"
grep -q '"triangles": 6,' stdout && grep -q '"boxes": 1,' stdout || fail "--with-boxes: $(cat stdout)"
"$occlude" preprocess slanting.ply --occluders near.ply --triangles 1 --path path.json >stdout || fail "--path: $(cat stdout)"
grep -q '; 1 chosen' stdout || fail "--path: $(cat stdout)"
# A cube whose faces are bent by a millimetre in their middles is as few triangles as a flat one within a centimetre.
ply bent.ply 14 24 '0 0 0\n4 0 0\n0 4 0\n4 4 0\n0 0 4\n4 0 4\n0 4 4\n4 4 4\n.001 2 2\n4.001 2 2\n2 .001 2\n2 4.001 2\n2 2 .001\n2 2 4.001\n'
for face in '8 0 4 6 2' '9 1 3 7 5' '10 0 1 5 4' '11 2 6 7 3' '12 0 2 3 1' '13 4 5 7 6'; do
  echo "$face" | awk '{ for (i = 2; i <= 5; ++i) print 3, $1, $i, $(i < 5 ? i + 1 : 2) }'
done >>bent.ply
"$occlude" preprocess bent.ply --occluders few.ply --json >stdout || fail "bent: $(cat stdout)"
grep -q '"triangles": 24,' stdout || fail "bent: $(cat stdout)"
"$occlude" preprocess bent.ply --occluders few.ply --inset 0.01 --json >stdout || fail "--inset: $(cat stdout)"
grep -q '"triangles": 12,' stdout || fail "--inset: $(cat stdout)"
expect_error "--inset" "$occlude" preprocess bent.ply --occluders out.ply --inset -1
expect_error "--occluders" "$occlude" preprocess solids.ply --out out.pre --triangles 8
expect_error "--triangles" "$occlude" preprocess solids.ply --occluders out.ply --triangles 0
expect_error "out.ply" "$occlude" preprocess solids.ply --inner-boxes out.ply --occluders ./out.ply
expect_error "missing.json" "$occlude" preprocess solids.ply --occluders out.ply --path missing.json

# When interrupted, it leaves the old file. The lists here take many times as long as usual.
"$occlude" generate city --polygons 20000 --out city.ply --path city.json >/dev/null || fail "generate"
echo old >city.pre
for signal in INT TERM; do
  interrupt $signal "$occlude" preprocess city.ply --region-count 1e6 --threshold 1e-6 --out city.pre
  [ "$(cat city.pre)" = old ] || fail "preprocess: SIG$signal did not spare the file that was there"
done

# The import library does not report that no more files may be open, so the command must.
printf 'solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n' >a.stl
for files in 5 6 7 8; do
  (ulimit -n $files && exec "$occlude" preprocess a.stl --out few.pre) >/dev/null 2>stderr
  code=$?
  [ $code -eq 127 ] && continue # not even its libraries are loaded
  [ $code -eq 0 ] || { [ $code -eq 2 ] && grep -q 'Too many open files' stderr; } || fail "$files files: exit $code: $(cat stderr)"
done

# Copies of a closed part cost no more than to read them: each looked at by itself, they would take minutes of the processor.
ply copies.ply 8 120000 '2 -1 -1\n4 -1 -1\n2 1 -1\n4 1 -1\n2 -1 1\n4 -1 1\n2 1 1\n4 1 1\n'
yes $'4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5' | head -n 120000 >>copies.ply
(ulimit -t 40 && "$occlude" preprocess copies.ply --inner-boxes copies_boxes.ply --cells 64 >stdout 2>stderr) ||
  fail "copies: $(cat stderr)"
grep -q 'parts 1, closed 1' stdout || fail "copies: $(cat stdout)"

finish
