#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# `occlude walk`: what it writes for good input, and what it says about bad input.
# Usage: walk_test.sh PATH_OF_OCCLUDE [FOLDER_OF_REAL_MODELS]
set -uo pipefail
scenes=$(realpath "$(dirname "$0")/../data/scenes")
. "$(dirname "$0")/common.sh"
walk_of_squares

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

# Matrices of which nothing tells the order.
printf '0 0 -1 0 -1 0 0 0 0 1 0 0 0 0 0 1\n0 0 -1 0 -1 0 0 0 0 1 0 0 0 0 0 1\n' >turned.csv
expect_error "turned.csv:1: the numbers may be rows or columns: give --matrix-order row" "$occlude" walk good.ply --path turned.csv --out out
"$occlude" walk good.ply --path turned.csv --matrix-order row --out matrices --no-render >/dev/null || fail "walk by matrices"
"$occlude" walk good.ply --path matrices/path.json --out kept --no-render >/dev/null && cmp -s matrices/path.json kept/path.json || fail "matrices have another path than the one kept"
grep -q '"eye": \[0.0, 0.0, 0.0\], "target": \[1.0, 0.0, 0.0\]}' matrices/path.json || fail "matrices place: $(cat matrices/path.json)"
gzip -k turned.csv
"$occlude" walk good.ply --path turned.csv.gz --matrix-order row --out kept --no-render >/dev/null && cmp -s matrices/path.json kept/path.json || fail "compressed matrices have another path"
sed 's/\[0,0,0\]/[0,1e-40,0]/' path.json >noise.json
"$occlude" walk good.ply --path noise.json --out kept --no-render >/dev/null 2>stderr || fail "noise: $(cat stderr)"
[ "$(cat stderr)" = "occlude: warning: noise.json: 1 numbers nearer to 0 than 2^-100 were taken as 0" ] || fail "noise: $(cat stderr)"

# A camera of the model.
cat >camera.gltf <<'END'
{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":0},{"name":"eye","translation":[0,0,1],"camera":0}],
 "cameras":[{"type":"perspective","perspective":{"yfov":1,"znear":0.5}}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
 "accessors":[{"bufferView":0,"componentType":5126,"count":6,"type":"VEC3","min":[-1,-1,-9],"max":[1,1,-5]},{"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"}],
 "bufferViews":[{"buffer":0,"byteLength":72},{"buffer":0,"byteOffset":72,"byteLength":12}],
 "buffers":[{"byteLength":84,"uri":"data:application/octet-stream;base64,AACAvwAAgL8AAKDAAACAPwAAgL8AAKDAAAAAAAAAgD8AAKDAAACAvwAAgL8AABDBAACAPwAAgL8AABDBAAAAAAAAgD8AABDBAAABAAIAAwAEAAUA"}]}
END
"$occlude" walk camera.gltf --path camera:eye --out camera --size 64x36 --witness camera.jsonl >stdout 2>stderr || fail "walk --path camera:eye: $(cat stderr)"
[ ! -s stderr ] || fail "walk --path camera:eye said: $(cat stderr)"
grep -q '"eye": \[0.0, 0.0, 1.0\], "target": \[0.0, 0.0, 0.0\]' camera/path.json || fail "the camera stands elsewhere: $(cat camera/path.json)"
"$occlude" walk camera.gltf --path camera/path.json --out camera --size 64x36 --witness repeated.jsonl >/dev/null || fail "repeated"
cmp -s camera.jsonl repeated.jsonl || fail "the path of a camera culls something else when it is read"
expect_error "camera.gltf: its cameras are camera:eye" "$occlude" walk camera.gltf --path camera: --out out
expect_error "good.ply: there is no camera in it" "$occlude" validate good.ply --path camera:eye

# Folders and options.
touch file
expect_error "file" "$occlude" walk good.ply --path path.json --out file/out
for frames in 4:9 9:10 2:1; do
  expect_error "--frames: no frame selected: the path has 4 frames, 0 to 3" \
    "$occlude" walk good.ply --path path.json --out out --frames $frames
done
expect_error "--frames" "$occlude" walk good.ply --path path.json --out out --frames 1
expect_error "--size" "$occlude" walk good.ply --path path.json --out out --size 0x10
expect_error "--arithmetic" "$occlude" walk good.ply --path path.json --out out --arithmetic float
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
grep -A1 '"missed": {' report/summary.json | grep -q '"frames": 4' || fail "summary.json does not say why polygons were missed"
grep -q '^good.ply: 64 polygons; 63 x 2 x 2 units, +z taken as up$' stdout || fail "walk does not say what it read: $(cat stdout)"
for method in 'view frustum alone' automatic 'shadow frusta' 'joined shadows'; do
  grep -q "^$method  *[0-9]" stdout || fail "no $method in the table: $(cat stdout)"
  grep -q "<td>$method</td>" report/report.html || fail "no $method in the page"
  grep -q "\"method\": \"$method\"" report/summary.json || fail "no $method in the summary"
done
grep -q '"by":"cover"' witness.jsonl || fail "no witness of a cull by cover"
"$occlude" validate good.ply --path path.json --witness witness.jsonl >stdout || fail "validate"
total=$(wc -l <witness.jsonl)
grep -q "^$total of $total witnesses proved" stdout || fail "validate said: $(cat stdout)"
"$occlude" validate good.ply --path path.json --size 64x36 >again || fail "validate without file"
# Culling again proves the same, and also says why hidden polygons were drawn.
head -n 4 again | cmp -s stdout - || fail "culling anew proves something else: $(cat again)"
grep -q "^without a pixel and drawn in 4 of the frames" again || fail "no reasons: $(cat again)"

# A path of another model is taken with a warning.
sed 's/{/{"model":"other.ply",/' path.json >named.json
sed 's/0,0\]/0,900]/g' path.json >far.json
for command in "walk good.ply --out foreign --no-render" "validate good.ply --size 64x36" \
  "why good.ply --size 64x36 --frame 0 --polygon 0" "bench culler good.ply --only sort --repetitions 1 --no-render"; do
  "$occlude" $command --path named.json >stdout 2>stderr || fail "$command of another model: $(cat stderr)"
  [ "$(cat stderr)" = "occlude: warning: named.json: made for other.ply, not for good.ply" ] || fail "$command said: $(cat stderr)"
done
"$occlude" walk good.ply --out foreign --no-render --path far.json >stdout 2>stderr || fail "a path far from the model"
[ "$(cat stderr)" = "occlude: warning: far.json: the path is nowhere near good.ply" ] || fail "walk said: $(cat stderr)"
"$occlude" walk good.ply --out foreign --no-render --path path.json >stdout 2>stderr || fail "walk"
[ ! -s stderr ] || fail "walk said: $(cat stderr)"
grep -q 'Nothing was drawn' foreign/report.html || fail "the report does not say that nothing was drawn"

# Without a path one is made, and saved beside the report: with it the walk is the same, byte for byte.
room
"$occlude" walk room.ply --size 64x36 --witness made.jsonl >stdout || fail "walk without a path: $(cat stdout)"
grep -q 'report: report/report.html' stdout || fail "walk without --out said: $(cat stdout)"
grep -q '"model": "room.ply"' report/path.json || fail "path.json does not name its model"
cp report/path.json made.json
for path in made.json report/path.json; do
  "$occlude" walk room.ply --path $path --size 64x36 --witness again.jsonl >/dev/null || fail "walk --path $path"
  cmp -s made.jsonl again.jsonl || fail "walk --path $path culls something else"
  cmp -s made.json report/path.json || fail "walk --path $path leaves another path"
done
"$occlude" validate room.ply --witness made.jsonl --size 64x36 >stdout || fail "validate without a path: $(cat stdout)"
for kind in walk fly orbit; do
  "$occlude" walk room.ply --path $kind --out $kind --no-render >stdout || fail "walk --path $kind"
  "$occlude" validate room.ply --path $kind --size 64x36 --frames 0:300:60 >again || fail "validate --path $kind"
  "$occlude" validate room.ply --path $kind/path.json --size 64x36 --frames 0:300:60 | cmp -s again - || fail "another path: $kind"
done
cmp -s walk/path.json made.json || fail "the way through a room is no walk"
! cmp -s walk/path.json fly/path.json && ! cmp -s fly/path.json orbit/path.json || fail "two kinds of path are the same"
"$occlude" preprocess room.ply --out room.store >/dev/null && "$occlude" walk room.store --out stored --no-render >/dev/null || fail "store"
sed 's/room.store/room.ply/' stored/path.json | cmp -s - made.json || fail "a store has another path than its model"
"$occlude" why room.ply --path walk --frame 0 --polygon 0 --size 64x36 >/dev/null || fail "why --path walk"
"$occlude" render room.ply --path orbit --frame 0 --size 64x36 --out orbit.png >/dev/null || fail "render --path orbit"
"$occlude" bench culler room.ply --path fly --only sort --repetitions 1 --no-render >/dev/null || fail "bench culler --path fly"
cp made.json ./orbit.json && mkdir words && cp made.json words/walk && (cd words && expect_error "named twice" "$occlude" walk ../room.ply --path ./walk --out . --witness walk)
"$occlude" walk good.ply --path walk --out kind --no-render >/dev/null 2>stderr || fail "walk --path walk where there is no floor"
[ "$(cat stderr)" = "occlude: warning: good.ply: there is no way to walk in it: the path is of the kind orbit" ] || fail "walk --path walk said: $(cat stderr)"
ply far.ply 3 2 '0 0 0\n1e30 0 0\n0 1e30 0\n3 0 1 2\n3 0 1 2\n'
expect_error "far.ply: no camera path can be made: " "$occlude" walk far.ply --out out

# Squares very little before the near plane, in a model so deep that single precision draws them.
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

"$occlude" walk deep.ply --path still.json --out deep --no-render --regions tree --leaf 1 >/dev/null || fail "walk deep.ply --regions tree"

# A wall, and a slanting one behind it, in a tree of oriented boxes.
slanting_wall
"$occlude" walk slanting.ply --path path.json --out oriented --no-render --method frusta --bounds obb --witness oriented.jsonl >/dev/null ||
  fail "walk --bounds obb"
grep -q '"box":{"center":' oriented.jsonl || fail "walk --bounds obb: no oriented box was culled"
grep -q '"bounds": "obb"' oriented/summary.json || fail "walk --bounds obb: not in the summary"
"$occlude" validate slanting.ply --path path.json --witness oriented.jsonl >stdout 2>&1 || fail "oriented: $(cat stdout)"
"$occlude" validate slanting.ply --path path.json --bounds obb >stdout 2>&1 || fail "oriented: $(cat stdout)"
grep -q 'tree of OBBs' oriented/report.html || fail "walk --bounds obb: not in the report"

# A given option that does nothing by the method is named.
for idle in "cover --probes 4" "automatic --near farthest" "frusta --cover-size 128x96" "frusta --budget-ms 1"; do
  set -- $idle
  "$occlude" walk good.ply --path path.json --out idle --no-render --method $1 $2 $3 >/dev/null 2>stderr || fail "walk --method $idle"
  [ "$(cat stderr)" = "occlude: warning: $2: does nothing by $1" ] || fail "walk --method $idle said: $(cat stderr)"
done
"$occlude" walk good.ply --path path.json --out idle --no-render --probes 4 --budget-ms 1 >/dev/null 2>stderr || fail "walk --probes"
[ ! -s stderr ] || fail "walk --probes said: $(cat stderr)"

expect_error "--regions" "$occlude" walk good.ply --path path.json --out out --regions octree
expect_error "--weight-coherence" "$occlude" walk good.ply --path path.json --out out --weight-coherence -1
for options in "--shapes polygon" "--regions tree" "--probes 0" "--solid-angle exact --weight-coherence 0" "--weight-solid-angle 0"; do
  "$occlude" walk good.ply --path path.json --out weighed --no-render $options --witness weighed.jsonl >/dev/null ||
    fail "walk $options"
  "$occlude" validate good.ply --path path.json --witness weighed.jsonl >stdout 2>&1 || fail "walk $options: $(cat stdout)"
done

# Parallel projection, without a far plane.
echo '{"frames":5,"projection":"orthographic","height":3,"keyframes":[{"eye":[0,0.1,0.2],"target":[3,1,0.5]},{"eye":[0.5,0,0],"target":[7,-0.4,0.1]}]}' >parallel.json
"$occlude" walk good.ply --path parallel.json --out parallel --size 64x36 --witness parallel.jsonl >stdout || fail "parallel walk: $(cat stdout)"
grep -q '"direction"' parallel.jsonl || fail "no direction in parallel witnesses"
"$occlude" validate good.ply --path parallel.json --witness parallel.jsonl --size 64x36 >stdout 2>&1 || fail "parallel: $(cat stdout)"

# Outputs that would replace inputs or each other are refused. Plates of an earlier walk are removed.
expect_error "named twice" "$occlude" walk good.ply --path path.json --out other --witness good.ply
expect_error "named twice" "$occlude" walk good.ply --path path.json --out other --witness other/summary.json
mkdir -p inway/summary.json
expect_error "inway/summary.json" "$occlude" walk good.ply --path path.json --out inway
"$occlude" walk good.ply --path path.json --out report --frames 0:2 --size 64x36 >/dev/null || fail "second walk"
[ "$(ls report/plates | wc -l)" -eq 4 ] || fail "plates of an earlier walk are left"

# The same walk by cover: many polygons hide together, and the proof gives their numbers.
cover="--method cover --cover-size 128x96"
"$occlude" walk good.ply --path path.json --out covered --size 64x36 $cover --witness cover.jsonl >stdout || fail "walk by cover"
! grep -q 'shadow frusta' covered/summary.json stdout || fail "--method compares another method"
grep -q '"method": "cover"' covered/summary.json || fail "the summary names no method"
grep -q '"false_culls": 0' covered/summary.json || fail "by cover: $(cat stdout)"
grep -q '"by":"cover","polygons":\[[0-9]' cover.jsonl || fail "no witness by cover"
"$occlude" validate good.ply --path path.json --witness cover.jsonl >stdout || fail "validate by cover: $(cat stdout)"
covers=$(wc -l <cover.jsonl)
grep -q "^$covers of $covers witnesses proved" stdout || fail "validate by cover said: $(cat stdout)"
sed 's/"polygons":\[[0-9,]*\]/"polygons":[63]/' cover.jsonl >forged.jsonl
"$occlude" validate good.ply --path path.json --witness forged.jsonl >stdout 2>&1 && fail "a polygon that hides nothing was taken"
"$occlude" validate good.ply --path path.json --size 64x36 $cover >stdout || fail "validate --method cover: $(cat stdout)"
expect_error "--cover-size" "$occlude" walk good.ply --path path.json --out out --method cover --cover-size 63x64
expect_error "--method" "$occlude" walk good.ply --path path.json --out out --method raster
expect_error "--pixel-margin" "$occlude" walk good.ply --path path.json --out out --pixel-margin nan
expect_error "--leaf" "$occlude" walk good.ply --path path.json --out out --leaf 0

# The same walk, held by regions of eyes. They are the same each time, and their proofs are for all eyes of each.
for method in cover frusta; do
  held="--hold 0.5 --method $method --leaf 1"
  "$occlude" walk good.ply --path path.json --out held --size 64x36 $held --witness held.jsonl >stdout || fail "walk --hold by $method"
  grep -q 'false culls 0, wrong pixels 0' stdout || fail "walk --hold by $method said: $(cat stdout)"
  grep -q '^held: [1-9][0-9]* regions that reach 0.5 ahead, one for [0-9.]* frames; .* 0 of 4 frames by point$' stdout || fail "walk --hold said: $(cat stdout)"
  grep -q '"hold": 0.5,' held/summary.json && grep -q '"frames_by_point": 0,' held/summary.json || fail "the summary does not tell that frames are held"
  cut -d, -f28 held/frames.csv | grep -q '^[1-9][0-9]*$' || fail "frames.csv has no regions"
  grep -q '"eyes":{"center":\[.*"by":"shadow"\|"eyes":{"center":\[.*"by":"cover","drawn"' held.jsonl || fail "no proof of a region by $method"
  "$occlude" validate good.ply --path path.json --witness held.jsonl >stdout || fail "validate what a region of $method hides: $(cat stdout)"
  grep -q "^$(wc -l <held.jsonl) of $(wc -l <held.jsonl) witnesses proved" stdout || fail "validate --hold said: $(cat stdout)"
  "$occlude" walk good.ply --path path.json --out held --size 64x36 $held --witness again.jsonl >/dev/null && cmp -s held.jsonl again.jsonl ||
    fail "two walks by $method hold otherwise"
  "$occlude" why good.ply --path path.json --size 64x36 $held --frame 2 --polygon 40 >stdout || fail "why --hold"
  grep -q '^frame 2, polygon 40: culled: in shadow$' stdout || fail "why --hold by $method said: $(cat stdout)"
  "$occlude" render good.ply --path path.json --size 64x36 $held --frame 2 --out held.png >/dev/null && [ -s held.png ] || fail "render --hold"
done

# Frames of a camera that turns, near to what hides, are proved by planes and near planes of the regions' cameras.
"$occlude" walk "$scenes/door.ply" --path walk --hold 2 --method cover --frames 0:100:10 --out turns --no-render --witness turns.jsonl >/dev/null ||
  fail "walk --hold past a door"
grep -q '"drawn":\[' turns.jsonl || fail "no frame is held past a door"
"$occlude" validate "$scenes/door.ply" --path walk --witness turns.jsonl >stdout || fail "validate what is held past a door: $(cat stdout)"

"$occlude" walk good.ply --path path.json --out held --size 64x36 --hold 0.5 >stdout || fail "walk --hold"
for method in 'automatic, held' 'automatic'; do
  grep -q "^$method  *[0-9]" stdout || fail "walk --hold has no $method in the table: $(cat stdout)"
done
"$occlude" walk good.ply --path parallel.json --out held --size 64x36 --hold 0.5 --witness parallel.jsonl >stdout || fail "parallel rays, held: $(cat stdout)"
"$occlude" validate good.ply --path parallel.json --witness parallel.jsonl --size 64x36 >stdout 2>&1 || fail "parallel rays, held: $(cat stdout)"
expect_error "--hold" "$occlude" walk good.ply --path path.json --out out --hold 0
expect_error "--hold" "$occlude" walk good.ply --path path.json --out out --hold -1
expect_error "--hold" "$occlude" walk good.ply --path path.json --out out --hold 2m
expect_error "--region excludes --hold" "$occlude" walk good.ply --path path.json --out out --hold 1 --region 1
expect_error "not with --bounds obb" "$occlude" walk good.ply --path path.json --out out --hold 1 --bounds obb

# When interrupted, it leaves nothing behind.
"$occlude" generate city --polygons 20000 --out city.ply --path city.json >/dev/null || fail "generate"
interrupt INT "$occlude" walk city.ply --path city.json --out stopped --witness stopped.jsonl
[ ! -e stopped ] && [ ! -e stopped.jsonl ] || fail "Ctrl-C left files behind"

# A model that does not fit into memory is refused by name.
awk 'BEGIN { for (i = 1; i <= 2e6; ++i) print "v", i, 0, 0; for (i = 1; i <= 1e6; ++i) print "f", i, i + 1, i + 2 }' >many.obj
with_little_memory() { (ulimit -v 200000 && timeout 60 "$occlude" "$@"); }
if with_little_memory --version >/dev/null 2>&1; then # a sanitizer needs more to begin with
  expect_error "many.obj" with_little_memory walk many.obj --path path.json --no-render --out out
  grep -q 'out of memory' stderr || fail "out of memory: $(cat stderr)"
  # Drawing needs more memory, and says so before the OpenGL library crashes for lack of it.
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

# A glTF file of 22 bytes that announces 4 GiB is named on one line, whatever its name.
printf 'glTF\2\0\0\0\377\377\377\377\360\377\377\377JSON{}' >$'odd\n\e[2J\377.glb'
expect_error 'odd\x0a\x1b[2J\xff.glb: the file has 22 bytes' timeout 60 "$occlude" walk $'odd\n\e[2J\377.glb' --path path.json --out out

# A wall that is one face around a doorway, and a thing behind the doorway: the face's fan would fill it. Its pieces have one
# number, and hide what is beside the doorway.
{
  printf 'v 0 %s\n' '-10 0' '-2 0' '-2 4' '2 4' '2 0' '10 0' '10 6' '-10 6'
  printf 'v %s\n' '20 -1 0.5' '20 1 0.5' '20 1 3' '20 -1 3' '20 8 0.5' '20 9 0.5' '20 9 3' '20 8 3'
  printf 'f %s\n' '1 2 3 4 5 6 7 8' '9 10 11 12' '13 14 15 16' '16 15 14 13'
} >doorway.obj
echo '{"frames":2,"keyframes":[{"eye":[-20,0,1.5],"target":[20,0,1.5]},{"eye":[-20,0,1.5],"target":[20,0,1.5]}]}' >towards.json
for method in frusta cover; do
  options="doorway.obj --path towards.json --method $method --leaf 1"
  "$occlude" why $options --frame 0 --polygon 1 >stdout || fail "why of a doorway"
  grep -q '^frame 0, polygon 1: drawn$' stdout || fail "a doorway by $method hides: $(cat stdout)"
  "$occlude" why $options --frame 0 --polygon 2 >stdout || fail "why of a wall with a doorway"
  grep -q '^frame 0, polygon 2: culled: in shadow$' stdout || fail "a wall with a doorway by $method: $(cat stdout)"
  grep -q '^  by .*polygons* .*0' stdout || fail "a wall with a doorway by $method: $(cat stdout)"
  "$occlude" why $options --frame 0 --polygon 0 >stdout || fail "why of pieces"
  grep -q '^  drawn in 6 pieces' stdout || fail "why of pieces said: $(cat stdout)"
  "$occlude" walk $options --out doorway --witness doorway.jsonl >stdout || fail "walk to a doorway: $(cat stdout)"
  "$occlude" validate doorway.obj --path towards.json --witness doorway.jsonl >stdout 2>&1 ||
    fail "proofs of a doorway by $method: $(cat stdout)"
  [ -s doorway.jsonl ] || fail "no proofs of a doorway by $method"
done
grep -q '"by":"cover","polygons":\[.*\[0,[0-5]\]' doorway.jsonl || fail "no proof names a piece: $(cat doorway.jsonl)"
expect_error "no polygon 4: the model has 4" "$occlude" why doorway.obj --path towards.json --frame 0 --polygon 4

# The same without its doorway, and of glass.
{
  printf 'mtllib glass.mtl\nusemtl glass\n'
  sed 's/^f 1 2 3 4 5 6 7 8/f 1 6 7 8\nusemtl other/' doorway.obj
} >glass.obj
printf 'newmtl glass\nd 0.3\n' >glass.mtl
for method in frusta cover; do
  options="glass.obj --path towards.json --method $method --leaf 1"
  "$occlude" why $options --frame 0 --polygon 1 >stdout || fail "why of what is behind glass"
  grep -q '^frame 0, polygon 1: drawn$' stdout || fail "glass by $method hides: $(cat stdout)"
  "$occlude" why $options --opaque-all --frame 0 --polygon 1 >stdout || fail "why --opaque-all"
  grep -q '^frame 0, polygon 1: culled: in shadow$' stdout || fail "--opaque-all by $method: $(cat stdout)"
  "$occlude" walk $options --out glass >stdout || fail "walk to glass: $(cat stdout)"
  grep -q "^glass.obj: 4 polygons (1 see-through); 20 x 20 x 6 units, +z taken as up$" stdout || fail "walk to glass said: $(cat stdout)"
  grep -q '"see_through_polygons": 1' glass/summary.json || fail "summary.json does not count what is see-through"
  "$occlude" validate $options --exact-up-to 0 >stdout || fail "validate glass in item buffers: $(cat stdout)"
  "$occlude" validate $options >stdout || fail "validate glass: $(cat stdout)"
done
"$occlude" preprocess glass.obj --out glass.pre >/dev/null || fail "preprocess glass"
"$occlude" why glass.pre --path towards.json --method cover --frame 0 --polygon 1 | grep -q ': drawn$' || fail "glass in a store hides"
expect_error "settled" "$occlude" walk glass.pre --path towards.json --out out --opaque-all
expect_error "made from another model" "$occlude" walk glass.obj --path towards.json --out out --opaque-all --preprocess glass.pre

# A real model, if there is one.
models=${2:-}
if [ -n "$models" ] && [ -f "$models/sponza.ply" ]; then
  "$occlude" walk "$models/sponza.ply" --path "$models/sponza_path1.json" --out sponza --frames 0:300:60 --size 160x90 >stdout ||
    fail "sponza: $(cat stdout)"
else
  echo "No real models (OCCLUDE_DATA): skipped"
fi

finish
