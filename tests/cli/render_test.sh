#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# `occlude render`: pictures of a frame, and animations.
# Usage: render_test.sh PATH_OF_OCCLUDE
set -uo pipefail
. "$(dirname "$0")/common.sh"
walk_of_squares

render() { "$occlude" render good.ply --path path.json --size 64x36 --method frusta "$@"; }

# Each layer is another picture. A picture holds its name, so all have one. The culled squares are behind the wall, which is
# not in their layer; the wall is the only occluder and all that is seen.
layers=(drawn all seen missed culled outside fates occluders)
mkdir "${layers[@]}" again
for layer in "${layers[@]}"; do
  render --frame 3 --layer $layer --out $layer/a.png >stdout || fail "render --layer $layer"
  [ "$(cat stdout)" = "$layer/a.png: a picture of 64x36 pixels" ] || fail "render said: $(cat stdout)"
done
cmp -s drawn/a.png all/a.png || fail "what is culled shows"
cmp -s fates/a.png occluders/a.png || fail "another occluder"
for ((i = 1; i + 1 < ${#layers[@]}; ++i)); do
  for ((k = i + 1; k + 1 < ${#layers[@]}; ++k)); do
    cmp -s "${layers[i]}/a.png" "${layers[k]}/a.png" && fail "${layers[i]} is as ${layers[k]}"
  done
done

# The same frame gives the same bytes, also between the frames of a walk with a step, and by its number in that walk.
render --frame 1 --layer fates --out fates/a.png >/dev/null || fail "render"
render --frame 1 --frames 0:4:3 --layer fates --out again/a.png >/dev/null || fail "render of a frame between"
cmp -s fates/a.png again/a.png || fail "a frame between looks otherwise"

# Several frames are an animation, whose first picture is that of the first frame.
render --frames 0:4:3 --layer outside --fps 5 --json --out moving.png >stdout || fail "render --frames"
grep -q '"pictures": 2' stdout || fail "render --json said: $(cat stdout)"
[ "$(grep -c acTL moving.png)" -ge 1 ] || fail "moving.png is no animation"

# What is refused.
expect_error "--out" render --frame 0
expect_error "no frame 4" render --frame 4 --out picture.png
expect_error "no frame 2: it has frames 0 to 1" render --frame 2 --frames 0:2 --out picture.png
expect_error "--layer" render --frame 0 --layer walls --out picture.png
expect_error "--frame" render --frame x --out picture.png
expect_error "--fps" render --fps 0 --out picture.png
expect_error "--size" render --frame 0 --size 99999x99999 --out picture.png
expect_error "missing.ply" "$occlude" render missing.ply --path path.json --frame 0 --out picture.png
expect_error "no/picture.png" render --frame 0 --out no/picture.png

finish
