# SPDX-License-Identifier: MIT
# Makes a machine part: a closed housing with walls, of one of four forms, and things in it, some on its floor or through it.
# Usage: closed_parts.py SEED FILE.ply
import math
import random
import sys

rng = random.Random(int(sys.argv[1]))
vertices, faces = [], []


def add(points, loops):
    first = len(vertices)
    vertices.extend(points)
    faces.extend([first + i for i in loop] for loop in loops)


def prism(outline, low, high):
    """A closed prism over an outline, which may be concave."""
    n = len(outline)
    sides = [(i, (i + 1) % n, n + (i + 1) % n, n + i) for i in range(n)]
    add([(x, y, z) for z in (low, high) for x, y in outline], [tuple(reversed(range(n))), tuple(range(n, 2 * n))] + sides)


def ring(n, radius, x=0.0, y=0.0):
    return [(x + radius * math.cos(2 * math.pi * i / n), y + radius * math.sin(2 * math.pi * i / n)) for i in range(n)]


def gear(n, radius, x, y):
    return [(x + radius * (1 if i % 4 < 2 else 0.8) * math.cos(2 * math.pi * i / (4 * n)),
             y + radius * (1 if i % 4 < 2 else 0.8) * math.sin(2 * math.pi * i / (4 * n))) for i in range(4 * n)]


def ball(n, radius, at):
    """A closed ball of triangles and quadrangles."""
    points = [(at[0], at[1], at[2] - radius), (at[0], at[1], at[2] + radius)]
    for k in range(1, n):
        angle = math.pi * k / n - math.pi / 2
        points += [(x, y, at[2] + radius * math.sin(angle)) for x, y in ring(2 * n, radius * math.cos(angle), at[0], at[1])]
    row = lambda k, i: 2 + 2 * n * k + i % (2 * n)
    loops = [(0, row(0, i + 1), row(0, i)) for i in range(2 * n)] + [(1, row(n - 2, i), row(n - 2, i + 1)) for i in range(2 * n)]
    loops += [(row(k, i), row(k, i + 1), row(k + 1, i + 1), row(k + 1, i)) for k in range(n - 2) for i in range(2 * n)]
    add(points, loops)


form, wall, height = int(sys.argv[1]) % 4, 0.5, rng.uniform(6, 12)
if form == 0:  # a box
    outer, inner = [(-10, -6), (10, -6), (10, 6), (-10, 6)], [(-9.5, -5.5), (9.5, -5.5), (9.5, 5.5), (-9.5, 5.5)]
    places = [(rng.uniform(-8, 8), rng.uniform(-4, 4)) for _ in range(30)]
elif form == 1:  # a can
    outer, inner = ring(32, 10), ring(32, 9.3)
    places = [(x * r, y * r) for x, y in ring(30, 1) for r in [rng.uniform(0, 7.5)]]
elif form == 2:  # an angle
    outer = [(-10, -10), (10, -10), (10, -2), (-2, -2), (-2, 10), (-10, 10)]
    inner = [(-9.5, -9.5), (9.5, -9.5), (9.5, -2.5), (-2.5, -2.5), (-2.5, 9.5), (-9.5, 9.5)]
    places = [(rng.uniform(-8, 8), rng.uniform(-8, -4)) for _ in range(15)] + [(rng.uniform(-8, -4), rng.uniform(-8, 8)) for _ in range(15)]
else:  # one with ribs
    outer, inner = gear(9, 10, 0, 0), ring(24, 7.4)
    places = [(x * r, y * r) for x, y in ring(30, 1) for r in [rng.uniform(0, 5.5)]]
prism(outer, 0, height)
prism(inner, wall, height - wall)
for number, (x, y) in enumerate(places):
    size = rng.uniform(0.4, 1.4)
    if number % 3 == 0:  # some lie on the floor
        prism(gear(6, size, x, y), wall, wall + size)
    elif number % 3 == 1:
        ball(8, size, (x, y, rng.uniform(2 * wall + size, height - 2 * wall - size)))
    else:
        prism(ring(12, size / 2, x, y), wall / 2, height - wall / 2)  # pins that end in the walls
prism(ring(16, 1, 0, 0), -3, height + 2) if rng.random() < 0.5 else None  # an axle that leads out
ball(8, 1.5, (14, 0, 2))

with open(sys.argv[2], 'w') as out:
    out.write('ply\nformat ascii 1.0\nelement vertex %d\nproperty double x\nproperty double y\nproperty double z\n' % len(vertices))
    out.write('element face %d\nproperty list uchar int vertex_indices\nend_header\n' % len(faces))
    for v in vertices: out.write('%r %r %r\n' % v)
    for f in faces: out.write('%d %s\n' % (len(f), ' '.join(map(str, f))))
