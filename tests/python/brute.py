# SPDX-License-Identifier: MIT
"""What culling is held against: rays, one by one, and random worlds."""
import os

import numpy as np

seed = int(os.environ.get("OCCLUDE_SEED", "1"))
print(f"OCCLUDE_SEED={seed}")


def random():
    return np.random.default_rng(seed)


def is_hidden(eye, points, triangles):
    """Whether a triangle stands strictly between the eye and each point. A hit within 1e-9 of a triangle's edges counts, so
    that rounding here does not find faults there."""
    eye = np.asarray(eye, float)
    hidden = np.zeros(len(points), bool)
    rays = np.asarray(points, float) - eye
    for a, b, c in np.asarray(triangles, float):
        e1, e2 = b - a, c - a
        p = np.cross(rays, e2)
        determinant = p @ e1
        with np.errstate(divide="ignore", invalid="ignore"):
            inverse = 1 / determinant
            s = eye - a
            u = (p @ s) * inverse
            q = np.cross(s, e1)
            v = (rays @ q) * inverse
            t = (q @ e2) * inverse
        hidden |= (u >= -1e-9) & (v >= -1e-9) & (u + v <= 1 + 1e-9) & (t > 0) & (t < 1 + 1e-9)
    return hidden


def is_in_view(planes, points):
    return np.all(points @ planes[:, :3].T + planes[:, 3] >= 0, axis=1)


def fan(vertices, polygon):
    return [vertices[[polygon[0], polygon[i], polygon[i + 1]]] for i in range(1, len(polygon) - 1)]


def points_of(box, rng, count):
    """Points of an axis-aligned box (6): its corners and others."""
    low, high = box[:3], box[3:]
    corners = np.array([[high[k] if i >> k & 1 else low[k] for k in range(3)] for i in range(8)])
    return np.vstack([corners, rng.uniform(low, high, (count, 3))])


def cube(low, high):
    """The vertices and the polygons of a box."""
    vertices = np.array([[high[k] if i >> k & 1 else low[k] for k in range(3)] for i in range(8)], float)
    return vertices, np.array([[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]])
