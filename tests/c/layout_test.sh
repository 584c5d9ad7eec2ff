#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# No struct of occlude.h that begins with its size ends in padding (layout.h), on machines with pointers of 64 bits and of 32,
# where numbers of 64 bits lie at multiples of 4 bytes or of 8. It names each that begins so.
# Usage: layout_test.sh FOLDER_OF_THE_C_INTERFACE C_COMPILER
set -euo pipefail
folder=$1 compiler=$2
layout=$folder/src/layout.h
structs=$(grep -B 1 'size_t size; .*of this struct' "$folder/include/occlude.h" | sed -n 's/^typedef struct \(occlude_[a-z_]*\) {$/\1/p' | sort)
diff <(echo "$structs") <(sed -n 's/^OCCLUDE_LAST_MEMBER(\(occlude_[a-z_]*\),.*/\1/p' "$layout" | sort) ||
  { echo "FAILED: structs with sizes (<), structs that are asked about (>)"; exit 1; }
for machine in -m64 -m32 '-m32 -malign-double'; do
  # Without the headers of a C library, which need not be there for 32 bits.
  "$compiler" $machine -std=c11 -ffreestanding -fsyntax-only -I "$folder/include" -include "$layout" -x c /dev/null ||
    { echo "FAILED: $machine"; exit 1; }
done
echo "$(wc -w <<<"$structs") structs end in a member on every machine"
