#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# What the kernel, the culler and their tests need on a platform, from Debian's sources into FOLDER/prefix, once, and again when
# this script has changed: Debian has Highway and GoogleTest for this machine alone. Installs the compiler and what runs its programs.
# Usage: bash tests/platforms/libraries.sh aarch64|s390x|windows|wasm FOLDER
set -euo pipefail
cd "$(dirname "$0")/../.."
platform=$1 folder=$(realpath -m "$2")
mkdir -p "$folder"
exec >"$folder/libraries.txt" 2>&1

packages=(dpkg-dev googletest)
case $platform in
  windows) packages+=(g++-mingw-w64-x86-64-posix wine wine64) ;;
  wasm) packages+=(emscripten) ;;
  *) packages+=(qemu-user "g++-$platform-linux-gnu") ;;
esac
bash .ci/packages.sh "${packages[@]}"
[ "$folder/prefix/complete" -nt tests/platforms/libraries.sh ] && exit
rm -rf "$folder/prefix"

# Where Debian has what Emscripten's scripts need. Its own node looks there unasked.
export NODE_PATH=/usr/share/nodejs

# get_source RELEASE PACKAGE [PATTERN...]: the source of a package of this release of Debian, or the parts of it whose paths
# match, into FOLDER/PACKAGE, whether or not this machine lists sources.
get_source() {
  (
    cd "$folder"
    local apt=(apt-get -o "Dir::Etc::sourcelist=$PWD/sources.list" -o Dir::Etc::sourceparts=- -o "Dir::State::lists=$PWD/lists")
    rm -rf "$2" "$2"_*
    mkdir -p lists/partial "$2"
    echo "deb-src http://deb.debian.org/debian $1 main" >sources.list
    "${apt[@]}" update
    "${apt[@]}" source --download-only "$2"
    tar -xf "$2"_*.orig.tar.* -C "$2" --strip-components 1 --wildcards "${@:3}"
  )
}

# The standard library of Debian's Emscripten lacks much of C++20. That of LLVM 16 has it, and clang 14 can compile it. The
# rest of the runtime stays that of Emscripten, whose namespace, __2, is kept.
install_standard_library() {
  get_source bookworm llvm-toolchain-16 '*/libcxx/include' '*/libcxx/src'
  local sources=$folder/llvm-toolchain-16/libcxx include=$folder/prefix/include/c++/v1 objects=$folder/libcxx-build
  mkdir -p "$include" "$objects"
  cp -r "$sources/include/." /usr/share/emscripten/system/lib/libcxxabi/include/*.h "$include"
  printf '#define %s\n' '_LIBCPP_ABI_VERSION 2' '_LIBCPP_ABI_NAMESPACE __2' _LIBCPP_HAS_MUSL_LIBC \
    _LIBCPP_HAS_NO_VENDOR_AVAILABILITY_ANNOTATIONS '_LIBCPP_ENABLE_ASSERTIONS_DEFAULT 0' >"$include/__config_site"
  cat >"$objects/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.25)
project(standard_library CXX)
file(GLOB sources $sources/src/*.cpp $sources/src/ryu/*.cpp $sources/src/filesystem/[do]*.cpp)
add_library(c++16 STATIC \${sources})
target_include_directories(c++16 PRIVATE $sources/src)
target_compile_features(c++16 PRIVATE cxx_std_20)
target_compile_definitions(c++16 PRIVATE _LIBCPP_BUILDING_LIBRARY LIBCXX_BUILDING_LIBCXXABI _LIBCPP_DISABLE_VISIBILITY_ANNOTATIONS)
install(TARGETS c++16)
END
  install_library "$objects" libcxx-build/build
}

# take_bits_of_masks_at_once HEADER: by the instruction that WebAssembly has for it, where Highway takes one lane after the other.
take_bits_of_masks_at_once() {
  local lanes
  for lanes in 32x4 64x2; do
    local found="  const __i$lanes mask_i = static_cast<__i$lanes>(mask.raw);"
    grep -qxF "$found" "$1"
    sed -i "s/^$found\$/  return static_cast<uint32_t>(wasm_i${lanes}_bitmask(mask.raw));\n&/" "$1"
  done
}

# install_library SOURCE NAME OPTIONS...
install_library() {
  cmake -S "$1" -B "$folder/$2" -G Ninja "-DCMAKE_TOOLCHAIN_FILE=$PWD/tests/platforms/$platform.cmake" \
    -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=OFF "-DCMAKE_PREFIX_PATH=$folder/prefix" \
    "-DCMAKE_INSTALL_PREFIX=$folder/prefix" "${@:3}"
  cmake --build "$folder/$2" --target install
}

release=bookworm
if [ "$platform" = wasm ]; then
  release=trixie  # whose Highway has vectors of doubles there
  install_standard_library
fi
get_source "$release" highway
if [ "$platform" = wasm ]; then take_bits_of_masks_at_once "$folder/highway/hwy/ops/wasm_128-inl.h"; fi
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
