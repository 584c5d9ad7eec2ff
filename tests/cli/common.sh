# SPDX-License-Identifier: MIT
# What the tests of the command share: an empty folder to work in, and judgements. To be sourced with the path of the command.
occlude=$(realpath "$1")
here=$(mktemp -d)
trap 'chmod -R u+w "$here"; rm -rf "$here"' EXIT
cd "$here" || exit 1
failures=0

fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

# The last line of a test.
finish() {
  [ $failures -eq 0 ] && echo "All tests of $(basename "$0") passed"
  exit $failures
}

# expect_error TEXT COMMAND...: exit code 2, one line on stderr that holds TEXT, nothing on stdout, and no file made.
expect_error() {
  local text=$1 before after status
  shift
  before=$(find . ! -name 'std*' | sort)
  "$@" >stdout 2>stderr
  status=$?
  after=$(find . ! -name 'std*' | sort)
  [ $status -eq 2 ] || fail "exit code $status instead of 2: $*"
  [ "$(wc -l <stderr)" -eq 1 ] || fail "not one line: $* said: $(cat stderr)"
  grep -qF -- "$text" stderr || fail "'$text' is not in: $(cat stderr)"
  [ "$before" = "$after" ] || fail "left files behind: $*"
}

ply() { # ply FILE VERTICES FACES BODY: an ascii PLY
  printf 'ply\nformat ascii 1.0\nelement vertex %s\nproperty double x\nproperty double y\nproperty double z\nelement face %s\nproperty list uchar int vertex_indices\nend_header\n%b' "$2" "$3" "$4" >"$1"
}

# walls FILE: a wall at x = 2, and 63 more squares of its size behind it.
walls() {
  local vertices= faces= i
  for i in $(seq 0 63); do
    vertices+="$((2 + i)) -1 -1\n$((2 + i)) 1 -1\n$((2 + i)) 1 1\n$((2 + i)) -1 1\n"
    faces+="4 $((4 * i)) $((4 * i + 1)) $((4 * i + 2)) $((4 * i + 3))\n"
  done
  ply "$1" 256 64 "$vertices$faces"
}
