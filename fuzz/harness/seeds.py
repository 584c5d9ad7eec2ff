#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes what chance would not find soon, as bytes that decode.cpp reads: walls and what they hide for `traversal`, loops
that go round twice for `construction`. Usage: python3 fuzz/harness/seeds.py"""
import pathlib

CORPUS = pathlib.Path(__file__).parents[1] / "corpus"


def point(x, y, z):
    return [0, 0, x, 0, y, 0, z]  # fresh coordinates, of the small grid


def polygon(origin, across, up, places):
    """In the plane through `origin`: a*across + b*up for every (a, b)."""
    return [0, *point(*origin), *across, *up, len(places) - 3, *(16 * (b + 8) + a + 8 for a, b in places), 0]


def wall(x, reach):
    return polygon((x, 0, 0), (0, 1, 0), (0, 0, 1), [(-reach, -reach), (reach, -reach), (reach, reach), (-reach, reach)])


def triangle(x, y, z):
    return polygon((x, y, z), (0, 1, 0), (1, 0, 1), [(0, 0), (1, 0), (0, 1)])


def scene(polygons, orthographic=False, farthest=False, overlap=False, near=None):
    camera = [*point(0, 0, 0), *point(1, 0, 0), 0, 2 if orthographic else 0, 1, 0, 0, 8, *([0] if near is None else [1, 0, near]), 0]
    config = [1, 0, 2]
    options = [8, farthest, overlap, 0]
    return bytes(byte & 255 for byte in [0, *camera, *config, *options, len(polygons), *(b for p in polygons for b in p)])


def loop(corners):
    """Seen from the origin, in the plane x = 4; any order of corners."""
    free_polygon = [3, len(corners), *(byte for y, z in corners for byte in point(4, y, z))]
    return bytes(byte & 255 for byte in [0, 0, *point(0, 0, 0), 1, 0, *free_polygon])


def main():
    hidden = [triangle(x, y, z) for x in (4, 6) for y in range(-2, 3) for z in (-1, 1)]
    beside = [triangle(3, y, 0) for y in (-8, 8)]
    slanted = polygon((3, 0, 0), (0, 1, 0), (1, 0, 2), [(-3, -1), (3, -1), (3, 1), (-3, 1)])
    scenes = {
        "wall": scene([wall(2, 3), *hidden, *beside]),
        "wall_orthographic": scene([wall(2, 3), *hidden, *beside], orthographic=True),
        "wall_farthest": scene([wall(2, 3), *hidden], farthest=True),
        "wall_overlap": scene([wall(2, 2), *hidden, *beside], overlap=True),
        "walls_in_a_row": scene([wall(x, x + 1) for x in range(1, 7)] + hidden),
        "wall_across_the_near_plane": scene([slanted, *hidden], near=3),
        "coplanar_walls": scene([wall(2, 3), wall(2, 3), wall(2, 1), *(triangle(2, y, 0) for y in range(-2, 3))]),
    }
    pentagon = [(0, 3), (3, 1), (2, -3), (-2, -3), (-3, 1)]
    loops = {
        "pentagram": loop([pentagon[2 * i % 5] for i in range(5)]),
        "pentagon_twice": loop(pentagon * 2),
    }
    for folder, seeds in (("traversal", scenes), ("construction", loops)):
        for name, data in seeds.items():
            (CORPUS / folder / name).write_bytes(data)


if __name__ == "__main__":
    main()
