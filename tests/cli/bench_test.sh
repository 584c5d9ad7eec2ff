#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# `occlude bench`: everything measured is there. How fast it is does not matter for a test.
# Usage: bench_test.sh PATH_OF_OCCLUDE
set -uo pipefail
. "$(dirname "$0")/common.sh"
walk_of_squares

# bench: everything measured is there and is a positive number.
"$occlude" bench kernel --json --boxes 256 --repetitions 1 >bench.json || fail "bench"
for member in ratios certified_over_plain random integer_touching ulp_touching decimal batch_speedup gjk_over_certified operations ns \
  overlap_certified overlap_plain naive answers peers machine; do
  grep -q "^ *\"$member\": " bench.json || fail "bench: no $member"
done
sed -n '/^  "ns": {/,/^  }/p' bench.json | grep -v '[{}]' >times
[ "$(wc -l <times)" -ge 15 ] || fail "bench: only $(wc -l <times) times"
awk -F '": ' '$2 + 0 <= 0 || $2 !~ /^[0-9]/ { bad = 1 } END { exit bad }' times || fail "bench measured: $(cat times)"
grep -A2 '"wrong": {' bench.json | grep '"overlap_certified"' | grep -qv ': 0,' && fail "bench: certified answers are wrong"
"$occlude" bench kernel --boxes 256 --repetitions 1 | grep -q 'Table 1' || fail "bench without --json"
expect_error "--boxes" "$occlude" bench kernel --boxes 0
expect_error "--repetitions" "$occlude" bench kernel --repetitions many
expect_error "--seed" "$occlude" bench kernel --seed -1

# bench culler: every experiment is there, and the files contain what it prints.
"$occlude" bench culler --polygons 20000 --frames 0:4 --no-render --region-count 64 --repetitions 1 --largest 50000 --json --out bench >bench.json 2>stderr ||
  fail "bench culler: $(cat stderr)"
cmp -s bench.json bench/culler.json || fail "bench culler: culler.json is not what it prints"
for member in model polygons frames options table2 methods mean culled_share speedup_limit figures_2_and_3 view_frustum_polygons figure4 knee \
  all_three all_three_over_area_angle_at_8 sweeps entries cull_ratio sort comparisons_anew joined pictures cover_size leaves budgets occluders hidden_share threads speedup most_speedup call_us growth exponents build machine; do
  grep -q "^ *\"$member\": " bench/culler.json || fail "bench culler: no $member"
done
grep -q '"speedup": null' bench/culler.json || fail "bench culler --no-render: a speedup of nothing drawn"
[ "$(grep -o '<svg' bench/culler.html | wc -l)" -eq 13 ] || fail "bench culler: $(grep -o '<svg' bench/culler.html | wc -l) charts"
grep -q '<script\|src="http\|href="http\|nan\|inf"' bench/culler.html && fail "bench culler: scripts, addresses or no numbers in the page"
"$occlude" bench culler good.ply --path path.json --frames 0:4 --size 64x36 --samples 0 --repetitions 1 >stdout || fail "bench culler MODEL"
for title in 'Table 2' 'Figure 4' 'Number of regions' 'Threshold' 'Sort from' 'coarse picture' 'size of the leaves' 'Simplified occluders' 'several threads'; do
  grep -q "$title" stdout || fail "bench culler MODEL: no $title"
done
grep -q 'Growth with the number of polygons' stdout && fail "bench culler MODEL: cities"
grep -q 'all three' stdout && fail "bench culler --samples 0: curves that need samples"
"$occlude" bench culler good.ply --path path.json --only sort,sweeps --frames 0:2 --repetitions 1 >stdout || fail "bench culler --only"
grep -q 'Table 2\|Figure 4' stdout && fail "bench culler --only: more than was chosen"
expect_error "--only" "$occlude" bench culler --only nonsense
expect_error "--path" "$occlude" bench culler --path path.json
expect_error "--largest" "$occlude" bench culler --largest 5
expect_error "--largest" "$occlude" bench culler --largest many
expect_error "no frame" "$occlude" bench culler good.ply --path path.json --frames 7:9 --out benchmarks
expect_error "missing.ply" "$occlude" bench culler missing.ply --path path.json --out benchmarks
: >file
expect_error "file" "$occlude" bench culler good.ply --path path.json --out file/out
interrupt INT "$occlude" bench culler --polygons 20000 --no-render --out benchmarks
[ ! -e benchmarks ] || fail "Ctrl-C left a folder"
interrupt TERM "$occlude" bench culler --polygons 20000 --only table2 --out benchmarks
[ ! -e benchmarks ] || fail "SIGTERM left a folder"

# bench scene: everything is there, and what was checked is right.
small=(--objects 20000 --streamed 5000 --moving 500 --moving-occluders 20 --frames 12 --settling 4 --check-every 4)
"$occlude" bench scene "${small[@]}" --json >scene.json || fail "bench scene"
for member in objects occluders bytes_of_object change_ms update_ms cull_ms drawn hidden median percentile_99 maximum machine; do
  grep -q "^ *\"$member\": " scene.json || fail "bench scene: no $member"
done
grep -q '"objects": 20000,' scene.json || fail "bench scene: objects were lost"
grep -q '"different": 0,' scene.json || fail "bench scene: culled otherwise than in a scene made anew"
grep -q '"unproved": 0$' scene.json || fail "bench scene: culls that are not proved"
[ "$(sed -n 's/^ *"proved": \([0-9]*\),/\1/p' scene.json)" -ge 60 ] || fail "bench scene: few proofs"
"$occlude" bench scene "${small[@]}" | grep -q 'objects hidden' || fail "bench scene without --json"
# With a budget culls are proved, and not compared. Work is the same everywhere: the less of it, the less is hidden.
share_with() { "$occlude" bench scene "${small[@]}" --json "$@" | tee scene.json | sed -n '0,/"hidden_share"/s/^ *"hidden_share": \(.*\)$/\1/p'; }
little=$(share_with --budget-work 300) much=$(share_with --budget-work 30000) all=$(share_with)
grep -q '"budget_work": null,' scene.json || fail "bench scene: a budget where there is none"
awk -v a="$little" -v b="$much" -v c="$all" 'BEGIN { exit !(a < b && b <= c && c > 0) }' ||
  fail "bench scene: budgets hide $little, $much, $all"
"$occlude" bench scene "${small[@]}" --budget-ms 1 --json >scene.json || fail "bench scene --budget-ms"
for expected in '"budget_ms": 1.0,' '"different": 0,' '"unproved": 0$' '"view_frustum_ms": {'; do
  grep -q "$expected" scene.json || fail "bench scene --budget-ms: no $expected"
done
expect_error "--budget-ms" "$occlude" bench scene --budget-ms -1
expect_error "--streamed" "$occlude" bench scene --objects 1000 --streamed 1001 --moving 0 --moving-occluders 0
expect_error "--moving-occluders" "$occlude" bench scene --moving 5 --moving-occluders 6
expect_error "--frames" "$occlude" bench scene --frames 0

# bench town: everything is there, and walls hide.
small=(--houses 2000 --walls 1800 --cars 50 --repetitions 2 --frames 10)
"$occlude" bench town "${small[@]}" --json >town.json || fail "bench town"
for member in houses cars walls prepared_ms held_bytes update_ms cull_ms drawn hidden out_of_view median maximum machine; do
  grep -q "^ *\"$member\": " town.json || fail "bench town: no $member"
done
"$occlude" bench town --houses 2000 --walls 0 --cars 50 --repetitions 2 --frames 10 --json >open.json || fail "bench town without walls"
drawn() { grep -A1 '"drawn"' "$1" | sed -n 's/^ *"median": \([0-9]*\).*/\1/p'; }
[ "$(drawn town.json)" -gt 0 ] && [ $((4 * $(drawn town.json))) -lt "$(drawn open.json)" ] ||
  fail "bench town: $(drawn town.json) objects are drawn behind walls, $(drawn open.json) without"
"$occlude" bench town "${small[@]}" | grep -q 'objects hidden' || fail "bench town without --json"
expect_error "--walls" "$occlude" bench town --houses 5 --walls 6

# bench held: everything is there, for each way to move, and regions hold.
"$occlude" bench held good.ply --path path.json --frames 40 --json >held.json || fail "bench held"
for member in model polygons frames moves ms own_ms worst_own_ms beside_ms point_ms hidden_over_point drawn frames_by_point regions \
  machine; do
  grep -q "^ *\"$member\": " held.json || fail "bench held: no $member"
done
speeds() { sed -n 's/^ *"speed": \(.*\),$/\1/p' held.json | tr '\n' ' '; }
[ "$(grep -c '"move": ' held.json)" -eq 4 ] || fail "bench held: $(grep -c '"move": ' held.json) ways to move"
[ "$(speeds)" = "1.5 15.0 null 1.5 " ] || fail "bench held: speeds $(speeds)"
grep -q '"regions": 0,' held.json && fail "bench held: no region was culled"
"$occlude" bench held good.ply --path path.json --frames 2 | grep -q 'turning' || fail "bench held without --json"
expect_error "--frames" "$occlude" bench held --frames 0
"$occlude" bench held good.ply --path path.json --frames 40 --speeds 0.5,2,8 --chart held.svg --json >held.json || fail "bench held --speeds"
[ "$(grep -c '"move": ".* a second"' held.json)" -eq 3 ] && grep -q '"move": "0.5 a second"' held.json || fail "bench held --speeds: $(cat held.json)"
[ "$(speeds)" = "0.5 2.0 8.0 " ] || fail "bench held --speeds: speeds $(speeds)"
[ "$(grep -o '<polyline' held.svg | wc -l)" -eq 2 ] && [ "$(grep -o '<circle' held.svg | wc -l)" -eq 6 ] && grep -q '^<svg xmlns=' held.svg ||
  fail "bench held --chart: $(cat held.svg)"
for speeds in 0,1 2,1 1,x -1 1,inf; do expect_error "--speeds" "$occlude" bench held --speeds "$speeds"; done
expect_error "--speeds" "$occlude" bench held --chart held.svg

# bench rivals: everything is there; what the wall hides is culled by ours, and nothing that shows.
small=(good.ply --path path.json --size 64x36 --leaf 1 --repetitions 1)
"$occlude" bench rivals "${small[@]}" --frames 0:4:2 --rays 32x18,64x36 --json --out rivals >rivals.json || fail "bench rivals"
cmp -s rivals.json rivals/rivals.json || fail "bench rivals: rivals.json is not what it prints"
for member in model polygons frames size rays tree leaves built_ms hidden_polygons ways project way prepared_ms drawn hidden_culled \
  false_culls wrong_pixels cull_ms worst_cull_ms cull_over_joined_shadows rivals version machine; do
  grep -q "^ *\"$member\": " rivals.json || fail "bench rivals: no $member"
done
of_way() { sed -n "/\"way\": \"$1\"/,/}/s/^ *\"$2\": \([0-9.]*\),*/\1/p" rivals.json; } # of_way WAY MEMBER
for way in 'view frustum alone' 'occlude, shadow frusta' 'occlude, joined shadows'; do
  [ "$(of_way "$way" false_culls)$(of_way "$way" wrong_pixels)" = 00 ] || fail "bench rivals: $way culls what shows"
done
[ "$(of_way 'view frustum alone' hidden_culled)" = 0.0 ] || fail "bench rivals: the view frustum culls what is hidden in it"
[ "$(of_way 'occlude, shadow frusta' hidden_culled)" = 1.0 ] || fail "bench rivals: the wall hides $(of_way 'occlude, shadow frusta' hidden_culled)"
grep -q '<table' rivals/rivals.html || fail "bench rivals: no table in the page"
grep -q '<script\|src="http\|href="http' rivals/rivals.html && fail "bench rivals: scripts or addresses in the page"
"$occlude" bench rivals "${small[@]}" --frames 0:1 | grep -q 'of the hidden culled' || fail "bench rivals without --json"
expect_error "--rays" "$occlude" bench rivals "${small[@]}" --rays 5 --out rivals2
expect_error "--path" "$occlude" bench rivals --path path.json
expect_error "no frame" "$occlude" bench rivals good.ply --path path.json --frames 7:9 --out rivals2
expect_error "missing.ply" "$occlude" bench rivals missing.ply --path path.json --out rivals2
interrupt INT "$occlude" bench rivals --polygons 20000 --repetitions 1000 --out rivals2
[ ! -e rivals2 ] || fail "Ctrl-C left a folder"

# bench all: each part is what its own command prints, and every known project is there, installed or not.
"$occlude" bench all good.ply --path path.json --frames 0:1 --size 64x36 --quick --json --out all >all.json || fail "bench all"
cmp -s all.json all/bench.json || fail "bench all: bench.json is not what it prints"
for part in ratios kernel culler scene town rivals held machine; do grep -q "^  \"$part\": " all.json || fail "bench all: no $part"; done
for project in libccd FCL Bullet OpenSceneGraph Embree; do
  sed -n '/^  "ratios"/,/^  }/p' all.json | grep -q "^    \"$project\": " || fail "bench all: no $project"
  grep -q "$project: " all/bench.html || fail "bench all: no $project in the page"
done
grep -q '<script\|src="http\|href="http\|nan\|inf"' all/bench.html && fail "bench all: scripts, addresses or no numbers in the page"
expect_error "--seed" "$occlude" bench all --quick --seed many --out all2
: >taken
expect_error "taken" "$occlude" bench all --quick --out taken/out
interrupt TERM "$occlude" bench all --out all2
[ ! -e all2 ] || fail "SIGTERM left a folder"

finish
