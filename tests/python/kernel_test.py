# SPDX-License-Identifier: MIT
"""Boxes against shadow frusta: the kernel against the oracle."""
import unittest

import numpy as np

import brute
import occlude
from occlude import Relation, Stage

try:
    from occlude import oracle
except ImportError:
    oracle = None

SQUARE = np.array([[2, -1, -1], [2, 1, -1], [2, 1, 1], [2, -1, 1]], float)


def touching_boxes(rng, count):
    """Boxes with small whole coordinates, many of which touch |y| = x / 2; half of them moved by an ulp."""
    low = rng.integers([0, -6, -6], [12, 6, 6], (count, 3)).astype(float)
    boxes = np.hstack([low, low + rng.integers(0, 4, (count, 3))])
    moved = np.nextafter(boxes, rng.choice([-np.inf, np.inf], boxes.shape))
    moved[np.abs(moved) < 1e-30] = 0
    return np.vstack([boxes[: count // 2], np.sort(moved[count // 2 :].reshape(-1, 2, 3), axis=1).reshape(-1, 6)])


class Answers(unittest.TestCase):
    def test_by_hand(self):
        shadow = occlude.ShadowFrustum(SQUARE, eye=[0, 0, 0])
        boxes = [[4, -1, -1, 5, 1, 1], [4, 1, -1, 5, 3, 1], [4, 5, 5, 5, 6, 6], [4, -2, -2, 5, 2, 2], [2, -1, -1, 3, 1, 1]]
        relations, stages = shadow.relations(boxes), shadow.stages(boxes)
        self.assertEqual((relations.dtype, stages.dtype), (np.uint8, np.uint8))
        expected = [Relation.INSIDE, Relation.PARTIAL, Relation.OUTSIDE, Relation.INSIDE, Relation.INSIDE]
        np.testing.assert_array_equal(relations, expected)
        self.assertEqual(stages[0], Stage.FILTER)
        opened = shadow.relations(boxes, near_boundary="open")
        np.testing.assert_array_equal(opened, expected[:4] + [Relation.PARTIAL])

    def test_types_strides_and_shapes(self):
        rng = brute.random()
        shadow = occlude.ShadowFrustum(SQUARE.astype("f4"), eye=(0, 0, 0))
        boxes = touching_boxes(rng, 500)[:250]
        expected = shadow.relations(boxes)
        wide = np.full((500, 9), np.nan)
        wide[::2, 1:7] = boxes
        for same in (
            wide[::2, 1:7],
            boxes.astype("f4"),
            boxes.astype("i8"),
            np.asfortranarray(boxes),
            boxes.reshape(-1, 2, 3),
            boxes.astype(">f8"),
            boxes.tolist(),
        ):
            np.testing.assert_array_equal(shadow.relations(same), expected)
        np.testing.assert_array_equal(shadow.relations(boxes[::-1]), expected[::-1])
        middle, half = (boxes[:, 3:] + boxes[:, :3]) / 2, (boxes[:, 3:] - boxes[:, :3]) / 2
        oriented = np.stack([middle, *(half * axis for axis in np.eye(3))], axis=1)
        np.testing.assert_array_equal(shadow.relations(oriented), expected)
        np.testing.assert_array_equal(shadow.relations(oriented.reshape(-1, 12)), expected)
        self.assertEqual(shadow.relations(np.empty((0, 6))).shape, (0,))

    def test_tests_and_arithmetics(self):
        rng = brute.random()
        shadow = occlude.ShadowFrustum(SQUARE, direction=[1, 0.25, 0])
        boxes = touching_boxes(rng, 4000)
        overlap = shadow.relations(boxes)
        conservative = shadow.relations(boxes, test="conservative")
        np.testing.assert_array_equal(overlap == Relation.INSIDE, conservative == Relation.INSIDE)
        self.assertTrue(np.all(overlap[conservative == Relation.OUTSIDE] == Relation.OUTSIDE))
        # No single plane of the frustum separates this box from it, but another plane does.
        slanted = [[[2, -3, 2], [-2, -4, -3], [0, -1, -1], [-3, 4, -2]]]
        ahead = occlude.ShadowFrustum(SQUARE, eye=[0, 0, 0])
        self.assertEqual(ahead.relations(slanted), [Relation.OUTSIDE])
        self.assertEqual(ahead.relations(slanted, test="conservative"), [Relation.PARTIAL])
        # Many at once are as one by one.
        for test, all in (("overlap", overlap), ("conservative", conservative)):
            one_by_one = [shadow.relations(box[None], test=test)[0] for box in boxes]
            np.testing.assert_array_equal(all, one_by_one)
        plain = shadow.relations(boxes, arithmetic="plain")
        self.assertTrue(np.mean(plain == overlap) > 0.9)


@unittest.skipUnless(oracle, "the oracle was not built")
class Oracle(unittest.TestCase):
    def agree(self, shadow, boxes):
        relations, stages = shadow.relations(boxes), shadow.stages(boxes)
        np.testing.assert_array_equal(relations, oracle.relations(shadow, boxes))
        return relations, stages

    def test_touching_boxes(self):
        rng = brute.random()
        for near in ("surface", "farthest"):
            relations, stages = self.agree(occlude.ShadowFrustum(SQUARE, eye=[0, 0, 0], near=near), touching_boxes(rng, 3000))
            self.assertEqual(set(relations), set(Relation))
            self.assertEqual(set(stages), set(Stage))

    def test_random_boxes(self):
        rng = brute.random()
        for i in range(20):
            angles = np.sort(rng.uniform(0, 2 * np.pi, 7))
            loop = np.stack([np.full(7, 5), np.cos(angles), np.sin(angles)], axis=1) * rng.uniform(0.5, 2)
            view = {"eye": rng.normal(size=3)} if i % 2 else {"direction": [1, *rng.normal(size=2) / 4]}
            centre = rng.uniform([3, -4, -4], [20, 4, 4], (200, 3))
            edges = rng.normal(size=(200, 3, 3)) * rng.uniform(0.05, 2)
            self.agree(occlude.ShadowFrustum(loop, **view), np.concatenate([centre[:, None], edges], axis=1))

    def test_polytopes_and_bent_polygons(self):
        rng = brute.random()
        vertices, faces = brute.cube([2, -1, -1], [3, 1, 1])
        boxes = touching_boxes(rng, 1000)
        for near in ("surface", "farthest"):
            self.agree(occlude.ShadowFrustum(vertices, faces, eye=[0, 0, 0], near=near), boxes)
        bent = SQUARE + [[0.25, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0, 0]]
        shadow = occlude.ShadowFrustum(bent, eye=[0, 0, 0])
        self.assertIsNotNone(shadow.support_plane)
        self.agree(shadow, boxes)

    def test_what_is_refused(self):
        shadow = occlude.ShadowFrustum(SQUARE, eye=[0, 0, 0])
        for ask in (shadow.relations, lambda boxes: oracle.relations(shadow, boxes)):
            with self.assertRaisesRegex(ValueError, "^box 1: "):
                ask([[4, 0, 0, 5, 1, 1], [4, 0, 0, np.nan, 1, 1]])


class Refusals(unittest.TestCase):
    def refused(self, text, *arguments, **keywords):
        with self.assertRaisesRegex(ValueError, text):
            occlude.ShadowFrustum(*arguments, **keywords)

    def test_frusta(self):
        self.refused("viewpoint lies in the occluder's plane", SQUARE, eye=[2, 5, 5])
        self.refused("fewer than 3 distinct silhouette vertices", SQUARE[:2], eye=[0, 0, 0])
        self.refused("loop is not convex", SQUARE[[0, 2, 1, 3]], eye=[0, 0, 0])
        self.refused("number is not finite", SQUARE * np.inf, eye=[0, 0, 0])
        self.refused("number out of range", SQUARE, eye=[1e-40, 0, 0])
        self.refused("direction of view is zero", SQUARE, direction=[0, 0, 0])
        self.refused("either an eye or a direction", SQUARE)
        self.refused("either an eye or a direction", SQUARE, eye=[0, 0, 0], direction=[1, 0, 0])
        self.refused(r"vertices has shape \(4, 2\), must be \(n, 3\)", SQUARE[:, :2], eye=[0, 0, 0])
        self.refused(r"eye has shape \(2,\), must be \(3,\)", SQUARE, eye=[0, 0])
        self.refused("near is 'far', must be 'surface' or 'farthest'", SQUARE, eye=[0, 0, 0], near="far")
        vertices, faces = brute.cube([2, -1, -1], [3, 1, 1])
        self.refused("polytope is not closed", vertices, faces[:5], eye=[0, 0, 0])
        self.refused("face names a vertex that does not exist", vertices[:7], faces, eye=[0, 0, 0])
        self.refused("viewpoint lies in the polytope", vertices, faces, eye=[2.5, 0, 0])

    def test_boxes(self):
        shadow = occlude.ShadowFrustum(SQUARE, eye=[0, 0, 0])
        for text, boxes in (
            ("box 0: box has min > max", [[1, 0, 0, 0, 1, 1]]),
            (r"boxes has shape \(6,\), must be", [1, 0, 0, 1, 1, 1]),
            (r"boxes has shape \(1, 7\), must be", [[1, 0, 0, 1, 1, 1, 1]]),
        ):
            with self.assertRaisesRegex(ValueError, text):
                shadow.relations(boxes)
        with self.assertRaisesRegex(ValueError, "arithmetic is 'exact', must be 'certified' or 'plain'"):
            shadow.relations([[1, 0, 0, 1, 1, 1]], arithmetic="exact")
        far = np.ones((3000, 6))
        far[2500, 0] = 2
        with self.assertRaisesRegex(ValueError, "box 2500: box has min > max"):
            shadow.relations(far)
        with self.assertRaisesRegex(ValueError, "box 2500: box has min > max"):
            shadow.stages(far)
        with self.assertRaisesRegex(TypeError, "an array of real numbers is needed, not of <U5"):
            shadow.relations("boxes")

    def test_what_is_not_real(self):
        shadow = occlude.ShadowFrustum(SQUARE, eye=[0, 0, 0])
        camera = ([0, 0, 0], [1, 0, 0])
        mesh, scene, view = occlude.OccluderMesh(SQUARE, [[0, 1, 2, 3]]), occlude.Scene(), occlude.View()
        box, matrix = np.array([[4, 0, 0, 5, 1, 1]]), np.eye(4)
        ids, walls = scene.add_objects(box), scene.add_occluders(mesh, [matrix])
        calls = (
            lambda t: shadow.relations(box.astype(t)),
            lambda t: shadow.stages(box.astype(t)),
            lambda t: occlude.ShadowFrustum(SQUARE.astype(t), eye=[0, 0, 0]),
            lambda t: occlude.ShadowFrustum(SQUARE, eye=np.zeros(3, t)),
            lambda t: occlude.ShadowFrustum(SQUARE, direction=np.ones(3, t)),
            lambda t: occlude.Camera(np.zeros(3, t), [1, 0, 0]),
            lambda t: occlude.Camera(*camera, up=np.ones(3, t)),
            lambda t: occlude.MatrixCamera(matrix.astype(t), "zero_to_w", "less"),
            lambda t: occlude.OccluderMesh(SQUARE.astype(t), [[0, 1, 2, 3]]),
            lambda t: occlude.Culler(SQUARE.astype(t), [[0, 1, 2, 3]]),
            lambda t: occlude.is_fan(SQUARE.astype(t), range(4)),
            lambda t: scene.add_object(box[0].astype(t)),
            lambda t: scene.add_objects(box.astype(t)),
            lambda t: scene.move_objects(ids, box.astype(t)),
            lambda t: scene.add_occluder(mesh, matrix.astype(t)),
            lambda t: scene.add_occluders(mesh, [matrix.astype(t)]),
            lambda t: scene.move_occluders(walls, [matrix.astype(t)]),
            lambda t: scene.move_occluder(walls[0], matrix.astype(t)),
            lambda t: view.visibility(box.astype(t)),
        )
        for type, name in (("c16", "complex128"), ("c8", "complex64"), ("U9", "<U9"), ("m8[s]", r"timedelta64\[s\]")):
            for call in calls:
                with self.assertRaisesRegex(TypeError, "an array of real numbers is needed, not of " + name):
                    call(type)
        for bad in ([[1, 2], [3]], [[object()] * 6], {}):
            with self.assertRaisesRegex(TypeError, "an array of real numbers is needed"):
                shadow.relations(bad)
        for call in (lambda t: scene.remove_objects(ids.astype(t)), lambda t: occlude.is_fan(SQUARE, np.arange(4).astype(t))):
            with self.assertRaisesRegex(ValueError, "are not whole numbers"):
                call("c16")
        with self.assertRaisesRegex(ValueError, "see_through are not truth values"):
            occlude.OccluderMesh(SQUARE, [[0, 1, 2, 3]], see_through=np.ones(1, "c16"))


if __name__ == "__main__":
    unittest.main()
