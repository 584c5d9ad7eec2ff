#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Draws the pictures of the README anew, with build/release/occlude, of the city of demo.sh. That of the page needs the packages
# chromium, chromium-driver and python3-selenium.
# The chart of held culls is of utrecht_centre.ply and its path in the folder OCCLUDE_DATA; without it that picture stays.
# Usage: bash render/pictures.sh
set -euo pipefail
cd "$(dirname "$0")/.."
demo=build/demo
mkdir -p "$demo"
[ -f "$demo/city.ply" ] ||
  build/release/occlude generate city --polygons 500000 --seed 1 --out "$demo/city.ply" --path "$demo/city.json"
# draw NAME OPTIONS...: a frame in a street of terraces.
draw() {
  build/release/occlude render "$demo/city.ply" --path "$demo/city.json" --frame 1093 --size 960x540 --out "render/images/$1.png" "${@:2}"
}
draw street
draw outside --layer outside
# The same frame in the page of a walk.
build/release/occlude walk "$demo/city.ply" --path "$demo/city.json" --frames 3:2748:109 --method frusta --out "$demo/pictures"
. tests/page/need_browser.sh
"$python" -B tests/page/picture.py "$demo/pictures/report.html" 1093 render/images/page.png
# What a frame takes where culls hold, on a machine that does nothing else.
data=${OCCLUDE_DATA:-}
if [ -f "$data/utrecht_centre.ply" ]; then
  build/release/occlude bench held "$data/utrecht_centre.ply" --path "$data/utrecht_centre_path1.json" --speeds 0.5,1.5,5,15,50 --frames 3600 \
    --chart render/images/held.svg
else
  echo "No real models (OCCLUDE_DATA): the chart of held culls stays as it is"
fi
