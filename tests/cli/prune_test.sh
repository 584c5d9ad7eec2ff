#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# `occlude prune`: what is never seen goes, everything else stays as it is, and pictures are equal to the pixel.
# Usage: prune_test.sh PATH_OF_OCCLUDE PATH_OF_PRUNE_PICTURES CLOSED_PARTS_PY
set -uo pipefail
pictures=$(realpath "$2") parts=$(realpath "$3")
. "$(dirname "$0")/common.sh"

# box LOW HIGH FIRST: eight corners of a cube. sides FIRST: its six sides, over corners from FIRST on.
box() {
  local x y z
  for z in "$1" "$2"; do for y in "$1" "$2"; do for x in "$1" "$2"; do printf '%s' "$x $y $z\n"; done; done; done
}
sides() {
  local side corner
  for side in '0 4 6 2' '1 3 7 5' '0 1 5 4' '2 6 7 3' '0 2 3 1' '4 5 7 6'; do
    printf 4
    for corner in $side; do printf ' %d' $((corner + $1)); done
    printf '%s' '\n'
  done
}
# gone FILE EXPECTED ARGUMENTS...: how many faces are gone.
gone() {
  local file=$1 expected=$2
  shift 2
  "$occlude" prune "$file" --out "pruned.${file##*.}" --json "$@" >told 2>stderr || fail "$file $*: $(cat stderr)"
  grep -q "\"gone\": $expected," told || fail "$file $*: $expected expected: $(cat told)"
}
# gone_proved FILE EXPECTED ARGUMENTS...: the same, and each of them is proved.
gone_proved() {
  gone "$@" --witness proof.jsonl
  proves "$1" proof.jsonl "$2"
}
# same FILE PICTURES: pictures from outside of it and of what was written last are equal, and exact rays reach nothing that is gone.
same() { "$pictures" "$1" "pruned.${1##*.}" "$2" 1000 128 >drawn || fail "pictures of $1: $(cat drawn)"; }

# A closed box with two cubes in it, and one outside; one that touches it from inside.
all="$(box 0 10)$(box 4 6)$(box 1 1.5)$(box 20 21)" faces="$(sides 0)$(sides 8)$(sides 16)$(sides 24)"
ply closed.ply 32 24 "$all$faces"
gone_proved closed.ply 12 --from outside
same closed.ply 200
finds_lie closed.ply proof.jsonl 'a side of the shell' 's/"shell":\[0,/"shell":[/'
finds_lie closed.ply proof.jsonl 'the shell' 's/"shell":\[.*\]/"shell":[6,7,8,9,10,11]/'
finds_lie closed.ply proof.jsonl 'what is inside' 's/"hidden":\[\[[0-9]*,1\]/"hidden":[[18,1]/'
finds_lie closed.ply proof.jsonl 'the polygons' '/claim/s/\[6,12\]/[6,13]/'
sed 's/"max":\[[^]]*\]/"max":[20,20,20]/' proof.jsonl >lie.jsonl
expect_error 'lie.jsonl:1: "outside": a part of the model is outside of the box' "$occlude" validate closed.ply --witness lie.jsonl
gone closed.ply 12 --from outside --witness proof.jsonl --witness-share 0.25
proves closed.ply proof.jsonl 3
grep -qa 'element face 12' pruned.ply || fail "the header: $(head pruned.ply)"
grep -q ' 100 % of' drawn || fail "something inside of a closed box stays: $(cat drawn)"
ply touching.ply 16 12 "$(box 0 10)$(box 0 5)$(sides 0)$(sides 8)"
gone touching.ply 0 --from outside --effort 0
same touching.ply 200
gone_proved touching.ply 3 --from outside --effort 0 --touching
finds_lie touching.ply proof.jsonl 'touching' 's/"touching":true/"touching":false/'
same touching.ply 0

# A row of three houses with walls between them, of which the last is open above: the wall to it is seen.
row='' walls=''
for x in 0 1 2 3; do
  row="$row$x 0 0\n$x 1 0\n$x 1 1\n$x 0 1\n"
  walls="${walls}4 $((4 * x)) $((4 * x + 1)) $((4 * x + 2)) $((4 * x + 3))\n"
done
for x in 0 4 8; do
  for side in '0 1 5 4' '1 2 6 5' '3 0 4 7' '2 3 7 6'; do
    [ $x -eq 8 ] && [ "$side" = '2 3 7 6' ] && continue
    walls="${walls}4"
    for corner in $side; do walls="$walls $((corner + x))"; done
    walls="$walls\n"
  done
done
ply row.ply 16 15 "$row$walls"
gone row.ply 0 --from outside --effort 0
gone row.ply 1 --from outside --effort 0 --touching
same row.ply 0
grep -qa '^4 4 5 6 7' pruned.ply && fail "the wall between closed houses stays: $(cat pruned.ply)"

# A housing of six plates that overlap and close nothing by themselves: culls find what is in it.
plates=''
for place in '0 0' '0 1' '1 0' '1 1' '2 0' '2 1'; do
  for corner in '-.5 -.5' '10.5 -.5' '10.5 10.5' '-.5 10.5'; do
    set -- $place $corner
    at=$(($2 * 10))
    case $1 in 0) plates="$plates$at $3 $4\n" ;; 1) plates="$plates$4 $at $3\n" ;; 2) plates="$plates$3 $4 $at\n" ;; esac
  done
done
ply plates.ply 32 12 "$plates$(box 4 6)4 0 1 2 3\n4 4 5 6 7\n4 8 9 10 11\n4 12 13 14 15\n4 16 17 18 19\n4 20 21 22 23\n$(sides 24)"
gone plates.ply 0 --from outside --effort 0
gone plates.ply 6 --from outside --witness proof.jsonl --witness-share 0.34
proves plates.ply proof.jsonl 2
finds_lie plates.ply proof.jsonl 'what hides' 's/"polygons":\[[0-9]*/"polygons":[11/'
same plates.ply 200

# Without its upper side what is in it may be seen; the sides seen from in there stay, too.
ply open.ply 32 23 "$all${faces/4 4 5 7 6\\n/}"
gone open.ply 0 --from outside
same open.ply 200

# Of a face of several pieces all must be hidden: one of this one is in the box, and others lead out of it.
ply pieces.ply 14 7 "$(box 0 10)2 2 5\n4 2 5\n4 4 5\n12 4 5\n12 5 5\n2 5 5\n$(sides 0)6 8 9 10 11 12 13\n"
gone pieces.ply 0 --from outside
same pieces.ply 50

# A deep well, upside down: only an eye below looks into it. Culls prove that nothing is seen of the tile in it where a lid is
# somewhat below, which makes it no closed part, and do not without the lid.
well='-1 -1 0\n-1 -1 4\n-1 1 4\n-1 1 0\n1 -1 0\n1 -1 4\n1 1 4\n1 1 0\n'
lid='-2 -2 -1\n2 -2 -1\n2 2 -1\n-2 2 -1\n' tile='-.2 -.2 3\n.2 -.2 3\n.2 .2 3\n-.2 .2 3\n'
walls='4 0 1 2 3\n4 4 5 6 7\n4 0 1 5 4\n4 3 2 6 7\n4 1 2 6 5\n'
ply well.ply 12 6 "$well$tile${walls}4 8 9 10 11\n"
gone well.ply 0 --from outside --rays 0 --effort 1000
same well.ply 50
ply lid.ply 16 7 "$well$tile$lid${walls}4 8 9 10 11\n4 12 13 14 15\n"
gone_proved lid.ply 1 --from outside --effort 1000
same lid.ply 50

# A window in place of that side hides nothing, unless it is opaque.
printf 'mtllib glass.mtl\nusemtl wall\no house\n' >window.obj
printf 'newmtl wall\nKd 1 1 1\nnewmtl glass\nd 0.5\n' >glass.mtl
printf '%b' "$(box 0 10)$(box 4 6)" | sed 's/^/v /' >>window.obj
printf '%b' "$(sides 0)" | awk '{ if (NR == 6) print "usemtl glass"; print "f", $2 + 1, $3 + 1, $4 + 1, $5 + 1 }' >>window.obj
printf 'o thing\nusemtl wall\n' >>window.obj
printf '%b' "$(sides 8)" | awk '{ print "f", $2 + 1, $3 + 1, $4 + 1, $5 + 1 " # a side" }' >>window.obj
gone window.obj 0 --from outside
same window.obj 100
gone window.obj 6 --from outside --opaque-all
grep -v '# a side' window.obj | cmp - pruned.obj || fail "other lines of the OBJ changed"
gone window.obj 0 --from outside --opaque-all --keep thing
grep -q '"kept_by_name": 6,' told || fail "kept: $(cat told)"
cmp window.obj pruned.obj || fail "the OBJ without anything to leave out changed"

# By culls of regions: from a cell before a wall, of what is behind it. The wall is of two polygons that share an edge, and the
# cube outside of their shadow is seen.
wall='2 -1 -1\n2 0 -1\n2 0 1\n2 -1 1\n2 1 -1\n2 1 1\n'
behind='6 -.5 -.5\n6 .5 -.5\n6 .5 .5\n6 -.5 .5\n' beside='6 5 -.5\n6 6 -.5\n6 6 .5\n6 5 .5\n'
ply wall.ply 14 4 "$wall$behind${beside}4 0 1 2 3\n4 1 4 5 2\n4 6 7 8 9\n4 10 11 12 13\n"
echo '{"cells":[{"min":[-0.2,-0.2,-0.2],"max":[0.2,0.2,0.2]},{"min":[0,0,0],"max":[0,0,0]}]}' >cells.json
gone wall.ply 1 --from cells --cells cells.json --witness proof.jsonl
proves wall.ply proof.jsonl 2
finds_lie wall.ply proof.jsonl 'a cell' '/claim/s/"max":\[0.2,/"max":[0.201,/'
grep -qa '^4 6 7 8 9' pruned.ply && fail "what is behind the wall stays: $(cat pruned.ply)"
echo '{"cells":[{"min":[-0.2,-0.2,-0.2],"max":[0.2,0.2,0.2]},{"min":[0,4,0],"max":[0,4,0]}]}' >both.json
gone wall.ply 0 --from cells --cells both.json
# The same without rays, so that culls alone decide: from all cells, and from all of each. From the middle of the wide cell, and
# from the near end of the long one, what is behind the wall is hidden.
gone wall.ply 1 --from cells --cells cells.json --rays 0
gone wall.ply 0 --from cells --cells both.json --rays 0
echo '{"cells":[{"min":[-0.2,-1.3,-0.2],"max":[0.2,1.3,0.2]}]}' >wide.json
gone wall.ply 0 --from cells --cells wide.json --rays 0
echo '{"cells":[{"min":[-0.2,-0.2,-0.2],"max":[0.2,4,0.2]}]}' >long.json
gone wall.ply 0 --from cells --cells long.json --rays 0
echo '{"frames":2,"keyframes":[{"eye":[-1,0,0],"target":[1,0,0]},{"eye":[0,0,0],"target":[1,0,0]}]}' >path.json
gone_proved wall.ply 1 --from path --path path.json --reach 0.1
gone wall.ply 0 --from path --path path.json --reach 3
gone wall.ply 0 --from outside

# glTF: a house with a thing in its mesh, another node in it, and a chair that is shown outside and inside.
python3 - <<'END' || fail "glTF cannot be made"
import base64, json, struct
def cube(lo, hi):
    v = [[(hi if i >> a & 1 else lo) for a in range(3)] for i in range(8)]
    quads = [(0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6)]
    return v, [k for a, b, c, d in quads for k in (a, b, c, a, c, d)]
data = b''
doc = {'asset': {'version': '2.0', 'extras': {'kept': [1.5, 'x']}}, 'scene': 0, 'scenes': [{'nodes': [0, 2, 4]}], 'accessors': [],
       'materials': [{'name': 'stone'}, {'name': 'wood', 'extras': {'age': 7}}], 'bufferViews': [], 'meshes': []}
def accessor(numbers, code, kind, count, component):
    global data
    packed = struct.pack('<%d%s' % (len(numbers), code), *numbers)
    doc['bufferViews'].append({'buffer': 0, 'byteOffset': len(data), 'byteLength': len(packed)})
    data += packed + b'\0' * (-len(packed) % 4)
    doc['accessors'].append({'bufferView': len(doc['bufferViews']) - 1, 'componentType': component, 'count': count, 'type': kind})
    return len(doc['accessors']) - 1
def primitive(vertices, indices, material, mode=4):
    flat = [x for v in vertices for x in v]
    made = {'attributes': {'POSITION': accessor(flat, 'f', 'VEC3', len(vertices), 5126)}, 'material': material, 'mode': mode}
    if indices: made['indices'] = accessor(indices, 'B', 'SCALAR', len(indices), 5121)
    return made
def mesh(name, *primitives):
    doc['meshes'].append({'name': name, 'primitives': list(primitives)})
    return len(doc['meshes']) - 1
v, i = cube(4, 5)
house = mesh('house', primitive(*cube(0, 10), 0), primitive(*cube(2, 3), 1))
inner = mesh('inner', primitive([v[k] for k in i], None, 1))
chair = mesh('chair', primitive(*cube(0, 1), 1))
# A shell, and what it shares a list with: first a strip in it, and then a triangle far outside.
corners = [[6, 6, 1], [7, 6, 1], [6, 7, 1], [7, 7, 1], [30, 0, 0], [31, 0, 0], [30, 1, 0]]
mixed = mesh('mixed', primitive(corners, [0, 1, 2, 3, 3, 4, 4, 5, 6], 0, 5))
doc['nodes'] = [{'name': 'house', 'mesh': house, 'children': [1, 3], 'extras': {'id': 3}}, {'name': 'inner', 'mesh': inner},
                {'name': 'chair out', 'mesh': chair, 'translation': [20, 0, 0]},
                {'name': 'chair in', 'mesh': chair, 'translation': [7, 7, 7]},
                {'name': 'mixed', 'mesh': mixed}]
doc['buffers'] = [{'byteLength': len(data)}]
text = json.dumps(doc).encode()
text += b' ' * (-len(text) % 4)
with open('house.glb', 'wb') as out:
    out.write(struct.pack('<III', 0x46546C67, 2, 28 + len(text) + len(data)) + struct.pack('<II', len(text), 0x4E4F534A) + text)
    out.write(struct.pack('<II', len(data), 0x4E4942) + data)
doc['buffers'][0]['uri'] = 'data:application/octet-stream;base64,' + base64.b64encode(data).decode()
json.dump(doc, open('house.gltf', 'w'))
END
for format in glb gltf; do
  # 12 triangles each of the thing, of the other node and of the chair inside, and 3 of the strip, of which one has no area.
  gone_proved house.$format 39 --from outside
  grep -q '"kept_for_other_instances": 0,' told || fail "instances: $(cat told)"
  same house.$format 200
  python3 - pruned.$format <<'END' || fail "house.$format"
import base64, json, struct, sys
def read(name):
    b = open(name, 'rb').read()
    if b[:4] != b'glTF':
        doc = json.loads(b)
        return doc, [base64.b64decode(x.pop('uri').split(',')[1]) for x in doc['buffers']]
    n = struct.unpack('<I', b[12:16])[0]
    assert struct.unpack('<I', b[8:12])[0] == len(b)
    return json.loads(b[20:20 + n]), [b[28 + n:]]
old, old_data = read('house.' + sys.argv[1].split('.')[1])
new, data = read(sys.argv[1])
def indices(doc, data, number):
    a = doc['accessors'][number]
    v = doc['bufferViews'][a['bufferView']]
    code = {5121: 'B', 5123: 'H', 5125: 'I'}[a['componentType']]
    return list(struct.unpack_from('<%d%s' % (a['count'], code), data[v['buffer']], v['byteOffset']))
for member in ('asset', 'scene', 'scenes', 'materials'): assert new[member] == old[member], member
assert new['accessors'][:len(old['accessors'])] == old['accessors']
assert new['bufferViews'][:len(old['bufferViews'])] == old['bufferViews']
assert data[0][:len(old_data[0])] == old_data[0]
for a, b in zip(old['nodes'], new['nodes']):
    assert 'mesh' in b or b['name'] in ('inner', 'chair in'), b
    assert 'mesh' not in b or b['name'] not in ('inner', 'chair in'), b
    assert {k: x for k, x in a.items() if k != 'mesh'} == {k: x for k, x in b.items() if k != 'mesh'}
assert new['meshes'][:1] == [{'name': 'house', 'primitives': old['meshes'][0]['primitives'][:1]}]
assert new['meshes'][1:3] == old['meshes'][1:3]
strip = new['meshes'][3]['primitives'][0]
assert 'mode' not in strip and indices(new, data, strip['indices'])[-3:] == [4, 5, 6], strip
END
done
gone house.glb 3 --from outside --keep wood --keep inner
gone house.glb 0 --from outside --keep house --keep mixed
# A chair that is half outside. A pair of things of which one is inside in one place alone. What another scene shows.
python3 - <<'END'
import json
doc = json.load(open('house.gltf'))
doc['nodes'][3]['scale'] = [1, 1, 20]
json.dump(doc, open('pole.gltf', 'w'))
doc['nodes'][3]['scale'] = [1, 1, 1]
doc['scenes'].append({'nodes': [3]})
json.dump(doc, open('scenes.gltf', 'w'))
scenes = doc.pop('scenes')
nodes = doc['nodes']
doc['scenes'] = scenes[:1]
doc['meshes'].append({'name': 'pair', 'primitives': [doc['meshes'][k]['primitives'][0] for k in (2, 1)]})
doc['nodes'] = [{'name': 'shell', 'mesh': 0}, {'name': 'far', 'mesh': 4, 'translation': [100, 0, 0]},
                {'name': 'near', 'mesh': 4, 'translation': [7, 7, 7]}]
doc['scenes'] = [{'nodes': [0, 1, 2]}]
json.dump(doc, open('pair.gltf', 'w'))
doc['nodes'], doc['scenes'] = nodes, scenes
doc['meshes'].pop()
doc['animations'] = [{'channels': [], 'samplers': []}]
doc['images'] = [{'uri': 'wood.png'}]
json.dump(doc, open('moving.gltf', 'w'))
END
gone pole.gltf 27 --from outside
same pole.gltf 100
gone pair.gltf 12 --from outside
grep -q '"kept_for_other_instances": 12,' told || fail "the pair: $(cat told)"
same pair.gltf 100
gone scenes.gltf 27 --from outside
grep -q '"kept_as_they_cannot_go": 12,' told || fail "another scene: $(cat told)"
mkdir other
"$occlude" prune moving.gltf --from outside --out other/pruned.gltf >/dev/null 2>stderr || fail "moving: $(cat stderr)"
grep -q 'animations' stderr && grep -q 'lie beside moving.gltf: wood.png' stderr || fail "warnings: $(cat stderr)"
rm -r other

# Binary PLY with colours, faces of two corners and what follows them.
python3 - <<'END'
import struct
def cube(lo, hi): return [[(hi if i >> a & 1 else lo) for a in range(3)] for i in range(8)]
quads = [(0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6)]
def write(name, faces):
    with open(name, 'wb') as out:
        out.write(b'ply\nformat binary_little_endian 1.0\ncomment two boxes\nelement vertex 16\nproperty float x\nproperty float y\n'
                  b'property float z\nproperty uchar red\nelement face %d\nproperty uchar flag\nproperty list uchar int vertex_indices\n'
                  b'element mark 1\nproperty int what\nend_header\n' % len(faces))
        for k, v in enumerate(cube(0, 9) + cube(3, 4)): out.write(struct.pack('<fffB', *v, k))
        for k, f in faces: out.write(struct.pack('<BB%di' % len(f), k, len(f), *f))
        out.write(struct.pack('<i', 77))
outer, inner = [(k, q) for k, q in enumerate(quads)], [(9 + k, tuple(c + 8 for c in q)) for k, q in enumerate(quads)]
line = [(99, (0, 1))]
write('binary.ply', inner[:3] + line + outer + inner[3:])
write('expected.ply', line + outer)
END
gone binary.ply 6 --from outside
cmp expected.ply pruned.ply || fail "the binary PLY"

# Twenty machine parts: four fifths of what pictures do not show is gone, and in fact all of it.
for seed in $(seq 20); do
  python3 "$parts" "$seed" part.ply || fail "part $seed cannot be made"
  "$occlude" prune part.ply --from outside --out pruned.ply >/dev/null || fail "part $seed"
  same part.ply 10
  grep -qE ' (100|9[0-9][.0-9]*) % of what' drawn || fail "part $seed: $(cat drawn)"
done

# The judges find what is wrong: the closed box without its upper side.
"$pictures" closed.ply open.ply 20 200 128 >drawn
[ $? -eq 1 ] && grep -q '^picture' drawn && grep -q '^a ray reaches polygon 5,' drawn || fail "a side less is not found: $(cat drawn)"

# The same with any number of threads; and again, of what was written.
"$occlude" prune lid.ply --from outside --effort 1000 --out first.ply >/dev/null
taskset -c 0 "$occlude" prune lid.ply --from outside --effort 1000 --out second.ply >/dev/null
cmp first.ply second.ply || fail "threads"
gone first.ply 0 --from outside --effort 5000

# Bad input.
expect_error '--from' "$occlude" prune closed.ply --out bad.ply
expect_error '--from' "$occlude" prune closed.ply --from inside --out bad.ply
expect_error '--out' "$occlude" prune closed.ply --from outside
expect_error '--out' "$occlude" prune closed.ply --from outside --out bad.obj
expect_error 'closed.ply' "$occlude" prune closed.ply --from outside --out closed.ply
expect_error 'missing.ply' "$occlude" prune missing.ply --from outside --out bad.ply
expect_error 'nothing in the model has the name lamp' "$occlude" prune window.obj --from outside --out bad.obj --keep lamp
expect_error '--cells' "$occlude" prune closed.ply --from cells --out bad.ply
expect_error '--touching' "$occlude" prune closed.ply --from cells --cells cells.json --touching --out bad.ply
expect_error '--cells' "$occlude" prune closed.ply --from outside --cells cells.json --out bad.ply
echo '{"model":"closed.ply","frames":2,"projection":"orthographic","height":2,"keyframes":[{"eye":[0,0,0],"target":[1,0,0]},{"eye":[0,0,0],"target":[1,1,0]}]}' >parallel.json
sed 's/closed/other/; s/orthographic/perspective/; s/"height":2,//' parallel.json >other.json
expect_error 'parallel.json: its rays are parallel' "$occlude" prune closed.ply --from path --path parallel.json --out bad.ply
expect_error '--path: goes with --from path' "$occlude" prune closed.ply --from outside --path other.json --out bad.ply
expect_error '--reach: goes with --from path' "$occlude" prune closed.ply --from outside --reach 2 --out bad.ply
"$occlude" prune closed.ply --from path --path other.json --effort 0 --out other.ply >/dev/null 2>stderr
grep -q 'other.json: made for other.ply, not for closed.ply' stderr || fail "prune takes the path of another model: $(cat stderr)"
echo '{"cells":[]}' >none.json
expect_error 'none.json: no cells' "$occlude" prune closed.ply --from cells --cells none.json --out bad.ply
echo 'solid x' >model.stl
expect_error 'model.stl' "$occlude" prune model.stl --from outside --out bad.stl
head -c 300 closed.ply >cut.ply
expect_error 'cut.ply' "$occlude" prune cut.ply --from outside --out bad.ply
head -c 500 house.glb >cut.glb
expect_error 'cut.glb' "$occlude" prune cut.glb --from outside --out bad.glb

finish
