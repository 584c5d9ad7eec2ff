#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Checks that no folder includes one above it: what every object of a build was made of is compared with the table below,
# which docs/structure.md has. Usage: bash tests/layers.sh BUILD_FOLDER
set -euo pipefail
build=$(realpath "$1")
cd "$(dirname "$0")/.."

# FOLDER: the folders that it may include. All of them are named above it, so there is no cycle.
layers='
kernel:
kernel/judge: kernel
culler: kernel
culler/c: kernel culler
oracle:
render: kernel culler
culler/python: kernel culler oracle
oracle/cases: kernel oracle render
oracle/proof: kernel culler oracle render oracle/cases
fuzz: kernel oracle/cases
fuzz/bound_check: kernel kernel/judge culler oracle/cases fuzz
fuzz/differential: kernel kernel/judge culler oracle oracle/cases oracle/proof fuzz
fuzz/harness: kernel kernel/judge culler oracle render oracle/cases oracle/proof fuzz fuzz/differential
kernel/bench: kernel render fuzz
render/bench: kernel culler render kernel/bench
cli: kernel kernel/judge culler oracle render oracle/cases oracle/proof fuzz fuzz/differential kernel/bench render/bench
'

ninja -C "$build" -t deps | sed "s|^    $PWD/|    |; s|^    \(\.\./\)*|    |" | awk -v layers="$layers" '
  BEGIN {
    count = split(layers, lines, "\n")
    for (i = 1; i <= count; ++i) {
      if (lines[i] == "") continue
      split(lines[i], sides, ":")
      known[sides[1]] = 1
      wanted = split(sides[2], below, " ")
      for (k = 1; k <= wanted; ++k) {
        if (!(below[k] in known) || below[k] == sides[1]) wrong("the table: " sides[1] " stands below " below[k])
        allowed[sides[1], below[k]] = 1
      }
    }
  }
  function wrong(what) { if (!(what in said)) { said[what] = 1; print what; bad = 1 } }
  # The folder of the table that contains a file; none for files that are not ours, and for tests, which may include
  # everything.
  function folder(path, parts, n, two) {
    n = split(path, parts, "/")
    if (path ~ /^\// || n < 3) return ""
    if (parts[2] == "cli") return "cli"
    two = parts[1] "/" parts[2]
    return two in known ? two : parts[1] in known ? parts[1] : ""
  }
  /^[^ ]/ { source = ""; next }
  /^    / {
    path = substr($0, 5)
    # The first source of ours: a unity file, a precompiled header and files of the compiler may come before it.
    if (source == "" && path !~ /^[a-z].*\.cpp$/) next
    if (source == "") { source = path; from = folder(path); met[from] = 1; ++objects; next }
    to = folder(path)
    if (from != "" && to != "" && from != to && !((from, to) in allowed)) wrong(source " includes " path ": " from " may not include " to)
  }
  END {
    if (objects == 0) wrong("no object was built")
    for (name in known) if (!(name in met)) print "not checked, because not built: " name
    exit bad
  }'

# ROOM of the culler: the rooms that its files may include, beside the public headers, which include no room.
rooms='
include:
base:
camera: base
model: base
descent: base camera model
frusta: base camera model descent
cover: base camera model descent
scene: base camera model descent cover
inner: base model frusta
store: base model frusta cover
frame: base camera model descent frusta cover
'
grep -rHo --include="*.h" --include="*.cpp" '^#include "[a-z]*/' culler/*/ | awk -F '[/:"]' -v rooms="$rooms" '
  BEGIN {
    count = split(rooms, lines, "\n")
    for (i = 1; i <= count; ++i) {
      split(lines[i], sides, ":")
      wanted = split(sides[2], below, " ")
      known[sides[1]] = 1
      for (k = 1; k <= wanted; ++k) allowed[sides[1], below[k]] = 1
    }
    delete known[""]
  }
  { from = $2; to = $(NF - 1) }
  from in known && to in known { met[to] = 1 }
  from in known && to in known && from != to && !((from, to) in allowed) { print $0 ": culler/" from " may not include culler/" to; bad = 1 }
  END {
    if (!("base" in met)) { print "no room of the culler includes another"; bad = 1 }
    exit bad
  }'
echo "No folder includes what stands above it"
