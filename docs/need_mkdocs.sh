# SPDX-License-Identifier: MIT
# To be sourced. True if what the site is made with is there: MkDocs with Debian's theme, and Doxygen.
command -v mkdocs >/dev/null && command -v doxygen >/dev/null && [ -d /usr/share/mkdocs/themes/material ]
