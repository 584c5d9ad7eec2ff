#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The page in which dropped models are flown through, in Chromium (flight_test.py). Skipped, with exit code 77, where there is no Chromium
# with its driver, no Python with selenium, or the page was not built (culler/js/page/build.sh). Usage: flight_test.sh PATH_OF_OCCLUDE
set -uo pipefail
tests=$(realpath "$(dirname "$0")")
. "$tests/../cli/common.sh"
. "$tests/need_browser.sh"
. "$tests/need_page.sh"

cp "$page" flight.html
"$occlude" generate city --polygons 20000 --seed 1 --out city.ply --path city.json >/dev/null || fail "generate"
"$python" -B "$tests/flight_test.py" || fail "flight_test.py"
"$occlude" walk city.ply --path saved/path.json --no-render --out walked >/dev/null || fail "the path that was recorded"
finish
