# SPDX-License-Identifier: MIT
"""The C++ and the C that the documents show is code of the examples, which are compiled and run: each block, but for its indentation
and blank lines, stands in one of them as it is.
Usage: code_test.py FOLDER_OF_THE_PROJECT
"""
import pathlib
import re
import sys

from documents import documents

KINDS = ("cpp", "c")  # names of blocks, and endings of files


def lines_of(text):
    return [line.strip() for line in text.splitlines() if line.strip()]


def is_part(block, whole):
    return any(whole[i : i + len(block)] == block for i in range(len(whole) - len(block) + 1))


def main(folder):
    examples = {kind: [lines_of(path.read_text()) for path in sorted(folder.glob(f"*/example/*.{kind}"))] for kind in KINDS}
    blocks = failures = 0
    for document in documents(folder):
        text = document.read_text()
        for match in re.finditer(r"^```(cpp|c)\n(.*?)^```", text, re.MULTILINE | re.DOTALL):
            blocks += 1
            # Between lines of three dots the parts may stand anywhere.
            for part in re.split(r"^\s*// …\n", match[2], flags=re.MULTILINE):
                if not any(is_part(lines_of(part), example) for example in examples[match[1]]):
                    failures += 1
                    line = text.count("\n", 0, match.start()) + 1
                    print(f"{document}:{line}: this code is in no example:\n{part}")
    print(f"{blocks} blocks of code, {failures} in no example")
    return 1 if failures or not blocks else 0


sys.exit(main(pathlib.Path(sys.argv[1])))
