#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# `occlude compare`: two walks side by side.
# Usage: compare_test.sh PATH_OF_OCCLUDE
set -uo pipefail
. "$(dirname "$0")/common.sh"
walk_of_squares
sed -i 's/"frames":4/"frames":40/' path.json
walk() { "$occlude" walk good.ply --path path.json --size 64x36 --method frusta "$@" >/dev/null || fail "walk $*"; }
walk --out a
walk --out less --occluders 0
walk --out some --frames 0:40:4 --no-render

compare() { "$occlude" compare "$@" >stdout 2>stderr || fail "compare $*: $(cat stderr)"; }

# With itself: every ratio is 1 and nothing is worse.
compare a a
grep -qE '^mean.rendered_polygons +([0-9.]+) +\1 +1\.000 +1\.000 +1\.000 +1\.000 *$' stdout || fail "a beside itself: $(cat stdout)"
grep -q '^40 frames that both have; worse: nothing$' stdout || fail "a beside itself: $(cat stdout)"
! grep -q 'not the same' stdout || fail "a differs from itself: $(cat stdout)"
compare a/summary.json a/summary.json --fail-if-worse
grep -q 'the noise of times is not known' stdout || fail "summaries alone have no noise: $(cat stdout)"

# What culls less is worse, and the options that differ are named.
compare a less
grep -q '^not the same: options.occluders: 8 and 0$' stdout || fail "options that differ: $(cat stdout)"
grep -qE '^culled_share .* worse$' stdout || fail "culling less is not marked: $(cat stdout)"
grep -qE '^mean.rendered_polygons .* worse$' stdout || fail "drawing more is not marked: $(cat stdout)"
walk --out region --region 0.01
compare a region
grep -q '^not the same: options.region: none and 0.01$' stdout || fail "walks that hold for a region: $(cat stdout)"
compare a region --json --out page.html
grep -q '<p>Not the same: options.region: none and 0.01</p>' page.html || fail "walks that hold for a region: the page"
grep -A1 '"name": "options.region"' stdout | grep -q '"a": "null"' || fail "walks that hold for a region: $(cat stdout)"
sed '/"cover_size": \[/,/\]/d' a/summary.json >older.json
compare older.json a/summary.json
grep -q '^not the same: options.cover_size: none and \[576,360\]$' stdout || fail "a member that is not there: $(cat stdout)"
compare less a
grep -qE '^culled_share .* better$' stdout || fail "culling more is not marked: $(cat stdout)"
"$occlude" compare a less --fail-if-worse >stdout
[ $? -eq 1 ] || fail "--fail-if-worse does not fail"
"$occlude" compare a/summary.json less/summary.json --fail-if-worse --quiet >stdout 2>stderr
[ $? -eq 1 ] && [ ! -s stdout ] && [ ! -s stderr ] || fail "--fail-if-worse --quiet said: $(cat stdout stderr)"

# Only the frames that both have are compared frame by frame; counts over other frames are not judged.
compare a some
grep -q '^10 frames that both have' stdout || fail "other frames: $(cat stdout)"
grep -q '^not the same: frames: 40 and 10$' stdout || fail "other frames: $(cat stdout)"
sed 's/"model": "good.ply"/"model": "<b>.ply"/; s/"false_culls": 0/"false_culls": 3/' a/summary.json >other.json
compare a/summary.json other.json --json --out page.html
grep -q '"name": "model"' stdout || fail "the model that differs: $(cat stdout)"
grep -A1 '"worse": \[' stdout | grep -q '"false_culls"' || fail "false culls: $(cat stdout)"
grep -q '&lt;b&gt;.ply' page.html || fail "the page does not escape names"
! grep -q '<svg' page.html || fail "curves without frames"
compare a less --out page.html
[ "$(grep -o '<svg' page.html | wc -l)" -eq 4 ] || fail "no curves"

# Walks are called by their folders, and shown: a plate of each, of the same frame where both have one.
head -n 20 stdout | grep -q 'A: a  *B: less ' || fail "the table does not name the walks: $(cat stdout)"
grep -q '<h1>a and less</h1>' page.html && grep -q '>B: less</text>' page.html || fail "the page does not name the walks"
[ "$(grep -o '<img src="data:image/png;base64,iVBOR' page.html | wc -l)" -eq 2 ] || fail "no plates"
frames=$(grep -o 'alt="[AB]: [a-z]*: frame [0-9]* from outside"' page.html | sed 's/.*frame \([0-9]*\).*/\1/' | uniq | wc -l)
[ "$frames" -eq 1 ] || fail "plates of two frames: $(grep -o 'alt="[^"]*"' page.html)"
mkdir -p other && cp -r less other/a && compare a other/a && grep -q 'A: a  *B: other/a ' stdout || fail "two folders of one name: $(cat stdout)"
for name in frame_x_outside frame_000001_view frame_000002_outside; do : >less/plates/$name.png; done
compare a less --out page.html
[ "$(grep -o '<img src="data:image/png;base64,iVBOR' page.html | wc -l)" -eq 2 ] || fail "what is no plate is shown"
expect_error "named twice" "$occlude" compare a less --out a/plates/$(ls a/plates | grep outside | head -n 1)

# The view frustum alone took longer: times are not judged.
mkdir busy && cp a/summary.json busy
awk -F, -v OFS=, 'NR == 1 { for (i = 1; i <= NF; ++i) c[$i] = i } NR > 1 { $c["view_frustum_frame_ms"] *= 1.2; $c["cull_ms"] *= 2 } 1' a/frames.csv >busy/frames.csv
compare a busy
grep -q '^warning: Times by the clock cannot be compared, and are not judged: .* took 1.20 times as long in B' stdout || fail "no warning: $(cat stdout)"
grep -q '; worse: nothing$' stdout || fail "times are judged: $(cat stdout)"
sed 's/"busy": [^}]*/"busy": "The machine was <busy>."/' a/summary.json >said.json
compare said.json a --out page.html
grep -q '^warning: said.json: The machine was <busy>.$' stdout || fail "a busy machine is not told: $(cat stdout)"
grep -q 'The machine was &lt;busy&gt;.' page.html || fail "the page does not tell of a busy machine"

# Times: B is slower on every frame by a fifth, or by nothing on most.
mkdir slow odd
for folder in slow odd; do cp a/summary.json $folder; done
slower() { awk -F, -v OFS=, "NR == 1 { for (i = 1; i <= NF; ++i) if (\$i == \"cull_ms\") c = i } NR > 1 { \$c = \$c $1 } 1" a/frames.csv; }
awk -F, -v OFS=, 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == "cull_ms") c = i } NR > 1 { $c = 1 } 1' a/frames.csv >steady && mv steady a/frames.csv
slower '* 1.2' >slow/frames.csv
slower '* (NR % 3 ? 1 : 1.2)' >odd/frames.csv
compare a slow
grep -qE '^mean.cull_ms .* 1.200 +1.200 +1.200 +worse$' stdout || fail "slower is not marked: $(cat stdout)"
compare a odd
grep -qE '^mean.cull_ms .* 1.000 +1.000 +1.200 *$' stdout || fail "noise is marked: $(cat stdout)"

# What is no walk.
echo '{}' >none.json
echo '{"mean":{"rendered_polygons":1,"cull_ms":"x"},"culled_share":0.5}' >words.json
mkdir empty broken unsorted nameless huge endless negative
for folder in broken unsorted nameless huge endless negative; do cp a/summary.json $folder; done
printf 'frame,cull_ms\n0,1\n1,x\n' >broken/frames.csv
printf 'frame,cull_ms\n1,1\n0,1\n' >unsorted/frames.csv
printf 'frame,cull_ms\n0,inf\n' >endless/frames.csv
printf 'frame,cull_ms\n0,-1\n' >negative/frames.csv
printf 'cull_ms\n1\n' >nameless/frames.csv
printf 'frame,cull_ms\n1e300,1\n' >huge/frames.csv
expect_error "none.json: not a summary of \`occlude walk\`: mean.rendered_polygons: missing" "$occlude" compare a none.json
expect_error "words.json: not a summary of \`occlude walk\`: mean.cull_ms: expected a number" "$occlude" compare words.json a
sed 's/"model": "good.ply"/"model": 7/' a/summary.json >number.json
sed 's/"culled_share": [0-9.]*/"culled_share": 1.5/' a/summary.json >much.json
sed 's/"leaf": [0-9]*/"leaf": [1]/' a/summary.json >list.json
expect_error "number.json: not a summary of \`occlude walk\`: model: expected a text" "$occlude" compare a number.json
expect_error "much.json: not a summary of \`occlude walk\`: culled_share: expected a number from 0 to 1" "$occlude" compare much.json a
expect_error "list.json: not a summary of \`occlude walk\`: options.leaf: expected a whole number" "$occlude" compare a list.json
expect_error "missing" "$occlude" compare a missing
expect_error "empty/summary.json" "$occlude" compare a empty
expect_error "broken/frames.csv:3: 'x' is not a number" "$occlude" compare a broken
expect_error "endless/frames.csv:2: 'inf' is not a number" "$occlude" compare a endless
expect_error "negative/frames.csv:2: '-1' is negative" "$occlude" compare a negative
expect_error "unsorted/frames.csv:3: frames do not ascend" "$occlude" compare unsorted a
expect_error "huge/frames.csv:2: the frame is not a whole number" "$occlude" compare a huge
expect_error "nameless/frames.csv:1: no column" "$occlude" compare a nameless
expect_error "named twice" "$occlude" compare a less --out less/summary.json
expect_error "named twice" "$occlude" compare a less --out a/frames.csv
expect_error "B is required" "$occlude" compare a
expect_error "" "$occlude" compare a ""

finish
