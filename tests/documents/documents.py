# SPDX-License-Identifier: MIT
"""The documents: all Markdown files of the project."""


def documents(folder):
    """In the root, in docs/ and in the modules, but for what a build makes."""
    files = [file for file in sorted(folder.rglob("*.md")) if file.relative_to(folder).parts[0] not in ("build", ".git", "shared")]
    assert len(files) > 20, f"only {len(files)} documents were found"
    return files
