#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# `occlude audit`: what another culler culled wrongly is found, and nothing else is claimed.
# Usage: audit_test.sh PATH_OF_OCCLUDE PATH_OF_THE_EXAMPLE_THAT_WRITES_A_LOG
set -uo pipefail
example=$(realpath "$2")
. "$(dirname "$0")/common.sh"
walk_of_squares # polygon 0 is a wall at x = 2 before the origin; polygons 1 to 63 are behind it

eye='"eye":[0,0,0],"target":[1,0,0],"width":320,"height":180'
# judge MODEL LOG FALSE_CULLS [OPTIONS...]: expects so many, and the exit code that goes with it.
judge() {
  local model=$1 log=$2 expected=$3 status
  shift 3
  "$occlude" audit "$model" --log "$log" --out audit --json "$@" >stdout 2>stderr
  status=$?
  [ $status -eq $((expected > 0 ? 1 : 0)) ] || fail "exit code $status of $log: $(cat stderr)"
  grep -q "\"false_culls\": $expected," stdout || fail "$log: $expected false culls expected: $(cat stdout)"
  cmp -s stdout audit/summary.json || fail "$log: summary.json is not what is printed"
  [ "$(wc -l <audit/false_culls.jsonl)" -eq "$expected" ] || fail "$log: $(cat audit/false_culls.jsonl)"
}
judged() { grep -q "\"$1\": $2,\?$" audit/summary.json || fail "$1 is not $2: $(cat audit/summary.json)"; }

# What is hidden may be culled. What was drawn though it is hidden is counted.
echo "{\"frame\":0,$eye,\"culled\":[[1,63]]}" >hidden.jsonl
judge good.ply hidden.jsonl 0
judged proved_hidden 63
judged unsettled 0
judged needless 0
echo "{\"frame\":0,$eye,\"culled\":[[1,13]]}" >few.jsonl
judge good.ply few.jsonl 0
judged proved_hidden 13
judged drawn 51
judged needless 50

# The wall is not hidden. The ray goes from the eye to it, through a pixel of the picture.
echo "{\"frame\":0,$eye,\"culled\":[[0,64]]}" >wall.jsonl
judge good.ply wall.jsonl 1
grep -qE '^\{"frame":0,"polygon":0,"eye":\[0.0,0.0,0.0\],"through":\[2.0,[-.0-9e]+,[-.0-9e]+\],"pixel":\[[0-9]+,[0-9]+\],"picture":"false_culls_000000.png"\}$' \
  audit/false_culls.jsonl || fail "the wall: $(cat audit/false_culls.jsonl)"
grep -q '^the first false cull: {"frame":0,"polygon":0,' stderr || fail "the wall was not told: $(cat stderr)"
[ -s audit/false_culls_000000.png ] || fail "no picture of the wall"
grep -q '^{"frame":0,"culled":64,"proved_hidden":63,"false_culls":1,"unsettled":0,"drawn":0,"needless":0}$' audit/frames.jsonl ||
  fail "frames.jsonl: $(cat audit/frames.jsonl)"
judge good.ply hidden.jsonl 0
[ ! -e audit/false_culls_000000.png ] || fail "the picture of an earlier audit stays"
"$occlude" audit good.ply --log wall.jsonl --quiet >stdout 2>stderr
[ $? -eq 1 ] && [ ! -s stdout ] || fail "--quiet: $(cat stdout stderr)"

# The same frame in other words.
row='-0.974278579257493,0,0'
matrix="\"matrix\":[0,$row,0,0,1.7320508075688772,0,1,0,0,-0.2,1,0,0,0],\"order\":\"row\",\"width\":320,\"height\":180"
column='"matrix":[0,0,1,1,-0.974278579257493,0,0,0,0,1.7320508075688772,0,0,0,0,-0.1,0],"clip_depth":"zero_to_w","width":320,"height":180'
parallel='"eye":[0,0,0],"target":[1,0,0],"projection":"orthographic","view_height":2,"width":320,"height":180'
objects='{"object":7,"polygons":[0]}\n{"object":4294967294,"polygons":[[1,60],61,62,63]}\n'
for camera in "$eye" "$matrix" "$column" "$parallel" "$eye,\"up\":[0,1,2],\"fov_y_deg\":30,\"near\":0.5,\"far\":100"; do
  printf '%b' "{\"frame\":3,$camera,\"drawn\":[0]}\n" >same.jsonl
  judge good.ply same.jsonl 0
  printf '%b' "{\"frame\":3,$camera,\"drawn\":[[1,63]]}\n" >same.jsonl
  judge good.ply same.jsonl 1
  printf '%b' "$objects{\"frame\":3,$camera,\"culled_objects\":[4294967294]}\n" >same.jsonl
  judge good.ply same.jsonl 0
  printf '%b' "$objects{\"frame\":3,$camera,\"drawn_objects\":[4294967294]}\n" >same.jsonl
  judge good.ply same.jsonl 1
  grep -q '"polygon":0,"object":7,' audit/false_culls.jsonl || fail "no object: $(cat audit/false_culls.jsonl)"
done
judge good.ply <(cat wall.jsonl) 1
gzip -k wall.jsonl
judge good.ply wall.jsonl.gz 1
# From a pipe whose first bytes come one by one, and padded as on a tape.
judge good.ply <(head -c 1 wall.jsonl.gz; sleep 0.3; tail -c +2 wall.jsonl.gz; head -c 512 /dev/zero) 1
"$occlude" audit good.ply --log - <wall.jsonl >stdout 2>stderr
[ $? -eq 1 ] || fail "standard input: $(cat stderr)"

# A log that an engine writes, of frames by matrix, by eye and of objects.
"$example" || fail "the example cannot write its log"
judge wall.ply culled.log 0
judged frames 6
judged proved_hidden 378
gzip -k culled.log
judge wall.ply culled.log.gz 0
# Its first byte that tells what is listed: from culled to drawn.
{ head -c 24 culled.log; printf '\1'; tail -c +26 culled.log; } >forged.log
judge wall.ply forged.log 1

# A small thing behind a slit of a wall, smaller than a pixel by far: 2^-10 across at a distance of 128, in pictures of which a
# pixel is 0.8 there. Through the slit show 9 % of it, and not its middle.
slit='2 -2 -2\n2 LOW -2\n2 LOW 2\n2 -2 2\n2 HIGH -2\n2 2 -2\n2 2 2\n2 HIGH 2\n'
thing='128 -0.0009765625 -0.001\n128 0.0009765625 -0.001\n128 0.0009765625 0.001\n128 -0.0009765625 0.001\n'
faces='4 0 1 2 3\n4 4 5 6 7\n4 8 9 10 11\n'
slit_from_to() { sed "s/LOW/$1/g; s/HIGH/$2/g" <<<"$slit"; }
ply slit.ply 12 3 "$(slit_from_to 0.000005 0.0000078)$thing$faces"
echo "{\"frame\":0,$eye,\"culled\":[2]}" >slit.jsonl
judge slit.ply slit.jsonl 1 --item-buffers 0
judge slit.ply slit.jsonl 1
# Without the slit, and with a slit beside it.
ply slit.ply 12 3 "$(slit_from_to 0.000005 0.000005)$thing$faces"
judge slit.ply slit.jsonl 0
ply slit.ply 12 3 "$(slit_from_to 0.1 0.2)$thing$faces"
judge slit.ply slit.jsonl 0

# What only touches is not claimed: a thing in the plane of the wall, one that ends at the edge of its shadow, a second wall at
# the same place. Where all at a place are culled, they are.
walls='2 -1 -1\n2 1 -1\n2 1 1\n2 -1 1\n2 -.5 -.5\n2 .5 -.5\n2 .5 .5\n2 -.5 .5\n4 0 2\n4 2 2\n4 2 0\n4 0 0\n2 -1 -1\n2 1 -1\n2 1 1\n2 -1 1\n'
ply touching.ply 16 4 "$walls"'4 0 1 2 3\n4 4 5 6 7\n4 8 9 10 11\n4 12 13 14 15\n'
echo "{\"frame\":0,$eye,\"culled\":[[1,3]]}" >touching.jsonl
judge touching.ply touching.jsonl 0
echo "{\"frame\":0,$eye,\"culled\":[0,1,3]}" >touching.jsonl
judge touching.ply touching.jsonl 3
# What shows of a thing that is larger than the shadow by an ulp is too narrow for any ray: it is unsettled.
sed 's/^4 2 0$/4 2.0000000000000004 0/' touching.ply >larger.ply
echo "{\"frame\":0,$eye,\"culled\":[2]}" >larger.jsonl
judge larger.ply larger.jsonl 0
judged unsettled 1
sed 's/^4 2 0$/4 2.001 0/' touching.ply >larger.ply
judge larger.ply larger.jsonl 1 --item-buffers 0

# What shows through a small window, of a picture that covers it but for that. Rays into all of it miss the window; item buffers
# show it.
window='2.005 -.9 -.9\n2.005 .9 -.9\n2.005 .9 .9\n2.005 -.9 .9\n'
rectangle() { printf '2 %s %s\\n2 %s %s\\n2 %s %s\\n2 %s %s\\n' "$1" "$3" "$2" "$3" "$2" "$4" "$1" "$4"; } # from, to: y, z
window+="$(rectangle -1 1 -.66 1)$(rectangle -1 1 -1 -.73)$(rectangle -1 .13 -.73 -.66)$(rectangle .19 1 -.73 -.66)"
ply window.ply 20 5 "$window"'4 0 1 2 3\n4 4 5 6 7\n4 8 9 10 11\n4 12 13 14 15\n4 16 17 18 19\n'
for camera in "$eye" "$matrix" "$column"; do
  echo "{\"frame\":0,$camera,\"culled\":[0]}" >window.jsonl
  judge window.ply window.jsonl 0 --item-buffers 0
  judged unsettled 1
  judge window.ply window.jsonl 1
done

# A window in the lower part of a wall that lies in one plane with the thing. A picture may show the thing all over it: its first
# pixels, which are above the window, do not tell.
wall_with_window="$(rectangle -1 1 -1 1)$(rectangle -1 1 -.4 1)$(rectangle -1 1 -1 -.9)$(rectangle -1 -.9 -.9 -.4)$(rectangle .9 1 -.9 -.4)"
ply plane.ply 20 5 "$wall_with_window"'4 0 1 2 3\n4 4 5 6 7\n4 8 9 10 11\n4 12 13 14 15\n4 16 17 18 19\n'
echo '{"frame":0,"eye":[0,0,0],"target":[1,0,0],"width":284,"height":160,"culled":[0]}' >plane.jsonl
judge plane.ply plane.jsonl 0 --rays 0 --item-buffers 0
judge plane.ply plane.jsonl 1 --rays 0

# What is before the near plane hides nothing; what is out of the picture is not seen.
echo "{\"frame\":0,$eye,\"near\":2.5,\"culled\":[0]}" >near.jsonl
judge good.ply near.jsonl 0
echo "{\"frame\":0,$eye,\"near\":2.5,\"culled\":[[0,64]]}" >near.jsonl
judge good.ply near.jsonl 1
grep -q '"polygon":1,' audit/false_culls.jsonl || fail "beyond the near plane: $(cat audit/false_culls.jsonl)"
echo '{"frame":0,"eye":[0,0,0],"target":[-1,0,0],"width":320,"height":180,"culled":[[0,64]]}' >back.jsonl
judge good.ply back.jsonl 0
judged culled 0

# A near plane just before the wall, and an oblique one that is nearer on the left: the wall is in their pictures.
for slant_and_end in "0 -3.98" "0.3 -3.6"; do
  near="0,0,1,1,-0.974278579257493,0,${slant_and_end% *},0,0,1.7320508075688772,0,0,0,0,${slant_and_end#* },0"
  echo "{\"frame\":0,\"matrix\":[$near],\"width\":640,\"height\":360,\"culled\":[0]}" >near.jsonl
  judge window.ply near.jsonl 1
done

# So it is beyond the far plane, and beside the picture where the box of a thing is not.
echo "{\"frame\":0,$eye,\"far\":1.5,\"culled\":[0]}" >far.jsonl
judge good.ply far.jsonl 0
ply beside.ply 3 2 '10 9 9\n10 30 4\n10 30 30\n3 0 1 2\n3 2 1 0\n'
echo "{\"frame\":0,$eye,\"culled\":[0,1]}" >beside.jsonl
judge beside.ply beside.jsonl 0
judged culled 0

# A wall in pieces is one polygon. What is behind its doorway shows; what is beside the doorway does not.
{
  printf 'v 0 %s\n' '-10 0' '-2 0' '-2 4' '2 4' '2 0' '10 0' '10 6' '-10 6'
  printf 'v %s\n' '20 -1 0.5' '20 1 0.5' '20 1 3' '20 -1 3' '20 8 0.5' '20 9 0.5' '20 9 3' '20 8 3'
  printf 'f %s\n' '1 2 3 4 5 6 7 8' '9 10 11 12' '13 14 15 16'
} >doorway.obj
{
  printf 'mtllib glass.mtl\nusemtl glass\n'
  sed 's/^f 1 2 3 4 5 6 7 8/f 1 6 7 8\nusemtl other/' doorway.obj
} >glass.obj
printf 'newmtl glass\nd 0.3\n' >glass.mtl
door='"eye":[-20,0,1.5],"target":[20,0,1.5],"width":320,"height":180'
echo "{\"frame\":0,$door,\"drawn\":[[0,2]]}" >door.jsonl
judge doorway.obj door.jsonl 0
judge glass.obj door.jsonl 1
judge glass.obj door.jsonl 0 --opaque-all
echo "{\"frame\":0,$door,\"drawn\":[[1,2]]}" >door.jsonl
judge doorway.obj door.jsonl 1
judge glass.obj door.jsonl 1
echo "{\"frame\":0,$door,\"drawn\":[0,2]}" >door.jsonl
judge doorway.obj door.jsonl 1

# What occlude culls on a walk is hidden.
"$occlude" generate city --polygons 20000 --seed 5 --out city.ply --path city.json >/dev/null || fail "generate"
for options in "--method cover" "--method frusta" "--hold 2"; do
  # shellcheck disable=SC2086
  "$occlude" walk city.ply --path city.json --frames 0:60:20 --no-render $options --out walked --log walk.jsonl >/dev/null || fail "walk $options"
  judge city.ply walk.jsonl 0
  judged frames 3
  judged culled '[1-9][0-9]*'
done
"$occlude" preprocess city.ply --out city.pre >/dev/null || fail "preprocess"
judge city.pre walk.jsonl 0
# A store is judged polygon by polygon, too, though its leaves are larger. What is settled in it cannot be asked for.
"$occlude" preprocess good.ply --leaf 64 --out good.pre >/dev/null || fail "preprocess"
judge good.pre hidden.jsonl 0
judged proved_hidden 63
for option in "--up y" "--unit cm" "--opaque-all"; do
  # shellcheck disable=SC2086
  expect_error "${option% *}: good.pre is a store" "$occlude" audit good.pre --log hidden.jsonl $option
done

# Logs that cannot be read are named with the line, or the record.
bad() { # bad TEXT LINE: a log of two frames, of which the second is this line
  printf '%s\n%s\n' "{\"frame\":0,$eye,\"culled\":[]}" "$2" >bad.jsonl
  expect_error "bad.jsonl:2: $1" "$occlude" audit good.ply --log bad.jsonl --out bad
}
bad '' '{'
bad '' 'frame 1'
bad '' '[1]'
bad 'polygons 64 to 64: the model has 64' "{\"frame\":1,$eye,\"culled\":[64]}"
bad 'polygons 60 to 64: the model has 64' "{\"frame\":1,$eye,\"culled\":[[60,5]]}"
bad 'the range [5, 0] is empty' "{\"frame\":1,$eye,\"culled\":[[5,0]]}"
bad '"culled": expected whole numbers' "{\"frame\":1,$eye,\"culled\":[-1]}"
bad '"culled": expected whole numbers' "{\"frame\":1,$eye,\"culled\":[[0,4294967296]]}"
bad '"culled": expected numbers and ranges' "{\"frame\":1,$eye,\"culled\":[[0,1,2]]}"
bad '"drawn": expected an array' "{\"frame\":1,$eye,\"drawn\":5}"
bad 'frame 0 is there twice' "{\"frame\":0,$eye,\"culled\":[]}"
bad 'unknown member "cull"' "{\"frame\":1,$eye,\"cull\":[]}"
bad 'unknown member "fov_y_deg"' "{\"frame\":1,$matrix,\"fov_y_deg\":60,\"culled\":[]}"
bad 'expected one of culled, drawn' "{\"frame\":1,$eye}"
bad 'expected one of culled, drawn' "{\"frame\":1,$eye,\"culled\":[],\"drawn\":[]}"
bad '"width" is missing' '{"frame":1,"eye":[0,0,0],"target":[1,0,0],"height":180,"culled":[]}'
bad 'width and height must be from 1' "{\"frame\":1,${eye/320/0},\"culled\":[]}"
bad 'the camera: ' "{\"frame\":1,${eye/1,0,0/0,0,0},\"culled\":[]}"
bad 'the camera: ' "{\"frame\":1,$eye,\"near\":0,\"culled\":[]}"
bad 'the camera: ' "{\"frame\":1,${matrix/1.7320508075688772/0},\"culled\":[]}"
bad '"matrix": expected 16 numbers' '{"frame":1,"matrix":[1],"width":320,"height":180,"culled":[]}'
bad 'the matrix has parallel rays' '{"frame":1,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],"width":320,"height":180,"culled":[]}'
bad 'the matrix: its eye is too far away' "{\"frame\":1,${matrix/0,-0.2,1,0,0,0/0,-1.0000000001e20,1,0,0,-1e20},\"culled\":[]}"
bad '"view_height": expected' "{\"frame\":1,$eye,\"view_height\":2,\"culled\":[]}"
bad '"fov_y_deg": an orthographic' "{\"frame\":1,$parallel,\"fov_y_deg\":60,\"culled\":[]}"
bad '"order": expected "column" or "row"' "{\"frame\":1,${matrix/\"row\"/\"rows\"},\"culled\":[]}"
bad 'it lists polygons twice' "{\"frame\":1,$eye,\"culled\":[[0,64],0]}"
bad 'no object 5' "{\"frame\":1,$eye,\"culled_objects\":[5]}"
bad 'polygons 64 to 64' '{"object":5,"polygons":[64]}'
bad 'unknown member "name"' '{"object":5,"name":"a","polygons":[]}'
bad 'polygon 3 belongs to object 5 already' '{"object":5,"polygons":[3,3]}'
printf '%b' "$objects{\"frame\":1,$eye,\"culled_objects\":[7,7]}\n" >bad.jsonl
expect_error 'bad.jsonl:3: it lists object 7 twice' "$occlude" audit good.ply --log bad.jsonl
printf '%b{"object":7,"polygons":[]}\n' "$objects" >bad.jsonl
expect_error 'bad.jsonl:3: object 7 is there twice' "$occlude" audit good.ply --log bad.jsonl
printf '%b' "$objects" >bad.jsonl
expect_error 'bad.jsonl: no frames' "$occlude" audit good.ply --log bad.jsonl
: >bad.jsonl
expect_error 'bad.jsonl: no frames' "$occlude" audit good.ply --log bad.jsonl
expect_error 'missing.jsonl' "$occlude" audit good.ply --log missing.jsonl
expect_error 'missing.ply' "$occlude" audit missing.ply --log wall.jsonl
: >file
expect_error 'file' "$occlude" audit good.ply --log wall.jsonl --out file
expect_error '--cover-size' "$occlude" audit good.ply --log wall.jsonl --cover-size 9

# Logs that are cut off anywhere but between two records, and others that are damaged.
head -c 30 wall.jsonl.gz >cut.jsonl.gz
expect_error 'cut.jsonl.gz: the compressed data are cut off' "$occlude" audit good.ply --log cut.jsonl.gz --out cut
for bytes in 1 7 9 30 $(($(stat -c %s culled.log) - 1)); do
  head -c "$bytes" culled.log >cut.log
  expect_error "cut.log: record" "$occlude" audit wall.ply --log cut.log --out cut
done
head -c 8 culled.log >cut.log
expect_error "cut.log: no frames" "$occlude" audit wall.ply --log cut.log
{ head -c 8 culled.log; printf '\11\0\0\0'; } >kind.log
expect_error "kind.log: record 1: no kind of record: 9" "$occlude" audit wall.ply --log kind.log
{ head -c 24 culled.log; printf '\7'; tail -c +26 culled.log; } >what.log
expect_error "what.log: record 1: what is listed" "$occlude" audit wall.ply --log what.log
# Lists that are longer than the model, or than there are objects: no more of them is read. An empty range.
u32() { printf '%b' "$(printf '\\x%02x' $(($1 & 255)) $((($1 >> 8) & 255)) $((($1 >> 16) & 255)) $(($1 >> 24)))"; }
list_of() { # list_of WHAT NUMBER...: the first frame of the log, to its list, and these numbers
  head -c 24 culled.log
  u32 "$1"
  tail -c +29 culled.log | head -c 132
  for number in "${@:2}"; do u32 "$number"; done
}
list_of 0 65 >long.log
expect_error "long.log: record 1: it lists 65 ranges of polygons: there are 64" "$occlude" audit wall.ply --log long.log
list_of 2 1 >long.log
expect_error "long.log: record 1: it lists 1 objects: there are 0" "$occlude" audit wall.ply --log long.log
{ printf 'OCCLLOG1'; u32 3; u32 7; u32 65; } >long.log
expect_error "long.log: record 1: it lists 65 ranges of polygons" "$occlude" audit wall.ply --log long.log
list_of 0 2 1 1 5 0 >empty.log
expect_error "empty.log: record 1: the range [5, 0] is empty" "$occlude" audit wall.ply --log empty.log
expect_error "OCCLLOG1" "$occlude" audit wall.ply --log <(echo 'OTHER')

finish
