#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks that no two classes have the same name. The program would take the functions of one for those of the other, which
no compiler or linker tells.

Usage: names_test.py FOLDER"""
import collections
import pathlib
import re
import sys

# What hides braces: comments, raw strings, strings and characters.
TEXT = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\])\'', re.DOTALL)
# A namespace, a class that is defined there, or any other brace.
BRACE = re.compile(r"namespace\s*(?P<space>[\w:]*)\s*\{"
                   r"|(?:struct|class|union|enum)\s+(?:class\s+)?(?:alignas\(\w+\)\s+)?(?P<name>[\w:]+)\s*(?:final\s*)?"
                   r"(?::(?!:)[^;{}]*)?\{"
                   r"|[{}]")


def classes(text):
    """The full names of the classes that the file defines, but for those that no other file sees."""
    around = []
    for brace in BRACE.finditer(TEXT.sub('""', text)):
        if brace[0] == "}":
            around.pop()
        elif brace["space"] is not None:
            around.append(brace["space"] or None)
        else:
            if brace["name"] and None not in around:
                yield "::".join(around + [brace["name"]])
            around.append(brace["name"])
    assert not around, "braces do not match"


def main():
    root = pathlib.Path(sys.argv[1])
    files = collections.defaultdict(set)
    for folder in "kernel", "culler", "oracle", "render", "fuzz":
        for file in sorted((root / folder).rglob("*")):
            if file.suffix in (".h", ".cpp"):
                for name in classes(file.read_text()):
                    files[name].add(str(file.relative_to(root)))
    twice = {name: places for name, places in files.items() if len(places) > 1}
    for name, places in twice.items():
        print(f"{name} is defined in {' and '.join(sorted(places))}")
    assert len(files) > 500, f"only {len(files)} classes were found"
    print(f"{len(files)} classes, {len(twice)} names of several")
    return 1 if twice else 0


if __name__ == "__main__":
    sys.exit(main())
