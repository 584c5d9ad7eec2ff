#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# `occlude bake`: visible sets are what they should be, and nothing is left out that is seen.
# Usage: bake_test.sh PATH_OF_OCCLUDE PATH_OF_THE_EXAMPLE_THAT_READS_SETS PATH_OF_BAKE_RAYS FOLDER_OF_EXAMPLES
set -uo pipefail
example=$(realpath "$2") rays=$(realpath "$3") examples=$(realpath "$4") pixels=$(realpath "$(dirname "$0")/png_pixels.py")
. "$(dirname "$0")/common.sh"

# A closed room of 8 by 6 by 3: floor 0, ceiling 1, walls 2 to 5. In its middle, at x = 4, a wall with a door from y = 2 to 3,
# 2 high: 6, 7 and 8 above the door. A thing beside the door, 9, and one behind it, 10, both far from it; one on this side
# beside it, 11; and one outside, 12, behind a wall of its own corners, 5.
room='0 0 0\n8 0 0\n8 6 0\n0 6 0\n0 0 3\n8 0 3\n8 6 3\n0 6 3\n'
wall='4 0 0\n4 2 0\n4 2 3\n4 0 3\n4 3 0\n4 6 0\n4 6 3\n4 3 3\n4 2 2\n4 3 2\n'
thing() { printf '%s' "$1 $2 1\n$1 $3 1\n$1 $3 1.3\n$1 $2 1.3\n"; } # thing X Y0 Y1
end='8 -1 -1\n8 7 -1\n8 7 4\n8 -1 4\n'
things="$(thing 7.5 .1 .3)$(thing 7.5 2 3)$(thing .2 .1 .3)$(thing 20 2 3)"
faces='4 0 1 2 3\n4 4 5 6 7\n4 0 1 5 4\n4 3 2 6 7\n4 0 3 7 4\n4 34 35 36 37\n4 8 9 10 11\n4 12 13 14 15\n4 16 17 15 10\n'
faces+='4 18 19 20 21\n4 22 23 24 25\n4 26 27 28 29\n4 30 31 32 33\n'
ply door.ply 38 13 "$room$wall$things$end$faces"

# One cell on this side before the door, and two on the other: beside the door and before it. They are not in the order of the
# file.
here_='{"min":[0.5,2,1],"max":[1,3,2]}' beside='{"min":[6,0.2,1],"max":[7,0.6,2]}' before='{"min":[6,2,1],"max":[7,3,2]}'
echo "{\"cells\":[$before,$here_,$beside]}" >cells.json
"$occlude" bake door.ply --cells cells.json --out door.pvs --json >told 2>stderr || fail "bake: $(cat stderr)"
grep -q '"cells": 3,' told && grep -q '"items": 13,' told && grep -q '"seen": 34,' told && grep -q '"most": 12,' told || fail "told: $(cat told)"
grep -q "\"bytes\": $(stat -c %s door.pvs)," told || fail "the size: $(cat told)"

readers=("$example" "python3 -B $examples/print_visible_sets.py")
if command -v node >/dev/null; then readers+=("node $examples/print_visible_sets.mjs"); else echo "No node: its reader is not tried"; fi
wc -l "$examples"/visible_sets.* | awk '$2 != "total" && $1 >= 100 { print; exit 1 }' || fail "readers of a hundred lines"
# same_in_all FILE EYE: all readers print the same.
same_in_all() {
  for reader in "${readers[@]}"; do
    # shellcheck disable=SC2086
    $reader "$1" $2 >seen 2>stderr || fail "$reader: $(cat stderr)"
    [ "$reader" = "$example" ] && cp seen seen_first
    cmp seen_first seen || fail "$1 from $2: $reader reads something else"
  done
}
# refused FILE: no reader reads it.
refused() {
  for reader in "${readers[@]}"; do
    # shellcheck disable=SC2086
    timeout 100 $reader "$1" .7 2.5 1.5 >stdout 2>stderr
    [ $? -eq 2 ] && grep -q 'no visible sets, or damaged' stderr || fail "$reader $1: $(cat stdout stderr)"
  done
}
# sees FILE EYE EXPECTED: what all readers print.
sees() {
  # shellcheck disable=SC2086
  for reader in "${readers[@]}"; do
    $reader "$1" $2 >seen 2>stderr || fail "$reader: $(cat stderr)"
    [ "$(tr '\n' ';' <seen)" = "$3" ] || fail "$1 from $2: $(cat seen)"
  done
}
sees door.pvs '.7 2.5 1.5' 'cell 0;items 0 1 2 3 4 5 6 7 8 10 11;cells 0 2;'
sees door.pvs '6 .2 1' 'cell 1;items 0 1 2 3 4 5 6 7 8 9 10;cells 1 2;'
sees door.pvs '7 3 2' 'cell 2;items 0 1 2 3 4 5 6 7 8 9 10 11;cells 0 1 2;'
for eye in '4 2.5 1.5' '6.5 1 1.5' '.7 2.5 2.1' '-1 0 0' '9 0 0'; do sees door.pvs "$eye" 'in no cell;'; done

# What the sets lack is proved: 13 polygons for each of three cells, of which 34 are seen.
"$occlude" bake door.ply --cells cells.json --out again.pvs --witness door.jsonl >/dev/null || fail "--witness"
cmp door.pvs again.pvs || fail "--witness changes the sets"
proves door.ply door.jsonl 5
[ "$(grep -c claim door.jsonl)" -eq 3 ] || fail "claims: $(grep claim door.jsonl)"
finds_lie door.ply door.jsonl 'a polygon' 's/"hidden":\[9\]/"hidden":[7]/'
finds_lie door.ply door.jsonl 'one more polygon' '/claim/s/\[9,1\]/[8,2]/'
finds_lie door.ply door.jsonl 'what hides' 's/"polygons":\[[0-9]*/"polygons":[0/'
finds_lie door.ply door.jsonl 'a cell' '/claim/s/"max":\[1,3,2\]/"max":[1,3.001,2]/'
finds_lie door.ply door.jsonl 'a piece' '/hidden/s/"from":{"min":\[0.5,/"from":{"min":[0.4,/'
finds_lie door.ply door.jsonl 'where windows are' 's/"rect":\[[-0-9.e]*,/"rect":[1e9,/'
grep -v '"hidden":\[12\]' door.jsonl >lie.jsonl
"$occlude" validate door.ply --witness lie.jsonl >stdout 2>stderr
[ $? -eq 1 ] && grep -q 'lie.jsonl:[123]: polygon 12 is not proved to be hidden from all of box 0' stderr || fail "what is left out: $(cat stdout stderr)"
sed '2s/"claim":\[/"claim":[[99,1],/' door.jsonl >lie.jsonl
expect_error 'lie.jsonl:2: "claim"' "$occlude" validate door.ply --witness lie.jsonl
expect_error '--path: is for witnesses of a walk' "$occlude" validate door.ply --path path.json --witness door.jsonl
# A share of the cells, cells of many pieces, points, flat cells, and objects.
"$occlude" bake door.ply --cells cells.json --out again.pvs --witness door.jsonl --witness-share 0.4 >/dev/null || fail "--witness-share"
[ "$(grep -c claim door.jsonl)" -eq 1 ] || fail "a share of the claims: $(grep claim door.jsonl)"
proves door.ply door.jsonl 1
"$occlude" bake door.ply --cells cells.json --piece 0.3 --out again.pvs --witness door.jsonl >/dev/null || fail "pieces"
proves door.ply door.jsonl "$((39 - $("$example" again.pvs .7 2.5 1.5 | sed -n '2p' | wc -w) - $("$example" again.pvs 6 .2 1 | sed -n '2p' | wc -w) - $("$example" again.pvs 7 3 2 | sed -n '2p' | wc -w) + 3))"
[ "$(grep -c hidden door.jsonl)" -gt 20 ] || fail "proofs of pieces: $(grep -c hidden door.jsonl)"
number=$(grep -n '"from":{"min":\[0.5,2,1\]' door.jsonl | head -1 | cut -d: -f1)
sed "${number:-1}d" door.jsonl >lie.jsonl
"$occlude" validate door.ply --witness lie.jsonl >stdout 2>stderr
[ $? -eq 1 ] && grep -q 'is not proved to be hidden from all of box 0' stderr || fail "a piece is left out: $(cat stdout stderr)"

# With a wall before all of that wall each side sees itself alone, and both, which are in one plane.
ply closed.ply 42 13 "$room$wall$things$end${end//8 /4 }${faces/4 8 9 10 11/4 38 39 40 41}"
"$occlude" bake closed.ply --cells cells.json --out closed.pvs >/dev/null || fail "closed"
sees closed.pvs '.7 2.5 1.5' 'cell 0;items 0 1 2 3 4 6 7 8 11;cells 0;'
sees closed.pvs '6.5 .5 1.5' 'cell 1;items 0 1 2 3 5 6 7 8 9 10;cells 1 2;'

# Objects: 0 is the room, 1 what is outside, 2 and 3 are things. Of cells, an object is seen where one polygon is.
echo '{"objects":[[[0,9]],[12],[9,11],[10]]}' >objects.json
"$occlude" bake door.ply --cells cells.json --objects objects.json --out objects.pvs >/dev/null || fail "objects"
sees objects.pvs '.7 2.5 1.5' 'cell 0;items 0 2 3;cells 0 2;'
echo '{"objects":[[9],[12],[10]]}' >objects.json
"$occlude" bake door.ply --cells cells.json --objects objects.json --out objects.pvs >/dev/null || fail "objects"
sees objects.pvs '.7 2.5 1.5' 'cell 0;items 2;cells 0 2;'
sees objects.pvs '6.5 .5 1.5' 'cell 1;items 0 2;cells 1 2;'
"$occlude" bake door.ply --cells cells.json --objects objects.json --out objects.pvs --witness objects.jsonl >/dev/null || fail "objects: --witness"
proves door.ply objects.jsonl 4

# A point, and a cell that is flat.
echo '{"cells":[{"min":[1,1,1],"max":[1,1,1]},{"min":[6,0.2,1],"max":[7,0.6,1]}]}' >flat.json
"$occlude" bake door.ply --cells flat.json --out flat.pvs >/dev/null || fail "flat"
sees flat.pvs '1 1 1' 'cell 0;items 0 1 2 3 4 5 6 7 8 11;cells 0;'
sees flat.pvs '6.5 .5 1' 'cell 1;items 0 1 2 3 4 5 6 7 8 9 10;cells 1;'
"$occlude" bake door.ply --cells flat.json --out flat.pvs --witness flat.jsonl >/dev/null || fail "flat: --witness"
proves door.ply flat.jsonl 5
finds_lie door.ply flat.jsonl 'an eye' 's/"eye":\[1,1,1\]/"eye":[1,1,1.5]/'

# Grids and corridors: cubes, or one layer. Rays into what is in no set, and in all directions.
clear() { "$rays" "$@" >rays || fail "rays: $(cat rays)"; }
clear door.ply door.pvs 20000 9
clear closed.ply closed.pvs 20000 9
clear door.ply flat.pvs 20000 9
# What is seen through glass, and behind which there is a wall that is seen: the rays find that it is missing in the sets of a
# model where a plate stands before it.
behind_plate() { # behind_plate FILE X: with the plate at X
  {
    printf 'mtllib glass.mtl\n%b' "$room" | sed '2,$s/^/v /'
    printf 'v %s\n' '7.5 2.4 1.4' '7.5 2.6 1.4' '7.5 2.6 1.6' '7.5 2.4 1.6' "$2 2 1" "$2 3 1" "$2 3 2" "$2 2 2"
    printf 'f %s\n' '1 2 3 4' '5 6 7 8' '1 2 6 5' '4 3 7 8' '1 4 8 5' '2 3 7 6' '13 14 15 16'
    printf 'usemtl glass\nf 9 10 11 12\n'
  } >"$1"
}
printf 'newmtl glass\nd 0.5\n' >glass.mtl
behind_plate hidden.obj 7.4
behind_plate open.obj 20
echo '{"cells":[{"min":[1,2.5,1.5],"max":[1,2.5,1.5]}]}' >eye.json
"$occlude" bake hidden.obj --cells eye.json --out hidden.pvs >/dev/null || fail "glass"
sees hidden.pvs '1 2.5 1.5' 'cell 0;items 0 1 2 3 4 5 6;cells 0;'
clear hidden.obj hidden.pvs 20000 9
"$rays" open.obj hidden.pvs 20000 9 >rays
[ $? -eq 1 ] && grep -q 'cell 0 sees polygon 7 ' rays || fail "the rays do not find glass: $(cat rays)"
"$occlude" bake door.ply --cells grid --cell-size 2 --out grid.pvs --json >told || fail "grid"
grep -q '"cells": 150,' told || fail "cells of a grid: $(cat told)" # 10 by 5 by 3: those that the model only touches are none
clear door.ply grid.pvs 500 150
echo '{"frames":4,"keyframes":[{"eye":[1,2.5,1.5],"target":[2,2.5,1.5]},{"eye":[6,2.5,1.5],"target":[7,2.5,1.5]}]}' >path.json
"$occlude" bake door.ply --cells corridor --path path.json --cell-size 1 --heights 1:2 --reach 0 --out way.pvs --json >told || fail "corridor"
grep -q '"cells": 5,' told || fail "cells of a corridor: $(cat told)" # from x = 1 to 6
clear door.ply way.pvs 20000 9
sees way.pvs '5.5 2.5 2' 'cell 4;items 0 1 2 3 4 5 6 7 8 9 10 11;cells 0 1 2 3 4;'
# A way across a corner between four cells, and what is within reach.
two='{"frames":2,"keyframes":[{"eye":[0.5,0.52,1.5],"target":[4,0.52,1.5]},{"eye":[1.5,1.52,1.5],"target":[4,1.52,1.5]}]}'
echo "$two" >two.json
"$occlude" bake door.ply --cells corridor --path two.json --cell-size 1 --heights 1:2 --reach 0 --out two.pvs >/dev/null || fail "corner"
"$example" two.pvs .99 1.01 1.5 | grep -q '^cell' || fail "a hole in a corridor"
"$occlude" bake door.ply --cells corridor --path path.json --cell-size 1 --heights 1:2 --reach 1 --out reach.pvs --json >told || fail "--reach"
grep -q '"cells": 21,' told || fail "cells within reach: $(cat told)" # from x = 0 to 7, and from y = 1 to 4
clear door.ply reach.pvs 2000 21
# 1.918 / 0.001 is rounded to 1918, and 1918 * 0.001 to more than 1.918.
ply small.ply 3 1 '1.918 0 0\n1.92 0 0\n1.92 0.002 0.0005\n3 0 1 2\n'
"$occlude" bake small.ply --cells grid --cell-size 0.001 --out small.pvs >/dev/null || fail "small"
sees small.pvs '1.918 0 0' 'cell 0;items 0;cells 0 1 2 3 4 5;'
"$occlude" generate city --polygons 20000 --seed 5 --out city.ply --path whole.json >/dev/null || fail "generate"
# The first of its keyframes, which have a line each.
{ sed -n '1s/2748/20/p; 2,9p' whole.json; sed -n '10s/,$/]}/p' whole.json; } >city.json
"$occlude" bake city.ply --cells corridor --path city.json --cell-size 4 --reach 0 --heights 1:3 --out city.pvs >/dev/null || fail "city"
clear city.ply city.pvs 2000 20
"$occlude" bake city.ply --cells corridor --path city.json --cell-size 4 --reach 0 --heights 1:3 --out again.pvs --witness city.jsonl \
  --witness-share 0.2 --json >told || fail "city: --witness"
"$occlude" validate city.ply --witness city.jsonl --json >stdout 2>stderr || fail "city: validate: $(cat stdout stderr)"
grep -qE '"pairs": [1-9][0-9]{4,},' stdout || fail "city: pairs: $(cat stdout)"
grep -q ' 0 reach' rays || fail "$(cat rays)"
# All readers read the same, of numbers of two bytes too, and one cell of another as its set.
cat >middles.py <<'END'
import struct, sys
from visible_sets import VisibleSets
sets = VisibleSets(sys.argv[1])
for cell in range(0, sets.cells, max(sets.cells // 5, 1)):
    box = sets.box(cell)
    print(*((box[i] + box[i + 3]) / 2 for i in range(3)))
    for other in range(sets.cells):
        assert sets.visible(cell, other) == (other in sets.visible_cells(cell))
for call in sets.box, sets.visible, sets.visible_cells, lambda cell: sets.visible(0, cell), lambda cell: sets.visible(cell, 0):
    for cell in -1, sets.cells:
        try:
            call(cell)
            print("a cell that there is not:", cell)
        except IndexError:
            pass
value = 0xCBF29CE484222325
for byte in open(sys.argv[2], "rb").read():
    value = (value ^ byte) * 0x100000001B3 % 2**64
assert sets.model == value, "the hash of the model"
END
PYTHONPATH=$examples python3 -B middles.py city.pvs city.ply >middles || fail "the Python reader"
[ "$(wc -l <middles)" -ge 5 ] || fail "cells of the city: $(cat middles)"
while read -r eye; do same_in_all city.pvs "$eye"; done <middles
[ "$(tr ' ' '\n' <seen | sort -n | tail -1)" -gt 127 ] || fail "no numbers of two bytes"
if command -v node >/dev/null; then
  cat >pairs.mjs <<END
import {readFileSync} from 'node:fs'
import {VisibleSets} from '$examples/visible_sets.mjs'
const sets = new VisibleSets(new Uint8Array(readFileSync('city.pvs')).buffer)
for (let other = 0; other < sets.cells; ++other) {
  if (sets.visible(1, other) !== sets.visibleCells(1).includes(other)) throw new Error('visible(1, ' + other + ')')
}
for (const call of [() => sets.visible(sets.cells), () => sets.visible(0, -1), () => sets.box(0.5), () => sets.visibleCells(NaN)]) {
  try { call() } catch (error) { if (error instanceof RangeError) continue }
  throw new Error('a cell that there is not')
}
END
  node pairs.mjs 2>stderr || fail "the JavaScript reader: $(cat stderr)"
fi

# The rays find what is wrong: in the sets of the closed door, with the door open.
"$rays" door.ply closed.pvs 20000 9 >rays
[ $? -eq 1 ] && grep -q 'cell 0 sees polygon 10 ' rays && grep -q 'cell 0 sees cell 2 ' rays || fail "the rays do not find a wrong set: $(cat rays)"

# Parts that are kept change no byte, nor does a run that goes on with those of one that was killed, nor do ranks.
long=(bake door.ply --cells grid --cell-size 1)
has_parts() { [ "$(ls kept 2>/dev/null | grep -c '^part-')" -ge 2 ]; } # two parts are finished
"$occlude" "${long[@]}" --parts kept --out killed.pvs >/dev/null 2>stderr &
await has_parts
{ kill -KILL $! && wait $!; } 2>/dev/null
has_parts && [ ! -e killed.pvs ] || fail "killed: $(ls kept killed.pvs)"
expect_error "kept: has finished parts of an earlier run" "$occlude" "${long[@]}" --parts kept --out killed.pvs
expect_error "kept: has parts of another run" "$occlude" "${long[@]}" --piece 5 --parts kept --resume --out killed.pvs
"$occlude" "${long[@]}" --parts kept --resume --out resumed.pvs >/dev/null || fail "--resume"
[ ! -e kept ] || fail "parts are left behind: $(ls kept)"
"$occlude" "${long[@]}" --out one.pvs >one || fail "bake"
cmp one.pvs resumed.pvs || fail "--resume: the bytes differ"
# What a model's file names belongs to it.
{ echo 'mtllib door.mtl'; awk 'NF == 3 && /^[-0-9.]/ { print "v", $0 } NF > 3 && /^[34] [0-9]/ { $1 = "usemtl m\nf"; for (i = 2; i <= NF; ++i) ++$i; print }' door.ply; } >door.obj
printf 'newmtl m\nd 1\n' >door.mtl
"$occlude" bake door.obj "${long[@]:2}" --parts kept --out killed.pvs >/dev/null 2>stderr &
await has_parts
{ kill -KILL $! && wait $!; } 2>/dev/null
printf 'newmtl m\nd 0.5\n' >door.mtl
expect_error "kept: has parts of another run" "$occlude" bake door.obj "${long[@]:2}" --parts kept --resume --out killed.pvs
rm -r kept
taskset -c 0 "$occlude" "${long[@]}" --out single.pvs >/dev/null || fail "one thread"
cmp one.pvs single.pvs || fail "one thread: the bytes differ"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
if ! command -v mpirun >/dev/null || mpirun -n 1 "$occlude" fuzz --cases 1 --findings '' 2>&1 | grep -q 'built without MPI'; then
  echo "No mpirun: several processes are not tried"
else
  mpirun --oversubscribe -n 3 "$occlude" "${long[@]}" --out many.pvs >many 2>stderr || fail "mpirun: $(cat stderr)"
  cmp one.pvs many.pvs || fail "mpirun: the bytes differ"
  mpirun --oversubscribe -n 3 "$occlude" validate door.ply --witness door.jsonl >many_proved 2>stderr || fail "mpirun: $(cat stderr)"
  "$occlude" validate door.ply --witness door.jsonl | cmp - many_proved || fail "mpirun proves $(cat many_proved)"
  cmp -s <(sed 's/^one//; s/;[^;]*$//' one) <(sed 's/^many//; s/;[^;]*$//' many) || fail "mpirun prints $(cat many)"
  ! compgen -G 'occlude_*_parts' >/dev/null || fail "mpirun leaves parts behind"
fi

# The map: 32 pixels for a unit, from above. Of two cells above each other that which sees more shows. The brightest sees
# most; where there are none nothing is.
echo '{"cells":[{"min":[0,0,1],"max":[1,1,2]},{"min":[31,0,1],"max":[32,2,2]},{"min":[6,2,1],"max":[7,3,2]},{"min":[6,2,9],"max":[7,3,9]}]}' >map.json
"$occlude" bake door.ply --cells map.json --out map.pvs --map map.png >/dev/null || fail "--map"
pixel() { # pixel X Y EXPECTED
  [ "$(python3 -B "$pixels" map.png "$1" "$2")" = "$3" ] || fail "pixel $1 $2: $(python3 -B "$pixels" map.png "$1" "$2")"
}
[ "$(python3 -B "$pixels" map.png)" = '1024 96' ] || fail "the size of the map: $(python3 -B "$pixels" map.png)"
pixel 192 0 '255 240 120 255'
pixel 223 31 '255 240 120 255'
pixel 224 31 '0 0 0 0'
pixel 192 32 '0 0 0 0'
pixel 1023 95 '190 45 80 255'
pixel 992 32 '190 45 80 255'
pixel 991 95 '0 0 0 0'

# A store gives the same as its model.
"$occlude" preprocess door.ply --leaf 4 --out door.pre >/dev/null || fail "preprocess"
"$occlude" bake door.pre --cells cells.json --out store.pvs >/dev/null || fail "store"
sees store.pvs '.7 2.5 1.5' 'cell 0;items 0 1 2 3 4 5 6 7 8 10 11;cells 0 2;'

# Files that are cut off or damaged, in the header, too.
head -c 200 door.pvs >cut.pvs
refused cut.pvs
for at in 0 8 16 24 27 28 31 32 39 40 48 63 64 220; do
  { head -c "$at" door.pvs; printf '\376'; tail -c +$((at + 2)) door.pvs; } >damaged.pvs
  cmp -s door.pvs damaged.pvs || refused damaged.pvs
done
# Files that are no sets, with the hash that they should have.
forged() { # forged PLACE BYTE...: of the sets if PLACE begins with +
  python3 -B - "$@" <<'END' || fail "forged"
import struct, sys
data = bytearray(open("door.pvs", "rb").read())
place = int(sys.argv[1]) + (struct.unpack_from("<Q", data, 64 + 3 * 48)[0] if sys.argv[1][0] == "+" else 0)
for i, byte in enumerate(sys.argv[2:]):
    data[place + i] = int(byte)
value = 0xCBF29CE484222325
for byte in data[:40] + data[48:]:
    value = (value ^ byte) * 0x100000001B3 % 2**64
struct.pack_into("<Q", data, 40, value)
open("forged.pvs", "wb").write(data)
END
  refused forged.pvs
}
forged +0 1                          # differs from the set before the first
forged +0 255 255                    # a number that does not end
forged +1 127                        # items beyond the last
forged 24 255 255                    # more cells than there is room for
forged 28 3                          # fewer items than are in a set
forged $((64 + 3 * 48)) 0 0 0 0 1    # a set beyond the file
forged $((64 + 3 * 48 + 8)) 0 0 0 0 1

# Bad input.
bad() { # bad TEXT CELLS
  echo "$2" >bad.json
  expect_error "$1" "$occlude" bake door.ply --cells bad.json --out bad.pvs
}
bad 'bad.json: expected {"cells"' '[]'
bad 'bad.json: expected {"cells"' '{"cells":{}}'
bad 'bad.json: expected {"cells"' '{"cells":[],"more":1}'
bad 'bad.json: no cells' '{"cells":[]}'
bad 'bad.json: cell 0: expected an object' '{"cells":[1]}'
bad 'bad.json: cell 1: max: missing' "{\"cells\":[$before,{\"min\":[0,0,0]}]}"
bad 'bad.json: cell 0: unknown member "low"' '{"cells":[{"low":[0,0,0],"max":[1,1,1]}]}'
bad 'bad.json: cell 0: min: expected three numbers' '{"cells":[{"min":[0,0],"max":[1,1,1]}]}'
bad 'bad.json: cell 0: ' '{"cells":[{"min":[0,0,2],"max":[1,1,1]}]}'
bad 'bad.json: cell 0: ' '{"cells":[{"min":[0,0,NaN],"max":[1,1,1]}]}'
bad 'bad.json: cell 0: ' '{"cells":[{"min":[0,0,1e-40],"max":[1,1,1]}]}'
bad 'bad.json' '{'
objects() { # objects TEXT OBJECTS
  echo "$2" >bad.json
  expect_error "$1" "$occlude" bake door.ply --cells cells.json --objects bad.json --out bad.pvs
}
objects 'bad.json: expected {"objects"' '[]'
objects 'bad.json: object 1: expected an array' '{"objects":[[1],2]}'
objects 'bad.json: object 0: polygons 12 to 13: the model has 13' '{"objects":[[[12,2]]]}'
objects 'bad.json: object 1: polygon 3 is in object 0 already' '{"objects":[[[0,9]],[3]]}'
objects 'bad.json: object 0: expected numbers of polygons' '{"objects":[[-1]]}'
expect_error '--cells' "$occlude" bake door.ply --out bad.pvs
expect_error '--out' "$occlude" bake door.ply --cells cells.json
expect_error 'missing.json' "$occlude" bake door.ply --cells missing.json --out bad.pvs
expect_error 'missing.ply' "$occlude" bake missing.ply --cells cells.json --out bad.pvs
echo '{"frames":2,"projection":"orthographic","height":2,"keyframes":[{"eye":[0,0,0],"target":[1,0,0]},{"eye":[0,0,0],"target":[1,1,0]}]}' >parallel.json
expect_error 'parallel.json: its rays are parallel' "$occlude" bake door.ply --cells corridor --path parallel.json --out bad.pvs
expect_error '--heights' "$occlude" bake door.ply --cells grid --heights 3:1 --out bad.pvs
expect_error '--heights' "$occlude" bake door.ply --cells grid --heights 3 --out bad.pvs
expect_error '--heights' "$occlude" bake door.ply --cells grid --heights 1e300:1e300 --out bad.pvs
expect_error '--heights: does nothing with --cells cells.json' "$occlude" bake door.ply --cells cells.json --heights 1:2 --out bad.pvs
expect_error '--cell-size: does nothing' "$occlude" bake door.ply --cells cells.json --cell-size 2 --out bad.pvs
expect_error '--reach: does nothing with --cells grid' "$occlude" bake door.ply --cells grid --reach 2 --out bad.pvs
expect_error '--path: does nothing' "$occlude" bake door.ply --cells grid --path walk --out bad.pvs
expect_error '--cells' "$occlude" bake door.ply --cells grid --cell-size 0.01 --out bad.pvs
expect_error 'the cell from (6, 2, 1) to (7, 3, 2) has more than 65536 pieces, with --piece 0.001' \
  "$occlude" bake door.ply --cells cells.json --piece 0.001 --out bad.pvs
for reader in "${readers[@]}"; do
  # shellcheck disable=SC2086
  $reader door.pvs abc 1 1 >stdout 2>stderr
  [ $? -eq 2 ] || fail "$reader takes abc for a number: $(cat stdout)"
done
expect_error '--cell-size' "$occlude" bake door.ply --cells grid --cell-size 0 --out bad.pvs
expect_error 'cells.json' "$occlude" bake door.ply --cells cells.json --out cells.json
expect_error 'named twice' "$occlude" bake door.ply --cells cells.json --out bad.pvs --map ./bad.pvs

finish
