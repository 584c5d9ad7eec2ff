#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds live.wasm, the culler that runs in the page of `occlude inspect`, and puts it into FOLDER, where the program is.
# Installs Emscripten and makes its libraries first (minutes, once; Debian 12, as root or with sudo).
# Usage: bash render/live/build.sh [FOLDER] (default: build/release)
set -euo pipefail
folder=$(realpath -m "${1:-$(dirname "$0")/../../build/release}")
cd "$(dirname "$0")/../.."
platform=$PWD/build/platforms/wasm
bash tests/platforms/libraries.sh wasm "$platform" || { echo "Failed: $platform/libraries.txt" >&2; exit 1; }
export NODE_PATH=/usr/share/nodejs  # where Debian has what Emscripten's scripts need
{
  cmake -S . -B "$platform/build" -G Ninja -DOCCLUDE_TOOLS=OFF "-DCMAKE_TOOLCHAIN_FILE=$PWD/tests/platforms/wasm.cmake" \
    "-DCMAKE_PREFIX_PATH=$platform/prefix" -DCMAKE_BUILD_TYPE=Release
  cmake --build "$platform/build" --target live
} >"$platform/live.txt" 2>&1 || { echo "Failed: $platform/live.txt" >&2; exit 1; }
mkdir -p "$folder"
cp "$platform/build/render/live/live.wasm" "$folder/live.wasm"
echo "$folder/live.wasm"
