#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs clang-tidy with .clang-tidy on the kernel and the culler. It takes minutes of processor time, so it is not a part of
# continuous integration. Usage: bash tests/tidy.sh
set -euo pipefail
cd "$(dirname "$0")/.."
bash .ci/packages.sh clang clang-tidy
# Each file has a command of its own.
cmake --preset clang -B build/tidy -DCMAKE_UNITY_BUILD=OFF -DOCCLUDE_TOOLS=OFF -DCMAKE_EXPORT_COMPILE_COMMANDS=ON >/dev/null
find kernel/src kernel/judge/src culler/{base,camera,model,descent,frusta,cover,scene,inner,store,frame} -name "*.cpp" -print0 |
  xargs -0 --max-args 1 --max-procs "$(nproc)" clang-tidy -p build/tidy --quiet
echo "The kernel and the culler are tidy"
