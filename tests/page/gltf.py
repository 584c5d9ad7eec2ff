# SPDX-License-Identifier: MIT
"""Makes glTF files for tests: boxes, each a node with a matrix of its own, and a camera."""
import base64
import json
import struct

CORNERS = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
TRIANGLES = [0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5]


def of_boxes(boxes, eye):
    """Each box: name, least corner, size and colour, red, green, blue and alpha. The camera at `eye` looks along -z."""
    data = b''.join(struct.pack('<3f', *corner) for corner in CORNERS) + struct.pack(f'<{len(TRIANGLES)}H', *TRIANGLES)
    meshes, materials, nodes = [], [], []
    for number, (name, least, size, colour) in enumerate(boxes):
        materials.append({'pbrMetallicRoughness': {'baseColorFactor': colour}, 'alphaMode': 'OPAQUE' if colour[3] == 1 else 'BLEND'})
        meshes.append({'primitives': [{'attributes': {'POSITION': 0}, 'indices': 1, 'material': number}]})
        nodes.append({'name': name, 'mesh': number, 'translation': least, 'scale': size})
    nodes.append({'name': 'Door', 'camera': 0, 'translation': eye})
    return json.dumps({
        'asset': {'version': '2.0'},
        'buffers': [{'byteLength': len(data), 'uri': 'data:application/octet-stream;base64,' + base64.b64encode(data).decode()}],
        'bufferViews': [{'buffer': 0, 'byteLength': 96}, {'buffer': 0, 'byteOffset': 96, 'byteLength': 2 * len(TRIANGLES)}],
        'accessors': [
            {'bufferView': 0, 'componentType': 5126, 'count': 8, 'type': 'VEC3', 'min': [0, 0, 0], 'max': [1, 1, 1]},
            {'bufferView': 1, 'componentType': 5123, 'count': len(TRIANGLES), 'type': 'SCALAR'}],
        'cameras': [{'name': 'Door', 'type': 'perspective', 'perspective': {'yfov': 1.0, 'znear': 0.1}}],
        'materials': materials, 'meshes': meshes, 'nodes': nodes,
        'scenes': [{'nodes': list(range(len(nodes)))}], 'scene': 0})
