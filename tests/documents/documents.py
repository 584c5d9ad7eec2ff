# SPDX-License-Identifier: MIT
"""The documents: the Markdown files of the project that are for people who use or change it."""


def documents(folder):
    """All but those in what a build makes or installs, in folders beside the project and in folders with a dot."""
    files = [file for file in sorted(folder.rglob("*.md"))
             if not any(part in ("build", "node_modules", "shared") or part.startswith(".") for part in file.relative_to(folder).parts)]
    assert len(files) > 20, f"only {len(files)} documents were found"
    return files
