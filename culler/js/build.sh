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
  # With -O2 alone a frame takes a seventh less time, and the module a sixth more room. -Os has no function inlined: frames take four
  # times as long.
  cmake -S "$project" -B "$platform/js" -G Ninja -DOCCLUDE_TOOLS=OFF -DOCCLUDE_TESTS=OFF -DOCCLUDE_INSTALL=OFF \
    -DCMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_FLAGS_RELEASE=-O2 -fno-unroll-loops -mllvm -inline-threshold=45 -DNDEBUG" \
    -DCMAKE_EXE_LINKER_FLAGS_RELEASE=-Oz "-DCMAKE_TOOLCHAIN_FILE=$project/tests/platforms/wasm.cmake" \
    "-DCMAKE_PREFIX_PATH=$platform/prefix"
  cmake --build "$platform/js" --target occlude_js
  [ node_modules/.package-lock.json -nt package-lock.json ] || npm ci
  npm run build
} >"$log" 2>&1 || { echo "Failed: $log" >&2; exit 1; }
mkdir -p "$dist"
cp "$platform/js/culler/js/occlude.wasm" "$dist"
cp "$project/LICENSE" .
ls "$dist"
