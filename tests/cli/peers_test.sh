#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# `occlude bench kernel` with the program that measures other projects, whatever that program does; `bench rivals` with its
# module.
# Usage: peers_test.sh PATH_OF_OCCLUDE
set -uo pipefail
. "$(dirname "$0")/common.sh"

! ldd "$occlude" | sed "s, (0x.*,," | grep -iE 'ccd|fcl|bullet|embree|libosg' || fail "the command is linked with what it is measured beside"
cp "$occlude" occlude # it looks for the program beside itself
bench() { ./occlude bench kernel --boxes 16 --repetitions 2 --json >stdout 2>stderr; }
peers() { # peers SCRIPT: makes the program
  printf '#!/bin/sh\n%s\n' "$1" >occlude_peers
  chmod +x occlude_peers
}

bench || fail "without the program: $(cat stderr)"
grep -q '"gjk_over_certified": null' stdout || fail "a ratio without the program"
[ ! -s stderr ] || fail "without the program it said: $(cat stderr)"

peers 'echo "$@" >arguments
cat <<END
{"peer":"FCL","version":"9.8"}
{"round":2}
{"subject":"overlap_certified_with_peers","workload":"random","ns":[2,2],"wrong":0,"gjk":false}
{"subject":"fcl_slow","workload":"random","ns":[9,9],"wrong":0,"gjk":true}
{"subject":"fcl_quick","workload":"random","ns":[6,6],"wrong":1,"gjk":true}
{"subject":"fcl_planes","workload":"random","ns":[1,1],"wrong":1,"gjk":false}
END'
bench || fail "with the program: $(cat stderr)"
[ "$(cat arguments)" = "16 2 1997" ] || fail "the program was given $(cat arguments)"
for member in '"gjk_over_certified": 3.0' '"fastest_gjk": "fcl_quick"' '"fcl_planes": 1.0' '"version": "9.8"' '"version": "not installed"'; do
  grep -q "$member" stdout || fail "not taken in: $member"
done

for fault in 'exit 1' 'kill -SEGV $$' 'echo rubbish' 'echo "{\"peer\":5}"' 'echo "{\"subject\":\"x\"}"' \
  'echo "{\"peer\":\"FCL\",\"version\":\"9.8\"}"; exit 127'; do
  peers "$fault"
  bench || fail "$fault: exit code $?: $(cat stderr)"
  grep -q 'occlude_peers: .*other projects are not measured' stderr || fail "$fault: $(cat stderr)"
  grep -q '"gjk_over_certified": null' stdout || fail "$fault: a ratio of nothing"
done
echo 'no program' >occlude_peers
bench || fail "not a program: exit code $?"
grep -q 'occlude_peers: .*other projects are not measured' stderr || fail "not a program: $(cat stderr)"

# `occlude bench rivals` without the module that measures other projects, and with one that cannot be loaded.
walk_of_squares
rivals() { ./occlude bench rivals good.ply --path path.json --frames 0:1 --size 64x36 --repetitions 1 --json >stdout 2>stderr; }
rivals || fail "rivals without the module: $(cat stderr)"
[ "$(grep -c '"version": "not installed"' stdout)" -eq 2 ] || fail "rivals without the module: $(cat stdout)"
[ ! -s stderr ] || fail "without the module it said: $(cat stderr)"
echo rubbish >occlude_rivals.so
rivals || fail "not a module: exit code $?: $(cat stderr)"
grep -q 'occlude_rivals.so: .*other projects are not measured' stderr || fail "not a module: $(cat stderr)"
[ "$(wc -l <stderr)" -eq 1 ] || fail "not a module: not one line: $(cat stderr)"

# The program does not outlive the command that waits for it.
peers 'echo $$ >process; exec tail -f /dev/null'
./occlude bench kernel --boxes 16 --repetitions 1 >stdout 2>stderr &
await test -s process
kill -TERM $!
wait $!
[ $? -eq 130 ] || fail "SIGTERM: exit code $?: $(cat stderr)"
! kill -0 "$(cat process)" 2>/dev/null || fail "the program outlives the command"

finish
