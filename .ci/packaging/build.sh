#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the Debian packages in build/debian, unpacks them there, and lets other programs link and run what is in them. Of the
# recipes for vcpkg and Conan, which Debian does not have, it sees that they parse; of all, that they name the project's version.
# Usage: bash .ci/packaging/build.sh (Debian 12, as root or with sudo where packages are missing)
set -euo pipefail
cd "$(dirname "$0")/../.."
bash .ci/packages.sh debhelper dpkg-dev

recipes=.ci/packaging
folder=$PWD/build/debian
version=$(sed -n 's/^project(occlude VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
# names_it FILE TEXT
names_it() { grep -qF "$2" "$recipes/$1" || { echo "$recipes/$1: not of version $version: no $2" >&2; exit 1; }; }
names_it debian/changelog "occlude ($version)"
names_it debian/control "Package: libocclude-c${version%.*}"
names_it vcpkg/vcpkg.json "\"version\": \"$version\""
names_it conan/conanfile.py "version = \"$version\""
python3 -c 'import ast, json, sys; json.load(open(sys.argv[1])); ast.parse(open(sys.argv[2]).read())' \
  "$recipes/vcpkg/vcpkg.json" "$recipes/conan/conanfile.py"

# The packages are built from a copy: `debian` would have to stand in the root.
rm -rf "$folder"
mkdir -p "$folder/source"
tar --create --exclude=./build --exclude=./.git . | tar --extract --directory "$folder/source"
cp -r "$recipes/debian" "$folder/source/"
(cd "$folder/source" && dpkg-buildpackage --build=binary --no-sign >"$folder/log.txt" 2>&1) ||
  { tail -n 30 "$folder/log.txt" >&2; exit 1; }

for package in "$folder"/*.deb; do dpkg-deb --extract "$package" "$folder/root"; done
cmake -S tests/package/consumer -B "$folder/consumer" -G Ninja -DCMAKE_PREFIX_PATH="$folder/root/usr" >>"$folder/log.txt"
cmake --build "$folder/consumer" >>"$folder/log.txt"
"$folder/consumer/consumer"
"$folder/consumer/c_consumer"
cmake -S tests/package/c_consumer -B "$folder/c_alone" -G Ninja -DCMAKE_PREFIX_PATH="$folder/root/usr" >>"$folder/log.txt"
cmake --build "$folder/c_alone" >>"$folder/log.txt"
"$folder/c_alone/consumer"  # with the shared library
ls "$folder"/*.deb
