#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# One file of tests of the JavaScript package, as it lies in culler/js/dist. Skipped, with exit code 77, where there is no node of
# version 20 or later, or the package was not built (culler/js/build.sh). Tests of it that need more say so when they are skipped.
# Usage: test.sh NAME
set -uo pipefail
tests=$(realpath "$(dirname "$0")")
if ! node --input-type=module --eval 'process.exit(parseInt(process.versions.node) >= 20 ? 0 : 1)' 2>/dev/null ||
  [ ! -e "$tests/../../culler/js/dist/occlude.wasm" ]; then
  echo "no node of version 20, or no package in culler/js/dist (culler/js/build.sh): skipped"
  exit 77
fi
exec node --expose-gc --test --test-reporter=spec "$tests/$1.test.mjs"
