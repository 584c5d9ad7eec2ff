#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# `occlude validate`: true witnesses are proved, and false ones are found out.
# Usage: validate_test.sh PATH_OF_OCCLUDE
set -uo pipefail
. "$(dirname "$0")/common.sh"
walk_of_squares

"$occlude" walk good.ply --path path.json --out walked --no-render --method frusta --witness witness.jsonl >/dev/null || fail "walk"
total=$(wc -l <witness.jsonl)

# The witnesses of a walk by cover refer to a tree with smaller leaves, and say so.
"$occlude" generate city --polygons 20000 --seed 5 --out city.ply --path city.json >/dev/null || fail "generate"
"$occlude" walk city.ply --path city.json --frames 0:40:20 --no-render --method cover --out covered --witness cover.jsonl >/dev/null ||
  fail "walk by cover"
proves_all() { # proves_all WHAT FILE [WITNESSES]
  "$occlude" validate city.ply --path city.json --witness "${3:-$2}" >stdout || fail "validate a walk $1"
  grep -qx "$(wc -l <"$2") of $(wc -l <"$2") witnesses proved" stdout || fail "validate a walk $1: $(cat stdout)"
}
proves_all 'by cover' cover.jsonl
proves_all 'by cover, from a pipe' cover.jsonl <(cat cover.jsonl)
"$occlude" walk city.ply --path city.json --frames 0:40:20 --no-render --leaf 7 --bounds obb --out leaves --witness leaves.jsonl \
  >/dev/null || fail "walk with leaves of 7"
proves_all 'with leaves of 7' leaves.jsonl
sed '2s/"leaf":7/"leaf":8/' leaves.jsonl >lie.jsonl
expect_error 'lie.jsonl:2: "leaf"' "$occlude" validate city.ply --path city.json --witness lie.jsonl
sed '1s/"leaf":7/"leaf":-7/' leaves.jsonl >lie.jsonl
expect_error 'lie.jsonl:1: "leaf"' "$occlude" validate city.ply --path city.json --witness lie.jsonl

# What an engine culls, by its matrix and as a scene, is proved alike.
for culled in '--matrix' '--matrix --method frusta' '--scene' '--scene --matrix'; do
  # shellcheck disable=SC2086
  "$occlude" validate city.ply --path city.json --frames 0:40:20 $culled >stdout || fail "validate $culled: $(cat stdout)"
  grep -qE '^([1-9][0-9]+) of \1 witnesses proved' stdout || fail "validate $culled: $(cat stdout)"
  grep -q '^false culls 0, wrong pixels 0 in 2 frames' stdout || fail "validate $culled: $(cat stdout)"
done
expect_error '--scene: a scene is not culled by frusta' "$occlude" validate city.ply --path city.json --scene --method frusta

# False witnesses are found out.
"$occlude" walk good.ply --path back.json --out aside --no-render --method frusta --witness aside.jsonl >/dev/null || fail "walk, looking away"
lie() { # lie WHAT SED_SCRIPT [MODEL WITNESSES PATH]
  local model=${3:-good.ply} witnesses=${4:-witness.jsonl} path=${5:-path.json}
  sed "$2" "$witnesses" >lie.jsonl
  cmp -s "$witnesses" lie.jsonl && fail "the lie about $1 changed nothing"
  "$occlude" validate "$model" --path "$path" --witness lie.jsonl >stdout 2>stderr
  [ $? -eq 1 ] || fail "a lie about $1 was believed"
}
lie "the box" '/shadow/s/"max":\[\([0-9]*\),1,1\]/"max":[\1,99,1]/'
lie "the margin of a shadow" '/shadow/s/"margin":[^}]*}/"margin":1000}/'
lie "the margin of a view" '/"by":"view"/s/"margin":[^}]*}/"margin":1e9}/' good.ply aside.jsonl back.json
lie "the eye" 's/"eye":\[0,0,0\]/"eye":[0,0,0.5]/'
lie "the occluder" 's/"polygon":\[\[2,-1,-1\]/"polygon":[[2,-2,-2]/'
lie "the triangles" '/shadow/s/"triangles":\[[0-9]*,[0-9]*\]/"triangles":[0,128]/'
# The last lie says that the wall before the camera is culled. Exact visibility and item buffers both find it visible.
grep -q "is culled and shows in exact arithmetic: lie.jsonl:[1-9]" stderr || fail "exact visibility believed it: $(cat stdout stderr)"
"$occlude" validate good.ply --path path.json --witness lie.jsonl --exact-up-to 0 --out failures >stdout 2>stderr
[ $? -eq 1 ] || fail "item buffers believed a lie"
grep -q "is culled and shows in 640x360 pixels, moved by -0.375, -0.375: lie.jsonl:[1-9]" stderr || fail "item buffers: $(cat stdout stderr)"
[ "$(wc -l <failures/failures.jsonl)" -gt 0 ] || fail "no failures"
grep -q '^{"frame":0,"polygon":[0-9]*,"shows":"in 640x360 pixels.*","witness":"lie.jsonl:[0-9]*","picture":"failure_000000.png"}$' failures/failures.jsonl || fail "failures: $(cat failures/failures.jsonl)"
[ -s failures/failure_000000.png ] || fail "no picture of the failure"
cp lie.jsonl $'lie\377.jsonl'
"$occlude" validate good.ply --path path.json --witness $'lie\377.jsonl' --out odd_failures >stdout 2>stderr
[ $? -eq 1 ] && grep -qF '"witness":"lie\\xff.jsonl:' odd_failures/failures.jsonl || fail "validate: a name that is not UTF-8: $(cat stderr)"
"$occlude" validate good.ply --path path.json --witness witness.jsonl >stdout || fail "validate, exactly"
grep -q "^false culls 0 in [1-9][0-9]* frames, by exact visibility" stdout || fail "validate said: $(cat stdout)"
"$occlude" validate good.ply --path path.json --witness witness.jsonl --exact-up-to 127 --json >stdout || fail "--exact-up-to"
grep -q '"by": "item_buffers"' stdout || fail "--exact-up-to 127 said: $(cat stdout)"
grep -q '"false_culls": 0' stdout || fail "--exact-up-to 127 said: $(cat stdout)"

# A wall of two triangles is one occluder; its witnesses list both.
sed 's/^element face 64$/element face 65/; s/^4 0 1 2 3$/3 0 1 2\n3 0 2 3/' good.ply >split.ply
"$occlude" walk split.ply --path path.json --out split --no-render --occluders 1 --witness split.jsonl >/dev/null || fail "walk split.ply"
"$occlude" validate split.ply --path path.json --witness split.jsonl >stdout 2>&1 || fail "split: $(cat stdout)"
grep '"parts":\[\[[0-9]*,1\],\[[0-9]*,1\]\]' split.jsonl | head -1 >true.jsonl
[ -s true.jsonl ] || fail "the two halves of a wall are no occluder together"
for lie in 's/"parts":\[\[[0-9]*,1\],/"parts":[/' 's/"parts":[^}]*/"parts":[]/' 's/"parts":\[\[\([0-9]*\),1\]/"parts":[[\1,2]/' \
  's/\("triangles":\)\[[0-9]*,[0-9]*\]/\1[0,130]/' 's/,"parts":[^}]*//' 's/"parts":\[\[[0-9]*,1\]/"parts":[[999999,1]/'; do
  sed "$lie" true.jsonl >lie.jsonl
  cmp -s true.jsonl lie.jsonl && fail "no lie: $lie"
  "$occlude" validate split.ply --path path.json --witness lie.jsonl >/dev/null 2>stderr
  [ $? -eq 1 ] || fail "validate believed $lie: $(cat stderr)"
done
for nonsense in 'null' '[[0]]' '{}' '[["a","b"]]'; do
  sed "s/\"parts\":[^}]*/\"parts\":$nonsense/" true.jsonl >lie.jsonl
  expect_error 'lie.jsonl:1: "parts"' "$occlude" validate split.ply --path path.json --witness lie.jsonl
done

# Covers that name the wall before the squares by its number in the file, alone and with one of the squares.
for polygons in 0 5,0; do
  sed -n '/"by":"shadow"/{s/"by":"shadow".*/"by":"cover","polygons":['$polygons']}/;s/,"margin":[^,}]*//;p}' witness.jsonl >cover.jsonl
  "$occlude" validate good.ply --path path.json --witness cover.jsonl >stdout 2>&1 || fail "covers: $(cat stdout)"
  grep -q "^$(wc -l <cover.jsonl) of $(wc -l <cover.jsonl) witnesses proved" stdout || fail "covers: $(cat stdout)"
done
sed 's/\[5,0\]/[63]/' cover.jsonl >lie.jsonl
"$occlude" validate good.ply --path path.json --witness lie.jsonl >stdout 2>stderr
[ $? -eq 1 ] && grep -q 'the polygons do not hide the box' stderr || fail "validate believed a cover: $(cat stdout stderr)"

# Witnesses whose occluder is a block instead of its front, and whose squares are in an oriented box.
vertices='2 -1 -1\n2 1 -1\n2 1 1\n2 -1 1\n3 -1 -1\n3 1 -1\n3 1 1\n3 -1 1\n'
faces='4 0 1 2 3\n4 4 5 6 7\n4 0 1 5 4\n4 3 2 6 7\n4 0 3 7 4\n4 1 2 6 5\n'
for i in $(seq 2 59); do
  vertices+="$((2 + i)) -1 -1\n$((2 + i)) 1 -1\n$((2 + i)) 1 1\n$((2 + i)) -1 1\n"
  faces+="4 $((4 * i)) $((4 * i + 1)) $((4 * i + 2)) $((4 * i + 3))\n"
done
ply block.ply 240 64 "$vertices$faces"
block='"vertices":[[2,-1,-1],[2,1,-1],[2,1,1],[2,-1,1],[3,-1,-1],[3,1,-1],[3,1,1],[3,-1,1]],"faces":[[0,1,2,3],[4,5,6,7],[0,1,5,4],[3,2,6,7],[0,3,7,4],[1,2,6,5]]'
"$occlude" walk block.ply --path path.json --out blocked --no-render --method frusta --witness front.jsonl >stdout || fail "walk with a block"
sed 's/"polygon":\[\[2,-1,-1\],\[2,1,-1\],\[2,1,1\],\[2,-1,1\]\]/'"$block"'/
  s/"min":\[47,-1,-1\],"max":\[61,1,1\]/"center":[54,0,0],"half_edges":[[7,0,0],[0,1,1],[0,1,-1]]/
  s/,"margin":[^}]*}/}/' front.jsonl >block.jsonl
grep -q '"vertices"' block.jsonl || fail "no witness by a block"
grep -q '"half_edges"' block.jsonl || fail "no witness of an oriented box"
"$occlude" validate block.ply --path path.json --witness block.jsonl >stdout 2>&1 || fail "block: $(cat stdout)"
lie "an oriented box" 's/\[0,1,1\],\[0,1,-1\]\]/[0,1,1],[0,1,-0.5]]/' block.ply block.jsonl
lie "the size of an oriented box" 's/\[7,0,0\]/[7.25,0,40]/' block.ply block.jsonl
lie "the vertices of a block" 's/\[3,1,1\],\[3,-1,1\]\]/[3.5,1,1],[3,-1,1]]/' block.ply block.jsonl
lie "the faces of a block" 's/,\[1,2,6,5\]\]/]/' block.ply block.jsonl
lie "what is behind a block" 's/"triangles":\[[0-9]*,[0-9]*\]/"triangles":[0,128]/' block.ply block.jsonl
sed 's/\[1,2,6,5\]/[1,2,6,8]/' block.jsonl >line.jsonl
expect_error "line.jsonl:1" "$occlude" validate block.ply --path path.json --witness line.jsonl

# Two walls at a right angle hide together what neither hides alone. In the second model one of them is bent, so that its
# near plane is given in numbers.
walls='4 -4 -4\n2 0 -4\n2 0 4\n4 -4 4\n2 0 -4\n4 4 -4\n4 4 4\n2 0 4\n'
vertices=$walls faces='4 0 1 2 3\n4 4 5 6 7\n'
for i in $(seq 2 63); do
  vertices+="$((6 + i)) -1 -1\n$((6 + i)) 1 -1\n$((6 + i)) 1 1\n$((6 + i)) -1 1\n"
  faces+="4 $((4 * i)) $((4 * i + 1)) $((4 * i + 2)) $((4 * i + 3))\n"
done
ply corner.ply 256 64 "$vertices$faces"
ply bent.ply 256 64 "${vertices/2 0 4\\n4 -4 4/2 0 4\\n4 -4.5 4}$faces"
pairs() { grep -c '},{"polygon"' "$1"; }
for model in corner bent; do
  "$occlude" walk $model.ply --path path.json --out alone --no-render --occluders 2 --witness alone.jsonl >/dev/null || fail "walk $model.ply"
  [ "$(pairs alone.jsonl)" -eq 0 ] || fail "$model: unions that nobody asked for"
  "$occlude" walk $model.ply --path path.json --out together --no-render --occluders 2 --unions --witness $model.jsonl \
    >/dev/null || fail "walk $model.ply --unions"
  [ "$(pairs $model.jsonl)" -eq 16 ] || fail "$model: no cull by a union"
  "$occlude" validate $model.ply --path path.json --witness $model.jsonl >stdout 2>&1 || fail "$model: $(cat stdout)"
  total=$(wc -l <$model.jsonl)
  grep -q "^$total of $total witnesses proved" stdout || fail "$model: validate said: $(cat stdout)"
  "$occlude" validate $model.ply --path path.json --occluders 2 --unions >again || fail "validate --unions"
  head -n 4 again | cmp -s stdout - || fail "$model: culling anew proves something else: $(cat again)"
done
grep -q '"unions": true' together/summary.json || fail "walk --unions: not in the summary"
grep -q 'unions of pairs' together/report.html || fail "walk --unions: not in the report"
lie "the margin of two" 's/"margin":0}/"margin":0.5}/' corner.ply corner.jsonl
lie "the first of two" 's/"occluders":\[{[^}]*},/"occluders":[/' corner.ply corner.jsonl
lie "the second of two" 's/},{"polygon":[^}]*}\]/}]/' corner.ply corner.jsonl
lie "the wall of two that it is" 's/"occluders":\[{\([^}]*\)},{[^}]*}/"occluders":[{\1},{\1}/' corner.ply corner.jsonl
lie "a wall that is not of the model" 's/\[4,4,4\]/[4,4,5]/' corner.ply corner.jsonl
lie "what is hidden" 's/"triangles":\[[0-9]*,[0-9]*\]/"triangles":[0,128]/' corner.ply corner.jsonl
lie "the near plane" 's/"point":\[[^]]*\]/"point":[1,0,0]/' bent.ply bent.jsonl
head -1 corner.jsonl | sed 's/"max":\[28,1,1\]/"max":[28,1,31]/' >edge.jsonl
"$occlude" validate corner.ply --path path.json --witness edge.jsonl >stdout 2>&1 || fail "edge: $(cat stdout)"
lie "an ulp beyond both shadows" 's/1,31\]/1,31.000000000000004]/' corner.ply edge.jsonl
head -1 corner.jsonl | sed 's/"occluders":\[\({[^}]*}\),/"occluders":[\1,\1,/' >line.jsonl
expect_error 'line.jsonl:1: "occluders"' "$occlude" validate corner.ply --path path.json --witness line.jsonl
expect_error "--witness" "$occlude" validate corner.ply --path path.json --witness corner.jsonl --unions

# Options that would do nothing are refused, and so are files that are not witnesses or folders.
expect_error "--witness" "$occlude" validate good.ply --path path.json --witness witness.jsonl --occluders 3
expect_error "good.ply:1" "$occlude" validate good.ply --path path.json --witness good.ply
: >file
expect_error "file" "$occlude" validate good.ply --path path.json --out file

# Copies of a wall are drawn once: each by itself, they would take minutes of the processor.
ply copies.ply 4 500000 '2 -9 -9\n2 9 -9\n2 9 9\n2 -9 9\n'
yes '4 0 1 2 3' | head -n 500000 >>copies.ply
(ulimit -t 60 && "$occlude" validate copies.ply --path path.json --exact-up-to 0 >stdout 2>stderr) || fail "copies: $(cat stderr)"
grep -q "^false culls 0" stdout || fail "copies: $(cat stdout)"

finish
