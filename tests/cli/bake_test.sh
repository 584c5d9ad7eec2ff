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

readers=("$example" "python3 -B $examples/visible_sets.py")
if command -v node >/dev/null; then readers+=("node $examples/visible_sets.mjs"); else echo "No node: its reader is not tried"; fi
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

# A point, and a cell that is flat.
echo '{"cells":[{"min":[1,1,1],"max":[1,1,1]},{"min":[6,0.2,1],"max":[7,0.6,1]}]}' >flat.json
"$occlude" bake door.ply --cells flat.json --out flat.pvs >/dev/null || fail "flat"
sees flat.pvs '1 1 1' 'cell 0;items 0 1 2 3 4 5 6 7 8 11;cells 0;'
sees flat.pvs '6.5 .5 1' 'cell 1;items 0 1 2 3 4 5 6 7 8 9 10;cells 1;'

# Grids and corridors: cubes, or one layer. Rays into what is in no set, and in all directions.
clear() { "$rays" "$@" >rays || fail "rays: $(cat rays)"; }
clear door.ply door.pvs 20000 9
clear closed.ply closed.pvs 20000 9
clear door.ply flat.pvs 20000 9
"$occlude" bake door.ply --cells grid --cell-size 2 --out grid.pvs --json >told || fail "grid"
grep -q '"cells": 220,' told || fail "cells of a grid: $(cat told)" # 11 by 5 by 4
clear door.ply grid.pvs 500 220
echo '{"frames":4,"keyframes":[{"eye":[1,2.5,1.5],"target":[2,2.5,1.5]},{"eye":[6,2.5,1.5],"target":[7,2.5,1.5]}]}' >path.json
"$occlude" bake door.ply --cells corridor --path path.json --cell-size 1 --heights 1:2 --reach 0 --out way.pvs --json >told || fail "corridor"
grep -q '"cells": 6,' told || fail "cells of a corridor: $(cat told)"
clear door.ply way.pvs 20000 9
sees way.pvs '6.5 2.5 2' 'cell 5;items 0 1 2 3 4 5 6 7 8 9 10 11;cells 0 1 2 3 4 5;'
"$occlude" generate city --polygons 20000 --seed 5 --out city.ply --path whole.json >/dev/null || fail "generate"
# The first of its keyframes, which have a line each.
{ sed -n '1s/2748/20/p; 2,9p' whole.json; sed -n '10s/,$/]}/p' whole.json; } >city.json
"$occlude" bake city.ply --cells corridor --path city.json --cell-size 4 --reach 0 --heights 1:3 --out city.pvs >/dev/null || fail "city"
clear city.ply city.pvs 2000 20
grep -q ' 0 reach' rays || fail "$(cat rays)"

# The rays find what is wrong: in the sets of the closed door, with the door open.
"$rays" door.ply closed.pvs 20000 9 >rays
[ $? -eq 1 ] && grep -q 'cell 0 sees polygon 10 ' rays || fail "the rays do not find a wrong set: $(cat rays)"

# Parts that are kept change no byte, nor does a run that goes on with those of one that was killed, nor do ranks.
long=(bake door.ply --cells grid --cell-size 1.5)
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
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
if ! command -v mpirun >/dev/null || mpirun -n 1 "$occlude" fuzz --cases 1 --findings '' 2>&1 | grep -q 'built without MPI'; then
  echo "No mpirun: several processes are not tried"
else
  mpirun --oversubscribe -n 3 "$occlude" "${long[@]}" --out many.pvs >many 2>stderr || fail "mpirun: $(cat stderr)"
  cmp one.pvs many.pvs || fail "mpirun: the bytes differ"
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

# Files that are cut off or damaged.
head -c 200 door.pvs >cut.pvs
"$example" cut.pvs 1 1 1 >stdout 2>stderr
[ $? -eq 2 ] && grep -q 'no visible sets, or damaged' stderr || fail "cut off: $(cat stdout stderr)"
{ head -c 220 door.pvs; printf '\377'; tail -c +222 door.pvs; } >damaged.pvs
"$example" damaged.pvs 1 1 1 >stdout 2>stderr
[ $? -eq 2 ] && grep -q 'no visible sets, or damaged' stderr || fail "damaged: $(cat stdout stderr)"

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
expect_error '--heights' "$occlude" bake door.ply --cells grid --heights 3:1 --out bad.pvs
expect_error '--heights' "$occlude" bake door.ply --cells grid --heights 3 --out bad.pvs
expect_error '--cells' "$occlude" bake door.ply --cells grid --cell-size 0.01 --out bad.pvs
expect_error '--cells' "$occlude" bake door.ply --cells cells.json --piece 0.001 --out bad.pvs
expect_error '--cell-size' "$occlude" bake door.ply --cells grid --cell-size 0 --out bad.pvs
expect_error 'cells.json' "$occlude" bake door.ply --cells cells.json --out cells.json
expect_error 'named twice' "$occlude" bake door.ply --cells cells.json --out bad.pvs --map ./bad.pvs

finish
