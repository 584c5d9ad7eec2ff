# SPDX-License-Identifier: MIT
"""Makes glTF files for tests: boxes, each a node with a matrix of its own, and a camera."""
import base64
import json
import struct
import zlib

CORNERS = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
TRIANGLES = [0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5]


def png(pixels):
    """A row of pixels, three bytes each."""
    def chunk(kind, data):
        return struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))
    row = b'\0' + b''.join(bytes(pixel) for pixel in pixels)
    return (b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>2I5B', len(pixels), 1, 8, 2, 0, 0, 0)) +
            chunk(b'IDAT', zlib.compress(row)) + chunk(b'IEND', b''))


def of_boxes(boxes, eye):
    """
    Each box: name, least corner, size and colour, red, green, blue and alpha, and with a texture that is red where x is least, and
    green where it is greatest. The camera at `eye` looks along -z.
    """
    data = (b''.join(struct.pack('<3f', *corner) for corner in CORNERS) + struct.pack(f'<{len(TRIANGLES)}H', *TRIANGLES) +
            b''.join(struct.pack('<2f', corner[0], 0.5) for corner in CORNERS))
    meshes, materials, nodes = [], [], []
    for number, (name, least, size, colour) in enumerate(boxes):
        materials.append({'pbrMetallicRoughness': {'baseColorFactor': colour, 'baseColorTexture': {'index': 0}}, 'alphaMode': 'OPAQUE' if colour[3] == 1 else 'BLEND'})
        meshes.append({'primitives': [{'attributes': {'POSITION': 0, 'TEXCOORD_0': 2}, 'indices': 1, 'material': number}]})
        nodes.append({'name': name, 'mesh': number, 'translation': least, 'scale': size})
    nodes.append({'name': 'Door', 'camera': 0, 'translation': eye})
    return json.dumps({
        'asset': {'version': '2.0'},
        'buffers': [{'byteLength': len(data), 'uri': 'data:application/octet-stream;base64,' + base64.b64encode(data).decode()}],
        'bufferViews': [{'buffer': 0, 'byteLength': 96}, {'buffer': 0, 'byteOffset': 96, 'byteLength': 2 * len(TRIANGLES)},
                        {'buffer': 0, 'byteOffset': 96 + 2 * len(TRIANGLES), 'byteLength': 64}],
        'accessors': [
            {'bufferView': 0, 'componentType': 5126, 'count': 8, 'type': 'VEC3', 'min': [0, 0, 0], 'max': [1, 1, 1]},
            {'bufferView': 1, 'componentType': 5123, 'count': len(TRIANGLES), 'type': 'SCALAR'},
            {'bufferView': 2, 'componentType': 5126, 'count': 8, 'type': 'VEC2'}],
        'images': [{'uri': 'data:image/png;base64,' + base64.b64encode(png([[255, 0, 0], [0, 255, 0]])).decode()}],
        'samplers': [{'wrapS': 33071, 'wrapT': 33071}], 'textures': [{'source': 0, 'sampler': 0}],
        'cameras': [{'name': 'Door', 'type': 'perspective', 'perspective': {'yfov': 1.0, 'znear': 0.1}}],
        'materials': materials, 'meshes': meshes, 'nodes': nodes,
        'scenes': [{'nodes': list(range(len(nodes)))}], 'scene': 0})
