# SPDX-License-Identifier: MIT
# What the tests of the command share: an empty folder to work in, and checks. Source it with the path of the command.
occlude=$(realpath "$1")
here=$(mktemp -d)
export XDG_STATE_HOME=$here.state # for the key that seals parts
trap 'chmod -R u+w "$here"; rm -rf "$here" "$XDG_STATE_HOME"' EXIT
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

# expect_error TEXT COMMAND...: expects exit code 2, one line on stderr that contains TEXT, nothing on stdout, and no new
# file.
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

# proves MODEL FILE PAIRS: validate proves all of the file, which has so many pairs.
proves() {
  "$occlude" validate "$1" --witness "$2" >stdout 2>stderr || fail "validate $2: $(cat stdout stderr)"
  grep -qx "$3 of $3 hidden pairs of eyes and polygon proved" stdout || fail "validate $2: $3 pairs expected: $(cat stdout)"
  grep -qxE '([0-9]+) of \1 witnesses proved' stdout || fail "validate $2: $(cat stdout)"
}

# finds_lie MODEL FILE WHAT SED_SCRIPT: validate finds the file out once the script has changed it.
finds_lie() {
  sed "$4" "$2" >lie.jsonl
  cmp -s "$2" lie.jsonl && fail "the lie about $3 changed nothing"
  "$occlude" validate "$1" --witness lie.jsonl >stdout 2>stderr
  [ $? -eq 1 ] && grep -q '^lie.jsonl:' stderr || fail "a lie about $3 was believed: $(cat stdout stderr)"
}

# walls FILE: writes a wall at x = 2 and 63 squares of the same size behind it.
walls() {
  local vertices= faces= i
  for i in $(seq 0 63); do
    vertices+="$((2 + i)) -1 -1\n$((2 + i)) 1 -1\n$((2 + i)) 1 1\n$((2 + i)) -1 1\n"
    faces+="4 $((4 * i)) $((4 * i + 1)) $((4 * i + 2)) $((4 * i + 3))\n"
  done
  ply "$1" 256 64 "$vertices$faces"
}

# walk_of_squares: writes good.ply, those walls; path.json, a walk of four frames towards them; and back.json, the same walk
# looking away.
walk_of_squares() {
  walls good.ply
  echo '{"frames":4,"keyframes":[{"eye":[0,0,0],"target":[1,0,0]},{"eye":[0.5,0,0],"target":[1.5,0,0]}]}' >path.json
  sed 's/"target":\[1,0,0\]/"target":[-1,0,0]/; s/"target":\[1.5,0,0\]/"target":[-0.5,0,0]/' path.json >back.json
}

# room: writes room.ply, a room of 8 by 6 and 3 high, open at one end, with a wall and a way past it.
room() {
  local vertices='0 0 0\n8 0 0\n8 6 0\n0 6 0\n0 0 3\n8 0 3\n8 6 3\n0 6 3\n4 0 0\n4 4 0\n4 4 3\n4 0 3\n'
  ply room.ply 12 6 "${vertices}4 0 1 2 3\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 8 9 10 11\n"
}

# slanting_wall: writes slanting.ply, a wall and behind it a slanting one of 64 tiles, for trees of oriented boxes.
slanting_wall() {
  local vertices faces i along up
  vertices='2 -1 -1\n2 1 -1\n2 1 1\n2 -1 1\n' faces='4 0 1 2 3\n' i=4
  for along in $(seq 0 7); do
    for up in $(seq 0 7); do
      vertices+="$((4 + along)) $((along - 4)) $((up - 4))\n$((5 + along)) $((along - 3)) $((up - 4))\n"
      vertices+="$((5 + along)) $((along - 3)) $((up - 3))\n$((4 + along)) $((along - 4)) $((up - 3))\n"
      faces+="4 $i $((i + 1)) $((i + 2)) $((i + 3))\n"
      i=$((i + 4))
    done
  done
  ply slanting.ply 260 65 "$vertices$faces"
}

# three_cases: writes cases.jsonl, three cases of one wall. $case has the wall, without a box.
case='"eye":[0,0,0],"occluder":{"polygon":[[2,-1,-1],[2,1,-1],[2,1,1],[2,-1,1]]},"near":"surface"'
three_cases() {
  cat >cases.jsonl <<END
{"id":"inside",$case,"box":{"min":[4,-2,-2],"max":[4,2,2]},"expect":"inside"}
{"id":"reversed",$case,"box":{"min":[4,2,-2],"max":[4,1,2]}}
{"id":"touch",$case,"box":{"min":[4,2,0],"max":[4,3,1]},"expect":"partial"}
END
}

# await COMMAND...: waits until COMMAND succeeds, for at most a minute.
await() {
  local try
  for try in $(seq 600); do
    ! "$@" || return 0
    sleep 0.1
  done
  fail "waited in vain for: $*"
}

has_leftovers() { [ -n "$(find . -name '.occlude*')" ]; }
# has_begun PROCESS: it has begun an output here, which has no name yet, or a temporary one.
has_begun() { ls -l "/proc/$1/fd" 2>/dev/null | grep -qE "$here/(.*/)?(#[0-9]+ \(deleted\)|\.occlude\.tmp-.*)\$"; }

# interrupt SIGNAL COMMAND...: sends SIGNAL to COMMAND once it has begun an output. Expects exit code 130 and nothing left of
# the output.
interrupt() {
  local signal=$1 status
  shift
  "$@" >stdout 2>stderr &
  await has_begun $!
  kill -"$signal" $!
  wait $!
  status=$?
  [ $status -eq 130 ] || fail "exit code $status after SIG$signal: $*: $(cat stderr)"
  ! has_leftovers || fail "SIG$signal leaves $(find . -name '.occlude*'): $*"
}

# interrupt_reader COMMAND...: sends SIGINT to COMMAND while it waits for input from the pipe `pipe`. Expects exit code 130.
interrupt_reader() {
  local status writer
  mkfifo pipe
  "$@" >/dev/null 2>stderr &
  exec {writer}>pipe # opened once there is a reader
  kill -INT $!
  wait $!
  status=$?
  exec {writer}>&-
  rm pipe
  [ $status -eq 130 ] || fail "exit code $status, $* does not stop while it waits: $(cat stderr)"
}
