#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the JavaScript package into culler/js/dist: occlude.wasm, occlude.mjs and occlude.d.ts. Installs Emscripten and makes
# its libraries first (minutes, once; Debian 12, as root or with sudo), and what package-lock.json names.
# Usage: bash culler/js/build.sh
set -euo pipefail
cd "$(dirname "$0")"
dist=$PWD/dist
project=$(realpath ../..)
platform=$project/build/platforms/wasm
log=$platform/js.txt
bash "$project/tests/platforms/libraries.sh" wasm "$platform" || { echo "Failed: $platform/libraries.txt" >&2; exit 1; }
export NODE_PATH=/usr/share/nodejs  # where Debian has what Emscripten's scripts need
{
  cmake -S "$project" -B "$platform/build" -G Ninja -DOCCLUDE_TOOLS=OFF -DCMAKE_BUILD_TYPE=Release \
    "-DCMAKE_TOOLCHAIN_FILE=$project/tests/platforms/wasm.cmake" "-DCMAKE_PREFIX_PATH=$platform/prefix"
  cmake --build "$platform/build" --target occlude_js
  [ node_modules/.package-lock.json -nt package-lock.json ] || npm ci
  npm run build
} >"$log" 2>&1 || { echo "Failed: $log" >&2; exit 1; }
mkdir -p "$dist"
cp "$platform/build/culler/js/occlude.wasm" "$project/LICENSE" "$dist"
ls "$dist"
