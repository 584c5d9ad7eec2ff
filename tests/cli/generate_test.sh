#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# `occlude generate`: the same seed gives the same city, and nothing is left behind.
# Usage: generate_test.sh PATH_OF_OCCLUDE
set -uo pipefail
. "$(dirname "$0")/common.sh"
walk_of_squares

expect_error "--polygons" "$occlude" generate city --polygons 5 --out city.ply --path city.json
expect_error "missing/city.ply" "$occlude" generate city --polygons 20000 --out missing/city.ply --path city.json
expect_error "named twice" "$occlude" generate city --polygons 20000 --out same --path same
expect_error "nodir/h.json" "$occlude" generate city --polygons 20000 --out h.ply --path nodir/h.json
expect_error "--seed" "$occlude" generate city --polygons 20000 --seed -1 --out h.ply --path h.json

# The same seed gives the same city. When interrupted, it leaves nothing behind.
"$occlude" generate city --polygons 20000 --out city.ply --path city.json >/dev/null || fail "generate"
"$occlude" generate city --polygons 20000 --out again.ply --path again.json >/dev/null || fail "generate"
cmp -s city.ply again.ply && cmp -s city.json again.json || fail "two cities of one seed differ"

interrupt INT "$occlude" generate city --polygons 5000000 --out big.ply --path big.json
[ ! -e big.ply ] && [ ! -e big.json ] || fail "Ctrl-C left a city"

finish
