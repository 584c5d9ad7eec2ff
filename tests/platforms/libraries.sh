#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# What the kernel, the culler and their tests need on a platform, from Debian's sources into FOLDER/prefix, once: Debian has
# Highway and GoogleTest for this machine alone. Installs the compiler and what runs its programs.
# Usage: bash tests/platforms/libraries.sh aarch64|s390x|windows FOLDER
set -euo pipefail
cd "$(dirname "$0")/../.."
platform=$1 folder=$(realpath -m "$2")
mkdir -p "$folder"
exec >"$folder/libraries.txt" 2>&1

packages=(dpkg-dev googletest)
case $platform in
  windows) packages+=(g++-mingw-w64-x86-64-posix wine wine64) ;;
  *) packages+=(qemu-user "g++-$platform-linux-gnu") ;;
esac
bash .ci/packages.sh "${packages[@]}"
[ -e "$folder/prefix/complete" ] && exit

# Debian's sources, whether or not this machine lists them.
get_highway() {
  local apt=(apt-get -o "Dir::Etc::sourcelist=$PWD/sources.list" -o Dir::Etc::sourceparts=- -o "Dir::State::lists=$PWD/lists")
  mkdir -p lists/partial highway
  echo "deb-src http://deb.debian.org/debian bookworm main" >sources.list
  "${apt[@]}" update
  "${apt[@]}" source --download-only highway
  tar -xf highway_*.orig.tar.* -C highway --strip-components 1
}

# install_library SOURCE NAME OPTIONS...
install_library() {
  cmake -S "$1" -B "$folder/$2" -G Ninja "-DCMAKE_TOOLCHAIN_FILE=$PWD/tests/platforms/$platform.cmake" \
    -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=OFF "-DCMAKE_INSTALL_PREFIX=$folder/prefix" "${@:3}"
  cmake --build "$folder/$2" --target install
}

(cd "$folder" && get_highway)
install_library "$folder/highway" highway-build -DBUILD_TESTING=OFF -DHWY_ENABLE_EXAMPLES=OFF -DHWY_ENABLE_CONTRIB=OFF
install_library /usr/src/googletest googletest-build -DBUILD_GMOCK=OFF
# GLM and the JSON parser are headers. The folder that holds them, /usr/include, must not be searched for this platform.
cmake_files=$folder/prefix/lib/cmake
mkdir -p "$cmake_files/hwy"
cp -r /usr/include/{glm,nlohmann} "$folder/prefix/include/"
cp -r /usr/share/cmake/{glm,nlohmann_json} "$cmake_files/"
cat >"$cmake_files/hwy/hwy-config.cmake" <<'END'
add_library(hwy::hwy STATIC IMPORTED)
set_target_properties(hwy::hwy PROPERTIES IMPORTED_LOCATION "${CMAKE_CURRENT_LIST_DIR}/../../libhwy.a"
  INTERFACE_INCLUDE_DIRECTORIES "${CMAKE_CURRENT_LIST_DIR}/../../../include")
END
touch "$folder/prefix/complete"
