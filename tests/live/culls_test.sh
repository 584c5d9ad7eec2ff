#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The culler of the page of `occlude inspect` culls 300 frames of the city as the native one does, polygon by polygon, with
# both methods. Skipped, with exit code 77, where there is no node or no live.wasm (render/live/build.sh).
# Usage: culls_test.sh PATH_OF_OCCLUDE PATH_OF_LIVE_CULLS
set -uo pipefail
tests=$(realpath "$(dirname "$0")")
culls=$(realpath "$2")
. "$tests/../cli/common.sh"

if ! command -v node >/dev/null || [ ! -e "$(dirname "$occlude")/live.wasm" ]; then
  echo "no node, or no live.wasm beside the program (render/live/build.sh): skipped"
  exit 77
fi

"$occlude" generate city --polygons 20000 --seed 1 --out city.ply --path city.json >/dev/null || fail "generate"
"$occlude" inspect city.ply --path city.json --out live.html >/dev/null || fail "inspect"
for method in frusta cover; do
  "$culls" city.ply city.json "$method" 300 >native.txt || fail "live_culls"
  node "$tests/culls.js" "$tests/../../render/report/page" live.html "$method" 300 >page.txt || fail "culls.js"
  [ "$(wc -l <page.txt)" -eq 300 ] || fail "$method: not 300 frames"
  cmp native.txt page.txt || fail "$method: the culls differ"
done
finish
