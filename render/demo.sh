#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The paper's experiment from a fresh checkout: installs missing packages, builds, generates the city, walks through it and
# prints the path of the report. Then it validates the walk, with pictures of the same size.
# Usage: bash render/demo.sh [OPTIONS OF occlude walk ...], for instance --frames 0:2748:10.
set -euo pipefail

size=()
for ((i = 1; i <= $#; ++i)); do
  next=$((i + 1))
  case ${!i} in
    --size=*) size=("${!i}") ;;
    --size) size=(--size "${!next:-}") ;;
  esac
done

cd "$(dirname "$0")/.."
bash .ci/packages.sh
[ -f build/release/build.ninja ] || cmake --preset release >/dev/null
cmake --build --preset release --target occlude

demo=build/demo
mkdir -p "$demo"
if [ ! -f "$demo/city.ply" ] || [ ! -f "$demo/city.json" ] || [ build/release/occlude -nt "$demo/city.ply" ]; then
  build/release/occlude generate city --polygons 500000 --seed 1 --out "$demo/city.ply" --path "$demo/city.json"
fi
build/release/occlude walk "$demo/city.ply" --path "$demo/city.json" --out "$demo/report" \
  --witness "$demo/witness.jsonl" "$@"
build/release/occlude validate "$demo/city.ply" --path "$demo/city.json" --witness "$demo/witness.jsonl" \
  ${size[@]+"${size[@]}"}
