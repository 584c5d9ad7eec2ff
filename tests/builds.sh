#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Checks that every build gives the same answers bit for bit. On this machine: g++ and clang++, -O0 and -O3, without and with
# FMA, and batches on every instruction set. On others: all tests of the kernel and the culler, on 64-bit ARM and a big-endian
# machine (IBM Z) under QEMU, and on Windows under Wine; and as WebAssembly, which has no threads and pointers of 32 bits, those
# of the kernel and of the C interface, under node. Prints one line per build, with a hash of its answers. `msvc` only compiles
# the libraries, by clang, in the language of Microsoft's compiler. Exit code 1 if one fails.
# Usage: bash tests/builds.sh [g++|clang++|msvc|aarch64|s390x|windows|wasm]...
#   (default: all; x86-64, Debian 12, as root or with sudo)
set -euo pipefail
cd "$(dirname "$0")/.."
builds=("$@")
[ $# -gt 0 ] || builds=(g++ clang++ msvc aarch64 s390x windows wasm)

# build_and_test FOLDER: builds `targets` with the CMake `options` and runs the tests whose label `chosen` matches. Prints
# "passed" or "FAILED", how many tests, and a hash of the answers to the million cases. The logs stay in the folder.
build_and_test() {
  local folder=$1 result=passed count hash
  mkdir -p "$folder"
  { cmake -S . -B "$folder" -G Ninja -DOCCLUDE_TOOLS=OFF "${options[@]}" && cmake --build "$folder" --target "${targets[@]}"; } \
    >"$folder/log.txt" 2>&1 || { echo "FAILED to build: $folder/log.txt"; return 1; }
  ctest --test-dir "$folder" --parallel "$(nproc)" --verbose --label-regex "$chosen" >"$folder/tests.txt" 2>&1 ||
    result="FAILED ($folder/tests.txt)"
  count=$(grep -c '\[       OK \]' "$folder/tests.txt")
  hash=$(grep -o '{0x[0-9a-f]*, 0x[0-9a-f]*}' "$folder/tests.txt" | sort | sha256sum)
  [ "$count" -gt 0 ] || result="FAILED: no test ran"
  echo "$result: $count tests passed, answers ${hash:0:16}"
  [[ $result == passed ]]
}

# on_this_machine COMPILER FLAGS: the million cases, and the batches.
on_this_machine() {
  local options=(-DCMAKE_BUILD_TYPE= "-DCMAKE_CXX_COMPILER=$1" "-DCMAKE_CXX_FLAGS=$2")
  local targets=(kernel_tests) chosen='^kernel$'
  GTEST_FILTER='*Answers*:*Batch*' build_and_test "build/answers/$1${2// /}"
}

# as_msvc: the libraries and the public headers, as Microsoft's compiler takes C++, which has no integers of 128 bits. The headers of
# the standard library are those of this machine: they need clang to be a GNU compiler too, and say so in a warning.
as_msvc() {
  local folder=build/platforms/msvc flags='-fms-extensions -fms-compatibility -fmsc-version=1934 -fdelayed-template-parsing'
  flags+=' -D_MSC_FULL_VER=193431937 -fgnuc-version=4.2.1 -U__SIZEOF_INT128__ -Wno-#warnings'
  mkdir -p "$folder"
  {
    cmake -S . -B "$folder" -G Ninja -DOCCLUDE_TOOLS=OFF -DOCCLUDE_PYTHON=OFF -DCMAKE_BUILD_TYPE= -DCMAKE_UNITY_BUILD=OFF \
      -DCMAKE_CXX_COMPILER=clang++ "-DCMAKE_CXX_FLAGS=$flags" &&
      cmake --build "$folder" --target occlude_kernel occlude_kernel_judge occlude_culler occlude_c public_headers
  } >"$folder/log.txt" 2>&1 || { echo "FAILED to build: $folder/log.txt"; return 1; }
  echo "compiled"
}

# on_platform NAME: all tests of the kernel, the C interface and, where there are threads, of the culler, and the examples.
on_platform() {
  local folder=$PWD/build/platforms/$1
  bash tests/platforms/libraries.sh "$1" "$folder" || { echo "FAILED to build libraries: $folder/libraries.txt"; return 1; }
  if [ "$1" = windows ]; then
    # Wine's first program makes its files. Tests that start meanwhile would fail.
    mkdir -p "$folder/build"
    WINEDEBUG=-all WINEPREFIX=$folder/build/wine wineboot --init >>"$folder/libraries.txt" 2>&1
  fi
  local options=("-DCMAKE_TOOLCHAIN_FILE=$PWD/tests/platforms/$1.cmake" "-DCMAKE_PREFIX_PATH=$folder/prefix"
    -DCMAKE_BUILD_TYPE=Release)
  local targets=(kernel_tests culler_tests public_headers {contents,matrix,model,scene,tutorial}_example c_tests) chosen='^(kernel|culler)$'
  [ "$1" != wasm ] || { targets=(kernel_tests c_tests public_headers) chosen='^(kernel|c)$'; }
  build_and_test "$folder/build"
}

# Where Debian has what Emscripten's scripts need. Its own node looks there unasked.
export NODE_PATH=/usr/share/nodejs
status=0
# report NAME COMMAND...: a line of what the command says and how long it took.
report() {
  local start=$SECONDS result
  result=$("${@:2}") || status=1
  printf '%-18s %s, %d s\n' "$1" "$result" $((SECONDS - start))
}

for name in "${builds[@]}"; do
  case $name in
    g++ | clang++)
      for flags in -O0 '-O0 -mfma' -O3 '-O3 -mfma'; do
        report "$name $flags" on_this_machine "$name" "$flags"
      done
      ;;
    msvc) report "$name" as_msvc ;;
    aarch64 | s390x | windows | wasm) report "$name" on_platform "$name" ;;
    *)
      echo "There is no build $name" >&2
      exit 2
      ;;
  esac
done
exit $status
