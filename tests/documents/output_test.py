# SPDX-License-Identifier: MIT
"""A document shows what a program prints: all lines of it, one after another, in a block of text.
Usage: output_test.py DOCUMENT PROGRAM
"""
import pathlib
import re
import subprocess
import sys


def main(document, program):
    printed = subprocess.run([program], stdout=subprocess.PIPE, text=True, check=True).stdout
    if printed and printed in re.findall(r"^```text\n(.*?)^```", pathlib.Path(document).read_text(), re.MULTILINE | re.DOTALL):
        return 0
    print(f"{document} does not have what {program} prints:\n{printed}")
    return 1


sys.exit(main(*sys.argv[1:]))
