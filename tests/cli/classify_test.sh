#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# `occlude classify`: the answers to cases, and the refusal of invalid input.
# Usage: classify_test.sh PATH_OF_OCCLUDE
set -uo pipefail
. "$(dirname "$0")/common.sh"
walk_of_squares

# Every answer of a case.
three_cases
"$occlude" classify cases.jsonl >stdout || fail "classify"
cat >expected <<'END'
{"id":"inside","certified":"inside","stage":"exact","plain":"inside","conservative":"inside","oracle":"inside"}
{"id":"reversed","error":"box has min > max"}
{"id":"touch","certified":"partial","stage":"exact","plain":"partial","conservative":"partial","oracle":"partial"}
END
diff expected stdout || fail "classify answered otherwise"
sed 's/"expect"/"expect_stage":"none","expect"/' cases.jsonl | "$occlude" classify | diff expected - || fail "members that are not its own matter"
sed 's/"expect":"partial"/"expect":"outside"/' cases.jsonl | "$occlude" classify - >/dev/null 2>stderr
[ $? -eq 1 ] || fail "a wrong expectation was accepted"
grep -q '^standard input:[0-9]*: expected outside$' stderr || fail "classify does not tell which case differs: $(cat stderr)"
(head -1 cases.jsonl; echo '{"id":') | "$occlude" classify >stdout 2>stderr
[ $? -eq 2 ] || fail "a broken line was accepted"
[ "$(wc -l <stdout)" -eq 1 ] || fail "the lines before a broken one are to be answered"
grep -q 'standard input:2: ' stderr || fail "the line is not named: $(cat stderr)"

# Input without a case is not answered.
: >nothing.jsonl
printf '\n \n' >blank.jsonl
for file in nothing.jsonl blank.jsonl; do expect_error "$file: no cases" "$occlude" classify $file; done
expect_error "standard input: no cases" "$occlude" classify - <nothing.jsonl

# Polytopes and oriented boxes that are refused. The block is two deep. The eye sees its front, and one side edge-on.
block='"eye":[0,0,0],"occluder":{"vertices":[[2,0,-1],[4,0,-1],[4,2,-1],[2,2,-1],[2,0,1],[4,0,1],[4,2,1],[2,2,1]],"faces":[[0,1,2,3],[4,5,6,7],[0,1,5,4],[1,2,6],[1,6,5],[3,2,6,7],[0,4,7,3]]},"near":"surface"'
but() { # but SED_SCRIPT: the block, changed
  sed "$1" <<<"$block"
}
cat >cases.jsonl <<END
{"id":"along",$(but s/eye/direction/),"box":{"min":[0,0,0],"max":[1,1,1]}}
{"id":"no vertex",$(but s/4,7,3/4,7,4294967299/),"box":{"min":[0,0,0],"max":[1,1,1]}}
{"id":"open",$(but 's/,\[0,4,7,3\]//'),"box":{"min":[0,0,0],"max":[1,1,1]}}
{"id":"dented",$(but s/2,0,-1/3,0.5,0/),"box":{"min":[0,0,0],"max":[1,1,1]}}
{"id":"within",$(but s/0,0,0/3,2,1/),"box":{"min":[0,0,0],"max":[1,1,1]}}
{"id":"half edge",$case,"box":{"center":[6,0,0],"half_edges":[[1,1,0],[-1,1,0],[0,0,1e99]]}}
END
"$occlude" classify cases.jsonl >stdout || fail "classify: $(cat stdout)"
grep -o '"id":"[^"]*","error":"[a-z]*' stdout >answers
cat >expected <<'END'
"id":"along","error":"direction
"id":"no vertex","error":"face
"id":"open","error":"polytope
"id":"dented","error":"polytope
"id":"within","error":"viewpoint
"id":"half edge","error":"number
END
diff expected answers || fail "classify refused oriented boxes or polytopes otherwise"

# Numbers that JSON cannot express are refused with their case. A line that is not a case is an error that names the line.
echo "{\"id\":\"n\",$case,\"box\":{\"min\":[NaN,0,0],\"max\":[4,3,1e999]}}" | "$occlude" classify >stdout || fail "NaN"
grep -q '{"id":"n","error":"number is not finite"}' stdout || fail "NaN: $(cat stdout)"
echo "{\"id\":1,$case,\"box\":{\"min\":[1,0,0],\"max\":[0,0,0]},\"expect\":\"inside\"}" | "$occlude" classify >/dev/null
[ $? -eq 1 ] || fail "an expectation of a refused case was passed over"
nested=$(printf '[%.0s' $(seq 1 20000))
box='"box":{"min":[0,0,0],"max":[1,1,1]}'
faces() { # faces JSON: a case with these faces
  echo "{\"eye\":[0,0,0],\"occluder\":{\"vertices\":[[1,0,0]],\"faces\":$1},$box}"
}
for line in "{\"id\":$nested" "{\"id\":[1]}" "{$case,\"direction\":[1,0,0],$box}" '[]' '"x"' \
  "$(faces 1)" "$(faces '[1]')" "$(faces '[[-1]]')" "$(faces '[[0.5]]')" "$(faces '[["0"]]')" "$(faces '[[[0]]]')" \
  "{\"eye\":[0,0,0],\"occluder\":{\"vertices\":[[1,0,0]]},$box}" "{\"eye\":[0,0,0],\"occluder\":{\"faces\":[[0]]},$box}" \
  "{\"eye\":[0,0,0],\"occluder\":{\"polygon\":[],\"vertices\":[],\"faces\":[]},$box}" \
  "{\"eye\":[0,0,0],\"occluder\":[],$box}" "{$case,\"box\":{\"center\":[0,0,0]}}" \
  "{$case,\"box\":{\"center\":[0,0,0],\"half_edges\":[[0,0,0],[0,0,0]]}}" \
  "{$case,\"box\":{\"center\":[0,0,0],\"half_edges\":[[0,0,0],[0,0,0],[0,0,0]],\"min\":[0,0,0]}}"; do
  echo "$line" >line.jsonl
  expect_error "line.jsonl:1: " "$occlude" classify line.jsonl
done
{ head -c 1000000 /dev/zero | tr '\0' 'a'; echo; } >line.jsonl
expect_error "line.jsonl:1: not JSON, near column 1" timeout 10 "$occlude" classify line.jsonl
echo '{"eye":[NaN,NaN,NaN,NaN}' >line.jsonl
expect_error "line.jsonl:1: not JSON, near column 24" "$occlude" classify line.jsonl
# A repeated key is refused, because it is unclear which value counts.
echo '{"eye":[0,0,0],"eye":[1,0,0]}' >line.jsonl
expect_error "line.jsonl:1: repeated key in an object, near column 16" "$occlude" classify line.jsonl

# What several polygons hide together.
case='{"id":"c","eye":[0,0,0],"occluder":{"cover":[[[2,-1,-1],[2,0,-1],[2,0,1],[2,-1,1]],[[2,0,-1],[2,1,-1],[2,1,1],[2,0,1]]]},"box":{"min":[9,-1,-1],"max":[9,1,1]}'
echo "$case,\"expect\":\"inside\"}" | "$occlude" classify >stdout || fail "classify a cover: $(cat stdout)"
[ "$(cat stdout)" = '{"id":"c","certified":"inside","stage":"exact","oracle":"inside"}' ] || fail "a cover is $(cat stdout)"
echo "$case,\"expect\":\"partial\"}" | "$occlude" classify >stdout && fail "classify took what is not expected"
echo "${case/\"cover\":/\"polygon\":[],\"cover\":}}" >line.jsonl
expect_error 'line.jsonl:1: both "cover" and "polygon"' "$occlude" classify line.jsonl
echo "${case/\"cover\":[[/\"cover\":[}}" >line.jsonl
expect_error 'line.jsonl:1:' "$occlude" classify line.jsonl

# Regions of viewpoints.
case='{"id":"r","eyes":{"center":[0,0,0],"half_edges":[[0,1,0],[0,0,1],[0,0,0]]},"occluder":{"polygon":[[2,-2,-2],[2,2,-2],[2,2,2],[2,-2,2]]},"shadow":"umbra","box":{"min":[4,-3,-3],"max":[4,3,3]}'
echo "$case,\"expect\":\"inside\"}" | "$occlude" classify >stdout || fail "classify an umbra: $(cat stdout)"
[ "$(cat stdout)" = '{"id":"r","certified":"inside","stage":"exact","plain":"inside","conservative":"inside","oracle":"inside"}' ] ||
  fail "an umbra is $(cat stdout)"
echo "${case/\"umbra\"/\"penumbra\"},\"expect\":\"outside\"}" | "$occlude" classify >/dev/null
[ $? -eq 1 ] || fail "a wrong expectation of a penumbra"
echo "${case/\[0,1,0\]/\[2,0,0\]}}" | "$occlude" classify >stdout || fail "eyes in the plane: $(cat stdout)"
grep -q '"error":"viewpoint lies in' stdout || fail "eyes in the plane: $(cat stdout)"
echo "${case/\"eyes\"/\"eye\":[0,0,0],\"eyes\"}}" >line.jsonl
expect_error 'line.jsonl:1: a region of viewpoints and "eye"' "$occlude" classify line.jsonl
echo "${case/\"shadow\":\"umbra\",/}}" >line.jsonl
expect_error 'line.jsonl:1: "shadow" is missing' "$occlude" classify line.jsonl
echo "${case/\"shadow\"/\"near\":\"farthest\",\"shadow\"}}" >line.jsonl
expect_error 'line.jsonl:1: "near": the shadow of a region begins at the "surface"' "$occlude" classify line.jsonl

# A polygon may have very many sides. A polytope may have no more vertices than the oracle can judge in seconds.
corners=$(awk 'BEGIN { n = 100000; for (i = 0; i < n; i++) printf "%s[2,%.17g,%.17g]", i ? "," : "", cos(6.283185307179586 * i / n), sin(6.283185307179586 * i / n) }')
echo "{\"eye\":[0,0,0],\"occluder\":{\"polygon\":[$corners]},\"near\":\"surface\",\"box\":{\"min\":[4,0,0],\"max\":[5,1,1]},\"expect\":\"inside\"}" >line.jsonl
timeout 60 "$occlude" classify line.jsonl >stdout 2>stderr || fail "a polygon of 100000 sides: $(head -c 300 stdout stderr)"
corners=$(printf '[2,0,0],%.0s' $(seq 1 4096))
echo "{\"eye\":[0,0,0],\"occluder\":{\"vertices\":[$corners[2,1,0]],\"faces\":[]},$box}" >line.jsonl
expect_error "line.jsonl:1: \"occluder\": a polytope with more than 4096 vertices" timeout 60 "$occlude" classify line.jsonl
# Thousands of vertices on one edge of the silhouette, which no face names, give one side of the shadow and not millions.
corners=$(for i in $(seq 1 4000); do printf '[3,1,%s],' "0.$(printf '%04d' $i)"; done)
echo "{\"eye\":[0,0,0.5],\"occluder\":{\"vertices\":[[2,0,0],[3,0,0],[3,1,0],[2,1,0],[2,0,1],[3,0,1],[3,1,1],[2,1,1],${corners%,}],\"faces\":[[0,1,2,3],[4,5,6,7],[0,1,5,4],[1,2,6,5],[2,3,7,6],[3,0,4,7]]},\"near\":\"surface\",\"box\":{\"min\":[5,0.6,0.4],\"max\":[6,0.7,0.6]},\"expect\":\"inside\"}" >line.jsonl
timeout 60 "$occlude" classify line.jsonl >stdout 2>stderr || fail "4000 vertices on an edge: $(head -c 300 stdout stderr)"
# A wall that hides the box is found soon, although polygons that hide nothing run through the box.
awk 'BEGIN { srand(3); printf "{\"eye\":[0,0,0],\"occluder\":{\"cover\":[[[3.1,5,5]"; for (i = 0; i < 150; ++i) { for (k = 0; k < 3; ++k) v[k] = 4 + 4 * rand(); v[i % 3] = 3 + 0.9 * rand(); printf ",[%.17g,%.17g,%.17g]", v[0], v[1], v[2] } printf "],[[13,-5,-5],[-5,13,-5],[-5,-5,13]]]},\"box\":{\"min\":[4,4,4],\"max\":[8,8,8]},\"expect\":\"inside\"}\n" }' >line.jsonl
timeout 60 "$occlude" classify line.jsonl >stdout 2>stderr || fail "a cover that runs through the box: $(head -c 300 stdout stderr)"

# It can be stopped while it waits for input.
interrupt_reader "$occlude" classify pipe

[ ! -e /dev/full ] || expect_error "standard output" bash -c '"$0" classify cases.jsonl >/dev/full' "$occlude"

finish
