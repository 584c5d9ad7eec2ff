# SPDX-License-Identifier: MIT
"""Models, against rays."""
import unittest

import numpy as np

import brute
import occlude
from occlude import CulledBy, Visibility


def houses(rng):
    """A model of boxes on a grid, and its triangles by polygon."""
    vertices, polygons = [], []
    for x in range(6):
        for y in range(6):
            low = np.array([6 * x, 6 * y, 0]) + rng.uniform(0, 1, 3)
            corners, faces = brute.cube(low, low + rng.uniform(2, 4, 3))
            polygons.append(faces + 8 * len(vertices))
            vertices.append(corners)
    vertices, polygons = np.concatenate(vertices), np.concatenate(polygons)
    return vertices, polygons, np.array([brute.fan(vertices, polygon) for polygon in polygons])


class Faces(unittest.TestCase):
    doorway = np.array([[0, 0, 0], [4, 0, 0], [4, 8, 0], [6, 8, 0], [6, 0, 0], [10, 0, 0], [10, 10, 0], [0, 10, 0]], float)

    def test_triangles_are_the_face(self):
        self.assertFalse(occlude.is_fan(self.doorway, range(8)))
        self.assertTrue(occlude.is_fan(self.doorway, [0, 5, 6, 7]))
        triangles = self.doorway[occlude.triangulate(self.doorway, range(8))]
        self.assertEqual(triangles.shape, (6, 3, 3))
        areas = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])[:, 2] / 2
        self.assertTrue((areas > 0).all())
        self.assertEqual(areas.sum(), 100 - 16)

    def test_refusals(self):
        for text, loop in (
            ("crosses itself", [0, 6, 5, 7]),
            ("fewer than 3 corners", [0, 1]),
            ("vertex 8 of 8", [0, 1, 8]),
            ("loop are not whole numbers", [0, 1, 2.5]),
        ):
            with self.assertRaisesRegex(ValueError, text):
                occlude.triangulate(self.doorway, loop)
        with self.assertRaisesRegex(ValueError, "vertex 1: number is not finite"):
            occlude.is_fan([[0, 0, 0], [np.nan, 0, 0], [0, 1, 0]], range(3))

    def test_what_is_see_through_hides_nothing(self):
        vertices = [[5, -9, -9], [5, 9, -9], [5, 9, 9], [5, -9, 9], [9, 0, 0], [9, 1, 0], [9, 0, 1]]
        camera = occlude.Camera([0, 0, 0], [1, 0, 0])
        for see_through, drawn in ((None, [0]), ([False, True], [0]), ([True, False], [0, 1])):
            culler = occlude.Culler(vertices, [[0, 1, 2, 3], [4, 5, 6]], see_through=see_through, leaf_size=1)
            for method in ("frusta", "cover"):
                self.assertEqual(sorted(culler.cull(camera, method=method).polygons), drawn)
        with self.assertRaisesRegex(ValueError, "see_through has another length"):
            occlude.OccluderMesh(vertices, [[0, 1, 2, 3]], see_through=[True, False])


class Simplified(unittest.TestCase):
    # A cube of which each face is 4 x 4 squares, turned outwards.
    @staticmethod
    def fine_cube():
        vertices, polygons = [], []
        for axis in range(3):
            for far in (False, True):
                for i, k in np.ndindex(4, 4):
                    corners = np.zeros((4, 3))
                    corners[:, axis] = 4 * far
                    corners[:, (axis + 1) % 3] = [i, i + 1, i + 1, i]
                    corners[:, (axis + 2) % 3] = [k, k, k + 1, k + 1]
                    vertices.append(corners if far else corners[::-1])
                    polygons.append(np.arange(4) + 4 * len(polygons))
        return np.concatenate(vertices), np.array(polygons)

    def test_few_triangles_hide_for_a_mesh(self):
        vertices, polygons = self.fine_cube()
        simple = occlude.simplified_occluders(vertices, polygons)
        self.assertEqual((len(simple), simple.drawn_triangles, simple.flat_triangles), (12, 192, 12))
        self.assertEqual(repr(simple), "<occlude.SimplifiedOccluders: 12 triangles>")
        a, b, c = np.moveaxis(simple.vertices[simple.triangles], 1, 0)
        normals = np.cross(b - a, c - a) / 2
        self.assertEqual(np.abs(normals).sum(), 6 * 16)
        self.assertTrue(((a - 2) * normals).sum(1).min() > 0, "they turn as the cube does")
        faces = vertices[polygons[simple.polygons]]
        self.assertTrue((np.einsum("ij,ikj->ik", normals, faces - a[:, None]) == 0).all(), "each is in its polygon's plane")
        self.assertTrue((simple.box == -1).all() and simple.boxes.shape == (0, 6))
        mesh = occlude.OccluderMesh(simple.vertices, simple.triangles)
        self.assertEqual(len(mesh), 12)

    def test_what_is_chosen(self):
        vertices, polygons = self.fine_cube()
        near = occlude.simplified_occluders(vertices, polygons, triangles=2, views=[occlude.Camera([9, 2, 2], [0, 2, 2]), occlude.Camera([8, 2, 1], [0, 2, 2])])
        self.assertTrue((near.vertices[near.triangles.ravel(), 0] == 4).all(), "the face that is turned to the eyes")
        clear = occlude.simplified_occluders(vertices, polygons, see_through=np.ones(96, bool))
        self.assertEqual(len(clear), 0)
        sized = occlude.simplified_occluders(vertices, polygons.ravel(), [4] * 96)
        self.assertEqual(len(sized), 12)
        boxes = occlude.simplified_occluders(vertices, polygons, boxes=1, cells=4)
        self.assertEqual(sorted(boxes.box), [-1] * 12 + [0] * 12)
        turned = vertices @ np.array([[0.6, 0.8, 0], [-0.8, 0.6, 0], [0, 0, 1]]) @ np.array([[1, 0, 0], [0, 0.28, 0.96], [0, -0.96, 0.28]])
        self.assertGreater(len(occlude.simplified_occluders(turned, polygons)), 12)
        self.assertEqual(len(occlude.simplified_occluders(turned, polygons, inset=1e-9)), 12)
        self.assertEqual(boxes.boxes.tolist(), [[0, 0, 0, 4, 4, 4]])

    def test_refusals(self):
        vertices, _ = self.fine_cube()
        with self.assertRaisesRegex(ValueError, "vertex 99 of 8"):
            occlude.simplified_occluders(vertices[:8], [[0, 1, 99]])


class Models(unittest.TestCase):
    def test_materials_of_another_model_are_refused(self):
        triangles = np.arange(18.0).reshape(6, 3) ** 2
        small, large = occlude.Culler(triangles, [[0, 1, 2]]), occlude.Culler(triangles, [[0, 1, 2], [3, 4, 5]])
        order = occlude.DrawOrder(small, [7])
        self.assertEqual(repr(order), "<occlude.DrawOrder: 1 polygon of 1 material>")
        frame = large.cull(occlude.Camera(triangles[0] - 9, triangles[1]))
        self.assertEqual(len(frame.polygons), 2)
        with self.assertRaisesRegex(ValueError, "the frame is of another model"):
            order.ranges(frame)
        for text, materials in (("2 materials for 1 faces", [1, 2]), ("below 0", [-1]), ("above", [2**32]), ("whole", [0.5])):
            with self.assertRaisesRegex(ValueError, text):
                occlude.DrawOrder(small, materials)

    def test_options_of_another_type_are_refused(self):
        triangles = np.arange(18.0).reshape(6, 3) ** 2
        culler, camera = occlude.Culler(triangles, [[0, 1, 2]]), occlude.Camera(triangles[0] - 9, triangles[1])
        for triangle_limit in (-1, 1.5, "x", 2**70):
            with self.assertRaisesRegex(TypeError, "^cover_work is no number from 0 on$"):
                culler.cull(camera, method="cover", cover_work=triangle_limit)
        with self.assertRaisesRegex(TypeError, "^cover_ms is no number$"):
            culler.cull(camera, method="cover", cover_ms="x")
        with self.assertRaisesRegex(TypeError, "^nearer is no text$"):
            occlude.MatrixCamera(np.eye(4), "zero_to_w", 5)

    def check_path(self, culler, view, triangles, rng, **options):
        culled, weights = 0, rng.dirichlet([1, 1, 1], 4)
        for step in range(6):
            eye = np.array([-4.0 + 2 * step, -3, 2])
            frame = culler.cull(occlude.Camera(eye, eye + [1, 0.7, -0.1]), view, **options)
            in_ranges = [p for first, count in frame.drawn for p in culler.order[first : first + count]]
            np.testing.assert_array_equal(frame.polygons, in_ranges)
            materials = rng.choice([5, 0, 2**32 - 1], len(triangles))
            order = occlude.DrawOrder(culler, materials)
            parts = [order.polygons[first : first + count] for _, first, count in order.ranges(frame)]
            for part, material in zip(parts, order.ranges(frame)["material"]):
                self.assertTrue(len(part) > 0 and np.all(materials[part] == material))
            np.testing.assert_array_equal(np.sort(np.concatenate([[], *parts])), np.sort(frame.polygons))
            self.assertEqual(order.materials["material"].tolist(), np.unique(materials).tolist())
            ranges = [culler.order[row["first"] : row["first"] + row["count"]] for row in frame.culled]
            np.testing.assert_array_equal(np.sort(np.concatenate([frame.polygons, *ranges])), np.arange(len(triangles)))
            self.assertEqual(frame.statistics["drawn_polygons"], len(frame.polygons))
            hidden = []
            for row in frame.culled:
                polygons = culler.order[row["first"] : row["first"] + row["count"]]
                points = (weights @ triangles[polygons]).reshape(-1, 3)
                if row["by"] == CulledBy.VIEW:
                    plane = frame.planes[row["index"]]
                    self.assertTrue(np.all(points @ plane[:3] + plane[3] < 0))
                else:
                    self.assertEqual(row["by"], CulledBy.SHADOW if options.get("method") == "frusta" else CulledBy.COVER)
                    hidden.append(points)
                    culled += row["count"]
            if hidden:
                self.assertTrue(np.all(brute.is_hidden(eye, np.concatenate(hidden), triangles.reshape(-1, 3, 3))))
        return culled

    def test_frusta(self):
        rng = brute.random()
        vertices, polygons, triangles = houses(rng)
        culler, view = occlude.Culler(vertices, polygons, leaf_size=4), occlude.View()
        self.assertEqual(len(culler), len(polygons))
        np.testing.assert_array_equal(np.sort(culler.order), np.arange(len(polygons)))
        few = self.check_path(culler, view, triangles, rng, method="frusta")
        self.assertGreater(few, 300)
        self.assertEqual(self.check_path(culler, view, triangles, rng, method="frusta", occluders=0), 0)
        self.check_path(culler, None, triangles, rng, method="frusta", test="overlap", near="farthest", unions=True)
        self.check_path(occlude.Culler(vertices, polygons, bounds="obb"), None, triangles, rng, method="frusta")

    def test_cover(self):
        rng = brute.random()
        vertices, polygons, triangles = houses(rng)
        culler, view = occlude.Culler(vertices, polygons, leaf_size=4), occlude.View()
        culler.prepare("cover")
        many = self.check_path(culler, view, triangles, rng, method="cover", cover_size=(512, 512))
        self.assertGreater(many, 600)
        seen = view.visibility([[30, 31, 0.2, 31, 32, 0.4], [-50, 0, 0, -49, 1, 1]])
        self.assertEqual(list(seen), [Visibility.OCCLUDED, Visibility.OUT_OF_VIEW])
        self.assertEqual(self.check_path(culler, view, triangles, rng, method="cover", cover_work=0), 0)

    def test_matrix_cameras(self):
        rng = brute.random()
        vertices, polygons, _ = houses(rng)
        culler = occlude.Culler(vertices, polygons, leaf_size=4)
        # From (-4, -3, 2) along x, left is y: the matrix of the camera below.
        look = np.array([[0, -1, 0, -3], [0, 0, 1, -2], [-1, 0, 0, -4], [0, 0, 0, 1]])
        projection = np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, -1, -0.2], [0, 0, -1, 0]])
        matrix = occlude.MatrixCamera(projection @ look, "minus_w_to_w")
        camera = occlude.Camera([-4, -3, 2], [0, -3, 2], fov_y_deg=90, aspect=1)
        for method in ("frusta", "cover"):
            expected, frame = culler.cull(camera, method=method), culler.cull(matrix, occlude.View(), method=method)
            self.assertLess(len(set(expected.polygons) ^ set(frame.polygons)), 20)
            self.assertGreater(frame.statistics["shadow_culled_polygons"], 30)
        several = occlude.MatrixCamera(projection @ look, "minus_w_to_w", eyes=occlude.EyeRegion.ball(0.5))
        for method in ("frusta", "cover"):
            from_one = set(culler.cull(matrix, method=method).polygons)
            self.assertGreater(len(culler.cull(several, method=method).polygons), len(from_one))

    def test_polygons_of_all_kinds(self):
        square = np.array([[5, -1, -1], [5, 1, -1], [5, 1, 1], [5, -1, 1]])
        camera = occlude.Camera([0, 0, 0], [1, 0, 0])
        for polygons, sizes in (([[0, 1, 2], [0, 1, 2, 3]], None), (np.array([0, 1, 2, 0, 1, 2, 3]), [3, 4])):
            culler = occlude.Culler(square, polygons, sizes)
            self.assertEqual(len(culler), 2)
            self.assertEqual(sorted(culler.cull(camera).polygons), [0, 1])

    def test_one_view_for_everything(self):
        rng = brute.random()
        vertices, polygons, _ = houses(rng)
        culler, scene, view = occlude.Culler(vertices, polygons), occlude.Scene(), occlude.View()
        camera, box = occlude.Camera([0, 0, 0], [1, 0, 0]), [[3, -0.5, -0.5, 4, 0.5, 0.5]]
        self.assertEqual(view.visibility(box)[0], Visibility.VISIBLE)
        culler.cull(camera, view)
        self.assertEqual(view.visibility([[-4, 0, 0, -3, 1, 1]])[0], Visibility.OUT_OF_VIEW)
        scene.cull(occlude.Camera([0, 0, 0], [-1, 0, 0]), view)
        self.assertEqual(view.visibility(box)[0], Visibility.OUT_OF_VIEW)
        culler.cull(camera, view)
        self.assertEqual(view.visibility(box)[0], Visibility.VISIBLE)

    def test_refusals(self):
        camera, square = occlude.Camera([0, 0, 0], [1, 0, 0]), [[5, -1, -1], [5, 1, -1], [5, 1, 1], [5, -1, 1]]
        culler = occlude.Culler(square, [[0, 1, 2, 3]])
        for text, call in (
            ("soup", lambda: occlude.Culler(square, [])),
            ("vertex 0: number out of range", lambda: occlude.Culler([[1e300, 0, 0]] * 3, [[0, 1, 2]])),
            ("bounds is 'sphere', must be 'aabb' or 'obb'", lambda: occlude.Culler(square, [[0, 1, 2]], bounds="sphere")),
            ("method is 'both', must be 'automatic' or 'frusta' or 'cover'", lambda: culler.cull(camera, method="both")),
            ("margin is below 0", lambda: culler.cull(camera, margin=-1)),
            ("margin is below 0", lambda: culler.cull(camera, margin=np.nan)),
        ):
            with self.assertRaisesRegex(ValueError, text):
                call()
        with self.assertRaises(TypeError):
            culler.cull("camera")


if __name__ == "__main__":
    unittest.main()
