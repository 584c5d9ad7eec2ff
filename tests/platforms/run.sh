#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The kernel's and the culler's tests on other platforms: 64-bit ARM and a big-endian machine under QEMU, and Windows under Wine.
# The answers have the hash of x86-64. One line a platform; exit 1 when one fails.
# Usage: bash tests/platforms/run.sh [aarch64|s390x|windows]... (Debian 12, as root or with sudo; half an hour on two cores)
set -euo pipefail
cd "$(dirname "$0")/../.."
platforms=("$@")
[ $# -gt 0 ] || platforms=(aarch64 s390x windows)
here=$PWD/build/platforms
mkdir -p "$here"

as_root=()
[ "$(id -u)" -eq 0 ] || as_root=(sudo)
DEBIAN_FRONTEND=noninteractive "${as_root[@]}" apt-get install -y -qq --no-install-recommends googletest qemu-user \
  g++-aarch64-linux-gnu g++-s390x-linux-gnu g++-mingw-w64-x86-64-posix wine wine64 >"$here/packages.log" 2>&1

# Debian's Highway as sources: its libraries are for this machine alone.
fetch_highway() {
  [ -d "$here/highway" ] && return
  local apt=(apt-get -o "Dir::Etc::sourcelist=$here/sources.list" -o Dir::Etc::sourceparts=- -o "Dir::State::lists=$here/lists")
  mkdir -p "$here/lists/partial"
  echo "deb-src http://deb.debian.org/debian bookworm main" >"$here/sources.list"
  (cd "$here" && "${apt[@]}" update -qq && "${apt[@]}" source -qq --download-only highway && mkdir highway.new &&
    tar -xf highway_*.orig.tar.* -C highway.new --strip-components 1 && mv highway.new highway) >"$here/highway.log" 2>&1
}

# build_libraries FOLDER TOOLCHAIN: Highway, GoogleTest and GLM for the platform, in FOLDER/prefix.
build_libraries() {
  local prefix=$1/prefix options=(-G Ninja "-DCMAKE_TOOLCHAIN_FILE=$2" -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=OFF
    "-DCMAKE_INSTALL_PREFIX=$1/prefix")
  [ -e "$prefix/complete" ] && return
  cmake -S "$here/highway" -B "$1/highway" "${options[@]}" -DBUILD_TESTING=OFF -DHWY_ENABLE_EXAMPLES=OFF -DHWY_ENABLE_CONTRIB=OFF
  cmake --build "$1/highway" --target install
  cmake -S /usr/src/googletest -B "$1/googletest" "${options[@]}" -DBUILD_GMOCK=OFF
  cmake --build "$1/googletest" --target install
  cp -r /usr/include/glm "$prefix/include/"
  cp -r /usr/share/cmake/glm "$prefix/lib/cmake/"
  mkdir -p "$prefix/lib/cmake/hwy"
  cat >"$prefix/lib/cmake/hwy/hwy-config.cmake" <<'END'
add_library(hwy::hwy STATIC IMPORTED)
set_target_properties(hwy::hwy PROPERTIES IMPORTED_LOCATION "${CMAKE_CURRENT_LIST_DIR}/../../libhwy.a"
  INTERFACE_INCLUDE_DIRECTORIES "${CMAKE_CURRENT_LIST_DIR}/../../../include")
END
  touch "$prefix/complete"
}

# build_and_test PLATFORM: "passed" or "FAILED" and how many tests; the log stays beside the build.
build_and_test() {
  local folder=$here/$1 toolchain=$PWD/tests/platforms/$1.cmake
  mkdir -p "$folder"
  {
    build_libraries "$folder" "$toolchain"
    cmake -S . -B "$folder/build" -G Ninja "-DCMAKE_TOOLCHAIN_FILE=$toolchain" "-DCMAKE_PREFIX_PATH=$folder/prefix" \
      -DCMAKE_BUILD_TYPE=Release -DOCCLUDE_TOOLS=OFF
    cmake --build "$folder/build" --target kernel_tests culler_tests
  } >"$folder/log.txt" 2>&1 || { echo "FAILED to build: $folder/log.txt"; return 1; }
  local result=passed
  ctest --test-dir "$folder/build" --parallel "$(nproc)" --label-regex '^(kernel|culler)$' --exclude-regex '^example' \
    >>"$folder/log.txt" 2>&1 || result=FAILED
  echo "$result, $(grep -o '[0-9]* tests failed out of [0-9]*' "$folder/log.txt" || echo "see $folder/log.txt")"
  [[ $result == passed ]]
}

fetch_highway
status=0
for platform in "${platforms[@]}"; do
  start=$SECONDS
  result=$(build_and_test "$platform") || status=1
  printf '%-8s %s, %d s\n' "$platform" "$result" $((SECONDS - start))
done
exit $status
