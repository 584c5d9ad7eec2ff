#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The command as its users meet it: what good input writes, what bad input says.
# Usage: commands_test.sh PATH_OF_OCCLUDE [FOLDER_OF_REAL_MODELS]
set -uo pipefail
. "$(dirname "$0")/common.sh"

# A wall at x = 2, and 63 more squares of its size behind it.
vertices= faces=
for i in $(seq 0 63); do
  vertices+="$((2 + i)) -1 -1\n$((2 + i)) 1 -1\n$((2 + i)) 1 1\n$((2 + i)) -1 1\n"
  faces+="4 $((4 * i)) $((4 * i + 1)) $((4 * i + 2)) $((4 * i + 3))\n"
done
ply good.ply 256 64 "$vertices$faces"
split_vertices=$vertices split_faces=${faces#*\\n}
path='{"frames":4,"keyframes":[{"eye":[0,0,0],"target":[1,0,0]},{"eye":[0.5,0,0],"target":[1.5,0,0]}]}'
echo "$path" >path.json
sed 's/"target":\[1,0,0\]/"target":[-1,0,0]/; s/"target":\[1.5,0,0\]/"target":[-0.5,0,0]/' path.json >back.json

# Models.
printf 'this is no model\n' >text.ply
ply nan.ply 3 1 'nan 0 0\n1 0 0\n0 1 0\n3 0 1 2\n'
ply index.ply 3 1 '0 0 0\n1 0 0\n0 1 0\n3 0 1 9\n'
ply empty.ply 0 0 ''
ply one.ply 3 1 '2 0 0\n2 1 0\n2 0 1\n3 0 1 2\n'
head -c $(($(wc -c <good.ply) - 20)) good.ply >truncated.ply
: >nothing.ply
for model in missing.ply text.ply truncated.ply nan.ply index.ply empty.ply one.ply nothing.ply; do
  expect_error "$model" "$occlude" walk "$model" --path path.json --out out
done
expect_error "truncated" "$occlude" walk truncated.ply --path path.json --out out
expect_error "out of range" "$occlude" walk index.ply --path path.json --out out
expect_error "not finite" "$occlude" walk nan.ply --path path.json --out out

# Paths.
echo '{"frames":4,"keyframes":[{"eye":[0,0,0],"target":[1,0,0]}]}' >single.json
echo '{"frames":4,"keyframes":[' >broken.json
echo '{"frames":4,"keyframes":[{"eye":[0,0,"x"],"target":[1,0,0]},{"eye":[0,0,0],"target":[1,0,0]}]}' >words.json
for file in single.json broken.json words.json missing.json; do
  expect_error "$file" "$occlude" walk good.ply --path "$file" --out out
done

# Folders and options.
touch file
expect_error "file" "$occlude" walk good.ply --path path.json --out file/out
expect_error "no frame" "$occlude" walk good.ply --path path.json --out out --frames 9:10
expect_error "--frames" "$occlude" walk good.ply --path path.json --out out --frames 1
expect_error "--size" "$occlude" walk good.ply --path path.json --out out --size 0x10
expect_error "--arithmetic" "$occlude" walk good.ply --path path.json --out out --arithmetic float
expect_error "--polygons" "$occlude" generate city --polygons 5 --out city.ply --path city.json
expect_error "missing/city.ply" "$occlude" generate city --polygons 20000 --out missing/city.ply --path city.json
if [ "$(id -u)" -ne 0 ]; then
  mkdir locked && chmod a-w locked
  expect_error "locked" "$occlude" walk good.ply --path path.json --out locked/out
fi

# A walk.
"$occlude" walk good.ply --path path.json --out report --size 64x36 --witness witness.jsonl >stdout || fail "walk"
grep -q 'false culls 0, wrong pixels 0' stdout || fail "walk said: $(cat stdout)"
for file in summary.json frames.csv report.html plates; do
  [ -e "report/$file" ] || fail "no $file"
done
[ "$(wc -l <report/frames.csv)" -eq 5 ] || fail "frames.csv has not a line a frame"
grep -q '"by":"shadow"' witness.jsonl || fail "no witness of a shadow cull"
"$occlude" validate good.ply --path path.json --witness witness.jsonl >stdout || fail "validate"
total=$(wc -l <witness.jsonl)
grep -q "^$total of $total witnesses proved" stdout || fail "validate said: $(cat stdout)"
"$occlude" validate good.ply --path path.json --size 64x36 >again || fail "validate without file"
# Culling anew proves the same, and tells as well why hidden polygons were drawn.
head -n 4 again | cmp -s stdout - || fail "culling anew proves something else: $(cat again)"
grep -q "^without a pixel and drawn in 4 of the frames" again || fail "no reasons: $(cat again)"

# Squares that are a hair's breadth before the near plane in a model so deep that single precision draws them.
vertices= faces= i=0
for y in $(seq 0 7); do
  for z in $(seq 0 7); do
    corner() { echo "0.099999 $((($1 - 4) * 125))e-4 $((($2 - 4) * 125))e-4\\n"; }
    vertices+="$(corner $y $z)$(corner $((y + 1)) $z)$(corner $((y + 1)) $((z + 1)))$(corner $y $((z + 1)))"
    faces+="4 $i $((i + 1)) $((i + 2)) $((i + 3))\n"
    i=$((i + 4))
  done
done
vertices+="5 -9 -9\n5 9 -9\n5 9 9\n5 -9 9\n-1000 -1 -1\n-1000 1 -1\n-1000 1 1\n-1000 -1 1\n"
faces+="4 $i $((i + 1)) $((i + 2)) $((i + 3))\n4 $((i + 4)) $((i + 5)) $((i + 6)) $((i + 7))\n"
ply deep.ply $((i + 8)) 66 "$vertices$faces"
echo '{"frames":2,"near":0.1,"keyframes":[{"eye":[0,0,0],"target":[1,0,0]},{"eye":[0,0,0],"target":[2,0,0]}]}' >still.json
"$occlude" walk deep.ply --path still.json --out deep --size 64x64 >stdout || fail "walk deep.ply"
grep -q 'false culls 0, wrong pixels 0' stdout || fail "walk deep.ply said: $(cat stdout)"

# A wall, and behind it a slanting one of 64 tiles, in a tree of oriented boxes.
vertices='2 -1 -1\n2 1 -1\n2 1 1\n2 -1 1\n' faces='4 0 1 2 3\n' i=4
for along in $(seq 0 7); do
  for up in $(seq 0 7); do
    vertices+="$((4 + along)) $((along - 4)) $((up - 4))\n$((5 + along)) $((along - 3)) $((up - 4))\n"
    vertices+="$((5 + along)) $((along - 3)) $((up - 3))\n$((4 + along)) $((along - 4)) $((up - 3))\n"
    faces+="4 $i $((i + 1)) $((i + 2)) $((i + 3))\n"
    i=$((i + 4))
  done
done
ply slanting.ply 260 65 "$vertices$faces"
"$occlude" walk slanting.ply --path path.json --out oriented --no-render --bounds obb --witness oriented.jsonl >/dev/null ||
  fail "walk --bounds obb"
grep -q '"box":{"center":' oriented.jsonl || fail "walk --bounds obb: no oriented box was culled"
grep -q '"bounds": "obb"' oriented/summary.json || fail "walk --bounds obb: not in the summary"
"$occlude" validate slanting.ply --path path.json --witness oriented.jsonl >stdout 2>&1 || fail "oriented: $(cat stdout)"
"$occlude" validate slanting.ply --path path.json --bounds obb >stdout 2>&1 || fail "oriented: $(cat stdout)"
grep -q 'tree of OBBs' oriented/report.html || fail "walk --bounds obb: not in the report"

# Files of any name, in all that names them.
cp slanting.ply $'odd\377.ply'
"$occlude" preprocess $'odd\377.ply' --out $'odd\377.pre' >/dev/null || fail "preprocess: a name that is not UTF-8"
"$occlude" walk $'odd\377.ply' --path path.json --out odd --size 64x36 --preprocess $'odd\377.pre' --witness $'odd\377.jsonl' \
  >stdout 2>stderr || fail "walk: a name that is not UTF-8: $(cat stderr)"
grep -qF '"model": "odd\\xff.ply"' odd/summary.json || fail "walk: a name that is not UTF-8: $(cat odd/summary.json)"
grep -qF '"preprocess": "odd\\xff.pre"' odd/summary.json || fail "walk: a name that is not UTF-8: $(cat odd/summary.json)"
grep -qF '<h1>A walk through odd\xff.ply</h1>' odd/report.html || fail "walk: a name that is not UTF-8, in the page"
"$occlude" validate $'odd\377.ply' --path path.json --witness $'odd\377.jsonl' >stdout 2>&1 || fail "odd: $(cat stdout)"

# A preprocess, used and refused.
"$occlude" preprocess slanting.ply --out slanting.pre --bounds obb --regions 64 --threshold 0.01 --samples 2 >stdout ||
  fail "preprocess: $(cat stdout)"
"$occlude" preprocess slanting.ply --out again.pre --bounds obb --regions 64 --threshold 0.01 --samples 2 --json >/dev/null
"$occlude" preprocess good.ply --out good.pre --regions 64 --json >stdout || fail "preprocess --json"
grep -q '"found_to_hide": null' stdout || fail "preprocess samples unasked: $(cat stdout)"
"$occlude" preprocess good.ply --out good.pre --regions 64 --samples 1 --json >stdout || fail "preprocess --samples --json"
grep -q '"found_to_hide": [1-9]' stdout || fail "preprocess sampled nothing: $(cat stdout)"
cmp -s slanting.pre again.pre || fail "preprocess: two runs differ"
"$occlude" walk slanting.ply --path path.json --out prepared --no-render --preprocess slanting.pre --witness prepared.jsonl \
  >/dev/null || fail "walk --preprocess"
grep -q '"bounds": "obb"' prepared/summary.json || fail "walk --preprocess: the bounds are not those of the file"
grep -q '"preprocess": "slanting.pre"' prepared/summary.json || fail "walk --preprocess: not in the summary"
"$occlude" validate slanting.ply --path path.json --witness prepared.jsonl >stdout 2>&1 || fail "prepared: $(cat stdout)"
"$occlude" validate slanting.ply --path path.json --preprocess slanting.pre >stdout 2>&1 || fail "prepared: $(cat stdout)"
expect_error "slanting.pre: made of another model" "$occlude" walk good.ply --path path.json --out out --preprocess slanting.pre
head -c 300 slanting.pre >short.pre
expect_error "short.pre: the file ends" "$occlude" walk slanting.ply --path path.json --out out --preprocess short.pre
expect_error "good.ply: no file" "$occlude" walk slanting.ply --path path.json --out out --preprocess good.ply
expect_error "missing.pre" "$occlude" walk slanting.ply --path path.json --out out --preprocess missing.pre
expect_error "--preprocess" "$occlude" walk slanting.ply --path path.json --out out --preprocess slanting.pre --bounds aabb
expect_error "named twice" "$occlude" preprocess good.ply --out good.ply
expect_error "--weight-coherence" "$occlude" walk good.ply --path path.json --out out --weight-coherence -1
for options in "--shapes polygon" "--probes 0" "--solid-angle exact --weight-coherence 0" "--weight-solid-angle 0"; do
  "$occlude" walk good.ply --path path.json --out weighed --no-render $options --witness weighed.jsonl >/dev/null ||
    fail "walk $options"
  "$occlude" validate good.ply --path path.json --witness weighed.jsonl >stdout 2>&1 || fail "walk $options: $(cat stdout)"
done

# What several polygons hide together.
case='{"id":"c","eye":[0,0,0],"occluder":{"cover":[[[2,-1,-1],[2,0,-1],[2,0,1],[2,-1,1]],[[2,0,-1],[2,1,-1],[2,1,1],[2,0,1]]]},"box":{"min":[9,-1,-1],"max":[9,1,1]}'
echo "$case,\"expect\":\"inside\"}" | "$occlude" classify >stdout || fail "classify a cover: $(cat stdout)"
[ "$(cat stdout)" = '{"id":"c","certified":"inside","stage":"exact","oracle":"inside"}' ] || fail "a cover is $(cat stdout)"
echo "$case,\"expect\":\"partial\"}" | "$occlude" classify >stdout && fail "classify took what is not expected"
echo "${case/\"cover\":/\"polygon\":[],\"cover\":}}" >line.jsonl
expect_error 'line.jsonl:1: both "cover" and "polygon"' "$occlude" classify line.jsonl
echo "${case/\"cover\":[[/\"cover\":[}}" >line.jsonl
expect_error 'line.jsonl:1:' "$occlude" classify line.jsonl
# The wall before the squares by its number in the file, alone and with one of the squares.
for polygons in 0 5,0; do
  sed -n '/"by":"shadow"/{s/"by":"shadow".*/"by":"cover","polygons":['$polygons']}/;s/,"margin":[^,}]*//;p}' witness.jsonl >cover.jsonl
  "$occlude" validate good.ply --path path.json --witness cover.jsonl >stdout 2>&1 || fail "covers: $(cat stdout)"
  grep -q "^$(wc -l <cover.jsonl) of $(wc -l <cover.jsonl) witnesses proved" stdout || fail "covers: $(cat stdout)"
done
sed 's/\[5,0\]/[63]/' cover.jsonl >lie.jsonl
"$occlude" validate good.ply --path path.json --witness lie.jsonl >stdout 2>stderr
[ $? -eq 1 ] && grep -q 'the polygons do not hide the box' stderr || fail "validate believed a cover: $(cat stdout stderr)"

# A wall of two triangles is one occluder; its witnesses list both.
ply split.ply 256 65 "${split_vertices}3 0 1 2\\n3 0 2 3\\n$split_faces"
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

# Parallel projection, without a far plane.
echo '{"frames":5,"projection":"orthographic","height":3,"keyframes":[{"eye":[0,0.1,0.2],"target":[3,1,0.5]},{"eye":[0.5,0,0],"target":[7,-0.4,0.1]}]}' >parallel.json
"$occlude" walk good.ply --path parallel.json --out parallel --size 64x36 --witness parallel.jsonl >stdout || fail "parallel walk: $(cat stdout)"
grep -q '"direction"' parallel.jsonl || fail "no direction in parallel witnesses"
"$occlude" validate good.ply --path parallel.json --witness parallel.jsonl --size 64x36 >stdout 2>&1 || fail "parallel: $(cat stdout)"

# Files that are in each other's way, and options that would do nothing.
expect_error "named twice" "$occlude" walk good.ply --path path.json --out other --witness good.ply
expect_error "named twice" "$occlude" walk good.ply --path path.json --out other --witness other/summary.json
expect_error "named twice" "$occlude" generate city --polygons 20000 --out same --path same
expect_error "nodir/h.json" "$occlude" generate city --polygons 20000 --out h.ply --path nodir/h.json
expect_error "--seed" "$occlude" generate city --polygons 20000 --seed -1 --out h.ply --path h.json
expect_error "--witness" "$occlude" validate good.ply --path path.json --witness witness.jsonl --occluders 3
expect_error "frobnicate" "$occlude" frobnicate
mkdir -p inway/summary.json
expect_error "inway/summary.json" "$occlude" walk good.ply --path path.json --out inway
expect_error "good.ply:1" "$occlude" validate good.ply --path path.json --witness good.ply
"$occlude" walk good.ply --path path.json --out report --frames 0:2 --size 64x36 >/dev/null || fail "second walk"
[ "$(ls report/plates | wc -l)" -eq 4 ] || fail "plates of an earlier walk are left"

# Witnesses that lie are found out.
"$occlude" walk good.ply --path back.json --out aside --no-render --witness aside.jsonl >/dev/null || fail "walk, looking away"
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
# Of what is said to be culled then, the wall that the camera looks at shows: exactly, and in item buffers.
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

# Why a polygon was drawn or culled. The wall at 2 hides what is behind it; in the leaf of the wall itself all is drawn.
why() { "$occlude" why good.ply --path path.json --size 64x36 "$@"; }
why --frame 3 --polygon 40 >stdout || fail "why"
grep -q '^frame 3, polygon 40: culled: in shadow$' stdout || fail "why said: $(cat stdout)"
grep -q '^  by occluder 0: polygon 0; it hides [1-9][0-9]* polygons in this frame$' stdout || fail "why said: $(cat stdout)"
grep -q '^  the box is in its shadow by [0-9.]*, where it is nearest to the side through its edge (2, ' stdout || fail "why said: $(cat stdout)"
why --frame 0 --polygon 1 >stdout || fail "why"
grep -q '^frame 0, polygon 1: drawn$' stdout || fail "why said: $(cat stdout)"
grep -q "it was not culled: its own box is hidden" stdout || fail "why said: $(cat stdout)"
why --frame 0 --pixel 32,18 --json --out why >stdout || fail "why"
grep -q '"polygon": 0,' stdout || fail "why --pixel said: $(cat stdout)"
grep -q '"fate": "drawn"' stdout || fail "why --pixel said: $(cat stdout)"
cmp -s stdout why/why.json || fail "why.json is not what was printed"
for plate in view outside; do [ -s why/$plate.png ] || fail "why: no $plate.png"; done

# The same walk by cover: what many polygons hide together, proved by the numbers of the polygons.
cover="--method cover --cover-size 128x96"
"$occlude" walk good.ply --path path.json --out covered --size 64x36 $cover --witness cover.jsonl >stdout || fail "walk by cover"
grep -q '"method": "cover"' covered/summary.json || fail "the summary names no method"
grep -q '"false_culls": 0' covered/summary.json || fail "by cover: $(cat stdout)"
grep -q '"by":"cover","polygons":\[[0-9]' cover.jsonl || fail "no witness by cover"
"$occlude" validate good.ply --path path.json --witness cover.jsonl >stdout || fail "validate by cover: $(cat stdout)"
covers=$(wc -l <cover.jsonl)
grep -q "^$covers of $covers witnesses proved" stdout || fail "validate by cover said: $(cat stdout)"
sed 's/"polygons":\[[0-9,]*\]/"polygons":[63]/' cover.jsonl >forged.jsonl
"$occlude" validate good.ply --path path.json --witness forged.jsonl >stdout 2>&1 && fail "a polygon that hides nothing was taken"
"$occlude" validate good.ply --path path.json --size 64x36 $cover >stdout || fail "validate --method cover: $(cat stdout)"
why --frame 3 --polygon 63 $cover >stdout || fail "why by cover"
grep -q '^  by [1-9][0-9]* polygons together: ' stdout || fail "why by cover said: $(cat stdout)"
why --frame 0 --polygon 1 $cover --json >stdout || fail "why by cover --json"
grep -q '"fate": "drawn"' stdout || fail "why by cover of what is drawn"
expect_error "--cover-size" "$occlude" walk good.ply --path path.json --out out --method cover --cover-size 63x64
expect_error "--method" "$occlude" walk good.ply --path path.json --out out --method raster
expect_error "--leaf" "$occlude" walk good.ply --path path.json --out out --leaf 0
expect_error "--frame" why --frame -1 --polygon 0
: >file
expect_error "file" why --frame 0 --polygon 0 --out file
expect_error "file" "$occlude" validate good.ply --path path.json --out file
expect_error "--pixel-margin" "$occlude" walk good.ply --path path.json --out out --pixel-margin nan
expect_error "no frame 9" why --frame 9 --polygon 0
expect_error "no polygon 64" why --frame 0 --polygon 64
expect_error "no polygon shows there" why --frame 0 --pixel 0,0
expect_error "--pixel" why --frame 0 --pixel 64,0
expect_error "--pixel" why --frame 0 --pixel 3
expect_error "[--polygon,--pixel]" why --frame 0
expect_error "[--polygon,--pixel]" why --frame 0 --polygon 0 --pixel 3,3
"$occlude" why good.ply --path back.json --frame 0 --polygon 40 >stdout || fail "why, looking away"
grep -q '^frame 0, polygon 40: culled: out of view$' stdout || fail "why said: $(cat stdout)"
grep -q '^  by the left plane of the view: the box is beyond it by' stdout || fail "why said: $(cat stdout)"

# Shards add up.
parts=0
for i in 1 2 3; do
  "$occlude" validate good.ply --path path.json --witness witness.jsonl --shard $i/3 >stdout || fail "shard $i"
  parts=$((parts + $(sed -n 's/ of .* witnesses proved//p' stdout)))
done
[ "$parts" -eq "$total" ] || fail "shards proved $parts of $total"
"$occlude" validate good.ply --path path.json --size 64x36 --shard 1/3 >again || fail "a shard, culled anew"
"$occlude" validate good.ply --path path.json --witness witness.jsonl --shard 1/3 >stdout || fail "a shard"
head -n 1 again | cmp -s - <(head -n 1 stdout) || fail "a shard culled anew differs: $(cat again)"
expect_error "--shard" "$occlude" validate good.ply --path path.json --shard 4/3
expect_error "--shard" "$occlude" validate good.ply --path path.json --shard 0/3
expect_error "--shard" "$occlude" validate good.ply --path path.json --shard 3

# Witnesses by a block instead of its front, of squares in an oriented box.
vertices='2 -1 -1\n2 1 -1\n2 1 1\n2 -1 1\n3 -1 -1\n3 1 -1\n3 1 1\n3 -1 1\n'
faces='4 0 1 2 3\n4 4 5 6 7\n4 0 1 5 4\n4 3 2 6 7\n4 0 3 7 4\n4 1 2 6 5\n'
for i in $(seq 2 59); do
  vertices+="$((2 + i)) -1 -1\n$((2 + i)) 1 -1\n$((2 + i)) 1 1\n$((2 + i)) -1 1\n"
  faces+="4 $((4 * i)) $((4 * i + 1)) $((4 * i + 2)) $((4 * i + 3))\n"
done
ply block.ply 240 64 "$vertices$faces"
block='"vertices":[[2,-1,-1],[2,1,-1],[2,1,1],[2,-1,1],[3,-1,-1],[3,1,-1],[3,1,1],[3,-1,1]],"faces":[[0,1,2,3],[4,5,6,7],[0,1,5,4],[3,2,6,7],[0,3,7,4],[1,2,6,5]]'
"$occlude" walk block.ply --path path.json --out blocked --no-render --witness front.jsonl >stdout || fail "walk with a block"
sed 's/"polygon":\[\[2,-1,-1\],\[2,1,-1\],\[2,1,1\],\[2,-1,1\]\]/'"$block"'/
  s/"min":\[32,-1,-1\],"max":\[61,1,1\]/"center":[46.5,0,0],"half_edges":[[14.5,0,0],[0,1,1],[0,1,-1]]/
  s/,"margin":[^}]*}/}/' front.jsonl >block.jsonl
grep -q '"vertices"' block.jsonl || fail "no witness by a block"
grep -q '"half_edges"' block.jsonl || fail "no witness of an oriented box"
"$occlude" validate block.ply --path path.json --witness block.jsonl >stdout 2>&1 || fail "block: $(cat stdout)"
lie "an oriented box" 's/\[0,1,1\],\[0,1,-1\]\]/[0,1,1],[0,1,-0.5]]/' block.ply block.jsonl
lie "the size of an oriented box" 's/\[14.5,0,0\]/[14.75,0,40]/' block.ply block.jsonl
lie "the vertices of a block" 's/\[3,1,1\],\[3,-1,1\]\]/[3.5,1,1],[3,-1,1]]/' block.ply block.jsonl
lie "the faces of a block" 's/,\[1,2,6,5\]\]/]/' block.ply block.jsonl
lie "what is behind a block" 's/"triangles":\[[0-9]*,[0-9]*\]/"triangles":[0,128]/' block.ply block.jsonl
sed 's/\[1,2,6,5\]/[1,2,6,8]/' block.jsonl >line.jsonl
expect_error "line.jsonl:1" "$occlude" validate block.ply --path path.json --witness line.jsonl

# Two walls at a right angle that hide together what neither hides alone; one of them bent, with a near plane in numbers.
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
  [ "$(pairs $model.jsonl)" -eq 4 ] || fail "$model: no cull by a union"
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
head -1 corner.jsonl | sed 's/"max":\[69,1,1\]/"max":[69,1,31]/' >edge.jsonl
"$occlude" validate corner.ply --path path.json --witness edge.jsonl >stdout 2>&1 || fail "edge: $(cat stdout)"
lie "an ulp beyond both shadows" 's/1,31\]/1,31.000000000000004]/' corner.ply edge.jsonl
head -1 corner.jsonl | sed 's/"occluders":\[\({[^}]*}\),/"occluders":[\1,\1,/' >line.jsonl
expect_error 'line.jsonl:1: "occluders"' "$occlude" validate corner.ply --path path.json --witness line.jsonl
expect_error "--witness" "$occlude" validate corner.ply --path path.json --witness corner.jsonl --unions

# Interrupted, it leaves nothing behind.
"$occlude" generate city --polygons 20000 --out city.ply --path city.json >/dev/null || fail "generate"
"$occlude" generate city --polygons 20000 --out again.ply --path again.json >/dev/null || fail "generate"
cmp -s city.ply again.ply && cmp -s city.json again.json || fail "two cities of one seed differ"
"$occlude" walk city.ply --path city.json --out stopped --witness stopped.jsonl 2>stderr >stdout &
sleep 1
kill -INT $!
wait $!
[ $? -eq 130 ] || fail "Ctrl-C: exit code, said: $(cat stderr)"
[ ! -e stopped ] && [ ! -e stopped.jsonl ] || fail "Ctrl-C left files behind"
# So does what is stopped while it prepares a model: here with lists that take many times as long.
echo old >city.pre
for signal in INT TERM; do
  timeout --preserve-status --signal $signal --kill-after 20 1 \
    "$occlude" preprocess city.ply --regions 1e6 --threshold 1e-6 --out city.pre 2>stderr >stdout
  [ $? -eq 130 ] || fail "preprocess: exit code after SIG$signal, said: $(cat stderr)"
  [ "$(cat city.pre)" = old ] || fail "preprocess: SIG$signal did not spare the file that was there"
done
"$occlude" generate city --polygons 5000000 --out big.ply --path big.json 2>stderr >stdout &
sleep 0.5
kill -INT $!
wait $!
[ $? -eq 130 ] && [ ! -e big.ply ] && [ ! -e big.json ] || fail "Ctrl-C did not stop generate"

# classify.
case='"eye":[0,0,0],"occluder":{"polygon":[[2,-1,-1],[2,1,-1],[2,1,1],[2,-1,1]]},"near":"surface"'
cat >cases.jsonl <<END
{"id":"inside",$case,"box":{"min":[4,-2,-2],"max":[4,2,2]},"expect":"inside"}
{"id":"reversed",$case,"box":{"min":[4,2,-2],"max":[4,1,2]}}
{"id":"touch",$case,"box":{"min":[4,2,0],"max":[4,3,1]},"expect":"partial"}
END
"$occlude" classify cases.jsonl >stdout || fail "classify"
cat >expected <<'END'
{"id":"inside","certified":"inside","stage":"exact","plain":"inside","conservative":"inside","oracle":"inside"}
{"id":"reversed","error":"box has min > max"}
{"id":"touch","certified":"partial","stage":"exact","plain":"partial","conservative":"partial","oracle":"partial"}
END
diff expected stdout || fail "classify answered otherwise"
sed 's/"expect":"partial"/"expect":"outside"/' cases.jsonl | "$occlude" classify - >/dev/null
[ $? -eq 1 ] || fail "a wrong expectation was accepted"
(head -1 cases.jsonl; echo '{"id":') | "$occlude" classify >stdout 2>stderr
[ $? -eq 2 ] || fail "a broken line was accepted"
[ "$(wc -l <stdout)" -eq 1 ] || fail "the lines before a broken one are to be answered"
grep -q 'standard input:2: ' stderr || fail "the line is not named: $(cat stderr)"

# Oriented boxes and polytopes: a block two deep, seen on its front and on one side, which is edge-on.
block='"eye":[0,0,0],"occluder":{"vertices":[[2,0,-1],[4,0,-1],[4,2,-1],[2,2,-1],[2,0,1],[4,0,1],[4,2,1],[2,2,1]],"faces":[[0,1,2,3],[4,5,6,7],[0,1,5,4],[1,2,6],[1,6,5],[3,2,6,7],[0,4,7,3]]},"near":"surface"'
but() { # but SED_SCRIPT: the block, changed
  sed "$1" <<<"$block"
}
turned='[[1,1,0],[-1,1,0],[0,0,1]]'
cat >cases.jsonl <<END
{"id":"turned",$case,"box":{"center":[6,0,0],"half_edges":$turned},"expect":"inside"}
{"id":"touching",$case,"box":{"center":[4,3.25,0],"half_edges":[[1,0.5,0],[-0.5,1,0],[0,0,1]]},"expect":"partial"}
{"id":"needle",$case,"box":{"center":[6,0,0],"half_edges":[[0,0,0],[0,8,0],[0,0,0]]},"expect":"partial"}
{"id":"point",$case,"box":{"center":[6,3,3],"half_edges":[[0,0,0],[0,0,0],[0,0,0]]},"expect":"inside"}
{"id":"behind",$block,"box":{"min":[5,0,-1],"max":[6,5,1]},"expect":"inside"}
{"id":"edge-on",$block,"box":{"min":[5,-1,-1],"max":[6,0,1]},"expect":"partial"}
{"id":"beside",$block,"box":{"min":[5,-1,-1],"max":[6,-0.0625,1]},"expect":"outside"}
{"id":"both",$block,"box":{"center":[6,2,0],"half_edges":$turned},"expect":"inside"}
{"id":"along",$(but s/eye/direction/),"box":{"min":[0,0,0],"max":[1,1,1]}}
{"id":"no vertex",$(but s/4,7,3/4,7,4294967299/),"box":{"min":[0,0,0],"max":[1,1,1]}}
{"id":"open",$(but 's/,\[0,4,7,3\]//'),"box":{"min":[0,0,0],"max":[1,1,1]}}
{"id":"dented",$(but s/2,0,-1/3,0.5,0/),"box":{"min":[0,0,0],"max":[1,1,1]}}
{"id":"within",$(but s/0,0,0/3,2,1/),"box":{"min":[0,0,0],"max":[1,1,1]}}
{"id":"half edge",$case,"box":{"center":[6,0,0],"half_edges":[[1,1,0],[-1,1,0],[0,0,1e99]]}}
END
"$occlude" classify cases.jsonl >stdout || fail "classify: $(cat stdout)"
grep -o '"id":"[^"]*","\(certified\|error\)":"[a-z]*' stdout >answers
cat >expected <<'END'
"id":"turned","certified":"inside
"id":"touching","certified":"partial
"id":"needle","certified":"partial
"id":"point","certified":"inside
"id":"behind","certified":"inside
"id":"edge-on","certified":"partial
"id":"beside","certified":"outside
"id":"both","certified":"inside
"id":"along","error":"direction
"id":"no vertex","error":"face
"id":"open","error":"polytope
"id":"dented","error":"polytope
"id":"within","error":"viewpoint
"id":"half edge","error":"number
END
diff expected answers || fail "classify answered oriented boxes or polytopes otherwise"

# Numbers that JSON has no words for are refused with the case; what is no case is an error of the line.
echo "{\"id\":\"n\",$case,\"box\":{\"min\":[NaN,0,0],\"max\":[4,3,1e999]}}" | "$occlude" classify >stdout || fail "NaN"
grep -q '{"id":"n","error":"number is not finite"}' stdout || fail "NaN: $(cat stdout)"
echo "{\"id\":1,$case,\"box\":{\"min\":[1,0,0],\"max\":[0,0,0]},\"expect\":\"inside\"}" | "$occlude" classify >/dev/null
[ $? -eq 1 ] || fail "an expectation of a refused case was passed over"
nested=$(printf '[%.0s' $(seq 1 20000))
box='"box":{"min":[0,0,0],"max":[1,1,1]}'
faces() { # faces JSON: a case with these faces
  echo "{\"eye\":[0,0,0],\"occluder\":{\"vertices\":[[1,0,0]],\"faces\":$1},$box}"
}
for line in "{\"id\":$nested" "{\"id\":[1]}" "{$case,\"direction\":[1,0,0],$box}" '[]' '"x"' \
  "$(faces 1)" "$(faces '[1]')" "$(faces '[[-1]]')" "$(faces '[[0.5]]')" "$(faces '[["0"]]')" "$(faces '[[[0]]]')" \
  "{\"eye\":[0,0,0],\"occluder\":{\"vertices\":[[1,0,0]]},$box}" "{\"eye\":[0,0,0],\"occluder\":{\"faces\":[[0]]},$box}" \
  "{\"eye\":[0,0,0],\"occluder\":{\"polygon\":[],\"vertices\":[],\"faces\":[]},$box}" \
  "{\"eye\":[0,0,0],\"occluder\":[],$box}" "{$case,\"box\":{\"center\":[0,0,0]}}" \
  "{$case,\"box\":{\"center\":[0,0,0],\"half_edges\":[[0,0,0],[0,0,0]]}}" \
  "{$case,\"box\":{\"center\":[0,0,0],\"half_edges\":[[0,0,0],[0,0,0],[0,0,0]],\"min\":[0,0,0]}}"; do
  echo "$line" >line.jsonl
  expect_error "line.jsonl:1: " "$occlude" classify line.jsonl
done
{ head -c 1000000 /dev/zero | tr '\0' 'a'; echo; } >line.jsonl
expect_error "line.jsonl:1: not JSON, near column 1" timeout 10 "$occlude" classify line.jsonl
echo '{"eye":[NaN,NaN,NaN,NaN}' >line.jsonl
expect_error "line.jsonl:1: not JSON, near column 24" "$occlude" classify line.jsonl
# Of two values under one key neither counts.
echo '{"eye":[0,0,0],"eye":[1,0,0]}' >line.jsonl
expect_error "line.jsonl:1: a key that its object has before, near column 16" "$occlude" classify line.jsonl
# A line without end is not read to its end, and whoever reads it says how much is read.
for command in "classify" "fuzz" "validate good.ply --path path.json --witness"; do
  expect_error "/dev/zero:1: the line is longer than 16 MiB" timeout 60 "$occlude" $command /dev/zero
done
for command in "fuzz --merge" "walk good.ply --out out --path" "walk good.ply --path path.json --out out --preprocess" \
  "walk --path path.json --out out"; do
  expect_error "/dev/zero: cannot read: it is not a regular file" timeout 60 "$occlude" $command /dev/zero
done
# A polygon may have very many sides, a polytope no more vertices than the oracle can judge in seconds.
corners=$(awk 'BEGIN { n = 100000; for (i = 0; i < n; i++) printf "%s[2,%.17g,%.17g]", i ? "," : "", cos(6.283185307179586 * i / n), sin(6.283185307179586 * i / n) }')
echo "{\"eye\":[0,0,0],\"occluder\":{\"polygon\":[$corners]},\"near\":\"surface\",\"box\":{\"min\":[4,0,0],\"max\":[5,1,1]},\"expect\":\"inside\"}" >line.jsonl
timeout 60 "$occlude" classify line.jsonl >stdout 2>stderr || fail "a polygon of 100000 sides: $(head -c 300 stdout stderr)"
corners=$(printf '[2,0,0],%.0s' $(seq 1 4096))
echo "{\"eye\":[0,0,0],\"occluder\":{\"vertices\":[$corners[2,1,0]],\"faces\":[]},$box}" >line.jsonl
expect_error "line.jsonl:1: \"occluder\": a polytope with more than 4096 vertices" timeout 60 "$occlude" classify line.jsonl
# Vertices that no face names, thousands on one edge of the silhouette, are one side of the shadow and not millions.
corners=$(for i in $(seq 1 4000); do printf '[3,1,%s],' "0.$(printf '%04d' $i)"; done)
echo "{\"eye\":[0,0,0.5],\"occluder\":{\"vertices\":[[2,0,0],[3,0,0],[3,1,0],[2,1,0],[2,0,1],[3,0,1],[3,1,1],[2,1,1],${corners%,}],\"faces\":[[0,1,2,3],[4,5,6,7],[0,1,5,4],[1,2,6,5],[2,3,7,6],[3,0,4,7]]},\"near\":\"surface\",\"box\":{\"min\":[5,0.6,0.4],\"max\":[6,0.7,0.6]},\"expect\":\"inside\"}" >line.jsonl
timeout 60 "$occlude" classify line.jsonl >stdout 2>stderr || fail "4000 vertices on an edge: $(head -c 300 stdout stderr)"
# What a wall hides is soon found, though polygons that hide nothing run through the box.
awk 'BEGIN { srand(3); printf "{\"eye\":[0,0,0],\"occluder\":{\"cover\":[[[3.1,5,5]"; for (i = 0; i < 150; ++i) { for (k = 0; k < 3; ++k) v[k] = 4 + 4 * rand(); v[i % 3] = 3 + 0.9 * rand(); printf ",[%.17g,%.17g,%.17g]", v[0], v[1], v[2] } printf "],[[13,-5,-5],[-5,13,-5],[-5,-5,13]]]},\"box\":{\"min\":[4,4,4],\"max\":[8,8,8]},\"expect\":\"inside\"}\n" }' >line.jsonl
timeout 60 "$occlude" classify line.jsonl >stdout 2>stderr || fail "a cover that runs through the box: $(head -c 300 stdout stderr)"
# Nor do more polygons fit than memory holds; what is too large is named.
awk 'BEGIN { for (i = 1; i <= 2e6; ++i) print "v", i, 0, 0; for (i = 1; i <= 1e6; ++i) print "f", i, i + 1, i + 2 }' >many.obj
with_little_memory() { (ulimit -v 400000 && timeout 60 "$occlude" "$@"); }
if with_little_memory --version >/dev/null 2>&1; then # a sanitizer needs more to begin with
  expect_error "many.obj" with_little_memory walk many.obj --path path.json --no-render --out out
  grep -q 'out of memory' stderr || fail "out of memory: $(cat stderr)"
  # Drawing takes more, and says so before the OpenGL library crashes for want of it.
  for kib in 250000 300000 350000 450000; do
    (ulimit -v $kib && exec timeout 60 "$occlude" walk deep.ply --path still.json --out little --size 640x360) >/dev/null 2>stderr
    code=$?
    [ $code -eq 127 ] && continue # not even its libraries are loaded
    [ $code -eq 0 ] || { [ $code -eq 2 ] && grep -q 'out of memory' stderr; } || fail "$kib KiB: exit $code: $(cat stderr)"
    rm -rf little
  done
fi
(ulimit -s 64 && exec "$occlude" walk deep.ply --path still.json --out little) >/dev/null 2>stderr
[ $? -eq 2 ] && grep -q 'the stack is limited to 64 KiB' stderr || fail "little stack: $(cat stderr)"
rm many.obj
# The import library does not say that no more files may be open.
printf 'solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n' >a.stl
for files in 5 6 7 8; do
  (ulimit -n $files && exec "$occlude" preprocess a.stl --out few.pre) >/dev/null 2>stderr
  code=$?
  [ $code -eq 127 ] && continue # not even its libraries are loaded
  [ $code -eq 0 ] || { [ $code -eq 2 ] && grep -q 'Too many open files' stderr; } || fail "$files files: exit $code: $(cat stderr)"
done
# A glTF of 22 bytes that announces 4 GiB; what is in the way is named, on one line, whatever its name.
printf 'glTF\2\0\0\0\377\377\377\377\360\377\377\377JSON{}' >$'odd\n\e[2J\377.glb'
expect_error 'odd\x0a\x1b[2J\xff.glb: cannot import: ' timeout 60 "$occlude" walk $'odd\n\e[2J\377.glb' --path path.json --out out
for command in "classify" "fuzz" "validate" "walk" "why" "preprocess" "bench culler"; do
  "$occlude" $command --help >stdout
  grep -q 'Limits: .* at most 16 MiB, .* 4096 MiB' stdout || fail "$command --help does not tell limits"
done
# Who waits for input can be stopped.
mkfifo pipe
for command in classify fuzz; do
  (sleep 5 >pipe &) # keeps the pipe open, and silent
  timeout --preserve-status --signal INT --kill-after 5 1 "$occlude" $command pipe >/dev/null 2>stderr
  [ $? -eq 130 ] || fail "$command does not stop while it waits: $(cat stderr)"
done
[ ! -e /dev/full ] || expect_error "standard output" bash -c '"$0" classify cases.jsonl >/dev/full' "$occlude"

# fuzz: nothing is wrong, whatever the number of jobs and however the cases are dealt.
"$occlude" fuzz --cases 20000 --seed 7 >table || fail "fuzz: $(tail -3 table)"
grep -q '^all .*| *0 |' table || fail "fuzz: no total"
grep -q '^0 wrong in [0-9]* cases' table || fail "fuzz: no verdict"
without_time() { grep -v core_seconds "$1"; }
"$occlude" fuzz --cases 20000 --seed 7 --jobs 1 --json >one.json || fail "fuzz --jobs 1"
"$occlude" fuzz --cases 20000 --seed 7 --jobs 3 --json >three.json || fail "fuzz --jobs 3"
diff <(without_time one.json) <(without_time three.json) >/dev/null || fail "fuzz: the number of jobs changes the result"
for i in 0 1 2; do "$occlude" fuzz --cases 20000 --seed 7 --shard $i/3 --out part$i.json >/dev/null || fail "fuzz --shard $i/3"; done
"$occlude" fuzz --merge part2.json part0.json part1.json --json >merged.json || fail "fuzz --merge"
counts() { sed -n '/"families"/,$p' "$1" | grep -v core_seconds; }
diff <(counts one.json) <(counts merged.json) >/dev/null || fail "fuzz: shards do not add up"
"$occlude" fuzz --family lattice --family spoiled --cases 1 | grep -c '^spoiled\|^lattice' | grep -qx 2 || fail "fuzz --family"
"$occlude" fuzz cases.jsonl | grep -q '^cases.jsonl' || fail "fuzz FILE"
"$occlude" fuzz --seconds 0.2 | grep -q '^0 wrong in ' || fail "fuzz --seconds"
sed 's/"expect":"[a-z]*"/"expect":"outside"/' cases.jsonl >untrue.jsonl
"$occlude" fuzz untrue.jsonl --findings untrue_findings.jsonl --out untrue.json >table 2>stderr && fail "fuzz: a wrong expect is no finding"
grep -q '^WRONG .*: expect: outside, the oracle: inside' table || fail "fuzz: does not say what is wrong: $(cat table)"
"$occlude" fuzz untrue_findings.jsonl >again 2>stderr && fail "fuzz: a stored finding is none any more"
[ "$(grep -c '^WRONG' again)" -eq "$(grep -c '^WRONG' table)" ] || fail "fuzz: $(grep -c '^WRONG' again) of the stored findings again"
"$occlude" fuzz --merge untrue.json --findings merged_findings.jsonl >/dev/null 2>stderr && fail "fuzz --merge loses a finding"
cmp -s untrue_findings.jsonl merged_findings.jsonl || fail "fuzz --merge: other findings than those of the parts"
"$occlude" walk good.ply --path path.json --out recorded --no-render --cases recorded.jsonl >/dev/null || fail "walk --cases"
"$occlude" classify recorded.jsonl >stdout || fail "classify of what walk recorded"
[ -s stdout ] && [ "$(wc -l <stdout)" -eq "$(wc -l <recorded.jsonl)" ] || fail "walk --cases recorded nothing"
echo '{"seed":1}' >bad.json
expect_error "bad.json: not a result of occlude fuzz --out: \"rounds\" is missing" "$occlude" fuzz --merge part0.json bad.json
head -c 100 part0.json >bad.json
expect_error "bad.json:$(($(wc -l <bad.json) + 1)): not JSON, near column " "$occlude" fuzz --merge bad.json
for change in 's/"cases": [0-9]*/"cases": -5/' 's/"cases": [0-9]*/"cases": 1.5/' 's/"cases": [0-9]*/"cases": 1e30/' \
  's/"inside": [0-9]*/"inside": 1000000000/' 's/"seed": 7/"seed": -1/' 's/"shards": 3/"shards": 0/' \
  's/"core_seconds": [0-9.]*/"core_seconds": -1/' 's/"families": /"families": [], "x": /'; do
  sed "$change" part0.json >bad.json
  expect_error "bad.json: not a result of occlude fuzz --out: \"" "$occlude" fuzz --merge bad.json
done
tr -d ' \n' <part0.json | sed 's/"parts":\[0\]/"parts":[0,0]/' >bad.json
expect_error "bad.json: shard 0 of 3 was given before" "$occlude" fuzz --merge bad.json
expect_error "missing.json" "$occlude" fuzz --merge missing.json
expect_error "part0.json: shard 0 of 3 was given before" "$occlude" fuzz --merge part0.json part0.json
cp part0.json same.json
expect_error "same.json: shard 0 of 3 was given before" "$occlude" fuzz --merge part0.json same.json
expect_error "one.json: a result of another run" "$occlude" fuzz --merge part0.json one.json
sed 's/"interrupted": false/"interrupted": true/' part1.json >half.json
expect_error "half.json: a run that was interrupted" "$occlude" fuzz --merge part0.json half.json
expect_error "nonsense: no such family" "$occlude" fuzz --family nonsense
expect_error "--shard" "$occlude" fuzz --shard 3/3
expect_error "--shard" "$occlude" fuzz --shard 1
expect_error "--shard" "$occlude" fuzz --shard 0/1048577
expect_error "--cases" "$occlude" fuzz --cases 0
expect_error "--seconds" "$occlude" fuzz --seconds nan
expect_error "none/f" "$occlude" fuzz --cases 1 --findings none/f
expect_error "'many' is not a whole number" "$occlude" fuzz --cases many
expect_error "--family" "$occlude" fuzz cases.jsonl --family lattice
expect_error "--jobs" "$occlude" fuzz cases.jsonl --jobs 2
expect_error "--stop-at-first" "$occlude" fuzz --merge part0.json --stop-at-first
expect_error "--stop-at-first" "$occlude" fuzz --shard 0/2 --stop-at-first
"$occlude" fuzz --cases 1 --family lattice --json --out late.json 2>stderr | true
ls -A | grep -q 'tmp-' && fail "left behind: $(ls -A | grep tmp-)"
cp untrue.jsonl $'odd\xff.jsonl'
"$occlude" fuzz $'odd\xff.jsonl' --json --findings odd_findings.jsonl >/dev/null 2>stderr
[ $? -eq 1 ] && [ -s odd_findings.jsonl ] || fail "fuzz: a file name that is not UTF-8: $(cat stderr)"
: >empty.jsonl
expect_error "empty.jsonl: no cases" "$occlude" fuzz empty.jsonl
expect_error "missing.jsonl" "$occlude" fuzz missing.jsonl
echo '{"id":"x"}' >bad.jsonl
expect_error "bad.jsonl:1: " "$occlude" fuzz bad.jsonl

# bench: everything measured is there and is a positive number. How fast it is, is no matter for a test.
"$occlude" bench kernel --json --boxes 256 --repetitions 1 >bench.json || fail "bench"
for member in ratios certified_over_plain random integer_touching ulp_touching batch_speedup gjk_over_certified operations ns \
  overlap_certified overlap_plain naive answers peers machine; do
  grep -q "^ *\"$member\": " bench.json || fail "bench: no $member"
done
sed -n '/^  "ns": {/,/^  }/p' bench.json | grep -v '[{}]' >times
[ "$(wc -l <times)" -ge 15 ] || fail "bench: only $(wc -l <times) times"
awk -F '": ' '$2 + 0 <= 0 || $2 !~ /^[0-9]/ { bad = 1 } END { exit bad }' times || fail "bench measured: $(cat times)"
grep -A2 '"wrong": {' bench.json | grep '"overlap_certified"' | grep -qv ': 0,' && fail "bench: certified answers are wrong"
"$occlude" bench kernel --boxes 256 --repetitions 1 | grep -q 'Table 1' || fail "bench without --json"
expect_error "--boxes" "$occlude" bench kernel --boxes 0
expect_error "--repetitions" "$occlude" bench kernel --repetitions many
expect_error "--seed" "$occlude" bench kernel --seed -1

# bench culler: every experiment is there; the files are those that it prints.
"$occlude" bench culler --polygons 20000 --frames 0:8 --no-render --regions 64 --repetitions 1 --largest 50000 --json --out bench >bench.json 2>stderr ||
  fail "bench culler: $(cat stderr)"
cmp -s bench.json bench/culler.json || fail "bench culler: culler.json is not what it prints"
for member in model polygons frames options table2 methods mean culled_share speedup_limit figures_2_and_3 view_frustum_polygons figure4 knee \
  all_three all_three_over_area_angle_at_8 sweeps entries cull_ratio sort comparisons_anew joined pictures cover_size leaves budgets growth exponents build machine; do
  grep -q "^ *\"$member\": " bench/culler.json || fail "bench culler: no $member"
done
grep -q '"speedup": null' bench/culler.json || fail "bench culler --no-render: a speedup of nothing drawn"
[ "$(grep -o '<svg' bench/culler.html | wc -l)" -eq 13 ] || fail "bench culler: $(grep -o '<svg' bench/culler.html | wc -l) charts"
grep -q '<script\|src="http\|href="http\|nan\|inf"' bench/culler.html && fail "bench culler: scripts, addresses or no numbers in the page"
"$occlude" bench culler good.ply --path path.json --frames 0:4 --size 64x36 --samples 0 --repetitions 1 >stdout || fail "bench culler MODEL"
for title in 'Table 2' 'Figure 4' 'grid regions' 'Threshold' 'Sort with' 'coarse picture' 'size of the leaves'; do
  grep -q "$title" stdout || fail "bench culler MODEL: no $title"
done
grep -q 'Growth with the number of polygons' stdout && fail "bench culler MODEL: cities"
grep -q 'all three' stdout && fail "bench culler --samples 0: curves that need samples"
"$occlude" bench culler good.ply --path path.json --only sort,sweeps --frames 0:2 --repetitions 1 >stdout || fail "bench culler --only"
grep -q 'Table 2\|Figure 4' stdout && fail "bench culler --only: more than was chosen"
expect_error "--only" "$occlude" bench culler --only nonsense
expect_error "--path" "$occlude" bench culler good.ply
expect_error "--largest" "$occlude" bench culler --largest 5
expect_error "--largest" "$occlude" bench culler --largest many
expect_error "no frame" "$occlude" bench culler good.ply --path path.json --frames 7:9 --out benchmarks
expect_error "missing.ply" "$occlude" bench culler missing.ply --path path.json --out benchmarks
expect_error "file" "$occlude" bench culler good.ply --path path.json --out file/out
"$occlude" bench culler --polygons 20000 --no-render --out benchmarks 2>stderr >stdout &
sleep 1
kill -INT $!
wait $!
[ $? -eq 130 ] && [ ! -e benchmarks ] || fail "Ctrl-C did not stop bench culler"

for command in "" generate "generate city" preprocess walk why classify validate fuzz bench "bench kernel" "bench culler"; do
  "$occlude" $command --help >stdout || fail "no help for '$command'"
  grep -q . stdout || fail "an empty help for '$command'"
done

# A real model, where there is one.
models=${2:-}
if [ -n "$models" ] && [ -f "$models/sponza.ply" ]; then
  "$occlude" walk "$models/sponza.ply" --path "$models/sponza_path1.json" --out sponza --frames 0:300:60 --size 160x90 >stdout ||
    fail "sponza: $(cat stdout)"
else
  echo "No real models (OCCLUDE_DATA): skipped"
fi

finish
