#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The wheel of the Python module, made by the command that culler/python/README.md gives, without a network: it is installed
# elsewhere, where the examples of that page run.
# Usage: wheel_test.sh PYTHON; exit code 77 where that Python has no pip, setuptools or wheel
set -uo pipefail
python=$1
source=$(realpath "$(dirname "$0")/../..")
here=$(mktemp -d)
trap 'rm -rf "$here"' EXIT

fail() {
  echo "FAILED: $*"
  exit 1
}

"$python" -c 'import setuptools, wheel, pip' 2>/dev/null || { echo "no pip, setuptools and wheel: skipped"; exit 77; }
cd "$source"
before=$(find . -path ./build -prune -o -path ./.git -prune -o -print | sort)
command=$(grep -m1 '^python3 -m pip wheel ' docs/python.md) || fail "docs/python.md gives no command"
read -ra words <<<"$command"
"$python" "${words[@]:1}" --no-index --wheel-dir "$here" >"$here/log" 2>&1 || fail "no wheel is made: $(cat "$here/log")"
diff <(echo "$before") <(find . -path ./build -prune -o -path ./.git -prune -o -print | sort) || fail "it leaves files"

"$python" -m pip install --no-index --no-deps --no-compile --target "$here/site" "$here"/occlude-*.whl >"$here/log" 2>&1 ||
  fail "it cannot be installed: $(cat "$here/log")"
for file in LICENSE py.typed _occlude.pyi; do
  [ -e "$here/site/occlude/$file" ] || fail "no $file"
done
for test in readme stubs; do
  PYTHONPATH="$here/site" "$python" -B "tests/python/${test}_test.py" || fail "$test"
done
