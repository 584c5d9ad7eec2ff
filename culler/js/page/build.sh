#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the page in which one flies through a model: a static folder, culler/js/page/site, and the same page as FOLDER/viewer.html,
# beside the program, for `occlude inspect`. Builds the package first, if it is not there, and installs what package-lock.json names.
# Usage: bash culler/js/page/build.sh [FOLDER] (default: build/release)
set -euo pipefail
folder=$(realpath -m "${1:-$(dirname "$0")/../../../build/release}")
cd "$(dirname "$0")"
[ -e ../dist/occlude.wasm ] || bash ../build.sh
mkdir -p made "$folder"
log=$PWD/made/log.txt
{
  [ node_modules/.package-lock.json -nt package-lock.json ] || npm ci
  npm run build
} >"$log" 2>&1 || { echo "Failed: $log" >&2; exit 1; }
node assemble.mjs site
cp site/index.html "$folder/viewer.html"
ls site "$folder/viewer.html"
