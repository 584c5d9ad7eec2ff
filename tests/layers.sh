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
culler/js: kernel culler culler/c
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

# ROOM of the culler: the rooms whose files and public headers it may include.
rooms='
base:
model: base
camera: base model
descent: base model camera
frusta: base model camera descent
cover: base model camera descent
scene: base model camera descent cover
inner: base model frusta
frame: base model camera descent frusta cover
simplify: base model camera descent frusta cover frame inner
held: base model camera descent cover scene frame
store: base model frusta cover frame
'
{
  ls culler/*/include/occlude/culler/*.h
  grep -rHoE --include="*.h" --include="*.cpp" '^#include "([a-z]+|occlude/culler)/[a-z_]+\.h' culler/*/
} | awk -F ':#include "' -v rooms="$rooms" '
  BEGIN {
    count = split(rooms, lines, "\n")
    for (i = 1; i <= count; ++i) {
      if (lines[i] == "") continue
      split(lines[i], sides, ":")
      wanted = split(sides[2], below, " ")
      known[sides[1]] = 1
      for (k = 1; k <= wanted; ++k) allowed[sides[1], below[k]] = 1
    }
  }
  { split($1, path, "/"); from = path[2] }
  NF == 1 { home[substr($1, index($1, "occlude/"))] = from; next }
  { split($2, path, "/"); to = $2 in home ? home[$2] : path[1] }
  from in known && to in known && from != to {
    ++arrows
    if (!((from, to) in allowed)) { print $1 " includes " $2 ": culler/" from " may not include culler/" to; bad = 1 }
  }
  END {
    if (arrows < 100) { print "rooms of the culler hardly include each other"; bad = 1 }
    exit bad
  }'
echo "No folder includes what stands above it"
