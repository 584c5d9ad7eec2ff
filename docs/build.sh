#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the site of the documents, with the reference of C++, C and Python and all options of the command. Installs MkDocs and
# Doxygen if they are missing, and builds the command and the Python module, which tell of themselves, if they are not there.
# Usage: bash docs/build.sh [BUILD_FOLDER [SITE]], default build/release and build/docs; then open build/docs/index.html, or, to
# search as well, serve the folder: python3 -m http.server --directory build/docs.
set -euo pipefail
build=$(realpath -m "${1:-$(dirname "$0")/../build/release}")
site=$(realpath -m "${2:-$(dirname "$0")/../build/docs}")
cd "$(dirname "$0")/.."
. docs/need_mkdocs.sh || bash .ci/packages.sh mkdocs mkdocs-material doxygen
if [ ! -x "$build/occlude" ] || [ ! -d "$build/python/occlude" ]; then
  bash .ci/packages.sh
  cmake --preset release >/dev/null
  cmake --build --preset release --target occlude python
fi

source=$(mktemp -d)
trap 'rm -rf "$source"' EXIT
# The documents, and the headers, examples and pictures that they link to, where they are in the project.
find . \( -path ./build -o -path ./.git -o -path ./tests/data/models -o -path ./shared -o -name node_modules \) -prune -o \
  \( -name '*.md' -o -name '*.css' -o -name '*.py' -o -path '*/include/*.h' -o -path '*/example/*' -o -path './render/images/*' \) -type f -print0 |
  tar --create --null --files-from=- | tar --extract --directory "$source"

# reference NAME FOLDER...: that of the headers in these folders. Its first page is read from standard input.
reference() {
  local name=$1
  shift
  cat >"$source/$name.md"
  {
    cat docs/Doxyfile
    echo "INPUT = $source/$name.md $*"
    echo "USE_MDFILE_AS_MAINPAGE = $source/$name.md"
    echo "OUTPUT_DIRECTORY = $source/docs"
    echo "HTML_OUTPUT = $name"
    [ "$name" = cpp ] || echo "OPTIMIZE_OUTPUT_FOR_C = YES"
  } | doxygen -
  rm "$source/$name.md"
}
reference cpp kernel/include culler/{base,model,camera,descent,cover,scene,inner,frame}/include <<'END'
# Reference of C++

- occlude::culler::Culler culls a model of polygons, occlude::culler::Scene a world of objects.
- occlude::culler::Camera and occlude::culler::MatrixCamera are what is seen, occlude::culler::View and
  occlude::culler::SceneView what is kept of one camera from frame to frame.
- occlude::culler::PolygonSoup is a model, occlude::culler::OccluderMesh what hides in a scene.
- occlude::kernel answers how one box lies to one shadow.
END
reference c culler/c/include <<'END'
# Reference of C

All of it is in occlude.h.
END
python=$(sed -n "s/^OCCLUDE_NUMPY_PYTHON:FILEPATH=//p" "$build/CMakeCache.txt")
PYTHONPATH=$build/python "$python" -B docs/python_reference.py >"$source/docs/python_reference.md"
# options WORD...: the help of this command, and of the commands below it.
options() {
  local help below
  help=$("$build/occlude" "$@" --help)
  printf '\n## occlude %s\n\n```text\n%s\n```\n' "$*" "$help"
  for below in $(sed -n '/^Subcommands:/,/^$/s/^  \([a-z]\{1,\}\) .*/\1/p' <<<"$help"); do options "$@" "$below"; done
}
{ echo "# Options"; options; } >"$source/docs/options.md"
cat >"$source/docs/reference.md" <<'END'
# Reference

- [C++](cpp/index.html): the headers of the kernel and of the culler
- [C](c/index.html): `occlude.h`
- [Python](python_reference.md): the module `occlude`
- [Options](options.md): all commands with all of their options
END
OCCLUDE_SITE_SOURCE=$source OCCLUDE_SITE=$site mkdocs build --strict --config-file docs/mkdocs.yml
echo "$site/index.html"
