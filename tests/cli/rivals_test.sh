#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# `occlude bench rivals` beside Embree. Skipped where occlude was built without it.
# Usage: rivals_test.sh PATH_OF_OCCLUDE
set -uo pipefail
. "$(dirname "$0")/common.sh"
walk_of_squares

of_way() { sed -n "/\"way\": \"$1\"/,/}/s/^ *\"$2\": \([0-9.]*\),*/\1/p" rivals.json; } # of_way WAY MEMBER

"$occlude" bench rivals good.ply --path path.json --size 64x36 --leaf 1 --repetitions 1 --rays 64x36 --json >rivals.json || fail "rivals"
if grep -A1 '"name": "Embree"' rivals.json | grep -q 'not installed'; then
  echo "Skipped: built without Embree (libembree-dev)"
  exit 77
fi
# Rays through the pixels of the item buffer see what it shows: the wall, and nothing behind it.
for way in 'Embree, Morton, 64x36 rays' 'Embree, SAH, 64x36 rays'; do
  [ "$(of_way "$way" drawn)" = 1.0 ] || fail "$way: draws $(of_way "$way" drawn)"
  [ "$(of_way "$way" hidden_culled)" = 1.0 ] || fail "$way: culls $(of_way "$way" hidden_culled) of what is hidden"
  [ "$(of_way "$way" false_culls)$(of_way "$way" wrong_pixels)" = 00 ] || fail "$way: culls what shows"
done
# The check itself: few rays miss what shows, and that is found.
"$occlude" bench rivals --polygons 20000 --frames 0:2 --repetitions 1 --rays 15x7 --json >rivals.json || fail "few rays"
for member in false_culls wrong_pixels; do
  [ "$(of_way 'Embree, SAH, 15x7 rays' $member)" -gt 0 ] || fail "few rays: no $member"
  [ "$(of_way 'occlude, joined shadows' $member)" -eq 0 ] || fail "joined shadows: $member"
done

finish
