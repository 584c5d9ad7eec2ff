#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# clang-tidy, with what .clang-tidy asks for, over the kernel and the culler. Minutes of processor time: not of continuous
# integration. Usage: bash tests/tidy.sh
set -euo pipefail
cd "$(dirname "$0")/.."
bash .ci/packages.sh clang clang-tidy
cmake --preset clang -DCMAKE_EXPORT_COMPILE_COMMANDS=ON >/dev/null
find kernel/src culler/src -name "*.cpp" -print0 |
  xargs -0 --max-args 1 --max-procs "$(nproc)" clang-tidy -p build/clang --quiet
echo "The kernel and the culler are tidy"
