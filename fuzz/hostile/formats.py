# SPDX-License-Identifier: MIT
"""The formats that `occlude` reads: a sound file of each, hostile ones made of it, and bombs."""
import base64
import functools
import gzip
import io
import json
import math
import pathlib
import re
import struct
import subprocess
import zipfile

FILES = {"ply ascii": "a.ply", "ply binary": "a.ply", "obj": "a.obj", "stl": "a.stl", "gltf": "a.gltf", "glb": "a.glb",
         "collada": "a.dae", "3mf": "a.3mf", "path": "a.json", "matrices": "a.csv",
         "gltf camera": "a.gltf", "collada camera": "a.dae", "cases": "a.jsonl", "witnesses": "a.jsonl",
         "hidden": "a.jsonl", "log": "a.jsonl", "binary log": "a.log",
         "preprocess": "a.store", "store": "a.store"}
SOUND = "sound"  # what is done to a file to which nothing is done
MODELS = pathlib.Path(__file__).resolve().parents[2] / "tests" / "data" / "models"
IMPORTED = ("stl", "gltf", "glb", "collada", "3mf", "gltf camera", "collada camera")
JSON = ("path", "cases", "witnesses", "hidden", "log")


def command(name, seeds):
    """The arguments that make the command read the file, and do little else."""
    walk = ["--frames", "0:1", "--no-render", "--occluders", "2", "--probes", "1", "--out", "out"]
    model, path = str(seeds / "model.ply"), str(seeds / "path.json")
    file = FILES[name]
    if name in ("path", "matrices"):
        return ["walk", model, "--path", file, *walk]
    if name.endswith(" camera"):
        return ["walk", file, "--path", "camera:eye", *walk]
    if name == "cases":
        return ["classify", file]
    if name == "witnesses":
        return ["validate", model, "--path", path, "--exact-up-to", "1000", "--witness", file]
    if name == "hidden":
        return ["validate", model, "--witness", file]
    if name.endswith("log"):
        return ["audit", model, "--log", file, "--item-buffers", "0"]
    return ["walk", file, "--path", path, *walk]


# A wall and a row of squares behind it.
SQUARES = [[(x, -1, -1), (x, 1, -1), (x, 1, 1), (x, -1, 1)] for x in range(2, 42)]
VERTICES = [vertex for square in SQUARES for vertex in square]
TRIANGLES = [(4 * i + a, 4 * i + b, 4 * i + c) for i in range(len(SQUARES)) for a, b, c in ((0, 1, 2), (0, 2, 3))]
PATH = {"frames": 4, "keyframes": [{"eye": [0, 0, 0], "target": [1, 0, 0]}, {"eye": [0.5, 0.25, 0],
                                                                             "target": [1.5, 0, 0]}],
        "fov_y_deg": 60, "near": 0.1, "far": 1000.0, "up": [0, 0, 1], "interpolation": "smooth"}


# Cameras on the same way, as matrices.
MATRICES = [[0, 0, -1, x, -1, 0, 0, y, 0, 1, 0, 0, 0, 0, 0, 1] for x, y in ((0, 0), (0.25, 0.125), (0.5, 0.25))]


def matrices():
    return "\n".join(["# made to be damaged"] + [",".join(map(repr, m)) for m in MATRICES]).encode() + b"\n"


MATRIX = [0, 0, 1, 1, -1, 0, 0, 0, 0, 1.75, 0, 0, 0, 0, -0.2, 0]  # of a projection, column after column


def log():
    """What is hidden behind the wall, in all words."""
    squares = [1, [2, len(SQUARES) - 2]]
    frames = [{**camera, **listed, "width": 64, "height": 36}
              for camera in ({"eye": [0, 0, 0], "target": [1, 0, 0], "up": [0, 0, 1], "fov_y_deg": 60, "far": 1000},
                             {"eye": [0, 0, 0], "target": [1, 0, 0], "projection": "orthographic", "view_height": 2, "near": 0.5},
                             {"matrix": MATRIX, "order": "column", "clip_depth": "minus_w_to_w"})
              for listed in ({"culled": squares}, {"drawn": [0]}, {"culled_objects": [8]}, {"drawn_objects": [7]})]
    lines = [{"object": 7, "polygons": [0]}, {"object": 8, "polygons": squares}]
    lines += [{"frame": i, **frame} for i, frame in enumerate(frames)]
    return "".join(json.dumps(line) + "\n" for line in lines).encode()


def binary_log():
    def ranges(*numbers):
        return struct.pack(f"<{len(numbers) + 1}I", len(numbers) // 2, *numbers)

    file = b"OCCLLOG1" + struct.pack("<2I", 3, 7) + ranges(0, 1) + struct.pack("<2I", 3, 8) + ranges(1, len(SQUARES) - 1)
    file += struct.pack("<5I16dI", 1, 0, 64, 36, 0, *MATRIX, 0) + ranges(1, len(SQUARES) - 1)
    file += struct.pack("<5I12d", 2, 1, 64, 36, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 60, 0.1, math.inf) + ranges(0, 1)
    return file + struct.pack("<5I12d2I", 2, 2, 64, 36, 2, 0, 0, 0, 1, 0, 0, 0, 0, 1, 60, 0.1, 1000, 1, 8)


def ply_header(kind, vertices=len(VERTICES), faces=len(SQUARES), more=""):
    return (f"ply\nformat {kind} 1.0\ncomment made to be damaged\nelement vertex {vertices}\nproperty double x\n"
            f"property double y\nproperty float z\n{more}element face {faces}\nproperty list uchar int vertex_indices\n"
            "end_header\n").encode()


def ply_ascii():
    vertices = [" ".join(map(repr, v)) for v in VERTICES]
    faces = [f"4 {i} {i + 1} {i + 2} {i + 3}" for i in range(0, len(VERTICES), 4)]
    return ply_header("ascii") + "\n".join(vertices + faces).encode() + b"\n"


def ply_binary(order="<"):
    body = b"".join(struct.pack(order + "ddf", *v) for v in VERTICES)
    body += b"".join(struct.pack(order + "Biiii", 4, *range(4 * i, 4 * i + 4)) for i in range(len(SQUARES)))
    return ply_header("binary_little_endian" if order == "<" else "binary_big_endian") + body


def obj():
    lines = ["# made to be damaged", "o wall"] + [f"v {x} {y} {z}" for x, y, z in VERTICES] + ["vn 1 0 0", "vt 0 0"]
    lines += [f"f {i + 1}/1/1 {i + 2}//1 \\\n  {i + 3} {i + 3 - len(VERTICES)}" for i in range(0, len(VERTICES), 4)]
    return "\n".join(lines).encode() + b"\n"


def stl_ascii():
    corners = [["vertex %g %g %g\n" % VERTICES[i] for i in t] for t in TRIANGLES]
    facets = ["facet normal 1 0 0\nouter loop\n" + "".join(three) + "endloop\nendfacet" for three in corners]
    return ("solid wall\n" + "\n".join(facets) + "\nendsolid wall\n").encode()


def stl_binary():
    facets = [struct.pack("<3f", 1, 0,
                          0) + b"".join(struct.pack("<3f", *VERTICES[i]) for i in t) + b"\0\0" for t in TRIANGLES]
    return b"made to be damaged".ljust(80) + struct.pack("<I", len(facets)) + b"".join(facets)


def gltf_parts():
    indices = b"".join(struct.pack("<3H", *t) for t in TRIANGLES)
    positions = b"".join(struct.pack("<3f", *v) for v in VERTICES)
    scene = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
             "nodes": [{"children": [1], "translation": [0, 0, 0]}, {"mesh": 0}],
             "meshes": [{"primitives": [{"attributes": {"POSITION": 1}, "indices": 0}]}],
             "accessors": [{"bufferView": 0, "byteOffset": 0, "componentType": 5123, "count": 3 * len(TRIANGLES),
                            "type": "SCALAR"},
                           {"bufferView": 1, "byteOffset": 0, "componentType": 5126, "count": len(VERTICES),
                            "type": "VEC3",
                            "min": [2, -1, -1], "max": [41, 1, 1]}],
             "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": len(indices)},
                             {"buffer": 0, "byteOffset": len(indices), "byteLength": len(positions), "byteStride": 12}],
             "buffers": [{"byteLength": len(indices) + len(positions)}]}
    return scene, bytearray(indices + positions)


def add_accessor(scene, binary, kind, component, form, elements, **more):
    """Adds numbers to the buffer of a scene, and returns the index of their accessor."""
    data = b"".join(struct.pack("<" + form, *element) for element in elements)
    scene["bufferViews"].append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(data)})
    scene["accessors"].append({"bufferView": len(scene["bufferViews"]) - 1, "componentType": component,
                               "count": len(elements), "type": kind, **more})
    binary += data + b"\0" * (-len(data) % 4)
    scene["buffers"][0]["byteLength"] = len(binary)
    return len(scene["accessors"]) - 1


def gltf_of_all_kinds():
    """A scene with what else may say where vertices are: a skin, morph targets, sparse and quantised numbers, instances."""
    scene, binary = gltf_parts()
    scene["extensionsUsed"] = ["KHR_mesh_quantization", "EXT_mesh_gpu_instancing", "KHR_node_visibility"]
    accessor = functools.partial(add_accessor, scene, binary)
    count = len(VERTICES)
    identity = [1.0 if i % 5 == 0 else 0.0 for i in range(16)]
    attributes = scene["meshes"][0]["primitives"][0]["attributes"]
    attributes["JOINTS_0"] = accessor("VEC4", 5121, "4B", [(0, 1, 0, 0)] * count)
    attributes["WEIGHTS_0"] = accessor("VEC4", 5121, "4B", [(200, 55, 0, 0)] * count, normalized=True)
    target = accessor("VEC3", 5126, "3f", [(0, 0, 0.1)] * count)
    indices = accessor("SCALAR", 5123, "H", [(1,), (3,)])
    values = accessor("VEC3", 5126, "3f", [(0, 0, 0.2)] * 2)
    scene["accessors"][target]["sparse"] = {
        "count": 2, "indices": {"bufferView": scene["accessors"][indices]["bufferView"], "componentType": 5123},
        "values": {"bufferView": scene["accessors"][values]["bufferView"]}}
    scene["meshes"][0]["primitives"][0]["targets"] = [{"POSITION": target}]
    scene["meshes"][0]["weights"] = [0.5]
    scene["skins"] = [{"joints": [0, 2], "inverseBindMatrices": accessor("MAT4", 5126, "16f", [identity] * 2)}]
    scene["nodes"][1]["skin"] = 0
    strip = accessor("VEC3", 5122, "4h", [(1, 0, 0, 0), (1, 100, 0, 0), (1, 0, 100, 0), (1, 100, 100, 0)])
    scene["bufferViews"][scene["accessors"][strip]["bufferView"]]["byteStride"] = 8
    scene["materials"] = [{"alphaMode": "BLEND", "extensions": {"KHR_materials_transmission": {"transmissionFactor": 0.5}}}]
    scene["meshes"].append({"primitives": [{"attributes": {"POSITION": strip}, "mode": 5, "material": 0},
                                           {"attributes": {"POSITION": strip}, "mode": 6}]})
    instances = {"TRANSLATION": accessor("VEC3", 5126, "3f", [(3, 0, 0), (4, 0, 0)]),
                 "ROTATION": accessor("VEC4", 5122, "4h", [(0, 0, 0, 32767)] * 2, normalized=True)}
    scene["nodes"] += [{"translation": [0, 0, 0.25], "rotation": [0, 0, 0, 1], "scale": [1, 1, 1]},
                       {"mesh": 1, "scale": [0.01, 0.01, 0.01],
                        "extensions": {"EXT_mesh_gpu_instancing": {"attributes": instances},
                                       "KHR_node_visibility": {"visible": True}}}]
    scene["nodes"][0]["children"] += [2, 3]
    return scene, binary


def gltf(scene=None, binary=None):
    own_scene, own_binary = gltf_parts()
    scene, binary = scene or own_scene, own_binary if binary is None else binary
    if scene.get("buffers") and "uri" not in scene["buffers"][0]:
        scene["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64.b64encode(binary).decode()
    return json.dumps(scene, indent=1).encode()


def glb(scene=None, binary=None, lengths=(0, 0, 0)):
    own_scene, own_binary = gltf_parts()
    text = json.dumps(scene or own_scene).encode()
    text += b" " * (-len(text) % 4)
    binary = own_binary if binary is None else binary
    chunks = struct.pack("<I4s", lengths[1] or len(text), b"JSON") + text
    chunks += struct.pack("<I4s", lengths[2] or len(binary), b"BIN\0") + binary
    return struct.pack("<4sII", b"glTF", 2, lengths[0] or 12 + len(chunks)) + chunks


def gltf_camera():
    """The same with a camera that moves."""
    scene, binary = gltf_parts()
    times = add_accessor(scene, binary, "SCALAR", 5126, "f", [(0,), (0.5,), (1,)])
    places = add_accessor(scene, binary, "VEC3", 5126, "3f", [(0, 0, 0), (0.5, 0.25, 0), (1, 0, 0)])
    turns = add_accessor(scene, binary, "VEC4", 5126, "4f", [(0.5, -0.5, -0.5, 0.5)] * 3)
    scene["scenes"][0]["nodes"].append(2)
    scene["nodes"] += [{"children": [3]}, {"name": "eye", "camera": 0}]
    scene["cameras"] = [{"type": "perspective", "perspective": {"yfov": 1, "znear": 0.1, "zfar": 1000}}]
    scene["animations"] = [{"samplers": [{"input": times, "output": places},
                                         {"input": times, "output": turns, "interpolation": "STEP"}],
                            "channels": [{"sampler": 0, "target": {"node": 2, "path": "translation"}},
                                         {"sampler": 1, "target": {"node": 3, "path": "rotation"}}]}]
    return gltf(scene, binary)


def collada_camera():
    optics = ("<optics><technique_common><perspective><xfov>60</xfov><aspect_ratio>1.5</aspect_ratio><znear>0.1</znear>"
              "<zfar>1000</zfar></perspective></technique_common></optics>")
    node = ('<node id="n"><instance_geometry url="#g"/></node><node id="eye" name="eye"><rotate>0 0 1 -90</rotate>'
            '<rotate>1 0 0 90</rotate><instance_camera url="#c"/></node>')
    camera = f'<library_cameras><camera id="c" name="c">{optics}</camera></library_cameras>\n<library_geometries>'.encode()
    return collada(node).replace(b"<library_geometries>", camera)


def collada(nodes='<node id="n"><translate>0 0 0</translate><instance_geometry url="#g"/></node>', doctype=""):
    numbers = " ".join("%g %g %g" % v for v in VERTICES)
    indices = " ".join(str(i) for i in range(len(VERTICES)))
    return f"""<?xml version="1.0" encoding="utf-8"?>{doctype}
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="pa" count="{3 * len(VERTICES)}">{numbers}</float_array>
<technique_common><accessor source="#pa" count="{len(VERTICES)}" stride="3"><param name="X" type="float"/><param name="Y"
type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<polylist count="{len(SQUARES)}"><input semantic="VERTEX" source="#v" offset="0"/><vcount>{"4 " * len(SQUARES)}</vcount>
<p>{indices}</p></polylist></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s">{nodes}</visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>
""".encode()


def model_3mf(padding=b"", objects=None):
    vertices = "".join('<vertex x="%g" y="%g" z="%g"/>' % v for v in VERTICES)
    triangles = "".join('<triangle v1="%d" v2="%d" v3="%d"/>' % t for t in TRIANGLES)
    objects = objects or (f'<object id="1" type="model"><mesh><vertices>{vertices}</vertices>'
                          f'<triangles>{triangles}</triangles></mesh></object>')
    return (b'<?xml version="1.0" encoding="UTF-8"?><model unit="millimeter" xml:lang="en-US" '
            b'xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>' + padding + objects.encode() +
            b'</resources><build><item objectid="1"/></build></model>')


RELATIONS = (b'<?xml version="1.0" encoding="UTF-8"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/'
             b'relationships"><Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/'
             b'3dmanufacturing/2013/01/3dmodel"/></Relationships>')
CONTENT_TYPES = (b'<?xml version="1.0" encoding="UTF-8"?><Types xmlns="http://schemas.openxmlformats.org/package/2006/'
                 b'content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.'
                 b'relationships+xml"/><Default Extension="model" ContentType="application/vnd.ms-package.'
                 b'3dmanufacturing-3dmodel+xml"/></Types>')


def pack_3mf(write_model, more=()):
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as package:
        package.writestr("[Content_Types].xml", CONTENT_TYPES)
        package.writestr("_rels/.rels", RELATIONS)
        with package.open("3D/3dmodel.model", "w", force_zip64=True) as model:
            write_model(model)
        for name, data in more:
            package.writestr(name, data)
    return file.getvalue()


# A claim from outside, and a shell, of nothing.
SHELL = (b'{"claim":[],"outside":{"min":[-9,-9,-9],"max":[99,9,9]},"touching":true}\n'
         b'{"hidden":[],"shell":[]}\n')


def make_seeds(occlude, folder):
    """Sound files, by format; what `occlude` itself writes is written by it."""
    def ask(*arguments):
        subprocess.run([occlude, *arguments], cwd=folder, check=True, stdout=subprocess.DEVNULL)

    (folder / "model.ply").write_bytes(ply_binary())
    (folder / "path.json").write_text(json.dumps(PATH))
    ask("walk", "model.ply", "--path", "path.json", "--no-render", "--out", "seed", "--witness", "witness.jsonl",
        "--cases", "cases.jsonl")
    (folder / "cells.json").write_text(json.dumps({"cells": [{"min": [0, -0.25, 0], "max": [0.5, 0.25, 0.25]}]}))
    ask("bake", "model.ply", "--cells", "cells.json", "--out", "model.pvs", "--witness", "hidden.jsonl")
    ask("preprocess", "model.ply", "--out", "model.store", "--region-count", "8", "--samples", "1")
    cases = (folder / "cases.jsonl").read_bytes().splitlines(True)[:20]
    polytope = (b'{"id":"block","eye":[0,0,0],"occluder":{"vertices":[[2,0,-1],[4,0,-1],[4,2,-1],[2,2,-1],[2,0,1],[4,0,1],'
                b'[4,2,1],'
                b'[2,2,1]],"faces":[[0,1,2,3],[4,5,6,7],[0,1,5,4],[1,2,6,5],[3,2,6,7],[0,4,7,3]]},"near":"surface",'
                b'"box":{"center":[6,2,0],"half_edges":[[1,1,0],[-1,1,0],[0,0,1]]},"expect":"inside"}\n')
    return {"ply ascii": [ply_ascii()], "ply binary": [ply_binary("<"), ply_binary(">")], "obj": [obj()],
            "stl": [stl_ascii(), stl_binary()], "gltf": [gltf(), gltf(*gltf_of_all_kinds())],
            "glb": [glb(), glb(*gltf_of_all_kinds())] + [file.read_bytes() for file in sorted(MODELS.glob("*.glb"))],
            "collada": [collada()],
            "3mf": [pack_3mf(lambda model: model.write(model_3mf()))],
            "path": [json.dumps(PATH, indent=1).encode(), json.dumps({"matrices": MATRICES, "near": 0.1}).encode()],
            "matrices": [matrices()], "gltf camera": [gltf_camera()], "collada camera": [collada_camera()],
            "cases": [b"".join(cases) + polytope, polytope], "witnesses": [(folder / "witness.jsonl").read_bytes()],
            "hidden": [(folder / "hidden.jsonl").read_bytes(), SHELL],
            "log": [log(), gzip.compress(log())], "binary log": [binary_log(), gzip.compress(binary_log())],
            "preprocess": [(folder / "model.store").read_bytes()], "store": [(folder / "model.store").read_bytes()]}


# ---- Damage to a sound file ----

NUMBERS = [b"nan", b"-nan", b"inf", b"-Infinity", b"1e999", b"-1e999", b"1e-999", b"+-5", b"++5", b"0x10", b"1,5",
           b"-0", b"-1",
           b"2147483647", b"2147483648", b"4294967295", b"4294967296", b"9223372036854775807", b"9223372036854775808",
           b"18446744073709551615", b"18446744073709551616", b"1e18", b"1e30", b"1.2676506002282295e30", b"1e-31",
           b"0.1", b"1.", b".5",
           b"1e", b"--1", b"", b"true", b"\"5\"", b"null", b"[]", b"{}", b"[[[[]]]]"]
WORDS = [b"\x1b[2J\x1b]0;owned\x07", b"\xff\xfe\xfd", b"\xc3\x28", b"\xed\xa0\x80", b"\xc2\x9b31m", b"\0", b"%s%n%x",
         b"\r", b"\n", b"\r\n", b"\"",
         b"\\", b"/", b"#", b"{", b"}", b"[", b"]", b"<", b">", b"&lt;", b"<!--", b"]]>", b",", b":",
         b"../../../../dev/zero",
         b"end_header", b"\\u0000", b"\\ud800"]
NUMBER = re.compile(rb"-?\d+(?:\.\d+)?(?:e-?\d+)?")


def number(random):
    if random.random() < 0.1:
        return random.choice([b"", b"0", b"0.", b"1e", b"-"]) + b"%d" % random.randrange(10) * 10 ** random.randint(2,
                                                                                                                    5)
    any_size = repr(random.uniform(-1, 1) * 10 ** random.randint(-40, 40)).encode()
    return random.choice(NUMBERS) if random.random() < 0.8 else any_size


def place(random, data):
    return random.randrange(len(data) + 1)


def cut(random, data):
    return data[:place(random, data)]


def without(random, data):
    i = place(random, data)
    return data[:i] + data[i + random.randint(1, 100):]


def repeated(random, data):
    i = place(random, data)
    piece = data[i:i + random.randint(1, 300)]
    return data[:i] + piece * min(10 ** random.randint(1, 5), 1 + 10_000 // max(1, len(piece))) + data[i:]


def flipped(random, data):
    changed = bytearray(data)
    for _ in range(random.randint(1, 20)):
        if changed:
            changed[random.randrange(len(changed))] ^= 1 << random.randrange(8)
    return bytes(changed)


def inserted(random, data):
    i = place(random, data)
    return data[:i] + random.choice(WORDS) * random.choice([1, 1, 1, 1000]) + data[i:]


def with_number(random, data):
    for _ in range(random.randint(1, 3)):
        found = list(NUMBER.finditer(data[:200_000]))
        if found:
            one = random.choice(found)
            data = data[:one.start()] + number(random) + data[one.end():]
    return data


def with_binary_number(random, data):
    value = random.choice([0, 1, 0x7f, 0xff, 0xffff, 0x7fffffff, 0x80000000, 0xffffffff, 0xfffffff0, 0x3fffffff,
                           0x10000000,
                           random.getrandbits(32)])
    width = random.choice([1, 2, 4, 8])
    value = (value << random.choice([0, 32]) if width == 8 else value) & (1 << 8 * width) - 1
    i = place(random, data) if random.random() < 0.5 else random.randrange(min(200, len(data)) + 1)
    return data[:i] + value.to_bytes(width, "little") + data[i + width:]


def other_line_ends(random, data):
    return data.replace(b"\n", random.choice([b"\r", b"\r\n", b"\n\n", b" ", b"\0"]))


def marked(random, data):
    mark = random.choice([b"\xef\xbb\xbf", b"\xff\xfe", b"\xfe\xff", b"\0\0\xfe\xff"])
    if mark in (b"\xff\xfe", b"\xfe\xff") and random.random() < 0.5:
        return mark + data.decode("latin-1").encode("utf-16-le" if mark == b"\xff\xfe" else "utf-16-be")
    return mark + data


def lines_shuffled(random, data):
    lines = data.split(b"\n")
    random.shuffle(lines)
    return b"\n".join(lines)


def with_more(random, data):
    return data + random.choice([b"\0", b"x", data, b"\n" * 1000, b"\0" * 100_000, random.randbytes(1000)])


def noise(random, data):
    return data[:random.randint(0, 40)] + random.randbytes(random.choice([0, 1, 10, 1000, 100_000]))


DAMAGES = [cut, without, repeated, flipped, inserted, with_number, with_number, with_number, with_binary_number,
           other_line_ends, marked,
           lines_shuffled, with_more, noise]


def other_value(random, value):
    """A JSON value with another in place of one of its parts."""
    if isinstance(value, dict) and value and random.random() < 0.9:
        key = random.choice(list(value))
        if random.random() < 0.1:
            return {k: v for k, v in value.items() if k != key}
        return {**value, key: other_value(random, value[key])}
    if isinstance(value, list) and value and random.random() < 0.9:
        i = random.randrange(len(value))
        if random.random() < 0.1:
            return value[:i] + value[i:i + 1] * random.choice([0, 2, 20]) + value[i + 1:]
        return value[:i] + [other_value(random, value[i])] + value[i + 1:]
    return random.choice([None, True, -1, 0, 1, 5, 2 ** 31, 2 ** 32 - 1, 2 ** 63, 2 ** 64, 1e300, -1e30, 1e-31, 0.1,
                          "", "x", "nan", "1", [], {},
                          [[]], [0, 0, 0], [1e30, 0, 0], {"polygon": []}, "\x1b[2J", "x" * 10_000])


def with_other_value(random, data):
    lines = data.splitlines()
    try:
        i = random.randrange(len(lines))
        lines[i] = json.dumps(other_value(random, json.loads(lines[i]))).encode()
        return b"\n".join(lines)
    except (ValueError, IndexError):
        pass
    try:
        return json.dumps(other_value(random, json.loads(data))).encode()
    except ValueError:
        return data


# ---- Bombs: small to write down, large to read ----

MIB = 1 << 20


def numbers_without_end(random):
    return random.choice([b"9", b"1e", b"0.", b"-", b"0"]) + b"7" * random.choice([1000, MIB, 4 * MIB])


def ply_bombs(random):
    huge = random.choice([2 ** 31, 2 ** 32, 2 ** 63, 2 ** 64 - 1, 10 ** 30, 10 ** 9])
    kind = random.choice(["ascii", "binary_little_endian", "binary_big_endian"])
    body = random.choice([b"", b"\0" * 1000, b"\xff" * 1000, b"0 " * 1000, b"3 0 1 2\n" * 1000])
    char_vertices = (b"ply\nformat binary_little_endian 1.0\nelement vertex 300000\nproperty char x\nproperty char y\n"
                     b"property char z\n")
    return random.choice([
        lambda: ("vertices", ply_header(kind, huge) + body), lambda: ("faces", ply_header(kind, 3, huge) + body),
        lambda: ("elements", ply_header(kind, 3, 1, "".join(f"element e{i} {huge}\n" for i in range(1100))) + body),
        lambda: ("properties",
                 ply_header(kind, 3, 1, "".join(f"property list uint uint p{i}\n" for i in range(999))) + body),
        lambda: ("list", ply_header(kind, 3, 1, "property list uint double more\n") + b"\xff" * 100_000),
        lambda: ("empty element", ply_header(kind, 3, 1, f"element void {huge}\n") + body),
        lambda: ("words", b"ply\nformat ascii 1.0\n" + b"a " * (4 * MIB) + b"\n"),
        lambda: ("line", b"ply\nformat ascii 1.0\ncomment " + b"x" * (8 * MIB)),
        lambda: ("name", b"ply\nformat ascii 1.0\nelement " + b"\x1b" * MIB + b" 99999\nproperty int x\nend_header\n"),
        lambda: ("small vertices",
                 char_vertices + b"element face 0\nproperty list uchar int vertex_indices\nend_header\n" + b"\1" * 900_000),
        lambda: ("number", ply_header("ascii", 3, 1) + numbers_without_end(random)),
        lambda: ("blanks", ply_header("ascii", 3, 1) + random.choice([b" ", b"\n"]) * (8 * MIB)),
        lambda: ("loop",
                 ply_header("ascii", 3, 1).replace(b"uchar int",
                                                   b"int int") + b"0 0 0\n1 0 0\n0 1 0\n300000 " + b"0 1 2 " * 100_000),
    ])()


def obj_bombs(random):
    corners = b"v 0 0 0\nv 1 0 0\nv 0 1 0\n"
    return random.choice([
        lambda: ("line", corners + b"f " + b"x" * (8 * MIB)),
        lambda: ("number", b"v " + numbers_without_end(random) + b" 0 0\n"),
        lambda: ("continued", b"\\\n" * (2 * MIB)), lambda: ("joined", corners + b"f 1 2 \\\n3 " * 300_000),
        lambda: ("vertices", b"v 0 0 0\n" * MIB), lambda: ("same faces", corners + b"f 1 2 3\n" * 100_000),
        lambda: ("loop", corners + b"f 1 2 3\nf" + b" 1 2 3" * 300), lambda: ("index", corners + b"f 1 2 " + b"9" * MIB),
        lambda: ("short faces", corners + b"f 1 2 3\n" + b"f\n" * MIB), lambda: ("zeros", b"\0" * (8 * MIB)),
        lambda: ("carriage returns", b"\r" * (8 * MIB)),
        lambda: ("control", corners + b"f \x1b[2J\n")])()


def sparse(head):
    """A writer of a file of 1 GB, of which all but the head is a hole: it reads as zeros and takes no space."""
    def write(file):
        with open(file, "wb") as whole:
            whole.write(head)
            whole.truncate(10 ** 9)
    return write


def stl_bombs(random):
    count = random.choice([0xffffffff, 0x7fffffff, 0x5555555, 10 ** 8, 10 ** 6])
    return random.choice([
        lambda: ("hole", sparse(random.choice([b"", b"solid", b" " * 80 + struct.pack("<I", (10 ** 9 - 84) // 50)]))),
        lambda: ("blank", b" " * (64 * MIB)),
        lambda: ("count", b" " * 80 + struct.pack("<I", count) + b"\0" * random.choice([0, 50, 1000, 50_000])),
        lambda: ("solid count", b"solid".ljust(80) + struct.pack("<I", count) + b"\0" * 1000),
        lambda: ("solids", b"solid a\nendsolid a\n" * 100_000),
        lambda: ("facets", b"solid a\n" + b"facet normal 0 0 1\n" * 100_000),
        lambda: ("line", b"solid " + b"x" * (8 * MIB)),
        lambda: ("number", b"solid a\nfacet normal 0 0 1\nouter loop\nvertex " + numbers_without_end(random)),
        lambda: ("vertices", b"solid a\nfacet normal 0 0 1\nouter loop\n" + b"vertex 1 0 0\n" * 300_000)])()


def gltf_scene_bomb(random):
    if random.random() < 0.15:
        return gltf_repeats(random)
    scene, binary = gltf_parts()
    huge = random.choice([2 ** 31 - 1, 2 ** 31, 2 ** 32 - 1, 2 ** 32, 2 ** 53, 2 ** 63 - 1, 2 ** 64 - 1, 10 ** 8,
                          10 ** 9, -1])
    depth = random.choice([1000, 20_000, 100_000])
    kind = random.choice(["count", "count", "stride", "offset", "buffer", "view", "sparse", "uri", "cycle", "deep",
                          "nodes", "indices", "both", "kind"])
    view, accessor = random.choice(scene["bufferViews"]), random.choice(scene["accessors"])
    if kind in ("count", "both"):
        accessor["count"] = huge
    if kind in ("view", "both"):
        view["byteLength"] = huge
    if kind == "stride":
        view["byteStride"] = huge
    if kind == "offset":
        random.choice([view, accessor])["byteOffset"] = huge
    if kind in ("buffer", "both"):
        scene["buffers"][0]["byteLength"] = huge
    if kind == "sparse":
        accessor["sparse"] = {"count": huge, "indices": {"bufferView": 0, "componentType": 5125},
                              "values": {"bufferView": 1}}
        accessor.pop("bufferView", None)
        accessor["count"] = random.choice([huge, 100])
    if kind == "uri":
        scene["buffers"][0]["uri"] = random.choice(["/dev/zero", "/dev/stdin", ".", "..", "/proc/self/mem",
                                                    "/proc/kmsg", "a.gltf", "http://localhost/", "data:,",
                                                    "data:application/octet-stream;base64," + "A" * (4 * MIB),
                                                    "x" * 100_000])
    if kind == "cycle":
        scene["nodes"][1]["children"] = [random.choice([0, 1])]
    if kind == "deep":
        scene["nodes"] = [{"children": [i + 1]} for i in range(depth)] + [{"mesh": 0}]
    if kind == "nodes":  # each the parent of the next, twice
        scene["nodes"] = [{"children": [i + 1, i + 1]} for i in range(40)] + [{"mesh": 0}]
    if kind == "indices":
        scene["meshes"][0]["primitives"] = scene["meshes"][0]["primitives"] * random.choice([10, 1000])
    if kind == "kind":
        accessor["componentType"], accessor["type"] = random.choice([0, 5120, 5130, huge]), random.choice(["MAT4",
                                                                                                           "SCALAR",
                                                                                                           "VEC9", ""])
    return kind, scene, binary


def of_triangles(positions):
    """A scene without meshes, and `positions` corners: what is left to say is which primitives are made of them."""
    scene, _ = gltf_parts()
    scene["accessors"] = [{"bufferView": 0, "componentType": 5126, "count": positions, "type": "VEC3",
                           "min": [0, 0, 0], "max": [1, 1, 1]}]
    scene["bufferViews"] = [{"buffer": 0, "byteLength": 12 * positions}]
    scene["buffers"] = [{"byteLength": 12 * positions}]
    corners = struct.pack("<9f", 1, 0, 0, 1, 1, 0, 1, 0, 1)
    return scene, corners * (positions // 3)


def gltf_repeats(random):
    """A scene that uses the same megabyte thousands of times."""
    scene, binary = of_triangles(87_000)
    count = random.choice([300, 2000, 10_000])
    kind = random.choice(["primitives", "meshes"])
    primitive = {"attributes": {"POSITION": 0}}
    if kind == "primitives":
        scene["meshes"] = [{"primitives": [primitive] * count}]
    else:
        scene["meshes"] = [{"primitives": [primitive]}]
        scene["nodes"] = [{"mesh": 0}] * count
        scene["scenes"] = [{"nodes": list(range(count))}]
    return kind, scene, binary


def gltf_of_one_buffer(random):
    """A writer of a glTF that opens one file thousands of times, by one name or by many."""
    scene, binary = of_triangles(87_000)
    count = random.choice([500, 2000, 10_000])
    name = random.choice([lambda i: "a.bin", lambda i: "./" * (i % 1000) + "a.bin"])
    scene["buffers"] = [{"byteLength": len(binary), "uri": name(i)} for i in range(count)]
    scene["bufferViews"] = [{"buffer": i, "byteLength": 36} for i in range(count)]
    scene["accessors"] = [{"bufferView": i, "componentType": 5126, "count": 3, "type": "VEC3"} for i in range(count)]
    scene["meshes"] = [{"primitives": [{"attributes": {"POSITION": i}} for i in range(count)]}]

    def write(file):
        (file.parent / "a.bin").write_bytes(binary)
        file.write_text(json.dumps(scene))
    return write


def gltf_bombs(random):
    if random.random() < 0.15:
        return random.choice([
            lambda: ("hole", sparse(random.choice([b"", b"{", b'{"asset":']))),
            lambda: ("blank", b"{" + b" " * (64 * MIB) + b"}"),
            lambda: ("one buffer", gltf_of_one_buffer(random))])()
    if random.random() < 0.15:
        return "nested text", random.choice([b"[", b'{"a":', b'{"nodes":[']) * random.choice([1000, 100_000, MIB])
    kind, scene, binary = gltf_scene_bomb(random)
    return kind, gltf(scene, binary)


def glb_bombs(random):
    huge = random.choice([2 ** 31 - 1, 2 ** 32 - 1, 2 ** 32 - 16, 2 ** 31, 10 ** 9])
    if random.random() < 0.05:
        return "hole", sparse(random.choice([b"", b"glTF\2\0\0\0", glb()]))
    if random.random() < 0.3:
        lengths = [random.choice([0, huge]) for _ in range(3)]
        return "lengths", glb(lengths=lengths)[:random.choice([20, 22, 100, 10 ** 9])]
    kind, scene, binary = gltf_scene_bomb(random)
    return kind, glb(scene, binary)


def collada_bombs(random):
    depth = random.choice([100, 1000, 20_000, 200_000])
    entities = "".join(f'<!ENTITY e{i} "{f"&e{i - 1};" * 10}">' for i in range(1, 12))
    laughs = f'<!DOCTYPE x [<!ENTITY e0 "ha">{entities}]>'
    huge = random.choice([2 ** 31 - 1, 2 ** 31, 2 ** 32 - 1, 2 ** 32, 2 ** 64 - 1, 10 ** 8, 10 ** 9])
    files = collada()
    doubled = "".join(f'<node id="n{i}">' + f'<instance_node url="#n{i + 1}"/>' * 2 + "</node>" for i in range(40))
    return random.choice([
        lambda: ("deep", collada("<node>" * depth + '<instance_geometry url="#g"/>' + "</node>" * depth)),
        lambda: ("deep and open", collada("<node>" * depth)),
        lambda: ("laughs", collada("<node><translate>&e11;</translate></node>", laughs)),
        lambda: ("cycle", collada('<node id="n"><instance_node url="#n"/><instance_geometry url="#g"/></node>')),
        lambda: ("doubled",
                 collada(doubled +
                                    '<node id="n40"><instance_geometry url="#g"/></node>')),
        lambda: ("array", files.replace(b'<float_array id="pa" count="%d"' % (3 * len(VERTICES)),
                                        b'<float_array id="pa" count="%d"' % huge)),
        lambda: ("accessor",
                 files.replace(b'count="%d" stride="3"' % len(VERTICES),
                               b'count="%d" stride="%d"' % (huge, random.choice([0, 1, 3, huge])))),
        lambda: ("polygons", files.replace(b'<polylist count="%d"' % len(SQUARES), b'<polylist count="%d"' % huge)),
        lambda: ("sides", files.replace(b"<vcount>4 ", b"<vcount>%d " % huge)),
        lambda: ("offset", files.replace(b'offset="0"', b'offset="%d"' % huge)),
        lambda: ("attributes", b"<COLLADA " + b" ".join(b'a%d="x"' % i for i in range(100_000)) + b"/>"),
        lambda: ("text", files.replace(b"<p>", b"<p>" + b"0 " * (2 * MIB))),
        lambda: ("geometries", collada('<node><instance_geometry url="#g"/></node>' * 1000)),
    ])()


def bombs_3mf(random):
    def fill(piece, mebibytes):
        def write(model):
            model.write(model_3mf().split(b"<resources>")[0] + b"<resources>")
            for _ in range(mebibytes):
                model.write(piece * (MIB // len(piece)))
            model.write(model_3mf().split(b"<resources>")[1])
        return write

    size = random.choice([1, 16, 64, 256])
    both = '<components><component objectid="{0}"/><component objectid="{0}"/></components>'
    doubled = "".join(f'<object id="{i}">{both.format(i + 1)}</object>' for i in range(1, 40))
    circle = '<object id="1"><components><component objectid="1"/></components></object>'
    vertices = b'<object id="9"><mesh><vertices>' + b'<vertex x="1" y="2" z="3"/>' * 100 + b"</vertices></mesh></object>"
    return random.choice([
        lambda: ("blanks", pack_3mf(fill(b" ", size))), lambda: ("elements", pack_3mf(fill(b"<a/>", min(size, 64)))),
        lambda: ("deep", pack_3mf(fill(b"<a>", min(size, 16)))),
        lambda: ("vertices",
                 pack_3mf(fill(vertices, min(size, 64)))),
        lambda: ("attribute", pack_3mf(lambda model: model.write(b'<model a="' + b"x" * (size * MIB // 4) + b'"/>'))),
        lambda: ("components", pack_3mf(lambda model: model.write(model_3mf(objects=doubled)))),
        lambda: ("cycle",
                 pack_3mf(lambda model: model.write(model_3mf(objects=circle)))),
        lambda: ("entries", pack_3mf(lambda model: model.write(model_3mf()), [(f"{i}/" * 5 + "x",
                                                                               b"") for i in range(3000)])),
        lambda: ("sizes", wrong_sizes(random, pack_3mf(lambda model: model.write(model_3mf())))),
        lambda: ("textures", pack_3mf(lambda model: model.write(model_3mf()), [(f"3D/Textures/{i}.png",
                                                                                b"\0" * (16 * MIB)) for i in range(4)])),
    ])()


def wrong_sizes(random, package):
    """The size of a packed file, in its own header and in the directory, as something else."""
    data = bytearray(package)
    for match in re.finditer(rb"PK\x01\x02", package):
        if random.random() < 0.7:
            at = match.start() + random.choice([20, 24, 42])
            data[at:at + 4] = struct.pack("<I", random.choice([0xffffffff, 0x7fffffff, 0x40000000, 0, 1]))
    return bytes(data)


def json_bombs(random):
    size = random.choice([1000, 100_000, 2 * MIB])

    def repeat(piece):
        return b'{"id":"x","frames":4,"seed":1,"rounds":[' + b",".join([piece] * (size // (len(piece) + 1))) + b"]}"

    return random.choice([
        lambda: ("nested lists", b"[" * size), lambda: ("nested objects", b'{"a":' * (size // 5)),
        lambda: ("empty lists", repeat(b"[]")),
        lambda: ("empty objects", repeat(b"{}")), lambda: ("members", repeat(b'{"":0}')),
        lambda: ("overflows", repeat(b"1e999")), lambda: ("strings", repeat(b'""')),
        lambda: ("number", b'{"frames":' + numbers_without_end(random) + b"}"),
        lambda: ("string", b'{"id":"' + b"x" * size + b'"}'),
        lambda: ("open string", b'{"id":"' + b"\\" * size), lambda: ("line", b"x" * (17 * MIB)),
        lambda: ("zeros", b"\0" * (17 * MIB)), lambda: ("hole", sparse(b"")),
        lambda: ("keys", b"{" + b",".join(b'"%d":0' % i for i in range(size // 10)) + b"}"),
        lambda: ("empty lines", b"\n" * size)])()


def path_bombs(random):
    path = dict(PATH)
    kind = random.choice(["frames", "keyframes", "same", "json", "json"])
    if kind == "frames":
        path["frames"] = random.choice([10 ** 6, 10 ** 6 + 1, 2 ** 32, 2 ** 64 - 1, 10 ** 30])
    elif kind == "keyframes":
        path["keyframes"] = PATH["keyframes"] * random.choice([1000, 50_000])
    elif kind == "same":
        path["keyframes"] = [{"eye": [1e30, 1e30, 1e30], "target": [math.nextafter(1e30, 2e30), 1e30, 1e30]}] * 2
    else:
        return json_bombs(random)
    return kind, json.dumps(path).encode()


def matrix_bombs(random):
    size = random.choice([1000, 100_000, 2 * MIB])
    return random.choice([
        lambda: ("line", b"1," * size), lambda: ("number", numbers_without_end(random)),
        lambda: ("lines", (b",".join([b"1"] * 16) + b"\n") * (size // 32)), lambda: ("empty lines", b"\n" * size),
        lambda: ("comments", b"#\n" * size), lambda: ("hole", sparse(b"")), lambda: ("long line", b"x" * (17 * MIB)),
        lambda: ("words", b"x " * size)])()


def case_bombs(random):
    n = random.choice([100, 1000, 4096, 4097, 20_000])
    ring = [[2, math.cos(2 * math.pi * i / n), math.sin(2 * math.pi * i / n)] for i in range(n)]
    case = {"eye": [0, 0, 0], "occluder": {"polygon": ring}, "near": "surface",
            "box": {"min": [4, 0, 0], "max": [5, 0.1, 0.1]}}
    kind = random.choice(["sides", "star", "same vertex", "prism", "same face", "json", "json", "json"])
    if kind == "star":
        case["occluder"]["polygon"] = [ring[i * 7 % n] for i in range(n)]
    if kind == "same vertex":
        case["occluder"]["polygon"] = ring[:1] * n
    if kind == "prism":
        m = n // 6
        far = [[3, y, z] for _, y, z in ring[::6][:m]]
        faces = [list(range(m)), list(range(m, 2 * m))] + [[i, (i + 1) % m, m + (i + 1) % m, m + i] for i in range(m)]
        case["occluder"] = {"vertices": ring[::6][:m] + far, "faces": faces}
    if kind == "same face":
        case["occluder"] = {"vertices": ring[:3], "faces": [[0, 1, 2]] * (n // 3)}
    return json_bombs(random) if kind == "json" else (kind, json.dumps(case).encode() + b"\n")


def preprocess_bombs(random):
    head = b"occlude preprocess\n" + struct.pack("<I", 3)
    return random.choice([lambda: ("zeros", head + b"\0" * (8 * MIB)), lambda: ("ones", head + b"\xff" * MIB),
                          lambda: ("head", b"occlude preprocess\n" * 100_000)])()


def log_bombs(random):
    count = random.choice([1000, 100_000, MIB])
    camera = b'"eye":[0,0,0],"target":[1,0,0],"width":64,"height":36'
    return random.choice([
        lambda: json_bombs(random),
        lambda: ("the same polygons", b'{"frame":0,' + camera + b',"culled":[' + b"[0,40]," * count + b"0]}"),
        lambda: ("no polygons", b'{"frame":0,' + camera + b',"culled":[' + b"[0,0]," * count + b"0]}"),
        lambda: ("the same object", b'{"object":7,"polygons":[' + b"[0,0]," * count + b'0]}\n{"frame":0,' + camera +
                 b',"culled_objects":[' + b"7," * count + b"7]}"),
        lambda: ("objects", b"".join(b'{"object":%d,"polygons":[]}\n' % i for i in range(count // 10))),
        lambda: ("compressed zeros", gzip.compress(b"\0" * (17 * MIB))),
        lambda: ("compressed lines", gzip.compress(b"\n" * (64 * MIB)))])()


def binary_log_bombs(random):
    head = b"OCCLLOG1"
    count = random.choice([1000, 100_000, MIB])
    return random.choice([
        lambda: ("an object without end", head + struct.pack("<3I", 3, 7, 0xFFFFFFFF) + b"\0" * count),
        lambda: ("empty objects", head + b"".join(struct.pack("<3I", 3, i, 0) for i in range(count // 10))),
        lambda: ("no polygons", head + struct.pack("<3I", 3, 7, count) + b"\0" * 8 * count),
        lambda: ("zeros", head + b"\0" * count),
        lambda: ("compressed zeros", gzip.compress(head + struct.pack("<3I", 3, 7, count) + b"\0" * 8 * count))])()


BOMBS = {"ply ascii": ply_bombs, "ply binary": ply_bombs, "obj": obj_bombs, "stl": stl_bombs, "gltf": gltf_bombs,
         "glb": glb_bombs,
         "collada": collada_bombs, "3mf": bombs_3mf, "path": path_bombs, "matrices": matrix_bombs,
         "gltf camera": gltf_bombs, "collada camera": collada_bombs, "cases": case_bombs, "witnesses": json_bombs,
         "hidden": json_bombs,
         "log": log_bombs, "binary log": binary_log_bombs,
         "preprocess": preprocess_bombs}


def repacked(random, package):
    """A 3MF whose packed files are damaged, not the package."""
    with zipfile.ZipFile(io.BytesIO(package)) as whole:
        parts = {name: whole.read(name) for name in whole.namelist()}
    name = random.choice(list(parts))
    parts[name] = random.choice(DAMAGES)(random, parts[name])
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as packed:
        for name, data in parts.items():
            packed.writestr(name, data)
    return file.getvalue()


class Maker:
    """Hostile files of one format."""

    def __init__(self, name, seeds, folder, forger):
        self.name, self.seeds, self.folder, self.forger = name, seeds, folder, forger
        self.damages = DAMAGES + [with_other_value] * 6 if name in JSON + ("gltf", "gltf camera") else DAMAGES

    def write(self, random, file):
        """Writes one; returns what was done, in a word or two."""
        if self.name == "store":  # with right hashes, which Python cannot compute
            seed = str(random.randrange(1 << 64))
            return subprocess.run([self.forger, "--write", seed, file], check=True, capture_output=True,
                                  text=True).stdout.strip()
        if random.random() < 0.25:
            kind, data = BOMBS[self.name](random)
        else:
            kind, data = self.damaged(random)
        if callable(data):
            data(file)
        else:
            file.write_bytes(data)
        return kind

    def damaged(self, random):
        seeds = self.seeds[self.name if random.random() < 0.97 else random.choice(list(self.seeds))]
        data = random.choice(seeds)
        if self.name == "3mf" and random.random() < 0.6 and data.startswith(b"PK"):
            return "repacked", repacked(random, data)
        kinds = []
        for _ in range(random.choice([1, 1, 2, 3])):
            damage = random.choice(self.damages)
            kinds.append(damage.__name__.replace("_", " "))
            data = damage(random, data)[:16 * MIB]
        return kinds[-1], data
