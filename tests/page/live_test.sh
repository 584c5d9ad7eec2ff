#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The page of `occlude inspect` in Chromium (live_test.py). Skipped, with exit code 77, where there is no Chromium with its
# driver, no Python with selenium, or no live.wasm beside the program (render/live/build.sh). Usage: live_test.sh PATH_OF_OCCLUDE
set -uo pipefail
tests=$(realpath "$(dirname "$0")")
. "$tests/../cli/common.sh"
. "$tests/need_browser.sh"
if [ ! -e "$(dirname "$occlude")/live.wasm" ]; then
  echo "no live.wasm beside the program (render/live/build.sh): skipped"
  exit 77
fi

"$occlude" generate city --polygons 20000 --seed 1 --out city.ply --path city.json >/dev/null || fail "generate"
"$occlude" inspect city.ply --path city.json --out live.html >/dev/null || fail "inspect"
"$occlude" inspect city.ply --out free.html >/dev/null || fail "inspect without a path"

"$python" -B "$tests/live_test.py" || fail "live_test.py"
finish
