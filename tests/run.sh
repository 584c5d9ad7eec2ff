#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs what is missing, builds and runs the tests. Usage: bash tests/run.sh [PRESET], default release.
set -euo pipefail
cd "$(dirname "$0")/.."
preset=${1:-release}
compilers=()
case $preset in
  clang) compilers=(clang) ;;
  sanitizers) compilers=(clang libclang-rt-dev) ;;
esac
bash .ci/packages.sh "${compilers[@]}"
cmake --preset "$preset" >/dev/null
cmake --build --preset "$preset"
ctest --preset "$preset" --parallel "$(nproc)"
