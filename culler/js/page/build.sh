#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the page in which a dropped model is flown through, a static folder: culler/js/page/site. Builds the package first, if it is
# not there, and installs what package-lock.json names.
# Usage: bash culler/js/page/build.sh
set -euo pipefail
cd "$(dirname "$0")"
[ -e ../dist/occlude.wasm ] || bash ../build.sh
mkdir -p made
log=$PWD/made/log.txt
{
  [ node_modules/.package-lock.json -nt package-lock.json ] || npm ci
  npm run build
} >"$log" 2>&1 || { echo "Failed: $log" >&2; exit 1; }
node assemble.mjs site
ls site
