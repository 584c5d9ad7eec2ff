#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# What the command may replace and remove, and what happens to output that cannot be written.
# Usage: outputs_test.sh PATH_OF_OCCLUDE
set -uo pipefail
. "$(dirname "$0")/common.sh"

walls good.ply
echo '{"frames":4,"keyframes":[{"eye":[0,0,0],"target":[1,0,0]},{"eye":[0.5,0,0],"target":[1.5,0,0]}]}' >path.json
"$occlude" walk good.ply --path path.json --out walked --size 64x36 --witness witness.jsonl >/dev/null || fail "walk"
"$occlude" preprocess good.ply --out good.pre --region-count 64 >/dev/null || fail "preprocess"
sed 's/"triangles":\[[0-9]*,[0-9]*\]/"triangles":[0,128]/' witness.jsonl >lie.jsonl # says that the visible wall is culled
echo '{"id":"a","eye":[0,0,0],"occluder":{"polygon":[[2,-1,-1],[2,1,-1],[2,1,1],[2,-1,1]]},"box":{"min":[4,0,0],"max":[5,1,1]}}' >cases.jsonl
sed 's/}}$/},"expect":"outside"}/' cases.jsonl >untrue.jsonl
"$occlude" fuzz --cases 20 --out part.json --findings '' >/dev/null || fail "fuzz"

# exit_code CODE COMMAND...
exit_code() {
  local expected=$1 status
  shift
  "$@" >stdout 2>stderr
  status=$?
  [ $status -eq "$expected" ] || fail "exit code $status instead of $expected: $*: $(cat stderr)"
}

# keeps FILE COMMAND...: expects that a command is refused that would replace FILE, an input or another output.
keeps() {
  local file=$1
  shift
  cp "$file" kept
  expect_error "named twice" "$@"
  cmp -s "$file" kept || fail "replaced $file: $*"
  rm kept
}

walk() { "$occlude" walk good.ply --path path.json --size 64x36 --no-render "$@"; }
drawn() { "$occlude" walk good.ply --path path.json --size 64x36 "$@"; }
validate() { "$occlude" validate good.ply --path path.json --size 64x36 "$@"; }
why() { "$occlude" why good.ply --path path.json --size 64x36 --frame 0 --polygon 0 "$@"; }

# No input is replaced, under whatever name.
keeps good.pre walk --out out --preprocess good.pre --witness good.pre
keeps good.pre walk --out out --preprocess good.pre --cases good.pre
keeps path.json walk --out out --witness ./walked/../path.json
ln -s good.ply link.ply
ln good.ply hard.ply
keeps good.ply walk --out out --witness link.ply
keeps good.ply "$occlude" walk link.ply --path path.json --out out --witness good.ply
keeps good.ply "$occlude" preprocess good.ply --out hard.ply
keeps good.ply "$occlude" preprocess good.ply --inner-boxes hard.ply
keeps good.ply "$occlude" preprocess good.ply --occluders hard.ply
ln path.json path.ply
keeps path.json "$occlude" preprocess good.ply --occluders path.ply --path path.json
rm path.ply
for name in summary.json frames.csv report.html; do
  mkdir reads && cp path.json reads/$name
  keeps reads/$name "$occlude" walk good.ply --path reads/$name --out reads --no-render
  rm -r reads
done
ln -s good.ply link.png
keeps good.ply "$occlude" render good.ply --path path.json --frame 0 --out link.png
rm link.png
for name in why.json view.png outside.png; do
  cp path.json $name
  keeps $name "$occlude" why good.ply --path $name --frame 0 --polygon 0 --out .
  rm $name
done
cp witness.jsonl failures.jsonl
keeps failures.jsonl validate --witness failures.jsonl --out .
rm failures.jsonl
cp path.json failure_000000.png
keeps failure_000000.png "$occlude" validate good.ply --path failure_000000.png --witness lie.jsonl --out .
rm failure_000000.png
mkdir -p full/plates
cp path.json full/plates/frame_000000_view.png
keeps full/plates/frame_000000_view.png "$occlude" walk good.ply --path full/plates/frame_000000_view.png --out full
ln -s plates/frame_000000_view.png full/link.json
keeps full/plates/frame_000000_view.png "$occlude" walk good.ply --path full/link.json --out full
rm -r full
keeps cases.jsonl "$occlude" fuzz cases.jsonl --findings cases.jsonl
keeps cases.jsonl "$occlude" fuzz cases.jsonl --out cases.jsonl
cp path.json culler.json
keeps culler.json "$occlude" bench culler good.ply --path culler.json --only sort --out .
rm culler.json

# No two outputs are the same file.
keeps path.json walk --out out --witness out/summary.json
keeps path.json walk --out out --witness new --cases new
keeps path.json walk --out out --witness out/plates/frame_000000_view.png
ln -s new link
keeps path.json walk --out out --witness new --cases link
keeps path.json "$occlude" generate city --polygons 20000 --out new --path ./new
keeps path.json "$occlude" fuzz --cases 1 --findings new --out new
mkdir -p full/plates && : >full/plates/kept
keeps path.json walk --out full --witness full/plates/frame_000000_view.png
rm -r full
walk --out out --witness printed >>printed 2>stderr
[ $? -eq 2 ] && grep -q 'named twice' stderr || fail "a witness file where the summary is printed: $(cat stderr)"
rm -rf out printed
cp cases.jsonl appended.jsonl
"$occlude" classify appended.jsonl >>appended.jsonl 2>stderr
[ $? -eq 2 ] && grep -q 'named twice' stderr || fail "classify reads what it prints: $(cat stderr)"
cmp -s cases.jsonl appended.jsonl || fail "classify appended to what it reads"
keeps cases.jsonl bash -c '"$0" fuzz - --out cases.jsonl <cases.jsonl' "$occlude"

# Pictures of an earlier run are removed. Files that the program did not make, or that were renamed since, stay.
drawn --out old >/dev/null || fail "walk"
mkdir -p old/plates
echo mine >old/plates/frame_999999_view.png
cp old/plates/frame_000000_view.png old/plates/frame_999998_view.png
drawn --out old --frames 2:4 >/dev/null || fail "second walk"
[ "$(cat old/plates/frame_999999_view.png)" = mine ] || fail "walk removed a picture that it did not make"
[ -e old/plates/frame_999998_view.png ] || fail "walk removed the copy of a plate"
[ ! -e old/plates/frame_000000_view.png ] || fail "walk left a plate of the walk before"
[ -e old/plates/frame_000002_view.png ] || fail "walk drew no plate"
mkdir failures
echo mine >failures/failure_holiday.png
exit_code 1 validate --witness lie.jsonl --exact-up-to 0 --out failures
[ -e failures/failure_000000.png ] || fail "validate drew no failure"
validate --witness witness.jsonl --out failures >/dev/null || fail "validate"
[ ! -e failures/failure_000000.png ] || fail "validate left the picture of a failure that was"
[ "$(cat failures/failure_holiday.png)" = mine ] || fail "validate removed a picture that it did not make"

# A picture that cannot be replaced is reported before the work starts.
mkdir -p inway/failure_000000.png inway/plates/frame_000000_view.png
expect_error "Is a directory" validate --witness witness.jsonl --out inway
expect_error "Is a directory" drawn --out inway
rmdir inway/*/frame_000000_view.png
: >inway/plates/frame_000000_view.png
chmod a-w inway/plates/frame_000000_view.png
expect_error "it is read-only" drawn --out inway

# Links stay links, permissions and read-only files stay, and names may be as long as the system allows.
mkdir target
: >target/file
chmod 640 target/file
ln -s target/file link_to_file
ln -s target/none link_to_none
for name in link_to_file link_to_none; do
  walk --out out --witness $name >/dev/null || fail "walk --witness $name"
  [ -L $name ] || fail "$name is a link no more"
  cmp -s $name witness.jsonl || fail "nothing was written through $name"
done
[ "$(stat -c %a target/file)" = 640 ] || fail "the permissions of a file have changed: $(stat -c %a target/file)"
ln -s circle circle
expect_error "circle: cannot create" walk --out out --witness circle
echo mine >read_only
chmod a-w read_only
expect_error "read_only: cannot create: it is read-only" walk --out out --witness read_only
[ "$(cat read_only)" = mine ] || fail "replaced a file that is read-only"
long=$(printf 'n%.0s' $(seq 255))
walk --out out --witness $long >/dev/null || fail "a name of 255 characters"
cmp -s $long witness.jsonl || fail "no file of 255 characters"
expect_error "name too long" walk --out out --witness ${long}n
expect_error "Not a directory" walk --out out --witness path.json/x
expect_error "path.json" walk --out path.json/deep/out
expect_error "Is a directory" walk --out out --witness target/
chmod a-w target
[ "$(id -u)" -eq 0 ] || expect_error "deep/out" walk --out target/deep/out
chmod u+w target
expect_error "no frame" walk --out new/deep/out --frames 9:10

# An empty name is a mistake.
for options in "walk good.ply --path path.json --out @" "walk good.ply --path @ --out out" "walk @ --path path.json --out out" \
  "walk good.ply --path path.json --out out --witness @" "walk good.ply --path path.json --out out --cases @" \
  "walk good.ply --path path.json --out out --preprocess @" "walk good.ply --path path.json --out out --frames @" \
  "validate good.ply --path path.json --witness @" "validate good.ply --path path.json --out @" "validate @ --path path.json" \
  "validate good.ply --path @" "validate good.ply --path path.json --preprocess @" "validate good.ply --path path.json --parts @" \
  "audit @ --log file" "audit good.ply --log @" "audit good.ply --log file --out @" "walk good.ply --path path.json --out out --log @" \
  "why good.ply --path path.json --frame 0 --polygon 0 --out @" "why good.ply --path path.json --frame @ --polygon 0" \
  "why good.ply --path @ --frame 0 --polygon 0" "why @ --path path.json --frame 0 --polygon 0" \
  "why good.ply --path path.json --frame 0 --pixel @" "why good.ply --path path.json --frame 0 --polygon @" \
  "preprocess @ --out out.pre" "preprocess good.ply --out @" "preprocess good.ply --inner-boxes @" "preprocess good.ply --occluders @" "generate city --out @ --path path2.json" \
  "generate city --out out.ply --path @" "classify @" "fuzz @" "fuzz --parts @" "fuzz --cases 1 --out @" "fuzz --cases @" \
  "bench culler @ --path path.json" "bench culler good.ply --path @" "bench culler good.ply --path path.json --out @" \
  "bench kernel --seed @"; do
  read -ra words <<<"$options"
  expect_error "" timeout 60 "$occlude" "${words[@]/#@/}"
done
"$occlude" fuzz --cases 1 --family lattice --findings '' >/dev/null || fail "fuzz --findings '' is documented"

# The default value of an option may be given.
walk --out out --frames all >/dev/null || fail "--frames all"
cmp -s <(cut -d, -f1-3 out/frames.csv) <(cut -d, -f1-3 walked/frames.csv) || fail "--frames all is not the default"

# Without culls there is nothing to prove.
: >none.jsonl
exit_code 0 validate --witness none.jsonl
[ "$(cat stdout)" = "0 of 0 witnesses proved" ] || fail "no witnesses: $(cat stdout)"
exit_code 0 validate --witness none.jsonl --json
grep -q '"visibility": null' stdout || fail "a frame of which nothing is said was looked at: $(cat stdout)"

# A failed check keeps its exit code, whatever goes wrong after it.
exit_code 1 validate --witness lie.jsonl --exact-up-to 0
exit_code 1 bash -c 'ulimit -f 1; "$0" "$@"' "$occlude" validate good.ply --path path.json --witness lie.jsonl --exact-up-to 0 \
  --out short
grep -q 'failure_000000.png: cannot write: File too large' stderr || fail "a picture that is not written is not told: $(cat stderr)"
[ ! -e short ] || fail "half of the failures are written: $(ls -A short)"
exit_code 1 bash -c 'cat untrue.jsonl text | "$0" classify' "$occlude"
echo 'no witness' | cat lie.jsonl - >broken.jsonl
exit_code 1 validate --witness broken.jsonl

# Every command reports that it cannot print. A message that cannot be written does not change the exit code.
commands=("--help" "--version" "walk --help" "bench kernel --help" "walk good.ply --path path.json --size 64x36 --no-render --out out"
  "validate good.ply --path path.json --witness witness.jsonl" "classify cases.jsonl" "fuzz --cases 1 --family lattice --findings ="
  "fuzz cases.jsonl" "preprocess good.ply --out out.pre --region-count 64 --json"
  "generate city --polygons 20000 --out out.ply --path out.json"
  "why good.ply --path path.json --size 64x36 --frame 0 --polygon 0 --out why"
  "bench kernel --boxes 16 --repetitions 1" "bench culler good.ply --path path.json --only sort --repetitions 1 --frames 0:2 --no-render")
for options in "${commands[@]}"; do
  read -ra words <<<"$options"
  words=("${words[@]/#=/}")
  "$occlude" "${words[@]}" >stdout 2>stderr || fail "$options: $(cat stderr)"
  "$occlude" "${words[@]}" >&- 2>stderr
  [ $? -eq 2 ] && grep -q 'standard output' stderr || fail "stdout closed: $options: $(cat stderr)"
  "$occlude" "${words[@]}" >stdout 2>&- </dev/null || fail "stderr closed: $options"
  "$occlude" "${words[@]}" >stdout 2>stderr <&- || fail "stdin closed: $options"
  [ -e /dev/full ] || continue
  "$occlude" "${words[@]}" >/dev/full 2>stderr
  [ $? -eq 2 ] && grep -q 'standard output.*No space left' stderr || fail "stdout full: $options: $(cat stderr)"
  "$occlude" "${words[@]}" >stdout 2>/dev/full || fail "stderr full: $options"
done
rm -rf out why out.* stdout stderr
deaf() { # deaf CODE COMMAND...: expects CODE when stderr cannot be written
  local expected=$1 status
  shift
  for stream in '&-' /dev/full; do
    [ "$stream" = '&-' ] || [ -e "$stream" ] || continue
    bash -c '"$@" >stdout 2>'"$stream" bash "$@"
    status=$?
    [ $status -eq "$expected" ] || fail "exit code $status instead of $expected, 2>$stream: $*"
  done
}
deaf 2 "$occlude" frobnicate
deaf 2 "$occlude"
deaf 2 "$occlude" walk missing.ply --path path.json --out out
deaf 2 "$occlude" classify missing.jsonl
deaf 1 "$occlude" classify untrue.jsonl
deaf 1 "$occlude" fuzz untrue.jsonl
deaf 1 "$occlude" validate good.ply --path path.json --witness lie.jsonl
deaf 2 "$occlude" bench kernel --boxes many
exit_code 1 bash -c '"$@" 1>&- 2>&- <&-' bash "$occlude" validate good.ply --path path.json --witness lie.jsonl
exit_code 2 bash -c '"$@" 1>&- 2>&- <&-' bash "$occlude" classify -

# A full disk and a limit of the size of files: the error says so, and nothing is left behind.
nothing_left() {
  ! has_leftovers || fail "left behind by $*: $(find . -name '.occlude*')"
}
[ ! -e /dev/full ] || for options in "walk good.ply --path path.json --size 64x36 --no-render --out out --witness /dev/full" \
  "walk good.ply --path path.json --size 64x36 --no-render --out out --cases /dev/full" \
  "preprocess good.ply --out /dev/full" "preprocess good.ply --inner-boxes /dev/full" "preprocess good.ply --occluders /dev/full" "fuzz --cases 1 --out /dev/full" \
  "generate city --polygons 20000 --out /dev/full --path out.json" \
  "fuzz untrue.jsonl --findings /dev/full"; do
  expected=2
  [[ $options != *untrue* ]] || expected=1
  exit_code $expected "$occlude" $options
  grep -q '/dev/full: cannot write: No space left on device' stderr || fail "a full disk: $options: $(cat stderr)"
  [ ! -e out ] && [ ! -e out.json ] || fail "a full disk: $options leaves files"
done
"$occlude" generate city --polygons 20000 --out city.ply --path city.json >/dev/null || fail "generate"
# A frame is culled after the same frames, whatever the step. The columns are polygons in view, drawn and seen; occluders;
# sorting; tests.
walk_city() { "$occlude" walk city.ply --path city.json --no-render --out "$1" --frames "$2" >/dev/null || fail "walk --frames $2"; }
walk_city every 0:31
walk_city third 0:31:10
cmp -s <(cut -d, -f1-4,9-16 every/frames.csv | awk -F, 'NR == 1 || $1 % 10 == 0') <(cut -d, -f1-4,9-16 third/frames.csv) ||
  fail "a walk with a step does not cull the frames between"
limited() { # limited KIBIBYTES COMMAND...
  exit_code 2 bash -c 'ulimit -f $0; "$@"' "$@"
  grep -q 'File too large' stderr || fail "ulimit -f: $*: $(cat stderr)"
  nothing_left "$@"
}
# Standard output and standard error are files too, and the limit leaves room for what is printed.
limited 4 "$occlude" generate city --polygons 20000 --out limited.ply --path limited.json
limited 4 "$occlude" preprocess city.ply --out limited.pre
limited 4 "$occlude" walk city.ply --path city.json --frames 0:4 --no-render --out limited --witness limited.jsonl
limited 4 "$occlude" walk good.ply --path path.json --out limited
[ -z "$(ls | grep limited)" ] || fail "ulimit -f leaves $(ls | grep limited)"
if mkdir disk && mount -t tmpfs -o size=64k none disk 2>/dev/null; then
  exit_code 2 "$occlude" walk city.ply --path city.json --frames 0:4 --no-render --out disk/out --witness disk/witness.jsonl
  grep -q 'No space left on device' stderr || fail "a full disk: $(cat stderr)"
  exit_code 2 "$occlude" generate city --polygons 20000 --out disk/out.ply --path disk/out.json
  grep -q 'disk/out.ply: cannot write: No space left on device' stderr || fail "a full disk: $(cat stderr)"
  [ -z "$(ls -A disk)" ] || fail "left on a full disk: $(ls -A disk)"
  umount disk
else
  echo "No file system may be mounted here: a full disk is tried with /dev/full alone"
fi

# No signal leaves a temporary file.
for signal in INT TERM HUP XCPU; do
  interrupt $signal "$occlude" walk city.ply --path city.json --out stopped --witness stopped.jsonl
  [ -z "$(ls | grep stopped)" ] || fail "SIG$signal leaves $(ls | grep stopped)"
done
(trap '' HUP && exec "$occlude" walk city.ply --path city.json --frames 0:20 --out nohup --no-render) >stdout 2>stderr &
await has_begun $!
kill -HUP $!
wait $! || fail "a hangup ended what was to survive it: $(cat stderr)"
mkfifo pipe
head -c 100 pipe >/dev/null &
exit_code 2 "$occlude" walk city.ply --path city.json --frames 0:100 --no-render --out stopped --witness pipe
grep -q 'pipe: cannot write: Broken pipe' stderr || fail "a pipe that ends: $(cat stderr)"
nothing_left SIGPIPE

# A name that says another format.
expect_error 'h.jpg: what is written is no .jpg file: let the name end in .png' \
  "$occlude" render good.ply --path path.json --frame 0 --layer camera --out h.jpg
expect_error 'x.OBJ: what is written is no .obj file: let the name end in .ply' "$occlude" preprocess good.ply --occluders x.OBJ
nothing_left "a name of another format"

# A few threads are enough. Root has no limit, so it runs the command as nobody.
chmod 777 .
few_threads() { # few_threads NUMBER COMMAND...
  local as_nobody=()
  [ "$(id -u)" -ne 0 ] || as_nobody=(setpriv --reuid=65534 --clear-groups)
  timeout --kill-after 5 60 "${as_nobody[@]}" bash -c 'ulimit -u $0; exec "$@"' "$@" >stdout 2>stderr
}
if ldd "$occlude" | grep -qE 'lib[a-z]*san\.'; then
  echo "A sanitizer has threads of its own: limits to them are not tried"
elif [ "$(id -u)" -ne 0 ] || setpriv --reuid=65534 --clear-groups test -x "$occlude" 2>/dev/null; then
  # The user may run other things: the limit is at least as many threads as there are already.
  running=0
  [ "$(id -u)" -eq 0 ] || running=$(ps -L -u "$(id -u)" -o pid= | wc -l)
  for more in 1 2 3 4; do
    few_threads $((running + more)) "$occlude" walk good.ply --path path.json --size 64x36 --out few$more ||
      fail "with $more threads: $? $(cat stderr)"
    few_threads $((running + more)) "$occlude" fuzz --cases 1 --jobs 8 --findings '' || fail "fuzz with $more threads: $? $(cat stderr)"
  done
else
  echo "Nobody may run the command here: limits to threads are not tried"
fi

finish
