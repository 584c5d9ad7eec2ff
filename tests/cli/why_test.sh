#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# `occlude why`: why a polygon was drawn or culled.
# Usage: why_test.sh PATH_OF_OCCLUDE
set -uo pipefail
. "$(dirname "$0")/common.sh"
walk_of_squares

# The wall at x = 2 hides what is behind it. Everything in the leaf of the wall itself is drawn.
why() { "$occlude" why good.ply --path path.json --size 64x36 "$@"; }
why --method frusta --frame 3 --polygon 40 >stdout || fail "why"
grep -q '^frame 3, polygon 40: culled: in shadow$' stdout || fail "why said: $(cat stdout)"
grep -q '^  by occluder 0: polygon 0; it hides [1-9][0-9]* polygons in this frame$' stdout || fail "why said: $(cat stdout)"
grep -q '^  the box is inside its shadow by [0-9.]*, nearest to the side through its edge (2, ' stdout || fail "why said: $(cat stdout)"
why --method frusta --frame 0 --polygon 1 >stdout || fail "why"
grep -q '^frame 0, polygon 1: drawn$' stdout || fail "why said: $(cat stdout)"
grep -q "it was not culled: its leaf is too coarse: its own box is hidden" stdout || fail "why said: $(cat stdout)"
why --frame 0 --pixel 32,18 --json --out why >stdout || fail "why"
grep -q '"polygon": 0,' stdout || fail "why --pixel said: $(cat stdout)"
grep -q '"fate": "drawn"' stdout || fail "why --pixel said: $(cat stdout)"
cmp -s stdout why/why.json || fail "why.json is not what was printed"
for plate in view outside; do [ -s why/$plate.png ] || fail "why: no $plate.png"; done

# By cover: what many polygons hide together.
cover="--method cover --cover-size 128x96"
why --frame 3 --polygon 63 $cover >stdout || fail "why by cover"
grep -q '^  by [1-9][0-9]* polygons together: ' stdout || fail "why by cover said: $(cat stdout)"
why --frame 0 --polygon 1 $cover --json >stdout || fail "why by cover --json"
grep -q '"fate": "drawn"' stdout || fail "why by cover of what is drawn"

# A walk with a step also culls the frames between.
why --frame 1 --frames 0:4:3 --polygon 40 >stdout || fail "why of a frame between"
why --frame 1 --polygon 40 | cmp -s stdout - || fail "a frame between is culled otherwise: $(cat stdout)"
expect_error "no frame 2: it has frames 0 to 1" why --frame 2 --frames 0:2 --polygon 40

# Questions that are refused.
expect_error "--frame" why --frame -1 --polygon 0
: >file
expect_error "file" why --frame 0 --polygon 0 --out file
expect_error "no frame 9" why --frame 9 --polygon 0
expect_error "no polygon 64" why --frame 0 --polygon 64
expect_error "no polygon is visible there" why --frame 0 --pixel 0,0
expect_error "--pixel" why --frame 0 --pixel 64,0
expect_error "--pixel" why --frame 0 --pixel 3
expect_error "[--polygon,--pixel]" why --frame 0
expect_error "[--polygon,--pixel]" why --frame 0 --polygon 0 --pixel 3,3

# A polygon out of view.
"$occlude" why good.ply --path back.json --frame 0 --polygon 40 >stdout || fail "why, looking away"
grep -q '^frame 0, polygon 40: culled: out of view$' stdout || fail "why said: $(cat stdout)"
grep -q '^  by the left plane of the view: the box is beyond it by' stdout || fail "why said: $(cat stdout)"

finish
