#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The site of the documents is built without a warning, and has its pages. Usage: site_test.sh BUILD_FOLDER
set -euo pipefail
build=$(realpath "$1")
cd "$(dirname "$0")/../.."
. docs/need_mkdocs.sh || { echo "SKIPPED: no MkDocs with its theme, or no Doxygen (bash docs/build.sh installs them)"; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
bash docs/build.sh "$build" "$folder/site"
for page in index docs/tutorial docs/measured docs/options docs/python_reference culler/index docs/cpp/index docs/c/index; do
  [ -s "$folder/site/$page.html" ] || { echo "FAILED: there is no $page.html"; exit 1; }
done
grep -q 'class="language-cpp highlight"' "$folder/site/docs/tutorial.html" || { echo "FAILED: code has no colours"; exit 1; }
grep -qr 'occlude_scene_cull' "$folder/site/docs/c" || { echo "FAILED: the reference of C lacks a function"; exit 1; }
grep -q 'add_occluder' "$folder/site/docs/python_reference.html" || { echo "FAILED: that of Python lacks a method"; exit 1; }
if grep -rlE '(src|href)="(https?:)?//[^"]*\.(js|css|woff2?)"' "$folder/site"; then
  echo "FAILED: these pages load something from elsewhere"
  exit 1
fi
echo "The site is whole"
