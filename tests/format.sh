#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Checks that every file of C++ and C is formatted as by clang-format 14 with .clang-format; --fix formats them. Usage: bash
# tests/format.sh [--fix]
set -euo pipefail
cd "$(dirname "$0")/.."
how=(--dry-run -Werror)
[ "${1:-}" != --fix ] || how=(-i)
find . -path ./build -prune -o \( -name '*.h' -o -name '*.cpp' -o -name '*.c' \) -print0 | xargs -0 clang-format "${how[@]}"
