# SPDX-License-Identifier: MIT
"""The documents hang together: each link leads to a file, and to a heading where it names one; each page of docs/ is in the
contents of the site; the README is short; and no row of figures stands in two places.
Usage: text_test.py FOLDER_OF_THE_PROJECT
"""
import collections
import pathlib
import re
import sys

from documents import documents

MOST_OF_README = 11000  # bytes: what one reads before deciding to go on


def prose(text):
    """Without blocks of code and code in lines, in which brackets mean something else."""
    return re.sub(r"`[^`\n]*`", "`code`", re.sub(r"^ *```.*?^ *```", "", text, flags=re.MULTILINE | re.DOTALL))


def headings(text):
    """The names by which links reach headings: on the site, and in a forge where that is the same."""
    names = set()
    for heading in re.findall(r"^#+ (.*)$", re.sub(r"^```.*?^```", "", text, flags=re.MULTILINE | re.DOTALL), re.MULTILINE):
        name = re.sub(r"[^\w\s-]", "", heading).strip().lower()
        if not re.search(r"[-\s]{2}", name):
            names.add(re.sub(r"\s", "-", name))
    return names


def faults_of_links(folder, document, text):
    for target in re.findall(r"\]\(([^)\s]+)\)", prose(text)):
        if re.match(r"[a-z]+:", target):
            continue
        path, _, heading = target.partition("#")
        file = (document.parent / path).resolve() if path else document
        if not file.is_file():
            yield f"{target} is no file"
        elif not file.is_relative_to(folder):
            yield f"{target} leads out of the project"
        elif any(part.startswith(".") for part in file.relative_to(folder).parts):
            yield f"{target} is in a folder that the site leaves out"
        elif heading and heading not in headings(file.read_text()):
            yield f"{target} is no heading"


def main(folder):
    faults = []
    rows = collections.defaultdict(list)
    links = 0
    for document in documents(folder):
        text = document.read_text()
        name = document.relative_to(folder)
        links += len(re.findall(r"\]\(", prose(text)))
        faults += [f"{name}: {fault}" for fault in faults_of_links(folder, document, text)]
        for row in set(re.findall(r"^ *(\|.*\|)$", text, re.MULTILINE)):
            if len(re.findall(r"\| *[<0-9][^|]*(?=\|)", row)) > 1:  # two cells that are numbers
                rows[re.sub(r"\s+", " ", row)].append(str(name))
    faults += [f"{' and '.join(places)} have the row {row}" for row, places in rows.items() if len(places) > 1]
    size = (folder / "README.md").stat().st_size
    if size > MOST_OF_README:
        faults.append(f"README.md has {size} bytes, more than {MOST_OF_README}")
    contents = (folder / "docs" / "mkdocs.yml").read_text()
    for page in sorted((folder / "docs").glob("*.md")):
        if f" docs/{page.name}\n" not in contents:
            faults.append(f"docs/mkdocs.yml: {page.name} is not in the contents")
    print("\n".join(faults + [f"{links} links, {len(rows)} rows of figures, {len(faults)} faults"]))
    return 1 if faults or links < 100 or len(rows) < 100 else 0


sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
