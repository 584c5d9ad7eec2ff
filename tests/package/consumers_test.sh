#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The libraries as other programs meet them: installed, the installed folder moved, and small programs in C++ and in C that
# link them through CMake, through pkg-config, and with the sources inside their own project, whatever that compiles with.
# Usage: consumers_test.sh BUILD_FOLDER COMPILER
set -uo pipefail
build=$(realpath "$1") compiler=$2
tests=$(realpath "$(dirname "$0")")
source=${tests%/tests/package}
here=$(mktemp -d)
trap 'rm -rf "$here"' EXIT
cd "$here"
failures=0

fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

# run_consumer HOW [PROGRAM]: the program's answer.
run_consumer() {
  "$1/${2:-consumer}" >stdout 2>&1 || fail "$1: exit code $?: $(cat stdout)"
}

launcher=$(command -v ccache || true)
# configure_consumer HOW OPTIONS...: none of the flags that the project gives itself may reach the program.
configure_consumer() {
  cmake -S "$tests/consumer" -B "$1" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_EXPORT_COMPILE_COMMANDS=ON \
    -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_COMPILER_LAUNCHER="$launcher" "${@:2}" >log 2>&1 ||
    { fail "$1: is not configured: $(cat log)"; return 1; }
  grep '"command".*/consumer\.dir/' "$1/compile_commands.json" >command || fail "$1: no command compiles it"
  if grep -E -- '-fno-fast-math|-ffp-contract|-Wconversion' command; then fail "$1: compiled with our flags"; fi
}
# cmake_consumer HOW OPTIONS...: configures, builds and runs the program.
cmake_consumer() {
  configure_consumer "$@" || return
  cmake --build "$1" --parallel 2 >log 2>&1 || { fail "$1: does not build: $(cat log)"; return; }
  run_consumer "$1"
  run_consumer "$1" c_consumer
}

cmake --install "$build" --prefix "$here/first" >log 2>&1 || { fail "install: $(cat log)"; exit 1; }
mkdir elsewhere && mv first elsewhere/second
prefix=$here/elsewhere/second

# What is there.
headers() { (cd "$1" && find . -path './occlude/*' -name '*.h'); }
diff <(for folder in "$source"/kernel/include "$source"/culler/*/include; do headers "$folder"; done | sort) <(headers "$prefix/include" | sort) ||
  fail "not the public headers"
[ "$(headers "$prefix/include" | grep -c '^./occlude/culler/')" -le 13 ] || fail "more headers of the culler than one remembers"
cmp "$source/culler/c/include/occlude.h" "$prefix/include/occlude.h" || fail "not the header of the C interface"
[ -s "$prefix/share/doc/occlude/LICENSE" ] || fail "no licence"
# Documents, of which each link leads to something that is installed; and examples, which are programs of their own.
documents=$prefix/share/doc/occlude
[ "$(ls "$documents/docs")" = "$(cd "$source/docs" && ls ./*.md | xargs -n 1 basename)" ] || fail "not the guides"
links=0
for document in "$documents"/*.md "$documents"/docs/*.md; do
  for link in $(sed '/^ *```/,/^ *```$/d; s/`[^`]*`//g' "$document" | grep -oE '\]\([^)[:space:]]+\)' | sed 's/^](//; s/)$//; s/#.*//'); do
    [[ $link == http* ]] || [ -e "$(dirname "$document")/$link" ] || fail "$document: $link is not installed"
    links=$((links + 1))
  done
done
[ $links -gt 50 ] || fail "only $links links in documents"
if {
  cmake -S "$documents/examples" -B examples -G Ninja -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_CXX_COMPILER="$compiler" \
    -DCMAKE_CXX_COMPILER_LAUNCHER="$(command -v ccache)" && cmake --build examples --parallel 2
} >log 2>&1; then
  for example in contents matrix model scene tutorial scene_in_c; do run_consumer examples "$example"; done
else
  fail "examples: do not build: $(cat log)"
fi
if [ -e "$build/occlude" ]; then
  "$prefix/bin/occlude" --version >log 2>&1 || fail "the command: $(cat log)"
  grep -q 'SH OCCLUDE WALK' "$prefix/share/man/man1/occlude.1" || fail "no manual page"
  grep -q 'complete .* occlude$' "$prefix/share/bash-completion/completions/occlude" || fail "no completion"
fi
# Assertions and debug information name the sources. A release has neither; of other builds only the text files are searched.
binaries=without-match
grep -q '^CMAKE_BUILD_TYPE:.*=Release$' "$build/CMakeCache.txt" && binaries=text
grep -rlF --binary-files=$binaries -e "$source/" -e "$build" -e "$here" "$prefix" &&
  fail "these files know where they were made"

cmake_consumer find_package -DOCCLUDE_BY=find_package -DCMAKE_PREFIX_PATH="$prefix"
package=$(dirname "$(find "$prefix" -name occlude-config.cmake)")
echo 'find_package(occlude ${wanted} REQUIRED CONFIG)' >find.cmake
for version in 0.0 0.2 1.0; do
  cmake -Docclude_DIR="$package" -Dwanted=$version -P find.cmake >log 2>&1 && fail "taken for version $version"
  grep -qF "compatible with requested version \"$version\"" log || fail "version $version: $(cat log)"
done

export PKG_CONFIG_PATH
PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name occlude.pc)")
mkdir pkg-config
# Every header is compiled, and the program linked.
headers "$prefix/include" | sed 's/.*/#include <&>/' >all.h
if flags=$(pkg-config --cflags --libs occlude 2>&1) &&
  "$compiler" -std=c++20 -Wall -Wextra -Werror -include all.h "$tests/consumer/main.cpp" $flags -o pkg-config/consumer \
    >log 2>&1; then
  run_consumer pkg-config
else
  fail "pkg-config: does not build: $flags $(cat log)"
fi

# A program in C, by a C compiler: with the shared library nothing of C++ is needed.
compiler_of_c=$(command -v cc)
if flags=$(pkg-config --cflags --libs occlude-c 2>&1) &&
  "$compiler_of_c" -std=c11 -pedantic -Wall -Wextra -Werror "$tests/c_consumer/main.c" $flags -o pkg-config/c_consumer \
    >log 2>&1; then
  LD_LIBRARY_PATH=$(pkg-config --variable=libdir occlude-c) run_consumer pkg-config c_consumer
else
  fail "pkg-config in C: does not build: $flags $(cat log)"
fi
if {
  cmake -S "$tests/c_consumer" -B c_alone -G Ninja -DCMAKE_PREFIX_PATH="$prefix" && cmake --build c_alone
} >log 2>&1; then
  run_consumer c_alone
else
  fail "CMake in C: does not build: $(cat log)"
fi

# With the sources inside. FetchContent adds the folder as add_subdirectory does, so one of them builds the libraries anew: as
# shared ones, in few optimisations and few files, because that is most of the time.
configure_consumer add_subdirectory -DOCCLUDE_BY=add_subdirectory -DOCCLUDE_FOLDER="$source"
cmake_consumer hostile_FetchContent -DOCCLUDE_BY=FetchContent -DOCCLUDE_FOLDER="$source" -DCMAKE_BUILD_TYPE=None \
  -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=0 -DCMAKE_CXX_FLAGS='-O1 -ffast-math -Wall -Wextra -Werror' \
  -DBUILD_SHARED_LIBS=ON -DOCCLUDE_INSTALL=ON

# The shared libraries, installed and moved: a program of CMake finds them, and others in the folder that pkg-config names.
cmake --install hostile_FetchContent --prefix "$here/third" >log 2>&1 || fail "install of shared libraries: $(cat log)"
mv third elsewhere/fourth
rm -r hostile_FetchContent
prefix=$here/elsewhere/fourth
[ -z "$(find "$prefix" -name 'libocclude_[!c]*.a' -o -name 'libocclude_culler.a')" ] || fail "static libraries beside shared ones"
cmake_consumer shared -DOCCLUDE_BY=find_package -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_DISABLE_FIND_PACKAGE_hwy=ON
PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name occlude.pc)")
export LD_LIBRARY_PATH
LD_LIBRARY_PATH=$(pkg-config --variable=libdir occlude)
mkdir shared_pkg-config
if flags=$(pkg-config --cflags --libs occlude 2>&1) && [[ $flags != *hwy* ]] &&
  "$compiler" -std=c++20 -Wall -Wextra -Werror "$tests/consumer/main.cpp" $flags -o shared_pkg-config/consumer >log 2>&1 &&
  flags=$(pkg-config --cflags --libs occlude-c 2>&1) &&
  "$compiler_of_c" -std=c11 "$tests/c_consumer/main.c" $flags -o shared_pkg-config/c_consumer >log 2>&1; then
  run_consumer shared_pkg-config
  run_consumer shared_pkg-config c_consumer
else
  fail "pkg-config of shared libraries: does not build: $flags $(cat log)"
fi

[ $failures -eq 0 ] && echo "All package tests passed"
exit $failures
